//! One state of a project. Which photos are in the tray and used, the locks, the wanted number of panels, and the page.
//! What is known of a photo (its name, size, measures) never changes and lives in the album, so that undoing an edit does
//! not undo what was read meanwhile. States of a history share what they have in common.

use super::limits::{GREATEST_ID, LONGEST_ID, LONGEST_NAME, MOST_BLOCKS, MOST_LOVED, MOST_WANTED};
use crate::json::{Fields, Read, Wrong, flag, list, name, number, text, whole};
use crate::layout::{PageSettings, Template};
use crate::page::Document;
use crate::raster::color::parse_hex;
use crate::style::{Style, blocks};
use serde::Serialize;
use serde_json::{Map, Value};
use std::collections::HashSet;
use std::sync::Arc;

/// A list that states share, of things that lists share.
pub type List<T> = Arc<[Arc<T>]>;

/// A state of a project.
#[derive(Debug, Clone, PartialEq)]
pub struct Project {
    /// What the person calls it, empty until then.
    pub name: String,
    /// The photos, in the order in which they were added.
    pub tray: List<TrayItem>,
    /// Photos whose fingerprints differ in at most so many of 64 bits show the same picture.
    pub alike: u8,
    /// How the photos are ordered.
    pub order: Order,
    /// Parts of the page that no shuffle changes.
    pub locks: Locks,
    /// The wanted number of panels, none for any.
    pub panels: Option<u32>,
    /// Size, gutters and colours.
    pub settings: Arc<PageSettings>,
    /// The page that is edited; none while there is none.
    pub page: Option<Arc<Document>>,
    /// Names the page among those shown.
    pub page_id: u64,
    /// Names its place in the storyboard through all its versions.
    pub sheet: u64,
    /// The other pages of the storyboard, in order.
    pub others: List<Sheet>,
    /// How many of these come before the page.
    pub at: usize,
    /// The style in the designer.
    pub draft: Option<Arc<Draft>>,
    /// A person's own styles, which all projects share.
    pub mine: List<Value>,
    /// Styles that are favourites, which all projects share.
    pub favourites: List<Value>,
    /// A person's own layouts, which all projects share.
    pub own_layouts: List<Value>,
    /// The favourites among the pages shown, by their ids.
    pub loved: Arc<[u64]>,
    /// How a shuffle draws styles.
    pub styling: Styling,
    /// Fields that this program does not know, kept for one that does.
    pub rest: Map<String, Value>,
}

/// A photo in the tray.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TrayItem {
    /// Its id.
    pub id: String,
    /// What the person chose; none follows the selection's verdict.
    #[serde(rename = "use")]
    pub used: Option<bool>,
    /// The point of it that matters, where a person marked one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub focus: Option<Focus>,
    /// Fields that this program does not know.
    #[serde(flatten)]
    pub rest: Map<String, Value>,
}

/// A point of a photo, in parts of it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Focus {
    /// From the left.
    pub x: f64,
    /// From the top.
    pub y: f64,
}

/// The order of photos.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Order {
    /// As they were taken, where all say so.
    #[default]
    Time,
    /// As their files are called.
    Name,
}

/// Parts of the page that no shuffle changes.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Locks {
    /// The layout.
    pub layout: bool,
    /// The style.
    pub style: bool,
    /// The photos.
    pub photos: bool,
    /// Fields that this program does not know.
    #[serde(flatten)]
    pub rest: Map<String, Value>,
}

/// How a shuffle draws a style.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Styling {
    /// The share of invented ones, 0 to 1.
    pub invented: f64,
    /// The line layer stays.
    pub keep_lines: bool,
    /// The colour layer stays.
    pub keep_colours: bool,
    /// Fields that this program does not know.
    #[serde(flatten)]
    pub rest: Map<String, Value>,
}

/// A page of a storyboard.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// The page.
    pub page: Arc<Document>,
    /// Names the version.
    pub page_id: u64,
    /// Names its place through all its versions.
    pub sheet: u64,
    /// Fields that this program does not know.
    pub rest: Map<String, Value>,
}

/// A style while it is designed. Every block has a key, so that its card stays the same card wherever it is moved, and all
/// of its values.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Draft {
    /// Id of the style.
    pub id: String,
    /// What people call it.
    pub name: String,
    /// Families that it belongs to.
    pub tags: Vec<String>,
    /// The colour layer.
    pub background: Vec<DraftStep>,
    /// The line layer.
    pub foreground: Vec<DraftStep>,
    /// Colour of the lines, `#rrggbb`.
    pub ink: String,
    /// Fields that this program does not know.
    #[serde(flatten)]
    pub rest: Map<String, Value>,
}

