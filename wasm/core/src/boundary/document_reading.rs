//! Opens projects: reads and checks them completely, or rejects them with a message.

use inkpanel_engine::document::file::ProjectFile;
use inkpanel_engine::error::Result;
use wasm_bindgen::prelude::*;

/// Reads the text of a project file or of a page PNG, and normalises it: `{format, version, history:
/// {present, shown}, photos, videos, dropped}`. `dropped` lists invalid parts. With a prefix all photos and
/// videos get ids that begin with it. Throws `damaged-project`, `newer-project` or `too-large-project`.
#[wasm_bindgen]
pub fn read_project(json: &str, prefix: Option<String>) -> Result<String> {
    let project = ProjectFile::parse(json)?;
    let project = match prefix {
        Some(prefix) => project.renamed(&prefix),
        None => project,
    };
    Ok(project.write())
}
