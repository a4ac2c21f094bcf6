//! A history as data between the core and the app. States share most of their parts. The parts are in tables,
//! and states refer to them by index.
//!
//! `{version, gesture, history: {parts, past, present, future, shown}}`, where `gesture` is the gesture of the
//! last edit, if it has one, and `parts` has the tables
//!
//! | table | of | named by |
//! |---|---|---|
//! | `items`, `trays` | photos of the tray, and trays as lists of their indices | `tray` of a state |
//! | `pages` | pages | `page` of a state, a sheet and a page shown |
//! | `sheets`, `books` | pages of a storyboard, and lists of their indices | `others` of a state |
//! | `styles`, `shelves` | styles, and lists of their indices | `mine` and `favourites` of a state |
//! | `layouts`, `layoutShelves` | layouts, and lists of their indices | `ownLayouts` of a state |
//! | `words`, `waits` | unplaced text items, and lists of their indices | `waiting` of a state |
//! | `settings`, `drafts`, `boards` | page settings, drafts, boards | `settings`, `draft`, `board` of a state |
//!
//! Each part is checked once.

use super::draft::Draft;
use super::edit::{Edit, How, Shelf};
use super::history::{History, Shown};
use super::limits::{
    HISTORY, LONGEST_NAME, MOST_LAYOUTS, MOST_PHOTOS, MOST_SHEETS, MOST_SHOWN, MOST_STEPS, MOST_STYLES,
    MOST_WAITING,
};
use super::project::{self, List, Order, Pages, Parts, Project, Sheet, TrayItem};
use super::shots::Board;
use super::{Dropped, VERSION, leave_out, own, refusal, validation, version};
use crate::error::Result;
use crate::json::{self, Fields, Read, Writer, Wrong, items};
use crate::layout::PageSettings;
use crate::page::Document;
use crate::reference::CustomFile;
use crate::text::TextItem;
use serde_json::Value;
use std::collections::HashMap;
use std::sync::Arc;

/// Maximum number of entries per table: a hundred parts for every state.
const MOST_PARTS: usize = (2 * MOST_STEPS + 1 + MOST_SHOWN) * 100;

/// Reads a history with its tables.
///
/// # Errors
/// `damaged-project`, `newer-project` or `too-large-project`, with the place.
pub fn parse(text: &str) -> Result<(History, Dropped)> {
    parse_saved(text).map(|(history, _, dropped)| (history, dropped))
}

/// Like [`parse`], with the gesture of the last edit.
///
/// # Errors
/// As [`parse`].
pub fn parse_saved(text: &str) -> Result<(History, Option<String>, Dropped)> {
    json::parse(text, HISTORY).and_then(read).map_err(|wrong| refusal(&wrong))
}

fn read(value: Value) -> Read<(History, Option<String>, Dropped)> {
    let mut fields = Fields::of(value)?;
    version(&mut fields)?;
    let gesture = fields.nullable("gesture").text("gesture", LONGEST_NAME)?;
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
    Ok((history, gesture, dropped))
}

/// Writes a history with its tables, and the list of dropped parts.
#[must_use]
pub fn write(history: &History, dropped: &Dropped) -> String {
    write_saved(history, None, dropped)
}

/// Like [`write()`], with the gesture of the last edit.
#[must_use]
pub fn write_saved(history: &History, gesture: Option<&str>, dropped: &Dropped) -> String {
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
    if let Some(gesture) = gesture {
        out.key("gesture").text(gesture);
    }
    out.key("history").append(&states);
    out.key("dropped").texts(dropped);
    out.close(b'}');
    out.finish()
}

/// Parts of a difference in addition to the history.
#[derive(Debug, Clone, Copy)]
pub struct Told<'a> {
    /// The edits that an intent led to.
    pub edits: &'a [(Edit, How)],
    /// Number of earlier changes that the change includes.
    pub includes: usize,
    /// Parts that were dropped.
    pub dropped: &'a [String],
}

/// The difference between an empty project and a history that an editor has read.
#[must_use]
pub fn loaded(history: &History, dropped: &Dropped) -> String {
    difference(history, &History::default(), &Told { edits: &[], includes: 0, dropped })
}

