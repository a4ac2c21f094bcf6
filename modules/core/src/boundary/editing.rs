//! A project while it is edited, held by the page.

use super::thrown;
use inkpanel::document::Dropped;
use inkpanel::document::editor::Editor as Hands;
use inkpanel::document::{kept, own};
use inkpanel::json;
use wasm_bindgen::prelude::*;

/// An editor.
#[wasm_bindgen]
#[derive(Default)]
pub struct Editor {
    pub(super) hands: Hands,
}

#[wasm_bindgen]
impl Editor {
    /// An editor of an empty project.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Puts a history with tables of its parts (see `document::kept`) in the place of what is there. Throws
    /// `damaged-project`, `newer-project` or `too-large-project`, and then nothing changed. Gives `{dropped, pageId, sheet}`:
    /// what was left out, and ids for a new page and a new place, as JSON.
    pub fn load(&mut self, json: &str) -> std::result::Result<String, JsValue> {
        let (history, dropped) = kept::parse(json).map_err(thrown)?;
        let mut out = json::Writer::default();
        out.open(b'{');
        out.key("dropped").texts(&dropped);
        let (page_id, sheet) = history.fresh();
        out.key("pageId").whole(page_id);
        out.key("sheet").whole(sheet);
        out.close(b'}');
        self.hands = Hands::new(history);
        Ok(out.finish())
    }

    /// Does something: an object with a `type`, as `document::edit::Edit` reads it. Gives what changed as JSON: see
    /// `document::kept::difference`. Throws `invalid-document`, and then nothing changed.
    pub fn apply(&mut self, edit: &str) -> std::result::Result<String, JsValue> {
        self.hands.apply_json(edit).map_err(thrown)
    }

    /// The whole history with tables of its parts, which `load` takes.
    #[must_use]
    pub fn save(&self) -> String {
        kept::write(self.hands.history(), &Dropped::new())
    }
}

/// What was done between two states of a list that all projects share, done to another state of it: `{list, before, after}`,
/// gives such a list.
#[wasm_bindgen]
pub fn carried(lists: &str) -> std::result::Result<String, JsValue> {
    own::carried_json(lists).map_err(thrown)
}
