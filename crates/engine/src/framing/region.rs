//! The visible part of a panel's rectangle: inside its outline, not covered by later panels, not in the
//! gutters of a merge.
//!
//! A grid of samples with running sums gives the visible part of a head in constant time, for any of the many
//! crops of a photo.

use crate::layout::{Bounds, Point, ResolvedPanel, ResolvedShape, polygon};

/// Samples across and down.
const GRID: usize = 40;
/// Minimum visible part of a box that counts as complete. Heads are round: a slanted edge that takes a corner
/// of the box takes nothing of the head.
const WHOLE: f64 = 0.96;
/// The part of a box that makes it count as hidden.
const GONE: f64 = 0.04;
/// Cells that count as wholly inside where the sums are rounded.
const SLACK: f64 = 1e-6;

/// The visible part of a rectangle, in coordinates from 0 to 1.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Region {
    /// One part for each panel that shows a part of the image. Empty if the whole rectangle is visible.
    parts: Vec<Part>,
    /// The largest upright rectangle in which everything is seen, in one part.
    core: Option<Bounds>,
    /// The part of the rectangle that is seen, less than 1.
    hidden: f64,
}

/// One panel's window.
#[derive(Debug, Clone, PartialEq)]
struct Part {
    /// `(GRID + 1) * (GRID + 1)` counts of the seen samples above and to the left.
    sums: Vec<u16>,
}

impl Region {
    /// The visible part of the rectangle around the panels of `group`. `panels` are in paint order, from
    /// [`resolve`](crate::layout::resolve). `covered_by_any` checks every later panel, not only overlays. It
    /// is for pages with layouts from other sources.
    #[must_use]
    pub fn of(panels: &[ResolvedPanel], group: &[usize], covered_by_any: bool) -> Self {
        let Some(bounds) =
            group.iter().filter_map(|&i| panels.get(i)).map(|p| p.bounds).reduce(Bounds::union)
        else {
            return Self::default();
        };
        let over = |i: usize| -> Vec<&ResolvedPanel> {
            let later = panels.iter().enumerate().skip(i + 1);
            let later = later.filter(|(j, other)| !group.contains(j) && (covered_by_any || other.overlay));
            later.map(|(_, other)| other).filter(|other| meets(other, bounds)).collect()
        };
        let windows: Vec<(&ResolvedPanel, Vec<&ResolvedPanel>)> =
            group.iter().filter_map(|&i| Some((panels.get(i)?, over(i)))).collect();
        if let [(panel, over)] = &windows[..]
            && over.is_empty()
            && (matches!(panel.shape, ResolvedShape::Circle { .. }) || upright(panel))
        {
            // Only a single circle has an exact rule.
            return Self::default();
        }
        let parts: Vec<Part> = windows.iter().map(|(panel, over)| Part::of(panel, over, bounds)).collect();
        let core = parts.iter().filter_map(Part::core).max_by(|a, b| size(a).total_cmp(&size(b)));
        let all = Bounds { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };
        let hidden = 1.0 - parts.iter().map(|part| part.seen(all)).sum::<f64>().min(1.0);
        Self { parts, core, hidden }
    }

    /// Whether all of the rectangle is seen.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.parts.is_empty()
    }

    /// The part of the rectangle that is seen, 0 to 1.
    #[must_use]
    pub fn seen(&self) -> f64 {
        1.0 - self.hidden
    }

    /// The largest axis-parallel rectangle that is completely visible. The whole rectangle if nothing is
    /// hidden.
    #[must_use]
    pub fn core(&self) -> Bounds {
        self.core.unwrap_or(Bounds { x: 0.0, y: 0.0, width: 1.0, height: 1.0 })
    }

    /// The visible shares of a box: in all windows together, and in the window that shows most of it. The
    /// part outside of the rectangle is not visible.
    #[must_use]
    pub fn shares(&self, inner: Bounds) -> (f64, f64) {
        let area = (inner.width * inner.height).max(f64::MIN_POSITIVE);
        if self.parts.is_empty() {
            let within = |at: f64, side: f64| ((at + side).min(1.0) - at.max(0.0)).max(0.0);
            let share = within(inner.x, inner.width) * within(inner.y, inner.height) / area;
            return (share, share);
        }
        let (mut all, mut most) = (0.0, 0.0f64);
        for part in &self.parts {
            let share = part.seen(inner) / area;
            all += share;
            most = most.max(share);
        }
        (all, most)
    }

    /// Returns whether a box is completely visible in one window.
    #[must_use]
    pub fn holds(&self, inner: Bounds) -> bool {
        self.shares(inner).1 >= if self.parts.is_empty() { 1.0 - SLACK } else { WHOLE }
    }

    /// Whether a box is seen in part: cut by an edge, or by a gutter between two windows.
    #[must_use]
    pub fn cuts(&self, inner: Bounds) -> bool {
        let (all, most) = self.shares(inner);
        if self.parts.is_empty() { all > SLACK && most < 1.0 - SLACK } else { all > GONE && most < WHOLE }
    }
}

