//! The pages of a storyboard.

use super::project::{Pages, Project, Sheet};
use crate::json::Writer;
use crate::page::Document;
use crate::raster::Matte;
use std::collections::HashSet;
use std::sync::Arc;

impl Project {
    /// The edited page; `None` without pages.
    #[must_use]
    pub fn page(&self) -> Option<&Document> {
        self.pages.edited().map(|sheet| &*sheet.page)
    }

    /// Id of the edited page in the page history. Without pages, the id of the last edited page.
    #[must_use]
    pub fn page_id(&self) -> u64 {
        self.pages.ids().0
    }

    /// Names the place of the edited page in the storyboard through all its versions. Without pages it is the
    /// place of the last one.
    #[must_use]
    pub fn sheet(&self) -> u64 {
        self.pages.ids().1
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

    /// Photos that appear twice on a page, or on two pages, although there are enough photos.
    #[must_use]
    pub fn claimed_twice(&self) -> Vec<String> {
        let mut seen = HashSet::new();
        let mut twice = Vec::new();
        for sheet in self.sheets() {
            for photo in photos_on(&[&sheet.page]) {
                if !seen.insert(photo.to_owned()) {
                    twice.push(photo.to_owned());
                }
            }
        }
        twice
    }

    /// Takes over the page settings of the edited page.
    pub fn follow_paper(&mut self) {
        if let Some(page) = self.page().map(|page| &page.page).filter(|paper| **paper != *self.settings) {
            self.settings = Arc::new(page.clone());
        }
    }

    /// Replaces the pages of the storyboard. `None` if `active` is out of range.
    #[must_use]
    pub(crate) fn set_pages(&mut self, sheets: &[Arc<Sheet>], active: usize) -> Option<()> {
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

/// Sets the number of a page of a book, from 1. Returns whether the text changed.
pub fn renumber(page: &mut Document, number: usize) -> bool {
    let text = number.to_string();
    let mut changed = false;
    for word in page.words.iter_mut().filter(|word| word.number) {
        changed |= word.text != text;
        word.text.clone_from(&text);
    }
    changed
}

/// Writes sheets. Pages that were already in `before` are omitted.
pub fn write(out: &mut Writer, sheets: &[Arc<Sheet>], before: &[Arc<Sheet>]) {
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
pub(crate) fn exchanged(page: &Document, id: &str, by: &str) -> Option<Document> {
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
pub(crate) fn with_figures(page: &Document, id: &str, figure: Option<&Matte>) -> Option<Document> {
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
pub(crate) fn without(page: &Document, gone: &dyn Fn(&str) -> bool) -> Option<Document> {
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
