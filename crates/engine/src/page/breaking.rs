//! Panel breakouts: subjects that extend past the border of their panel. This module finds the part outside,
//! and adjusts the crop.
//!
//! An edge is closed if the subject must not cross it. Reasons: the photo or the page ends inside the
//! subject, it would cover the face of another panel, extend too far, or end in the border. Only the
//! connected part of the subject that starts in the panel and crosses open edges breaks out.

use super::bleed::widened;
use super::document::{Document, PanelContent};
use super::scene::{self, Around, Scene, ScenePanel};
use crate::error::Result;
use crate::framing::{Crop, PhotoMeta, Subject};
use crate::layout::polygon::edges;
use crate::layout::{Bounds, Point, ResolvedShape};
use crate::raster::plane::neighbours;
use crate::raster::resize::{Region, resample};
use crate::raster::{Matte, Plane, matte};
use oorandom::Rand64;

/// Minimum visible value of the mask. Lower values are not drawn, see `STEEP` of `compose`.
const SEEN: u8 = 96;
/// Maximum overhang of a subject beyond an edge, relative to the panel's shorter side.
const MOST_REACH: f64 = 0.3;
/// Minimum overhang, in border widths. Below it the subject would only nick the border.
const LEAST_REACH: f64 = 1.5;
/// Minimum area outside the panel, as a share of the panel's area.
const LEAST_OUTSIDE: f64 = 0.008;
/// Minimum mask confidence for automatic breakouts.
const SURE: f64 = 0.68;
/// Minimum confidence outside the panel for a person or an animal. Models are less certain about hair and
/// hats than about body outlines. The outline of things is often wrong, such as the foot of a tower in
/// bushes, so they need the higher value.
const SURE_OF_LIFE: f64 = 0.25;
/// Free distance around other faces, as a share of their size.
const ABOUT_FACES: f64 = 0.15;

/// A subject that extends over the edges of its panel.
pub(super) struct Figure {
    /// The connected part that may be visible, at the size of the photo.
    pub(super) shares: Plane,
    /// The edges of the panel, and whether they are closed to it.
    pub(super) closed: Vec<bool>,
    /// Its bounds outside of the panel, in pixels of the page.
    pub(super) outside: Bounds,
    /// The area of that, in parts of the panel's.
    pub(super) share: f64,
}

/// The edges of a panel's outline, clockwise; a circle is one edge.
pub(super) struct Edges(Vec<Edge>);

enum Edge {
    /// A point of it, and the way outward.
    Line(Point, [f64; 2]),
    Circle(Point, f64),
}

impl Edges {
    pub(super) fn of(shape: &ResolvedShape) -> Self {
        match shape {
            ResolvedShape::Polygon(points) => {
                let line = |(from, to): (Point, Point)| {
                    let (dx, dy) = (to.x - from.x, to.y - from.y);
                    let length = dx.hypot(dy).max(1e-9);
                    Edge::Line(from, [dy / length, -dx / length])
                };
                Self(edges(points).map(line).collect())
            }
            ResolvedShape::Circle { center, radius } => Self(vec![Edge::Circle(*center, *radius)]),
        }
    }

    /// How far a point is beyond an edge; less than 0 on the panel's side.
    pub(super) fn beyond(&self, edge: usize, point: Point) -> f64 {
        match &self.0[edge] {
            Edge::Line(from, [x, y]) => (point.x - from.x) * x + (point.y - from.y) * y,
            Edge::Circle(center, radius) => point.distance(*center) - radius,
        }
    }
}

