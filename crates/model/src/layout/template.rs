//! A page template: the panels in unit coordinates, and their reading order.

use super::polygon::{Bounds, Point, area, edges, eroded, normalised, thickness};
use super::settings::DEFAULT_GUTTER;
use super::tree::{Node, PAGE};

/// Minimum thickness of a panel, in page widths. Templates with thinner panels are not offered.
pub const LEAST_THICKNESS: f64 = 0.12;
/// Maximum elongation of panels (width over height, height over width): near the intended aspect ratio of the
/// template, and on other pages. The second limit applies to automatic choices.
const MOST_ELONGATED: [(f64, f64); 2] = [(4.6, 3.2), (3.2, 2.1)];
/// How far an aspect may be from another and still be near.
const NEAR: f64 = 1.35;

/// Beginning of the ids of layouts that show photos whole. They may leave the edge of the page free.
pub(super) const WHOLE: &str = "whole-";

/// The outline of a panel.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// A convex polygon, clockwise on the screen.
    Polygon(Vec<Point>),
    /// A circle.
    Circle {
        /// Its centre, in unit coordinates.
        center: Point,
        /// Its radius in widths of a page of the template's own aspect. On wider pages the circle keeps its
        /// share of the page's area, on taller ones its share of the width.
        radius: f64,
    },
}

/// One panel of a template.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Its cell in unit coordinates (0..1 across and down the page), before gutters.
    pub shape: Shape,
    /// Visual prominence: the strongest photo belongs into the panel of the greatest weight.
    pub weight: f32,
    /// Whether the panel is an overlay. Other panels tile the page.
    pub overlay: bool,
    /// Width of the paper-coloured outline that separates an overlay from the panels below, in gutters. 0 for
    /// the rest.
    pub halo: f64,
    /// True for a base panel whose outer edges are on the edge of the page, not on its margin.
    pub bleeds: bool,
}

impl Panel {
    /// A panel that tiles the page together with `count - 1` others.
    pub(super) fn base(cell: &[Point], count: usize) -> Self {
        // Cells of a tree are convex by construction, polygons are checked; the fall-back cannot be reached.
        let corners = normalised(cell).unwrap_or_else(|| cell.to_vec());
        let weight = natural_weight(cell, count);
        Self { shape: Shape::Polygon(corners), weight, overlay: false, halo: 0.0, bleeds: false }
    }
}

/// Definition of the base panels of a template, stored so that the template can be edited and written back.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename_all = "lowercase"))]
pub enum Body {
    /// A tree of cuts.
    Tree(#[cfg_attr(feature = "typescript", ts(type = "string | object"))] Node),
    /// Convex polygons that tile the page.
    Polygons(Vec<Vec<Point>>),
}

/// A page template that has passed every check of its schema (see `layouts/README.md`).
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Template {
    pub(super) id: String,
    pub(super) name: String,
    pub(super) family: String,
    pub(super) aspect: f64,
    #[cfg_attr(feature = "typescript", ts(flatten))]
    pub(super) body: Body,
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub(super) order: Vec<usize>,
    #[cfg_attr(feature = "typescript", ts(as = "Option<Vec<f32>>", rename = "weights", optional))]
    pub(super) panels: Vec<Panel>,
}

impl Template {
    /// Returns a template without overlays, in the order of its body. The parts must be valid.
    pub(super) fn assemble(id: &str, name: &str, family: &str, aspect: f64, body: Body) -> Self {
        let cells = base_cells(&body);
        let panels = cells.iter().map(|cell| Panel::base(cell, cells.len())).collect();
        let order = (0..cells.len()).collect();
        Self { id: id.into(), name: name.into(), family: family.into(), aspect, body, order, panels }
    }

    /// Unique name in kebab-case; the name of its file.
    #[must_use]
    pub fn id(&self) -> &str {
        &self.id
    }

    /// Display name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The family, one of [`FAMILIES`](super::FAMILIES).
    #[must_use]
    pub fn family(&self) -> &str {
        &self.family
    }

    /// Width over height of the page that it was drawn for.
    #[must_use]
    pub fn aspect(&self) -> f64 {
        self.aspect
    }

    /// The base panels in reading order, then the overlays: the order in which they are painted.
    #[must_use]
    pub fn panels(&self) -> &[Panel] {
        &self.panels
    }

    /// Whether its pages are livelier than a wall of rectangles: slants, overlays, circles, or a panel at the edge of the page.
    #[must_use]
    pub fn is_lively(&self) -> bool {
        let slanted =
            |cell: &[Point]| edges(cell).any(|(a, b)| (b.x - a.x).abs().min((b.y - a.y).abs()) > 1e-6);
        self.panels.iter().any(|panel| match &panel.shape {
            Shape::Circle { .. } => true,
            Shape::Polygon(cell) => panel.overlay || panel.bleeds || slanted(cell),
        })
    }

    /// Whether it was made for the aspect ratios of photos, see [`whole`](super::whole()).
    #[must_use]
    pub fn shows_whole(&self) -> bool {
        self.id.starts_with(WHOLE)
    }

