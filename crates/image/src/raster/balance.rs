//! White balance: photos of one page get one white point, so that panels in daylight and lamplight fit together.
//!
//! The light of a photo is estimated by shades of gray: the fourth norm of each channel over a grid of pixels. Only a part of the
//! difference to gray is corrected, up to a limit: a sunset stays warm.
//!
//! Source: Finlayson and Trezzi, "Shades of gray and colour constancy", 2004.

use super::Image;
use crate::simd::point::luma_plane;
use crate::simd::table::Table;

/// Pixels of the grid on the longer side, at most.
const GRID: usize = 96;
/// Tones that say something about the light: darker ones are noise, brighter ones are clipped.
const SEEN: (u8, u8) = (16, 250);
/// Part of the difference that is corrected.
const PART: f64 = 0.6;
/// Strongest correction of a channel, as a factor.
const MOST: f64 = 1.16;

/// Factors of R, G and B that bring the light of a photo nearer to gray.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Balance([f64; 3]);

impl Balance {
    /// Estimates the light of a photo. `None` for gray photos and photos that need no correction.
    #[must_use]
    pub fn of(photo: &Image) -> Option<Self> {
        let [r, g, b] = photo.planes() else { return None };
        let step = photo.width().max(photo.height()).div_ceil(GRID).max(1);
        let (mut sums, mut count) = ([0.0_f64; 3], 0_u32);
        for y in (step / 2..photo.height()).step_by(step) {
            for x in (step / 2..photo.width()).step_by(step) {
                let rgb = [r, g, b].map(|plane| plane.at(x, y));
                if rgb.iter().any(|tone| *tone > SEEN.1) || rgb.iter().all(|tone| *tone < SEEN.0) {
                    continue;
                }
                for (sum, tone) in sums.iter_mut().zip(rgb) {
                    let square = f64::from(tone) * f64::from(tone);
                    *sum += square * square;
                }
                count += 1;
            }
        }
        if count == 0 || sums.iter().any(|sum| *sum <= 0.0) {
            return None;
        }
        // The fourth root by roots that every platform rounds alike.
        let light = sums.map(|sum| (sum / f64::from(count)).sqrt().sqrt());
        let gray = (light[0] + light[1] + light[2]) / 3.0;
        let factors = light.map(|own| (1.0 + PART * (gray / own - 1.0)).clamp(1.0 / MOST, MOST));
        // The photo is as bright as before.
        let luma = 0.299 * factors[0] + 0.587 * factors[1] + 0.114 * factors[2];
        // Steps that no rounding on another platform can cross unseen.
        let factors = factors.map(|factor| (factor / luma * 256.0).round() / 256.0);
        (factors.iter().any(|factor| (factor - 1.0).abs() > 0.01)).then_some(Self(factors))
    }

    /// Corrects a picture of the photo, such as a crop.
    pub fn apply(self, picture: &mut Image) {
        if picture.is_luma() {
            return;
        }
        for (plane, factor) in picture.planes_mut().iter_mut().zip(self.0) {
            Table::from_fn(|tone| tone * factor as f32).apply(plane.samples_mut());
        }
    }
}

/// Mean distance of the largest to the smallest channel below which a photo is gray.
const GRAY: f64 = 7.0;
/// Shift of R, G and B in the middle tones of a toned picture, in grey levels. Its luma stays.
const TONE: [f32; 3] = [26.0, -2.0, -42.0];

/// Whether a photo has no colours.
#[must_use]
pub fn is_gray(photo: &Image) -> bool {
    let [r, g, b] = photo.planes() else { return true };
    let step = photo.width().max(photo.height()).div_ceil(GRID).max(1);
    let (mut sum, mut count) = (0.0, 0_u32);
    for y in (step / 2..photo.height()).step_by(step) {
        for x in (step / 2..photo.width()).step_by(step) {
            let rgb = [r, g, b].map(|plane| plane.at(x, y));
            let (least, most) = rgb.iter().fold((255, 0), |(l, m), v| (*v.min(&l), *v.max(&m)));
            sum += f64::from(most - least);
            count += 1;
        }
    }
    sum < GRAY * f64::from(count)
}

/// A gray picture in the warm tone of an old print.
#[must_use]
pub fn toned(picture: Image) -> Image {
    let luma = luma_plane(&picture);
    let toned = TONE.map(|shift| {
        let mut plane = luma.clone();
        Table::from_fn(|tone| {
            let part = tone / 255.0;
            tone + shift * 4.0 * part * (1.0 - part)
        })
        .apply(plane.samples_mut());
        plane
    });
    // The three planes have one size, so this cannot fail.
    Image::from_rgb(toned).unwrap_or(picture)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Plane;

    /// Gray with texture, under a light.
    fn photo(light: [f64; 3]) -> Image {
        let tone = |x: usize, y: usize| 40.0 + ((x * 7 + y * 11) % 120) as f64;
        Image::from_rgb(light.map(|part| Plane::from_fn(120, 90, |x, y| (tone(x, y) * part) as u8))).unwrap()
    }

    /// Mean of red over mean of blue.
    fn warmth(image: &Image) -> f64 {
        let sum = |c: usize| image.planes()[c].samples().iter().map(|v| f64::from(*v)).sum::<f64>();
        sum(0) / sum(2)
    }

    #[test]
    fn lamplight_and_shade_come_nearer_to_each_other() {
        let balanced = |light| {
            let mut image = photo(light);
            if let Some(balance) = Balance::of(&image) {
                balance.apply(&mut image);
            }
            warmth(&image)
        };
        let (warm, cold) = ([1.2, 1.0, 0.85], [0.9, 1.0, 1.15]);
        let before = warmth(&photo(warm)) / warmth(&photo(cold));
        let after = balanced(warm) / balanced(cold);
        assert!(before > 1.7 && after < 1.0 + 0.55 * (before - 1.0), "{before} {after}");
        assert!(Balance::of(&photo([1.0; 3])).is_none());
    }

    #[test]
    fn a_sunset_stays_warm_and_as_bright() {
        let mut image = photo([1.5, 0.8, 0.4]);
        let luma = |image: &Image| {
            let sum = |c: usize| image.planes()[c].samples().iter().map(|v| f64::from(*v)).sum::<f64>();
            0.299 * sum(0) + 0.587 * sum(1) + 0.114 * sum(2)
        };
        let before = luma(&image);
        Balance::of(&image).unwrap().apply(&mut image);
        assert!(warmth(&image) > 2.2);
        assert!((luma(&image) / before - 1.0).abs() < 0.06);
    }

    #[test]
    fn a_toned_gray_picture_is_warm_and_as_bright() {
        let gray = photo([1.0; 3]);
        assert!(is_gray(&gray) && !is_gray(&photo([1.3, 1.0, 0.8])));
        let warm = toned(gray.clone());
        assert!(warmth(&warm) > 1.3, "{}", warmth(&warm));
        let (before, after) = (luma_plane(&gray), luma_plane(&warm));
        let off = before.samples().iter().zip(after.samples()).map(|(a, b)| a.abs_diff(*b)).max();
        assert!(off <= Some(3), "{off:?}");
    }

    #[test]
    fn gray_photos_stay() {
        assert!(Balance::of(&Image::from_luma(Plane::filled(20, 20, 90))).is_none());
    }
}
