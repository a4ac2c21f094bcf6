//! The panels of a page as slots for photos.

use crate::framing::{Crop, Region, Target};
use crate::layout::merge::merged_bounds;
use crate::layout::{Bounds, ResolvedPanel, ResolvedShape};

/// Minimum area, relative to the largest panel, of a panel that counts as equally large.
pub const LEADS: f64 = 0.97;

/// A panel, or a merged group of panels, that needs a photo, in reading order.
#[derive(Debug, Clone, PartialEq)]
pub struct Slot {
    /// The wanted aspect ratio and shape of the crop.
    pub target: Target,
    /// Visual prominence of the panel.
    pub weight: f32,
    /// Position in page widths. Panels that touch avoid the same photo.
    pub bounds: Bounds,
    /// The area of it that is seen, in square page widths.
    pub area: f64,
    /// Whether it is several panels that share an image.
    pub merged: bool,
    /// Photo and crop of a locked panel.
    pub locked: Option<Assignment>,
    /// The retained photo of the panel, whose crop is computed later.
    pub keeps: Option<usize>,
}

impl Slot {
    /// The photo that it has already.
    pub(crate) fn photo(&self) -> Option<usize> {
        self.locked.map(|locked| locked.photo).or(self.keeps)
    }
}

/// A panel's photo.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Assignment {
    /// Index of the photo in the list given.
    pub photo: usize,
    /// The part of it that is shown.
    pub crop: Crop,
}

/// The panels of a page as slots; `page_width` is the width of the exported page in pixels.
#[must_use]
pub fn slots(panels: &[ResolvedPanel], page_width: f64) -> Vec<Slot> {
    (0..panels.len()).filter_map(|i| slot(panels, &[i], page_width, false)).collect()
}

/// Returns the slot of one panel, or of a group of panels that share one image. `None` for an empty group.
/// `covered_by_any` is as in [`Region::of`].
#[must_use]
pub fn slot(
    panels: &[ResolvedPanel],
    group: &[usize],
    page_width: f64,
    covered_by_any: bool,
) -> Option<Slot> {
    let bounds = merged_bounds(panels, group)?;
    let leader = panels.get(*group.first()?)?;
    let round = group.len() == 1 && matches!(leader.shape, ResolvedShape::Circle { .. });
    let region = Region::of(panels, group, covered_by_any);
    let part = if round && region.is_plain() { std::f64::consts::FRAC_PI_4 } else { region.seen() };
    let target = Target { aspect: bounds.aspect(), width: bounds.width * page_width, round, region };
    let area = bounds.width * bounds.height * part;
    Some(Slot {
        target,
        weight: leader.weight,
        bounds,
        area,
        merged: group.len() > 1,
        locked: None,
        keeps: None,
    })
}

/// Panels less than a generous gutter apart along an edge, or one on top of the other; corners do not count.
#[must_use]
pub fn touch(a: Bounds, b: Bounds) -> bool {
    let apart = |a: f64, al: f64, b: f64, bl: f64| (b - a - al).max(a - b - bl);
    let (across, down) = (apart(a.x, a.width, b.x, b.width), apart(a.y, a.height, b.y, b.height));
    across.max(down) < 0.05 && across.min(down) < -0.01
}
