//! The web boundary of comics that are read, a part of the module of other files: their text. The app inserts
//! the images, which it has as blobs.
//!
//! Errors are like in the `words` module.

use crate::letters::Lettering;
use inkpanel_engine::error::{Error, Result};
use inkpanel_engine::output::{Comic, cbz, epub, html, strip};
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// Exports a comic (a `Comic` as JSON): for `html` a list of pieces, for `epub` and `cbz` a list of files, as
/// JSON. See `output::comic`.
///
/// # Errors
/// Returns `invalid-document` if the comic or its kind is invalid, and any layout error.
#[wasm_bindgen(js_name = comicFile)]
pub fn comic_file(kind: &str, comic: &str, lettering: &Lettering) -> Result<String> {
    let comic = Comic::parse(comic)?;
    let letters = lettering.letters();
    match kind {
        "html" => json(&html::write(&comic, letters)?),
        "epub" => json(&epub::write(&comic, letters)?),
        "cbz" => json(&cbz::write(&comic, letters)?),
        _ => Err(Error::InvalidDocument {
            location: "kind".into(),
            reason: format!("{kind} must be one of html, epub, cbz"),
        }),
    }
}

/// The pages of a vertical strip (a `Request` of `output::strip` as JSON): a list of pages.
///
/// # Errors
/// `invalid-document` for an invalid request; layout and text errors.
#[wasm_bindgen(js_name = stripPages)]
pub fn strip_pages(request: &str, lettering: &Lettering) -> Result<String> {
    let pages = strip::Request::made(request, lettering.letters())?;
    let pages: Vec<String> = pages.iter().map(inkpanel_engine::page::Document::to_json).collect();
    Ok(format!("[{}]", pages.join(",")))
}

fn json(made: &impl Serialize) -> Result<String> {
    serde_json::to_string(made).map_err(|error| Error::Encode(error.to_string()))
}
