//! Layouts as the page lists, makes and changes them; see `page::layouts` for each request and answer.

use inkpanel_engine::error::Result;
use inkpanel_engine::page::layouts;
use wasm_bindgen::prelude::*;

/// The layouts to choose from, with thumbnails: `{page, own}`.
#[wasm_bindgen]
pub fn list_layouts(json: &str) -> Result<String> {
    layouts::list(json)
}

/// The panels of `{layout, page}` on the page.
#[wasm_bindgen]
pub fn page_geometry(json: &str) -> Result<String> {
    layouts::geometry(json)
}

/// The possible changes of the layout in `{layout, page}`.
#[wasm_bindgen]
pub fn layout_facts(json: &str) -> Result<String> {
    layouts::facts(json)
}

/// The template of `{layout}` in full.
#[wasm_bindgen]
pub fn layout_file(json: &str) -> Result<String> {
    layouts::file(json)
}

/// A new template: `{seed, page, least, most}`.
#[wasm_bindgen]
pub fn generate_layout(json: &str) -> Result<String> {
    layouts::generated(json)
}
