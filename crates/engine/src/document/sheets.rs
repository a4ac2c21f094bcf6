//! The pages of a storyboard.

use super::limits::GREATEST_ID;
use super::project::{List, Parts, Project, Sheet};
use crate::json::{Fields, Read, Writer, Wrong};
use crate::page::Document;
use crate::page::book::renumber;
use crate::raster::Matte;
use serde_json::Map;
use std::collections::HashSet;
use std::sync::Arc;

/// The pages of a storyboard in reading order, and which one is edited.
///
/// In JSON, the edited page is the fields `page`, `pageId` and `sheet` of the project. `others` has the other
/// pages, and `at` is the index of the edited page among all pages.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Pages {
    list: List<Sheet>,
    /// Index of the edited page; 0 without pages.
    active: usize,
}

/// The fields of [`Pages`] in JSON.
#[cfg(test)]
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

#[cfg(test)]
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
        (active < pages.len()).then(|| Self { list: pages.into(), active })
    }

    /// Reads the pages from the fields of a project.
    ///
    /// # Errors
    /// Returns the location of the error.
    pub(super) fn read(fields: &mut Fields, parts: &mut dyn Parts) -> Read<Self> {
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
        let Some(page) = page else { return Ok(Self::default()) };
        let mut list = others.to_vec();
        list.insert(active, Arc::new(Sheet { page, page_id, sheet, rest: Map::new() }));
        Ok(Self { list: list.into(), active })
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

    /// The pages that are not edited, in reading order.
    pub fn others(&self) -> impl Iterator<Item = &Arc<Sheet>> {
        self.list.iter().enumerate().filter(|(i, _)| *i != self.active).map(|(_, sheet)| sheet)
    }

    /// Replaces the document of the edited page, or adds a first page.
    pub(super) fn replace(&mut self, page: Arc<Document>) {
        let sheet = match self.edited() {
            Some(sheet) => Sheet { page, ..Sheet::clone(sheet) },
            None => Sheet { page, page_id: 0, sheet: 0, rest: Map::new() },
        };
        self.replace_sheet(sheet);
    }

    /// Replaces the edited page, or adds a first page.
    pub(super) fn replace_sheet(&mut self, sheet: Sheet) {
        let mut list = self.list.to_vec();
        list.splice(self.active..(self.active + 1).min(list.len()), [Arc::new(sheet)]);
        self.list = list.into();
    }

    /// Changes the pages for which `change` returns a new one. It gets the index of each page.
    pub(super) fn each(&mut self, change: &mut Change<'_>) {
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

impl Project {
    /// The edited page; `None` without pages.
    #[must_use]
    pub fn page(&self) -> Option<&Document> {
        self.pages.edited().map(|sheet| &*sheet.page)
    }

    /// Id of the edited page in the page history; 0 without pages.
    #[must_use]
    pub fn page_id(&self) -> u64 {
        self.pages.edited().map_or(0, |sheet| sheet.page_id)
    }

    /// Names the place of the edited page in the storyboard through all its versions; 0 without pages.
    #[must_use]
    pub fn sheet(&self) -> u64 {
        self.pages.edited().map_or(0, |sheet| sheet.sheet)
    }

    /// All pages in reading order.
    #[must_use]
    pub fn sheets(&self) -> &[Arc<Sheet>] {
        self.pages.list()
    }

    /// Returns whether the storyboard has pages besides the edited one.
    #[must_use]
    pub fn has_several_pages(&self) -> bool {
        self.sheets().len() > 1
    }

    /// The page settings become those of the edited page.
    pub(super) fn follow_paper(&mut self) {
        if let Some(page) = self.page().map(|page| &page.page).filter(|paper| **paper != *self.settings) {
            self.settings = Arc::new(page.clone());
        }
    }

    /// Replaces the pages of the storyboard. `None` if `active` is out of range.
    #[must_use]
    pub(super) fn set_pages(&mut self, sheets: &[Arc<Sheet>], active: usize) -> Option<()> {
        self.pages = Pages::new(numbered(sheets), active)?;
        self.follow_paper();
        Some(())
    }
}

/// The pages with the numbers of a book in their order.
fn numbered(sheets: &[Arc<Sheet>]) -> Vec<Arc<Sheet>> {
    let number = |(i, sheet): (usize, &Arc<Sheet>)| {
        if !sheet.page.words.iter().any(|word| word.number) {
            return sheet.clone();
        }
        let mut page = sheet.page.as_ref().clone();
        if renumber(&mut page, i + 1) {
            Arc::new(Sheet { page: Arc::new(page), ..sheet.as_ref().clone() })
        } else {
            sheet.clone()
        }
    };
    sheets.iter().enumerate().map(number).collect()
}

/// Writes sheets. Pages that were already in `before` are omitted.
pub(super) fn write(out: &mut Writer, sheets: &[Arc<Sheet>], before: &[Arc<Sheet>]) {
    out.list(sheets, &|out, sheet| {
        out.open(b'{');
        if !before.iter().any(|before| Arc::ptr_eq(&before.page, &sheet.page)) {
            out.key("page").put(&*sheet.page);
        }
        out.key("pageId").whole(sheet.page_id);
        out.key("sheet").whole(sheet.sheet);
        out.rest(&sheet.rest);
        out.close(b'}');
    });
}

/// The photos on some pages.
#[must_use]
#[inline(never)]
pub fn photos_on<'a>(pages: &[&'a Document]) -> HashSet<&'a str> {
    let mut photos = HashSet::new();
    for page in pages {
        photos.extend(page.panels.iter().filter_map(|panel| panel.photo.as_deref()));
    }
    photos
}

