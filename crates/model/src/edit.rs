//! All edits of a project as plain data, and the pure function that applies them to a state.

use super::draft::Draft;
use super::intent::Intent;
use super::limits::{
    GREATEST_ID, LONGEST_ID, LONGEST_NAME, MOST_ADDED, MOST_LAYOUTS, MOST_LOVED, MOST_PHOTOS, MOST_SHEETS,
    MOST_STYLES, MOST_WAITING, MOST_WANTED, MOST_WORDS,
};
use super::project::{self, Focus, List, Order, Project, Sheet, Styling, TrayItem};
use super::shots::{self, Board, Shot};
use super::{following, own, sheets, validation};
use crate::json::fields::whole_of;
use crate::json::{Fields, Read, Wrong, each, items, text_of};
use crate::layout::PageSettings;
use crate::page::Document;
use crate::raster::Matte;
use crate::reference::CustomFile;
use crate::text::NewText;
use crate::text::TextItem;
use crate::text_links::tied;
use serde_json::{Map, Value};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// An edit. In JSON, an object with the name of the edit as `type`, and its fields.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "typescript",
    derive(ts_rs::TS),
    ts(tag = "type", rename_all = "kebab-case", rename_all_fields = "camelCase")
)]
#[allow(clippy::large_enum_variant, reason = "one at a time exists")]
pub enum Edit {
    /// Adds photos to the tray.
    AddPhotos {
        /// Their ids.
        ids: Vec<String>,
    },
    /// Photos leave it, and the pages with it.
    RemovePhotos {
        /// Their ids.
        ids: Vec<String>,
    },
    /// Unreadable photos are removed from all states, so no undo restores them.
    ForgetPhotos {
        /// Their ids.
        ids: Vec<String>,
    },
    /// Photos are used, or not.
    UsePhotos {
        /// Which, by id.
        #[cfg_attr(feature = "typescript", ts(type = "Record<string, boolean>"))]
        uses: Vec<(String, bool)>,
    },
    /// Replaces a photo everywhere.
    ExchangePhoto {
        /// The replaced photo.
        id: String,
        /// The new photo.
        by: String,
    },
    /// Sets how photos are selected and ordered. Missing fields stay unchanged.
    ChooseBy {
        /// Bits in which fingerprints of look-alikes may differ.
        #[cfg_attr(feature = "typescript", ts(optional = nullable))]
        alike: Option<u8>,
        /// The order.
        #[cfg_attr(feature = "typescript", ts(optional = nullable))]
        order: Option<Order>,
    },
    /// The point of a photo that matters.
    FocusPhoto {
        /// The photo.
        id: String,
        /// `None` removes the focus point.
        focus: Option<Focus>,
    },
    /// Stars a photo, which gets a large panel, or removes the star.
    StarPhoto {
        /// The photo.
        id: String,
        /// Whether it is starred.
        on: bool,
    },
    /// Sets the corrected subject mask of a photo.
    MaskPhoto {
        /// The photo.
        id: String,
        /// `None` restores the detected mask.
        #[cfg_attr(feature = "typescript", ts(type = "string | null"))]
        mask: Option<Matte>,
        /// The detected mask, for the panel breakouts of the photo.
        #[cfg_attr(feature = "typescript", ts(type = "string", optional))]
        found: Option<Matte>,
    },
    /// Sets the shot metadata of photos.
    DescribeShots {
        /// The complete metadata of each shot, by photo id.
        #[cfg_attr(feature = "typescript", ts(type = "Record<string, Shot>"))]
        shots: Vec<(String, Shot)>,
    },
    /// How the shots are counted, ordered and laid out.
    SetBoard {
        /// The complete settings of the storyboard.
        #[cfg_attr(feature = "typescript", ts(as = "Board"))]
        board: Arc<Board>,
    },
    /// A part of the page is locked, or no longer.
    Lock {
        /// Which.
        part: Part,
        /// Whether it is locked.
        on: bool,
    },
    /// Sets the number of panels.
    WantPanels {
        /// None for any.
        count: Option<u32>,
    },
    /// Another page is the page.
    ShowPage {
        /// It.
        page: Arc<Document>,
        /// Id of the page in the page history.
        page_id: u64,
    },
    /// The page changes.
    ChangePage {
        /// The new page.
        page: Arc<Document>,
    },
    /// Sets the page settings, with the page on the new paper.
    ChangeSettings {
        /// The settings.
        settings: Arc<PageSettings>,
        /// The page, or `None` without a page.
        page: Option<Arc<Document>>,
    },
    /// The pages of the storyboard.
    SetSheets {
        /// In order, one at least.
        sheets: Vec<Arc<Sheet>>,
        /// Which is edited from now on.
        at: usize,
    },
    /// Adds new text items to pages and photos.
    AddWords {
        /// Each has its page index as `sheet` and its `panel`, or its `photo`. `joins` continues the text
        /// item before.
        #[cfg_attr(
            feature = "typescript",
            ts(type = "ReadonlyArray<Word & { sheet?: number; joins?: boolean }>")
        )]
        words: Vec<NewText>,
    },
    /// Replaces the text items of pages.
    SetWords {
        /// For each page its index in the storyboard, and all its text items.
        #[cfg_attr(
            feature = "typescript",
            ts(type = "ReadonlyArray<{ at: number; words: ReadonlyArray<Word> }>")
        )]
        pages: Vec<(usize, Vec<TextItem>)>,
    },
    /// Deletes unplaced text items.
    DropWaiting {
        /// Their numbers.
        words: Vec<usize>,
    },
    /// The page was removed.
    NoPage,
    /// Sets the draft of the designer.
    Design {
        /// `None` for an empty designer.
        draft: Option<Arc<Draft>>,
    },
    /// Sets the custom styles.
    OwnStyles {
        /// All of them.
        #[cfg_attr(feature = "typescript", ts(as = "Vec<crate::style::Style>"))]
        mine: List<CustomFile>,
    },
    /// Styles that are favourites.
    Favourites {
        /// All of them.
        #[cfg_attr(feature = "typescript", ts(as = "Vec<crate::style::Style>"))]
        favourites: List<CustomFile>,
    },
    /// Sets the custom layouts.
    OwnLayouts {
        /// All of them.
        #[cfg_attr(feature = "typescript", ts(as = "Vec<crate::layout::Template>"))]
        own_layouts: List<CustomFile>,
    },
    /// A page shown is a favourite, or no longer.
    LovePage {
        /// Its id.
        page_id: u64,
        /// Whether it is.
        on: bool,
    },
    /// The project has another name.
    Rename {
        /// The project name.
        name: String,
    },
    /// How a shuffle draws styles.
    Styling {
        /// Its settings.
        styling: Styling,
    },
    /// One undo step back.
    Undo,
    /// One redo step forward.
    Redo,
    /// Replaces lists that all projects share with their current version, without an undo step.
    Share {
        /// The lists that changed.
        #[cfg_attr(feature = "typescript", ts(type = "Partial<SharedLists>"))]
        lists: Vec<(Shelf, List<CustomFile>)>,
    },
    /// Like `Share`, but other items of this project stay, at the end.
    Join {
        /// The lists to merge.
        #[cfg_attr(feature = "typescript", ts(type = "Partial<SharedLists>"))]
        lists: Vec<(Shelf, List<CustomFile>)>,
    },
    /// An edit of pages that needs the planner.
    #[cfg_attr(feature = "typescript", ts(untagged))]
    Plan(Intent),
}

