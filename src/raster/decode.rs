//! Bytes of a file to pixels, with limits and EXIF orientation.
//!
//! The format is told by the content, never by the name. Everything that the header announces is checked
//! before memory is taken for it; a file that is cut short is an error, not a picture with a grey foot.

use std::io::Cursor;

use ::image::codecs::bmp::BmpDecoder;
use ::image::codecs::gif::GifDecoder;
use ::image::codecs::png::PngDecoder;
use ::image::codecs::tiff::TiffDecoder;
use ::image::codecs::webp::WebPDecoder;
use ::image::{ImageDecoder, ImageError, ImageFormat, ImageResult};

use super::exif::{self, Exif};
use super::icc;
use super::jpeg::{self, Markers};
use super::orient::{swaps_sides, upright};
use super::resize::{self, Region};
use super::samples::{self, Samples};
use super::{Image, Plane};
use crate::error::{Error, Result};

/// What a file may ask for at most.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Limits {
    /// Width times height.
    pub max_pixels: u64,
    /// The longer side, in pixels.
    pub max_side: u32,
    /// Memory for decoding, in bytes: the decoder's pixels and ours together.
    pub max_bytes: u64,
}

impl Default for Limits {
    /// 120 megapixels (more than any phone but a few makes by default), 32768 a side, 1 GiB.
    fn default() -> Self {
        Self { max_pixels: 120_000_000, max_side: 32_768, max_bytes: 1 << 30 }
    }
}

impl Limits {
    /// Checks announced sides before memory is taken for them; `name` is that of the format.
    ///
    /// # Errors
    /// `damaged` for a side of 0, `too-large` for a side or an area beyond the limits.
    pub fn check(&self, width: u32, height: u32, name: &'static str) -> Result<()> {
        check_size(width, height, name, self)
    }
}

/// A decoded photo.
#[derive(Clone, Debug)]
pub struct Decoded {
    /// Upright, in colour (a grey file has three like planes), transparency flattened on white.
    pub image: Image,
    /// Width of the whole photo in pixels, upright.
    pub width: u32,
    /// Height of the whole photo in pixels, upright.
    pub height: u32,
    /// Name of the format: JPEG, PNG, WebP, GIF, BMP or TIFF.
    pub format: &'static str,
    /// When it was taken, `YYYY:MM:DD HH:MM:SS` of the camera's clock.
    pub taken: Option<String>,
    /// EXIF's 1..=8, already applied.
    pub orientation: u8,
}

/// Decodes a file at its full size; of an animation the first frame.
///
/// # Errors
/// `unknown-format`, `unsupported`, `damaged` (also: cut short), `too-large`.
pub fn decode(bytes: &[u8], limits: &Limits) -> Result<Decoded> {
    decode_fit(bytes, limits, usize::MAX)
}

/// Decodes a file and reduces it, by exact area, to a long side of at most `longest` pixels. The full size
/// exists only as the decoder's own buffer.
///
/// # Errors
/// As [`decode`].
pub fn decode_fit(bytes: &[u8], limits: &Limits, longest: usize) -> Result<Decoded> {
    let (format, name) = known_format(bytes)?;
    let (pixels, exif) = read(bytes, format, name, limits)?;
    let (width, height) = pixels.size;
    let (profile, grey) = (pixels.profile.as_deref().and_then(icc::correction), pixels.grey);
    let mut image = pixels.reduced(resize::fit(width, height, longest))?;
    // After the reduction, which leaves less to do; all that was averaged lies close together.
    if let Some(profile) = profile {
        profile.apply(&mut image, grey);
    }
    let image = upright(image, exif.orientation)?;
    let (width, height) = if swaps_sides(exif.orientation) { (height, width) } else { (width, height) };
    let (width, height) = (width as u32, height as u32);
    Ok(Decoded { image, width, height, format: name, taken: exif.taken, orientation: exif.orientation })
}

fn known_format(bytes: &[u8]) -> Result<(ImageFormat, &'static str)> {
    let format = ::image::guess_format(bytes).map_err(|_| Error::UnknownFormat)?;
    let name = match format {
        ImageFormat::Jpeg => "JPEG",
        ImageFormat::Png => "PNG",
        ImageFormat::WebP => "WebP",
        ImageFormat::Gif => "GIF",
        ImageFormat::Bmp => "BMP",
        ImageFormat::Tiff => "TIFF",
        _ => return Err(Error::UnknownFormat),
    };
    Ok((format, name))
}

/// The decoder's pixels: interleaved RGB, or grey.
struct Pixels {
    size: (usize, usize),
    samples: Vec<u8>,
    grey: bool,
    /// The file's ICC profile.
    profile: Option<Vec<u8>>,
}

impl Pixels {
    fn reduced(self, (new_width, new_height): (usize, usize)) -> Result<Image> {
        let (width, height) = self.size;
        if !self.grey {
            return resize::planes_of_interleaved(&self.samples, self.size, (new_width, new_height));
        }
        let mut plane = Plane::from_samples(width, height, self.samples)?;
        if (new_width, new_height) != (width, height) {
            plane = resize::resample(&plane, Region::whole(width, height), new_width, new_height);
        }
        Image::from_rgb([plane.clone(), plane.clone(), plane])
    }
}

