//! Measures the visible part of a photo on a page with sample points against the exact outlines. It does not
//! use the approximations of framing.

use inkpanel_engine::framing::{Crop, FACE, Subject};
use inkpanel_engine::layout::{Bounds, Point, ResolvedPanel, ResolvedShape, polygon};

/// Points across and down a box.
const POINTS: usize = 24;

/// Returns the visible parts of a box of the photo: in all panels of the group, and in the panel that shows
/// most. A round face can be fully visible although the corners of its box are not.
pub(crate) fn seen(
    s: &Subject,
    crop: &Crop,
    bounds: Bounds,
    panels: &[ResolvedPanel],
    group: &[usize],
) -> (f64, f64) {
    let (mut total, mut by_panel) = (0, vec![0; group.len()]);
    for row in 0..POINTS {
        for column in 0..POINTS {
            let (u, v) = ((column as f64 + 0.5) / POINTS as f64, (row as f64 + 0.5) / POINTS as f64);
            if s.label == FACE && (u - 0.5).hypot(v - 0.5) > 0.5 {
                continue;
            }
            total += 1;
            let (x, y) = (s.x + u * s.width, s.y + v * s.height);
            let at = Point::new(
                bounds.x + (x - crop.x) / crop.width * bounds.width,
                bounds.y + (y - crop.y) / crop.height * bounds.height,
            );
            for (count, &i) in by_panel.iter_mut().zip(group) {
                let covered = panels[i + 1..].iter().any(|p| p.overlay && inside(&p.shape, at, p.halo));
                *count += usize::from(inside(&panels[i].shape, at, 0.0) && !covered);
            }
        }
    }
    let share = |count: usize| count as f64 / f64::from(total.max(1));
    (share(by_panel.iter().sum()), share(by_panel.into_iter().max().unwrap_or(0)))
}

fn inside(shape: &ResolvedShape, at: Point, halo: f64) -> bool {
    match shape {
        ResolvedShape::Circle { center, radius } => center.distance(at) <= radius + halo,
        ResolvedShape::Polygon(corners) => {
            polygon::edges(corners).all(|(a, b)| polygon::side(a, b, at) >= -halo)
        }
    }
}
