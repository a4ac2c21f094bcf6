//! Edits of a style in the designer. A draft is the JSON of `document::draft`.

use super::parse;
use inkpanel_engine::document::draft;
use inkpanel_engine::error::Result;
use inkpanel_engine::page::StyleRef;
use wasm_bindgen::prelude::*;

/// A draft of a style that has no block.
#[wasm_bindgen]
#[must_use]
pub fn empty_draft(id: &str, name: &str) -> String {
    draft::empty_json(id, name)
}

/// Returns the editable draft of a style. Throws `invalid-style`.
#[wasm_bindgen]
pub fn draft_of(style: &str) -> Result<String> {
    draft::of_json(&parse::<StyleRef>(style, "style")?)
}

/// A draft after an edit, both as JSON: see `document::draft::DraftEdit`. Null if nothing changes or the edit
/// is impossible.
#[wasm_bindgen]
pub fn edit_draft(draft: &str, edit: &str) -> Result<String> {
    draft::after_json(draft, edit)
}

/// Analysis of a draft: see `document::draft::facts_json`.
#[wasm_bindgen]
pub fn draft_facts(draft: &str) -> Result<String> {
    draft::facts_json(draft)
}
