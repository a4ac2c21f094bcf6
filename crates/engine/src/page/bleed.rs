//! Bleed: printed area beyond the trim edge of a page, so that trimming leaves no white border. Panels at the
//! edge are extended with more of their photo, or with its mirror image. Everything else is paper.

use super::rect::PixelRect;
use crate::framing::Crop;
use crate::layout::{Bounds, Point, ResolvedShape};
use crate::raster::{Image, Plane};

/// Tolerance for sides on the page edge, relative to the width of the page, because numbers are rounded.
const NEAR: f64 = 1e-6;
/// Extension of panels past the edge, in bleeds. The border ends up outside of the trimmed area.
const REACH: f64 = 1.5;
/// The sharpest corner whose sides are followed outwards, as the sine of its angle.
const SHARPEST: f64 = 0.1;

/// Returns a shape with its sides at the page edge moved outward. `None` if no side is at the edge.
pub(super) fn extended(
    shape: &ResolvedShape,
    (width, height): (f64, f64),
    bleed: f64,
) -> Option<ResolvedShape> {
    let ResolvedShape::Polygon(points) = shape else { return None };
    let near = NEAR * width;
    let by = REACH * bleed;
    let count = points.len();
    let outward: Vec<bool> = (0..count)
        .map(|i| {
            let (from, to) = (points[i], points[(i + 1) % count]);
            let edges =
                [(from.x, to.x, 0.0), (from.x, to.x, width), (from.y, to.y, 0.0), (from.y, to.y, height)];
            edges.iter().any(|(from, to, edge)| (from - edge).abs() <= near && (to - edge).abs() <= near)
        })
        .collect();
    if by <= 0.0 || !outward.contains(&true) {
        return None;
    }
    let moved = |i: usize| if outward[i] { by } else { 0.0 };
    let corner = |i: usize| {
        let before = (i + count - 1) % count;
        crossing([points[before], points[i], points[(i + 1) % count]], [moved(before), moved(i)])
    };
    Some(ResolvedShape::Polygon((0..count).map(corner).collect()))
}

/// New corner after its two sides moved outward, clockwise on the screen.
fn crossing([from, at, to]: [Point; 3], [first, second]: [f64; 2]) -> Point {
    let side = |a: Point, b: Point| {
        let (dx, dy) = (b.x - a.x, b.y - a.y);
        let length = dx.hypot(dy).max(1e-9);
        (dx / length, dy / length)
    };
    let (a, b) = (side(from, at), side(at, to));
    let sine = (a.0 * b.1 - a.1 * b.0).max(SHARPEST);
    // In steps along both sides: the moving side continues along the other.
    Point::new(at.x + (second * a.0 - first * b.0) / sine, at.y + (second * a.1 - first * b.1) / sine)
}

/// Enlarges a crop for larger bounds, so that the content of the smaller bounds does not move. It may reach
/// beyond the photo.
pub(super) fn widened(crop: Crop, from: Bounds, to: Bounds) -> Crop {
    let (across, down) = (crop.width / from.width, crop.height / from.height);
    Crop {
        x: crop.x + (to.x - from.x) * across,
        y: crop.y + (to.y - from.y) * down,
        width: to.width * across,
        height: to.height * down,
    }
}

/// Returns the number of pixels along one axis outside of the photo, before and after it. `start` is where
/// the first begins and `step` what one is long, in fractions of the photo.
pub(super) fn beyond(start: f64, step: f64, count: usize) -> (usize, usize) {
    let middle = |pixel: usize| start + (pixel as f64 + 0.5) * step;
    let before = (0..count).take_while(|&pixel| middle(pixel) < 0.0).count();
    let behind = (before..count).rev().take_while(|&pixel| middle(pixel) > 1.0).count();
    // Something of the photo is always seen.
    if before + behind >= count { (0, 0) } else { (before, behind) }
}