impl Part {
    fn of(panel: &ResolvedPanel, over: &[&ResolvedPanel], bounds: Bounds) -> Self {
        let mut sums = vec![0u16; (GRID + 1) * (GRID + 1)];
        for row in 0..GRID {
            let y = bounds.y + bounds.height * (row as f64 + 0.5) / GRID as f64;
            let mut line = 0u16;
            for column in 0..GRID {
                let x = bounds.x + bounds.width * (column as f64 + 0.5) / GRID as f64;
                let at = Point::new(x, y);
                let seen = inside(&panel.shape, at, 0.0)
                    && !over.iter().any(|other| inside(&other.shape, at, other.halo));
                line += u16::from(seen);
                let place = (row + 1) * (GRID + 1) + column + 1;
                sums[place] = sums[place - GRID - 1] + line;
            }
        }
        Self { sums }
    }

    /// The area of a box that is seen; the box in parts of the rectangle.
    fn seen(&self, inner: Bounds) -> f64 {
        let (x0, x1) = (self.up(inner.x), self.up(inner.x + inner.width));
        let (y0, y1) = (self.up(inner.y), self.up(inner.y + inner.height));
        let sum = self.sum(x1, y1) - self.sum(x0, y1) - self.sum(x1, y0) + self.sum(x0, y0);
        (sum / (GRID * GRID) as f64).max(0.0)
    }

    #[allow(clippy::unused_self, reason = "it reads like the sums that it is for")]
    fn up(&self, at: f64) -> f64 {
        (at * GRID as f64).clamp(0.0, GRID as f64)
    }

    fn sum(&self, x: f64, y: f64) -> f64 {
        let (column, row) = ((x as usize).min(GRID - 1), (y as usize).min(GRID - 1));
        let (fx, fy) = (x - column as f64, y - row as f64);
        let at = |row: usize, column: usize| f64::from(self.sums[row * (GRID + 1) + column]);
        let upper = at(row, column) * (1.0 - fx) + at(row, column + 1) * fx;
        let lower = at(row + 1, column) * (1.0 - fx) + at(row + 1, column + 1) * fx;
        upper * (1.0 - fy) + lower * fy
    }

    /// The largest rectangle of seen samples: the largest rectangle under each row's histogram of heights.
    fn core(&self) -> Option<Bounds> {
        let cell = |row: usize, column: usize| {
            let at = |r: usize, c: usize| self.sums[r * (GRID + 1) + c];
            at(row + 1, column + 1) + at(row, column) - at(row, column + 1) - at(row + 1, column) > 0
        };
        let mut heights = [0usize; GRID + 1];
        let mut best = (0, (0, 0, 0, 0));
        for row in 0..GRID {
            for (column, height) in heights[..GRID].iter_mut().enumerate() {
                *height = if cell(row, column) { *height + 1 } else { 0 };
            }
            let mut open: Vec<(usize, usize)> = Vec::with_capacity(GRID);
            for (column, &height) in heights.iter().enumerate() {
                let mut start = column;
                while let Some(&(from, higher)) = open.last() {
                    if higher <= height {
                        break;
                    }
                    open.pop();
                    start = from;
                    let area = higher * (column - from);
                    if area > best.0 {
                        best = (area, (from, row + 1 - higher, column - from, higher));
                    }
                }
                if open.last().is_none_or(|&(_, last)| last < height) {
                    open.push((start, height));
                }
            }
        }
        let part = |n: usize| n as f64 / GRID as f64;
        let (x, y, width, height) = best.1;
        (best.0 > 0).then(|| Bounds { x: part(x), y: part(y), width: part(width), height: part(height) })
    }
}

/// Returns whether a point is inside a shape, or nearer to it than `halo`.
fn inside(shape: &ResolvedShape, at: Point, halo: f64) -> bool {
    match shape {
        ResolvedShape::Circle { center, radius } => center.distance(at) <= radius + halo,
        ResolvedShape::Polygon(corners) => {
            polygon::edges(corners).all(|(a, b)| polygon::side(a, b, at) >= -halo)
        }
    }
}

