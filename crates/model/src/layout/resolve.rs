//! A template on a page: gutters and margins are subtracted, in page-width units.

use super::polygon::{Bounds, Point, TINY, clip, edges, eroded};
use super::settings::PageSettings;
use super::template::{Shape, Template, circle_radius};

/// The least part of a panel's half thickness that gutters leave.
const KEPT: f64 = 0.5;
/// The most of the page's shorter side that one margin takes.
const MOST_MARGIN: f64 = 0.25;

/// The outline of a panel on the page, in page-width units: x from 0 to 1, y from 0 to height / width.
#[derive(Debug, Clone, PartialEq)]
pub enum ResolvedShape {
    /// A convex polygon, clockwise on the screen.
    Polygon(Vec<Point>),
    /// A circle.
    Circle {
        /// Its centre.
        center: Point,
        /// Its radius.
        radius: f64,
    },
}

/// A panel on the page.
#[derive(Debug, Clone, PartialEq)]
pub struct ResolvedPanel {
    /// The outline, on which the border runs.
    pub shape: ResolvedShape,
    /// The rectangle round the outline.
    pub bounds: Bounds,
    /// Visual prominence of the panel.
    pub weight: f32,
    /// Whether the panel is an overlay.
    pub overlay: bool,
    /// Width of the paper-coloured outline around the panel, in page widths. 0 without an outline.
    pub halo: f64,
}

/// The panels of a template on a page of the aspect `page_aspect` (width over height), in the order in which
/// they are painted: base panels in reading order, then overlays.
///
/// The unit square is laid over the area inside the margins, widened by half a gutter all round; then every
/// edge moves inward by half a gutter. So the outer edges are exactly on the margin, gutters are even, and
/// the columns of a grid stay equal. If gutters and margins are too large for the template, they are reduced
/// equally until every panel keeps half of its thickness.
///
/// If the page is read from right to left, the panels are mirrored. Their order stays, so the first one is on the right.
#[must_use]
pub fn resolve(template: &Template, page_aspect: f64, settings: &PageSettings) -> Vec<ResolvedPanel> {
    let page = Page::new(page_aspect, settings);
    let gutter = page.largest_gutter(template);
    let panels = template.panels().iter().map(|panel| {
        let (shape, bounds) = match &panel.shape {
            Shape::Polygon(cell) => page.polygon(cell, gutter, panel.bleeds),
            Shape::Circle { center, radius } => page.circle(*center, *radius, template.aspect(), gutter),
        };
        let halo = panel.halo * gutter;
        let (shape, bounds) = if settings.rtl { mirrored(&shape, bounds) } else { (shape, bounds) };
        ResolvedPanel { shape, bounds, weight: panel.weight, overlay: panel.overlay, halo }
    });
    panels.collect()
}

/// A panel of a page that is read from right to left.
fn mirrored(shape: &ResolvedShape, bounds: Bounds) -> (ResolvedShape, Bounds) {
    let mirror = |p: &Point| Point::new(1.0 - p.x, p.y);
    let shape = match shape {
        // The other direction keeps the corners clockwise.
        ResolvedShape::Polygon(corners) => ResolvedShape::Polygon(corners.iter().rev().map(mirror).collect()),
        ResolvedShape::Circle { center, radius } => {
            ResolvedShape::Circle { center: mirror(center), radius: *radius }
        }
    };
    (shape, Bounds { x: 1.0 - bounds.x - bounds.width, ..bounds })
}

/// The measures of a page, all in page widths.
pub(super) struct Page {
    aspect: f64,
    height: f64,
    margin: f64,
    gutter: f64,
}

impl Page {
    pub(super) fn new(aspect: f64, settings: &PageSettings) -> Self {
        let aspect = if aspect.is_finite() { aspect.clamp(0.05, 20.0) } else { 1.0 };
        let height = 1.0 / aspect;
        let margin = settings.margin.clamp(0.0, MOST_MARGIN * height.min(1.0));
        Self { aspect, height, margin, gutter: settings.gutter.max(0.0) }
    }

