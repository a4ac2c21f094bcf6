//! Removes the grain of photos that are enlarged: the noise of old scans and strong compression. Filters would draw it as
//! lines and spots.

use super::guided::guided;
use super::{Image, Plane};
use crate::simd::point::luma_plane;

/// Radius of a window, in pixels of the photo.
const RADIUS: usize = 2;
/// Variance of luma that counts as grain, for luma of 0 to 1: about 14 grey levels.
const EPSILON: f32 = 0.003;

/// A photo with less grain and with its edges. `amount`: from 0 for the same pixels to 1.
///
/// Source: the guided filter, with the photo's own luma as the guide.
#[must_use]
pub fn without_grain(photo: &Image, amount: f32) -> Image {
    let luma = luma_plane(photo);
    let mut clean = photo.clone();
    for plane in clean.planes_mut() {
        let smooth = guided(&luma, plane, RADIUS, EPSILON);
        mix(plane, &smooth, amount);
    }
    clean
}

/// Moves samples toward those of another plane.
fn mix(plane: &mut Plane, other: &Plane, amount: f32) {
    for (sample, &other) in plane.samples_mut().iter_mut().zip(other.samples()) {
        let from = f32::from(*sample);
        *sample = (from + amount * (f32::from(other) - from)).round() as u8;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grain_goes_and_edges_stay() {
        let noise = |x: usize, y: usize| (x * 7919 + y * 104_729) % 17;
        let tone = |x: usize, y: usize| if x < 30 { 60 + noise(x, y) as u8 } else { 180 + noise(x, y) as u8 };
        let photo = Image::from_rgb([0, 1, 2].map(|_| Plane::from_fn(60, 40, tone))).unwrap();
        let clean = without_grain(&photo, 1.0);
        let spread = |image: &Image| {
            let row = &image.planes()[0].row(20)[5..25];
            row.iter().max().unwrap() - row.iter().min().unwrap()
        };
        assert!(spread(&photo) >= 14 && spread(&clean) <= 6, "{} {}", spread(&photo), spread(&clean));
        let row = clean.planes()[1].row(20);
        assert!(row[31] - row[28] > 90, "{:?}", &row[24..36]);
        assert!(without_grain(&photo, 0.0) == photo);
    }
}