/// A block of a draft.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DraftStep {
    /// Names it within the draft.
    pub key: u64,
    /// What runs.
    pub block: String,
    /// Its values by the ids of the parameters.
    pub values: Map<String, Value>,
    /// Left out of the chain.
    pub bypass: bool,
    /// Fields that this program does not know.
    #[serde(flatten)]
    pub rest: Map<String, Value>,
}

impl Default for Project {
    fn default() -> Self {
        Self {
            name: String::new(),
            tray: Arc::new([]),
            alike: 10,
            order: Order::Time,
            locks: Locks::default(),
            panels: None,
            settings: Arc::default(),
            page: None,
            page_id: 0,
            sheet: 0,
            others: Arc::new([]),
            at: 0,
            draft: None,
            mine: Arc::new([]),
            favourites: Arc::new([]),
            own_layouts: Arc::new([]),
            loved: Arc::new([]),
            styling: Styling::default(),
            rest: Map::new(),
        }
    }
}

/// Where the parts of a state come from that other states may share: they stand in it, or in tables beside it.
pub(super) trait Parts {
    fn tray(&mut self, value: Value) -> Read<List<TrayItem>>;
    fn settings(&mut self, value: Value) -> Read<Arc<PageSettings>>;
    fn page(&mut self, value: Value) -> Read<Arc<Document>>;
    fn sheets(&mut self, value: Value) -> Read<List<Sheet>>;
    fn draft(&mut self, value: Value) -> Read<Arc<Draft>>;
    /// `field` is the list's name, for what is left out of it.
    fn styles(&mut self, value: Value, field: &str) -> Read<List<Value>>;
    fn layouts(&mut self, value: Value, field: &str) -> Read<List<Value>>;
}

impl Project {
    /// Reads a state; what is missing is as in an empty project.
    ///
    /// # Errors
    /// With the place of what is wrong.
    pub(super) fn read(value: Value, parts: &mut impl Parts) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let usual = Self::default();
        let mut count = |name: &str| Ok(fields.read(name, whole(0..=GREATEST_ID))?.unwrap_or_default());
        let (page_id, sheet, at) = (count("pageId")?, count("sheet")?, count("at")?);
        let loved = fields.read("loved", list(MOST_LOVED, whole(0..=GREATEST_ID)))?.unwrap_or_default();
        let wanted = fields.nullable("panels", whole(1..=MOST_WANTED))?;
        let project = Self {
            name: fields.read("name", text(LONGEST_NAME))?.unwrap_or_default(),
            tray: fields.read("tray", |value| parts.tray(value))?.unwrap_or(usual.tray),
            alike: fields.read("alike", whole(0..=64))?.map_or(usual.alike, |bits| bits as u8),
            order: fields.read("order", order)?.unwrap_or_default(),
            locks: fields.read("locks", locks)?.unwrap_or_default(),
            panels: wanted.map(|panels| panels as u32),
            settings: fields.read("settings", |value| parts.settings(value))?.unwrap_or(usual.settings),
            page: fields.nullable("page", |value| parts.page(value))?,
            page_id,
            sheet,
            others: fields.read("others", |value| parts.sheets(value))?.unwrap_or(usual.others),
            at: at as usize,
            draft: fields.nullable("draft", |value| parts.draft(value))?,
            mine: fields.read("mine", |value| parts.styles(value, "mine"))?.unwrap_or(usual.mine),
            favourites: fields
                .read("favourites", |value| parts.styles(value, "favourites"))?
                .unwrap_or(usual.favourites),
            own_layouts: fields
                .read("ownLayouts", |value| parts.layouts(value, "ownLayouts"))?
                .unwrap_or(usual.own_layouts),
            loved: loved.into(),
            styling: fields.read("styling", styling)?.unwrap_or_default(),
            rest: fields.rest(),
        };
        project.check_sheets()?;
        Ok(project)
    }

    fn check_sheets(&self) -> Read<()> {
        if self.at > self.others.len() || (self.page.is_none() && !self.others.is_empty()) {
            return Err(Wrong::new("is no place among the pages").at("at"));
        }
        let mut seen = HashSet::from([self.sheet]);
        for (i, other) in self.others.iter().enumerate() {
            if !seen.insert(other.sheet) {
                return Err(Wrong::new("is that of another page").at("sheet").in_list(i).at("others"));
            }
        }
        Ok(())
    }
}

/// The photos of the tray. One that is there twice counts once.
pub(super) fn tray(items: impl IntoIterator<Item = Arc<TrayItem>>) -> List<TrayItem> {
    let mut seen = HashSet::new();
    items.into_iter().filter(|item| seen.insert(item.id.clone())).collect()
}

/// A style of one's own: a style file with an id.
pub(super) fn style(value: Value) -> Read<Value> {
    identified(&value)?;
    Style::from_value("style", &value).map_err(Wrong::of)?;
    Ok(value)
}

/// A layout of one's own.
pub(super) fn layout(value: Value) -> Read<Value> {
    identified(&value)?;
    Template::from_value("layout", &value).map_err(Wrong::of)?;
    Ok(value)
}

