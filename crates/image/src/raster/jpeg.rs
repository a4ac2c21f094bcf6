//! Headers of a JPEG file: size, EXIF record, profile and damage.
//!
//! `zune-jpeg` decodes the pixels. It draws damaged parts grey or wrong without an error, so the coded data are checked first, and
//! damaged files are rewritten ([`rescue`]). Source: ITU-T T.81, annex B.

mod header;
mod huffman;
mod reduced;
mod rescue;
mod sound;

use super::Plane;
use super::channels::Channels;
use super::limits::{Damage, Limits, MOST_PROFILE, check_memory};
use super::resize::{self, Region};
use super::samples::rgb_of_ycc;
use crate::error::{Error, Result};
use crate::simd::ycc;
use zune_jpeg::JpegDecoder;
use zune_jpeg::errors::DecodeErrors;
use zune_jpeg::zune_core::bytestream::ZCursor;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

/// A file whose headers were read.
pub(super) struct Decoder {
    /// The same type as `tiff` uses for JPEG in TIFF. Another type would be compiled a second time.
    file: JpegDecoder<ZCursor<Vec<u8>>>,
    size: (usize, usize),
    channels: Channels,
    /// Whether the inks are stored as luma and chroma.
    is_ycck: bool,
    name: &'static str,
}

impl Decoder {
    /// Reads the headers of a file without metadata. `name` is the format in messages.
    pub(super) fn new(image: Vec<u8>, name: &'static str) -> Result<Self> {
        // Files with small faults are drawn by every other program, too; the sides are checked by the caller.
        let options = DecoderOptions::default()
            .set_strict_mode(false)
            .set_max_width(usize::MAX)
            .set_max_height(usize::MAX);
        let mut decoder = JpegDecoder::new_with_options(ZCursor::new(image), options);
        decoder.decode_headers().map_err(|error| explained(error, name))?;
        let colors = decoder.input_colorspace();
        let (channels, out) = match colors {
            Some(ColorSpace::Luma) => (Channels::Grey, ColorSpace::Luma),
            // Unchanged, because a profile defines their look.
            Some(inks @ (ColorSpace::CMYK | ColorSpace::YCCK)) => (Channels::Cmyk, inks),
            _ => (Channels::Rgb, ColorSpace::RGB),
        };
        decoder.set_options(options.jpeg_set_out_colorspace(out));
        let size = decoder
            .dimensions()
            .ok_or_else(|| Error::damaged(name, "its width or height is zero or missing"))?;
        Ok(Self { file: decoder, size, channels, is_ycck: colors == Some(ColorSpace::YCCK), name })
    }

    /// Width and height in pixels.
    pub(super) fn size(&self) -> (usize, usize) {
        self.size
    }

    /// Channels of a pixel.
    pub(super) fn channels(&self) -> Channels {
        self.channels
    }

    /// The samples, interleaved.
    pub(super) fn samples(&mut self) -> Result<Vec<u8>> {
        let mut samples = self.file.decode().map_err(|error| explained(error, self.name))?;
        if self.channels == Channels::Cmyk {
            // Adobe's files, and so all, have light instead of ink in them.
            for pixel in samples.as_chunks_mut::<4>().0 {
                let [a, b, c, k] = *pixel;
                let [c, m, y] =
                    if self.is_ycck { rgb_of_ycc([a, b, c]) } else { [255 - a, 255 - b, 255 - c] };
                *pixel = [c, m, y, 255 - k];
            }
        }
        Ok(samples)
    }
}

/// Decodes the planes of a photo at reduced size, then reduces them to a long side of `longest`. Returns
/// `None` if the file is less than twice as large, of an unusual kind, or damaged.
pub(super) fn reduced(bytes: &[u8], longest: usize) -> Option<Vec<Plane>> {
    let mut photo = reduced::reduced(bytes, longest)?;
    if let [y, u, v] = &mut photo.planes[..] {
        ycc::rgb_of_ycc([y, u, v]);
    }
    let side = |length: usize| (length * photo.of_eight) as f64 / 8.0;
    let region = Region { x: 0.0, y: 0.0, width: side(photo.size.0), height: side(photo.size.1) };
    let (width, height) = resize::fit(photo.size.0, photo.size.1, longest);
    let planes = photo.planes.into_iter().map(|samples| {
        let plane = Plane::from_samples(photo.width, photo.height, samples).ok()?;
        Some(resize::resample(&plane, region, width, height))
    });
    planes.collect()
}

