//! One state of a project. Photos of the tray and their use, the locks, the number of panels, and the page.
//! Properties of a photo (its name, size, measurements) never change and are stored in the album, so undo
//! does not affect them. States of a history share equal parts.

use super::draft::Draft;
use super::limits::{DUPLICATE_THRESHOLD, GREATEST_ID, LONGEST_ID, LONGEST_NAME, MOST_LOVED, MOST_WANTED};
use super::shots::{Board, Shot};
use crate::json::{Fields, Read, Writer, Wrong, fields};
use crate::layout::PageSettings;
use crate::page::Document;
use crate::raster::Matte;
use crate::raster::matte::MOST_TEXT as LONGEST_MASK;
use crate::reference::CustomFile;
use crate::text::TextItem;
use serde_json::{Map, Value};
use std::collections::HashSet;
use std::sync::Arc;

/// The share of invented styles that a new project begins with.
const INVENTED: f64 = 0.15;

/// A list that states share, of things that lists share.
pub type List<T> = Arc<[Arc<T>]>;

/// A state of a project.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Project {
    /// Project name, empty until the user sets it.
    pub name: String,
    /// The photos, in the order in which they were added.
    pub tray: List<TrayItem>,
    /// Maximum fingerprint distance of near-duplicates, in bits of 64.
    pub alike: u8,
    /// How the photos are ordered.
    pub order: Order,
    /// Parts of the page that no shuffle changes.
    pub locks: Locks,
    /// Wanted number of panels; `None` for any.
    pub panels: Option<u32>,
    /// Size, gutters and colours.
    pub settings: Arc<PageSettings>,
    /// The pages of the storyboard, and which one is edited.
    #[cfg_attr(feature = "typescript", ts(flatten))]
    pub pages: Pages,
    /// The style in the designer.
    pub draft: Option<Arc<Draft>>,
    /// Unplaced text items. They return with their photos.
    #[cfg_attr(feature = "typescript", ts(type = "ReadonlyArray<Word>", optional))]
    pub waiting: List<TextItem>,
    /// Custom styles, which all projects share.
    #[cfg_attr(feature = "typescript", ts(as = "Vec<crate::style::Style>"))]
    pub mine: List<CustomFile>,
    /// Styles that are favourites, which all projects share.
    #[cfg_attr(feature = "typescript", ts(as = "Vec<crate::style::Style>"))]
    pub favourites: List<CustomFile>,
    /// Custom layouts, which all projects share.
    #[cfg_attr(feature = "typescript", ts(as = "Vec<crate::layout::Template>"))]
    pub own_layouts: List<CustomFile>,
    /// Favourite pages of the page history, by id.
    pub loved: Arc<[u64]>,
    /// How a shuffle draws styles.
    pub styling: Styling,
    /// Settings of the storyboard: frame rate, order and sheets. Not written if they equal the defaults.
    #[cfg_attr(feature = "typescript", ts(as = "Option<Board>", optional = nullable))]
    pub board: Arc<Board>,
    /// Unknown fields, preserved for newer programs.
    #[cfg_attr(feature = "typescript", ts(skip))]
    pub rest: Map<String, Value>,
}

/// A photo in the tray.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct TrayItem {
    /// Its id.
    pub id: String,
    /// The user's choice; `None` follows the selection.
    #[cfg_attr(feature = "typescript", ts(rename = "use"))]
    pub used: Option<bool>,
    /// The focus point that the user set.
    #[cfg_attr(feature = "typescript", ts(optional = nullable))]
    pub focus: Option<Focus>,
    /// Whether the user starred it for a large panel.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub starred: bool,
    /// The corrected subject mask. `None` uses the detected mask.
    #[cfg_attr(feature = "typescript", ts(type = "string", optional))]
    pub mask: Option<Matte>,
    /// Shot metadata.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub shot: Shot,
    /// Unknown fields, preserved for newer programs.
    #[cfg_attr(feature = "typescript", ts(skip))]
    pub rest: Map<String, Value>,
}

/// A point of a photo, in fractions of its sides.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Focus {
    /// From the left.
    pub x: f64,
    /// From the top.
    pub y: f64,
}