/// The difference after a change, for a reader that knows the present and the page history before:
///
/// - `present`: the fields of the present that changed
/// - `shown`: the page history as runs of numbers, pairs of `[first, count]`. Its old entries count from 0, and
///   the new ones in `entries` follow.
/// - `edits`: the edits that an intent led to, with their pages in tables
/// - `parts`: tables that extend the known tables (`Interner::knowing`)
/// - `undos`, `redos`: the number of steps; `stepped`: whether the steps to undo are others
/// - `changed`: whether the history changed at all
/// - `includes`: number of earlier changes that a journal need not have
/// - `dropped`: parts that could not be read
/// - `pageId` and `sheet`: ids for a new page and a new sheet
#[must_use]
pub fn difference(history: &History, was: &History, told: &Told) -> String {
    let mut parts = Interner::knowing(was);
    let mut out = Writer::default();
    out.open(b'{');
    parts.differences(out.key("present"), &history.present, Some(&was.present));
    let fresh = runs(out.key("shown"), &history.shown, &was.shown);
    parts.shown(out.key("entries"), &fresh);
    parts.edits(out.key("edits"), told.edits);
    parts.tables(out.key("parts"));
    out.key("undos").whole(history.past.len() as u64);
    out.key("redos").whole(history.future.len() as u64);
    let stepped = addresses(history.past.iter()) != addresses(was.past.iter());
    let changed = stepped
        || !Arc::ptr_eq(&history.present, &was.present)
        || addresses(history.future.iter()) != addresses(was.future.iter())
        || addresses(history.shown.iter()) != addresses(was.shown.iter());
    out.key("stepped").flag(stepped);
    out.key("changed").flag(changed);
    out.key("includes").whole(told.includes as u64);
    out.key("dropped").texts(told.dropped);
    let (page_id, sheet) = history.fresh();
    out.key("pageId").whole(page_id);
    out.key("sheet").whole(sheet);
    out.close(b'}');
    out.finish()
}

/// Writes a list as runs of numbers.
///
/// Returns the entries that the old list does not have.
fn runs(out: &mut Writer, list: &[Arc<Shown>], old: &[Arc<Shown>]) -> Vec<Arc<Shown>> {
    let known = addresses(old.iter());
    let mut fresh = Vec::new();
    let mut runs: Vec<(usize, u64)> = Vec::new();
    // Most lists are unchanged.
    let mut next = 0;
    for shown in list {
        let item = address(shown);
        let at = match known.get(next) {
            Some(known) if *known == item => next,
            _ => known.iter().position(|known| *known == item).unwrap_or_else(|| {
                fresh.push(shown.clone());
                known.len() + fresh.len() - 1
            }),
        };
        next = at + 1;
        match runs.last_mut() {
            Some((first, count)) if *first + *count as usize == at => *count += 1,
            _ => runs.push((at, 1)),
        }
    }
    out.list(&runs, &|out, (first, count)| {
        out.open(b'[');
        out.whole(*first as u64);
        out.item();
        out.whole(*count);
        out.close(b']');
    });
    fresh
}

/// Returns whether two histories are equal. Most of their parts are identical objects.
#[must_use]
pub fn same_history(a: &History, b: &History) -> bool {
    let states = |a: &[Arc<Project>], b: &[Arc<Project>]| same_items(a.iter(), b.iter());
    if !states(&a.past, &b.past) || !states(&a.future, &b.future) {
        return false;
    }
    let mut fields = Writer::default();
    Interner::default().differences(&mut fields, &a.present, Some(&b.present));
    fields.finish() == "{}" && same_items(a.shown.iter(), b.shown.iter())
}

fn address<T>(part: &Arc<T>) -> usize {
    Arc::as_ptr(part).addr()
}

fn addresses<'a, T: 'a>(list: impl Iterator<Item = &'a Arc<T>>) -> Vec<usize> {
    list.map(address).collect()
}

/// Tables that were read. An error of a part is reported where the part is used.
#[derive(Default)]
struct Tables {
    trays: Table<List<TrayItem>>,
    pages: Table<Arc<Document>>,
    books: Table<List<Sheet>>,
    waits: Table<List<TextItem>>,
    shelves: Table<List<CustomFile>>,
    layout_shelves: Table<List<CustomFile>>,
    settings: Table<Arc<PageSettings>>,
    drafts: Table<Arc<Draft>>,
    boards: Table<Arc<Board>>,
}

type Table<T> = Vec<Read<T>>;