/// The file without records, as the decoder takes it, and the damage that is left out of it.
///
/// # Errors
/// `damaged` if less than half of the picture can be decoded, `too-large` if its repair needs too much
/// memory.
pub(super) fn readable(
    bytes: &[u8],
    markers: &Markers<'_>,
    name: &'static str,
    limits: &Limits,
) -> Result<(Vec<u8>, Option<Damage>)> {
    if markers.complete && sound::is_sound(bytes) {
        return Ok((markers.without_records(bytes), None));
    }
    if let Some(end) = video_start(bytes) {
        return readable(&bytes[..end], &Markers::of(&bytes[..end]), name, limits);
    }
    let size = markers.size.map_or((0, 0), |(width, height)| (width as usize, height as usize));
    // Two bytes for each coefficient, and the file.
    let room = check_memory(size, 3 * u64::from(markers.components), limits);
    let rescued = match room {
        Err(error) if markers.frame != PROGRESSIVE => return Err(error),
        Err(_) => None,
        Ok(()) => rescue::rescued(bytes),
    };
    match rescued {
        Some((file, damage)) => Ok((file, damage.checked(name)?)),
        // An unusual kind, which the decoder may support.
        None if markers.complete => Ok((markers.without_records(bytes), None)),
        None => Err(Error::damaged(name, "it is truncated")),
    }
}

/// Position of the video of a motion photo: a box `ftyp` of ISO/IEC 14496-12 with the name of a brand. Some phones write the video
/// directly after the coded data, without an end marker. Bytes of the video must not count as coded data.
fn video_start(bytes: &[u8]) -> Option<usize> {
    let starts = |&at: &usize| {
        let Some(&[a, b, c, d, ..]) = bytes[at..].first_chunk::<12>() else { return false };
        let length = u32::from_be_bytes([a, b, c, d]);
        (16..=256).contains(&length)
            && length.is_multiple_of(4)
            && bytes[at + 8..at + 12].iter().all(|byte| (b' '..=b'~').contains(byte))
    };
    let mut scan = 2;
    loop {
        let (marker, after) = next_marker(bytes, scan)?;
        let length = bytes.get(after..).and_then(<[u8]>::first_chunk).map(|&two| u16::from_be_bytes(two))?;
        scan = after + usize::from(length);
        if marker == START_OF_SCAN {
            break;
        }
    }
    let kinds = bytes.get(scan..)?.windows(4).enumerate().skip(4).filter(|(_, four)| four == b"ftyp");
    kinds.map(|(at, _)| scan + at - 4).find(starts)
}

fn explained(error: DecodeErrors, format: &'static str) -> Error {
    match error {
        DecodeErrors::Unsupported(reason) => Error::Unsupported { format, reason: format!("{reason:?}") },
        error => Error::damaged(format, error),
    }
}

/// The markers of a file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Markers<'a> {
    /// Width and height as announced.
    pub(super) size: Option<(u32, u32)>,
    /// Marker of the frame: the kind of file; 0 without a frame.
    frame: u8,
    /// Bits of a sample.
    precision: u8,
    /// Number of colour components.
    pub(super) components: u8,
    /// The EXIF record, without its mark.
    pub(super) exif: Option<&'a [u8]>,
    /// True when the end of the image is there.
    pub(super) complete: bool,
    /// End of the image, or end of the file if the end marker is missing.
    end: usize,
    /// The parts of the ICC profile: a number from 1, how many there are, and bytes.
    parts: Vec<&'a [u8]>,
}

const HUFFMAN_TABLES: u8 = 0xC4;
const END_OF_IMAGE: u8 = 0xD9;
const PROGRESSIVE: u8 = 0xC2;
const START_OF_SCAN: u8 = 0xDA;
const QUANTIZATION_TABLES: u8 = 0xDB;
const RESTART_INTERVAL: u8 = 0xDD;
const APP0: u8 = 0xE0;
const APP1: u8 = 0xE1;
const APP2: u8 = 0xE2;
/// Adobe's marker, which defines the colour space.
const APP14: u8 = 0xEE;
const APP15: u8 = 0xEF;
const COMMENT: u8 = 0xFE;
/// A part's number has one byte.
const MOST_PARTS: usize = 255;

