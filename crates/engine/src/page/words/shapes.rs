//! Outlines of balloons and captions, as closed lines in pixels of the page.

use super::balloons;
use super::model::{Kind, Shape};
use super::setting::FULLNESS;
use crate::layout::Point;
use std::f64::consts::PI;

/// Maximum distance of a polygon from its curve, in pixels.
const WITHIN: f64 = 0.08;

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

/// A point of the superellipse.
pub(super) fn at(a: f64, b: f64, angle: f64) -> Point {
    let part = |value: f64| value.abs().powf(2.0 / FULLNESS).copysign(value);
    Point::new(a * part(angle.cos()), b * part(angle.sin()))
}

/// The parameter of the superellipse in the direction of a point.
pub(super) fn towards(a: f64, b: f64, to: Point) -> f64 {
    let part = |value: f64| value.abs().powf(FULLNESS / 2.0).copysign(value);
    part(to.y / b).atan2(part(to.x / a))
}

pub(super) fn steps(radius: f64) -> usize {
    (PI / (2.0 * WITHIN / radius.max(0.5)).min(1.0).sqrt()).ceil().clamp(16.0, 400.0) as usize
}

/// Adds a quadratic curve without its start.
pub(super) fn curve(points: &mut Vec<Point>, from: Point, control: Point, to: Point) {
    let off = (from.x - 2.0 * control.x + to.x).hypot(from.y - 2.0 * control.y + to.y);
    let count = (off / (4.0 * WITHIN)).sqrt().ceil().clamp(1.0, 60.0) as usize;
    for i in 1..=count {
        let t = i as f64 / count as f64;
        let mix = |from: f64, control: f64, to: f64| {
            (1.0 - t) * (1.0 - t) * from + 2.0 * t * (1.0 - t) * control + t * t * to
        };
        points.push(Point::new(mix(from.x, control.x, to.x), mix(from.y, control.y, to.y)));
    }
}
