//! Points of the superellipse and of curves.

use super::setting::FULLNESS;
use crate::layout::Point;
use std::f64::consts::PI;

/// Maximum distance of a polygon from its curve, in pixels.
const WITHIN: f64 = 0.08;

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

/// Number of segments of a round line.
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
