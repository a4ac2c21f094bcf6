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

use super::edit::Shelf;
use super::history::{History, Shown};
use super::limits::{HISTORY, MOST_LAYOUTS, MOST_PHOTOS, MOST_SHEETS, MOST_SHOWN, MOST_STEPS, MOST_STYLES};
use super::project::{self, Draft, List, Order, Parts, Project, Sheet, TrayItem};
use super::{Dropped, VERSION, leave_out, own, pages, refusal, version};
use crate::error::Result;
use crate::json::{self, Fields, Read, Writer, Wrong, items};
use crate::layout::PageSettings;
use crate::page::Document;
use serde_json::Value;
use std::collections::HashMap;
use std::sync::Arc;

/// Entries of one table: every state may have a hundred parts of its own.
const MOST_PARTS: usize = (2 * MOST_STEPS + 1 + MOST_SHOWN) * 100;

/// Reads a history with its tables.
///
/// # Errors
/// `damaged-project`, `newer-project` or `too-large-project`, with the place.
pub fn parse(text: &str) -> Result<(History, Dropped)> {
    json::parse(text, HISTORY).and_then(read).map_err(|wrong| refusal(&wrong))
}

fn read(value: Value) -> Read<(History, Dropped)> {
    let mut fields = Fields::of(value)?;
    version(&mut fields)?;
    let mut history = fields.required("history")?;
    let mut dropped = Dropped::new();
    let mut tables = match history.as_object_mut().and_then(|history| history.remove("parts")) {
        Some(parts) => Tables::read(parts, &mut dropped).map_err(|wrong| wrong.at("parts"))?,
        None => Tables::default(),
    };
    let history = History::read(history, &mut tables, &mut dropped).map_err(|wrong| match wrong.place() {
        "" => wrong.at("history"),
        _ => wrong,
    })?;
    Ok((history, dropped))
}

/// The text of a history with its tables, and of what was left out.
#[must_use]
pub fn write(history: &History, dropped: &Dropped) -> String {
    let mut parts = Interner::default();
    let mut states = Writer::default();
    states.open(b'{');
    for (name, list) in [("past", &history.past), ("future", &history.future)] {
        states.key(name).open(b'[');
        for state in list {
            states.item();
            parts.state(&mut states, state);
        }
        states.close(b']');
    }
    parts.state(states.key("present"), &history.present);
    parts.shown(states.key("shown"), &history.shown);
    parts.tables(states.key("parts"));
    states.close(b'}');
    let mut out = Writer::default();
    out.open(b'{');
    out.key("version").whole(VERSION);
    out.key("history").append(&states);
    out.key("dropped").texts(dropped);
    out.close(b'}');
    out.finish()
}

