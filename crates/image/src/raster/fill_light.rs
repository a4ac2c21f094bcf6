//! Fill light: dark photos get lighter shadows, so that styles with few tones draw more than black there.
//!
//! A tone of the part v of white gets a part of (sqrt(v) - v) (1 - v)^2 more. Middle and light tones stay. The part grows
//! with the dark share of the photo, so light photos do not change.

use super::Image;
use crate::simd::table::Table;

/// Pixels of the grid on the longer side, at most.
const GRID: usize = 96;
/// Luma below which a pixel is dark.
const DARK: u8 = 48;
/// Dark share of photos that do not change, and of photos that get all of the light.
const SHARE: (f64, f64) = (0.2, 0.5);
/// Most of the light, in sixteenths.
const MOST: f64 = 9.0;

/// How much lighter shadows become, in sixteenths.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FillLight(u8);

impl FillLight {
    /// Measures the shadows of a photo. `None` if they are small.
    #[must_use]
    pub fn of(photo: &Image) -> Option<Self> {
        let step = photo.width().max(photo.height()).div_ceil(GRID).max(1);
        let (mut dark, mut count) = (0_u32, 0_u32);
        for y in (step / 2..photo.height()).step_by(step) {
            for x in (step / 2..photo.width()).step_by(step) {
                dark += u32::from(luma_at(photo, x, y) < DARK);
                count += 1;
            }
        }
        let share = f64::from(dark) / f64::from(count.max(1));
        let part = ((share - SHARE.0) / (SHARE.1 - SHARE.0)).clamp(0.0, 1.0);
        // Whole steps, so that every platform rounds alike.
        let light = (part * MOST).round() as u8;
        (light > 0).then_some(Self(light))
    }

    /// Lightens a picture of the photo, such as a crop.
    pub fn apply(self, picture: &mut Image) {
        let table = Table::from_fn(|tone| self.lit(tone));
        for plane in picture.planes_mut() {
            table.apply(plane.samples_mut());
        }
    }

    /// The tone that becomes of a tone, both in grey levels.
    fn lit(self, tone: f32) -> f32 {
        let v = tone / 255.0;
        255.0 * (v + f32::from(self.0) / 16.0 * (v.sqrt() - v) * (1.0 - v) * (1.0 - v))
    }
}

fn luma_at(photo: &Image, x: usize, y: usize) -> u8 {
    match photo.planes() {
        [r, g, b] => {
            let [r, g, b] = [r, g, b].map(|plane| u32::from(plane.at(x, y)));
            ((299 * r + 587 * g + 114 * b) / 1000) as u8
        }
        planes => planes[0].at(x, y),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Plane;

    /// A photo with a dark part, in parts of its width.
    fn photo(dark: f64) -> Image {
        let plane = Plane::from_fn(100, 80, |x, y| {
            if (x as f64) < 100.0 * dark { (8 + (x + y) % 24) as u8 } else { (90 + (x + y) % 120) as u8 }
        });
        Image::from_luma(plane)
    }

    fn lit(image: &Image) -> Image {
        let mut lit = image.clone();
        if let Some(light) = FillLight::of(image) {
            light.apply(&mut lit);
        }
        lit
    }

    #[test]
    fn shadows_of_dark_photos_become_lighter_and_light_photos_stay() {
        let tone = |image: &Image, x| i32::from(image.planes()[0].at(x, 2));
        let dark = photo(0.7);
        let light = lit(&dark);
        assert!(tone(&light, 10) - tone(&dark, 10) >= 15);
        assert!(tone(&light, 95) - tone(&dark, 95) <= 3);
        assert_eq!(lit(&photo(0.1)).planes()[0].samples(), photo(0.1).planes()[0].samples());
        let half = lit(&photo(0.35));
        assert!(tone(&half, 10) > tone(&dark, 10) && tone(&half, 10) < tone(&light, 10));
    }

    #[test]
    fn tones_keep_their_order_and_black_and_white_stay() {
        let light = FillLight(MOST as u8);
        let tones: Vec<f32> = (0..=255).map(|tone| light.lit(tone as f32)).collect();
        assert!(tones.windows(2).all(|pair| pair[0] < pair[1]));
        assert_eq!((tones[0], tones[255]), (0.0, 255.0));
    }
}