/// Returns the breakout of a panel, or `None` if nothing breaks out or nothing may.
pub(super) fn figure(panel: &ScenePanel, shares: Plane, around: &Around) -> Option<Figure> {
    let (crop, bounds) = (panel.crop, panel.image_bounds);
    // The mirror image past the photo's end has no mask.
    if crop.x < -1e-6
        || crop.y < -1e-6
        || crop.x + crop.width > 1.0 + 1e-6
        || crop.y + crop.height > 1.0 + 1e-6
    {
        return None;
    }
    let (width, height) = (shares.width(), shares.height());
    let place = placed(panel, (width, height));
    let cells = Cells { shares, edges: Edges::of(&panel.shape), place: &place };
    let mut closed = vec![false; cells.edges.0.len()];
    let mut kept = cells.connected(&closed);
    cells.close(&kept, &mut closed, around, MOST_REACH * bounds.width.min(bounds.height));
    if closed.contains(&true) {
        kept = cells.connected(&closed);
    }
    let cell = (bounds.width / crop.width / width as f64, bounds.height / crop.height / height as f64);
    let (mut outside, mut sum) = (None::<Bounds>, 0.0);
    for (i, _) in kept.iter().enumerate().filter(|(_, kept)| **kept) {
        let point = place(i % width, i / width);
        if (0..closed.len()).any(|edge| cells.edges.beyond(edge, point) > 0.0) {
            sum += f64::from(cells.shares.samples()[i]) / 255.0 * cell.0 * cell.1;
            let own = Bounds {
                x: point.x - cell.0,
                y: point.y - cell.1,
                width: 2.0 * cell.0,
                height: 2.0 * cell.1,
            };
            outside = Some(outside.map_or(own, |before| before.union(own)));
        }
    }
    let share = sum / (bounds.width * bounds.height);
    let outside = outside.filter(|_| share >= LEAST_OUTSIDE)?;
    let mut shares = cells.shares;
    for (share, kept) in shares.samples_mut().iter_mut().zip(kept) {
        // The soft border belongs to the adjacent subject.
        *share *= u8::from(kept || *share < SEEN);
    }
    Some(Figure { shares, closed, outside, share })
}

/// Maps pixels of a mask to the page.
fn placed(panel: &ScenePanel, (width, height): (usize, usize)) -> impl Fn(usize, usize) -> Point {
    let (crop, bounds) = (panel.crop, panel.image_bounds);
    move |x, y| {
        let part =
            |at: usize, of: usize, start: f64, length: f64| ((at as f64 + 0.5) / of as f64 - start) / length;
        Point::new(
            bounds.x + part(x, width, crop.x, crop.width) * bounds.width,
            bounds.y + part(y, height, crop.y, crop.height) * bounds.height,
        )
    }
}

/// Returns the confidence of the subject's border outside of the panel, 0 to 1. `shares` are all of its mask.
fn confidence_outside(panel: &ScenePanel, figure: &Figure, shares: &Plane) -> f64 {
    let (edges, place) = (Edges::of(&panel.shape), placed(panel, (shares.width(), shares.height())));
    let Bounds { x: left, y: top, width, height } = figure.outside;
    matte::confidence(shares, |x, y| {
        let point = place(x, y);
        (left..=left + width).contains(&point.x)
            && (top..=top + height).contains(&point.y)
            && (0..figure.closed.len()).any(|edge| !figure.closed[edge] && edges.beyond(edge, point) > 0.0)
    })
}

/// The pixels of a mask on the page.
struct Cells<'a> {
    shares: Plane,
    edges: Edges,
    place: &'a dyn Fn(usize, usize) -> Point,
}