fn identified(value: &Value) -> Read<()> {
    if value["id"].is_string() { Ok(()) } else { Err(Wrong::new("is missing").at("id")) }
}

pub(super) fn tray_item(value: Value) -> Read<TrayItem> {
    let mut fields = Fields::of(value)?;
    let id = name(LONGEST_ID)(fields.required("id")?).map_err(|wrong| wrong.at("id"))?;
    let used = fields.nullable("use", flag)?;
    let focus = fields.nullable("focus", focus)?;
    Ok(TrayItem { id, used, focus, rest: fields.rest() })
}

fn focus(value: Value) -> Read<Focus> {
    let mut fields = Fields::of(value)?;
    let mut part = |name: &str| number(-1.0..=2.0)(fields.required(name)?).map_err(|wrong| wrong.at(name));
    let focus = Focus { x: part("x")?, y: part("y")? };
    fields.done()?;
    Ok(focus)
}

/// A page of a storyboard, whose document comes from elsewhere.
pub(super) fn sheet(value: Value, page: impl FnOnce(Value) -> Read<Arc<Document>>) -> Read<Sheet> {
    let mut fields = Fields::of(value)?;
    let page = page(fields.required("page")?).map_err(|wrong| wrong.at("page"))?;
    let mut id = |name: &str| whole(0..=GREATEST_ID)(fields.required(name)?).map_err(|wrong| wrong.at(name));
    Ok(Sheet { page, page_id: id("pageId")?, sheet: id("sheet")?, rest: fields.rest() })
}

#[allow(clippy::needless_pass_by_value, reason = "readers take values")]
fn order(value: Value) -> Read<Order> {
    match value.as_str() {
        Some("time") => Ok(Order::Time),
        Some("name") => Ok(Order::Name),
        _ => Err(Wrong::new("is none of time, name")),
    }
}

fn locks(value: Value) -> Read<Locks> {
    let mut fields = Fields::of(value)?;
    let mut lock = |name: &str| Ok(fields.read(name, flag)?.unwrap_or_default());
    let (layout, style, photos) = (lock("layout")?, lock("style")?, lock("photos")?);
    Ok(Locks { layout, style, photos, rest: fields.rest() })
}

fn styling(value: Value) -> Read<Styling> {
    let mut fields = Fields::of(value)?;
    Ok(Styling {
        invented: fields.read("invented", number(0.0..=1.0))?.unwrap_or_default(),
        keep_lines: fields.read("keepLines", flag)?.unwrap_or_default(),
        keep_colours: fields.read("keepColours", flag)?.unwrap_or_default(),
        rest: fields.rest(),
    })
}

pub(super) fn draft(value: Value) -> Read<Draft> {
    let mut fields = Fields::of(value)?;
    let mut layer = |name: &str| Ok(fields.read(name, list(MOST_BLOCKS, draft_step))?.unwrap_or_default());
    let (background, foreground) = (layer("background")?, layer("foreground")?);
    Ok(Draft {
        id: name(LONGEST_ID)(fields.required("id")?).map_err(|wrong| wrong.at("id"))?,
        name: fields.read("name", text(LONGEST_NAME))?.unwrap_or_default(),
        tags: fields.read("tags", list(20, text(LONGEST_NAME)))?.unwrap_or_default(),
        background,
        foreground,
        ink: fields.read("ink", ink)?.unwrap_or_else(|| "#000000".into()),
        rest: fields.rest(),
    })
}

fn ink(value: Value) -> Read<String> {
    let ink = text(7)(value)?;
    if parse_hex(&ink).is_some() { Ok(ink) } else { Err(Wrong::new("is no colour like #101014")) }
}

fn draft_step(value: Value) -> Read<DraftStep> {
    let mut fields = Fields::of(value)?;
    let id = name(LONGEST_ID)(fields.required("block")?).map_err(|wrong| wrong.at("block"))?;
    let block = blocks::find(&id).ok_or_else(|| Wrong::new("is no block that there is").at("block"))?;
    let values = fields.read("values", |value| match value {
        Value::Object(values) => Ok(values),
        _ => Err(Wrong::new("is no object")),
    })?;
    let values = values.unwrap_or_default();
    for (name, value) in &values {
        let param = block.params.iter().find(|param| param.id == name);
        let good = param.ok_or_else(|| "is no parameter of this block".to_owned());
        good.and_then(|param| param.value_from_json(value))
            .map_err(|reason| Wrong::new(reason).at(name).at("values"))?;
    }
    Ok(DraftStep {
        key: whole(0..=GREATEST_ID)(fields.required("key")?).map_err(|wrong| wrong.at("key"))?,
        block: id,
        values,
        bypass: fields.read("bypass", flag)?.unwrap_or_default(),
        rest: fields.rest(),
    })
}