/// The order of photos.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename_all = "lowercase"))]
pub enum Order {
    /// By capture time, if all photos have one.
    #[default]
    Time,
    /// As their files are called.
    Name,
}

/// Parts of the page that no shuffle changes.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Locks {
    /// The layout.
    pub layout: bool,
    /// The style.
    pub style: bool,
    /// The photos.
    pub photos: bool,
    /// Unknown fields, preserved for newer programs.
    #[cfg_attr(feature = "typescript", ts(skip))]
    pub rest: Map<String, Value>,
}

/// How a shuffle draws a style.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Styling {
    /// The share of invented ones, 0 to 1.
    pub invented: f64,
    /// The line layer stays.
    pub keep_lines: bool,
    /// The colour layer stays.
    pub keep_colours: bool,
    /// Unknown fields, preserved for newer programs.
    #[cfg_attr(feature = "typescript", ts(skip))]
    pub rest: Map<String, Value>,
}

impl Default for Styling {
    fn default() -> Self {
        Self { invented: INVENTED, keep_lines: false, keep_colours: false, rest: Map::new() }
    }
}

/// A page of a storyboard.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Sheet {
    /// The page.
    pub page: Arc<Document>,
    /// Names the version.
    pub page_id: u64,
    /// Names its place through all its versions.
    pub sheet: u64,
    /// Unknown fields, preserved for newer programs.
    #[cfg_attr(feature = "typescript", ts(skip))]
    pub rest: Map<String, Value>,
}

/// The pages of a storyboard in reading order, and which one is edited.
///
/// In JSON, the edited page is the fields `page`, `pageId` and `sheet` of the project. `others` has the other
/// pages, and `at` is the index of the edited page among all pages.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Pages {
    list: List<Sheet>,
    /// Index of the edited page; 0 without pages.
    active: usize,
    /// Without pages: page id and sheet of the last edited page. The next page continues its versions.
    left: (u64, u64),
}

/// The fields of [`Pages`] in JSON.
#[cfg(feature = "typescript")]
#[derive(ts_rs::TS)]
#[ts(rename_all = "camelCase")]
#[expect(dead_code, reason = "describes JSON")]
struct InJson {
    /// The page that is edited; `None` without pages.
    page: Option<Arc<Document>>,
    /// Id of the page in the page history.
    page_id: u64,
    /// Names its place in the storyboard through all its versions.
    sheet: u64,
    /// The other pages of the storyboard, in order.
    others: List<Sheet>,
    /// Number of pages before the current page.
    at: usize,
}

#[cfg(feature = "typescript")]
impl ts_rs::TS for Pages {
    type WithoutGenerics = Self;
    type OptionInnerType = Self;

    fn name(cfg: &ts_rs::Config) -> String {
        InJson::name(cfg)
    }

    fn inline(cfg: &ts_rs::Config) -> String {
        InJson::inline(cfg)
    }

    fn inline_flattened(cfg: &ts_rs::Config) -> String {
        InJson::inline_flattened(cfg)
    }
}

impl Pages {
    /// The pages with the page at index `active` edited. `None` if `active` is out of range.
    #[must_use]
    pub fn new(pages: Vec<Arc<Sheet>>, active: usize) -> Option<Self> {
        (active < pages.len()).then(|| Self { list: pages.into(), active, left: (0, 0) })
    }

    /// Reads the pages from the fields of a project.
    ///
    /// # Errors
    /// Returns the location of the error.
    fn read(fields: &mut Fields, parts: &mut dyn Parts) -> Read<Self> {
        let mut id = |name: &str| Ok(fields.whole(name, 0, GREATEST_ID)?.unwrap_or_default());
        let (page_id, sheet, active) = (id("pageId")?, id("sheet")?, id("at")? as usize);
        let others = fields.part("others", &mut |value| parts.sheets(value))?.unwrap_or_default();
        let page = fields.nullable("page").part("page", &mut |value| parts.page(value))?;
        if active > others.len() || (page.is_none() && !others.is_empty()) {
            return Err(Wrong::new("is not the index of a page").at("at"));
        }
        let mut seen = HashSet::from([sheet]);
        if let Some(i) = others.iter().position(|other| !seen.insert(other.sheet)) {
            return Err(Wrong::new("is a duplicate page").at("sheet").in_list(i).at("others"));
        }
        let Some(page) = page else { return Ok(Self { left: (page_id, sheet), ..Self::default() }) };
        let mut list = others.to_vec();
        list.insert(active, Arc::new(Sheet { page, page_id, sheet, rest: Map::new() }));
        Ok(Self { list: list.into(), active, left: (0, 0) })
    }

