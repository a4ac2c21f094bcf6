//! Imports a photo: two reduced copies, and the measurements for selection and framing.

use super::catalogue::MeasuresEntry;
use super::png;
use crate::error::Result;
use crate::framing::{self, EnergyMap, PhotoMeta};
use crate::raster::Image;
use crate::raster::decode::{Damage, Decoded, Limits, decode_reduced, decode_sparse};
use crate::raster::orient::turned_clockwise;
use crate::raster::resize::{Region, fit, resample_image};
use crate::select::{Measures, measure};
use serde::Serialize;

/// Long side of the copy that previews are rendered from, in pixels.
pub const WORK_SIDE: usize = 1600;

/// Long side of the copy that thumbnails are rendered from, in pixels.
pub const SMALL_SIDE: usize = 400;

/// Long side of the copy that the first page is rendered from until the photo is read, in pixels. Photos of
/// twelve megapixels have it at an eighth of their size.
pub const DRAFT_SIDE: usize = 500;

/// An imported photo.
#[derive(Debug, Clone)]
pub struct Imported {
    /// Facts for selection and framing.
    pub meta: PhotoMeta,
    /// Measures that selection compares.
    pub measures: Measures,
    /// Name of the file's format.
    pub format: &'static str,
    /// The damage of the file, if any.
    pub damage: Option<Damage>,
    /// The photo at [`WORK_SIDE`] or less.
    pub work: Image,
    /// The photo at [`SMALL_SIDE`] or less.
    pub small: Image,
}

/// Data of an imported photo for the app.
#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ImportEntry<'a> {
    /// Measurements for framing.
    pub meta: &'a PhotoMeta,
    /// Name of the file's format.
    pub format: &'static str,
    /// The damage of the file, if any.
    pub damage: Option<Damage>,
    /// Measurements for the selection.
    pub measures: MeasuresEntry,
    /// Size of the photo at [`WORK_SIDE`] or less.
    pub work: PixelSize,
    /// Size of the photo at [`SMALL_SIDE`] or less.
    pub small: PixelSize,
}

/// A size in pixels.
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PixelSize {
    /// Across.
    pub width: usize,
    /// Down.
    pub height: usize,
}

impl Imported {
    /// Returns the data for the app.
    #[must_use]
    pub fn entry(&self) -> ImportEntry<'_> {
        let size = |image: &Image| PixelSize { width: image.width(), height: image.height() };
        ImportEntry {
            meta: &self.meta,
            format: self.format,
            damage: self.damage,
            measures: (&self.measures).into(),
            work: size(&self.work),
            small: size(&self.small),
        }
    }
}

/// Decodes, orients, reduces and measures a file.
///
/// # Errors
/// `unknown-format`, `damaged`, `too-large`.
pub fn import(id: &str, bytes: &[u8], limits: &Limits) -> Result<Imported> {
    Ok(of_decoded(id, decode_reduced(bytes, limits, WORK_SIDE)?))
}

/// Decodes a large JPEG file at [`DRAFT_SIDE`], in about a third of the time of [`import`]. The page shows it
/// until the photo is imported. Returns `None` for other files.
///
/// # Errors
/// As [`import`].
pub fn import_draft(id: &str, bytes: &[u8], limits: &Limits) -> Result<Option<Imported>> {
    Ok(decode_sparse(bytes, limits, DRAFT_SIDE)?.map(|decoded| of_decoded(id, decoded)))
}

fn of_decoded(id: &str, decoded: Decoded) -> Imported {
    let facts = Facts { size: (decoded.width, decoded.height), format: decoded.format, taken: decoded.taken };
    Imported { damage: decoded.damage, ..described(id, decoded.image, facts) }
}

/// Reduces and measures upright sRGB pixels without a file.
///
/// # Errors
/// `too-large` beyond `limits`.
pub fn import_image(id: &str, image: &Image, limits: &Limits) -> Result<Imported> {
    let size = (image.width() as u32, image.height() as u32);
    limits.check(size.0, size.1, "image")?;
    let longest = image.width().max(image.height());
    let work = if longest > WORK_SIDE { reduced(image, WORK_SIDE) } else { image.clone() };
    Ok(described(id, work, Facts { size, format: "pixels", taken: None }))
}

