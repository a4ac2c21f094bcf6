//! Bytes of a file to pixels, with limits and EXIF orientation.
//!
//! The format is detected by content, never by file name. Everything that the header announces is checked
//! before memory is allocated. The readable part of a damaged JPEG or PNG file is decoded, and the damage
//! is reported. Other damaged files are an error.

use std::io::Cursor;

use ::image::codecs::bmp::BmpDecoder;
#[cfg(feature = "rare")]
use ::image::codecs::webp::WebPDecoder;
use ::image::{ImageDecoder, ImageError, ImageFormat, ImageResult};

use super::exif::{self, Exif};
use super::heif;
use super::jpeg::{self, Markers};
#[cfg(feature = "rare")]
use super::limits::MOST_PROFILE;
use super::limits::check_memory;
pub use super::limits::{Damage, Limits};
use super::orient::{swaps_sides, upright};
use super::samples::{self, Alpha, Pixels};
use super::{Image, png, resize};
#[cfg(feature = "rare")]
use super::{gif, tiff};
use crate::error::{Error, Result};

/// A decoded photo.
#[derive(Clone, Debug)]
pub struct Decoded {
    /// Upright, in colour (a grey file has three like planes), transparency flattened on white.
    pub image: Image,
    /// Width of the whole photo in pixels, upright.
    pub width: u32,
    /// Height of the whole photo in pixels, upright.
    pub height: u32,
    /// Name of the format: JPEG, PNG, WebP, GIF, BMP, TIFF or HEIC.
    pub format: &'static str,
    /// When it was taken, `YYYY:MM:DD HH:MM:SS` of the camera's clock, with a fraction of the second if there is one.
    pub taken: Option<String>,
    /// EXIF's 1..=8, already applied.
    pub orientation: u8,
    /// The damage of the file, if any.
    pub damage: Option<Damage>,
}

/// Decodes a file at its full size; of an animation the first frame.
///
/// # Errors
/// `unknown-format`, `unsupported`, `damaged` if less than half of the image can be decoded, `too-large`.
pub fn decode(bytes: &[u8], limits: &Limits) -> Result<Decoded> {
    decode_fit(bytes, limits, usize::MAX)
}

/// Decodes a file and reduces it, by exact area, to a long side of at most `longest` pixels. The full size
/// exists only as the decoder's own buffer.
///
/// # Errors
/// As [`decode`].
pub fn decode_fit(bytes: &[u8], limits: &Limits, longest: usize) -> Result<Decoded> {
    let (name, (pixels, exif)) = if let Some(name) = heif::kind(bytes) {
        (name, heif::read(name, bytes, limits)?)
    } else {
        let (format, name) = known_format(bytes)?;
        (name, read(bytes, format, name, limits)?)
    };
    let ((width, height), damage) = (pixels.size, pixels.damage);
    let image = pixels.image(resize::fit(width, height, longest))?;
    Ok(Decoded { damage, ..finished(image, (width, height), &exif, name)? })
}

/// Decodes a HEIC file like [`decode`]. A module that calls only this function contains no other decoder.
///
/// # Errors
/// As [`decode`].
#[cfg(feature = "heic")]
pub fn decode_heic(bytes: &[u8], limits: &Limits) -> Result<Decoded> {
    let Some(name @ "HEIC") = heif::kind(bytes) else { return Err(Error::UnknownFormat) };
    let (pixels, exif) = heif::read(name, bytes, limits)?;
    let size = pixels.size;
    finished(pixels.image(size)?, size, &exif, name)
}

/// Like [`decode`], but decodes a JPEG file at reduced size if it is at least twice as large as `longest`.
/// This takes two thirds of the time and at most a quarter of the memory. Samples differ by a few steps.
///
/// # Errors
/// As [`decode`].
pub fn decode_reduced(bytes: &[u8], limits: &Limits, longest: usize) -> Result<Decoded> {
    match decode_sparse(bytes, limits, longest)? {
        Some(decoded) => Ok(decoded),
        None => decode_fit(bytes, limits, longest),
    }
}