/// A part of the page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(rename_all = "lowercase"))]
pub enum Part {
    /// Its layout.
    Layout,
    /// Its style.
    Style,
    /// Its photos.
    Photos,
}

/// A list that all projects share.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shelf {
    /// Custom styles.
    Mine,
    /// Favourite styles.
    Favourites,
    /// Custom layouts.
    Layouts,
}

impl Shelf {
    /// All of them, with their names in JSON.
    pub const ALL: [(Self, &str); 3] =
        [(Self::Mine, "mine"), (Self::Favourites, "favourites"), (Self::Layouts, "ownLayouts")];

    /// The list of a state.
    #[must_use]
    pub fn of(self, project: &Project) -> &List<CustomFile> {
        match self {
            Self::Mine => &project.mine,
            Self::Favourites => &project.favourites,
            Self::Layouts => &project.own_layouts,
        }
    }

    /// The list of a state, for changes.
    #[must_use]
    pub fn of_mut(self, project: &mut Project) -> &mut List<CustomFile> {
        match self {
            Self::Mine => &mut project.mine,
            Self::Favourites => &mut project.favourites,
            Self::Layouts => &mut project.own_layouts,
        }
    }
}

/// How an edit is recorded in the history. In JSON, fields next to the fields of the edit.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct How {
    /// Amends the present state without an undo step, for example while a page is still being completed.
    #[cfg_attr(feature = "typescript", ts(as = "Option<_>", optional))]
    pub silent: bool,
    /// Name of a coalesced edit, such as one drag of a slider. A step with the name of the step before joins
    /// it.
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub gesture: Option<String>,
}

