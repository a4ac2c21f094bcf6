//! Layout functions for the app, as JSON: the list with thumbnails, properties of one layout, a generated
//! layout, and manual changes.

use super::reference::LayoutRef;
use crate::error::{Error, Result};
use crate::layout::edit::{Cut, cuts};
use crate::layout::{
    Body, PageSettings, PlacedPanel, ResolvedPanel, ResolvedShape, Template, generate, good_for,
    reading_order, resolve,
};
use serde::{Deserialize, Serialize};
use std::fmt::Write as _;

/// Width of a drawn template, large enough for whole numbers. The height follows the page.
const PICTURE: f64 = 1000.0;
/// Gutter and margin of a drawn template, in page widths: wide enough to be seen at the size of a thumbnail.
const PICTURE_GUTTER: f64 = 0.05;
const PICTURE_MARGIN: f64 = 0.05;

/// Request of the list of layouts.
#[derive(Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct LayoutsRequest {
    /// The page that they are for.
    page: PageSettings,
    /// Whether it is a custom layout.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<Vec<Template>>", optional))]
    own: Vec<LayoutRef>,
}

/// A layout in the list.
#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct LayoutEntry<'a> {
    /// Unique name in kebab-case.
    pub id: &'a str,
    /// Display name.
    pub name: &'a str,
    /// Its family.
    pub family: &'a str,
    /// Panels.
    pub count: usize,
    /// Index among the custom layouts; null for a built-in layout.
    pub own: Option<usize>,
    /// Its panels as an SVG path on a page 1000 wide.
    pub base: String,
    /// Its overlays likewise.
    pub over: String,
}

/// Possible changes of a layout on a page.
#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct LayoutFacts<'a> {
    /// Unique name in kebab-case.
    pub id: &'a str,
    /// Display name.
    pub name: &'a str,
    /// Its family.
    pub family: &'a str,
    /// Panels.
    pub count: usize,
    /// Panels below overlays.
    pub base: usize,
    /// It suits the page.
    pub good: bool,
    /// It is made of cuts.
    pub editable: bool,
    /// The cuts between panels.
    pub cuts: Vec<Cut>,
}

/// Panels on a page of width 1, with gutters and margins.
#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Geometry<'a> {
    /// 1.
    pub width: f64,
    /// Height over width.
    pub height: f64,
    /// In the order in which they are painted.
    pub panels: Vec<PlacedPanel<'a>>,
    /// The numbers of the panels in reading order.
    pub order: Vec<usize>,
}

/// Returns the layouts for a `LayoutsRequest` as a list of [`LayoutEntry`]: custom layouts, and built-in
/// layouts that are good for the page.
///
/// # Errors
/// `invalid-document`, and `invalid-layout` for an invalid custom layout.
pub fn list(json: &str) -> Result<String> {
    let LayoutsRequest { page, own } = parse(json)?;
    page.validate()?;
    let aspect = page.aspect();
    let own = own.iter().map(LayoutRef::template).collect::<Result<Vec<_>>>()?;
    let own = own.iter().enumerate().map(|(i, template)| entry(template, Some(i), aspect));
    let good = good_for(aspect);
    let good = good.iter().map(|template| entry(template, None, aspect));
    text_of(&own.chain(good).collect::<Vec<_>>())
}

/// The [`Geometry`] of `{layout, page}`.
///
/// # Errors
/// As [`facts`].
pub fn geometry(json: &str) -> Result<String> {
    let Of { layout, page } = parse(json)?;
    page.validate()?;
    let panels = resolve(&*layout.template()?, page.aspect(), &page);
    let order = reading_order(&panels, page.rtl);
    let panels = panels.iter().map(ResolvedPanel::placed).collect();
    text_of(&Geometry { width: 1.0, height: 1.0 / page.aspect(), panels, order })
}

/// The [`LayoutFacts`] of `{layout, page}`.
///
/// # Errors
/// `invalid-document`, `unknown-layout`, `invalid-layout`.
pub fn facts(json: &str) -> Result<String> {
    let Of { layout, page } = parse(json)?;
    page.validate()?;
    let template = layout.template()?;
    text_of(&LayoutFacts {
        id: template.id(),
        name: template.name(),
        family: template.family(),
        count: template.panels().len(),
        base: template.base_count(),
        good: template.good_for(page.aspect()),
        editable: matches!(template.body(), Body::Tree(_)),
        cuts: cuts(&template, page.aspect(), &page),
    })
}