impl Cells<'_> {
    /// Returns the pixels that are connected to the subject inside the panel through open edges.
    fn connected(&self, closed: &[bool]) -> Vec<bool> {
        let (width, height) = (self.shares.width(), self.shares.height());
        let within = |i: usize, inside: bool| {
            let point = (self.place)(i % width, i / width);
            (0..closed.len())
                .filter(|edge| inside || closed[*edge])
                .all(|edge| self.edges.beyond(edge, point) <= 0.0)
        };
        // Most of a mask is empty, so positions are computed only for visible pixels.
        let allowed = |i: usize, inside: bool| self.shares.samples()[i] >= SEEN && within(i, inside);
        let mut kept: Vec<bool> = (0..width * height).map(|i| allowed(i, true)).collect();
        let mut open: Vec<usize> = (0..kept.len()).filter(|i| kept[*i]).collect();
        while let Some(at) = open.pop() {
            for next in neighbours(at, (width, height)) {
                if !kept[next] && allowed(next, false) {
                    kept[next] = true;
                    open.push(next);
                }
            }
        }
        kept
    }

    /// Closes the edges that the subject must not cross.
    fn close(&self, kept: &[bool], closed: &mut [bool], around: &Around, reach: f64) {
        let (width, height) = (self.shares.width(), self.shares.height());
        let Bounds { x: left, y: top, width: across, height: down } = around.room;
        let mut farthest = vec![f64::NEG_INFINITY; closed.len()];
        for i in (0..kept.len()).filter(|i| kept[*i]) {
            let (x, y) = (i % width, i / width);
            let point = (self.place)(x, y);
            let within = |bounds: &Bounds| {
                let (more, higher) = (ABOUT_FACES * bounds.width, ABOUT_FACES * bounds.height);
                (bounds.x - more..bounds.x + bounds.width + more).contains(&point.x)
                    && (bounds.y - higher..bounds.y + bounds.height + higher).contains(&point.y)
            };
            let off = x == 0
                || y == 0
                || x + 1 == width
                || y + 1 == height
                || !(left..left + across).contains(&point.x)
                || !(top..top + down).contains(&point.y)
                || around.faces.iter().any(within);
            for (edge, (closed, farthest)) in closed.iter_mut().zip(&mut farthest).enumerate() {
                let far = self.edges.beyond(edge, point);
                *closed |= far > 0.0 && (off || far > reach);
                *farthest = farthest.max(far);
            }
        }
        for (closed, far) in closed.iter_mut().zip(farthest) {
            *closed |= (-0.5 * around.border..LEAST_REACH * around.border).contains(&far);
        }
    }
}

/// Pixels along the longer side of a mask that is good enough to look for a crop by.
const COARSE: usize = 40;
/// Candidate crop sizes, as shares of the largest crop, per side.
const ZOOMS: [f64; 4] = [0.92, 0.8, 0.68, 0.55];
/// Overhang of the subject beyond the panel edge, relative to the height or width of the crop.
const STEPS: [f64; 3] = [0.08, 0.14, 0.2];
/// Number of coarse candidates that are refined.
const LOOKED_AT: usize = 6;

/// Share of new pages with a breakout, if one is possible.
const CHANCE: f64 = 0.35;
/// Panels that are tried for that.
const TRIED: usize = 2;
/// Range of the share of the photo that such a subject covers.
const COVERAGE: std::ops::Range<f64> = 0.03..0.65;
/// How good it is at least.
const GOOD: f64 = 0.5;

/// Adds a panel breakout to a new page if a good one exists. `wanted` `None`: at random; true: always; false:
/// never. Locked panels and panels with manual crops are not changed.
pub(super) fn by_chance(document: &mut Document, photos: &[PhotoMeta], wanted: Option<bool>) -> Result<()> {
    // A separate random number, so that the rest of the page does not depend on breakouts.
    let mut random = Rand64::new(u128::from(document.seed) ^ 0x6672_616d_6573);
    let drawn = random.rand_float() < CHANCE;
    let has = |document: &Document| document.panels.iter().any(|panel| panel.figure.is_some());
    if !wanted.unwrap_or(drawn) || has(document) {
        return Ok(());
    }
    let mask = |content: &PanelContent| {
        let photo = content.photo.as_ref().and_then(|id| photos.iter().find(|photo| photo.id == *id));
        photo.and_then(|photo| photo.mask.clone()).filter(|mask| {
            let facts = mask.facts();
            facts.confidence >= SURE && COVERAGE.contains(&facts.coverage)
        })
    };
    let mut free: Vec<(usize, Matte)> = (0..document.panels.len())
        .filter(|&i| {
            !document.panels[i].edited && !document.panels[i].locked && document.merge_of(i).is_none()
        })
        .filter_map(|i| Some((i, mask(&document.panels[i])?)))
        .collect();
    let mut best: Option<(usize, Matte, Crop, f64)> = None;
    for _ in 0..TRIED.min(free.len()) {
        let (panel, mask) = free.swap_remove(random.rand_range(0..free.len() as u64) as usize);
        if let Some((crop, good)) = way_out(document, panel, &mask, Some(photos))?
            && good >= best.as_ref().map_or(GOOD, |best| best.3)
        {
            best = Some((panel, mask, crop, good));
        }
    }
    if let Some((panel, mask, crop, _)) = best {
        let content = &mut document.panels[panel];
        (content.figure, content.crop) = (Some(mask), Some(crop));
    }
    Ok(())
}

