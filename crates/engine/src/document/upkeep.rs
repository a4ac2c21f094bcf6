//! Keeps inactive pages consistent with the photos: if a photo is excluded, it is removed from all pages. The
//! removal belongs to the undo step that excluded the photo.

use super::planning::{KEEP_ALL, Known, Planning, places_of};
use super::project::Sheet;
use crate::error::Result;
use crate::page::Document;
use crate::page::request::Keep;
use serde_json::{Map, Value};
use std::collections::HashSet;
use std::sync::Arc;

/// Groups of look-alikes by the ids of photos, as the selection has them.
pub type Groups = Map<String, Value>;

impl Planning<'_> {
    /// Whether another page has an empty panel or a photo that is not in use.
    #[must_use]
    pub fn torn(&self) -> bool {
        let used = self.used();
        self.project.pages.others().any(|sheet| !whole(&sheet.page, &used))
    }

    /// Replaces missing photos on all pages and removes pages without photos. Returns the pages and the index
    /// of the current one. `None` if nothing changes. Replacements prefer photos from the same group of
    /// near-duplicates.
    ///
    /// # Errors
    /// Errors of the planner.
    pub fn repaired(&self, groups: &Groups) -> Result<Option<(Vec<Arc<Sheet>>, usize)>> {
        let used = self.used();
        let others = self.project.pages.others();
        let torn: Vec<u64> =
            others.filter(|sheet| !whole(&sheet.page, &used)).map(|sheet| sheet.sheet).collect();
        if torn.is_empty() {
            return Ok(None);
        }
        let mut sheets = self.project.sheets().to_vec();
        for place in torn {
            let Some(at) = sheets.iter().position(|sheet| sheet.sheet == place) else { continue };
            let torn = sheets.remove(at);
            if let Some(page) = self.mended(&torn.page, &sheets, &used, groups)? {
                sheets.insert(at, Arc::new(Sheet { page: Arc::new(page), ..Sheet::clone(&torn) }));
            }
        }
        let edited = sheets.iter().position(|sheet| sheet.sheet == self.project.sheet());
        Ok(edited.map(|at| (sheets, at)))
    }

    #[inline(never)]
    fn used(&self) -> HashSet<&str> {
        self.photos.iter().map(Known::id).collect()
    }

    /// Returns the page with only photos in use, or `None` if no photo is left.
    #[inline(never)]
    fn mended(
        &self,
        page: &Document,
        rest: &[Arc<Sheet>],
        used: &HashSet<&str>,
        groups: &Groups,
    ) -> Result<Option<Document>> {
        let elsewhere: Vec<&Document> = rest.iter().map(|sheet| &*sheet.page).collect();
        let free = self.free(&elsewhere, Some(page));
        if free.is_empty() {
            return Ok(None);
        }
        let swap = |photo: &str| {
            let group = groups.get(photo).filter(|_| !used.contains(photo));
            let alike = free.iter().find(|other| group.is_some() && groups.get(other.id()) == group);
            alike.map_or_else(|| photo.to_owned(), |other| other.meta.id.clone())
        };
        let mut current = page.clone();
        current.order.clear();
        for photo in page.order.iter().map(|photo| swap(photo)) {
            if !current.order.contains(&photo) {
                current.order.push(photo);
            }
        }
        for panel in &mut current.panels {
            if let Some(photo) = panel.photo.as_deref().filter(|photo| !used.contains(photo)) {
                panel.photo = Some(swap(photo));
                (panel.crop, panel.edited, panel.locked) = (None, false, false);
                panel.faces.clear();
                panel.figure = None;
            }
        }
        // Text items move to the replacement.
        for word in &mut current.words {
            word.photo = word.photo.as_deref().map(&swap);
        }
        let layout = free.len() >= places_of(page);
        let mut request = self.request_for(Some(current), Keep { layout, ..KEEP_ALL }, page.seed);
        request.panels = (!layout).then_some(free.len());
        self.plan(request, Some(free))
    }
}

/// Whether all panels of a page show photos in use.
fn whole(page: &Document, used: &HashSet<&str>) -> bool {
    page.panels.iter().all(|panel| panel.photo.as_deref().is_some_and(|photo| used.contains(photo)))
}