impl Project {
    /// Returns the state after an edit, or `None` if nothing changes. Undo, redo, lists from other tabs and
    /// intents need more than one state, and change nothing here.
    #[must_use]
    #[allow(clippy::too_many_lines, reason = "an arm for each edit")]
    pub fn after(&self, edit: &Edit) -> Option<Self> {
        let mut next = self.clone();
        match edit {
            Edit::AddPhotos { ids } => next.tray = self.with_photos(ids)?,
            Edit::RemovePhotos { ids } | Edit::ForgetPhotos { ids } => return self.without(ids),
            Edit::UsePhotos { uses } => {
                let told = |on| -> HashSet<&str> {
                    uses.iter().filter(|(_, used)| *used == on).map(|(id, _)| id.as_str()).collect()
                };
                let (on, off) = (told(true), told(false));
                next.tray = mapped(&self.tray, |item| {
                    let id = item.id.as_str();
                    let used = on.contains(id);
                    (used || off.contains(id)).then(|| TrayItem { used: Some(used), ..item.clone() })
                });
            }
            Edit::ExchangePhoto { id, by } => next.exchange(id, by),
            Edit::ChooseBy { alike, order } => {
                next.alike = alike.unwrap_or(self.alike);
                next.order = order.unwrap_or(self.order);
                if (next.alike, next.order) == (self.alike, self.order) {
                    return None;
                }
            }
            Edit::FocusPhoto { id, focus } => {
                next.tray = mapped(&self.tray, |item| {
                    (item.id == *id).then(|| TrayItem { focus: *focus, ..item.clone() })
                });
            }
            Edit::StarPhoto { id, on } => {
                next.tray = mapped(&self.tray, |item| {
                    (item.id == *id).then(|| TrayItem { starred: *on, ..item.clone() })
                });
            }
            Edit::MaskPhoto { id, mask, found } => {
                next.tray = self.with_mask(id, mask.as_ref())?;
                let figure = mask.as_ref().or(found.as_ref());
                next.pages.each(&mut |_, page| sheets::with_figures(page, id, figure).map(Arc::new));
            }
            Edit::DescribeShots { shots } => next.tray = self.with_shots(shots)?,
            Edit::SetBoard { board } => {
                if self.board == *board {
                    return None;
                }
                next.tray = mapped(&self.tray, |item| {
                    board.taken(&self.board, &item.shot).map(|shot| TrayItem { shot, ..item.clone() })
                });
                next.board = board.clone();
            }
            Edit::Lock { part, on } => {
                let lock = match part {
                    Part::Layout => &mut next.locks.layout,
                    Part::Style => &mut next.locks.style,
                    Part::Photos => &mut next.locks.photos,
                };
                if *lock == *on {
                    return None;
                }
                *lock = *on;
            }
            Edit::WantPanels { count } => {
                if self.panels == *count {
                    return None;
                }
                next.panels = *count;
            }
            Edit::ShowPage { page, page_id } => {
                let sheet =
                    Sheet { page: page.clone(), page_id: *page_id, sheet: self.sheet(), rest: Map::new() };
                next.pages.replace_sheet(sheet);
                next.follow_paper();
            }
            Edit::ChangePage { page } => {
                self.page()?;
                next.pages.replace(page.clone());
                next.follow_paper();
            }
            Edit::ChangeSettings { settings, page } => {
                next.settings = settings.clone();
                match page {
                    Some(page) => next.pages.replace(page.clone()),
                    None => next.pages.clear(),
                }
            }
            Edit::SetSheets { sheets, at } => next.set_pages(sheets, *at)?,
            Edit::SetWords { pages } => {
                next.pages.each(&mut |at, page| {
                    let (_, words) = pages.iter().find(|(place, _)| *place == at)?;
                    let words: Vec<TextItem> = words.iter().map(|word| tied(word, &page.panels)).collect();
                    (words != page.words).then(|| Arc::new(Document { words, ..Document::clone(page) }))
                });
            }
            Edit::AddWords { words } => return self.with_words(words),
            Edit::DropWaiting { words } => return self.without_waiting(words),
            Edit::NoPage => {
                self.page()?;
                next.pages.clear();
            }
            Edit::Design { draft } => next.draft.clone_from(draft),
            Edit::OwnStyles { mine } => next.mine = own::reusing(&self.mine, mine),
            Edit::Favourites { favourites } => next.favourites = own::reusing(&self.favourites, favourites),
            Edit::OwnLayouts { own_layouts } => {
                next.own_layouts = own::reusing(&self.own_layouts, own_layouts);
            }
            Edit::LovePage { page_id, on } => next.loved = self.with_love(*page_id, *on)?,
            Edit::Rename { name } => {
                if self.name == *name {
                    return None;
                }
                next.name.clone_from(name);
            }
            Edit::Styling { styling } => next.styling = styling.clone(),
            Edit::Undo | Edit::Redo | Edit::Share { .. } | Edit::Join { .. } | Edit::Plan(_) => return None,
        }
        if matches!(
            edit,
            Edit::ShowPage { .. }
                | Edit::ChangePage { .. }
                | Edit::ChangeSettings { .. }
                | Edit::SetSheets { .. }
                | Edit::SetWords { .. }
        ) {
            // A page that was shown before may have photos that are no longer on the table.
            let table: HashSet<&str> = self.tray.iter().map(|item| item.id.as_str()).collect();
            next.pages
                .each(&mut |_, page| sheets::without(page, &|photo| !table.contains(photo)).map(Arc::new));
            following::follow(self, &mut next);
        }
        Some(next)
    }

