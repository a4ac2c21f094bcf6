//! The panel that a photo is cropped for.

use super::region::Region;

/// The panel that a crop is made for.
#[derive(Debug, Clone, PartialEq)]
pub struct Target {
    /// Width over height of the panel's bounds.
    pub aspect: f64,
    /// Width of the panel in pixels of the exported page; 0 when it does not matter.
    pub width: f64,
    /// True for a circle: only the inscribed circle of the crop will be seen.
    pub round: bool,
    /// The visible part of the rectangle: slanted edges, later panels and the gutters of a merge hide parts
    /// of it.
    pub region: Region,
}

impl Target {
    /// A rectangular panel of that aspect, whatever its size.
    #[must_use]
    pub fn of_aspect(aspect: f64) -> Self {
        Self { aspect, width: 0.0, round: false, region: Region::default() }
    }
}
