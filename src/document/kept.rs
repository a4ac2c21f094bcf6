//! A history as it crosses to and from the page: states share most of their parts, so these stand in tables beside the
//! states, which name them by their index.
//!
//! `{version, history: {parts, past, present, future, shown}}`, where `parts` has the tables
//!
//! | table | of | named by |
//! |---|---|---|
//! | `items`, `trays` | photos of the tray, and trays as lists of their indices | `tray` of a state |
//! | `pages` | pages | `page` of a state, a sheet and a page shown |
//! | `sheets`, `books` | pages of a storyboard, and lists of their indices | `others` of a state |
//! | `styles`, `shelves` | styles, and lists of their indices | `mine` and `favourites` of a state |
//! | `layouts`, `layoutShelves` | layouts, and lists of their indices | `ownLayouts` of a state |
//! | `settings`, `drafts` | page settings, drafts | `settings`, `draft` of a state |
//!
//! Each part is checked once.

use super::history::{History, Shown};
use super::limits::{HISTORY, MOST_LAYOUTS, MOST_PHOTOS, MOST_SHEETS, MOST_SHOWN, MOST_STEPS, MOST_STYLES};
use super::project::{self, Draft, List, Locks, Order, Parts, Project, Sheet, Styling, TrayItem};
use super::{Dropped, VERSION, leave_out, pages, told, version};
use crate::error::{Error, Result};
use crate::json::{self, Fields, Read, Wrong, list};
use crate::layout::PageSettings;
use crate::page::Document;
use serde::Serialize;
use serde_json::{Map, Value};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// Entries of one table: every state may have a hundred parts of its own.
const MOST_PARTS: usize = (2 * MOST_STEPS + 1 + MOST_SHOWN) * 100;

/// Reads a history with its tables.
///
/// # Errors
/// `damaged-project` or `newer-project`, with the place.
pub fn parse(text: &str) -> Result<(History, Dropped)> {
    told(json::parse(text, HISTORY).and_then(read))
}

fn read(value: Value) -> Read<(History, Dropped)> {
    let mut fields = Fields::of(value)?;
    version(&mut fields)?;
    let mut history = Fields::of(fields.required("history")?).map_err(|wrong| wrong.at("history"))?;
    let mut dropped = Dropped::new();
    let mut tables = match history.take("parts") {
        Some(parts) => Tables::read(parts, &mut dropped).map_err(|wrong| wrong.at("parts"))?,
        None => Tables::default(),
    };
    let history = History::read(Value::Object(history.rest()), &mut tables, &mut dropped)?;
    Ok((history, dropped))
}

/// The text of a history with its tables, and of what was left out.
///
/// # Errors
/// `encode`, which cannot be.
pub fn write(history: &History, dropped: &Dropped) -> Result<String> {
    let mut parts = Interner::default();
    let past = history.past.iter().map(|state| parts.state(state)).collect();
    let present = parts.state(&history.present);
    let future = history.future.iter().map(|state| parts.state(state)).collect();
    let shown = history.shown.iter().map(|shown| parts.shown(shown)).collect();
    let history = HistoryOut { parts: parts.tables, past, present, future, shown };
    text(&Out { version: VERSION, history, dropped })
}

/// JSON of what has no other form.
pub(super) fn text(value: &impl Serialize) -> Result<String> {
    serde_json::to_string(value).map_err(|error| Error::Encode(error.to_string()))
}

/// Tables that were read. What is wrong with a part is told where it is used.
#[derive(Default)]
struct Tables {
    trays: Table<List<TrayItem>>,
    pages: Table<Arc<Document>>,
    books: Table<List<Sheet>>,
    shelves: Table<List<Value>>,
    layout_shelves: Table<List<Value>>,
    settings: Table<Arc<PageSettings>>,
    drafts: Table<Arc<Draft>>,
}

type Table<T> = Vec<Read<T>>;

impl Tables {
    fn read(value: Value, dropped: &mut Dropped) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let mut table = |name: &str| Ok(fields.read(name, list(MOST_PARTS, Ok))?.unwrap_or_default());
        let items = each(table("items")?, project::tray_item);
        let pages = each(table("pages")?, pages::page);
        let sheets =
            each(table("sheets")?, |value| project::sheet(value, |page| part(&pages, &page, "page")));
        let styles = own(each(table("styles")?, project::style), "styles", dropped);
        let layouts = own(each(table("layouts")?, project::layout), "layouts", dropped);
        Ok(Self {
            trays: listed(
                table("trays")?,
                MOST_PHOTOS,
                |i| part(&items, i, "photo").map(Some),
                project::tray,
            ),
            books: listed(table("books")?, MOST_SHEETS, |i| part(&sheets, i, "page").map(Some), Into::into),
            shelves: listed(table("shelves")?, MOST_STYLES, |i| part(&styles, i, "style"), unique),
            layout_shelves: listed(
                table("layoutShelves")?,
                MOST_LAYOUTS,
                |i| part(&layouts, i, "layout"),
                unique,
            ),
            settings: each(table("settings")?, pages::settings),
            drafts: each(table("drafts")?, project::draft),
            pages,
        })
    }
}

