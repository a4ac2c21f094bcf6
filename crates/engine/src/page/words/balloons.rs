//! Balloon shapes after the rules of letterers: curved tails a fifth as wide as the balloon, uneven clouds
//! and bursts, the bolt of a loudspeaker, and connectors between linked balloons. Lengths are in pixels,
//! around the middle of the balloon.
//!
//! Source: Nate Piekos, "Comics Grammar & Tradition" (Blambot).

use super::curves::{at, curve, steps, towards};
use super::model::Shape;
use crate::layout::Point;
use std::f64::consts::{PI, TAU};

/// Width of a tail at its foot, as a part of the balloon's.
const FOOT: f64 = 0.2;
/// How far a tail bends aside, as a part of its length.
const BEND: f64 = 0.13;
/// Lengths of spikes and sizes of bumps that look hand-drawn, equal for every balloon.
const UNEVEN: [f64; 11] = [0.5, 0.05, 0.85, 0.3, 1.0, 0.15, 0.7, 0.0, 0.55, 0.95, 0.25];

/// Outlines of a balloon with half width `a` and half height `b`. Its tail ends at `tip` and is part of the
/// body, or follows it as bubbles.
pub(super) fn outline(shape: Shape, a: f64, b: f64, tip: Option<Point>) -> Vec<Vec<Point>> {
    match shape {
        Shape::Oval | Shape::Whisper => vec![oval(a, b, tip)],
        Shape::Thought => cloud(a, b, tip),
        Shape::Shout => vec![burst(a, b, tip)],
        Shape::Radio => vec![jagged(a, b, tip)],
    }
}

/// Half the angle of the superellipse, in its parameter, that a foot around `middle` takes.
fn foot(a: f64, b: f64, middle: f64) -> f64 {
    let width = (2.0 * a * FOOT).min(0.8 * b);
    let (mut low, mut high) = (0.02, 1.1);
    for _ in 0..16 {
        let half = f64::midpoint(low, high);
        let wide = at(a, b, middle - half).distance(at(a, b, middle + half)) > width;
        if wide { high = half } else { low = half }
    }
    f64::midpoint(low, high)
}

/// The body from one end of the foot around to the other.
fn around(a: f64, b: f64, middle: f64, half: f64) -> Vec<Point> {
    let count = 2 * steps(a.max(b));
    let (from, to) = (middle + half, middle - half + TAU);
    (0..=count).map(|i| at(a, b, from + (to - from) * i as f64 / count as f64)).collect()
}

fn oval(a: f64, b: f64, tip: Option<Point>) -> Vec<Point> {
    let Some(tip) = tip else {
        let count = 2 * steps(a.max(b));
        return (0..count).map(|i| at(a, b, TAU * i as f64 / count as f64)).collect();
    };
    let middle = towards(a, b, tip);
    let mut points = around(a, b, middle, foot(a, b, middle));
    let (Some(&first), Some(&last)) = (points.first(), points.last()) else { return points };
    curve(&mut points, last, bend(last, tip), tip);
    curve(&mut points, tip, bend(first, tip), first);
    points.pop();
    points
}

/// Control point of one side of a tail, which leaves the balloon steeply and turns to the speaker.
fn bend(foot: Point, tip: Point) -> Point {
    let side = if tip.x * tip.y > 0.0 { -1.0 } else { 1.0 };
    let (dx, dy) = (tip.x - foot.x, tip.y - foot.y);
    Point::new(foot.x + 0.5 * dx - side * BEND * dy, foot.y + 0.5 * dy + side * BEND * dx)
}

/// The two sides of the tail of an oval balloon: each begins at the balloon, passes its middle and ends at the
/// tip.
pub(super) fn sides(a: f64, b: f64, tip: Point) -> [[Point; 3]; 2] {
    let middle = towards(a, b, tip);
    let half = foot(a, b, middle);
    [middle - half, middle + half].map(|angle| {
        let from = at(a, b, angle);
        [from, from.toward(tip, 0.5).toward(bend(from, tip), 0.5), tip]
    })
}