    /// Without some photos, on the table and on the pages. Pages never show photos that are not in the tray.
    fn without(&self, ids: &[String]) -> Option<Self> {
        Without::new(ids).state(self)
    }

    /// The tray with new photos. `None` if all exist or the tray is full.
    fn with_photos(&self, ids: &[String]) -> Option<List<TrayItem>> {
        let mut known: HashSet<&str> = self.tray.iter().map(|item| item.id.as_str()).collect();
        let mut tray = self.tray.to_vec();
        let fresh = ids.iter().filter(|id| known.insert(id)).cloned().map(TrayItem::new).map(Arc::new);
        tray.extend(fresh.take(MOST_PHOTOS.saturating_sub(self.tray.len())));
        (tray.len() > self.tray.len()).then(|| tray.into())
    }

    /// The tray with the corrected mask of a photo set or removed. `None` if nothing changes.
    fn with_mask(&self, id: &str, mask: Option<&Matte>) -> Option<List<TrayItem>> {
        let changed = |item: &TrayItem| item.id == id && item.mask.as_ref() != mask;
        self.tray.iter().any(|item| changed(item)).then(|| {
            mapped(&self.tray, |item| changed(item).then(|| TrayItem { mask: mask.cloned(), ..item.clone() }))
        })
    }

    /// The tray with shot metadata. `None` if nothing changes.
    fn with_shots(&self, shots: &[(String, Shot)]) -> Option<List<TrayItem>> {
        let told: HashMap<&str, &Shot> = shots.iter().map(|(id, shot)| (id.as_str(), shot)).collect();
        let fresh = |item: &TrayItem| told.get(item.id.as_str()).copied().filter(|shot| **shot != item.shot);
        self.tray.iter().any(|item| fresh(item).is_some()).then(|| {
            mapped(&self.tray, |item| fresh(item).map(|shot| TrayItem { shot: shot.clone(), ..item.clone() }))
        })
    }

