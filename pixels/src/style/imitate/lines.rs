//! Lines: how much of a picture is thin and dark, or thin and light, and how wide that is.

use crate::raster::Plane;
use serde::{Deserialize, Serialize};

/// Half the width of the widest line, in pixels of a 1920 x 1080 picture.
const REACH: f32 = 11.0;

/// Grey steps by which a line differs from both its sides.
const STEP: u8 = 36;

/// Lines of one kind.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Lines {
    /// Share of the picture's pixels that belong to one, 0 to 1.
    pub density: f32,
    /// Mean width, in pixels of a 1920 x 1080 picture; 0 where there is none.
    pub width: f32,
}

/// Dark lines and light lines. `scale` is pixels of the picture for one of a 1920 x 1080 picture.
pub(super) fn lines(luma: &Plane, scale: f32) -> [Lines; 2] {
    let reach = ((REACH * scale).round() as usize).max(2);
    [false, true].map(|light| {
        let (width, height) = (luma.width(), luma.height());
        let tone = |x: usize, y: usize| if light { 255 - luma.at(x, y) } else { luma.at(x, y) };
        // A pixel belongs to a line when both sides of it are lighter, across or down.
        let on = |x: usize, y: usize| {
            let here = tone(x, y).saturating_add(STEP);
            let across =
                x >= reach && x + reach < width && here < tone(x - reach, y) && here < tone(x + reach, y);
            across
                || (y >= reach
                    && y + reach < height
                    && here < tone(x, y - reach)
                    && here < tone(x, y + reach))
        };
        let mut above = vec![false; width];
        let (mut area, mut borders) = (0u32, 0u32);
        for y in 0..height {
            let mut before = false;
            for (x, above) in above.iter_mut().enumerate() {
                let here = on(x, y);
                area += u32::from(here);
                borders += u32::from(here != before) + u32::from(here != *above);
                (before, *above) = (here, here);
            }
        }
        // Of a border in any direction, pi / 4 of what a walk along rows and columns crosses is its length.
        let length = borders as f32 * std::f32::consts::FRAC_PI_4;
        Lines {
            density: area as f32 / (width * height) as f32,
            width: if area == 0 { 0.0 } else { 2.0 * area as f32 / length.max(1.0) / scale },
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_have_the_share_and_the_width_that_they_were_drawn_with() {
        let drawn = Plane::from_fn(200, 150, |x, y| if (x + 2 * y) % 40 < 6 { 20 } else { 230 });
        let [dark, light] = lines(&drawn, 0.5);
        assert!((dark.density - 0.15).abs() < 0.02, "{dark:?}");
        // Six pixels along a row, 2.7 across the line, at half the size.
        assert!((dark.width / 5.4 - 1.0).abs() < 0.25, "{dark:?}");
        assert!(light.density < 0.01, "{light:?}");
    }

    #[test]
    fn an_edge_is_no_line() {
        let edge = Plane::from_fn(100, 80, |x, _| if x < 50 { 10 } else { 240 });
        assert!(lines(&edge, 0.3).iter().all(|lines| lines.density == 0.0));
    }
}