/// What an edit changed: `{project, shown, past, future, pageId, sheet}`: of the present state the fields that are not as
/// they were, of the pages shown the ids in order and those that are new or changed, where anything is; the numbers of steps
/// back and forth; ids for a new page and a new place.
#[must_use]
pub fn difference(history: &History, was: &History) -> String {
    let mut parts = Interner::inline();
    let mut out = Writer::default();
    out.open(b'{');
    parts.differences(out.key("project"), &history.present, Some(&was.present));
    let same = |a: &Arc<Shown>, b: &Arc<Shown>| Arc::ptr_eq(a, b);
    let changed = history.shown.len() != was.shown.len()
        || !history.shown.iter().zip(&was.shown).all(|(a, b)| same(a, b));
    if changed {
        let known: HashMap<u64, &Arc<Shown>> = was.shown.iter().map(|shown| (shown.id, shown)).collect();
        let fresh = history.shown.iter().filter(|now| !known.get(&now.id).is_some_and(|was| same(now, was)));
        let fresh: Vec<Arc<Shown>> = fresh.cloned().collect();
        out.key("shown").open(b'{');
        out.key("order").list(&history.shown, &|out, shown| out.whole(shown.id));
        parts.shown(out.key("pages"), &fresh);
        out.close(b'}');
    }
    out.key("past").whole(history.past.len() as u64);
    out.key("future").whole(history.future.len() as u64);
    out.key("pageId").whole(history.fresh_page_id());
    out.key("sheet").whole(history.fresh_sheet());
    out.close(b'}');
    out.finish()
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
        let mut table = |name: &str| fields.list(name, MOST_PARTS);
        let tray_items = all(table("items")?, &TrayItem::read);
        let pages = all(table("pages")?, &pages::page);
        let sheets = all(table("sheets")?, &|value| Sheet::read(value, &|page| part(&pages, &page, "page")));
        let styles = own_parts(table("styles")?, "styles", project::style, dropped);
        let layouts = own_parts(table("layouts")?, "layouts", project::layout, dropped);
        Ok(Self {
            trays: listed(table("trays")?, MOST_PHOTOS, &tray_items, "photo", &project::tray),
            books: listed(table("books")?, MOST_SHEETS, &sheets, "page", &Into::into),
            shelves: shelves(table("shelves")?, MOST_STYLES, &styles),
            layout_shelves: shelves(table("layoutShelves")?, MOST_LAYOUTS, &layouts),
            settings: all(table("settings")?, &pages::settings),
            drafts: all(table("drafts")?, &Draft::read),
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
fn all<T>(values: Vec<Value>, read: &dyn Fn(Value) -> Read<T>) -> Table<T> {
    let mut all = Vec::with_capacity(values.len());
    for value in values {
        all.push(read(value));
    }
    all
}

/// Styles or layouts of one's own: one that is not right is told, and null wherever it is used.
fn own_parts(
    values: Vec<Value>,
    name: &str,
    read: fn(Value) -> Read<Arc<Value>>,
    dropped: &mut Dropped,
) -> Table<Arc<Value>> {
    let mut good = Vec::with_capacity(values.len());
    for (i, value) in values.into_iter().enumerate() {
        good.push(Ok(read(value).unwrap_or_else(|wrong| {
            leave_out(dropped, &wrong.in_list(i).at(name));
            Arc::default()
        })));
    }
    good
}

/// Lists of parts of a table.
fn listed<T>(
    lists: Vec<Value>,
    most: usize,
    table: &[Read<Arc<T>>],
    what: &str,
    joined: &dyn Fn(Vec<Arc<T>>) -> List<T>,
) -> Table<List<T>> {
    all(lists, &|list| json::each(items(list, most)?, &|index| part(table, &index, what)).map(joined))
}

/// Lists of styles or layouts: of each id the first.
fn shelves(lists: Vec<Value>, most: usize, table: &[Read<Arc<Value>>]) -> Table<List<Value>> {
    listed(lists, most, table, "part", &|mut shelf: Vec<Arc<Value>>| {
        shelf.retain(|value| !value.is_null());
        own::first_of_each(shelf)
    })
}

/// The part of that index.
fn part<T: Clone>(table: &[Read<T>], index: &Value, what: &str) -> Read<T> {
    match index.as_u64().and_then(|index| table.get(usize::try_from(index).ok()?)) {
        Some(part) => part.clone(),
        None => Err(Wrong::new(&format!("is no {what}"))),
    }
}

/// Tables by their names, in the order of their numbers.
const TABLES: [&str; 11] = [
    "items",
    "trays",
    "pages",
    "sheets",
    "books",
    "styles",
    "shelves",
    "layouts",
    "layoutShelves",
    "settings",
    "drafts",
];
const ITEMS: usize = 0;
const PAGES: usize = 2;
const SHEETS: usize = 3;
const STYLES: usize = 5;
const LAYOUTS: usize = 7;
const SETTINGS: usize = 9;
const DRAFTS: usize = 10;

/// Writes states; parts that stand in tables already it knows by their addresses.
#[derive(Default)]
pub(super) struct Interner {
    inline: bool,
    known: HashMap<usize, u64>,
    tables: [(Writer, u64); TABLES.len()],
}

impl Interner {
    /// One that leaves every part where it is.
    pub(super) fn inline() -> Self {
        Self { inline: true, ..Self::default() }
    }

    /// Writes a state, its fields in the order in which the page has them.
    pub(super) fn state(&mut self, out: &mut Writer, state: &Project) {
        self.differences(out, state, None);
    }

    /// Writes what of a state is not as it was in another.
    pub(super) fn differences(&mut self, out: &mut Writer, state: &Project, was: Option<&Project>) {
        let fresh = |same: &dyn Fn(&Project) -> bool| !was.is_some_and(same);
        out.open(b'{');
        if fresh(&|was| was.name == state.name) {
            out.key("name").text(&state.name);
        }
        if fresh(&|was| was.tray == state.tray) {
            self.list(out.key("tray"), ITEMS, &state.tray, &|_, out, item| item.write(out));
        }
        if fresh(&|was| was.alike == state.alike) {
            out.key("alike").whole(u64::from(state.alike));
        }
        if fresh(&|was| was.order == state.order) {
            out.key("order").text(match state.order {
                Order::Time => "time",
                Order::Name => "name",
            });
        }
        if fresh(&|was| was.locks == state.locks) {
            state.locks.write(out.key("locks"));
        }
        if fresh(&|was| was.panels == state.panels) {
            match state.panels {
                Some(panels) => out.key("panels").whole(u64::from(panels)),
                None => out.key("panels").null(),
            }
        }
        if fresh(&|was| was.settings == state.settings) {
            self.part(out.key("settings"), SETTINGS, &state.settings, &|_, out, settings| out.put(settings));
        }
        if fresh(&|was| was.page == state.page) {
            match &state.page {
                Some(page) => self.page(out.key("page"), page),
                None => out.key("page").null(),
            }
        }
        for (name, same, id) in [
            ("pageId", fresh(&|was| was.page_id == state.page_id), state.page_id),
            ("sheet", fresh(&|was| was.sheet == state.sheet), state.sheet),
        ] {
            if same {
                out.key(name).whole(id);
            }
        }
        if fresh(&|was| was.others == state.others) {
            self.list(out.key("others"), SHEETS, &state.others, &|parts, out, sheet: &Sheet| {
                out.open(b'{');
                parts.page(out.key("page"), &sheet.page);
                out.key("pageId").whole(sheet.page_id);
                out.key("sheet").whole(sheet.sheet);
                out.rest(&sheet.rest);
                out.close(b'}');
            });
        }
        if fresh(&|was| was.at == state.at) {
            out.key("at").whole(state.at as u64);
        }
        if fresh(&|was| was.draft == state.draft) {
            match &state.draft {
                Some(draft) => self.part(out.key("draft"), DRAFTS, draft, &|_, out, draft| draft.write(out)),
                None => out.key("draft").null(),
            }
        }
        for (shelf, name) in Shelf::ALL {
            if fresh(&|was| shelf.of(was) == shelf.of(state)) {
                let table = if shelf == Shelf::Layouts { LAYOUTS } else { STYLES };
                self.list(out.key(name), table, shelf.of(state), &|_, out, value| out.value(value));
            }
        }
        if fresh(&|was| was.loved == state.loved) {
            out.key("loved").list(&state.loved, &|out, id| out.whole(*id));
        }
        if fresh(&|was| was.styling == state.styling) {
            state.styling.write(out.key("styling"));
        }
        if fresh(&|was| was.rest == state.rest) {
            out.rest(&state.rest);
        }
        out.close(b'}');
    }

    /// Writes pages shown.
    pub(super) fn shown(&mut self, out: &mut Writer, shown: &[Arc<Shown>]) {
        out.open(b'[');
        for Shown { id, page, from, sheet, rest } in shown.iter().map(AsRef::as_ref) {
            out.item();
            out.open(b'{');
            out.key("id").whole(*id);
            self.page(out.key("page"), page);
            if let Some(from) = from {
                out.key("from").whole(*from);
            }
            // In a project of one page nothing is told.
            if *sheet > 0 {
                out.key("sheet").whole(*sheet);
            }
            out.rest(rest);
            out.close(b'}');
        }
        out.close(b']');
    }

    fn tables(&self, out: &mut Writer) {
        out.open(b'{');
        for (name, (table, _)) in TABLES.iter().zip(&self.tables) {
            out.key(name).open(b'[');
            out.append(table);
            out.close(b']');
        }
        out.close(b'}');
    }

    fn page(&mut self, out: &mut Writer, page: &Arc<Document>) {
        self.part(out, PAGES, page, &|_, out, page| page.write(out));
    }

    /// A part, or its index in a table.
    fn part<T>(
        &mut self,
        out: &mut Writer,
        table: usize,
        part: &Arc<T>,
        write: &dyn Fn(&mut Self, &mut Writer, &T),
    ) {
        self.named(out, table, Arc::as_ptr(part).addr(), &mut |parts, out| write(parts, out, part));
    }

    /// A list of parts of a table, or its index in the table behind it.
    fn list<T>(
        &mut self,
        out: &mut Writer,
        table: usize,
        list: &List<T>,
        write: &dyn Fn(&mut Self, &mut Writer, &T),
    ) {
        self.named(out, table + 1, list.as_ptr().addr(), &mut |parts, out| {
            out.open(b'[');
            for item in list.iter() {
                out.item();
                parts.part(out, table, item, write);
            }
            out.close(b']');
        });
    }

    #[inline(never)]
    fn named(
        &mut self,
        out: &mut Writer,
        table: usize,
        address: usize,
        write: &mut dyn FnMut(&mut Self, &mut Writer),
    ) {
        if self.inline {
            return write(self, out);
        }
        if let Some(index) = self.known.get(&address) {
            return out.whole(*index);
        }
        let mut fresh = Writer::default();
        write(self, &mut fresh);
        let (entries, count) = &mut self.tables[table];
        if *count > 0 {
            entries.open(b',');
        }
        entries.append(&fresh);
        let index = *count;
        *count += 1;
        self.known.insert(address, index);
        out.whole(index);
    }
}