fn read(bytes: &[u8], format: ImageFormat, name: &'static str, limits: &Limits) -> Result<(Pixels, Exif)> {
    let file = Cursor::new(bytes);
    // Each decoder by its own type: behind a common one all that they can do besides would be in the module too.
    match format {
        ImageFormat::Jpeg => {
            let exif = check_jpeg(bytes, name, limits)?.exif.map(exif::read).unwrap_or_default();
            let mut decoder = jpeg::Decoder::new(bytes, name)?;
            let (size, grey) = (decoder.size(), decoder.is_grey());
            check_size(size.0 as u32, size.1 as u32, name, limits)?;
            check_memory(size, if grey { 1 } else { 3 }, limits)?;
            let (samples, profile) = (decoder.samples()?, decoder.profile());
            Ok((Pixels { size, samples, grey, profile }, exif))
        }
        ImageFormat::WebP => {
            check_riff(bytes, name)?;
            read_with(WebPDecoder::new(file), embedded, name, limits)
        }
        ImageFormat::Tiff => {
            let records = (exif::read(bytes), exif::profile(bytes).map(<[u8]>::to_vec));
            read_with(TiffDecoder::new(file), |_| records, name, limits)
        }
        ImageFormat::Gif => read_with(GifDecoder::new(file), |_| Records::default(), name, limits),
        ImageFormat::Bmp => read_with(BmpDecoder::new(file), |_| Records::default(), name, limits),
        _ => read_with(PngDecoder::with_limits(file, allowance(limits)), embedded, name, limits),
    }
}

/// What the EXIF record says, and the ICC profile.
type Records = (Exif, Option<Vec<u8>>);

/// Both as a decoder finds them.
fn embedded<D: ImageDecoder>(decoder: &mut D) -> Records {
    let exif = decoder.exif_metadata().ok().flatten().as_deref().map(exif::read).unwrap_or_default();
    (exif, decoder.icc_profile().ok().flatten())
}

fn allowance(limits: &Limits) -> ::image::Limits {
    // The sides are checked where the error can name them.
    let mut allowance = ::image::Limits::no_limits();
    allowance.max_alloc = Some(limits.max_bytes);
    allowance
}

fn read_with<D: ImageDecoder>(
    decoder: ImageResult<D>,
    records: impl FnOnce(&mut D) -> Records,
    name: &'static str,
    limits: &Limits,
) -> Result<(Pixels, Exif)> {
    let failed = |error| explained(error, name);
    let mut decoder = decoder.map_err(failed)?;
    decoder.set_limits(allowance(limits)).map_err(failed)?;
    let (width, height) = decoder.dimensions();
    check_size(width, height, name, limits)?;
    let (exif, profile) = records(&mut decoder);
    let size = (width as usize, height as usize);
    let color = decoder.color_type();
    check_memory(size, u64::from(color.bytes_per_pixel()), limits)?;
    let mut bytes = vec![0; decoder.total_bytes() as usize];
    decoder.read_image(&mut bytes).map_err(failed)?;
    let Samples { bytes, grey } = samples::flattened(color, bytes);
    Ok((Pixels { size, samples: bytes, grey, profile }, exif))
}

/// The decoder's pixels and ours together must fit.
fn check_memory((width, height): (usize, usize), bytes_per_pixel: u64, limits: &Limits) -> Result<()> {
    let pixels = width as u64 * height as u64;
    if pixels.saturating_mul(bytes_per_pixel + 4) > limits.max_bytes {
        return Err(too_large(
            width as u32,
            height as u32,
            format!("{} MB of memory", limits.max_bytes >> 20),
        ));
    }
    Ok(())
}

fn check_jpeg<'a>(bytes: &'a [u8], name: &'static str, limits: &Limits) -> Result<Markers<'a>> {
    let markers = Markers::of(bytes);
    if let Some((width, height)) = markers.size {
        check_size(width, height, name, limits)?;
    }
    if !markers.complete {
        return Err(Error::damaged(name, "its end is missing"));
    }
    if !markers.plausible(bytes.len()) {
        return Err(Error::damaged(name, "it is too short for the size that it announces"));
    }
    Ok(markers)
}

/// A RIFF file (WebP) says how long it is.
fn check_riff(bytes: &[u8], name: &'static str) -> Result<()> {
    let announced =
        bytes.get(4..8).and_then(<[u8]>::first_chunk).map_or(0, |&length| u32::from_le_bytes(length));
    if bytes.len() as u64 >= u64::from(announced) + 8 {
        Ok(())
    } else {
        Err(Error::damaged(name, "its end is missing"))
    }
}

fn check_size(width: u32, height: u32, name: &'static str, limits: &Limits) -> Result<()> {
    if width == 0 || height == 0 {
        return Err(Error::damaged(name, "it announces no pixels"));
    }
    if width.max(height) > limits.max_side {
        return Err(too_large(width, height, format!("{} pixels a side", limits.max_side)));
    }
    if u64::from(width) * u64::from(height) > limits.max_pixels {
        return Err(too_large(width, height, format!("{} megapixels", limits.max_pixels / 1_000_000)));
    }
    Ok(())
}

fn too_large(width: u32, height: u32, limit: String) -> Error {
    Error::TooLarge { width: width.into(), height: height.into(), limit }
}

fn explained(error: ImageError, format: &'static str) -> Error {
    match error {
        ImageError::Unsupported(reason) => Error::Unsupported { format, reason: reason.to_string() },
        ImageError::Limits(_) => Error::damaged(format, "it asks for more memory than its size explains"),
        error => Error::damaged(format, error),
    }
}
