//! How sharp a photo is, in three measures; higher is sharper.

use crate::raster::Plane;
use crate::raster::resize::{Region, fit, resample};

/// Gradients are computed for every third pixel in each direction, as in the paper.
const SUBSAMPLING: usize = 3;
/// Long side at which [`laplacian`] is measured, in pixels.
const LAPLACIAN_SIDE: usize = 640;
/// Bins of the paper's histogram: one a grey step.
const BINS: usize = 256;

/// Sharpness of near-duplicates, for ranking: the mean gradient over the spread of tones, `mean |grad Y| /
/// (std Y + 1)`, for the photo at a length of 1000 pixels.
///
/// A gradient in grey steps per pixel grows if a photo is reduced. A gradient per thousandth of the photo
/// does not, so a small copy never ranks sharper than its original.
#[must_use]
pub fn gradient(luma: &Plane) -> f32 {
    let (mut sum, mut count) = (0.0, 0u32);
    for_each_gradient(luma, |magnitude| {
        sum += f64::from(magnitude);
        count += 1;
    });
    let scale = luma.width().max(luma.height()) as f64 / 1000.0;
    (sum / f64::from(count.max(1)) * scale / (standard_deviation(luma) + 1.0)) as f32
}

/// The paper's measure, read as printed: with a histogram `h` of the gradient's magnitude that is normalised to
/// a mean of 1, the mean over the spread comes to `#bins / sum (h_i - 1)^2`.
#[must_use]
pub fn paper(luma: &Plane) -> f32 {
    let (mut histogram, mut count) = ([0u32; BINS], 0u32);
    for_each_gradient(luma, |magnitude| {
        histogram[(magnitude.round() as usize).min(BINS - 1)] += 1;
        count += 1;
    });
    let mean = f64::from(count.max(1)) / BINS as f64;
    let spread: f64 = histogram.iter().map(|&n| (f64::from(n) / mean - 1.0).powi(2)).sum();
    (BINS as f64 / spread.max(1e-9)) as f32
}

/// The measure to find blurred photos in an album: the variance of the Laplacian (of four neighbours, on
/// replicated borders) at a long side of 640 pixels.
#[must_use]
pub fn laplacian(luma: &Plane) -> f32 {
    let (width, height) = fit(luma.width(), luma.height(), LAPLACIAN_SIDE);
    let small = resample(luma, Region::whole(luma.width(), luma.height()), width, height);
    let (mut sum, mut squares) = (0i64, 0i64);
    for y in 0..height {
        let (above, row, below) =
            (small.row(y.saturating_sub(1)), small.row(y), small.row((y + 1).min(height - 1)));
        for x in 0..width {
            let (left, right) = (row[x.saturating_sub(1)], row[(x + 1).min(width - 1)]);
            let neighbours = i64::from(left) + i64::from(right) + i64::from(above[x]) + i64::from(below[x]);
            let value = neighbours - 4 * i64::from(row[x]);
            sum += value;
            squares += value * value;
        }
    }
    let count = (width * height) as f64;
    let mean = sum as f64 / count;
    (squares as f64 / count - mean * mean) as f32
}

/// The length of the central-difference gradient, in grey steps a pixel, at pixels 1, 4, 7... of each axis.
fn for_each_gradient(luma: &Plane, mut each: impl FnMut(f32)) {
    let (width, height) = (luma.width(), luma.height());
    for y in (1..height.saturating_sub(1)).step_by(SUBSAMPLING) {
        let (above, row, below) = (luma.row(y - 1), luma.row(y), luma.row(y + 1));
        for x in (1..width.saturating_sub(1)).step_by(SUBSAMPLING) {
            let across = f32::from(row[x + 1]) - f32::from(row[x - 1]);
            let down = f32::from(below[x]) - f32::from(above[x]);
            each(0.5 * across.hypot(down));
        }
    }
}

fn standard_deviation(luma: &Plane) -> f64 {
    let (mut sum, mut squares) = (0u64, 0u64);
    for row in luma.samples().chunks(luma.width()) {
        sum += row.iter().map(|&v| u64::from(v)).sum::<u64>();
        squares += row.iter().map(|&v| u64::from(u32::from(v) * u32::from(v))).sum::<u64>();
    }
    let count = luma.samples().len() as f64;
    let mean = sum as f64 / count;
    (squares as f64 / count - mean * mean).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::decode::{Limits, decode_fit};
    use crate::simd::point::luma_plane;

    fn photo() -> Plane {
        let bytes = include_bytes!("../../../../tests/photos/raccoon.jpg");
        luma_plane(&decode_fit(bytes, &Limits::default(), 400).unwrap().image)
    }

    /// Each pixel the mean of its neighbourhood.
    fn blurred(plane: &Plane, radius: usize) -> Plane {
        let (w, h) = (plane.width(), plane.height());
        Plane::from_fn(w, h, |x, y| {
            let (mut sum, mut count) = (0u32, 0);
            for v in y.saturating_sub(radius)..(y + radius + 1).min(h) {
                for u in x.saturating_sub(radius)..(x + radius + 1).min(w) {
                    sum += u32::from(plane.at(u, v));
                    count += 1;
                }
            }
            (sum / count) as u8
        })
    }

    #[test]
    fn every_measure_falls_as_blur_grows() {
        let mut last = [f32::MAX; 3];
        for radius in 0..5 {
            let plane = blurred(&photo(), radius);
            let now = [gradient(&plane), paper(&plane), laplacian(&plane)];
            for (now, last) in now.iter().zip(last) {
                assert!(*now < last, "radius {radius}: {now} after {last}");
            }
            last = now;
        }
    }

    #[test]
    fn a_smaller_copy_is_not_sharper() {
        let sharp = Plane::from_fn(900, 600, |x, y| if (x / 60 + y / 60) % 2 == 0 { 40 } else { 220 });
        let small = resample(&sharp, Region::whole(900, 600), 450, 300);
        assert!(gradient(&small) <= gradient(&sharp) * 1.01);
    }

    #[test]
    fn tiny_and_flat_planes_are_measured() {
        for plane in [Plane::filled(1, 1, 9), Plane::filled(2, 50, 9), Plane::filled(100, 100, 9)] {
            assert_eq!((gradient(&plane), laplacian(&plane)), (0.0, 0.0));
            assert!(paper(&plane).is_finite());
        }
    }
}