/// Returns the page with the subject of a panel breaking out. Returns `None` if it cannot, or if the mask
/// confidence is too low. If the crop has to change, it counts as a manual crop.
///
/// # Errors
/// Layout errors; `invalid-document` for a panel that the page does not have.
pub fn broken(document: &Document, panel: usize, mask: &Matte) -> Result<Option<Document>> {
    if mask.facts().is_vague()
        || document.merge_of(panel).is_some()
        || document.panels.get(panel).is_none_or(|panel| panel.photo.is_none())
    {
        return Ok(None);
    }
    let Some((crop, _)) = way_out(document, panel, mask, None)? else { return Ok(None) };
    let mut document = document.clone();
    let content = &mut document.panels[panel];
    (content.figure, content.crop, content.edited) = (Some(mask.clone()), Some(crop), true);
    Ok(Some(document))
}

/// Returns whether the subject of each panel breaks out in the drawn page.
///
/// # Errors
/// Layout errors.
pub fn breaks(document: &Document) -> Result<Vec<bool>> {
    let scene = Scene::new(document, document.page.width as usize)?;
    let (own, figures) = scene.panels.split_at(document.panels.len());
    let mut breaks = vec![false; own.len()];
    let broken = (0..own.len()).filter(|&i| document.breaks_frame(i));
    for (i, panel) in broken.zip(figures) {
        if let Some((matte, around)) = &panel.figure {
            breaks[i] = figure(panel, matte.plane(), around).is_some();
        }
    }
    Ok(breaks)
}

/// `photos`: properties of the photos on the page, for automatic breakouts. For these the upper halves of
/// living subjects stay uncovered, and the border outside needs a minimum confidence.
fn way_out(
    document: &Document,
    panel: usize,
    mask: &Matte,
    photos: Option<&[PhotoMeta]>,
) -> Result<Option<(Crop, f64)>> {
    let size = scene::size(document, document.page.width as usize)?;
    let mut panels = scene::panels(document, &*document.template()?, size)?;
    for other in &mut panels {
        let photo = photos.into_iter().flatten().find(|photo| Some(&photo.id) == other.photo.as_ref());
        let alive = photo.into_iter().flat_map(|photo| &photo.subjects).filter(|subject| subject.is_alive());
        other.faces.extend(alive.map(|subject| Crop {
            x: subject.x,
            y: subject.y,
            width: subject.width,
            height: subject.height / 2.0,
        }));
    }
    let around = scene::around(document, &panels, size);
    let content = &document.panels[panel];
    let sure = photos.map(|photos| {
        let own = photos.iter().find(|photo| Some(&photo.id) == content.photo.as_ref());
        let lives = own.is_some_and(|photo| photo.subjects.iter().any(Subject::is_alive));
        if lives { SURE_OF_LIFE } else { SURE }
    });
    Ok(stepping_out(&panels[panel], content, mask, &around[panel], sure))
}

