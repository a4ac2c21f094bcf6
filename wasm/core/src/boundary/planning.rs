//! Plans pages of the edited project: the photos for each page, and updates after changes. Each result is a
//! proposal. The app makes an edit of it.
//!
//! Every request is a `page::request::Request` in JSON with a seed and optional preferences. Each function
//! documents the other fields that it uses. A page is null if it is impossible.

use super::album::Album;
use super::editing::Editor;
use super::parse;
use inkpanel_engine::document::planning::Planning;
use inkpanel_engine::error::Result;
use inkpanel_engine::json::Writer;
use inkpanel_engine::page::request::{Request, Taste};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Editor {
    /// A new page. `photos`: ids as JSON; empty for the photos in use that are free for the page. `anew`:
    /// ignore the existing page. If not, the request uses the current page unless it contains one.
    pub fn plan(&self, album: &Album, request: &str, photos: &str, anew: bool) -> Result<String> {
        let mut request = parse_request(request)?;
        let mut planning = self.planning(album)?;
        planning.taste = std::mem::take(&mut request.taste);
        if request.current.is_none() && !anew {
            request.current = planning.project.page().cloned();
        }
        let mut own = None;
        if !photos.is_empty() {
            let ids: Vec<String> = parse(photos, "photos")?;
            own = Some(album.known(&ids)?);
        }
        let page = planning.plan(request, own)?;
        Ok(page.map_or_else(|| "null".to_owned(), |page| page.to_json()))
    }

    /// Returns whether another page shows a photo that is not in use.
    pub fn torn(&self, album: &Album) -> Result<bool> {
        self.planning(album).map(|planning| planning.torn())
    }

    /// The photos in use that no page has shown yet, and why: a list of `{photo, why}`.
    pub fn unseen(&self, album: &Album) -> Result<String> {
        self.planning(album).map(|planning| planning.unseen_json())
    }

    /// The ids of the photos in use that are free for the page.
    pub fn free_photos(&self, album: &Album) -> Result<String> {
        let free = |planning: Planning| {
            let mut out = Writer::default();
            let free = planning.free(&planning.elsewhere(), planning.project.page());
            out.list(&free, &|out, photo| out.text(photo.id()));
            out.finish()
        };
        self.planning(album).map(free)
    }
}

impl Editor {
    #[inline(never)]
    pub(super) fn planning<'p>(&'p self, album: &'p Album) -> Result<Planning<'p>> {
        let planning = Planning {
            project: self.hands.project(),
            photos: album.used()?,
            taste: Taste::default(),
            recent: Vec::new(),
        };
        Ok(planning.with_memory(self.hands.history()))
    }
}

#[inline(never)]
pub(super) fn parse_request(json: &str) -> Result<Request> {
    parse(json, "request")
}
