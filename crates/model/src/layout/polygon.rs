//! Convex polygons in the plane: area, hull, clipping and erosion. Independent of pages and templates.
//!
//! A polygon is a list of corners in order round its edge, clockwise on the screen (y grows downward),
//! without a repeated last corner. [`normalised`] brings any convex outline into that form.

use serde::{Deserialize, Serialize};

/// Tolerance: closer corners count as one corner, and smaller distances as 0. Unit coordinates.
pub const TINY: f64 = 1e-9;

/// A point, or a vector, in the plane; y grows downward.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(into = "[f64; 2]")]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(type = "[number, number]"))]
pub struct Point {
    /// To the right.
    pub x: f64,
    /// Down.
    pub y: f64,
}

impl From<Point> for [f64; 2] {
    fn from(point: Point) -> Self {
        [point.x, point.y]
    }
}

impl Point {
    /// The point (x, y).
    #[must_use]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The point at `t` of the way from `self` to `other`.
    #[must_use]
    pub fn toward(self, other: Self, t: f64) -> Self {
        Self::new(self.x + (other.x - self.x) * t, self.y + (other.y - self.y) * t)
    }

    /// Distance to `other`.
    #[must_use]
    pub fn distance(self, other: Self) -> f64 {
        (other.x - self.x).hypot(other.y - self.y)
    }
}

/// A rectangle with sides parallel to the axes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Bounds {
    /// Left edge.
    pub x: f64,
    /// Top edge.
    pub y: f64,
    /// Width, at least 0.
    pub width: f64,
    /// Height, at least 0.
    pub height: f64,
}

impl Bounds {
    /// The smallest rectangle around all points. Without points it is empty and at the origin.
    #[must_use]
    pub fn of(points: &[Point]) -> Self {
        let Some(first) = points.first() else { return Self { x: 0.0, y: 0.0, width: 0.0, height: 0.0 } };
        let (mut low, mut high) = (*first, *first);
        for p in points {
            low = Point::new(low.x.min(p.x), low.y.min(p.y));
            high = Point::new(high.x.max(p.x), high.y.max(p.y));
        }
        Self { x: low.x, y: low.y, width: high.x - low.x, height: high.y - low.y }
    }

    /// The smallest rectangle round both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        let (x, y) = (self.x.min(other.x), self.y.min(other.y));
        let right = (self.x + self.width).max(other.x + other.width);
        let bottom = (self.y + self.height).max(other.y + other.height);
        Self { x, y, width: right - x, height: bottom - y }
    }

    /// Width over height.
    #[must_use]
    pub fn aspect(self) -> f64 {
        self.width / self.height.max(f64::MIN_POSITIVE)
    }
}

/// Area with a sign: positive when the corners run clockwise on the screen.
#[must_use]
pub fn signed_area(polygon: &[Point]) -> f64 {
    edges(polygon).map(|(a, b)| a.x * b.y - b.x * a.y).sum::<f64>() / 2.0
}

/// Area of a simple polygon.
#[must_use]
pub fn area(polygon: &[Point]) -> f64 {
    signed_area(polygon).abs()
}

/// Returns the corners without duplicates and without corners in the middle of a straight edge, clockwise on
/// the screen. `None` if the outline is not convex, crosses itself or has no area.
#[must_use]
pub fn normalised(outline: &[Point]) -> Option<Vec<Point>> {
    let mut corners: Vec<Point> = Vec::with_capacity(outline.len());
    for &point in outline {
        if corners.last().is_none_or(|last| last.distance(point) > TINY) {
            corners.push(point);
        }
    }
    while corners.len() > 1 && corners[0].distance(corners[corners.len() - 1]) <= TINY {
        corners.pop();
    }
    if signed_area(&corners) < 0.0 {
        corners.reverse();
    }
    let n = corners.len();
    let corners: Vec<Point> = (0..n)
        .filter(|&i| side(corners[(i + n - 1) % n], corners[(i + 1) % n], corners[i]).abs() > TINY)
        .map(|i| corners[i])
        .collect();
    let convex = corners.len() >= 3
        && signed_area(&corners) > TINY
        && edges(&corners).all(|(a, b)| corners.iter().all(|&p| side(a, b, p) >= -TINY));
    convex.then_some(corners)
}

/// The convex hull (Andrew's monotone chain), clockwise on the screen.
#[must_use]
pub fn hull(points: &[Point]) -> Vec<Point> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let mut outline = half_hull(sorted.iter().copied());
    outline.extend(half_hull(sorted.iter().rev().copied()));
    outline
}

/// One side of the hull, without its last point, which begins the other side.
fn half_hull(points: impl Iterator<Item = Point>) -> Vec<Point> {
    let mut chain: Vec<Point> = Vec::new();
    for point in points {
        while let [.., a, b] = chain[..] {
            if (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x) > 0.0 {
                break;
            }
            chain.pop();
        }
        chain.push(point);
    }
    chain.pop();
    chain
}

/// The intersection of two convex polygons. It has fewer than three corners if they do not overlap.
#[must_use]
pub fn intersection(a: &[Point], b: &[Point]) -> Vec<Point> {
    let mut rest = a.to_vec();
    for (from, to) in edges(b) {
        rest = clip(&rest, from, to, 0.0);
    }
    rest
}