/// Whether a panel's halo reaches into a rectangle.
fn meets(panel: &ResolvedPanel, bounds: Bounds) -> bool {
    let (b, h) = (panel.bounds, panel.halo);
    let apart = |a: f64, al: f64, b: f64, bl: f64| (b - a - al).max(a - b - bl);
    apart(b.x - h, b.width + 2.0 * h, bounds.x, bounds.width) < 0.0
        && apart(b.y - h, b.height + 2.0 * h, bounds.y, bounds.height) < 0.0
}

/// Whether a panel fills the rectangle round it.
fn upright(panel: &ResolvedPanel) -> bool {
    match &panel.shape {
        ResolvedShape::Circle { .. } => false,
        ResolvedShape::Polygon(corners) => {
            polygon::area(corners) > (1.0 - 1e-6) * panel.bounds.width * panel.bounds.height
        }
    }
}

fn size(bounds: &Bounds) -> f64 {
    bounds.width * bounds.height
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::{PageSettings, catalogue, find, resolve};

    fn page(id: &str) -> Vec<ResolvedPanel> {
        let settings = PageSettings::default();
        resolve(find(id).unwrap(), settings.aspect(), &settings)
    }

    fn inner(x: f64, y: f64, side: f64) -> Bounds {
        Bounds { x, y, width: side, height: side }
    }

    #[test]
    fn an_upright_panel_is_seen_whole_and_cuts_at_its_rim() {
        let region = Region::of(&page("grid-4"), &[0], false);
        assert!(region.is_plain() && region.seen() > 1.0 - 1e-9);
        assert!(region.holds(inner(0.0, 0.0, 0.3)) && !region.cuts(inner(0.0, 0.0, 0.3)));
        assert!(region.cuts(inner(-0.1, 0.2, 0.3)) && !region.cuts(inner(-0.4, 0.2, 0.3)));
    }

    #[test]
    fn a_slant_hides_its_corner() {
        let panels = page("slanted-2");
        let region = Region::of(&panels, &[0], false);
        let ResolvedShape::Polygon(corners) = &panels[0].shape else { panic!("a circle") };
        let share = polygon::area(corners) / (panels[0].bounds.width * panels[0].bounds.height);
        assert!((region.seen() - share).abs() < 0.01, "{} {share}", region.seen());
        let core = region.core();
        assert!(region.holds(core) && core.width * core.height > 0.3, "{core:?}");
        let corners = [(0.0, 0.0), (0.8, 0.0), (0.0, 0.8), (0.8, 0.8)];
        assert!(corners.iter().any(|&(x, y)| !region.holds(inner(x, y, 0.2))));
    }

    #[test]
    fn an_overlay_hides_what_lies_below_it_with_its_halo() {
        let panels = page("inset-corner");
        let overlay = panels.iter().position(|panel| panel.overlay).unwrap();
        let below = (0..overlay).find(|&i| !Region::of(&panels, &[i], false).is_plain()).unwrap();
        let region = Region::of(&panels, &[below], false);
        let (base, top) = (panels[below].bounds, panels[overlay].bounds);
        let place = |b: Bounds| Bounds {
            x: (b.x - base.x) / base.width,
            y: (b.y - base.y) / base.height,
            width: b.width / base.width,
            height: b.height / base.height,
        };
        assert!(region.shares(place(top)).0 < 0.02);
        assert!(panels[overlay].halo > 0.0);
    }

    #[test]
    fn the_gutter_of_a_merge_cuts_and_the_windows_hold() {
        let panels = page("grid-4");
        let region = Region::of(&panels, &[0, 1], false);
        assert!(region.cuts(inner(0.45, 0.4, 0.1)), "{:?}", region.shares(inner(0.45, 0.4, 0.1)));
        assert!(region.holds(inner(0.1, 0.3, 0.2)) && region.holds(inner(0.65, 0.3, 0.2)));
        assert!(region.core().width < 0.51);
    }

    #[test]
    fn every_panel_of_every_template_shows_something() {
        let settings = PageSettings::default();
        for template in catalogue() {
            let panels = resolve(template, settings.aspect(), &settings);
            for i in 0..panels.len() {
                let region = Region::of(&panels, &[i], false);
                assert!(region.seen() > 0.2, "{} {i}: {}", template.id(), region.seen());
                assert!(region.core().width * region.core().height > 0.04, "{} {i}", template.id());
            }
        }
    }
}