/// The picture with its mirror image around it, so that it fills `area` pixels, its first ones at `left` and `top`.
pub(super) fn mirrored(image: &Image, (left, top): (usize, usize), area: PixelRect) -> Image {
    let reflect = |at: usize, first: usize, count: usize| {
        let off = at as i64 - first as i64;
        let turn = off.rem_euclid(2 * count as i64) as usize;
        if turn < count { turn } else { 2 * count - 1 - turn }
    };
    let (width, height) = (image.width(), image.height());
    let columns: Vec<usize> = (0..area.width).map(|x| reflect(x, left, width)).collect();
    let plane = |plane: &Plane| {
        let mut out = Plane::filled(area.width, area.height, 0);
        for y in 0..area.height {
            let from = plane.row(reflect(y, top, height));
            for (sample, &column) in out.row_mut(y).iter_mut().zip(&columns) {
                *sample = from[column];
            }
        }
        out
    };
    match image.planes() {
        [r, g, b] => Image::from_rgb([plane(r), plane(g), plane(b)]).unwrap_or_else(|_| image.clone()),
        planes => Image::from_luma(plane(&planes[0])),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(points: &[(f64, f64)]) -> ResolvedShape {
        ResolvedShape::Polygon(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    fn corners(shape: Option<ResolvedShape>) -> Vec<(i64, i64)> {
        let Some(ResolvedShape::Polygon(points)) = shape else { return Vec::new() };
        points.iter().map(|p| ((p.x * 100.0).round() as i64, (p.y * 100.0).round() as i64)).collect()
    }

    #[test]
    fn sides_at_the_edge_go_out_along_their_neighbours() {
        let page = (100.0, 200.0);
        let square = polygon(&[(0.0, 0.0), (50.0, 0.0), (50.0, 60.0), (0.0, 60.0)]);
        assert_eq!(
            corners(extended(&square, page, 2.0)),
            [(-300, -300), (5000, -300), (5000, 6000), (-300, 6000)]
        );
        // The slanted line does not move on the page.
        let slanted = polygon(&[(0.0, 50.0), (50.0, 75.0), (50.0, 100.0), (0.0, 100.0)]);
        assert_eq!(
            corners(extended(&slanted, page, 2.0)),
            [(-300, 4850), (5000, 7500), (5000, 10000), (-300, 10000)]
        );
        let inner = polygon(&[(10.0, 10.0), (50.0, 10.0), (50.0, 60.0), (10.0, 60.0)]);
        assert!(extended(&inner, page, 2.0).is_none());
        // A corner that touches the edge is not a side.
        let tip = polygon(&[(0.0, 50.0), (50.0, 20.0), (50.0, 80.0)]);
        assert!(extended(&tip, page, 2.0).is_none());
    }

    #[test]
    fn a_crop_grows_with_its_bounds() {
        let from = Bounds { x: 0.0, y: 0.0, width: 10.0, height: 10.0 };
        let to = Bounds { x: -1.0, y: -1.0, width: 11.0, height: 12.0 };
        let crop = widened(Crop { x: 0.2, y: 0.0, width: 0.5, height: 1.0 }, from, to);
        let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(near(crop.x, 0.15) && near(crop.y, -0.1) && near(crop.width, 0.55) && near(crop.height, 1.2));
        assert_eq!(beyond(crop.y, crop.height / 12.0, 12), (1, 1));
        assert_eq!(beyond(crop.x, crop.width / 11.0, 11), (0, 0));
    }

    #[test]
    fn what_lacks_is_mirrored() {
        let image = Image::from_luma(Plane::from_fn(3, 2, |x, y| (10 * y + x) as u8));
        let wide = mirrored(&image, (2, 1), PixelRect { x: 0, y: 0, width: 7, height: 4 });
        assert_eq!(wide.planes()[0].row(0), [1, 0, 0, 1, 2, 2, 1]);
        assert_eq!(wide.planes()[0].row(1), wide.planes()[0].row(0));
        assert_eq!(wide.planes()[0].row(3), [11, 10, 10, 11, 12, 12, 11]);
    }
}