/// Decodes a JPEG file at a half, a quarter or an eighth of its sides, and reduces it to a long side of
/// `longest` pixels. An eighth takes about a third of the time of a half. Returns `None` for other formats, and
/// for files that are less than twice as large, progressive or damaged.
///
/// # Errors
/// As [`decode`].
pub fn decode_sparse(bytes: &[u8], limits: &Limits, longest: usize) -> Result<Option<Decoded>> {
    let Ok((ImageFormat::Jpeg, name)) = known_format(bytes) else { return Ok(None) };
    let markers = check_jpeg(bytes, name, limits)?;
    let size = markers.size.map(|(width, height)| (width as usize, height as usize));
    let fitting = size.filter(|&size| check_memory(size, u64::from(markers.components), limits).is_ok());
    let Some((size, planes)) = fitting.zip(jpeg::reduced(bytes, longest)) else { return Ok(None) };
    let exif = markers.exif.map(exif::read).unwrap_or_default();
    finished(samples::image_of(planes, markers.profile())?, size, &exif, name).map(Some)
}

/// A photo of a size, as it is stored, whose pixels may be fewer.
#[inline(never)]
fn finished(image: Image, size: (usize, usize), exif: &Exif, name: &'static str) -> Result<Decoded> {
    let image = upright(image, exif.orientation)?;
    let (width, height) = if swaps_sides(exif.orientation) { (size.1, size.0) } else { size };
    let (width, height) = (width as u32, height as u32);
    let taken = exif.taken.clone();
    Ok(Decoded { image, width, height, format: name, taken, orientation: exif.orientation, damage: None })
}

fn known_format(bytes: &[u8]) -> Result<(ImageFormat, &'static str)> {
    let format = ::image::guess_format(bytes).map_err(|_| Error::UnknownFormat)?;
    let name = match format {
        ImageFormat::Jpeg => "JPEG",
        ImageFormat::Png => "PNG",
        #[cfg(feature = "rare")]
        ImageFormat::WebP => "WebP",
        #[cfg(feature = "rare")]
        ImageFormat::Gif => "GIF",
        ImageFormat::Bmp => "BMP",
        #[cfg(feature = "rare")]
        ImageFormat::Tiff => "TIFF",
        _ => return Err(Error::UnknownFormat),
    };
    Ok((format, name))
}

fn read(bytes: &[u8], format: ImageFormat, name: &'static str, limits: &Limits) -> Result<(Pixels, Exif)> {
    // Each decoder by its own type: behind a common one all that they can do besides would be in the module too.
    match format {
        ImageFormat::Jpeg => {
            let markers = check_jpeg(bytes, name, limits)?;
            let (image, damage) = jpeg::readable(bytes, &markers, name, limits)?;
            let mut decoder = jpeg::Decoder::new(image, name)?;
            let (size, channels) = (decoder.size(), decoder.channels());
            limits.check(size.0 as u32, size.1 as u32, name)?;
            check_memory(size, channels.count() as u64, limits)?;
            let exif = markers.exif.map(exif::read).unwrap_or_default();
            let (samples, profile) = (decoder.samples()?, markers.profile());
            Ok((Pixels { size, samples, channels, profile, damage }, exif))
        }
        #[cfg(feature = "rare")]
        ImageFormat::WebP | ImageFormat::Tiff | ImageFormat::Gif => read_rare(bytes, format, name, limits),
        ImageFormat::Bmp => {
            Ok((read_with(BmpDecoder::new(Cursor::new(bytes)), name, limits)?, Exif::default()))
        }
        _ => png::read(bytes, name, limits),
    }
}

#[cfg(feature = "rare")]
fn read_rare(
    bytes: &[u8],
    format: ImageFormat,
    name: &'static str,
    limits: &Limits,
) -> Result<(Pixels, Exif)> {
    match format {
        ImageFormat::Tiff => {
            let pixels = tiff::read(bytes, name, limits)?.with_profile(exif::profile(bytes));
            Ok((pixels, exif::read(bytes)))
        }
        ImageFormat::Gif => Ok((gif::read(bytes, name, limits)?, Exif::default())),
        ImageFormat::WebP => {
            check_riff(bytes, name)?;
            let (exif, profile) = records_of_webp(bytes);
            let pixels = read_with(WebPDecoder::new(Cursor::new(bytes)), name, limits)?;
            Ok((pixels.with_profile(profile), exif))
        }
        _ => Err(Error::UnknownFormat),
    }
}