/// The EXIF record of a file, without its mark. The beginning of the file is enough.
pub(super) fn exif(bytes: &[u8]) -> Option<&[u8]> {
    Markers::of(bytes).exif
}

impl<'a> Markers<'a> {
    /// Walks through the segments, and through the coded data between them.
    pub(super) fn of(bytes: &'a [u8]) -> Self {
        let (end, parts) = (bytes.len(), Vec::new());
        let (frame, precision, components) = (0, 0, 0);
        let mut markers =
            Self { size: None, frame, precision, components, exif: None, complete: false, end, parts };
        let mut at = 2;
        while let Some((marker, after)) = next_marker(bytes, at) {
            if marker == END_OF_IMAGE {
                (markers.complete, markers.end) = (true, after);
                break;
            }
            let Some(&[high, low]) = bytes.get(after..).and_then(<[u8]>::first_chunk) else { break };
            let end = after + usize::from(u16::from_be_bytes([high, low]));
            let Some(payload) = bytes.get(after + 2..end) else { break };
            match marker {
                APP1 if markers.exif.is_none() => markers.exif = payload.strip_prefix(b"Exif\0\0"),
                APP2 if markers.parts.len() <= MOST_PARTS => {
                    markers.parts.extend(payload.strip_prefix(b"ICC_PROFILE\0"));
                }
                // Start of frame: C0..CF without DHT, JPG and DAC.
                0xC0..=0xCF if !matches!(marker, 0xC4 | 0xC8 | 0xCC) => {
                    // Damaged data may look like another frame.
                    if markers.size.is_none()
                        && let Some(&[precision, h1, h0, w1, w0, components]) = payload.first_chunk()
                    {
                        let size = [[w1, w0], [h1, h0]].map(|side| u32::from(u16::from_be_bytes(side)));
                        markers.size = Some((size[0], size[1]));
                        (markers.frame, markers.precision, markers.components) =
                            (marker, precision, components);
                    }
                }
                _ => {}
            }
            at = end;
        }
        markers
    }

    /// Joins the parts of the ICC profile. Returns `None` if a part is missing or the profile is too large.
    pub(super) fn profile(&self) -> Option<Vec<u8>> {
        let length: usize = self.parts.iter().map(|part| part.len()).sum();
        if self.parts.is_empty() || length > MOST_PROFILE {
            return None;
        }
        let count = u8::try_from(self.parts.len()).ok()?;
        let mut profile = Vec::with_capacity(length);
        for number in 1..=count {
            profile.extend(self.parts.iter().find_map(|part| part.strip_prefix(&[number, count]))?);
        }
        Some(profile)
    }

    /// The image without metadata segments, and without data after its end.
    fn without_records(&self, bytes: &[u8]) -> Vec<u8> {
        let mut image = bytes[..2.min(bytes.len())].to_vec();
        let mut at = 2;
        while let Some((marker, after)) = next_marker(bytes, at) {
            let start = after - 2;
            let length =
                bytes.get(after..).and_then(<[u8]>::first_chunk).map_or(0, |&two| u16::from_be_bytes(two));
            let segment = bytes.get(start..after + usize::from(length));
            let Some(segment) = segment.filter(|_| !matches!(marker, START_OF_SCAN | END_OF_IMAGE)) else {
                image.extend(bytes.get(start..self.end).unwrap_or_default());
                break;
            };
            if matches!(marker, APP0 | APP14) || !matches!(marker, APP1..=APP15 | COMMENT) {
                image.extend(segment);
            }
            at = start + segment.len();
        }
        image
    }

    /// The reason why this kind of file is not supported; `None` for supported files.
    pub(super) fn unsupported(&self) -> Option<&'static str> {
        match (self.frame, self.precision) {
            (0xC9..=0xCF, _) => Some("it uses arithmetic coding"),
            (0xC3, _) => Some("it is lossless"),
            (0xC5..=0xC7, _) => Some("it is hierarchical"),
            (0xC0..=0xC2, 12) => Some("it has 12 bits per sample"),
            _ => None,
        }
    }

    /// True when coded data of `length` bytes can hold the announced pixels: a block of 64 takes a bit at least.
    pub(super) fn plausible(&self, length: usize) -> bool {
        let (width, height) = self.size.unwrap_or((0, 0));
        u64::from(width) * u64::from(height) <= length as u64 * 8 * 64
    }
}

