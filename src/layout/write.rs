//! A template back to the text of a layout file, and to what the page draws thumbnails from.

use serde_json::{Map, Value, json};

use super::polygon::Point;
use super::resolve::{ResolvedPanel, ResolvedShape};
use super::template::{Body, Panel, Shape, Template};
use super::tree::{Axis, Node};

/// The text of the layout file.
pub(super) fn file(template: &Template) -> String {
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
    let overlays: Vec<Value> = template.panels.iter().filter(|panel| panel.overlay).map(overlay).collect();
    if !overlays.is_empty() {
        lines.push(format!("  \"overlays\": {}", Value::Array(overlays)));
    }
    format!("{{\n{}\n}}\n", lines.join(",\n"))
}

/// See [`Template::descriptor`].
pub(super) fn descriptor(template: &Template) -> Value {
    let panel = |panel: &Panel| json!({ "shape": shape(&panel.shape), "weight": panel.weight, "overlay": panel.overlay });
    json!({
        "id": template.id,
        "name": template.name,
        "family": template.family,
        "aspect": template.aspect,
        "count": template.panels.len(),
        "panels": template.panels.iter().map(panel).collect::<Vec<_>>(),
    })
}

/// See [`ResolvedPanel::to_value`].
pub(super) fn resolved(panel: &ResolvedPanel) -> Value {
    let outline = match &panel.shape {
        ResolvedShape::Polygon(corners) => ("polygon", points(corners)),
        ResolvedShape::Circle { center, radius } => {
            ("circle", json!({ "x": center.x, "y": center.y, "radius": radius }))
        }
    };
    let bounds = panel.bounds;
    let mut object = Map::new();
    object.insert(outline.0.into(), outline.1);
    object.insert(
        "bounds".into(),
        json!({ "x": bounds.x, "y": bounds.y, "width": bounds.width, "height": bounds.height }),
    );
    object.insert("overlay".into(), panel.overlay.into());
    object.insert("halo".into(), panel.halo.into());
    Value::Object(object)
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