    /// All pages in reading order.
    #[must_use]
    pub fn list(&self) -> &[Arc<Sheet>] {
        &self.list
    }

    /// Index of the edited page; 0 without pages.
    #[must_use]
    pub fn active(&self) -> usize {
        self.active
    }

    /// The edited page; `None` without pages.
    #[must_use]
    pub fn edited(&self) -> Option<&Arc<Sheet>> {
        self.list.get(self.active)
    }

    /// Page id and sheet of the edited page. Without pages, those of the last edited page.
    pub(crate) fn ids(&self) -> (u64, u64) {
        self.edited().map_or(self.left, |sheet| (sheet.page_id, sheet.sheet))
    }

    /// Removes all pages.
    pub(crate) fn clear(&mut self) {
        *self = Self { left: self.ids(), ..Self::default() };
    }

    /// The pages that are not edited, in reading order.
    pub fn others(&self) -> impl Iterator<Item = &Arc<Sheet>> {
        self.list.iter().enumerate().filter(|(i, _)| *i != self.active).map(|(_, sheet)| sheet)
    }

    /// Replaces the document of the edited page, or adds a first page.
    pub(crate) fn replace(&mut self, page: Arc<Document>) {
        let (page_id, sheet) = self.ids();
        let rest = self.edited().map(|sheet| sheet.rest.clone()).unwrap_or_default();
        self.replace_sheet(Sheet { page, page_id, sheet, rest });
    }

    /// Replaces the edited page, or adds a first page.
    pub(crate) fn replace_sheet(&mut self, sheet: Sheet) {
        let mut list = self.list.to_vec();
        list.splice(self.active..(self.active + 1).min(list.len()), [Arc::new(sheet)]);
        (self.list, self.left) = (list.into(), (0, 0));
    }

    /// Changes the pages for which `change` returns a new one. It gets the index of each page.
    pub(crate) fn each(&mut self, change: &mut Change<'_>) {
        let mut changed = false;
        let mut list = self.list.to_vec();
        for (i, sheet) in list.iter_mut().enumerate() {
            if let Some(page) = change(i, &sheet.page) {
                *sheet = Arc::new(Sheet { page, ..Sheet::clone(sheet) });
                changed = true;
            }
        }
        if changed {
            self.list = list.into();
        }
    }
}

/// Changes the page with that index. `None` leaves it unchanged.
type Change<'c> = dyn FnMut(usize, &Arc<Document>) -> Option<Arc<Document>> + 'c;

impl Default for Project {
    fn default() -> Self {
        Self {
            name: String::new(),
            tray: Arc::new([]),
            alike: DUPLICATE_THRESHOLD as u8,
            order: Order::Time,
            locks: Locks::default(),
            panels: None,
            // People look at most comics on screens.
            settings: Arc::new(PageSettings { for_screens: true, ..PageSettings::default() }),
            pages: Pages::default(),
            draft: None,
            waiting: Arc::new([]),
            mine: Arc::new([]),
            favourites: Arc::new([]),
            own_layouts: Arc::new([]),
            loved: Arc::new([]),
            styling: Styling::default(),
            board: Arc::default(),
            rest: Map::new(),
        }
    }
}

