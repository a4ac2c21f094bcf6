//! A book of the photos in use, which replaces the pages of a project.

use super::limits::{MOST_SHEETS, MOST_WORDS};
use super::planning::{KEEP_ALL, Planning};
use super::project::{Order, Sheet};
use super::sheets;
use super::spreading::with_words;
use crate::error::Result;
use crate::framing::PhotoMeta;
use crate::json::Writer;
use crate::page::Document;
use crate::page::book::{Book, Wish};
use crate::page::request::{Keep, Request};
use crate::plan::Shelf;
use serde_json::Map;
use std::sync::Arc;

impl Planning<'_> {
    /// Begins a book of the photos in use, in the style of the current page. `None` without a page or photos. `request` has
    /// the seed and the preferences.
    ///
    /// # Errors
    /// Errors of [`Book::new`].
    pub fn book(&self, request: &Request, wish: Wish) -> Result<Option<Book>> {
        let Some(page) = self.project.page().filter(|_| !self.photos.is_empty()) else {
            return Ok(None);
        };
        let photos: Vec<PhotoMeta> = self.photos.iter().map(|photo| photo.meta.clone()).collect();
        let shelf =
            Shelf::of(self.photos.iter().map(|photo| photo.place.cloned().unwrap_or_default()).collect());
        let request = Request {
            photos,
            style: Some(page.style.clone()),
            figures: Some(false),
            duplicate_threshold: Some(u32::from(self.project.alike)),
            ordered: (self.project.order == Order::Name).then_some(true),
            keep: Keep { layout: false, photos: false, ..KEEP_ALL },
            styling: request.styling.clone(),
            ..self.request_for(None, Keep::default(), request.seed)
        };
        Book::new(request, wish, &shelf, MOST_SHEETS).map(Some)
    }

    /// The pages of a book as sheets in JSON, with the texts that the user wrote on the present pages. `fresh` is the first
    /// unused page id and the first unused sheet id.
    #[must_use]
    pub fn booked_json(&self, book: Book, fresh: (u64, u64)) -> String {
        let before = self.project.sheets();
        let sheet = |(i, page): (usize, Document)| {
            let texts = page.words.clone();
            let mut page = with_words(Document { words: Vec::new(), ..page }, before);
            page.words.extend(texts);
            page.words.truncate(MOST_WORDS);
            Arc::new(Sheet {
                page: Arc::new(page),
                page_id: fresh.0 + i as u64,
                sheet: before.get(i).map_or(fresh.1 + i as u64, |sheet| sheet.sheet),
                rest: Map::new(),
            })
        };
        let pages = book.pages().into_iter().map(|page| page.planned.document).enumerate();
        let sheets: Vec<Arc<Sheet>> = pages.map(sheet).collect();
        let mut out = Writer::default();
        sheets::write(&mut out, &sheets, &[]);
        out.finish()
    }
}