impl Parts for Tables {
    fn tray(&mut self, value: Value) -> Read<List<TrayItem>> {
        part(&self.trays, &value, "list")
    }

    fn settings(&mut self, value: Value) -> Read<Arc<PageSettings>> {
        part(&self.settings, &value, "object")
    }

    fn page(&mut self, value: Value) -> Read<Arc<Document>> {
        part(&self.pages, &value, "page")
    }

    fn sheets(&mut self, value: Value) -> Read<List<Sheet>> {
        part(&self.books, &value, "list")
    }

    fn draft(&mut self, value: Value) -> Read<Arc<Draft>> {
        part(&self.drafts, &value, "object")
    }

    fn styles(&mut self, value: Value, _field: &str) -> Read<List<Value>> {
        part(&self.shelves, &value, "list")
    }

    fn layouts(&mut self, value: Value, _field: &str) -> Read<List<Value>> {
        part(&self.layout_shelves, &value, "list")
    }
}

/// Each part of a table, or what is wrong with it.
fn each<T>(values: Vec<Value>, read: impl Fn(Value) -> Read<T>) -> Table<Arc<T>> {
    values.into_iter().map(|value| read(value).map(Arc::new)).collect()
}

/// Styles or layouts of one's own: those that are not right are told, and missing wherever they are used.
fn own(values: Table<Arc<Value>>, name: &str, dropped: &mut Dropped) -> Table<Option<Arc<Value>>> {
    let good = |(i, value): (usize, Read<Arc<Value>>)| match value {
        Ok(value) => Ok(Some(value)),
        Err(wrong) => {
            leave_out(dropped, &wrong.in_list(i).at(name));
            Ok(None)
        }
    };
    values.into_iter().enumerate().map(good).collect()
}

/// Lists of parts of a table.
fn listed<T>(
    values: Vec<Value>,
    most: usize,
    part: impl Fn(&Value) -> Read<Option<Arc<T>>>,
    joined: impl Fn(Vec<Arc<T>>) -> List<T>,
) -> Table<List<T>> {
    let read = |value| {
        list(most, |index| part(&index))(value).map(|parts| joined(parts.into_iter().flatten().collect()))
    };
    values.into_iter().map(read).collect()
}

/// One of each id; the first stays.
fn unique(values: impl IntoIterator<Item = Arc<Value>>) -> List<Value> {
    let mut seen = HashSet::new();
    values.into_iter().filter(|value| seen.insert(value["id"].as_str().map(str::to_owned))).collect()
}

/// The part of that index.
fn part<T: Clone>(table: &[Read<T>], index: &Value, what: &str) -> Read<T> {
    let found = index.as_u64().and_then(|index| table.get(usize::try_from(index).ok()?));
    found.cloned().unwrap_or_else(|| Err(Wrong::new(format!("is no {what}"))))
}

/// What is written.
#[derive(Serialize)]
struct Out<'a> {
    version: u64,
    history: HistoryOut<'a>,
    dropped: &'a Dropped,
}

#[derive(Serialize)]
struct HistoryOut<'a> {
    parts: TablesOut<'a>,
    past: Vec<StateOut<'a>>,
    present: StateOut<'a>,
    future: Vec<StateOut<'a>>,
    shown: Vec<ShownOut<'a>>,
}

/// A state, its parts in it or named. The fields stand in the order in which the page has them.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct StateOut<'a> {
    name: &'a str,
    tray: Part<&'a TrayItem>,
    alike: u8,
    order: Order,
    locks: &'a Locks,
    panels: Option<u32>,
    settings: Part<&'a PageSettings>,
    page: Option<Part<&'a Document>>,
    page_id: u64,
    sheet: u64,
    others: Part<SheetOut<'a>>,
    at: usize,
    draft: Option<Part<&'a Draft>>,
    mine: Part<&'a Value>,
    favourites: Part<&'a Value>,
    own_layouts: Part<&'a Value>,
    loved: &'a [u64],
    styling: &'a Styling,
    #[serde(flatten)]
    rest: &'a Map<String, Value>,
}

/// A page of a storyboard.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct SheetOut<'a> {
    page: Part<&'a Document>,
    page_id: u64,
    sheet: u64,
    #[serde(flatten)]
    rest: &'a Map<String, Value>,
}

/// A page shown.
#[derive(Serialize)]
pub(super) struct ShownOut<'a> {
    id: u64,
    page: Part<&'a Document>,
    #[serde(skip_serializing_if = "Option::is_none")]
    from: Option<u64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sheet: Option<u64>,
    #[serde(flatten)]
    rest: &'a Map<String, Value>,
}

/// A part, or a list of parts, that stands where it is or in a table.
#[derive(Serialize)]
#[serde(untagged)]
enum Part<T> {
    Named(usize),
    Whole(T),
    List(Vec<T>),
}

