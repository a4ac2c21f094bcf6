//! A book of the edited project, made page by page, so that the app stays responsive.

use super::album::Album;
use super::editing::Editor;
use super::parse;
use super::planning::parse_request;
use inkpanel_engine::document::planning::{Planning, Seeds};
use inkpanel_engine::error::Result;
use inkpanel_engine::page::book::{Book, Wish};
use wasm_bindgen::prelude::*;

/// A book that is being made.
#[wasm_bindgen]
pub struct BookMaker {
    book: Book,
}

#[wasm_bindgen]
impl BookMaker {
    /// Number of pages.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn length(&self) -> usize {
        self.book.len()
    }

    /// Plans the next page. Returns whether there are more.
    pub fn step(&mut self) -> Result<bool> {
        self.book.step()
    }
}

#[wasm_bindgen]
impl Editor {
    /// Begins a book of the photos in use. `request` has a seed and preferences; `wish` is a `page::book::Wish` in JSON.
    /// Nothing without a page.
    pub fn book(&self, album: &Album, request: &str, wish: &str) -> Result<Option<BookMaker>> {
        let mut request = parse_request(request)?;
        let wish: Wish = parse(wish, "book")?;
        let mut planning: Planning = self.planning(album)?;
        planning.taste = std::mem::take(&mut request.taste);
        request.seed = Seeds::new(u64::from(request.seed)).next_seed();
        Ok(planning.book(&request, wish)?.map(|book| BookMaker { book }))
    }

    /// The pages of a book that is made: a list of sheets.
    pub fn booked(&self, album: &Album, made: BookMaker) -> Result<String> {
        let fresh = self.hands.history().fresh();
        self.planning(album).map(|planning| planning.booked_json(made.book, fresh))
    }
}
