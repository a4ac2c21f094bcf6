//! wasm bindings of the `words` module: placement, size and pixels of text items. The app loads it when a
//! page first has text, and passes the glyphs (`wasm_letters`).
//!
//! Structured data crosses as JSON text, pixels as byte arrays. Every error is a JavaScript `Error` with a
//! `code` in addition to its `message`.

// Every function that returns a Result throws as the module's documentation says.
#![allow(clippy::missing_errors_doc)]

use crate::letters::Lettering;
use inkpanel_engine::error::{Error, Result};
use inkpanel_engine::framing::Subject;
use inkpanel_engine::page::rect::PixelRect;
use inkpanel_engine::page::words::place::{self, Known};
use inkpanel_engine::page::words::{draw, layout};
use inkpanel_engine::page::{Document, Patch};
use inkpanel_engine::raster::Matte;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use std::collections::HashMap;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Lettering {
    /// Places the automatic text items of a document. Items hide no face, and as little of bodies as
    /// possible. `photos`: properties of each photo by id, `{subjects, mask?}`. `again`: the layout has changed, so that text
    /// items that the user placed move off faces as well.
    pub fn settle(&self, document: &str, photos: &str, again: bool) -> Result<String> {
        let mut document = Document::parse(document)?;
        let told: HashMap<String, Told> = read(photos, "photos")?;
        let known = |id: &str| told.get(id).map(Told::known).unwrap_or_default();
        let settle = if again { place::resettle } else { place::settle };
        settle(&mut document, known, self.letters())?;
        Ok(document.words_json())
    }

    /// Places an automatic text item at its earlier place after its text changed. `before`: its earlier bounds. `None` if it does
    /// not fit there.
    pub fn stay(&self, document: &str, photos: &str, index: usize, before: &str) -> Result<Option<String>> {
        let mut document = Document::parse(document)?;
        let told: HashMap<String, Told> = read(photos, "photos")?;
        let known = |id: &str| told.get(id).map(Told::known).unwrap_or_default();
        let fits = place::stay(&mut document, index, read(before, "before")?, known, self.letters())?;
        Ok(fits.then(|| document.words_json()))
    }

    /// Bounds of the text items of a document; see `page::words::layout::measured`.
    pub fn measure(&self, document: &str) -> Result<String> {
        let boxes = layout::measured(&Document::parse(document)?, self.letters())?;
        serde_json::to_string(&boxes).map_err(|error| Error::Encode(error.to_string()))
    }

    /// Returns whether a text contains traced glyphs.
    #[must_use]
    pub fn foreign(&self, text: &str) -> bool {
        self.letters().foreign(text)
    }

    /// Renders one text item of a page with a width of `width` pixels.
    pub fn render(&self, document: &str, index: usize, width: usize) -> Result<Picture> {
        let patch = draw::render(&Document::parse(document)?, index, width, self.letters())?;
        Ok(Picture {
            x: patch.area.x as i32,
            y: patch.area.y as i32,
            width: patch.area.width as u32,
            height: patch.area.height as u32,
            rgba: patch.rgba,
        })
    }
}

/// Reads an argument in JSON.
fn read<T: DeserializeOwned>(json: &str, name: &str) -> Result<T> {
    let wrong = |error: serde_json::Error| Error::InvalidDocument {
        location: name.into(),
        reason: error.to_string(),
    };
    serde_json::from_str(json).map_err(wrong)
}

/// Properties of a photo.
#[derive(Deserialize)]
struct Told {
    subjects: Vec<Subject>,
    #[serde(default)]
    mask: Option<Matte>,
}

impl Told {
    fn known(&self) -> Known<'_> {
        Known { subjects: &self.subjects, mask: self.mask.as_ref() }
    }
}

/// A rectangle of rendered pixels, in pixels of the page.
#[wasm_bindgen]
pub struct Picture {
    /// Left edge.
    pub x: i32,
    /// Top edge.
    pub y: i32,
    /// Width.
    pub width: u32,
    /// Height.
    pub height: u32,
    rgba: Vec<u8>,
}

#[wasm_bindgen]
impl Picture {
    /// Reduces the opacity where a subject in front covers the item; a patch of the same page. See
    /// `page::Patch::stand_behind`.
    pub fn stand_behind(&mut self, x: i32, y: i32, width: usize, height: usize, rgba: &[u8]) {
        let own = PixelRect {
            x: i64::from(self.x),
            y: i64::from(self.y),
            width: self.width as usize,
            height: self.height as usize,
        };
        let mut patch = Patch { area: own, rgba: std::mem::take(&mut self.rgba) };
        patch.stand_behind(PixelRect { x: i64::from(x), y: i64::from(y), width, height }, rgba);
        self.rgba = patch.rgba;
    }

    /// Moves the straight-alpha RGBA out; the picture is empty afterwards.
    #[must_use]
    pub fn take(&mut self) -> js_sys::Uint8ClampedArray {
        js_sys::Uint8ClampedArray::from(std::mem::take(&mut self.rgba).as_slice())
    }
}
