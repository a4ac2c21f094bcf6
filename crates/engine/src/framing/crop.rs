//! Crops of photos.

use serde::{Deserialize, Serialize};

/// The part of a photo that a panel shows, in fractions of the oriented photo. It lies inside the photo.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
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
    pub(super) fn of(self, part: &Self) -> Self {
        Self {
            x: part.x + self.x * part.width,
            y: part.y + self.y * part.height,
            width: self.width * part.width,
            height: self.height * part.height,
        }
    }

    /// Whether the other crop lies inside.
    pub(super) fn holds(&self, other: &Self) -> bool {
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
}
