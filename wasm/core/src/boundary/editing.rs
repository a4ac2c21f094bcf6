//! A project while it is edited, held by the page.

use super::album::Album;
use inkpanel_engine::document::Dropped;
use inkpanel_engine::document::editor::Editor as Hands;
use inkpanel_engine::document::{kept, own};
use inkpanel_engine::error::Result;
use inkpanel_engine::json;
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

    /// Replaces the project by a history with tables (see `document::kept`). Throws `damaged-project`,
    /// `newer-project` or `too-large-project`, without any change. Returns `{dropped, pageId, sheet}` as
    /// JSON: the dropped parts, and ids for a new page and a new sheet.
    pub fn load(&mut self, json: &str) -> Result<String> {
        let (history, dropped) = kept::parse(json)?;
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

    /// Applies an edit: an object with a `type`, see `document::edit::Edit`. The album has the photos in use.
    /// Returns the changes as JSON, see `document::kept::difference`. Throws `invalid-document`, and for
    /// intents the errors of the planner, without any change.
    pub fn apply(&mut self, album: &Album, edit: &str) -> Result<String> {
        self.hands.apply_json_with(edit, &|| album.used())
    }

    /// Returns the page that an intent would make the current page, or null if the page stays.
    pub fn preview(&self, album: &Album, edit: &str) -> Result<String> {
        self.hands.preview_json(edit, album.used()?)
    }

    /// Returns why some panels of the current page cannot be merged or joined. `panels`: a list in JSON. Returns
    /// `{merge, join}`, each a reason, or null if nothing prevents it.
    pub fn obstacles(&self, panels: &str) -> Result<String> {
        self.hands.obstacles_json(panels)
    }

    /// The complete history with tables, as input of `load`.
    #[must_use]
    pub fn save(&self) -> String {
        kept::write(self.hands.history(), &Dropped::new())
    }
}

/// Applies the changes between two states of a list, which all projects share, to another state of it:
/// `{list, before, after}`. Returns the new list.
#[wasm_bindgen]
pub fn carried(lists: &str) -> Result<String> {
    own::carried_json(lists)
}