/// Crop of the panel for a breakout, unchanged if it already has one. `None` if no crop works. A manual crop
/// is never changed. The score rates the result, 0 to 1. `sure`: minimum confidence of the border outside the
/// panel, if any.
fn stepping_out(
    panel: &ScenePanel,
    content: &PanelContent,
    matte: &Matte,
    around: &Around,
    sure: Option<f64>,
) -> Option<(Crop, f64)> {
    let plane = matte.plane();
    let longer = plane.width().max(plane.height());
    let side = |side: usize| (side * COARSE.min(longer) / longer).max(1);
    let (width, height) = (side(plane.width()), side(plane.height()));
    let coarse = resample(&plane, Region::whole(plane.width(), plane.height()), width, height);
    let faces = &content.faces;
    let judged = |crop: Crop| -> Option<(Crop, f64)> {
        let shown = ScenePanel { crop, ..panel.clone() };
        let figure = figure(&shown, coarse.clone(), around)?;
        // Faces at edges without a breakout.
        let edges = Edges::of(&panel.shape);
        let cut = faces.iter().any(|face| {
            let middle = |at: f64, length: f64, start: f64, whole: f64| (at + length / 2.0 - start) / whole;
            let bounds = panel.image_bounds;
            let half = face.height / 2.0 / crop.height * bounds.height;
            let point = Point::new(
                bounds.x + middle(face.x, face.width, crop.x, crop.width) * bounds.width,
                bounds.y + middle(face.y, face.height, crop.y, crop.height) * bounds.height,
            );
            (0..figure.closed.len()).any(|edge| {
                let far = edges.beyond(edge, point);
                far > half || (figure.closed[edge] && far > -half)
            })
        });
        let crossed = figure.closed.iter().filter(|closed| **closed).count() as f64;
        let size = crop.width / panel.crop.width;
        let good = (figure.share / 0.06).min(1.0) * 0.6 + 0.4 * size.min(1.0) - 0.03 * crossed;
        (!cut).then_some((crop, good.clamp(0.0, 1.0)))
    };
    // A result in low resolution must also be good in full resolution.
    let holds = |crop: Crop| {
        let shown = ScenePanel { crop, ..panel.clone() };
        figure(&shown, plane.clone(), around).is_some_and(|figure| {
            sure.is_none_or(|least| confidence_outside(&shown, &figure, &plane) >= least)
        })
    };
    if let Some(now) = judged(panel.crop).filter(|(crop, _)| holds(*crop)) {
        return Some((now.0, now.1.max(0.5)));
    }
    if content.edited {
        return None;
    }
    let [left, top, across, down] = matte.facts().bounds;
    let mut found: Vec<(Crop, f64)> = Vec::new();
    for zoom in ZOOMS {
        let (w, h) = (panel.crop.width * zoom, panel.crop.height * zoom);
        let middle =
            |start: f64, length: f64, side: f64| (start + length / 2.0 - side / 2.0).clamp(0.0, 1.0 - side);
        let (x, y) = (middle(left, across, w), middle(top, down, h));
        for step in STEPS {
            let over = [
                (x, top + step * h),
                (left + step * w, y),
                (left + across - (1.0 + step) * w, y),
                (x, top + down - (1.0 + step) * h),
            ];
            let there =
                over.into_iter().filter(|(x, y)| *x >= 0.0 && *y >= 0.0 && x + w <= 1.0 && y + h <= 1.0);
            found.extend(there.filter_map(|(x, y)| judged(Crop { x, y, width: w, height: h })));
        }
    }
    found.sort_by(|one, other| other.1.total_cmp(&one.1));
    found.into_iter().take(LOOKED_AT).find(|(crop, _)| holds(*crop))
}

/// Returns the panel extended for its breakout: more of the photo at the same scale.
pub(super) fn widened_panel(panel: &ScenePanel, outside: Bounds, room: f64) -> ScenePanel {
    let Bounds { x, y, width, height } = outside;
    let (crop, bounds) = (panel.crop, panel.image_bounds);
    // Limited by the photo.
    let (across, down) = (bounds.width / crop.width, bounds.height / crop.height);
    let (start, end) = ((bounds.x - crop.x * across, bounds.y - crop.y * down), (across, down));
    let low = |at: f64, least: f64| (at - room).max(least);
    let high = |at: f64, most: f64| (at + room).min(most);
    let (left, top) = (low(x, start.0), low(y, start.1));
    let (right, bottom) = (high(x + width, start.0 + end.0), high(y + height, start.1 + end.1));
    let outside = Bounds { x: left, y: top, width: (right - left).max(1.0), height: (bottom - top).max(1.0) };
    let image_bounds = bounds.union(outside);
    ScenePanel { crop: widened(crop, bounds, image_bounds), image_bounds, ..panel.clone() }
}