#[derive(Default, Serialize)]
#[serde(rename_all = "camelCase")]
struct TablesOut<'a> {
    items: Vec<&'a TrayItem>,
    trays: Vec<Vec<usize>>,
    pages: Vec<&'a Document>,
    sheets: Vec<SheetOut<'a>>,
    books: Vec<Vec<usize>>,
    styles: Vec<&'a Value>,
    shelves: Vec<Vec<usize>>,
    layouts: Vec<&'a Value>,
    layout_shelves: Vec<Vec<usize>>,
    settings: Vec<&'a PageSettings>,
    drafts: Vec<&'a Draft>,
}

/// Where parts are that stand in tables already, by their addresses.
#[derive(Default)]
pub(super) struct Interner<'a> {
    inline: bool,
    known: HashMap<*const (), usize>,
    tables: TablesOut<'a>,
}

impl<'a> Interner<'a> {
    /// One that leaves every part where it is.
    pub(super) fn inline() -> Self {
        Self { inline: true, ..Self::default() }
    }

    pub(super) fn state(&mut self, state: &'a Project) -> StateOut<'a> {
        let sheets = |parts: &mut Self, sheet: &'a Arc<Sheet>| SheetOut {
            page: parts.page(&sheet.page),
            page_id: sheet.page_id,
            sheet: sheet.sheet,
            rest: &sheet.rest,
        };
        StateOut {
            name: &state.name,
            tray: self.list(&state.tray, |_, item| &**item, |tables| (&mut tables.items, &mut tables.trays)),
            alike: state.alike,
            order: state.order,
            locks: &state.locks,
            panels: state.panels,
            settings: self.one(&state.settings, |tables| &mut tables.settings),
            page: state.page.as_ref().map(|page| self.page(page)),
            page_id: state.page_id,
            sheet: state.sheet,
            others: self.list(&state.others, sheets, |tables| (&mut tables.sheets, &mut tables.books)),
            at: state.at,
            draft: state.draft.as_ref().map(|draft| self.one(draft, |tables| &mut tables.drafts)),
            mine: self.list(
                &state.mine,
                |_, style| &**style,
                |tables| (&mut tables.styles, &mut tables.shelves),
            ),
            favourites: self.list(
                &state.favourites,
                |_, style| &**style,
                |tables| (&mut tables.styles, &mut tables.shelves),
            ),
            own_layouts: self.list(
                &state.own_layouts,
                |_, layout| &**layout,
                |tables| (&mut tables.layouts, &mut tables.layout_shelves),
            ),
            loved: &state.loved,
            styling: &state.styling,
            rest: &state.rest,
        }
    }

    pub(super) fn shown(&mut self, shown: &'a Shown) -> ShownOut<'a> {
        ShownOut {
            id: shown.id,
            page: self.page(&shown.page),
            from: shown.from,
            sheet: Some(shown.sheet).filter(|sheet| *sheet > 0),
            rest: &shown.rest,
        }
    }

    fn page(&mut self, page: &'a Arc<Document>) -> Part<&'a Document> {
        self.one(page, |tables| &mut tables.pages)
    }

    fn one<T>(
        &mut self,
        part: &'a Arc<T>,
        table: impl for<'t> Fn(&'t mut TablesOut<'a>) -> &'t mut Vec<&'a T>,
    ) -> Part<&'a T> {
        if self.inline { Part::Whole(part) } else { Part::Named(self.place(part, |_, part| &**part, table)) }
    }

    fn list<T, O>(
        &mut self,
        parts: &'a List<T>,
        out: impl Fn(&mut Self, &'a Arc<T>) -> O,
        tables: impl for<'t> Fn(&'t mut TablesOut<'a>) -> (&'t mut Vec<O>, &'t mut Vec<Vec<usize>>),
    ) -> Part<O> {
        if self.inline {
            return Part::List(parts.iter().map(|part| out(self, part)).collect());
        }
        let address = Arc::as_ptr(parts).cast();
        if let Some(&index) = self.known.get(&address) {
            return Part::Named(index);
        }
        let places = parts.iter().map(|part| self.place(part, &out, |all| tables(all).0)).collect();
        let lists = tables(&mut self.tables).1;
        lists.push(places);
        let index = lists.len() - 1;
        self.known.insert(address, index);
        Part::Named(index)
    }

    fn place<T, O>(
        &mut self,
        part: &'a Arc<T>,
        out: impl Fn(&mut Self, &'a Arc<T>) -> O,
        table: impl for<'t> Fn(&'t mut TablesOut<'a>) -> &'t mut Vec<O>,
    ) -> usize {
        let address = Arc::as_ptr(part).cast();
        if let Some(&index) = self.known.get(&address) {
            return index;
        }
        let one = out(self, part);
        let table = table(&mut self.tables);
        table.push(one);
        let index = table.len() - 1;
        self.known.insert(address, index);
        index
    }
}
