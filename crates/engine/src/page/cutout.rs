//! The isolated subject of a photo: its mask at the photo's size, and an image that is transparent outside of
//! it.

use super::png;
use crate::error::Result;
use crate::raster::guided::refined;
use crate::raster::resize::{Region, fit, resample, resample_image};
use crate::raster::{Image, Matte, Plane};
use crate::style::context::scale_of;

/// Maximum side of the copy for edge detection, in pixels. Finer detail is interpolated.
const LONGEST: usize = 1600;

/// The mask at a size, with the edges of the photo. `photo` may be a smaller copy.
#[must_use]
pub fn full_mask(mask: &Matte, photo: &Image, (width, height): (usize, usize)) -> Plane {
    let whole = |plane: &Plane| Region::whole(plane.width(), plane.height());
    let (w, h) = fit(photo.width(), photo.height(), LONGEST);
    let guide = resample_image(photo, Region::whole(photo.width(), photo.height()), w, h);
    let shares = mask.plane();
    let refined = refined(&shares, whole(&shares), &guide, scale_of((w * h) as f64));
    resample(&refined, whole(&refined), width, height)
}

/// The subject as a PNG with alpha, of the photo's size.
///
/// # Errors
/// `encode`.
pub fn cut_out(photo: &Image, mask: &Matte) -> Result<Vec<u8>> {
    let alpha = full_mask(mask, photo, (photo.width(), photo.height()));
    let mut rgba = photo.to_rgba();
    for (pixel, alpha) in rgba.chunks_exact_mut(4).zip(alpha.samples()) {
        pixel[3] = *alpha;
    }
    png::encode_rgba(photo.width(), photo.height(), &rgba)
}