/// Source of state parts that several states may share: inside the state, or in tables next to it. `field` is
/// the name of a list in reports of dropped parts.
pub(crate) trait Parts {
    fn tray(&mut self, value: Value) -> Read<List<TrayItem>>;
    fn settings(&mut self, value: Value) -> Read<Arc<PageSettings>>;
    fn page(&mut self, value: Value) -> Read<Arc<Document>>;
    fn sheets(&mut self, value: Value) -> Read<List<Sheet>>;
    fn draft(&mut self, value: Value) -> Read<Arc<Draft>>;
    fn board(&mut self, value: Value) -> Read<Arc<Board>>;
    fn waiting(&mut self, value: Value) -> Read<List<TextItem>>;
    fn styles(&mut self, value: Value, field: &str) -> Read<List<CustomFile>>;
    fn layouts(&mut self, value: Value, field: &str) -> Read<List<CustomFile>>;
}

impl Project {
    /// Reads a state. Missing fields have the defaults of an empty project.
    ///
    /// # Errors
    /// Returns the location of the error.
    pub(crate) fn read(value: Value, parts: &mut dyn Parts) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let mut state = Self::default();
        if let Some(name) = fields.text("name", LONGEST_NAME)? {
            state.name = name;
        }
        if let Some(bits) = fields.whole("alike", 0, 64)? {
            state.alike = bits as u8;
        }
        state.order = fields.part("order", &mut |order| Order::read(&order))?.unwrap_or_default();
        state.panels = fields.nullable("panels").whole("panels", 1, MOST_WANTED)?.map(|panels| panels as u32);
        let id = |id| fields::whole_of(&id, 0, GREATEST_ID);
        state.loved = fields.each("loved", MOST_LOVED, &id)?.into();
        if let Some(tray) = fields.part("tray", &mut |value| parts.tray(value))? {
            state.tray = tray;
        }
        if let Some(settings) = fields.part("settings", &mut |value| parts.settings(value))? {
            state.settings = settings;
        }
        // Older programs may have dropped the table of unplaced text.
        let waiting = fields.take("waiting").and_then(|value| parts.waiting(value).ok());
        state.waiting = waiting.unwrap_or_else(|| Arc::new([]));
        if let Some(mine) = fields.part("mine", &mut |value| parts.styles(value, "mine"))? {
            state.mine = mine;
        }
        if let Some(favourites) = fields.part("favourites", &mut |value| parts.styles(value, "favourites"))? {
            state.favourites = favourites;
        }
        if let Some(own_layouts) =
            fields.part("ownLayouts", &mut |value| parts.layouts(value, "ownLayouts"))?
        {
            state.own_layouts = own_layouts;
        }
        if let Some(locks) = fields.part("locks", &mut locks)? {
            state.locks = locks;
        }
        if let Some(styling) = fields.part("styling", &mut styling)? {
            state.styling = styling;
        }
        if let Some(board) = fields.nullable("board").part("board", &mut |value| parts.board(value))? {
            state.board = board;
        }
        state.pages = Pages::read(&mut fields, parts)?;
        state.draft = fields.nullable("draft").part("draft", &mut |value| parts.draft(value))?;
        state.rest = fields.rest();
        Ok(state)
    }
}

/// The photos of the tray. One that is there twice counts once.
pub(crate) fn tray(mut items: Vec<Arc<TrayItem>>) -> List<TrayItem> {
    let mut seen = HashSet::new();
    items.retain(|item| seen.insert(item.id.clone()));
    items.into()
}

impl Order {
    pub(crate) fn read(value: &Value) -> Read<Self> {
        match value.as_str() {
            Some("time") => Ok(Self::Time),
            Some("name") => Ok(Self::Name),
            _ => Err(Wrong::new("must be one of time, name")),
        }
    }
}

impl Project {
    /// The corrected mask of a photo; `None` if the detected mask counts.
    #[must_use]
    pub fn corrected_mask(&self, photo: &str) -> Option<&Matte> {
        self.tray.iter().find(|item| item.id == photo)?.mask.as_ref()
    }
}

impl TrayItem {
    /// A photo with default settings.
    #[must_use]
    pub fn new(id: String) -> Self {
        Self {
            id,
            used: None,
            focus: None,
            starred: false,
            mask: None,
            shot: Shot::default(),
            rest: Map::new(),
        }
    }