/// Uneven spikes with hollow sides; the one to the speaker reaches as far as the tail points.
fn burst(a: f64, b: f64, tip: Option<Point>) -> Vec<Point> {
    let count = ((a / b).sqrt() * 13.0).clamp(13.0, 24.0) as usize;
    let start = tip.map_or(0.1, |tip| towards(a, b, tip));
    let step = TAU / count as f64;
    let valley = |i: usize| {
        let off = 0.24 * (UNEVEN[(i * 3) % UNEVEN.len()] - 0.5);
        at(1.03 * a, 1.03 * b, start + (i as f64 + 0.5 + off) * step)
    };
    let mut points = vec![valley(count - 1)];
    for i in 0..count {
        let length = 1.13 + 0.21 * UNEVEN[i % UNEVEN.len()];
        let spike = at(a * length, b * length, start + i as f64 * step);
        let spike = if i == 0 { tip.unwrap_or(spike) } else { spike };
        let (from, to) = (valley((i + count - 1) % count), valley(i));
        let hollow = |foot: Point| {
            let middle = foot.toward(spike, 0.5);
            let between = from.toward(to, 0.5);
            middle.toward(between.toward(spike, 0.5), 0.3)
        };
        curve(&mut points, from, hollow(from), spike);
        curve(&mut points, spike, hollow(to), to);
    }
    points.pop();
    points
}

/// Leaning teeth all around, and a bolt.
fn jagged(a: f64, b: f64, tip: Option<Point>) -> Vec<Point> {
    let count = ((a / b).sqrt() * 15.0).clamp(15.0, 28.0) as usize;
    let middle = tip.map_or(0.3, |tip| towards(a, b, tip));
    let half = tip.map_or(0.0, |_| foot(a, b, middle) * 0.9);
    let (from, to) = (middle + half, middle - half + TAU);
    let mut points = Vec::new();
    for i in 0..count {
        let angle = |part: f64| from + (to - from) * (i as f64 + part) / count as f64;
        let high = 1.09 + 0.08 * UNEVEN[(i * 5) % UNEVEN.len()];
        points.push(at(1.01 * a, 1.01 * b, angle(0.0)));
        points.push(at(high * a, high * b, angle(0.22)));
    }
    let Some(tip) = tip else { return points };
    let (first, last) = (points[0], at(1.01 * a, 1.01 * b, to));
    points.push(last);
    let foot = last.toward(first, 0.5);
    let (dx, dy) = (tip.x - foot.x, tip.y - foot.y);
    let wide = last.distance(first) / 2.0 / dx.hypot(dy).max(1e-6);
    // Along the tail and across it, the side of `last` first.
    let side = if (last.x - foot.x) * -dy + (last.y - foot.y) * dx > 0.0 { wide } else { -wide };
    let on = |along: f64, across: f64| {
        Point::new(foot.x + dx * along - dy * across * side, foot.y + dy * along + dx * across * side)
    };
    points.extend([on(0.52, 0.1), on(0.46, 0.8), tip, on(0.36, -0.1), on(0.42, -0.8)]);
    points
}

