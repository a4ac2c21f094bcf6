//! The guided filter: a mask takes the edges of the picture that it belongs to.
//!
//! In every window the mask is fitted by a straight line of the guide's luma; what each pixel gets is the mean of the lines of
//! all windows that hold it. Windows end at the picture's edge.
//!
//! Source: He, Sun and Tang, "Guided Image Filtering", 2013.

use super::resize::{Region, resample};
use super::{Image, Plane};
use crate::simd::point::luma_plane;

/// Radius of a window in pixels of a 1920 x 1080 picture.
const RADIUS: f32 = 8.0;
/// How much of the guide's variance counts as noise, for luma of 0 to 1.
const EPSILON: f32 = 1e-4;

/// A region of a small mask at the size of `guide`, the picture of the same region, with its edges. `scale` is that of
/// lengths: 1 for a picture of 1920 x 1080.
#[must_use]
pub fn refined(mask: &Plane, region: Region, guide: &Image, scale: f32) -> Plane {
    let (width, height) = (guide.width(), guide.height());
    let radius = (RADIUS * scale).round().max(1.0) as usize;
    guided(&luma_plane(guide), &resample(mask, region, width, height), radius, EPSILON)
}

/// The mean of the window of each pixel of a mask.
#[must_use]
pub fn softened(mask: &Plane, radius: usize) -> Plane {
    let shares: Vec<f32> = mask.samples().iter().map(|sample| f32::from(*sample)).collect();
    let mut out = mask.clone();
    let soft = means(&shares, (mask.width(), mask.height()), radius);
    out.samples_mut().iter_mut().zip(soft).for_each(|(sample, mean)| *sample = (mean + 0.5) as u8);
    out
}

/// `mask` filtered by `guide`, which is of the same size.
#[must_use]
pub fn guided(guide: &Plane, mask: &Plane, radius: usize, epsilon: f32) -> Plane {
    let (width, height) = (guide.width(), guide.height());
    let share = |sample: &u8| f32::from(*sample) / 255.0;
    let luma: Vec<f32> = guide.samples().iter().map(share).collect();
    let shares: Vec<f32> = mask.samples().iter().map(share).collect();
    let mean = |values: &[f32]| means(values, (width, height), radius);
    let product = |a: &[f32], b: &[f32]| -> Vec<f32> { a.iter().zip(b).map(|(a, b)| a * b).collect() };
    let (mut slopes, mut starts) = (mean(&product(&luma, &shares)), mean(&shares));
    let (squares, lumas) = (mean(&product(&luma, &luma)), mean(&luma));
    for (((slope, start), square), luma) in slopes.iter_mut().zip(&mut starts).zip(&squares).zip(&lumas) {
        *slope = (*slope - luma * *start) / (square - luma * luma + epsilon);
        *start -= *slope * luma;
    }
    let (slopes, starts) = (mean(&slopes), mean(&starts));
    let mut out = mask.clone();
    for (((sample, slope), start), luma) in out.samples_mut().iter_mut().zip(&slopes).zip(&starts).zip(&luma)
    {
        *sample = ((slope * luma + start) * 255.0 + 0.5) as u8;
    }
    out
}

/// The mean of each pixel's window, which is square and cut off at the edges.
fn means(values: &[f32], (width, height): (usize, usize), radius: usize) -> Vec<f32> {
    let mut out = vec![0.0; values.len()];
    // Sums of columns over the rows of the window.
    let mut columns = vec![0.0f64; width];
    let row = |y: usize| &values[y * width..(y + 1) * width];
    let reach = |at: usize, length: usize| (at.saturating_sub(radius), (at + radius + 1).min(length));
    let mut held = 0..0;
    for (y, out) in out.chunks_exact_mut(width).enumerate() {
        let (top, bottom) = reach(y, height);
        for y in held.end..bottom {
            columns.iter_mut().zip(row(y)).for_each(|(sum, value)| *sum += f64::from(*value));
        }
        for y in held.start..top {
            columns.iter_mut().zip(row(y)).for_each(|(sum, value)| *sum -= f64::from(*value));
        }
        held = top..bottom;
        let mut sum = 0.0;
        let mut inside = 0..0;
        for (x, out) in out.iter_mut().enumerate() {
            let (left, right) = reach(x, width);
            columns[inside.end..right].iter().for_each(|column| sum += column);
            columns[inside.start..left].iter().for_each(|column| sum -= column);
            inside = left..right;
            *out = (sum / ((bottom - top) * (right - left)) as f64) as f32;
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_are_cut_off_at_the_edges() {
        let values: Vec<f32> = (0..35).map(|i| ((i * 7919) % 23) as f32).collect();
        let (width, height, radius) = (7, 5, 2);
        let got = means(&values, (width, height), radius);
        for y in 0..height {
            for x in 0..width {
                let within = |at: usize, middle: usize| at.abs_diff(middle) <= radius;
                let window: Vec<f32> = (0..values.len())
                    .filter(|i| within(i % width, x) && within(i / width, y))
                    .map(|i| values[i])
                    .collect();
                let mean = window.iter().sum::<f32>() / window.len() as f32;
                assert!((got[y * width + x] - mean).abs() < 1e-4);
            }
        }
    }

    #[test]
    fn a_soft_mask_takes_the_guides_edge() {
        // A black thing on white, of which the mask knows only about where it ends.
        let guide = Plane::from_fn(80, 40, |x, _| if x < 43 { 20 } else { 230 });
        let mask = Plane::from_fn(80, 40, |x, _| (255.0 * ((46.0 - x as f32) / 8.0).clamp(0.0, 1.0)) as u8);
        let refined = guided(&guide, &mask, 8, EPSILON);
        assert!(refined.at(42, 20) > 170 && refined.at(43, 20) < 85, "{:?}", &refined.row(20)[36..50]);
        assert_eq!((refined.at(5, 20), refined.at(75, 20)), (255, 0));
    }

    #[test]
    fn any_size_is_filtered() {
        for (width, height) in [(1, 1), (1, 50), (50, 1), (3, 2)] {
            let plane = Plane::from_fn(width, height, |x, y| (x * 40 + y * 90) as u8);
            let filtered = guided(&plane, &plane, 8, EPSILON);
            assert_eq!((filtered.width(), filtered.height()), (width, height));
        }
    }
}
