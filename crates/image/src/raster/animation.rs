//! Animated GIF and WebP: frames in sequence, each composed over the frames before.

use std::borrow::Cow;
use std::io::Cursor;

use ::image::codecs::webp::WebPDecoder;
use ::image::{AnimationDecoder, Frames, ImageDecoder, ImageFormat, Rgba, RgbaImage};
use gif::{ColorOutput, DecodeOptions, Decoder, DecodingError, Frame};
use gif_dispose::Screen;

use super::Image;
use super::channels::Channels;
use super::decode::{explained, records_of_webp};
use super::limits::{Limits, check_memory, out_of_memory};
use super::samples::{Alpha, Pixels};
use crate::error::{Error, Result};

/// An animation that is read from its first frame to its last.
pub struct Animation(Kind);

enum Kind {
    Gif(Box<Gif>),
    WebP(WebP),
}

impl Animation {
    /// Opens a file by its content. No frame is decoded yet.
    ///
    /// # Errors
    /// `unknown-format` unless the file is GIF or WebP, `damaged`, `too-large`.
    pub fn new(bytes: Vec<u8>, limits: &Limits) -> Result<Self> {
        match ::image::guess_format(&bytes) {
            Ok(ImageFormat::Gif) => Ok(Self(Kind::Gif(Box::new(Gif::new(bytes, limits)?)))),
            Ok(ImageFormat::WebP) => Ok(Self(Kind::WebP(WebP::new(bytes, limits)?))),
            _ => Err(Error::UnknownFormat),
        }
    }

    /// Advances to the next frame.
    ///
    /// # Returns
    /// Returns `false` after the last frame.
    ///
    /// # Errors
    /// `damaged` if the file is truncated, `too-large` for a first frame that exceeds the limits.
    pub fn advance(&mut self) -> Result<bool> {
        match &mut self.0 {
            Kind::Gif(gif) => gif.advance(),
            Kind::WebP(webp) => webp.advance(),
        }
    }

    /// The current frame: in sRGB, transparency flattened on white.
    ///
    /// # Errors
    /// `damaged` before the first.
    pub fn picture(&mut self) -> Result<Image> {
        let (size, samples, profile) = match &mut self.0 {
            Kind::Gif(gif) => gif.picture()?,
            Kind::WebP(webp) => webp.picture()?,
        };
        Pixels::flattened(size, samples, Channels::Rgb, Alpha::Straight).with_profile(profile).image(size)
    }
}

/// Size, straight RGBA and ICC profile of a picture.
type Picture = ((usize, usize), Vec<u8>, Option<Vec<u8>>);

fn none_yet(name: &'static str) -> Error {
    Error::damaged(name, "it has no picture")
}

struct Gif {
    decoder: Decoder<Cursor<Vec<u8>>>,
    limits: Limits,
    /// As large as the first picture asks for, as browsers have it.
    screen: Option<Screen>,
}

impl Gif {
    const NAME: &str = "GIF";

    fn failed(error: DecodingError) -> Error {
        Error::damaged(Self::NAME, error)
    }

    fn new(bytes: Vec<u8>, limits: &Limits) -> Result<Self> {
        let mut options = DecodeOptions::new();
        options.set_color_output(ColorOutput::Indexed);
        let decoder = options.read_info(Cursor::new(bytes)).map_err(Self::failed)?;
        limits.check(decoder.width().max(1).into(), decoder.height().max(1).into(), Self::NAME)?;
        Ok(Self { decoder, limits: *limits, screen: None })
    }

    fn advance(&mut self) -> Result<bool> {
        let Some(mut frame) = self.decoder.next_frame_info().map_err(Self::failed)?.cloned() else {
            return Ok(false);
        };
        let screen = match &mut self.screen {
            Some(screen) => screen,
            none => none.insert(first_screen(&self.decoder, &frame, &self.limits)?),
        };
        let mut indices = vec![0; self.decoder.buffer_size()];
        self.decoder.read_into_buffer(&mut indices).map_err(Self::failed)?;
        frame.buffer = Cow::Owned(indices);
        clip(&mut frame, (screen.width(), screen.height()));
        if !frame.buffer.is_empty() {
            screen.blit_frame(&frame).map_err(|error| Error::damaged(Self::NAME, error))?;
        }
        Ok(true)
    }