/// Bumps of different sizes, and bubbles that grow smaller towards the thinker.
fn cloud(a: f64, b: f64, tip: Option<Point>) -> Vec<Vec<Point>> {
    let count = ((a / b).sqrt() * 9.0).clamp(9.0, 16.0) as usize;
    let corner = |i: usize| {
        let off = 0.36 * (UNEVEN[(i % count) % UNEVEN.len()] - 0.5);
        at(a, b, TAU * ((i % count) as f64 + off) / count as f64 + 0.2)
    };
    let mut points = Vec::new();
    for i in 0..count {
        let (from, to) = (corner(i), corner(i + 1));
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        let arc = steps(dx.hypot(dy) / 2.0);
        for step in 0..arc {
            let t = PI * step as f64 / arc as f64;
            let (along, out) = ((1.0 - t.cos()) / 2.0, 0.33 * t.sin());
            points.push(Point::new(from.x + dx * along + dy * out, from.y + dy * along - dx * out));
        }
    }
    let mut shapes = vec![points];
    let Some(tip) = tip else { return shapes };
    let edge = at(a * 1.13, b * 1.13, towards(a, b, tip));
    let length = edge.distance(tip);
    // Bubbles do not touch, however short the way is.
    let size = (0.22 * b.min(a)).min(0.2 * length);
    for (along, part) in [(0.24, 1.0), (0.62, 0.68), (0.92, 0.42)] {
        let middle = edge.toward(tip, along);
        let radius = size * part;
        let count = 2 * steps(radius);
        let on = |i: usize| {
            let (sin, cos) = (TAU * i as f64 / count as f64).sin_cos();
            Point::new(middle.x + radius * 1.15 * cos, middle.y + radius * 0.92 * sin)
        };
        shapes.push((0..count).map(on).collect());
    }
    shapes
}

/// Connector of two balloons: a band between their centres, narrow in the middle.
pub(super) fn neck(from: Point, to: Point, half: f64) -> Vec<Point> {
    let (dx, dy) = (to.x - from.x, to.y - from.y);
    let length = dx.hypot(dy).max(1e-6);
    let (across, down) = (-dy / length * half, dx / length * half);
    let beside = |point: Point, part: f64| Point::new(point.x + part * across, point.y + part * down);
    let middle = from.toward(to, 0.5);
    let mut points = vec![beside(from, -1.0)];
    curve(&mut points, beside(from, -1.0), beside(middle, -0.35), beside(to, -1.0));
    points.push(beside(to, 1.0));
    curve(&mut points, beside(to, 1.0), beside(middle, 0.35), beside(from, 1.0));
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tail_is_a_fifth_of_the_balloon_wide_and_ends_where_it_points() {
        for (x, y) in [(40.0, 160.0), (-180.0, 90.0), (220.0, 30.0), (0.0, -150.0)] {
            let tip = Point::new(x, y);
            let middle = towards(100.0, 60.0, tip);
            let half = foot(100.0, 60.0, middle);
            let wide = at(100.0, 60.0, middle - half).distance(at(100.0, 60.0, middle + half));
            assert!((wide - 40.0).abs() < 0.5, "{wide}");
            for shape in [Shape::Oval, Shape::Whisper, Shape::Shout, Shape::Radio] {
                let shapes = outline(shape, 100.0, 60.0, Some(tip));
                assert_eq!(shapes.len(), 1);
                assert!(shapes[0].iter().any(|point| point.distance(tip) < 1e-9), "{shape:?}");
            }
        }
    }

    #[test]
    fn the_sides_of_a_tail_are_on_its_outline() {
        for (x, y) in [(40.0, 160.0), (-180.0, 90.0), (220.0, 30.0), (0.0, -150.0)] {
            let tip = Point::new(x, y);
            let points = &outline(Shape::Oval, 100.0, 60.0, Some(tip))[0];
            for place in sides(100.0, 60.0, tip).into_iter().flatten() {
                let near = points.iter().map(|point| point.distance(place)).fold(f64::MAX, f64::min);
                assert!(near < 8.0, "{place:?} is {near} from the outline");
            }
        }
    }

    #[test]
    fn bubbles_of_a_thought_are_apart() {
        for length in [70.0, 90.0, 200.0] {
            let shapes = outline(Shape::Thought, 100.0, 60.0, Some(Point::new(0.0, length)));
            let span = |points: &[Point]| {
                let low = points.iter().fold(f64::MAX, |low, point| low.min(point.y));
                (low, points.iter().fold(f64::MIN, |high, point| high.max(point.y)))
            };
            let spans: Vec<_> = shapes[1..].iter().map(|points| span(points)).collect();
            assert!(spans.len() == 3 && spans.windows(2).all(|two| two[0].1 < two[1].0), "{spans:?}");
        }
    }
}
