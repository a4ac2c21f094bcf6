//! What the page asks of layouts and does to them, as JSON in and out: the list with its pictures, the facts of
//! one layout, a new one, and changes by hand.

use super::document::template_of;
use crate::error::{Error, Result};
use crate::layout::edit::{Cut, cuts, move_cut, remove_panel, split_panel};
use crate::layout::merge::adjacent;
use crate::layout::tree::Axis;
use crate::layout::{Body, PageSettings, ResolvedShape, Template, generate, good_for, resolve};
use serde::Deserialize;
use serde_json::{Value, json};
use std::fmt::Write as _;

/// Width of a drawn template, large enough for whole numbers; its height follows from the page.
const PICTURE: f64 = 1000.0;
/// Gutter and margin of a drawn template, in page widths: wide enough to be seen at the size of a thumbnail.
const PICTURE_GUTTER: f64 = 0.05;
const PICTURE_MARGIN: f64 = 0.05;

/// The layouts for `{page, own: [template, ...]}`: those of the catalogue that are good for the page, and all of
/// a person's own. Gives `[{id, name, family, count, own, base, over}]`: `own` is the place among the own ones or
/// null; `base` and `over` are SVG paths of the panels and of the overlays on a page 1000 wide.
///
/// # Errors
/// `invalid-document`, and `invalid-layout` for an own one that is not a template.
pub fn list(json: &str) -> Result<Value> {
    #[derive(Deserialize)]
    struct Wanted {
        page: PageSettings,
        #[serde(default)]
        own: Vec<Value>,
    }
    let Wanted { page, own } = parse(json)?;
    page.validate()?;
    let aspect = page.aspect();
    let own = own.iter().map(template_of).collect::<Result<Vec<_>>>()?;
    let own = own.iter().enumerate().map(|(i, template)| entry(template, Some(i), aspect));
    Ok(own.chain(good_for(aspect).into_iter().map(|template| entry(template, None, aspect))).collect())
}

/// The layout of `{layout, page}`: `{id, name, family, count, base, good, editable, adjacent, cuts}`. `base` is
/// the number of panels below overlays, `good` whether it suits the page, `editable` whether it is made of cuts,
/// `adjacent` the pairs of panels with a common edge; for `cuts` see [`Cut::to_value`].
///
/// # Errors
/// `invalid-document`, `unknown-layout`, `invalid-layout`.
pub fn facts(json: &str) -> Result<Value> {
    let Of { layout, page } = parse(json)?;
    page.validate()?;
    let template = template_of(&layout)?;
    let cuts = cuts(&template, page.aspect(), &page);
    Ok(json!({
        "id": template.id(),
        "name": template.name(),
        "family": template.family(),
        "count": template.panels().len(),
        "base": template.base_count(),
        "good": template.good_for(page.aspect()),
        "editable": matches!(template.body(), Body::Tree(_)),
        "adjacent": adjacent(&template),
        "cuts": cuts.iter().map(Cut::to_value).collect::<Vec<_>>(),
    }))
}

/// The template of `{layout, page}` as a file would have it.
///
/// # Errors
/// As [`facts`].
pub fn file(json: &str) -> Result<Value> {
    let Of { layout, .. } = parse(json)?;
    value_of(&*template_of(&layout)?)
}

/// A new template for `{seed, page, least, most}` with so many panels.
///
/// # Errors
/// `invalid-document`.
pub fn generated(json: &str) -> Result<Value> {
    #[derive(Deserialize)]
    struct Wanted {
        seed: u32,
        page: PageSettings,
        least: usize,
        most: usize,
    }
    let Wanted { seed, page, least, most } = parse(json)?;
    page.validate()?;
    value_of(&generate(u64::from(seed), page.aspect(), least..=most))
}

/// The template that the change of `{layout, change}` makes of a layout. A change is one of
/// `{type: "move-cut", cut, fraction, slant}`, `{type: "split", panel, axis: "rows" | "columns"}` and
/// `{type: "remove", panel}`.
///
/// # Errors
/// As [`facts`]; `invalid-layout` for a change that the layout does not allow.
pub fn changed(json: &str) -> Result<Value> {
    #[derive(Deserialize)]
    struct Wanted {
        layout: Value,
        change: Change,
    }
    #[derive(Deserialize)]
    #[serde(tag = "type", rename_all = "kebab-case")]
    enum Change {
        MoveCut { cut: usize, fraction: f64, slant: f64 },
        Split { panel: usize, axis: String },
        Remove { panel: usize },
    }
    let Wanted { layout, change } = parse(json)?;
    let template = template_of(&layout)?;
    let changed = match change {
        Change::MoveCut { cut, fraction, slant } => move_cut(&template, cut, fraction, slant),
        Change::Split { panel, axis } => split_panel(&template, panel, axis_of(&axis)?),
        Change::Remove { panel } => remove_panel(&template, panel),
    };
    value_of(&changed?)
}

#[derive(Deserialize)]
struct Of {
    layout: Value,
    #[serde(default)]
    page: PageSettings,
}

fn axis_of(name: &str) -> Result<Axis> {
    match name {
        "rows" => Ok(Axis::Rows),
        "columns" => Ok(Axis::Columns),
        other => Err(invalid(format!("axis must be rows or columns, not {other}"))),
    }
}