impl Tables {
    fn read(value: Value, dropped: &mut Dropped) -> Read<Self> {
        let mut fields = Fields::of(value)?;
        let mut table = |name: &str| fields.list(name, MOST_PARTS);
        let tray_items = all(table("items")?, &TrayItem::read);
        let pages = all(table("pages")?, &validation::page);
        let sheets = all(table("sheets")?, &|value| Sheet::read(value, &|page| part(&pages, &page, "page")));
        let words = all(table("words")?, &validation::waiting);
        let styles = own_parts(table("styles")?, "styles", CustomFile::style, dropped);
        let layouts = own_parts(table("layouts")?, "layouts", CustomFile::layout, dropped);
        Ok(Self {
            trays: listed(table("trays")?, MOST_PHOTOS, &tray_items, "photo", &project::tray),
            books: listed(table("books")?, MOST_SHEETS, &sheets, "page", &Into::into),
            waits: listed(table("waits")?, MOST_WAITING, &words, "word", &Into::into),
            shelves: shelves(table("shelves")?, MOST_STYLES, &styles),
            layout_shelves: shelves(table("layoutShelves")?, MOST_LAYOUTS, &layouts),
            settings: all(table("settings")?, &validation::settings),
            drafts: all(table("drafts")?, &Draft::read),
            boards: all(table("boards")?, &Board::shared),
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

    fn board(&mut self, value: Value) -> Read<Arc<Board>> {
        part(&self.boards, &value, "object")
    }

    fn waiting(&mut self, value: Value) -> Read<List<TextItem>> {
        part(&self.waits, &value, "list")
    }

    fn styles(&mut self, value: Value, _field: &str) -> Read<List<CustomFile>> {
        part(&self.shelves, &value, "list")
    }

    fn layouts(&mut self, value: Value, _field: &str) -> Read<List<CustomFile>> {
        part(&self.layout_shelves, &value, "list")
    }
}

/// Each part of a table, or its error.
fn all<T>(values: Vec<Value>, read: &dyn Fn(Value) -> Read<T>) -> Table<T> {
    let mut all = Vec::with_capacity(values.len());
    for value in values {
        all.push(read(value));
    }
    all
}

/// Custom styles or layouts. Invalid ones are reported, and are null in every state.
fn own_parts(
    values: Vec<Value>,
    name: &str,
    read: fn(Value) -> Read<Arc<CustomFile>>,
    dropped: &mut Dropped,
) -> Table<Arc<CustomFile>> {
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
fn shelves(lists: Vec<Value>, most: usize, table: &[Read<Arc<CustomFile>>]) -> Table<List<CustomFile>> {
    listed(lists, most, table, "part", &|mut shelf: Vec<Arc<CustomFile>>| {
        shelf.retain(|file| !file.json().is_null());
        own::first_of_each(shelf)
    })
}

/// The part of that index.
fn part<T: Clone>(table: &[Read<T>], index: &Value, what: &str) -> Read<T> {
    match index.as_u64().and_then(|index| table.get(usize::try_from(index).ok()?)) {
        Some(part) => part.clone(),
        None => Err(Wrong::new(&format!("is not the index of a {what}"))),
    }
}

/// Tables by their names, in the order of their numbers.
const TABLES: [&str; 14] = [
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
    "words",
    "waits",
    "boards",
];
const ITEMS: usize = 0;
const PAGES: usize = 2;
const SHEETS: usize = 3;
const BOOKS: usize = 4;
const STYLES: usize = 5;
const LAYOUTS: usize = 7;
const SETTINGS: usize = 9;
const DRAFTS: usize = 10;
const WORDS: usize = 11;
const BOARDS: usize = 13;

/// Returns whether two parts are equal. Most are identical objects.
fn same<T: PartialEq>(a: &Arc<T>, b: &Arc<T>) -> bool {
    Arc::ptr_eq(a, b) || a == b
}

fn same_option<T: PartialEq>(a: Option<&Arc<T>>, b: Option<&Arc<T>>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => same(a, b),
        (a, b) => a.is_none() && b.is_none(),
    }
}

fn same_list<T: PartialEq>(a: &List<T>, b: &List<T>) -> bool {
    Arc::ptr_eq(a, b) || same_items(a.iter(), b.iter())
}

fn same_items<'a, T: PartialEq + 'a>(
    mut a: impl Iterator<Item = &'a Arc<T>>,
    mut b: impl Iterator<Item = &'a Arc<T>>,
) -> bool {
    loop {
        match (a.next(), b.next()) {
            (Some(a), Some(b)) if same(a, b) => {}
            (a, b) => return a.is_none() && b.is_none(),
        }
    }
}

fn edited_page(state: &Project) -> Option<&Arc<Document>> {
    state.pages.edited().map(|sheet| &sheet.page)
}

/// Writes states. It finds parts of existing tables by their addresses.
#[derive(Default)]
pub(crate) struct Interner {
    inline: bool,
    known: HashMap<usize, u64>,
    /// Indices in the table `books`, by the addresses of the pages.
    books: HashMap<Vec<usize>, u64>,
    tables: [(Writer, u64); TABLES.len()],
}

impl Interner {
    /// One that leaves every part where it is.
    pub(crate) fn inline() -> Self {
        Self { inline: true, ..Self::default() }
    }

    /// An interner whose tables begin with the parts that its reader has. The order: photos and page of the present, pages of the other sheets, pages of the page history, the other sheets, custom styles and favourites. Custom layouts, settings, draft, unplaced text items and storyboard settings follow.
    fn knowing(history: &History) -> Self {
        let mut parts = Self::default();
        let present = &history.present;
        let pages = present.pages.edited().into_iter().chain(present.pages.others()).map(|sheet| &sheet.page);
        parts.know(ITEMS, present.tray.iter());
        parts.know(PAGES, pages.chain(history.shown.iter().map(|shown| &shown.page)));
        parts.know(SHEETS, present.pages.others());
        parts.know(STYLES, present.mine.iter().chain(present.favourites.iter()));
        parts.know(LAYOUTS, present.own_layouts.iter());
        parts.know(SETTINGS, [&present.settings].into_iter());
        parts.know(DRAFTS, present.draft.iter());
        parts.know(WORDS, present.waiting.iter());
        parts.know(BOARDS, [&present.board].into_iter());
        parts
    }

    fn know<'a, T: 'a>(&mut self, table: usize, known: impl Iterator<Item = &'a Arc<T>>) {
        let count = &mut self.tables[table].1;
        for part in known {
            self.known.insert(address(part), *count);
            *count += 1;
        }
    }

    /// Writes a state, its fields in the order in which the page has them.
    pub(crate) fn state(&mut self, out: &mut Writer, state: &Project) {
        self.differences(out, state, None);
    }

    /// Writes the fields of a state that differ from another state.
    pub(crate) fn differences(&mut self, out: &mut Writer, state: &Project, was: Option<&Project>) {
        let fresh = |same: &dyn Fn(&Project) -> bool| !was.is_some_and(same);
        out.open(b'{');
        if fresh(&|was| was.name == state.name) {
            out.key("name").text(&state.name);
        }
        if fresh(&|was| same_list(&was.tray, &state.tray)) {
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
        if fresh(&|was| same(&was.settings, &state.settings)) {
            self.settings(out.key("settings"), &state.settings);
        }
        if fresh(&|was| same_option(edited_page(was), edited_page(state))) {
            match edited_page(state) {
                Some(page) => self.page(out.key("page"), page),
                None => out.key("page").null(),
            }
        }
        for (name, same, id) in [
            ("pageId", fresh(&|was| was.page_id() == state.page_id()), state.page_id()),
            ("sheet", fresh(&|was| was.sheet() == state.sheet()), state.sheet()),
        ] {
            if same {
                out.key(name).whole(id);
            }
        }
        if fresh(&|was| same_items(was.pages.others(), state.pages.others())) {
            self.others(out.key("others"), &state.pages);
        }
        if fresh(&|was| was.pages.active() == state.pages.active()) {
            out.key("at").whole(state.pages.active() as u64);
        }
        if fresh(&|was| same_option(was.draft.as_ref(), state.draft.as_ref())) {
            match &state.draft {
                Some(draft) => self.part(out.key("draft"), DRAFTS, draft, &|_, out, draft| draft.write(out)),
                None => out.key("draft").null(),
            }
        }
        // Omitted in a project without unplaced text.
        let none = was.is_none_or(|was| was.waiting.is_empty()) && state.waiting.is_empty();
        if !none && fresh(&|was| same_list(&was.waiting, &state.waiting)) {
            self.list(out.key("waiting"), WORDS, &state.waiting, &|_, out, word| out.put(word));
        }
        for (shelf, name) in Shelf::ALL {
            if fresh(&|was| same_list(shelf.of(was), shelf.of(state))) {
                let table = if shelf == Shelf::Layouts { LAYOUTS } else { STYLES };
                self.list(out.key(name), table, shelf.of(state), &|_, out, value| out.value(value.json()));
            }
        }
        if fresh(&|was| was.loved == state.loved) {
            out.key("loved").list(&state.loved, &|out, id| out.whole(*id));
        }
        if fresh(&|was| was.styling == state.styling) {
            state.styling.write(out.key("styling"));
        }
        // Omitted with default settings of the storyboard.
        let none = was.is_none_or(|was| *was.board == Board::default()) && *state.board == Board::default();
        if !none && fresh(&|was| same(&was.board, &state.board)) {
            let board = out.key("board");
            if *state.board == Board::default() {
                board.null();
            } else {
                self.part(board, BOARDS, &state.board, &|_, out, board| board.write(out));
            }
        }
        if fresh(&|was| was.rest == state.rest) {
            out.rest(&state.rest);
        }
        out.close(b'}');
    }

    /// Writes pages shown.
    pub(crate) fn shown(&mut self, out: &mut Writer, shown: &[Arc<Shown>]) {
        out.open(b'[');
        for Shown { id, page, from, sheet, rest } in shown.iter().map(AsRef::as_ref) {
            out.item();
            out.open(b'{');
            out.key("id").whole(*id);
            self.page(out.key("page"), page);
            if let Some(from) = from {
                out.key("from").whole(*from);
            }
            // Omitted in a project of one page.
            if *sheet > 0 {
                out.key("sheet").whole(*sheet);
            }
            out.rest(rest);
            out.close(b'}');
        }
        out.close(b']');
    }

    /// Writes the edits that an intent led to.
    fn edits(&mut self, out: &mut Writer, edits: &[(Edit, How)]) {
        out.open(b'[');
        for (edit, how) in edits {
            out.item();
            out.open(b'{');
            match edit {
                Edit::ShowPage { page, page_id } => {
                    out.key("type").text("show-page");
                    self.page(out.key("page"), page);
                    out.key("pageId").whole(*page_id);
                }
                Edit::ChangePage { page } => {
                    out.key("type").text("change-page");
                    self.page(out.key("page"), page);
                }
                Edit::ChangeSettings { settings, page } => {
                    out.key("type").text("change-settings");
                    self.settings(out.key("settings"), settings);
                    if let Some(page) = page {
                        self.page(out.key("page"), page);
                    }
                }
                Edit::SetSheets { sheets, at } => {
                    out.key("type").text("set-sheets");
                    out.key("sheets").open(b'[');
                    for sheet in sheets {
                        out.item();
                        self.sheet(out, sheet);
                    }
                    out.close(b']');
                    out.key("at").whole(*at as u64);
                }
                _ => out.key("type").text("no-page"),
            }
            if how.silent {
                out.key("silent").flag(true);
            }
            if let Some(gesture) = &how.gesture {
                out.key("gesture").text(gesture);
            }
            out.close(b'}');
        }
        out.close(b']');
    }

    fn settings(&mut self, out: &mut Writer, settings: &Arc<PageSettings>) {
        self.part(out, SETTINGS, settings, &|_, out, settings| out.put(settings));
    }

    fn sheet(&mut self, out: &mut Writer, sheet: &Sheet) {
        out.open(b'{');
        self.page(out.key("page"), &sheet.page);
        out.key("pageId").whole(sheet.page_id);
        out.key("sheet").whole(sheet.sheet);
        out.rest(&sheet.rest);
        out.close(b'}');
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
        self.part(out, PAGES, page, &|_, out, page| out.put(page));
    }

    /// The pages that are not edited, as a list or its index. Equal lists share one index.
    fn others(&mut self, out: &mut Writer, pages: &Pages) {
        let key = addresses(pages.others());
        if let Some(index) = self.books.get(&key).filter(|_| !self.inline) {
            return out.whole(*index);
        }
        let mut list = Writer::default();
        list.open(b'[');
        for sheet in pages.others() {
            list.item();
            self.part(&mut list, SHEETS, sheet, &|parts, out, sheet| parts.sheet(out, sheet));
        }
        list.close(b']');
        if self.inline {
            return out.append(&list);
        }
        let index = self.add(BOOKS, &list);
        self.books.insert(key, index);
        out.whole(index);
    }

    /// A part, or its index in a table.
    fn part<T>(
        &mut self,
        out: &mut Writer,
        table: usize,
        part: &Arc<T>,
        write: &dyn Fn(&mut Self, &mut Writer, &T),
    ) {
        self.named(out, table, address(part), &mut |parts, out| write(parts, out, part));
    }

    /// Returns the index of a list of parts. New lists are added to the second table.
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
        let index = self.add(table, &fresh);
        self.known.insert(address, index);
        out.whole(index);
    }

    /// Adds an entry to a table and returns its index.
    fn add(&mut self, table: usize, entry: &Writer) -> u64 {
        let (entries, count) = &mut self.tables[table];
        if !entries.is_empty() {
            entries.open(b',');
        }
        entries.append(entry);
        *count += 1;
        *count - 1
    }
}