    /// Width and height of the room for panels, and the gutter, in page widths.
    pub(super) fn room(&self) -> (f64, f64, f64) {
        (1.0 - 2.0 * self.margin, self.height - 2.0 * self.margin, self.gutter)
    }

    /// Maps a point of the unit square to the page.
    pub(super) fn place(&self, p: Point, gutter: f64) -> Point {
        let origin = self.margin - gutter / 2.0;
        let scale = |length: f64| length - 2.0 * self.margin + gutter;
        Point::new(origin + p.x * scale(1.0), origin + p.y * scale(self.height))
    }

    /// Maps a point of the page to the unit square: the inverse of [`Page::place`].
    pub(super) fn unplace(&self, p: Point, gutter: f64) -> Point {
        let origin = self.margin - gutter / 2.0;
        let scale = |length: f64| length - 2.0 * self.margin + gutter;
        Point::new((p.x - origin) / scale(1.0), (p.y - origin) / scale(self.height))
    }

    fn cell(&self, cell: &[Point], gutter: f64) -> Vec<Point> {
        cell.iter().map(|&p| self.place(p, gutter)).collect()
    }

    /// The gutter of the settings, or less when a panel would lose more than half of its thickness.
    pub(super) fn largest_gutter(&self, template: &Template) -> f64 {
        let fits = |gutter: f64| {
            template.panels().iter().all(|panel| match &panel.shape {
                Shape::Polygon(cell) => eroded(&self.cell(cell, gutter), gutter / 2.0 / KEPT).is_some(),
                Shape::Circle { radius, .. } => {
                    circle_radius(*radius, template.aspect(), self.aspect) > gutter / 2.0 / KEPT
                }
            })
        };
        if fits(self.gutter) {
            return self.gutter;
        }
        let (mut low, mut high) = (0.0, self.gutter);
        for _ in 0..40 {
            let middle = f64::midpoint(low, high);
            if fits(middle) { low = middle } else { high = middle }
        }
        low
    }

    fn polygon(&self, cell: &[Point], gutter: f64, bleeds: bool) -> (ResolvedShape, Bounds) {
        let cell = if bleeds { self.to_the_edge(cell, gutter) } else { self.cell(cell, gutter) };
        let outline = eroded(&cell, gutter / 2.0).unwrap_or(cell);
        let bounds = Bounds::of(&outline);
        (ResolvedShape::Polygon(outline), bounds)
    }

    /// Moves the outer edges of a cell half a gutter beyond the page. The inner edges do not move.
    fn to_the_edge(&self, cell: &[Point], gutter: f64) -> Vec<Point> {
        let (low, right, bottom) = (-gutter / 2.0, 1.0 + gutter / 2.0, self.height + gutter / 2.0);
        let corners = [(low, low), (right, low), (right, bottom), (low, bottom)];
        let mut outline: Vec<Point> = corners.iter().map(|&(x, y)| Point::new(x, y)).collect();
        let at_rim = |a: f64, b: f64| (a.max(b) < TINY) || (a.min(b) > 1.0 - TINY);
        for (a, b) in edges(cell).filter(|(a, b)| !at_rim(a.x, b.x) && !at_rim(a.y, b.y)) {
            outline = clip(&outline, self.place(a, gutter), self.place(b, gutter), 0.0);
        }
        outline
    }

    /// A circle inside the margins; a panel like any other, it gives half a gutter away.
    fn circle(&self, center: Point, radius: f64, drawn_for: f64, gutter: f64) -> (ResolvedShape, Bounds) {
        let room = f64::midpoint(self.height.min(1.0), -2.0 * self.margin);
        let radius = (circle_radius(radius, drawn_for, self.aspect) - gutter / 2.0).min(room);
        let inside = |at: f64, length: f64| {
            let (low, high) = (self.margin + radius, length - self.margin - radius);
            if low < high { at.clamp(low, high) } else { length / 2.0 }
        };
        let at = self.place(center, gutter);
        let center = Point::new(inside(at.x, 1.0), inside(at.y, self.height));
        let (x, y, side) = (center.x - radius, center.y - radius, radius * 2.0);
        (ResolvedShape::Circle { center, radius }, Bounds { x, y, width: side, height: side })
    }
}
