//! Distributes an album over pages: number of pages, photos of each page, and text items with their photos.

use super::limits::{MOST_SHEETS, MOST_WORDS};
use super::planning::{Known, Planning, Seeds, places_of};
use super::project::Sheet;
use crate::error::Result;
use crate::layout;
use crate::page::request::{Keep, Mode, Request};
use crate::page::text_links::{belongs, photo_of, tied};
use crate::page::{Document, LayoutRef};
pub use crate::plan::spread::balanced;
use serde_json::Map;
use std::sync::Arc;

/// Default number of panels of later pages, and maximum of a first page. At this size photos are easy to see.
pub const USUAL: usize = 6;
/// Minimum number of unplaced photos for another page.
const FEWEST: usize = 2;
/// Seeds are tried this often for a layout that the two pages before do not have.
const TRIES: usize = 6;

impl Planning<'_> {
    /// Distributes all photos in use over as many pages as needed, replacing the present pages, in the style
    /// of the current page. `None` without a page. `fresh` is the first unused page id and the first unused
    /// sheet id.
    ///
    /// # Errors
    /// Errors of the planner.
    pub fn spread(&self, fresh: (u64, u64), seeds: &mut Seeds) -> Result<Option<Vec<Arc<Sheet>>>> {
        let Some(page) = self.project.page().filter(|_| !self.photos.is_empty()) else {
            return Ok(None);
        };
        let before = self.project.sheets();
        let fixed = self.project.locks.layout.then(|| (&page.layout, places_of(page)));
        let mut made: Vec<Document> = Vec::new();
        let mut rest = &self.photos[..];
        for size in self.sizes(fixed.map(|(_, places)| places)) {
            let (own, later) = rest.split_at(size.min(rest.len()));
            rest = later;
            let layout = fixed.filter(|(_, places)| *places == size).map(|(layout, _)| layout.clone());
            let draw = |seed| {
                let mut request = self.anew(seed);
                (request.panels, request.layout) = (Some(size), layout.clone());
                self.plan(request, Some(own.to_vec()))
            };
            if let Some(fresh) = varied(&made, seeds, &draw)? {
                made.push(with_words(fresh, before));
            }
        }
        let sheet = |(i, page): (usize, Document)| {
            // Each page takes the place of an existing page, whose versions stay available.
            let place = before.get(i).map_or(fresh.1 + i as u64, |sheet| sheet.sheet);
            Arc::new(Sheet {
                page: Arc::new(page),
                page_id: fresh.0 + i as u64,
                sheet: place,
                rest: Map::new(),
            })
        };
        Ok(Some(made.into_iter().enumerate().map(sheet).collect()))
    }

    /// A request for another page in the style of the page.
    #[inline(never)]
    fn anew(&self, seed: u32) -> Request {
        let mut request = self.request_for(None, Keep::default(), seed);
        request.style = self.project.page().map(|page| page.style.clone());
        request
    }

    /// Returns the number of photos on each page. `fixed`: panels of the layout, if all pages have the same.
    fn sizes(&self, fixed: Option<usize>) -> Vec<usize> {
        let count = self.photos.len();
        // A large album has more photos per page than wanted, to limit the number of pages.
        let least = count.div_ceil(MOST_SHEETS);
        if let Some(places) = fixed.filter(|places| *places >= least) {
            return filled(count, places);
        }
        let layouts = layout::good_for(self.project.settings.aspect());
        let counts: Vec<usize> = layouts.iter().map(|template| template.panels().len()).collect();
        balanced(count, self.wanted().max(least), &counts)
    }

    /// Panels of a page among others.
    fn wanted(&self) -> usize {
        self.project.panels.map_or(USUAL, |panels| panels as usize)
    }

    /// Plans another page in the style of the current page. It uses unplaced photos as long as there are any.
    /// `None` without a page.
    ///
    /// # Errors
    /// Errors of the planner.
    pub fn another(&self, seeds: &mut Seeds) -> Result<Option<Document>> {
        let Some(page) = self.project.page() else { return Ok(None) };
        let locked = self.project.locks.layout;
        let wanted = if locked { places_of(page) } else { self.wanted() };
        let mut all = self.elsewhere();
        all.push(page);
        let left = self.free(&all, None);
        let enough = left.len() >= if locked { wanted } else { FEWEST };
        let photos: Vec<Known> =
            if enough { left.into_iter().take(wanted).collect() } else { self.photos.clone() };
        let draw = |seed| {
            let mut request = self.anew(seed);
            request.panels = Some(wanted.min(photos.len()));
            request.layout = locked.then(|| page.layout.clone());
            // Photos that are already on a page need another order, because the new page would be equal.
            request.mode = if enough { Mode::Shuffle } else { Mode::Photos };
            self.plan(request, Some(photos.clone()))
        };
        varied(std::slice::from_ref(page), seeds, &draw)
    }
}

/// The page with the previous text items of its photos. Items of a whole page stay with their first photo.
#[inline(never)]
pub(super) fn with_words(page: Document, before: &[Arc<Sheet>]) -> Document {
    // Unplaced text of these photos is already on the page.
    let mut words = page.words;
    for old in before.iter().map(|sheet| &sheet.page) {
        let first = old.panels.first().and_then(|panel| panel.photo.as_deref());
        let shows = |photo: &str| page.panels.iter().any(|panel| panel.photo.as_deref() == Some(photo));
        // Automatic text belongs to the old pages.
        for word in old.words.iter().filter(|word| !word.made) {
            let own = photo_of(word, &old.panels);
            if word.panel.is_none() && first.is_some_and(shows) {
                words.push(word.clone());
            } else if own.is_some_and(shows) {
                words.extend(belongs(&tied(word, &old.panels), &page.panels));
            }
        }
    }
    words.truncate(MOST_WORDS);
    Document { words, ..page }
}

/// Full pages, and the rest.
fn filled(count: usize, places: usize) -> Vec<usize> {
    let places = places.max(1);
    let rest = (!count.is_multiple_of(places)).then_some(count % places);
    std::iter::repeat_n(places, count / places).chain(rest).collect()
}

/// A page with another layout than the last two, if one was drawn.
#[inline(never)]
fn varied(
    made: &[Document],
    seeds: &mut Seeds,
    draw: &dyn Fn(u32) -> Result<Option<Document>>,
) -> Result<Option<Document>> {
    let seen: Vec<&LayoutRef> = made.iter().rev().take(2).map(|page| &page.layout).collect();
    let mut page = draw(seeds.next_seed())?;
    for _ in 1..TRIES {
        if !page.as_ref().is_some_and(|page| seen.contains(&&page.layout)) {
            break;
        }
        page = draw(seeds.next_seed())?;
    }
    Ok(page)
}
