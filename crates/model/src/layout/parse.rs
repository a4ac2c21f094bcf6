//! The strict reader of layout files: every field is checked, and every error names its path.

use std::ops::RangeInclusive;

use serde_json::Value;

use super::FAMILIES;
use super::json::{self, Field};
use super::polygon::{Point, area, intersection, normalised};
use super::template::{Body, Panel, Shape, Template, WHOLE, base_cells, natural_weight};
use super::tree::{Axis, Node, Split};
use crate::error::Result;

/// The most base panels of a page; more are smaller than a stamp on A4.
pub(super) const MOST_PANELS: usize = 40;
/// The most overlays of a page.
const MOST_OVERLAYS: usize = 12;
/// The deepest nesting of a split tree.
pub(super) const DEEPEST: usize = 10;
/// The least distance between two cuts, or between a cut and the end of its cell, as a fraction of the cell.
pub(super) const LEAST_STEP: f64 = 0.02;
/// Maximum share of the page's area that base panels may miss or cover twice.
const TILING: f64 = 1e-6;
/// The family of sheets of a board, which the program makes: frames in a page that is theirs in part only.
pub(super) const BOARD: &str = "board";
const SHARE: RangeInclusive<f64> = 0.01..=100.0;
const WEIGHT: RangeInclusive<f64> = 0.01..=100.0;
const ASPECT: RangeInclusive<f64> = 0.1..=10.0;
const HALO: RangeInclusive<f64> = 0.0..=3.0;
const UNIT: RangeInclusive<f64> = 0.0..=1.0;

impl Template {
    /// Reads a template from the text of a layout file; `file_name` is only used to name it in errors.
    ///
    /// # Errors
    /// `invalid-layout` with the file, the path of the field and the reason.
    pub fn parse(file_name: &str, json: &str) -> Result<Self> {
        template(file_name, &json::read(file_name, json)?)
    }

    /// Reads a template that stands inside another document; `file_name` names it in errors.
    ///
    /// # Errors
    /// `invalid-layout`, as [`Template::parse`].
    pub fn from_value(file_name: &str, value: &Value) -> Result<Self> {
        template(file_name, value)
    }
}

/// Checks a whole layout file.
fn template(file: &str, value: &Value) -> Result<Template> {
    let root = Field::root(file, value);
    root.object(&[
        "id", "name", "family", "aspect", "tree", "polygons", "order", "weights", "bleeds", "overlays",
    ])?;
    let id = identifier(&root.required("id")?)?;
    let name = root.required("name")?.text(60)?.to_owned();
    let family = family(&root.required("family")?)?;
    let aspect = root.required("aspect")?.number(ASPECT)?;
    let body = body(&root, family == BOARD || id.starts_with(WHOLE))?;
    let cells = base_cells(&body);
    let order = match root.get("order") {
        Some(field) => permutation(&field, cells.len())?,
        None => (0..cells.len()).collect(),
    };
    let overlays = match root.get("overlays") {
        Some(field) => {
            field.list(0..=MOST_OVERLAYS)?.iter().map(|f| overlay(f, aspect)).collect::<Result<Vec<_>>>()?
        }
        None => Vec::new(),
    };
    let mut panels: Vec<Panel> = order.iter().map(|&i| Panel::base(&cells[i], cells.len())).collect();
    if let Some(field) = root.get("bleeds") {
        for entry in field.list(0..=panels.len())? {
            panels[entry.index(cells.len())?].bleeds = true;
        }
    }
    panels.extend(overlays);
    if let Some(field) = root.get("weights") {
        let weights = field.numbers(panels.len(), &WEIGHT)?;
        for (panel, weight) in panels.iter_mut().zip(weights) {
            panel.weight = weight as f32;
        }
    }
    Ok(Template { id, name, family, aspect, body, order, panels })
}

fn identifier(field: &Field) -> Result<String> {
    let id = field.text(60)?;
    let plain =
        |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit());
    if id.split('-').all(plain) {
        return Ok(id.to_owned());
    }
    Err(field.error("must be in kebab-case: small letters and digits, parts joined by single hyphens"))
}

fn family(field: &Field) -> Result<String> {
    let family = field.text(40)?;
    if FAMILIES.contains(&family) || family == BOARD {
        return Ok(family.to_owned());
    }
    Err(field.error(format!("must be one of {}", FAMILIES.join(", "))))
}

fn body(root: &Field, loose: bool) -> Result<Body> {
    match (root.get("tree"), root.get("polygons")) {
        (Some(tree), None) => {
            let node = node(&tree, 0)?;
            if node.count() > MOST_PANELS {
                return Err(tree.error(format!("has {} panels, the most is {MOST_PANELS}", node.count())));
            }
            Ok(Body::Tree(node))
        }
        (None, Some(polygons)) => Ok(Body::Polygons(tiling(&polygons, loose)?)),
        (Some(_), Some(polygons)) => Err(polygons.error("cannot be combined with tree; use one of them")),
        (None, None) => Err(root.error("must have a tree or polygons")),
    }
}