    pub(crate) fn read(value: Value) -> Read<Arc<Self>> {
        let mut fields = Fields::of(value)?;
        let id = fields.name("id", LONGEST_ID)?;
        let used = match fields.told("use") {
            None => None,
            Some(Value::Bool(used)) => Some(used),
            Some(_) => return Err(Wrong::new("must be true or false").at("use")),
        };
        let focus = fields.nullable("focus").part("focus", &mut focus)?;
        let starred = fields.flag("starred")?;
        // An invalid mask counts as missing, so that the photo is not lost.
        let mask = fields.take("mask").and_then(|text| self::mask(text).ok());
        let shot = fields.nullable("shot").part("shot", &mut Shot::read)?.unwrap_or_default();
        Ok(Arc::new(Self { id, used, focus, starred, mask, shot, rest: fields.rest() }))
    }

    pub(crate) fn write(&self, out: &mut Writer) {
        out.open(b'{');
        out.key("id").text(&self.id);
        match self.used {
            Some(used) => out.key("use").flag(used),
            None => out.key("use").null(),
        }
        if let Some(Focus { x, y }) = self.focus {
            out.key("focus").open(b'{');
            out.key("x").number(x);
            out.key("y").number(y);
            out.close(b'}');
        }
        if self.starred {
            out.key("starred").flag(true);
        }
        if let Some(mask) = &self.mask {
            out.key("mask").text(mask.text());
        }
        if !self.shot.is_empty() {
            self.shot.write(out.key("shot"));
        }
        out.rest(&self.rest);
        out.close(b'}');
    }
}

/// Which part of a photo is its subject.
pub(crate) fn mask(value: Value) -> Read<Matte> {
    Matte::try_from(fields::text_of(value, LONGEST_MASK)?).map_err(Wrong::new)
}

pub(crate) fn focus(value: Value) -> Read<Focus> {
    let mut fields = Fields::of(value)?;
    let mut part =
        |name: &str| fields.number(name, -1.0, 2.0)?.ok_or_else(|| Wrong::new("is missing").at(name));
    let focus = Focus { x: part("x")?, y: part("y")? };
    fields.done()?;
    Ok(focus)
}

impl Sheet {
    /// Reads a page of a storyboard, whose document may come from elsewhere.
    pub(crate) fn read(value: Value, page: &dyn Fn(Value) -> Read<Arc<Document>>) -> Read<Arc<Self>> {
        let mut fields = Fields::of(value)?;
        let page = page(fields.required("page")?).map_err(|wrong| wrong.at("page"))?;
        let (page_id, sheet) =
            (fields.count("pageId", 0, GREATEST_ID)?, fields.count("sheet", 0, GREATEST_ID)?);
        Ok(Arc::new(Self { page, page_id, sheet, rest: fields.rest() }))
    }
}

fn locks(value: Value) -> Read<Locks> {
    let mut fields = Fields::of(value)?;
    let (layout, style, photos) = (fields.flag("layout")?, fields.flag("style")?, fields.flag("photos")?);
    Ok(Locks { layout, style, photos, rest: fields.rest() })
}

impl Locks {
    pub(crate) fn write(&self, out: &mut Writer) {
        out.open(b'{');
        for (name, lock) in [("layout", self.layout), ("style", self.style), ("photos", self.photos)] {
            out.key(name).flag(lock);
        }
        out.rest(&self.rest);
        out.close(b'}');
    }
}

pub(crate) fn styling(value: Value) -> Read<Styling> {
    let mut fields = Fields::of(value)?;
    let invented = fields.number("invented", 0.0, 1.0)?.unwrap_or(INVENTED);
    let (keep_lines, keep_colours) = (fields.flag("keepLines")?, fields.flag("keepColours")?);
    Ok(Styling { invented, keep_lines, keep_colours, rest: fields.rest() })
}

impl Styling {
    pub(crate) fn write(&self, out: &mut Writer) {
        out.open(b'{');
        out.key("invented").number(self.invented);
        out.key("keepLines").flag(self.keep_lines);
        out.key("keepColours").flag(self.keep_colours);
        out.rest(&self.rest);
        out.close(b'}');
    }
}
