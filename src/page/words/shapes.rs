//! Outlines of balloons and captions, as closed lines in pixels of the page.

use super::balloons;
use super::model::{Craft, Kind, Shape};
use super::setting::FULLNESS;
use crate::layout::Point;
use std::f64::consts::{PI, TAU};

/// Maximum distance of a polygon from its curve, in pixels.
const WITHIN: f64 = 0.08;

/// A body with half the width `a` and half the height `b` around `(x, y)`; the tail is a part of it, or
/// follows it as bubbles. Effects have no body.
pub(super) fn outline(
    kind: Kind,
    craft: Craft,
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
        Kind::Balloon(shape) if craft == Craft::Letterer || shape == Shape::Radio => {
            balloons::outline(shape, a, b, tip)
        }
        Kind::Balloon(Shape::Thought) => cloud(a, b, tip),
        Kind::Balloon(Shape::Shout) => vec![burst(a, b, tip)],
        Kind::Balloon(_) => vec![oval(a, b, tip)],
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

fn oval(a: f64, b: f64, tip: Option<Point>) -> Vec<Point> {
    let count = 2 * steps(a.max(b));
    let Some(tip) = tip else {
        return (0..count).map(|i| at(a, b, TAU * i as f64 / count as f64)).collect();
    };
    let middle = towards(a, b, tip);
    // The foot of the tail is about as wide as half the balloon is high.
    let half = (0.26 * a.min(b) / at(a, b, middle).x.hypot(at(a, b, middle).y)).clamp(0.08, 0.4);
    let (from, to) = (middle + half, middle - half + TAU);
    let mut points: Vec<Point> =
        (0..=count).map(|i| at(a, b, from + (to - from) * i as f64 / count as f64)).collect();
    let (last, first) = (points[count], points[0]);
    // Both sides bend the same way, as a brush draws them.
    let bend = |foot: Point| {
        let (dx, dy) = (tip.x - foot.x, tip.y - foot.y);
        Point::new(foot.x + 0.45 * dx + 0.1 * dy, foot.y + 0.45 * dy - 0.1 * dx)
    };
    curve(&mut points, last, bend(last), tip);
    curve(&mut points, tip, bend(first), first);
    points.pop();
    points
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

/// Spikes of changing length around the text; the one nearest to the speaker reaches as far as the tail points.
fn burst(a: f64, b: f64, tip: Option<Point>) -> Vec<Point> {
    // Lengths that look hand-drawn, equal for every balloon.
    const LENGTHS: [f64; 7] = [1.3, 1.2, 1.34, 1.22, 1.28, 1.18, 1.32];
    let count = ((a / b).sqrt() * 14.0).clamp(14.0, 28.0) as usize;
    // One of the spikes points at the speaker.
    let start = tip.map_or(0.1, |tip| towards(a, b, tip));
    let angle = |half_steps: f64| start + half_steps * PI / count as f64;
    let mut points = Vec::with_capacity(2 * count);
    for i in 0..count {
        let length = LENGTHS[i % LENGTHS.len()];
        let spike = at(a * length, b * length, angle(2.0 * i as f64));
        points.push(if i == 0 { tip.unwrap_or(spike) } else { spike });
        points.push(at(a * 1.04, b * 1.04, angle(2.0 * i as f64 + 1.0)));
    }
    points
}

/// Bumps along the superellipse, and bubbles that grow smaller towards the thinker.
fn cloud(a: f64, b: f64, tip: Option<Point>) -> Vec<Vec<Point>> {
    let count = ((a / b).sqrt() * 9.0).clamp(8.0, 18.0) as usize;
    let corner = |i: usize| at(a, b, TAU * (i % count) as f64 / count as f64 + 0.2);
    let mut points = Vec::new();
    for i in 0..count {
        let (from, to) = (corner(i), corner(i + 1));
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        let radius = dx.hypot(dy) / 2.0;
        // An arc of somewhat less than a half circle, outwards.
        let arc = steps(radius);
        for step in 0..arc {
            let t = PI * step as f64 / arc as f64;
            let (along, out) = ((1.0 - t.cos()) / 2.0, 0.36 * t.sin());
            points.push(Point::new(from.x + dx * along + dy * out, from.y + dy * along - dx * out));
        }
    }
    let mut shapes = vec![points];
    if let Some(tip) = tip {
        let edge = at(a * 1.12, b * 1.12, towards(a, b, tip));
        let size = b.min(a) * 0.3;
        for (along, part) in [(0.22, 1.0), (0.6, 0.66), (0.94, 0.4)] {
            let middle = (edge.x + (tip.x - edge.x) * along, edge.y + (tip.y - edge.y) * along);
            let count = 2 * steps(size * part);
            let bubble = (0..count).map(|i| {
                let on = at(size * part, size * part * 0.8, TAU * i as f64 / count as f64);
                Point::new(on.x + middle.0, on.y + middle.1)
            });
            shapes.push(bubble.collect());
        }
    }
    shapes
}