/// Replaces a photo of the page. `None` if the page does not show it.
pub(super) fn exchanged(page: &Document, id: &str, by: &str) -> Option<Document> {
    let shown = page.panels.iter().filter_map(|panel| panel.photo.as_deref());
    if !shown.chain(page.order.iter().map(String::as_str)).any(|photo| photo == id) {
        return None;
    }
    let mut page = page.clone();
    let mut seen = HashSet::new();
    let order = std::mem::take(&mut page.order)
        .into_iter()
        .map(|photo| if photo == id { by.to_owned() } else { photo });
    page.order = order.filter(|photo| seen.insert(photo.clone())).collect();
    for panel in &mut page.panels {
        if panel.photo.as_deref() == Some(id) {
            panel.photo = Some(by.to_owned());
            panel.faces.clear();
            panel.figure = None;
        }
    }
    Some(page)
}

/// Updates the panel breakouts of a photo for another mask, or removes them without a mask. `None` if nothing
/// changes.
pub(super) fn with_figures(page: &Document, id: &str, figure: Option<&Matte>) -> Option<Document> {
    let shown = page.panels.iter().enumerate().filter(|(_, panel)| panel.photo.as_deref() == Some(id));
    let other = |at: &usize| {
        let before = page.panels[*at].figure.as_ref();
        before.is_some() && before != figure
    };
    let changed: Vec<usize> = shown.map(|(at, _)| at).filter(other).collect();
    (!changed.is_empty()).then(|| {
        let mut page = page.clone();
        for at in changed {
            page.panels[at].figure = figure.cloned();
        }
        page
    })
}

/// Empties the panels that show the given photos. `None` if the page shows none of them.
pub(super) fn without(page: &Document, gone: &dyn Fn(&str) -> bool) -> Option<Document> {
    let shown = page.panels.iter().filter_map(|panel| panel.photo.as_deref());
    if !shown.chain(page.order.iter().map(String::as_str)).any(gone) {
        return None;
    }
    let mut page = page.clone();
    page.order.retain(|photo| !gone(photo));
    for panel in &mut page.panels {
        if panel.photo.as_deref().is_some_and(gone) {
            (panel.photo, panel.crop, panel.edited) = (None, None, false);
            panel.faces.clear();
            panel.figure = None;
        }
    }
    Some(page)
}
