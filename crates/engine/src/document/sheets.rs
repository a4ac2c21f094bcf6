//! The pages of a storyboard. A project stores the current page separately, so edits of the page do not
//! depend on the other pages. Here all pages are one list in reading order.

use super::project::{Project, Sheet};
use crate::json::Writer;
use crate::page::Document;
use crate::page::book::renumber;
use crate::raster::Matte;
use serde_json::Map;
use std::collections::HashSet;
use std::sync::Arc;

impl Project {
    /// All pages in order, including the current one. Empty without pages.
    #[must_use]
    pub fn sheets(&self) -> Vec<Arc<Sheet>> {
        let Some(page) = &self.page else { return Vec::new() };
        let own = Sheet { page: page.clone(), page_id: self.page_id, sheet: self.sheet, rest: Map::new() };
        let (before, behind) = self.others.split_at(self.at.min(self.others.len()));
        before.iter().cloned().chain([Arc::new(own)]).chain(behind.iter().cloned()).collect()
    }

    /// Replaces the pages of the storyboard. `None` if `at` is out of range.
    #[must_use]
    pub(super) fn set_sheets(&mut self, sheets: &[Arc<Sheet>], at: usize) -> Option<()> {
        let sheets = numbered(sheets);
        let edited = sheets.get(at)?;
        self.page = Some(edited.page.clone());
        (self.page_id, self.sheet, self.at) = (edited.page_id, edited.sheet, at);
        let others = sheets.iter().enumerate().filter(|(i, _)| *i != at).map(|(_, sheet)| sheet.clone());
        self.others = others.collect();
        if *self.settings != edited.page.page {
            self.settings = Arc::new(edited.page.page.clone());
        }
        Some(())
    }

    /// Changes the pages for which `change` returns a new one.
    pub(super) fn each_page(&mut self, change: &mut dyn FnMut(&Arc<Document>) -> Option<Arc<Document>>) {
        if let Some(page) = self.page.as_ref().and_then(&mut *change) {
            self.page = Some(page);
        }
        let mut others = self.others.to_vec();
        let mut changed = false;
        for sheet in &mut others {
            if let Some(page) = change(&sheet.page) {
                *sheet = Arc::new(Sheet { page, ..Sheet::clone(sheet) });
                changed = true;
            }
        }
        if changed {
            self.others = others.into();
        }
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

/// Changes the page with that index. `None` leaves it unchanged.
type NumberedChange<'c> = dyn FnMut(usize, &Arc<Document>) -> Option<Arc<Document>> + 'c;

impl Project {
    /// [`Project::each_page`] with the number of each page in the storyboard.
    pub(super) fn each_numbered_page(&mut self, change: &mut NumberedChange<'_>) {
        let edited = self.at;
        // The page that is edited comes first.
        let mut told = 0;
        self.each_page(&mut |page| {
            let number = match told {
                0 => edited,
                other if other <= edited => other - 1,
                other => other,
            };
            told += 1;
            change(number, page)
        });
    }
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
