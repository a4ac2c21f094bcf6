//! Anti-aliased shapes: the inside of a panel and the line around it, as coverage of pixels.

use super::coverage::{Contour, coverage};
use super::rect::PixelRect;
use crate::layout::{Point, ResolvedShape};
use std::f64::consts::{PI, TAU};

/// Coverage 0..=255 of the inside of a shape, its corners rounded by `radius` pixels.
#[must_use]
pub fn inside(shape: &ResolvedShape, radius: f64, area: PixelRect) -> Vec<u8> {
    coverage(&[Contour { points: outline(shape, radius, 0.0), adds: true }], area)
}

/// Coverage of a line of `width` pixels centred on the shape's edge.
#[must_use]
pub fn border(shape: &ResolvedShape, radius: f64, width: f64, area: PixelRect) -> Vec<u8> {
    let half = width / 2.0;
    let outer = Contour { points: outline(shape, radius, half), adds: true };
    let inner = Contour { points: outline(shape, radius, -half), adds: false };
    coverage(&[outer, inner], area)
}

/// The shape's edge moved outward by `by` pixels (inward where negative), curves cut into short segments.
pub(super) fn outline(shape: &ResolvedShape, radius: f64, by: f64) -> Vec<Point> {
    match shape {
        ResolvedShape::Circle { center, radius } => arc(*center, (radius + by).max(0.0), 0.0, TAU),
        ResolvedShape::Polygon(points) => {
            let moved = offset(points, by);
            // Sharp corners keep sharp borders.
            if radius < 0.25 || radius + by < 0.25 { moved } else { rounded(&moved, radius + by) }
        }
    }
}

/// A clockwise convex polygon with every edge moved outward by `by`.
fn offset(points: &[Point], by: f64) -> Vec<Point> {
    let count = points.len();
    let edge = |i: usize| direction(points[i % count], points[(i + 1) % count]);
    (0..count)
        .map(|i| {
            let (before, after) = (edge(i + count - 1), edge(i));
            // The corner moves along the sum of both outward normals, until it is `by` from both edges.
            let (nx, ny) = (before.1 + after.1, -(before.0 + after.0));
            let reach = by / (1.0 + before.0 * after.0 + before.1 * after.1).max(0.05);
            Point::new(points[i].x + nx * reach, points[i].y + ny * reach)
        })
        .collect()
}

/// Returns a polygon with arcs of `radius` as corners. A short edge limits the radius to half of its length.
fn rounded(points: &[Point], radius: f64) -> Vec<Point> {
    let count = points.len();
    let mut out = Vec::new();
    for i in 0..count {
        let (before, corner, after) = (points[(i + count - 1) % count], points[i], points[(i + 1) % count]);
        let (back, forth) = (direction(corner, before), direction(corner, after));
        let half_angle = (back.0 * forth.0 + back.1 * forth.1).clamp(-1.0, 1.0).acos() / 2.0;
        let tangent = half_angle.tan().max(1e-3);
        // An arc of this radius touches both edges at this distance from the corner.
        let distance = (radius / tangent).min(back.2.min(forth.2) / 2.0);
        let radius = distance * tangent;
        let (mx, my) = (back.0 + forth.0, back.1 + forth.1);
        let to_center = radius / half_angle.sin().max(1e-3) / mx.hypot(my).max(1e-9);
        let center = Point::new(corner.x + mx * to_center, corner.y + my * to_center);
        let turn = PI - 2.0 * half_angle;
        let middle = (-my).atan2(-mx);
        out.extend(arc(center, radius, middle - turn / 2.0, turn));
    }
    out
}

/// Points on an arc, clockwise on the screen, so close that no segment is off by a hundredth of a pixel.
fn arc(center: Point, radius: f64, start: f64, turn: f64) -> Vec<Point> {
    let step = 2.0 * (1.0 - 0.008 / radius.max(0.1)).clamp(-1.0, 1.0).acos();
    let count = (turn / step).ceil().max(1.0) as usize;
    (0..=count)
        .map(|i| {
            let angle = start + turn * i as f64 / count as f64;
            Point::new(center.x + radius * angle.cos(), center.y + radius * angle.sin())
        })
        .collect()
}

