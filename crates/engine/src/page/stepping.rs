//! The pixels of panel breakouts.

use super::breaking::{Edges, Figure, widened_panel};
use super::mask;
use super::patch::{Drawing, Patch, fill_image, lay_under};
use super::rect::PixelRect;
use super::scene::{Scene, ScenePanel};
use crate::layout::Point;
use crate::raster::Plane;
use crate::raster::guided::{refined, softened, steepen};
use crate::raster::resize::{Region, resample_image};

/// Factor for the steepness of a breakout's border. Over other panels a soft border would look like a ghost.
const STEEP: i32 = 4;
/// Minimum width of the paper outline around a subject, in page widths. Otherwise it is as wide as the
/// border.
const OUTLINE: f64 = 0.002;
/// Factor from the mean mask value around a pixel to the opacity of the outline. At the edge of a subject, the
/// mean is about half, which gives full opacity.
const RING: u32 = 5;

/// Returns the panel with the additional part of its photo that its subject needs.
pub(super) fn widened(scene: &Scene, panel: &ScenePanel, figure: &Figure) -> ScenePanel {
    widened_panel(panel, figure.outside, 2.0 * outline(scene) + 2.0)
}

/// Width in pixels of the paper outline around subjects.
fn outline(scene: &Scene) -> f64 {
    scene.border.max(OUTLINE * scene.width as f64)
}

/// Cuts the subject of a panel out of its drawing, with a thin paper outline outside of the panel. It is cut
/// off at the edges that it may not cross. Unless `whole` is set, the inner part of the panel is left out,
/// because the panel shows the same pixels.
pub(super) fn patch(
    scene: &Scene,
    (panel, figure): (&ScenePanel, &Figure),
    drawing: &Drawing,
    whole: bool,
) -> Patch {
    let line = outline(scene);
    let at = drawing.shown.at;
    let part = if whole { at } else { common(at, PixelRect::around(figure.outside, 4.0 * line + 2.0)) };
    let mut alpha = shares(figure, drawing, part, scene.scale);
    steepen(&mut alpha, STEEP);
    cut_off(&mut alpha, part, scene.border, (panel, figure));
    let reach = line.ceil() as usize;
    let area = seen(&alpha, part, reach);
    let inside = mask::inside(&panel.shape, scene.corner_radius, area);
    let (left, top) = ((area.x - part.x) as usize, (area.y - part.y) as usize);
    // Only parts outside the panel have an outline. Parts that end near an edge, or must not cross it, leave the
    // border intact.
    let beyond = |x: usize, y: usize| {
        if inside[y * area.width + x] < 255 { alpha.at(left + x, top + y) } else { 0 }
    };
    let mut ring = softened(&Plane::from_fn(area.width, area.height, beyond), reach);
    cut_off(&mut ring, area, scene.border, (panel, figure));
    let mut rgba = vec![0; area.width * area.height * 4];
    fill_image(&mut rgba, area, &drawing.image, at);
    let rows = rgba.chunks_exact_mut(area.width * 4).zip(inside.chunks_exact(area.width));
    for (y, (pixels, inside)) in rows.enumerate() {
        let shares = alpha.row(top + y)[left..].iter().zip(ring.row(y)).zip(inside);
        for (pixel, ((&alpha, &ring), &inside)) in pixels.chunks_exact_mut(4).zip(shares) {
            pixel[3] = alpha;
            if ring == 0 || alpha == 255 || inside == 255 {
                continue;
            }
            // The outline is opaque with a soft rim.
            let paper = (u32::from(ring) * RING).min(255) * u32::from(255 - inside) / 255;
            lay_under(pixel, &[paper as u8], scene.paper);
        }
    }
    Patch { area, rgba }
}

/// Returns the mask of a subject in a part of its drawing, with the edges of the photo.
fn shares(figure: &Figure, Drawing { shown, photo, .. }: &Drawing, part: PixelRect, scale: f32) -> Plane {
    let (left, top) = ((part.x - shown.at.x) as f64, (part.y - shown.at.y) as f64);
    let (width, height) = (part.width as f64, part.height as f64);
    let cut = Region { x: left, y: top, width, height };
    let guide = resample_image(&shown.image, cut, part.width, part.height);
    // Ratio of mask pixels to photo pixels, and to page pixels.
    let (mask, region) = (&figure.shares, shown.region);
    let (x, y) = (mask.width() as f64 / photo.0 as f64, mask.height() as f64 / photo.1 as f64);
    let (across, down) =
        (x * region.width / shown.at.width as f64, y * region.height / shown.at.height as f64);
    let region = Region {
        x: region.x * x + left * across,
        y: region.y * y + top * down,
        width: width * across,
        height: height * down,
    };
    refined(mask, region, &guide, scale)
}

/// Intersection of two rectangles, at least one pixel of the first.
fn common(one: PixelRect, other: PixelRect) -> PixelRect {
    let span = |a: i64, long: usize, b: i64, other: usize| {
        let end = a + long as i64;
        let low = b.clamp(a, end - 1);
        (low, (b + other as i64).clamp(low + 1, end))
    };
    let (left, right) = span(one.x, one.width, other.x, other.width);
    let (top, bottom) = span(one.y, one.height, other.y, other.height);
    PixelRect { x: left, y: top, width: (right - left) as usize, height: (bottom - top) as usize }
}

/// Removes the parts beyond closed edges of a subject, and on their border. `at` is the place of its shares.
fn cut_off(shares: &mut Plane, at: PixelRect, border: f64, (panel, figure): (&ScenePanel, &Figure)) {
    let edges = Edges::of(&panel.shape);
    for edge in (0..figure.closed.len()).filter(|edge| figure.closed[*edge]) {
        for y in 0..at.height {
            // On the inner side of the border, without coverage.
            let open = |x: usize| {
                let point = Point::new(at.x as f64 + x as f64 + 0.5, at.y as f64 + y as f64 + 0.5);
                0.5 - border / 2.0 - edges.beyond(edge, point)
            };
            let row = shares.row_mut(y);
            // Panels are convex: between two pixels that are on this side all are.
            let Some(first) = (0..row.len()).find(|x| open(*x) >= 1.0) else {
                row.iter_mut().enumerate().for_each(|(x, share)| *share = part(*share, open(x)));
                continue;
            };
            let last = (first..row.len()).rev().find(|x| open(*x) >= 1.0).unwrap_or(first);
            for x in (0..first).chain(last..row.len()) {
                row[x] = part(row[x], open(x));
            }
        }
    }
}

fn part(share: u8, open: f64) -> u8 {
    (f64::from(share) * open.clamp(0.0, 1.0)) as u8
}

/// Bounds of the visible shares in `whole`, with a margin.
fn seen(shares: &Plane, whole: PixelRect, room: usize) -> PixelRect {
    let (mut left, mut top, mut right, mut bottom) = (whole.width, whole.height, 0, 0);
    for y in 0..whole.height {
        let row = shares.row(y);
        let Some(first) = row.iter().position(|share| *share > 0) else { continue };
        let last = row.iter().rposition(|share| *share > 0).unwrap_or(first);
        (left, right) = (left.min(first), right.max(last + 1));
        (top, bottom) = (top.min(y), y + 1);
    }
    let near = |low: usize, high: usize, side: usize| {
        let low = low.saturating_sub(room).min(side - 1);
        (low as i64, (high + room).clamp(low + 1, side) - low)
    };
    let ((x, width), (y, height)) = (near(left, right, whole.width), near(top, bottom, whole.height));
    PixelRect { x: whole.x + x, y: whole.y + y, width, height }
}
