//! Crops of photos. A manual crop never leaves the photo.

use serde::{Deserialize, Serialize};

/// Minimum part of a photo's side that a manual crop shows.
pub const LEAST_SIDE: f64 = 0.06;

/// The part of a photo that a panel shows, in fractions of the oriented photo. It lies inside the photo.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Crop {
    /// Left edge, 0..1.
    pub x: f64,
    /// Top edge, 0..1.
    pub y: f64,
    /// Width, 0..1.
    pub width: f64,
    /// Height, 0..1.
    pub height: f64,
}

impl Crop {
    /// This part of a part of a photo, as a part of the photo.
    #[must_use]
    pub fn of(self, part: &Self) -> Self {
        Self {
            x: part.x + self.x * part.width,
            y: part.y + self.y * part.height,
            width: self.width * part.width,
            height: self.height * part.height,
        }
    }

    /// Whether the other crop lies inside.
    #[must_use]
    pub fn holds(&self, other: &Self) -> bool {
        let within = |from: f64, length: f64, low: f64, side: f64| {
            from >= low - 1e-9 && from + length <= low + side + 1e-9
        };
        within(other.x, other.width, self.x, self.width) && within(other.y, other.height, self.y, self.height)
    }

    /// The area that two crops share, over the area that either covers: 0 apart, 1 the same.
    #[must_use]
    pub fn overlap(&self, other: &Self) -> f64 {
        let shared = |a: f64, al: f64, b: f64, bl: f64| ((a + al).min(b + bl) - a.max(b)).max(0.0);
        let both = shared(self.x, self.width, other.x, other.width)
            * shared(self.y, self.height, other.y, other.height);
        let either = self.width * self.height + other.width * other.height - both;
        if either > 0.0 { both / either } else { 0.0 }
    }

    /// Moves the photo by `(x, y)`, in widths and heights of the panel.
    #[must_use]
    pub fn panned(self, (x, y): (f64, f64)) -> Self {
        Self { x: self.x - x * self.width, y: self.y - y * self.height, ..self }.inside()
    }

    /// Zooms by `factor`; values above 1 zoom in. `(u, v)` is the fixed point, in fractions of the panel.
    #[must_use]
    pub fn zoomed(self, factor: f64, (u, v): (f64, f64)) -> Self {
        let longest = self.width.max(self.height);
        let closest = (LEAST_SIDE / longest).min(1.0);
        let scale = (1.0 / factor).max(closest).min(1.0 / longest);
        let (width, height) = (self.width * scale, self.height * scale);
        let (x, y) = (self.x + u * (self.width - width), self.y + v * (self.height - height));
        Self { x, y, width, height }.inside()
    }

    /// The crop moved inside the photo.
    #[must_use]
    pub fn inside(self) -> Self {
        let (width, height) = (self.width.min(1.0), self.height.min(1.0));
        let place = |at: f64, side: f64| at.max(0.0).min(1.0 - side);
        Self { x: place(self.x, width), y: place(self.y, height), width, height }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_moved_crop_stays_inside_the_photo_and_keeps_its_shape(
            (width, height, u, v) in (0.06..1.0, 0.06..1.0, 0.0..1.0, 0.0..1.0),
            (x, y, factor) in (-3.0..3.0, -3.0..3.0, 0.01..50.0),
        ) {
            let crop = Crop { x: u * (1.0 - width), y: v * (1.0 - height), width, height };
            let near = crop.panned((x, y)).zoomed(factor, (0.5, 0.5));
            prop_assert!(near.x >= 0.0 && near.y >= 0.0 && near.width > 0.0 && near.height > 0.0);
            prop_assert!(near.x + near.width <= 1.0 + 1e-9 && near.y + near.height <= 1.0 + 1e-9);
            prop_assert!((near.width / near.height - width / height).abs() < 1e-6 * width / height);
        }
    }

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-9
    }

    #[test]
    fn the_photo_follows_the_pointer_and_a_zoom_keeps_its_fixed_point() {
        let crop = Crop { x: 0.3, y: 0.3, width: 0.4, height: 0.2 };
        let moved = crop.panned((0.5, -0.5));
        assert!(close(moved.x, 0.1) && close(moved.y, 0.4) && close(moved.width, 0.4));
        let near = crop.zoomed(2.0, (0.25, 0.75));
        assert!(close(near.width, 0.2));
        assert!(close(near.x + 0.25 * near.width, crop.x + 0.25 * crop.width));
        assert!(close(near.y + 0.75 * near.height, crop.y + 0.75 * crop.height));
    }
}