    fn picture(&mut self) -> Result<Picture> {
        let screen = self.screen.as_mut().ok_or_else(|| none_yet(Self::NAME))?;
        let size = (screen.width(), screen.height());
        Ok((size, screen.pixels_rgba().pixels().flat_map(<[u8; 4]>::from).collect(), None))
    }
}

/// The screen that a file announces, grown where its first picture reaches beyond it.
fn first_screen(decoder: &Decoder<Cursor<Vec<u8>>>, first: &Frame, limits: &Limits) -> Result<Screen> {
    let reach = |from: u16, length: u16| usize::from(from) + usize::from(length);
    let size = (
        usize::from(decoder.width()).max(reach(first.left, first.width)),
        usize::from(decoder.height()).max(reach(first.top, first.height)),
    );
    limits.check(size.0 as u32, size.1 as u32, Gif::NAME)?;
    // The screen, one to go back to, and the picture that is given away.
    check_memory(size, 12, limits)?;
    let announced = Screen::new_decoder(decoder);
    if (announced.width(), announced.height()) == size {
        return Ok(announced);
    }
    let palette = decoder.global_palette().map(|palette| palette.as_chunks().0);
    let palette = palette.map(|colours| colours.iter().map(|&colour| colour.into()).collect::<Vec<_>>());
    Ok(Screen::new(size.0, size.1, palette.as_deref()))
}

/// Cuts off what lies beside the screen.
fn clip(frame: &mut Frame, screen: (usize, usize)) {
    let whole = (usize::from(frame.width), usize::from(frame.height));
    let width = whole.0.min(screen.0.saturating_sub(frame.left.into()));
    let height = whole.1.min(screen.1.saturating_sub(frame.top.into()));
    if (width, height) == whole {
        return;
    }
    let rows = frame.buffer.chunks_exact(whole.0.max(1)).take(height);
    frame.buffer = Cow::Owned(rows.flat_map(|row| &row[..width]).copied().collect());
    (frame.width, frame.height) = (width as u16, height as u16);
}

struct WebP {
    frames: Frames<'static>,
    profile: Option<Vec<u8>>,
    last: Option<RgbaImage>,
}

impl WebP {
    const NAME: &str = "WebP";

    fn new(bytes: Vec<u8>, limits: &Limits) -> Result<Self> {
        let (_, profile) = records_of_webp(&bytes);
        let failed = |error| explained(error, Self::NAME);
        let mut decoder = WebPDecoder::new(Cursor::new(bytes)).map_err(failed)?;
        // Browsers ignore the background colour of a file.
        if decoder.has_animation() {
            decoder.set_background_color(Rgba([0; 4])).map_err(failed)?;
        }
        let (width, height) = decoder.dimensions();
        limits.check(width, height, Self::NAME)?;
        // The canvas, a picture of it, and one that is given away.
        let size = (width as usize, height as usize);
        check_memory(size, 12, limits).map_err(|_| out_of_memory(size, limits))?;
        Ok(Self { frames: decoder.into_frames(), profile, last: None })
    }

    fn advance(&mut self) -> Result<bool> {
        let next = self.frames.next().transpose().map_err(|error| explained(error, Self::NAME))?;
        let there = next.is_some();
        self.last = next.map(::image::Frame::into_buffer).or(self.last.take());
        Ok(there)
    }