/// The template of `{layout, page}` as a file would have it.
///
/// # Errors
/// As [`facts`].
pub fn file(json: &str) -> Result<String> {
    let Of { layout, .. } = parse(json)?;
    Ok(layout.template()?.to_json())
}

/// Requirements of a generated layout.
#[derive(Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct GenerateRequest {
    /// Random seed.
    seed: u32,
    /// The page that it is for.
    page: PageSettings,
    /// Panels at least,
    least: usize,
    /// and at most.
    most: usize,
}

/// A new template for a `GenerateRequest`.
///
/// # Errors
/// `invalid-document`.
pub fn generated(json: &str) -> Result<String> {
    let GenerateRequest { seed, page, least, most } = parse(json)?;
    page.validate()?;
    Ok(generate(u64::from(seed), page.aspect(), least..=most).to_json())
}

#[derive(Deserialize)]
struct Of {
    layout: LayoutRef,
    #[serde(default)]
    page: PageSettings,
}

fn entry(template: &Template, own: Option<usize>, aspect: f64) -> LayoutEntry<'_> {
    let page = PageSettings { gutter: PICTURE_GUTTER, margin: PICTURE_MARGIN, ..PageSettings::default() };
    let panels = resolve(template, aspect, &page);
    let path = |overlay: bool| {
        let mut path = String::new();
        panels.iter().filter(|panel| panel.overlay == overlay).for_each(|p| draw(&mut path, &p.shape));
        path
    };
    LayoutEntry {
        id: template.id(),
        name: template.name(),
        family: template.family(),
        count: template.panels().len(),
        own,
        base: path(false),
        over: path(true),
    }
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

fn text_of(answer: &impl Serialize) -> Result<String> {
    serde_json::to_string(answer).map_err(|error| Error::Encode(error.to_string()))
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
    use crate::layout::{LayoutChange, catalogue};
    use serde_json::{Value, json};

    fn ask(of: &Value, answer: impl Fn(&str) -> Result<String>) -> Value {
        serde_json::from_str(&answer(&of.to_string()).unwrap()).unwrap()
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

    fn changed(layout: &Value, change: Value) -> Result<Value> {
        let layout: LayoutRef = serde_json::from_value(layout.clone()).unwrap();
        let change: LayoutChange = serde_json::from_value(change).unwrap();
        let made = change.of(&*layout.template()?, &PageSettings::default())?;
        Ok(serde_json::from_str(&made.to_json()).unwrap())
    }

    #[test]
    fn a_changed_layout_is_a_layout_like_any_other() {
        let cut = json!({ "type": "move-cut", "cut": 0, "fraction": 0.4, "slant": 0.1 });
        let moved = changed(&json!("grid-4"), cut).unwrap();
        let facts = ask(&json!({ "layout": moved, "page": PageSettings::default() }), facts);
        assert_eq!((&facts["family"], &facts["count"]), (&json!("custom"), &json!(4)));
        assert!((facts["cuts"][0]["fraction"].as_f64().unwrap() - 0.4).abs() < 1e-3);
        assert!((facts["cuts"][0]["slant"].as_f64().unwrap() - 0.1).abs() < 1e-3);
        assert_eq!(ask(&json!({ "layout": moved }), file), moved);
        let more = changed(&moved, json!({ "type": "split", "panel": 1, "axis": "rows" })).unwrap();
        assert_eq!(ask(&json!({ "layout": more }), super::facts)["count"], json!(5));
        let fewer = changed(&more, json!({ "type": "remove", "panel": 0 })).unwrap();
        assert_eq!(ask(&json!({ "layout": fewer }), super::facts)["count"], json!(4));
    }

    #[test]
    fn what_cannot_be_done_is_an_error() {
        let code = |layout: &str, panel: usize| {
            changed(&json!(layout), json!({ "type": "remove", "panel": panel })).unwrap_err().code()
        };
        assert_eq!(code("grid-4", 9), "invalid-layout");
        assert_eq!(code("mosaic-y", 0), "invalid-layout");
        assert_eq!(code("nope", 0), "unknown-layout");
        for bad in [json!({ "type": "split", "panel": 0, "axis": "diagonal" }), json!({ "type": "fold" })] {
            assert!(serde_json::from_value::<LayoutChange>(bad).is_err());
        }
    }
}