    /// Replaces a photo. A new photo that is already in the tray moves to the position of the old one.
    fn exchange(&mut self, id: &str, by: &str) {
        let others: Vec<_> = self.tray.iter().filter(|item| item.id != by || id == by).cloned().collect();
        if others.iter().any(|item| item.id == id) {
            // A correction belongs to one photo and stays with it.
            let mask = self.corrected_mask(by).cloned();
            self.tray = mapped(&others, |item| {
                (item.id == id).then(|| TrayItem {
                    id: by.to_owned(),
                    used: Some(true),
                    mask: mask.clone(),
                    ..item.clone()
                })
            });
            self.pages.each(&mut |_, page| sheets::exchanged(page, id, by).map(Arc::new));
            self.words_exchanged(id, by);
            if self.board.order.iter().any(|other| other == id) {
                let board = Arc::make_mut(&mut self.board);
                board.order.retain(|other| other != by || id == by);
                board.order.iter_mut().filter(|other| *other == id).for_each(|other| by.clone_into(other));
            }
        }
    }

    /// Adds or removes a favourite. `None` if nothing changes.
    fn with_love(&self, page_id: u64, on: bool) -> Option<Arc<[u64]>> {
        if self.loved.contains(&page_id) == on {
            return None;
        }
        let mut loved: Vec<_> = self.loved.iter().copied().filter(|id| *id != page_id).collect();
        if on {
            // The oldest are removed.
            loved.drain(..loved.len().saturating_sub(MOST_LOVED - 1));
            loved.push(page_id);
        }
        Some(loved.into())
    }
}

/// Removes photos. It caches changed pages, so that states which shared a page share the new one. Keep it
/// until all states are done.
pub struct Without<'a> {
    gone: HashSet<&'a str>,
    /// The conversion of each list, by address, if it changed. There are few.
    trays: Vec<(usize, Option<List<TrayItem>>)>,
    pages: Vec<(usize, Option<Arc<Document>>)>,
}

impl<'a> Without<'a> {
    /// `ids`: the photos to remove.
    #[must_use]
    pub fn new(ids: &'a [String]) -> Self {
        let gone = ids.iter().map(String::as_str).collect();
        Self { gone, trays: Vec::new(), pages: Vec::new() }
    }

    /// Returns the state without the photos, or `None` if it does not contain them.
    pub fn state(&mut self, state: &Project) -> Option<Project> {
        let gone = &self.gone;
        let tray = once(&mut self.trays, state.tray.as_ptr().addr(), || {
            let stay = |item: &&Arc<TrayItem>| !gone.contains(item.id.as_str());
            let tray: List<TrayItem> = state.tray.iter().filter(stay).cloned().collect();
            (tray.len() < state.tray.len()).then_some(tray)
        });
        let mut next = state.clone();
        let mut changed = tray.is_some();
        if let Some(tray) = tray {
            next.tray = tray;
        }
        next.pages.each(&mut |_, page| {
            let page = self.page(page);
            changed |= page.is_some();
            page
        });
        changed.then_some(next)
    }

    /// Returns the page without the photos, or `None` if it does not contain them.
    pub fn page(&mut self, page: &Arc<Document>) -> Option<Arc<Document>> {
        let gone = &self.gone;
        once(&mut self.pages, Arc::as_ptr(page).addr(), || {
            sheets::without(page, &|photo| gone.contains(photo)).map(Arc::new)
        })
    }
}

/// Returns the cached result for the part at that address, or makes it.
fn once<T: Clone>(made: &mut Vec<(usize, T)>, address: usize, make: impl FnOnce() -> T) -> T {
    if let Some((_, made)) = made.iter().find(|(of, _)| *of == address) {
        return made.clone();
    }
    let fresh = make();
    made.push((address, fresh.clone()));
    fresh
}

/// The list with some items changed.
fn mapped(tray: &[Arc<TrayItem>], change: impl Fn(&TrayItem) -> Option<TrayItem>) -> List<TrayItem> {
    tray.iter().map(|item| change(item).map_or_else(|| item.clone(), Arc::new)).collect()
}

