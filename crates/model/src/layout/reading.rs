//! The order in which panels are read. Panels are painted in another order, where overlays are last.

use super::polygon::Bounds;
use super::resolve::ResolvedPanel;

/// Minimum part of an overlay on its ground panel.
const GROUND: f64 = 0.9;
/// Minimum distance of the middle of an overlay from the edge of its row, in heights of the overlay.
const IN_ROW: f64 = 0.15;

/// Returns the panels in reading order, as numbers in paint order.
///
/// Base panels keep the order of the template. An overlay comes before the first panel that is below it or to
/// its right, and after the panel below it. `rtl`: the page is read from right to left.
#[must_use]
pub fn reading_order(panels: &[ResolvedPanel], rtl: bool) -> Vec<usize> {
    let (overlays, mut order): (Vec<usize>, Vec<usize>) =
        (0..panels.len()).partition(|&panel| panels[panel].overlay);
    for overlay in overlays {
        let inset = panels[overlay].bounds;
        let is_ground = |&other: &usize| {
            !panels[other].overlay
                && shared(inset, panels[other].bounds) >= GROUND * inset.width * inset.height
        };
        let ground = order.iter().rposition(is_ground).map_or(0, |at| at + 1);
        let next = order[ground..].iter().position(|&other| is_before(inset, panels[other].bounds, rtl));
        order.insert(next.map_or(order.len(), |at| ground + at), overlay);
    }
    order
}

/// Whether the eye meets an overlay before another panel.
fn is_before(inset: Bounds, other: Bounds, rtl: bool) -> bool {
    let (x, y) = (inset.x + inset.width / 2.0, inset.y + inset.height / 2.0);
    let within = IN_ROW * inset.height;
    if y > other.y + within && y < other.y + other.height - within {
        let ahead = other.x + other.width / 2.0 - x;
        (if rtl { -ahead } else { ahead }) > 1e-6
    } else {
        y < other.y + other.height / 2.0
    }
}

/// The area that two boxes share.
fn shared(a: Bounds, b: Bounds) -> f64 {
    let across = (a.x + a.width).min(b.x + b.width) - a.x.max(b.x);
    let down = (a.y + a.height).min(b.y + b.height) - a.y.max(b.y);
    across.max(0.0) * down.max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::resolve::ResolvedShape;
    use crate::layout::{PageSettings, find, resolve};

    /// Signed area, which tells the direction of the corners.
    fn area(panel: &ResolvedPanel) -> f64 {
        match &panel.shape {
            ResolvedShape::Polygon(corners) => {
                let pairs = corners.iter().zip(corners.iter().cycle().skip(1));
                pairs.map(|(a, b)| a.x * b.y - b.x * a.y).sum()
            }
            ResolvedShape::Circle { radius, .. } => *radius,
        }
    }

    fn order(layout: &str) -> Vec<usize> {
        let settings = PageSettings::default();
        reading_order(&resolve(find(layout).unwrap(), settings.aspect(), &settings), false)
    }

    #[test]
    fn an_inset_in_the_middle_is_read_in_the_middle() {
        assert_eq!(order("inset-middle-4"), [0, 1, 4, 2, 3]);
        assert_eq!(order("circle-middle-4"), [0, 1, 4, 2, 3]);
        assert_eq!(order("inset-between-2"), [0, 2, 1]);
    }

    #[test]
    fn an_inset_on_one_panel_is_read_after_it() {
        assert_eq!(order("inset-corner"), [0, 1]);
    }

    #[test]
    fn every_layout_is_mirrored_and_read_in_the_same_order() {
        let settings = PageSettings::default();
        let rtl = PageSettings { rtl: true, ..settings.clone() };
        for template in crate::layout::catalogue() {
            let panels = resolve(template, settings.aspect(), &settings);
            let other = resolve(template, settings.aspect(), &rtl);
            for (panel, other) in panels.iter().zip(&other) {
                let (a, b) = (panel.bounds, other.bounds);
                let far = [a.x + a.width + b.x - 1.0, a.y - b.y, a.width - b.width, a.height - b.height];
                assert!(far.iter().all(|far| far.abs() < 1e-9), "{}", template.id());
                assert!((area(panel) - area(other)).abs() < 1e-9, "{}", template.id());
            }
            assert_eq!(reading_order(&panels, false), reading_order(&other, true), "{}", template.id());
        }
    }

    #[test]
    fn base_panels_keep_their_order_in_every_layout() {
        let settings = PageSettings::default();
        for template in crate::layout::catalogue() {
            let panels = resolve(template, settings.aspect(), &settings);
            let order = reading_order(&panels, false);
            let base: Vec<usize> = order.iter().copied().filter(|&panel| !panels[panel].overlay).collect();
            assert!(base.is_sorted(), "{}: {order:?}", template.id());
            assert_eq!(order.len(), panels.len(), "{}", template.id());
        }
    }
}