/// Returns the EXIF record of a WebP file.
#[cfg(feature = "rare")]
pub(super) fn exif_of_webp(bytes: &[u8]) -> Option<&[u8]> {
    let mut rest = bytes.get(12..)?;
    loop {
        let (kind, after) = rest.split_first_chunk::<4>()?;
        let (&length, after) = after.split_first_chunk()?;
        let length = u32::from_le_bytes(length) as usize;
        if kind == b"EXIF" {
            return after.get(..length);
        }
        rest = after.get(length.next_multiple_of(2)..)?;
    }
}

/// Returns the EXIF record and the ICC profile of a WebP file. The decoder of the file would copy records of
/// any length.
#[cfg(feature = "rare")]
pub(super) fn records_of_webp(bytes: &[u8]) -> (Exif, Option<Vec<u8>>) {
    let (mut exif, mut profile) = (Exif::default(), None);
    let mut rest = bytes.get(12..).unwrap_or_default();
    while let Some((kind, after)) = rest.split_first_chunk::<4>() {
        let Some((&length, after)) = after.split_first_chunk() else { break };
        let length = u32::from_le_bytes(length) as usize;
        let Some(body) = after.get(..length) else { break };
        match kind {
            b"EXIF" => exif = exif::read(body),
            b"ICCP" if length <= MOST_PROFILE => profile = Some(body.to_vec()),
            _ => {}
        }
        rest = after.get(length.next_multiple_of(2)..).unwrap_or_default();
    }
    (exif, profile)
}

fn read_with<D: ImageDecoder>(
    decoder: ImageResult<D>,
    name: &'static str,
    limits: &Limits,
) -> Result<Pixels> {
    let failed = |error| explained(error, name);
    let mut decoder = decoder.map_err(failed)?;
    // The sides are checked where the error can name them.
    let mut allowance = ::image::Limits::no_limits();
    allowance.max_alloc = Some(limits.max_bytes);
    decoder.set_limits(allowance).map_err(failed)?;
    let (width, height) = decoder.dimensions();
    limits.check(width, height, name)?;
    let size = (width as usize, height as usize);
    let color = decoder.color_type();
    check_memory(size, u64::from(color.bytes_per_pixel()), limits)?;
    let mut bytes = vec![0; decoder.total_bytes() as usize];
    decoder.read_image(&mut bytes).map_err(failed)?;
    let (mut samples, channels, alpha) = samples::narrowed(color, bytes);
    if name == "BMP" && alpha == Alpha::Straight && samples.iter().skip(3).step_by(4).all(|&alpha| alpha == 0)
    {
        // The maker gave the alpha a place and forgot to fill it; browsers show such a file, too.
        samples.iter_mut().skip(3).step_by(4).for_each(|alpha| *alpha = 255);
    }
    Ok(Pixels::flattened(size, samples, channels, alpha))
}

#[inline(never)]
fn check_jpeg<'a>(bytes: &'a [u8], name: &'static str, limits: &Limits) -> Result<Markers<'a>> {
    let markers = Markers::of(bytes);
    if let Some((width, height)) = markers.size {
        limits.check(width, height, name)?;
    }
    if let Some(reason) = markers.unsupported() {
        return Err(Error::Unsupported { format: name, reason: reason.to_owned() });
    }
    if !markers.plausible(bytes.len()) {
        return Err(Error::damaged(name, "it is too short for its image size"));
    }
    Ok(markers)
}

/// A RIFF file (WebP) says how long it is.
#[cfg(feature = "rare")]
fn check_riff(bytes: &[u8], name: &'static str) -> Result<()> {
    let announced =
        bytes.get(4..8).and_then(<[u8]>::first_chunk).map_or(0, |&length| u32::from_le_bytes(length));
    if bytes.len() as u64 >= u64::from(announced) + 8 {
        Ok(())
    } else {
        Err(Error::damaged(name, "it is truncated"))
    }
}

pub(super) fn explained(error: ImageError, format: &'static str) -> Error {
    match error {
        ImageError::Unsupported(reason) => Error::Unsupported { format, reason: reason.to_string() },
        ImageError::Limits(_) => Error::damaged(format, "the decoder exceeded the memory limit"),
        error => Error::damaged(format, error),
    }
}
