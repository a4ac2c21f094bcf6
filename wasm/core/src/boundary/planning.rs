//! Plans pages of the edited project: the photos for each page, and updates after changes. Each result is a
//! proposal. The app makes an edit of it.
//!
//! Every request is a `page::request::Request` in JSON with a seed and optional preferences. Each function
//! documents the other fields that it uses. A page is null if it is impossible.

use super::album::Album;
use super::editing::Editor;
use super::parse;
use inkpanel_engine::document::planning::{Planning, Seeds};
use inkpanel_engine::document::upkeep::Groups;
use inkpanel_engine::error::Result;
use inkpanel_engine::json::Writer;
use inkpanel_engine::page::Document;
use inkpanel_engine::page::request::{Request, Taste};
use serde_json::Value;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Editor {
    /// A new page. `photos`: ids as JSON; empty for the photos in use that are free for the page. `anew`:
    /// ignore the existing page. If not, the request uses the current page unless it contains one.
    pub fn plan(&self, album: &Album, request: &str, photos: &str, anew: bool) -> Result<String> {
        self.asked(album, request, &mut |planning, mut request| {
            if request.current.is_none() && !anew {
                request.current = planning.project.page.as_deref().cloned();
            }
            let mut own = None;
            if !photos.is_empty() {
                let ids: Vec<String> = parse(photos, "photos")?;
                own = Some(album.known(&ids)?);
            }
            Ok(told(planning.plan(request, own)?))
        })
    }

    /// Returns the page after the photos in use changed, with as few changes as possible. `grow`: there are
    /// more photos than before.
    pub fn refitted(&self, album: &Album, request: &str, grow: bool) -> Result<String> {
        self.asked(album, request, &mut |planning, request| Ok(told(planning.refitted(grow, request.seed)?)))
    }

    /// All pages of the storyboard, in order, with the settings of the request.
    pub fn on_paper(&self, album: &Album, request: &str) -> Result<String> {
        self.asked(album, request, &mut |planning, request| {
            let mut out = Writer::default();
            out.open(b'[');
            for sheet in planning.project.sheets() {
                out.item();
                out.put(&planning.on_paper(&sheet.page, &request.page)?);
            }
            out.close(b']');
            Ok(out.finish())
        })
    }

    /// Returns an earlier version of a page in its current form. The request has it as the current page.
    pub fn brought_back(&self, album: &Album, request: &str) -> Result<String> {
        self.asked(album, request, &mut |planning, request| {
            let page = request.current.as_ref().map(|page| planning.brought_back(page));
            Ok(told(page.transpose()?))
        })
    }

    /// Distributes the photos in use over new pages, which replace the present ones: a list of sheets, or
    /// null.
    pub fn spread(&self, album: &Album, request: &str) -> Result<String> {
        let fresh = self.hands.history().fresh();
        self.asked(album, request, &mut |planning, request| {
            planning.spread_json(fresh, &mut Seeds::new(u64::from(request.seed)))
        })
    }

    /// A page to be added, of photos that no page shows as long as there are some.
    pub fn another(&self, album: &Album, request: &str) -> Result<String> {
        self.asked(album, request, &mut |planning, request| {
            Ok(told(planning.another(&mut Seeds::new(u64::from(request.seed)))?))
        })
    }

    /// Returns whether another page shows a photo that is not in use.
    pub fn torn(&self, album: &Album) -> Result<bool> {
        self.planning(album).map(|planning| planning.torn())
    }

    /// Replaces missing photos on all pages and removes pages without photos: see `Planning::repaired_json`.
    /// `groups`: of look-alikes, by the ids of photos.
    pub fn repaired(&self, album: &Album, request: &str, groups: &str) -> Result<String> {
        self.asked(album, request, &mut |planning, _| {
            let groups = match parse(groups, "groups")? {
                Value::Object(groups) => groups,
                _ => Groups::new(),
            };
            planning.repaired_json(&groups)
        })
    }

    /// The photos in use that no page has shown yet, and why: a list of `{photo, why}`.
    pub fn unseen(&self, album: &Album) -> Result<String> {
        self.planning(album).map(|planning| planning.unseen_json())
    }

    /// The ids of the photos in use that are free for the page.
    pub fn free_photos(&self, album: &Album) -> Result<String> {
        let free = |planning: Planning| {
            let mut out = Writer::default();
            let free = planning.free(&planning.elsewhere(), planning.project.page.as_deref());
            out.list(&free, &|out, photo| out.text(photo.id()));
            out.finish()
        };
        self.planning(album).map(free)
    }
}

/// Makes the result of a request. A trait object, so that the shared code is compiled once.
type Answer<'a> = &'a mut dyn FnMut(&Planning, Request) -> Result<String>;

impl Editor {
    #[inline(never)]
    fn asked(&self, album: &Album, request: &str, answer: Answer) -> Result<String> {
        let mut request = parse_request(request)?;
        let mut planning = self.planning(album)?;
        planning.taste = std::mem::take(&mut request.taste);
        answer(&planning, request)
    }

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

#[inline(never)]
fn told(page: Option<Document>) -> String {
    page.map_or_else(|| "null".to_owned(), |page| page.to_json())
}
