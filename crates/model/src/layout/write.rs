//! Writes a template as the text of a layout file, and as data for thumbnails.

use serde::Serialize;
use serde_json::{Map, Value, json};

use super::polygon::{Bounds, Point};
use super::resolve::{ResolvedPanel, ResolvedShape};
use super::template::{Body, Panel, Shape, Template};
use super::tree::{Axis, Node};

impl Template {
    /// The template as the text of a layout file, which [`Template::parse`] reads back to an equal template.
    #[must_use]
    pub fn to_json(&self) -> String {
        file(self)
    }

    /// The entry of this template in the list of layouts.
    #[must_use]
    pub fn descriptor(&self) -> Descriptor<'_> {
        Descriptor {
            id: &self.id,
            name: &self.name,
            family: &self.family,
            aspect: self.aspect,
            count: self.panels.len(),
            panels: self.panels.iter().map(layout_panel).collect(),
        }
    }
}

impl ResolvedPanel {
    /// The panel as JSON has it.
    #[must_use]
    pub fn placed(&self) -> PlacedPanel<'_> {
        let (polygon, circle) = match &self.shape {
            ResolvedShape::Polygon(corners) => (Some(&corners[..]), None),
            ResolvedShape::Circle { center, radius } => (None, Some(circle(*center, *radius))),
        };
        PlacedPanel { polygon, circle, bounds: self.bounds, overlay: self.overlay, halo: self.halo }
    }
}

/// The text of the layout file.
fn file(template: &Template) -> String {
    let mut lines = vec![
        format!("  \"id\": {}", json!(template.id)),
        format!("  \"name\": {}", json!(template.name)),
        format!("  \"family\": {}", json!(template.family)),
        format!("  \"aspect\": {}", json!(template.aspect)),
    ];
    lines.push(match &template.body {
        Body::Tree(tree) => format!("  \"tree\": {}", node(tree)),
        Body::Polygons(polygons) => {
            let polygons: Vec<Value> = polygons.iter().map(|polygon| points(polygon)).collect();
            format!("  \"polygons\": {}", Value::Array(polygons))
        }
    });
    if template.order.iter().enumerate().any(|(i, &panel)| i != panel) {
        lines.push(format!("  \"order\": {}", json!(template.order)));
    }
    let weights: Vec<f32> = template.panels.iter().map(|panel| panel.weight).collect();
    lines.push(format!("  \"weights\": {}", json!(weights)));
    let bleeds: Vec<usize> = (0..template.panels.len()).filter(|&i| template.panels[i].bleeds).collect();
    if !bleeds.is_empty() {
        lines.push(format!("  \"bleeds\": {}", json!(bleeds)));
    }
    let overlays: Vec<Value> = template.panels.iter().filter(|panel| panel.overlay).map(overlay).collect();
    if !overlays.is_empty() {
        lines.push(format!("  \"overlays\": {}", Value::Array(overlays)));
    }
    format!("{{\n{}\n}}\n", lines.join(",\n"))
}

/// An entry in the list of layouts, in unit coordinates.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename = "Layout"))]
pub struct Descriptor<'a> {
    /// Unique name in kebab-case.
    pub id: &'a str,
    /// Display name.
    pub name: &'a str,
    /// Its family.
    pub family: &'a str,
    /// Width over height of the page that it was drawn for.
    pub aspect: f64,
    /// Panels.
    pub count: usize,
    /// In the order in which they are painted.
    pub panels: Vec<LayoutPanel<'a>>,
}

/// A panel of a template.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct LayoutPanel<'a> {
    /// Its outline.
    pub shape: Outline<'a>,
    /// Visual prominence of the panel.
    pub weight: f32,
    /// Whether the panel is an overlay.
    pub overlay: bool,
}

/// The outline of a panel: a polygon or a circle.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Outline<'a> {
    /// Corners; the first is joined to the last.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub polygon: Option<&'a [Point]>,
    /// A circle.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub circle: Option<Circle>,
}

/// A circle.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Circle {
    /// Its centre from the left.
    pub x: f64,
    /// Its centre from the top.
    pub y: f64,
    /// Its radius.
    pub radius: f64,
}

/// A panel on the page, in page widths. Its outline is a polygon or a circle.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct PlacedPanel<'a> {
    /// Corners; the first is joined to the last.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub polygon: Option<&'a [Point]>,
    /// A circle.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub circle: Option<Circle>,
    /// The rectangle round the outline.
    pub bounds: Bounds,
    /// Whether the panel is an overlay.
    pub overlay: bool,
    /// Width of the paper-coloured outline around the panel. 0 without an outline.
    pub halo: f64,
}

fn layout_panel(panel: &Panel) -> LayoutPanel<'_> {
    LayoutPanel { shape: outline(&panel.shape), weight: panel.weight, overlay: panel.overlay }
}

fn outline(shape: &Shape) -> Outline<'_> {
    match shape {
        Shape::Polygon(corners) => Outline { polygon: Some(corners), circle: None },
        Shape::Circle { center, radius } => Outline { polygon: None, circle: Some(circle(*center, *radius)) },
    }
}

fn circle(center: Point, radius: f64) -> Circle {
    Circle { x: center.x, y: center.y, radius }
}

fn shape(shape: &Shape) -> Value {
    match shape {
        Shape::Polygon(corners) => json!({ "polygon": points(corners) }),
        Shape::Circle { center, radius } => {
            json!({ "circle": { "x": center.x, "y": center.y, "radius": radius } })
        }
    }
}

fn overlay(panel: &Panel) -> Value {
    let mut object = match shape(&panel.shape) {
        Value::Object(object) => object,
        _ => Map::new(),
    };
    object.insert("halo".into(), panel.halo.into());
    Value::Object(object)
}

fn node(node: &Node) -> Value {
    let Node::Split(split) = node else { return "panel".into() };
    let mut object = Map::new();
    let key = match split.axis {
        Axis::Rows => "rows",
        Axis::Columns => "columns",
    };
    object.insert(key.into(), split.children.iter().map(self::node).collect());
    if split.shares.iter().any(|share| share.to_bits() != 1f64.to_bits()) {
        object.insert("shares".into(), json!(split.shares));
    }
    if split.slants.iter().any(|slant| *slant != 0.0) {
        object.insert("slants".into(), json!(split.slants));
    }
    Value::Object(object)
}

fn points(points: &[Point]) -> Value {
    points.iter().map(|p| json!([p.x, p.y])).collect()
}
