//! What the other pages of a storyboard owe to the photos, while a person edits one of them: a photo that is no longer in
//! use leaves them at once. It is no step of the undo: it belongs to the step that took the photo away.

use super::planning::{KEEP_ALL, Planning, photos_for, places_of};
use super::project::{Project, Sheet};
use crate::error::Result;
use crate::framing::PhotoMeta;
use crate::page::Document;
use crate::page::request::{Keep, Request};
use std::collections::HashSet;
use std::sync::Arc;

impl Planning<'_> {
    /// The pages with other photos where one is gone, and without pages that none is left for, and which of them is edited;
    /// none where nothing is to be done. `alike`: of a photo the one that was taken in its place.
    ///
    /// # Errors
    /// Those of the planner.
    pub fn repaired(
        &self,
        alike: &dyn Fn(&str) -> Option<String>,
    ) -> Result<Option<(Vec<Arc<Sheet>>, usize)>> {
        let used: HashSet<&str> = self.photos.iter().map(|photo| photo.id.as_str()).collect();
        let whole = |page: &Document| {
            page.panels.iter().all(|panel| panel.photo.as_deref().is_some_and(|photo| used.contains(photo)))
        };
        let torn: Vec<u64> =
            self.project.others.iter().filter(|sheet| !whole(&sheet.page)).map(|sheet| sheet.sheet).collect();
        if torn.is_empty() {
            return Ok(None);
        }
        let mut sheets = self.project.sheets();
        for place in torn {
            let Some(at) = sheets.iter().position(|sheet| sheet.sheet == place) else { continue };
            let torn = sheets.remove(at);
            if let Some(page) = self.mended(&torn.page, &sheets, &used, alike)? {
                sheets.insert(at, Arc::new(Sheet { page: Arc::new(page), ..Sheet::clone(&torn) }));
            }
        }
        let edited = sheets.iter().position(|sheet| sheet.sheet == self.project.sheet);
        Ok(edited.map(|at| (sheets, at)))
    }

    /// The page with photos in use only; nothing when there is none for it.
    fn mended(
        &self,
        page: &Document,
        rest: &[Arc<Sheet>],
        used: &HashSet<&str>,
        alike: &dyn Fn(&str) -> Option<String>,
    ) -> Result<Option<Document>> {
        let elsewhere: Vec<&Document> = rest.iter().map(|sheet| &*sheet.page).collect();
        let free = photos_for(self.photos, &elsewhere, Some(page));
        if free.is_empty() {
            return Ok(None);
        }
        let swap = |photo: &str| match alike(photo) {
            Some(other) if !used.contains(photo) && free.iter().any(|photo| photo.id == other) => other,
            _ => photo.to_owned(),
        };
        let mut current = page.clone();
        let mut seen = HashSet::new();
        current.order =
            current.order.iter().map(|photo| swap(photo)).filter(|id| seen.insert(id.clone())).collect();
        for panel in &mut current.panels {
            if let Some(photo) = panel.photo.as_deref().filter(|photo| !used.contains(photo)) {
                panel.photo = Some(swap(photo));
                (panel.crop, panel.edited, panel.locked) = (None, false, false);
            }
        }
        let layout = free.len() >= places_of(page);
        let photos: Vec<PhotoMeta> = free.into_iter().cloned().collect();
        let request = Request {
            keep: Keep { layout, ..KEEP_ALL },
            panels: (!layout).then_some(photos.len()),
            current: Some(current),
            photos,
            ..self.request(page.seed)
        };
        self.plan(request)
    }
}

impl Project {
    /// The photos that a page shows in two places although it has photos enough, and those on two pages: what the rule of
    /// a photo on one page only forbids where there are enough of them.
    #[must_use]
    pub fn claimed_twice(&self) -> Vec<String> {
        let mut seen = HashSet::new();
        let mut twice = Vec::new();
        for sheet in self.sheets() {
            for photo in super::sheets::photos_on([&*sheet.page]) {
                if !seen.insert(photo.to_owned()) {
                    twice.push(photo.to_owned());
                }
            }
        }
        twice
    }
}