impl Edit {
    /// Reads an edit and its recording mode: an object with a `type`, its fields, and optionally `silent` and
    /// `gesture`. `known` returns pages by id that are not included in full.
    ///
    /// # Errors
    /// Returns the location of the error.
    pub fn read(value: Value, known: &dyn Fn(u64) -> Option<Arc<Document>>) -> Read<(Self, How)> {
        let mut fields = Fields::of(value)?;
        let how = How {
            silent: fields.flag("silent")?,
            gesture: fields.nullable("gesture").text("gesture", LONGEST_NAME)?,
        };
        let kind = fields.name("type", LONGEST_ID)?;
        let edit = match kind.as_str() {
            "add-photos" => Self::AddPhotos { ids: ids(&mut fields)? },
            "remove-photos" => Self::RemovePhotos { ids: ids(&mut fields)? },
            "forget-photos" => Self::ForgetPhotos { ids: ids(&mut fields)? },
            "use-photos" => Self::UsePhotos { uses: fields.part("uses", &mut uses)?.unwrap_or_default() },
            "exchange-photo" => {
                Self::ExchangePhoto { id: fields.name("id", LONGEST_ID)?, by: fields.name("by", LONGEST_ID)? }
            }
            "choose-by" => Self::ChooseBy {
                alike: fields.nullable("alike").whole("alike", 0, 64)?.map(|bits| bits as u8),
                order: fields.nullable("order").part("order", &mut |order| Order::read(&order))?,
            },
            "focus-photo" => Self::FocusPhoto {
                id: fields.name("id", LONGEST_ID)?,
                focus: fields.nullable("focus").part("focus", &mut project::focus)?,
            },
            "star-photo" => Self::StarPhoto { id: fields.name("id", LONGEST_ID)?, on: fields.flag("on")? },
            "mask-photo" => Self::MaskPhoto {
                id: fields.name("id", LONGEST_ID)?,
                mask: fields.nullable("mask").part("mask", &mut project::mask)?,
                found: fields.nullable("found").part("found", &mut project::mask)?,
            },
            "describe-shots" => Self::DescribeShots {
                shots: fields.part("shots", &mut shots::described)?.unwrap_or_default(),
            },
            "set-board" => {
                Self::SetBoard { board: fields.part("board", &mut Board::shared)?.unwrap_or_default() }
            }
            "lock" => Self::Lock {
                part: fields.part("part", &mut part)?.unwrap_or(Part::Layout),
                on: fields.flag("on")?,
            },
            "want-panels" => {
                let count = fields.nullable("count").whole("count", 1, MOST_WANTED)?;
                Self::WantPanels { count: count.map(|count| count as u32) }
            }
            "show-page" => {
                let page_id = fields.count("pageId", 0, GREATEST_ID)?;
                Self::ShowPage { page: page(&mut fields, page_id, known)?, page_id }
            }
            "change-page" => Self::ChangePage { page: page(&mut fields, 0, &|_| None)? },
            "change-settings" => Self::ChangeSettings {
                settings: fields.part("settings", &mut validation::settings)?.unwrap_or_default(),
                page: fields.nullable("page").part("page", &mut validation::page)?,
            },
            "set-sheets" => {
                let sheets = fields.each("sheets", MOST_SHEETS, &|value| sheet(value, known))?;
                let at = fields.count("at", 0, sheets.len().saturating_sub(1) as u64)? as usize;
                let mut seen = HashSet::new();
                if sheets.is_empty() || !sheets.iter().all(|sheet| seen.insert(sheet.sheet)) {
                    return Err(Wrong::new("must be distinct pages, at least one").at("sheets"));
                }
                Self::SetSheets { sheets, at }
            }
            "add-words" => Self::AddWords { words: fields.each("words", MOST_ADDED, &NewText::read)? },
            "set-words" => Self::SetWords { pages: fields.each("pages", MOST_SHEETS, &words_of)? },
            "drop-waiting" => {
                let number = |number| whole_of(&number, 0, MOST_WAITING as u64).map(|number| number as usize);
                Self::DropWaiting { words: fields.each("words", MOST_WAITING, &number)? }
            }
            "no-page" => Self::NoPage,
            "design" => Self::Design { draft: fields.nullable("draft").part("draft", &mut Draft::read)? },
            "love-page" => {
                Self::LovePage { page_id: fields.count("pageId", 0, GREATEST_ID)?, on: fields.flag("on")? }
            }
            "rename" => {
                // A name has an end, wherever it is written.
                let name = fields.text("name", usize::MAX)?.unwrap_or_default();
                Self::Rename { name: name.chars().take(LONGEST_NAME).collect() }
            }
            "styling" => {
                Self::Styling { styling: fields.part("styling", &mut project::styling)?.unwrap_or_default() }
            }
            "undo" => Self::Undo,
            "redo" => Self::Redo,
            "share" | "join" => {
                let mut lists = Fields::of(fields.required("lists")?).map_err(|wrong| wrong.at("lists"))?;
                let mut told = Vec::new();
                for (shelf, name) in Shelf::ALL {
                    if let Some(list) = lists.part(name, &mut |list| self::shelf(list, shelf))? {
                        told.push((shelf, list));
                    }
                }
                if kind == "share" { Self::Share { lists: told } } else { Self::Join { lists: told } }
            }
            "own-styles" => Self::OwnStyles { mine: own(&mut fields, "mine", Shelf::Mine)? },
            "favourites" => {
                Self::Favourites { favourites: own(&mut fields, "favourites", Shelf::Favourites)? }
            }
            "own-layouts" => {
                Self::OwnLayouts { own_layouts: own(&mut fields, "ownLayouts", Shelf::Layouts)? }
            }
            _ => Self::Plan(Intent::read(&kind, fields)?),
        };
        Ok((edit, how))
    }
}