/// A decoded frame of a video.
#[derive(Debug, Clone, Copy)]
pub struct Frame<'a> {
    /// Stored width and height in pixels.
    pub size: (usize, usize),
    /// Interleaved RGBA, `4 * width * height` bytes; alpha is ignored.
    pub rgba: &'a [u8],
    /// Width and height in square pixels, before the turn.
    pub square: (usize, usize),
    /// Degrees that the frame is turned clockwise to stand upright: 0, 90, 180 or 270.
    pub rotation: u32,
}

/// Rotates, reduces and measures a frame. It also returns the frame as a PNG file in full size, which
/// replaces the original.
///
/// # Errors
/// `buffer-size` for pixels that do not fit the size, `too-large` beyond `limits`.
pub fn import_frame(id: &str, frame: &Frame, limits: &Limits) -> Result<(Imported, Vec<u8>)> {
    let image = upright(frame, limits)?;
    let file = png::encode_rgb(image.width(), image.height(), &image.to_rgb(), 72)?;
    let (width, height) = (image.width(), image.height());
    let facts = Facts { size: (width as u32, height as u32), format: "Video", taken: None };
    let work = if width.max(height) > WORK_SIDE { reduced(&image, WORK_SIDE) } else { image };
    Ok((described(id, work, facts), file))
}

/// Returns a frame upright, in square pixels, with a long side of at most `longest`: one of many frames of an
/// animated panel.
///
/// # Errors
/// As [`import_frame`].
pub fn small_frame(frame: &Frame, longest: usize, limits: &Limits) -> Result<Image> {
    let image = upright(frame, limits)?;
    Ok(if image.width().max(image.height()) > longest { reduced(&image, longest) } else { image })
}

fn upright(frame: &Frame, limits: &Limits) -> Result<Image> {
    let (width, height) = frame.size;
    limits.check(width as u32, height as u32, "Video")?;
    let mut image = Image::from_rgba(width, height, frame.rgba, [255; 3])?;
    if frame.square != frame.size {
        limits.check(frame.square.0 as u32, frame.square.1 as u32, "Video")?;
        image = resample_image(&image, Region::whole(width, height), frame.square.0, frame.square.1);
    }
    turned_clockwise(image, frame.rotation)
}

/// Metadata of the file.
struct Facts {
    size: (u32, u32),
    format: &'static str,
    taken: Option<String>,
}

fn described(id: &str, work: Image, facts: Facts) -> Imported {
    let small = reduced(&work, SMALL_SIDE);
    let measures = measure(&work);
    let meta = PhotoMeta {
        fingerprint: measures.fingerprint,
        sharpness: measures.gradient,
        energy: EnergyMap::of(&small),
        taken: facts.taken,
        subjects: framing::lettering(&small),
        facts: Some(framing::Facts::of(&small)),
        ..PhotoMeta::unmeasured(id, facts.size.0, facts.size.1)
    };
    Imported { meta, measures, format: facts.format, damage: None, work, small }
}

fn reduced(image: &Image, longest: usize) -> Image {
    let (width, height) = fit(image.width(), image.height(), longest);
    resample_image(image, Region::whole(image.width(), image.height()), width, height)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::decode::decode;

    #[test]
    fn a_frame_is_stretched_turned_and_kept_as_a_file() {
        // Red on the left, blue on the right, in pixels twice as wide as high.
        let rgba: Vec<u8> =
            (0..20 * 30).flat_map(|i| if i % 20 < 10 { [255, 0, 0, 0] } else { [0, 0, 255, 0] }).collect();
        let opaque: Vec<u8> = rgba.chunks(4).flat_map(|p| [p[0], p[1], p[2], 255]).collect();
        let frame = Frame { size: (20, 30), rgba: &opaque, square: (40, 30), rotation: 90 };
        let (imported, file) = import_frame("f", &frame, &Limits::default()).unwrap();
        assert_eq!((imported.meta.width, imported.meta.height), (30, 40));
        let full = decode(&file, &Limits::default()).unwrap().image;
        assert_eq!((full.width(), full.height()), (30, 40));
        assert_eq!(full.planes()[0].at(15, 2), 255, "what was on the left is on top");
        assert_eq!(full.planes()[2].at(15, 38), 255);
        let wrong = Frame { rgba: &opaque[4..], ..frame };
        assert_eq!(import_frame("f", &wrong, &Limits::default()).unwrap_err().code(), "buffer-size");
        let huge = Frame { square: (100_000, 30), ..frame };
        assert_eq!(import_frame("f", &huge, &Limits::default()).unwrap_err().code(), "too-large");
    }
}