    /// The slants of the dividers, from the largest ones.
    #[must_use]
    pub fn slants(&self) -> Vec<f64> {
        let Body::Tree(node) = &self.body else { return Vec::new() };
        let (mut slants, mut level) = (Vec::new(), vec![node]);
        while !level.is_empty() {
            let splits = level.into_iter().filter_map(|node| match node {
                Node::Split(split) => Some(split),
                Node::Panel => None,
            });
            let splits: Vec<_> = splits.collect();
            slants
                .extend(splits.iter().flat_map(|split| &split.slants).copied().filter(|slant| *slant != 0.0));
            level = splits.iter().flat_map(|split| &split.children).collect();
        }
        slants
    }

    /// The part of a page of that aspect (width over height) that each panel takes, gutters included.
    #[must_use]
    pub fn shares(&self, page_aspect: f64) -> Vec<f64> {
        let share = |panel: &Panel| match &panel.shape {
            Shape::Circle { radius, .. } => {
                std::f64::consts::PI * circle_radius(*radius, self.aspect, page_aspect).powi(2) * page_aspect
            }
            Shape::Polygon(cell) => area(cell),
        };
        self.panels.iter().map(share).collect()
    }

    /// The number of panels that tile the page.
    #[must_use]
    pub fn base_count(&self) -> usize {
        self.order.len()
    }

    /// How the base panels were given.
    #[must_use]
    pub fn body(&self) -> &Body {
        &self.body
    }

    /// Returns whether the template suits a page of this aspect ratio (width over height): without gutters,
    /// no panel is thinner than 12 % of the page width, and no panel is very elongated.
    #[must_use]
    pub fn good_for(&self, page_aspect: f64) -> bool {
        let stretch = (page_aspect / self.aspect).max(self.aspect / page_aspect);
        let (wide, tall) = MOST_ELONGATED[usize::from(stretch > NEAR)];
        page_aspect.is_finite()
            && page_aspect > 0.0
            && self.panels.iter().all(|panel| match &panel.shape {
                Shape::Circle { radius, .. } => {
                    let radius = circle_radius(*radius, self.aspect, page_aspect);
                    radius * 2.0 >= LEAST_THICKNESS && radius <= 0.5f64.min(0.5 / page_aspect) * 0.8
                }
                Shape::Polygon(cell) => {
                    let cell: Vec<_> = cell.iter().map(|p| Point::new(p.x, p.y / page_aspect)).collect();
                    (1.0 / tall..=wide).contains(&Bounds::of(&cell).aspect()) && is_thick(&cell)
                }
            })
    }
}

/// Whether a convex cell has the least thickness between its gutters.
fn is_thick(cell: &[Point]) -> bool {
    let bounds = Bounds::of(cell);
    let spare = bounds.width.min(bounds.height) - DEFAULT_GUTTER - LEAST_THICKNESS;
    let is_level = |a: f64, b: f64| (a - b).abs() < f64::EPSILON;
    // Most cells are rectangles, which need no polygons.
    if spare.abs() > 1e-6 && edges(cell).all(|(a, b)| is_level(a.x, b.x) || is_level(a.y, b.y)) {
        return spare > 0.0;
    }
    eroded(cell, DEFAULT_GUTTER / 2.0).is_some_and(|panel| thickness(&panel) >= LEAST_THICKNESS)
}

/// The radius of a circle, in page widths, on a page of another aspect than the template was drawn for. It
/// never grows, so that circles which stand side by side do not run into one another.
pub(super) fn circle_radius(radius: f64, drawn_for: f64, page_aspect: f64) -> f64 {
    radius * (drawn_for / page_aspect).sqrt().min(1.0)
}

/// The base cells of a body in the order of the file.
pub(super) fn base_cells(body: &Body) -> Vec<Vec<Point>> {
    match body {
        Body::Tree(node) => node.cells(&PAGE).iter().map(|cell| cell.to_vec()).collect(),
        Body::Polygons(polygons) => polygons.clone(),
    }
}

/// The weight of a panel that its file does not weigh: its area in shares of an even page.
pub(super) fn natural_weight(cell: &[Point], count: usize) -> f32 {
    (area(cell) * count as f64) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rectangles_are_as_thick_as_the_complete_test_says() {
        let templates = crate::layout::catalogue();
        for aspect in (1..60).map(|i| f64::from(i) * 0.05) {
            for panel in templates.iter().flat_map(|template| &template.panels) {
                let Shape::Polygon(cell) = &panel.shape else { continue };
                let cell: Vec<_> = cell.iter().map(|p| Point::new(p.x, p.y / aspect)).collect();
                let complete = eroded(&cell, DEFAULT_GUTTER / 2.0)
                    .is_some_and(|panel| thickness(&panel) >= LEAST_THICKNESS);
                assert_eq!(is_thick(&cell), complete, "{cell:?}");
            }
        }
    }
}
