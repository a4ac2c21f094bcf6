//! Layouts as the page lists, makes and changes them; see `page::layouts` for each request and answer.

use super::thrown;
use inkpanel::page::layouts;
use wasm_bindgen::prelude::*;

/// The layouts to choose from, with thumbnails: `{page, own}`.
#[wasm_bindgen]
pub fn list_layouts(json: &str) -> std::result::Result<String, JsValue> {
    layouts::list(json).map_err(thrown)
}

/// The panels of `{layout, page}` on the page.
#[wasm_bindgen]
pub fn page_geometry(json: &str) -> std::result::Result<String, JsValue> {
    layouts::geometry(json).map_err(thrown)
}

/// The possible changes of the layout in `{layout, page}`.
#[wasm_bindgen]
pub fn layout_facts(json: &str) -> std::result::Result<String, JsValue> {
    layouts::facts(json).map_err(thrown)
}

/// The template of `{layout}` in full.
#[wasm_bindgen]
pub fn layout_file(json: &str) -> std::result::Result<String, JsValue> {
    layouts::file(json).map_err(thrown)
}

/// A new template: `{seed, page, least, most}`.
#[wasm_bindgen]
pub fn generate_layout(json: &str) -> std::result::Result<String, JsValue> {
    layouts::generated(json).map_err(thrown)
}

/// The template after `{layout, change}`.
#[wasm_bindgen]
pub fn change_layout(json: &str) -> std::result::Result<String, JsValue> {
    layouts::changed(json).map_err(thrown)
}
