//! White balance: photos of one page get one white point, so that panels in daylight and lamplight fit together.
//!
//! The light of a photo is estimated by shades of gray: the fourth norm of each channel over a grid of pixels. Only a part of the
//! difference to gray is corrected, up to a limit: a sunset stays warm. A coloured wall is not light, so a correction that
//! makes skin less natural is reduced.
//!
//! Sources: Finlayson and Trezzi, "Shades of gray and colour constancy", 2004; Bianco and Schettini, "Adaptive color
//! constancy using faces", 2014.

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

/// Difference of red and green over their mean in natural skin, from pale to dark. The difference of green and blue, relative to it.
const SKIN: (f64, f64) = (0.12, 0.42);
const SKIN_BLUE: f64 = 0.67;
/// Weight of green over blue, which lamplight changes most and the eye forgives.
const BLUE_WEIGHT: f64 = 0.5;
/// Parts of a correction that are tried on skin, the largest first, and the distance from natural skin that always passes.
const TRIED: [f64; 4] = [1.0, 0.75, 0.5, 0.25];
const NATURAL: f64 = 0.06;
/// Range of both differences for the colour of skin in any light.
const SKIN_IN_LIGHT: (f64, f64) = (0.03, 0.65);
/// Part of the sides of a face in which its colour is measured: cheeks and nose. Samples on each side.
const CHEEKS: f64 = 0.5;
const SAMPLES: usize = 12;
/// Luma below which skin has no reliable colour, in grey levels.
const DARK: f64 = 36.0;

/// Factors of R, G and B that bring the light of a photo nearer to gray.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Balance([f64; 3]);

impl Balance {
    /// Estimates the light of a photo. `None` for gray photos and photos that need no correction. `faces`: left edge, top
    /// edge, width and height in parts of the photo.
    #[must_use]
    pub fn of(photo: &Image, faces: &[[f64; 4]]) -> Option<Self> {
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
        let all = light.map(|own| (1.0 + PART * (gray / own - 1.0)).clamp(1.0 / MOST, MOST));
        let part = skin_of(photo, faces).map_or(1.0, |skin| part_for(skin, all));
        let factors = all.map(|factor| 1.0 + part * (factor - 1.0));
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

/// The mean colour of the faces of a photo with colours. `None` without faces in light, and if the colour is not skin.
fn skin_of(photo: &Image, faces: &[[f64; 4]]) -> Option<[f64; 3]> {
    let (width, height) = (photo.width(), photo.height());
    let at = |start: f64, length: f64, sample: usize, side: usize| {
        let inner = (1.0 - CHEEKS) / 2.0 + CHEEKS * (sample as f64 + 0.5) / SAMPLES as f64;
        let place = (start + inner * length) * side as f64;
        (place >= 0.0 && place < side as f64).then_some(place as usize)
    };
    let (mut sums, mut count) = ([0.0_f64; 3], 0.0_f64);
    for [x, y, face_width, face_height] in faces {
        for row in (0..SAMPLES).filter_map(|sample| at(*y, *face_height, sample, height)) {
            for column in (0..SAMPLES).filter_map(|sample| at(*x, *face_width, sample, width)) {
                for (sum, plane) in sums.iter_mut().zip(photo.planes()) {
                    *sum += f64::from(plane.at(column, row));
                }
                count += 1.0;
            }
        }
    }
    let mean = sums.map(|sum| sum / count.max(1.0));
    let (red, blue) = differences(mean);
    let in_light = 0.299 * mean[0] + 0.587 * mean[1] + 0.114 * mean[2] >= DARK;
    let skin = |value: f64| value >= SKIN_IN_LIGHT.0 && value <= SKIN_IN_LIGHT.1;
    (in_light && skin(red) && skin(blue)).then_some(mean)
}

/// The differences of red and green, and of green and blue, over their means.
fn differences([r, g, b]: [f64; 3]) -> (f64, f64) {
    (2.0 * (r - g) / (r + g).max(1.0), 2.0 * (g - b) / (g + b).max(1.0))
}

/// The largest part of a correction that keeps skin natural. Skin in coloured light does not become less natural.
fn part_for(skin: [f64; 3], factors: [f64; 3]) -> f64 {
    let distance = |part: f64| {
        let (red, blue) = differences([0, 1, 2].map(|i| skin[i] * (1.0 + part * (factors[i] - 1.0))));
        let off = (SKIN.0 - red).max(red - SKIN.1).max(0.0);
        off + BLUE_WEIGHT * (blue - SKIN_BLUE * red.clamp(SKIN.0, SKIN.1)).abs()
    };
    let now = distance(0.0).max(NATURAL);
    TRIED.into_iter().find(|part| distance(*part) <= now).unwrap_or(0.0)
}

/// Mean distance of the largest to the smallest channel below which a photo is gray.
pub const GRAY: u8 = 7;
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
    sum < f64::from(GRAY) * f64::from(count)
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
            if let Some(balance) = Balance::of(&image, &[]) {
                balance.apply(&mut image);
            }
            warmth(&image)
        };
        let (warm, cold) = ([1.2, 1.0, 0.85], [0.9, 1.0, 1.15]);
        let before = warmth(&photo(warm)) / warmth(&photo(cold));
        let after = balanced(warm) / balanced(cold);
        assert!(before > 1.7 && after < 1.0 + 0.55 * (before - 1.0), "{before} {after}");
        assert!(Balance::of(&photo([1.0; 3]), &[]).is_none());
    }

    #[test]
    fn a_coloured_wall_does_not_change_skin() {
        // Natural skin in front of a wall.
        let face = [0.4, 0.3, 0.2, 0.3];
        let seen = |wall: [u8; 3], skin: [u8; 3]| {
            let plane = |i: usize| {
                Plane::from_fn(100, 100, |x, y| {
                    if (40..60).contains(&x) && (30..60).contains(&y) { skin[i] } else { wall[i] }
                })
            };
            let mut image = Image::from_rgb([plane(0), plane(1), plane(2)]).unwrap();
            if let Some(balance) = Balance::of(&image, &[face]) {
                balance.apply(&mut image);
            }
            [0, 1, 2].map(|i: usize| image.planes()[i].at(50, 45))
        };
        let skin = [205, 160, 136];
        let near = |a: [u8; 3], b: [u8; 3]| a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 12);
        for wall in [[60, 70, 190], [190, 40, 30], [50, 150, 60]] {
            let drawn = seen(wall, skin);
            assert!(near(drawn, skin), "{wall:?} {drawn:?}");
        }
        // Lamplight falls on the wall and on the skin, so it is corrected.
        let [r, _, b] = seen([220, 180, 120], [235, 160, 95]);
        assert!(f64::from(r) / f64::from(b) < 0.85 * 235.0 / 95.0, "{r} {b}");
    }

    #[test]
    fn a_sunset_stays_warm_and_as_bright() {
        let mut image = photo([1.5, 0.8, 0.4]);
        let luma = |image: &Image| {
            let sum = |c: usize| image.planes()[c].samples().iter().map(|v| f64::from(*v)).sum::<f64>();
            0.299 * sum(0) + 0.587 * sum(1) + 0.114 * sum(2)
        };
        let before = luma(&image);
        Balance::of(&image, &[]).unwrap().apply(&mut image);
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
        assert!(Balance::of(&Image::from_luma(Plane::filled(20, 20, 90)), &[]).is_none());
    }
}
