//! Lines: how much of a picture is thin and dark, or thin and light, and how wide that is.

use crate::raster::Plane;
use crate::raster::retouch::inverted;
use serde::{Deserialize, Serialize};

/// Half the width of the widest line, in pixels of a 1920 x 1080 picture.
const REACH: f32 = 11.0;

/// Minimum contrast between a line and both its sides, in grey levels.
const STEP: u8 = 36;

/// Lines of one kind.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Lines {
    /// Share of the picture's pixels that belong to one, 0 to 1.
    pub density: f32,
    /// Mean width, in pixels of a 1920 x 1080 picture; 0 without lines.
    pub width: f32,
}

/// Dark lines and light lines. `scale` is pixels of the picture for one of a 1920 x 1080 picture.
pub(super) fn lines(luma: &Plane, scale: f32) -> [Lines; 2] {
    let reach = ((REACH * scale).round() as usize).max(2);
    [dark_lines(luma, reach, scale), dark_lines(&inverted(luma), reach, scale)]
}

fn dark_lines(luma: &Plane, reach: usize, scale: f32) -> Lines {
    let (width, height) = (luma.width(), luma.height());
    let (mut on, mut above) = (vec![0; width], vec![0; width]);
    let (mut area, mut borders) = (0u32, 0u32);
    for y in 0..height {
        mark(luma, y, reach, &mut on);
        area += on.iter().map(|&on| u32::from(on)).sum::<u32>();
        let upright = on.iter().zip(&on[1..]).map(|(a, b)| u32::from(a ^ b)).sum::<u32>();
        let level = on.iter().zip(&above).map(|(a, b)| u32::from(a ^ b)).sum::<u32>();
        borders += u32::from(on[0]) + upright + level;
        std::mem::swap(&mut on, &mut above);
    }
    // The number of crossings along rows and columns, times pi / 4, is the length of a border. This holds on
    // average over all directions.
    let length = borders as f32 * std::f32::consts::FRAC_PI_4;
    Lines {
        density: area as f32 / (width * height) as f32,
        width: if area == 0 { 0.0 } else { 2.0 * area as f32 / length.max(1.0) / scale },
    }
}

/// Sets 1 where a pixel of a row belongs to a line, as both sides of it are lighter, across or down; 0 elsewhere.
fn mark(luma: &Plane, y: usize, reach: usize, on: &mut [u8]) {
    let row = luma.row(y);
    let darker = |here: u8, a: u8, b: u8| {
        u8::from(here.saturating_add(STEP) < a) & u8::from(here.saturating_add(STEP) < b)
    };
    on.fill(0);
    if row.len() > 2 * reach {
        let middle = reach..row.len() - reach;
        let sides = row.iter().zip(&row[2 * reach..]);
        for ((on, &here), (&left, &right)) in on[middle.clone()].iter_mut().zip(&row[middle]).zip(sides) {
            *on = darker(here, left, right);
        }
    }
    if y >= reach && y + reach < luma.height() {
        let sides = luma.row(y - reach).iter().zip(luma.row(y + reach));
        for ((on, &here), (&above, &below)) in on.iter_mut().zip(row).zip(sides) {
            *on |= darker(here, above, below);
        }
    }
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
