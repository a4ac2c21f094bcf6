//! A project while it is edited, held by the page.

use super::album::Album;
use inkpanel_engine::document::editor::Editor as Hands;
use inkpanel_engine::document::{kept, own};
use inkpanel_engine::error::{Error, Result};
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

    /// Replaces the project by the output of `save`, and applies the changes of a journal that were made since: a
    /// list of lists of edits as JSON, or an empty text. An empty list ends the gesture. Throws `damaged-project`,
    /// `newer-project`, `too-large-project`, or `invalid-document` for the journal, without any change. Returns
    /// the project as JSON, see `document::kept::loaded`.
    pub fn load(&mut self, bytes: &[u8], journal: &str) -> Result<String> {
        let text = std::str::from_utf8(bytes).map_err(|_| Error::DamagedProject {
            location: "project".into(),
            reason: "is not UTF-8 text".into(),
        })?;
        let (hands, dropped) = Hands::load(text, journal)?;
        self.hands = hands;
        Ok(kept::loaded(self.hands.history(), &dropped))
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

    /// The complete history with tables, as input of `load`: JSON in UTF-8.
    pub fn save(&mut self) -> Vec<u8> {
        self.hands.save().into_bytes()
    }

    /// The ids of all photos of the history, a JSON array.
    #[must_use]
    pub fn photos(&self) -> String {
        self.hands.photos_json()
    }
}

/// Applies the changes between two states of a list, which all projects share, to another state of it:
/// `{list, before, after}`. Returns the new list.
#[wasm_bindgen]
pub fn carried(lists: &str) -> Result<String> {
    own::carried_json(lists)
}