fn entry(template: &Template, own: Option<usize>, aspect: f64) -> Value {
    let page = PageSettings { gutter: PICTURE_GUTTER, margin: PICTURE_MARGIN, ..PageSettings::default() };
    let panels = resolve(template, aspect, &page);
    let path = |overlay: bool| {
        let mut path = String::new();
        panels.iter().filter(|panel| panel.overlay == overlay).for_each(|p| draw(&mut path, &p.shape));
        path
    };
    json!({
        "id": template.id(),
        "name": template.name(),
        "family": template.family(),
        "count": template.panels().len(),
        "own": own,
        "base": path(false),
        "over": path(true),
    })
}

/// Appends a closed SVG path. Writing to a string cannot fail.
fn draw(path: &mut String, shape: &ResolvedShape) {
    match shape {
        ResolvedShape::Polygon(corners) => {
            for (i, p) in corners.iter().enumerate() {
                let letter = if i == 0 { 'M' } else { 'L' };
                let _ = write!(path, "{letter}{} {}", drawn(p.x), drawn(p.y));
            }
            path.push('Z');
        }
        ResolvedShape::Circle { center, radius } => {
            let (left, y, r) = (drawn(center.x - radius), drawn(center.y), drawn(*radius));
            let d = 2 * r;
            let _ = write!(path, "M{left} {y}a{r} {r} 0 1 0 {d} 0a{r} {r} 0 1 0-{d} 0Z");
        }
    }
}

/// A length in page widths as the drawing has it.
fn drawn(length: f64) -> i32 {
    (length * PICTURE).round() as i32
}

fn value_of(template: &Template) -> Result<Value> {
    serde_json::from_str(&template.to_json()).map_err(|error| Error::Encode(error.to_string()))
}

fn parse<T: for<'a> Deserialize<'a>>(json: &str) -> Result<T> {
    serde_json::from_str(json).map_err(|error| invalid(error.to_string()))
}

fn invalid(reason: String) -> Error {
    Error::InvalidDocument { location: "request".into(), reason }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::catalogue;

    fn ask(of: &Value, answer: impl Fn(&str) -> Result<Value>) -> Value {
        answer(&of.to_string()).unwrap()
    }

    #[test]
    fn the_list_has_what_is_good_and_all_that_is_own() {
        let tall = PageSettings { width: 1440, height: 2560, ..PageSettings::default() };
        let own =
            ask(&json!({ "seed": 5, "page": PageSettings::default(), "least": 9, "most": 9 }), generated);
        let answer = ask(&json!({ "page": tall, "own": [own] }), list);
        let entries = answer.as_array().unwrap();
        assert_eq!((&entries[0]["own"], &entries[0]["id"]), (&json!(0), &own["id"]));
        let listed: Vec<&str> = entries[1..].iter().filter_map(|entry| entry["id"].as_str()).collect();
        let good = catalogue().iter().filter(|t| t.good_for(tall.aspect())).map(Template::id);
        assert_eq!(listed, good.collect::<Vec<_>>());
        assert!(listed.len() > 10 && listed.len() < catalogue().len());
        assert!(entries.iter().all(|entry| entry["base"].as_str().is_some_and(|path| path.starts_with('M'))));
        assert!(list(&json!({ "page": tall, "own": [{ "id": 3 }] }).to_string()).is_err());
    }

    #[test]
    fn a_changed_layout_is_a_layout_like_any_other() {
        let cut = json!({ "type": "move-cut", "cut": 0, "fraction": 0.4, "slant": 0.1 });
        let moved = ask(&json!({ "layout": "grid-4", "change": cut }), changed);
        let facts = ask(&json!({ "layout": moved, "page": PageSettings::default() }), facts);
        assert_eq!((&facts["family"], &facts["count"]), (&json!("custom"), &json!(4)));
        assert!((facts["cuts"][0]["fraction"].as_f64().unwrap() - 0.4).abs() < 1e-3);
        assert!((facts["cuts"][0]["slant"].as_f64().unwrap() - 0.1).abs() < 1e-3);
        assert_eq!(ask(&json!({ "layout": moved }), file), moved);
        let split = json!({ "type": "split", "panel": 1, "axis": "rows" });
        let more = ask(&json!({ "layout": moved, "change": split }), changed);
        assert_eq!(ask(&json!({ "layout": more }), super::facts)["count"], json!(5));
        let fewer = ask(&json!({ "layout": more, "change": { "type": "remove", "panel": 0 } }), changed);
        assert_eq!(ask(&json!({ "layout": fewer }), super::facts)["count"], json!(4));
    }

    #[test]
    fn what_cannot_be_done_is_an_error() {
        let code = |of: Value| changed(&of.to_string()).unwrap_err().code();
        let remove = |panel: usize| json!({ "type": "remove", "panel": panel });
        assert_eq!(code(json!({ "layout": "grid-4", "change": remove(9) })), "invalid-layout");
        assert_eq!(code(json!({ "layout": "mosaic-y", "change": remove(0) })), "invalid-layout");
        assert_eq!(code(json!({ "layout": "nope", "change": remove(0) })), "unknown-layout");
        let split = json!({ "type": "split", "panel": 0, "axis": "diagonal" });
        assert_eq!(code(json!({ "layout": "grid-4", "change": split })), "invalid-document");
        assert_eq!(code(json!({ "layout": "grid-4", "change": { "type": "fold" } })), "invalid-document");
    }
}
