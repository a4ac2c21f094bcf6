//! Outlines of balloons and captions, as closed lines in pixels of the page.

use super::balloons;
use super::model::{Kind, Shape};
use crate::layout::Point;

/// A body with half the width `a` and half the height `b` around `(x, y)`; the tail is a part of it, or
/// follows it as bubbles. Effects have no body.
pub(super) fn outline(
    kind: Kind,
    (x, y): (f64, f64),
    (a, b): (f64, f64),
    tip: Option<Point>,
) -> Vec<Vec<Point>> {
    // Inside of the body, the tail would be invisible.
    let beyond = |tip: &Point| ((tip.x - x) / a).hypot((tip.y - y) / b) > 1.12;
    let tip = tip.filter(beyond).map(|tip| Point::new(tip.x - x, tip.y - y));
    let mut shapes = match kind {
        Kind::Effect => Vec::new(),
        Kind::Caption => vec![[(-a, -b), (a, -b), (a, b), (-a, b)].map(|(x, y)| Point::new(x, y)).to_vec()],
        Kind::Balloon(shape) => balloons::outline(shape, a, b, tip),
    };
    for point in shapes.iter_mut().flatten() {
        (point.x, point.y) = (point.x + x, point.y + y);
    }
    shapes
}

/// How far the outline reaches over the half sizes of the text's shape, as a factor.
pub(super) fn reach(kind: Kind) -> f64 {
    match kind {
        Kind::Balloon(Shape::Thought) => 1.18,
        Kind::Balloon(Shape::Shout) => 1.34,
        Kind::Balloon(Shape::Radio) => 1.17,
        _ => 1.0,
    }
}
