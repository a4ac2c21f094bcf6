//! Removes the grain of photos that are enlarged: the noise of old scans and strong compression. Filters would draw it as
//! lines and spots.

use super::guided::guided;
use super::{Image, Plane};
use crate::simd::point::luma_plane;

/// Radius of a window, in pixels of the photo.
const RADIUS: usize = 2;
/// Variance that counts as grain, in variances of the noise, and its maximum for luma of 0 to 1: 14 grey levels.
const VARIANCE: (f32, f32) = (6.0, 0.003);
/// Noise of a photo without visible grain, as a standard deviation in grey levels.
const CLEAN: f32 = 1.5;
/// Side of the squares whose noise is measured, in pixels, and the part of them that counts as flat.
const SQUARE: usize = 8;
const FLAT: usize = 8;

/// A photo with less grain and with its edges. A photo without noise does not change. `amount`: from 0 for the same pixels
/// to 1.
///
/// Source: the guided filter, with the photo's own luma as the guide.
#[must_use]
pub fn without_grain(photo: &Image, amount: f32) -> Image {
    let luma = luma_plane(photo);
    let noise = (noise(&luma) - CLEAN).max(0.0) / 255.0;
    let epsilon = (VARIANCE.0 * noise * noise).min(VARIANCE.1);
    let mut clean = photo.clone();
    if epsilon <= 0.0 {
        return clean;
    }
    for plane in clean.planes_mut() {
        let smooth = guided(&luma, plane, RADIUS, epsilon);
        mix(plane, &smooth, amount);
    }
    clean
}

/// The standard deviation of the noise in the flattest squares, in grey levels. Black and white squares do not count,
/// because their noise is cut off.
///
/// Source: Immerkaer, "Fast Noise Variance Estimation", 1996.
fn noise(luma: &Plane) -> f32 {
    let (width, height) = (luma.width(), luma.height());
    let at = |x: usize, y: usize| i32::from(luma.at(x, y));
    let response = |x: usize, y: usize| {
        let corners = at(x - 1, y - 1) + at(x + 1, y - 1) + at(x - 1, y + 1) + at(x + 1, y + 1);
        let sides = at(x, y - 1) + at(x - 1, y) + at(x + 1, y) + at(x, y + 1);
        (corners - 2 * sides + 4 * at(x, y)).unsigned_abs()
    };
    let mut squares: Vec<u32> = Vec::new();
    for top in (1..height.saturating_sub(SQUARE)).step_by(SQUARE) {
        for left in (1..width.saturating_sub(SQUARE)).step_by(SQUARE) {
            let pixels = || (top..top + SQUARE).flat_map(|y| (left..left + SQUARE).map(move |x| (x, y)));
            let mean = pixels().map(|(x, y)| at(x, y)).sum::<i32>() / (SQUARE * SQUARE) as i32;
            if (16..240).contains(&mean) {
                squares.push(pixels().map(|(x, y)| response(x, y)).sum());
            }
        }
    }
    squares.sort_unstable();
    let flat = squares.get(squares.len() / FLAT).copied().unwrap_or(0);
    flat as f32 / (SQUARE * SQUARE) as f32 * std::f32::consts::FRAC_PI_2.sqrt() / 6.0
}

/// Moves samples toward the samples of another plane.
fn mix(plane: &mut Plane, other: &Plane, amount: f32) {
    for (sample, &other) in plane.samples_mut().iter_mut().zip(other.samples()) {
        let from = f32::from(*sample);
        *sample = (from + amount * (f32::from(other) - from)).round() as u8;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two areas with noise of `levels` grey levels.
    fn photo(levels: usize) -> Image {
        let mut random = oorandom::Rand32::new(7);
        let mut samples = Vec::new();
        for i in 0..120 * 80 {
            let tone = if i % 120 < 60 { 60 } else { 180 };
            samples.push(tone + random.rand_range(0..levels as u32 + 1) as u8);
        }
        let plane = Plane::from_fn(120, 80, |x, y| samples[y * 120 + x]);
        Image::from_rgb([plane.clone(), plane.clone(), plane]).unwrap()
    }

    #[test]
    fn grain_goes_and_edges_stay() {
        let photo = photo(20);
        let clean = without_grain(&photo, 1.0);
        let spread = |image: &Image| {
            let row = &image.planes()[0].row(40)[5..50];
            row.iter().max().unwrap() - row.iter().min().unwrap()
        };
        assert!(spread(&photo) >= 18 && spread(&clean) <= 12, "{} {}", spread(&photo), spread(&clean));
        let row = clean.planes()[1].row(40);
        assert!(row[61] - row[58] > 90, "{:?}", &row[54..66]);
        assert!(without_grain(&photo, 0.0) == photo);
    }

    #[test]
    fn noise_is_measured_and_a_clean_photo_stays() {
        // An even distribution over 21 levels has a standard deviation of 6.06.
        assert!((noise(&luma_plane(&photo(20))) - 6.06).abs() < 1.0, "{}", noise(&luma_plane(&photo(20))));
        let clean = photo(2);
        assert!(without_grain(&clean, 1.0) == clean);
        let small = Image::from_luma(Plane::from_fn(5, 3, |x, y| (40 * x + y) as u8));
        assert!(without_grain(&small, 1.0) == small);
    }
}