/// The convex polygon with every edge moved inward by `distance`, at least 0. Edges that vanish are removed,
/// so the result is never inverted. It is `None` if nothing remains.
#[must_use]
pub fn eroded(polygon: &[Point], distance: f64) -> Option<Vec<Point>> {
    let mut rest = polygon.to_vec();
    for (from, to) in edges(polygon) {
        rest = clip(&rest, from, to, distance.max(0.0));
    }
    normalised(&rest)
}

/// The least distance between two parallel lines that hold the convex polygon between them.
#[must_use]
pub fn thickness(polygon: &[Point]) -> f64 {
    edges(polygon)
        .filter(|(a, b)| a.distance(*b) > TINY)
        .map(|(a, b)| polygon.iter().map(|&p| side(a, b, p)).fold(0.0, f64::max))
        .fold(f64::INFINITY, f64::min)
}

/// The edges as pairs of corners, the last one back to the first.
pub fn edges(polygon: &[Point]) -> impl Iterator<Item = (Point, Point)> + '_ {
    (0..polygon.len()).map(|i| (polygon[i], polygon[(i + 1) % polygon.len()]))
}

/// Distance of `p` from the line a -> b, positive on the inner side of a clockwise polygon.
#[must_use]
pub fn side(a: Point, b: Point, p: Point) -> f64 {
    let length = a.distance(b);
    if length <= f64::MIN_POSITIVE {
        return a.distance(p);
    }
    ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length
}

/// Returns the part of a convex polygon that is at least `distance` inside the line from -> to (Sutherland
/// and Hodgman).
pub(super) fn clip(polygon: &[Point], from: Point, to: Point, distance: f64) -> Vec<Point> {
    if from.distance(to) <= f64::MIN_POSITIVE {
        return polygon.to_vec();
    }
    let depth = |p: Point| side(from, to, p) - distance;
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (a, b) in edges(polygon) {
        let (da, db) = (depth(a), depth(b));
        if da >= 0.0 {
            kept.push(a);
        }
        if (da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0) {
            kept.push(a.toward(b, da / (da - db)));
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(corners: &[(f64, f64)]) -> Vec<Point> {
        corners.iter().map(|&(x, y)| Point::new(x, y)).collect()
    }

    fn square() -> Vec<Point> {
        polygon(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    }

    #[test]
    fn outlines_are_turned_and_stripped_of_idle_corners() {
        let anticlockwise =
            polygon(&[(0.0, 0.0), (0.0, 1.0), (0.5, 1.0), (1.0, 1.0), (1.0, 0.0), (1.0, 0.0), (0.0, 0.0)]);
        let turned = normalised(&anticlockwise).unwrap();
        assert_eq!(turned.len(), 4);
        assert!((signed_area(&turned) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn outlines_that_are_not_convex_are_refused() {
        let dart = polygon(&[(0.0, 0.0), (1.0, 0.0), (0.2, 0.2), (0.0, 1.0)]);
        let bow_tie = polygon(&[(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)]);
        let star: Vec<Point> = (0..5)
            .map(|i| f64::from(i * 2) * std::f64::consts::TAU / 5.0)
            .map(|a| Point::new(a.cos(), a.sin()))
            .collect();
        let line = polygon(&[(0.0, 0.0), (0.5, 0.5), (1.0, 1.0)]);
        for outline in [dart, bow_tie, star, line, Vec::new()] {
            assert_eq!(normalised(&outline), None, "{outline:?}");
        }
    }

    #[test]
    fn erosion_is_even_and_drops_edges_that_vanish() {
        let inner = eroded(&square(), 0.1).unwrap();
        assert!((area(&inner) - 0.64).abs() < 1e-12);
        // A square with one corner cut off by .1. The short edge disappears after moving in by .3.
        let cut = polygon(&[(0.1, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.1)]);
        assert_eq!(eroded(&cut, 0.01).unwrap().len(), 5);
        assert_eq!(eroded(&cut, 0.3).unwrap().len(), 4);
        assert_eq!(eroded(&cut, 0.5), None);
    }

    #[test]
    fn intersections_and_hulls_have_the_area_they_should() {
        let shifted: Vec<Point> = square().iter().map(|p| Point::new(p.x + 0.5, p.y + 0.25)).collect();
        assert!((area(&intersection(&square(), &shifted)) - 0.375).abs() < 1e-12);
        let all: Vec<Point> = square().into_iter().chain(shifted).collect();
        let outline = hull(&all);
        assert!(signed_area(&outline) > 0.0);
        assert!((area(&outline) - 1.75).abs() < 1e-12, "{}", area(&outline));
    }

    #[test]
    fn thickness_is_the_narrowest_way_through() {
        let strip = polygon(&[(0.0, 0.0), (3.0, 1.0), (3.0, 1.2), (0.0, 0.2)]);
        assert!((thickness(&strip) - 0.2 * 3.0 / 10f64.sqrt()).abs() < 1e-12);
        let triangle = polygon(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]);
        assert!((thickness(&triangle) - 0.5f64.sqrt()).abs() < 1e-12);
    }
}
