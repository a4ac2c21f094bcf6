//! Photos made larger than they are with more of their edges than interpolation leaves.
//!
//! ```text
//! large = interpolated(small)
//! three times: large += interpolated(small - reduced(large)), no further than what is around reaches
//! ```
//!
//! An enlarged photo, reduced again, should equal the photo. The difference is added to the enlarged photo.
//! This restores steep edges and leaves flat parts unchanged. No sample leaves the values of the nine pixels
//! around it by more than a little, so that edges get no halos.
//!
//! Source: Irani and Peleg, "Improving resolution by image registration" (1991), its back-projection, for a single picture.
//! `tests/oracles/enlarge.py` compares it with the interpolations of other libraries.

use super::resize::{Region, resample, resample_image};
use super::{Image, Plane};

/// How often what is lacking is laid on; more gains nothing.
const ROUNDS: usize = 3;
/// How far a sample may go beyond the pixels around it.
const BEYOND: u8 = 6;
/// Nothing is lacking.
const NOTHING: i32 = 128;

/// Enlarges a region of a photo to `width` x `height`, if that is larger than the region.
#[must_use]
pub fn enlarged(photo: &Image, region: Region, width: usize, height: usize) -> Image {
    let whole = |length: f64| (length.round() as usize).max(1);
    let small = resample_image(photo, region, whole(region.width), whole(region.height));
    let mut large = resample_image(photo, region, width, height);
    for (large, small) in large.planes_mut().iter_mut().zip(small.planes()) {
        let bounds = bounds(small);
        for _ in 0..ROUNDS {
            lay_on(large, small, &bounds);
        }
    }
    large
}

/// Minimum and maximum allowed value of each pixel.
fn bounds(small: &Plane) -> Vec<(u8, u8)> {
    let (width, height) = (small.width(), small.height());
    let mut bounds = Vec::with_capacity(width * height);
    for y in 0..height {
        for x in 0..width {
            let (mut least, mut most) = (255, 0);
            for row in y.saturating_sub(1)..(y + 2).min(height) {
                for &sample in &small.row(row)[x.saturating_sub(1)..(x + 2).min(width)] {
                    (least, most) = (sample.min(least), sample.max(most));
                }
            }
            bounds.push((least.saturating_sub(BEYOND), most.saturating_add(BEYOND)));
        }
    }
    bounds
}

/// Lays on an enlarged plane what it lacks, when it is reduced again, of the small one.
fn lay_on(large: &mut Plane, small: &Plane, bounds: &[(u8, u8)]) {
    let (width, height) = (large.width(), large.height());
    let mut lacks = resample(large, Region::whole(width, height), small.width(), small.height());
    for (lack, &wanted) in lacks.samples_mut().iter_mut().zip(small.samples()) {
        *lack = (NOTHING + i32::from(wanted) - i32::from(*lack)).clamp(0, 255) as u8;
    }
    let more = resample(&lacks, Region::whole(small.width(), small.height()), width, height);
    for (i, (sample, &more)) in large.samples_mut().iter_mut().zip(more.samples()).enumerate() {
        let (x, y) = (i % width * small.width() / width, i / width * small.height() / height);
        let (least, most) = bounds[y * small.width() + x];
        let laid = i32::from(*sample) + i32::from(more) - NOTHING;
        *sample = laid.clamp(i32::from(least), i32::from(most)) as u8;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(width: usize, height: usize, value: impl Fn(usize, usize) -> u8) -> Image {
        let mut plane = Plane::filled(width, height, 0);
        for (i, sample) in plane.samples_mut().iter_mut().enumerate() {
            *sample = value(i % width, i / width);
        }
        Image::from_luma(plane)
    }

    #[test]
    fn an_enlarged_photo_is_the_photo_when_it_is_reduced_again() {
        let photo = image(31, 23, |x, y| ((x * x * 7 + y * 13 + (x / 5) * 90) % 256) as u8);
        let whole = Region::whole(31, 23);
        let off = |large: &Image| {
            let back = resample(&large.planes()[0], Region::whole(93, 69), 31, 23);
            let pairs = back.samples().iter().zip(photo.planes()[0].samples());
            pairs.map(|(a, b)| f64::from(a.abs_diff(*b)).powi(2)).sum::<f64>()
        };
        let plain = off(&resample_image(&photo, whole, 93, 69));
        let well = off(&enlarged(&photo, whole, 93, 69));
        assert!(well < 0.3 * plain, "{well} {plain}");
    }

    #[test]
    fn what_is_flat_stays_and_any_size_is_made() {
        let flat = image(9, 7, |_, _| 77);
        for (width, height) in [(1, 1), (9, 7), (20, 40), (64, 3)] {
            let region = Region { x: 1.5, y: 0.25, width: 4.2, height: 3.3 };
            let made = enlarged(&flat, region, width, height);
            assert_eq!((made.width(), made.height()), (width, height));
            assert!(made.planes()[0].samples().iter().all(|&sample| sample == 77));
        }
    }
}
