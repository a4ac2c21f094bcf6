//! A file turned into what the page needs of a photo: two reduced copies and the facts that selection and
//! framing work with.

use crate::error::Result;
use crate::framing::{EnergyMap, PhotoMeta};
use crate::raster::Image;
use crate::raster::decode::{Limits, decode_fit};
use crate::raster::resize::{Region, fit, resample_image};
use crate::select::{Measures, measure};

/// Long side of the copy that previews are rendered from, in pixels.
pub const WORK_SIDE: usize = 1600;

/// Long side of the copy that thumbnails are rendered from, in pixels.
pub const SMALL_SIDE: usize = 400;

/// A photo as it was read.
pub struct Imported {
    /// Facts for selection and framing.
    pub meta: PhotoMeta,
    /// Measures that selection compares.
    pub measures: Measures,
    /// Name of the file's format.
    pub format: &'static str,
    /// The photo at [`WORK_SIDE`] or less.
    pub work: Image,
    /// The photo at [`SMALL_SIDE`] or less.
    pub small: Image,
}

/// Decodes, orients, reduces and measures a file.
///
/// # Errors
/// `unknown-format`, `damaged`, `too-large`.
pub fn import(id: &str, bytes: &[u8], limits: &Limits) -> Result<Imported> {
    let decoded = decode_fit(bytes, limits, WORK_SIDE)?;
    let work = decoded.image;
    let small = reduced(&work, SMALL_SIDE);
    let measures = measure(&work);
    let meta = PhotoMeta {
        id: id.to_owned(),
        width: decoded.width,
        height: decoded.height,
        fingerprint: measures.fingerprint,
        sharpness: measures.gradient,
        energy: EnergyMap::of(&small),
        taken: decoded.taken,
        subjects: Vec::new(),
        focus: None,
    };
    Ok(Imported { meta, measures, format: decoded.format, work, small })
}

fn reduced(image: &Image, longest: usize) -> Image {
    let (width, height) = fit(image.width(), image.height(), longest);
    resample_image(image, Region::whole(image.width(), image.height()), width, height)
}