/// Unit vector from one point to another, and their distance.
fn direction(from: Point, to: Point) -> (f64, f64, f64) {
    let (dx, dy) = (to.x - from.x, to.y - from.y);
    let length = dx.hypot(dy).max(1e-9);
    (dx / length, dy / length, length)
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREA: PixelRect = PixelRect { x: 0, y: 0, width: 105, height: 105 };

    fn polygon(points: &[(f64, f64)]) -> ResolvedShape {
        ResolvedShape::Polygon(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    /// Coverage by testing 16 x 16 points of each pixel.
    fn supersampled(within: impl Fn(f64, f64) -> bool) -> Vec<f64> {
        let mut out = Vec::new();
        for pixel in 0..AREA.width * AREA.height {
            let (x, y) = (pixel % AREA.width, pixel / AREA.width);
            let at = |pixel: usize, i: i32| pixel as f64 + (f64::from(i) + 0.5) / 16.0;
            let hits = (0..256).filter(|i| within(at(x, i % 16), at(y, i / 16))).count();
            out.push(hits as f64 / 256.0 * 255.0);
        }
        out
    }

    fn within_polygon(points: &[(f64, f64)], x: f64, y: f64) -> bool {
        let mut inside = false;
        for i in 0..points.len() {
            let (a, b) = (points[i], points[(i + 1) % points.len()]);
            if (a.1 > y) != (b.1 > y) && x < a.0 + (y - a.1) / (b.1 - a.1) * (b.0 - a.0) {
                inside = !inside;
            }
        }
        inside
    }

    fn assert_close(mask: &[u8], oracle: &[f64]) {
        for (i, (got, wanted)) in mask.iter().zip(oracle).enumerate() {
            // Points can miss a sliver at an edge, so a pixel counts as inner when its neighbours are like it.
            let row = AREA.width as isize;
            let same =
                |by: isize| oracle.get(i.wrapping_add_signed(by)).is_none_or(|o| (o - wanted).abs() < 1e-9);
            let inner = [-row - 1, -row, 1 - row, -1, 1, row - 1, row, row + 1].into_iter().all(same);
            let limit = if inner { 4.0 } else { 16.0 };
            assert!((f64::from(*got) - wanted).abs() <= limit, "{got} for {wanted}");
        }
    }

    #[test]
    fn masks_agree_with_supersampled_polygons() {
        let shapes: [&[(f64, f64)]; 4] = [
            &[(3.3, 2.2), (60.7, 9.1), (55.2, 70.4), (8.9, 61.6)],
            &[(10.0, 10.0), (50.5, 10.0), (50.5, 40.25), (10.0, 40.25)],
            &[(1.0, 1.0), (104.0, 30.0), (1.0, 33.0)],
            &[(20.0, 20.0), (90.0, 21.0), (89.0, 90.0), (19.5, 91.0)],
        ];
        for points in shapes {
            let mask = inside(&polygon(points), 0.0, AREA);
            assert_close(&mask, &supersampled(|x, y| within_polygon(points, x, y)));
        }
    }

    #[test]
    fn circles_and_their_borders_agree_too() {
        let circle = ResolvedShape::Circle { center: Point::new(50.3, 49.2), radius: 40.6 };
        let distance = |x: f64, y: f64| (x - 50.3).hypot(y - 49.2);
        assert_close(&inside(&circle, 0.0, AREA), &supersampled(|x, y| distance(x, y) < 40.6));
        let ring = supersampled(|x, y| (distance(x, y) - 40.6).abs() < 2.5);
        assert_close(&border(&circle, 0.0, 5.0, AREA), &ring);
    }

    #[test]
    fn a_border_is_as_wide_as_asked_for_and_has_sharp_corners() {
        let square = polygon(&[(10.0, 10.0), (90.0, 10.0), (90.0, 90.0), (10.0, 90.0)]);
        let line = border(&square, 0.0, 4.0, AREA);
        let at = |x: usize, y: usize| line[y * AREA.width + x];
        assert_eq!((at(7, 50), at(8, 50), at(11, 50), at(12, 50)), (0, 255, 255, 0));
        assert_eq!((at(8, 8), at(91, 91), at(50, 50)), (255, 255, 0));
    }

    #[test]
    fn a_rounded_square_loses_its_corners_only() {
        let square = polygon(&[(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)]);
        let mask = inside(&square, 20.0, AREA);
        let area: f64 = mask.iter().map(|&v| f64::from(v) / 255.0).sum();
        let exact = 10_000.0 - (4.0 - PI) * 400.0;
        assert!((area - exact).abs() < 1.5, "{area} {exact}");
        assert_eq!((mask[0], mask[50], mask[50 * AREA.width + 50]), (0, 255, 255));
    }
}
