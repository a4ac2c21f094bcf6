//! Projects as they are opened: read and checked in full, or refused with a sentence.

use super::thrown;
use inkpanel::document::file::ProjectFile;
use inkpanel::document::kept;
use inkpanel::error::Result;
use wasm_bindgen::prelude::*;

/// The text of a project file or of a page PNG, normalised, with what was left out: `{format, version, history: {present,
/// shown}, photos, videos, dropped}`. With a prefix all photos and videos get ids that begin with it.
/// Throws `damaged-project`, `newer-project` or `too-large-project`.
#[wasm_bindgen]
pub fn read_project(json: &str, prefix: Option<String>) -> std::result::Result<String, JsValue> {
    let read = move || -> Result<String> {
        let project = ProjectFile::parse(json)?;
        let project = match prefix {
            Some(prefix) => project.renamed(&prefix),
            None => project,
        };
        Ok(project.write())
    };
    read().map_err(thrown)
}

/// A history out of the browser's database with tables of its parts (see `document::kept`), normalised, with what was left
/// out. Throws as `read_project`.
#[wasm_bindgen]
pub fn read_history(json: &str) -> std::result::Result<String, JsValue> {
    kept::parse(json).map(|(history, dropped)| kept::write(&history, &dropped)).map_err(thrown)
}