/// A panel, `"panel"`, or an object with `rows` or `columns`.
fn node(field: &Field, depth: usize) -> Result<Node> {
    if field.is_text("panel") {
        return Ok(Node::Panel);
    }
    field.object(&["rows", "columns", "shares", "slants"])?;
    let (axis, list) = match (field.get("rows"), field.get("columns")) {
        (Some(rows), None) => (Axis::Rows, rows),
        (None, Some(columns)) => (Axis::Columns, columns),
        (Some(_), Some(columns)) => {
            return Err(columns.error("cannot be combined with rows; nest the split instead"));
        }
        (None, None) => return Err(field.error("must be \"panel\" or have rows or columns")),
    };
    if depth >= DEEPEST {
        return Err(list.error(format!("is nested more than {DEEPEST} deep")));
    }
    let list = list.list(2..=MOST_PANELS)?;
    let children = list.iter().map(|child| node(child, depth + 1)).collect::<Result<Vec<_>>>()?;
    let shares = match field.get("shares") {
        Some(shares) => shares.numbers(children.len(), &SHARE)?,
        None => vec![1.0; children.len()],
    };
    let slants = match field.get("slants") {
        Some(slants) => slants.numbers(children.len() - 1, &(-1.0..=1.0))?,
        None => vec![0.0; children.len() - 1],
    };
    let split = Split { axis, shares, slants, children };
    check_cuts(field, &split)?;
    Ok(Node::Split(split))
}

/// Checks that dividers stay inside their cell and do not cross, because a panel would be inverted.
fn check_cuts(field: &Field, split: &Split) -> Result<()> {
    let mut before = (0.0, 0.0);
    for (i, cut) in split.cuts().into_iter().chain([(1.0, 1.0)]).enumerate() {
        if cut.0 - before.0 < LEAST_STEP || cut.1 - before.1 < LEAST_STEP {
            let culprit = field.get("slants").or_else(|| field.get("shares"));
            return Err(culprit.as_ref().unwrap_or(field).error(format!(
                "leave child {i} less than {LEAST_STEP} of its cell on one side: cuts must not cross or leave it"
            )));
        }
        before = cut;
    }
    Ok(())
}

/// `loose`: they need not cover the page.
fn tiling(field: &Field, loose: bool) -> Result<Vec<Vec<Point>>> {
    let fields = field.list(1..=MOST_PANELS)?;
    let polygons = fields.iter().map(convex_polygon).collect::<Result<Vec<_>>>()?;
    for (i, second) in polygons.iter().enumerate() {
        for (j, first) in polygons[..i].iter().enumerate() {
            let shared = area(&intersection(first, second));
            if shared > TILING {
                return Err(fields[i].error(format!("overlaps polygon {j} by {shared:.6} of the page")));
            }
        }
    }
    let total: f64 = polygons.iter().map(|polygon| area(polygon)).sum();
    if !loose && (total - 1.0).abs() > TILING {
        return Err(field.error(format!("must tile the page: their areas add up to {total:.7}, not 1")));
    }
    Ok(polygons)
}

fn convex_polygon(field: &Field) -> Result<Vec<Point>> {
    let corners = field
        .list(3..=12)?
        .iter()
        .map(|corner| corner.numbers(2, &UNIT).map(|xy| Point::new(xy[0], xy[1])))
        .collect::<Result<Vec<_>>>()?;
    normalised(&corners).ok_or_else(|| {
        field.error("must be a convex polygon that encloses an area and does not cross itself")
    })
}

fn permutation(field: &Field, count: usize) -> Result<Vec<usize>> {
    let mut order: Vec<usize> = Vec::with_capacity(count);
    for entry in field.list(count..=count)? {
        let index = entry.index(count)?;
        if order.contains(&index) {
            return Err(entry.error(format!("names panel {index} a second time")));
        }
        order.push(index);
    }
    Ok(order)
}

fn overlay(field: &Field, aspect: f64) -> Result<Panel> {
    field.object(&["rect", "polygon", "circle", "halo"])?;
    let halo = field.get("halo").map_or(Ok(1.0), |halo| halo.number(HALO))?;
    let shape = match (field.get("rect"), field.get("polygon"), field.get("circle")) {
        (Some(rect), None, None) => rectangle(&rect)?,
        (None, Some(polygon), None) => Shape::Polygon(convex_polygon(&polygon)?),
        (None, None, Some(circle)) => circular(&circle, aspect)?,
        _ => return Err(field.error("must have exactly one of rect, polygon and circle")),
    };
    let weight = match &shape {
        Shape::Polygon(corners) => natural_weight(corners, 4),
        Shape::Circle { .. } => 0.5,
    };
    Ok(Panel { shape, weight, overlay: true, halo, bleeds: false })
}

fn rectangle(field: &Field) -> Result<Shape> {
    field.object(&["x", "y", "width", "height"])?;
    let (x, y) = (field.required("x")?.number(UNIT)?, field.required("y")?.number(UNIT)?);
    let (across, down) = (field.required("width")?, field.required("height")?);
    let (width, height) = (across.number(0.05..=1.0)?, down.number(0.05..=1.0)?);
    for (field, end) in [(&across, x + width), (&down, y + height)] {
        if end > 1.0 + TILING {
            return Err(field.error(format!("reaches over the edge of the page, to {end:.4}")));
        }
    }
    let (right, bottom) = ((x + width).min(1.0), (y + height).min(1.0));
    let corners = [(x, y), (right, y), (right, bottom), (x, bottom)];
    Ok(Shape::Polygon(corners.map(|(x, y)| Point::new(x, y)).to_vec()))
}

fn circular(field: &Field, aspect: f64) -> Result<Shape> {
    field.object(&["x", "y", "radius"])?;
    let center = Point::new(field.required("x")?.number(UNIT)?, field.required("y")?.number(UNIT)?);
    let reach = field.required("radius")?;
    let radius = reach.number(0.03..=0.5)?;
    for (at, radius) in [(center.x, radius), (center.y, radius * aspect)] {
        if at < radius || at > 1.0 - radius {
            return Err(reach.error("reaches over the edge of the page"));
        }
    }
    Ok(Shape::Circle { center, radius })
}