/// Reads the index of a page and its text items.
fn words_of(value: Value) -> Read<(usize, Vec<TextItem>)> {
    let mut fields = Fields::of(value)?;
    let at = fields.count("at", 0, MOST_SHEETS as u64)?;
    Ok((at as usize, fields.each("words", MOST_WORDS, &TextItem::read)?))
}

fn ids(fields: &mut Fields) -> Read<Vec<String>> {
    fields.each("ids", MOST_PHOTOS, &|id| text_of(id, LONGEST_ID))
}

fn uses(value: Value) -> Read<Vec<(String, bool)>> {
    let all = Fields::of(value)?.rest().into_iter();
    Ok(all.filter_map(|(id, used)| Some((id, used.as_bool()?))).collect())
}

fn part(value: Value) -> Read<Part> {
    match text_of(value, LONGEST_ID)?.as_str() {
        "layout" => Ok(Part::Layout),
        "style" => Ok(Part::Style),
        "photos" => Ok(Part::Photos),
        _ => Err(Wrong::new("must be one of layout, style, photos")),
    }
}

/// A list of that name, in full.
fn own(fields: &mut Fields, name: &str, shelf: Shelf) -> Read<List<CustomFile>> {
    let list = fields.part(name, &mut |list| self::shelf(list, shelf))?;
    Ok(list.unwrap_or_else(|| Arc::new([])))
}

fn shelf(value: Value, shelf: Shelf) -> Read<List<CustomFile>> {
    let all = match shelf {
        Shelf::Mine | Shelf::Favourites => each(items(value, MOST_STYLES)?, &CustomFile::style),
        Shelf::Layouts => each(items(value, MOST_LAYOUTS)?, &CustomFile::layout),
    };
    Ok(own::first_of_each(all?))
}

/// Reads a complete page, or the page with this id.
fn page(fields: &mut Fields, id: u64, known: &dyn Fn(u64) -> Option<Arc<Document>>) -> Read<Arc<Document>> {
    match fields.part("page", &mut validation::page)? {
        Some(page) => Ok(page),
        None => known(id).ok_or_else(|| Wrong::new("is missing").at("page")),
    }
}

fn sheet(value: Value, known: &dyn Fn(u64) -> Option<Arc<Document>>) -> Read<Arc<Sheet>> {
    let mut fields = Fields::of(value)?;
    let (page_id, place) = (fields.count("pageId", 0, GREATEST_ID)?, fields.count("sheet", 0, GREATEST_ID)?);
    let page = page(&mut fields, page_id, known)?;
    Ok(Arc::new(Sheet { page, page_id, sheet: place, rest: fields.rest() }))
}