/// The next marker from `at`, and the position after it. Stuffed zeros, fill bytes and restarts are passed over,
/// and with them the coded data.
fn next_marker(bytes: &[u8], mut at: usize) -> Option<(u8, usize)> {
    loop {
        at += first_mark(bytes.get(at..)?)?;
        match *bytes.get(at + 1)? {
            0xFF => at += 1,
            0x00 | 0x01 | 0xD0..=0xD8 => at += 2,
            marker => return Some((marker, at + 2)),
        }
    }
}

/// The position of the first 0xFF. Most of a file is passed over by pieces, which is faster.
fn first_mark(bytes: &[u8]) -> Option<usize> {
    const PIECE: usize = 64;
    let piece = bytes.chunks(PIECE).position(|piece| piece.contains(&0xFF))?;
    let start = piece * PIECE;
    Some(start + bytes[start..].iter().position(|&byte| byte == 0xFF)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn segment(marker: u8, body: &[u8]) -> Vec<u8> {
        [&[0xFF, marker], &(body.len() as u16 + 2).to_be_bytes()[..], body].concat()
    }

    #[test]
    fn records_are_left_out_and_the_image_is_not() {
        let file = include_bytes!("../../../../tests/oracles/data/files/jpeg-icc-exif-6.jpg");
        let image = Markers::of(file).without_records(file);
        assert!(image.len() < file.len() - 500);
        let with_tail = [&file[..], &[7; 99]].concat();
        assert_eq!(
            Markers::of(&with_tail).without_records(&with_tail),
            image,
            "what follows the end is left out"
        );
        assert_eq!(Markers::of(&image).without_records(&image), image);
        let pixels = |bytes: &[u8]| Decoder::new(bytes.to_vec(), "JPEG").unwrap().samples().unwrap();
        assert_eq!(pixels(&image), pixels(file));
        // Adobe's marker is required, because it identifies four inks.
        let inks = include_bytes!("../../../../tests/oracles/data/files/jpeg-ycck.jpg");
        let kept = Markers::of(inks).without_records(inks);
        assert!(kept.windows(5).any(|window| window == b"Adobe"));
        for length in 0..file.len() {
            let _ = Markers::of(&file[..length]).without_records(&file[..length]);
        }
    }

    #[test]
    fn a_profile_is_put_together_of_all_its_parts_or_none() {
        let part = |number: u8, count: u8, body: &[u8]| {
            segment(APP2, &[b"ICC_PROFILE\0", &[number, count][..], body].concat())
        };
        let profile = |parts: &[Vec<u8>]| {
            let file = [vec![0xFF, 0xD8], parts.concat(), vec![0xFF, END_OF_IMAGE]].concat();
            Markers::of(&file).profile()
        };
        assert_eq!(profile(&[part(2, 2, b"cd"), part(1, 2, b"ab")]).unwrap(), b"abcd");
        assert_eq!(profile(&[]), None);
        assert_eq!(profile(&[part(1, 2, b"ab")]), None);
        assert_eq!(profile(&[part(1, 2, b"ab"), part(1, 2, b"ab")]), None);
        let large: Vec<_> = (1..=80).map(|i| part(i, 80, &vec![i; 65_000])).collect();
        assert_eq!(profile(&large), None, "more than {MOST_PROFILE} bytes");
        assert_eq!(profile(&large[..60]), None, "some are missing");
        let many: Vec<_> = (0..600).map(|_| part(1, 1, b"a")).collect();
        assert_eq!(profile(&many), None);
    }

    #[test]
    fn the_end_inside_a_thumbnail_is_not_the_end_of_the_image() {
        // SOI, an APP1 that holds a whole little file, SOF0 of 300 x 200 with 3 components, coded data.
        let mut file = vec![0xFF, 0xD8, 0xFF, APP1, 0, 8, 1, 2, 0xFF, END_OF_IMAGE, 3, 4];
        file.extend([0xFF, 0xC0, 0, 8, 8, 0, 200, 1, 44, 3]);
        file.extend([0xFF, START_OF_SCAN, 0, 2, 1, 2, 0xFF, 0, 3, 0xFF, 0xD0, 4]);
        let markers = Markers::of(&file);
        assert_eq!((markers.size, markers.components, markers.complete), (Some((300, 200)), 3, false));
        file.extend([0xFF, END_OF_IMAGE]);
        assert!(Markers::of(&file).complete);
        for length in 0..file.len() {
            assert!(!Markers::of(&file[..length]).complete, "{length}");
        }
    }
}