    fn picture(&mut self) -> Result<Picture> {
        let last = self.last.as_ref().ok_or_else(|| none_yet(Self::NAME))?;
        let size = (last.width() as usize, last.height() as usize);
        Ok((size, last.as_raw().clone(), self.profile.clone()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::{Path, PathBuf};

    fn folder() -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/oracles/data/animations")
    }

    fn open(bytes: Vec<u8>) -> Result<Animation> {
        Animation::new(bytes, &Limits::default())
    }

    /// RGB of every picture until the end or a fault.
    fn pictures(animation: &mut Animation) -> Vec<Vec<u8>> {
        let mut all = Vec::new();
        while let Ok(true) = animation.advance() {
            all.push(animation.picture().unwrap().to_rgb());
        }
        all
    }

    #[test]
    fn every_picture_is_what_pillow_sees() {
        let told = std::fs::read_to_string(folder().join("expected.json")).unwrap();
        let expected = std::fs::read(folder().join("expected.bin")).unwrap();
        let told: Vec<serde_json::Value> = serde_json::from_str(&told).unwrap();
        assert!(told.len() >= 6);
        for entry in told {
            let name = entry["file"].as_str().unwrap();
            let number = |key: &str| entry[key].as_u64().unwrap() as usize;
            let count = entry["ends"].as_array().unwrap().len();
            let length = 3 * number("width") * number("height");
            let found = pictures(&mut open(std::fs::read(folder().join(name)).unwrap()).unwrap());
            assert_eq!(found.len(), count, "{name}");
            for (i, (found, expected)) in
                found.iter().zip(expected[number("offset")..].chunks_exact(length)).enumerate()
            {
                // Lossy WebP is turned to RGB by rounding that no specification fixes.
                let allowed = if name.starts_with("lossy") { 4 } else { 1 };
                let far = found.iter().zip(expected).map(|(a, b)| a.abs_diff(*b)).max();
                assert!(far <= Some(allowed), "{name}, picture {i}: off by {far:?}");
            }
        }
    }

    #[test]
    fn a_file_that_breaks_off_gives_its_whole_pictures_first() {
        for (name, least) in [("kept.gif", 3), ("cleared.gif", 3)] {
            let mut bytes = std::fs::read(folder().join(name)).unwrap();
            bytes.truncate(bytes.len() * 8 / 10);
            let found = pictures(&mut open(bytes).unwrap()).len();
            assert!((least..6).contains(&found), "{name}: {found}");
        }
    }

    #[test]
    fn pictures_beside_the_screen_are_cut_off() {
        let mut bytes = Vec::new();
        let palette = [255, 0, 0, 0, 0, 255];
        let mut encoder = gif::Encoder::new(&mut bytes, 4, 4, &palette).unwrap();
        let frame = |left, top, width: u16, height: u16, colour| Frame {
            left,
            top,
            width,
            height,
            buffer: vec![colour; usize::from(width) * usize::from(height)].into(),
            ..Frame::default()
        };
        // The first one grows the screen to 6 x 4.
        for picture in [frame(0, 0, 6, 4, 0), frame(4, 2, 5, 5, 1), frame(9, 9, 2, 2, 1)] {
            encoder.write_frame(&picture).unwrap();
        }
        drop(encoder);
        let mut animation = open(bytes).unwrap();
        assert!(animation.picture().is_err());
        let mut blue = Vec::new();
        while animation.advance().unwrap() {
            let image = animation.picture().unwrap();
            assert_eq!((image.width(), image.height()), (6, 4));
            blue.push(
                image.planes()[2].samples().iter().map(|&sample| usize::from(sample) / 255).sum::<usize>(),
            );
        }
        assert_eq!(blue, [0, 4, 4]);
    }

    #[test]
    fn what_is_no_animation_is_refused() {
        assert_eq!(open(b"\x89PNG\r\n\x1a\n".to_vec()).err().unwrap().code(), "unknown-format");
        assert_eq!(open(b"GIF89a".to_vec()).err().unwrap().code(), "damaged");
        let huge = [b"GIF89a\xff\xff\xff\xff\0\0\0".as_slice(), &[0; 20]].concat();
        assert_eq!(open(huge).err().unwrap().code(), "too-large");
    }
}
