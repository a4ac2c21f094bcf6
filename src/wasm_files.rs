//! The web boundary of files, a part of the module of words: pages as JPEG, WebP and PDF.
//! The core makes the pixels; they come from there as patches.
//!
//! Errors are as in the module of words.

// Every function that returns a Result throws as the module's documentation says.
#![allow(clippy::missing_errors_doc)]

use crate::error::Result;
use crate::page::compose::Sheet;
use crate::page::mask::PixelRect;
use crate::page::pdf::{self, Leaf, Picture, picture};
use crate::page::{Document, jpeg, webp};
use crate::wasm_error::thrown;
use crate::wasm_words::Lettering;
use wasm_bindgen::prelude::*;

/// A page on which patches are laid.
#[wasm_bindgen]
pub struct Print {
    sheet: Sheet,
    dpi: u32,
}

#[wasm_bindgen]
impl Print {
    /// The empty paper of a document, of any size.
    #[wasm_bindgen(constructor)]
    pub fn new(document: &str, width: usize, height: usize) -> std::result::Result<Print, JsValue> {
        let page = Document::parse(document).map_err(thrown)?.page;
        Ok(Self { sheet: Sheet::blank(width, height, page.paper_rgb()), dpi: page.dpi })
    }

    /// Lays a patch of the page on it.
    pub fn lay(
        &mut self,
        x: i32,
        y: i32,
        width: usize,
        height: usize,
        rgba: &[u8],
    ) -> std::result::Result<(), JsValue> {
        let area = PixelRect { x: i64::from(x), y: i64::from(y), width, height };
        self.sheet.lay(area, rgba).map_err(thrown)
    }

    /// The file, with a quality from 1 to 100.
    pub fn jpeg(&self, quality: u8) -> std::result::Result<Vec<u8>, JsValue> {
        let Self { sheet, dpi } = self;
        jpeg::encode_rgb(sheet.width(), sheet.height(), sheet.rgb(), *dpi, quality).map_err(thrown)
    }

    /// The file as WebP, without loss; it says nothing of its resolution.
    pub fn webp(&self) -> std::result::Result<Vec<u8>, JsValue> {
        let Self { sheet, .. } = self;
        webp::encode_rgb(sheet.width(), sheet.height(), sheet.rgb()).map_err(thrown)
    }
}

/// The picture of a panel for a [`Book`].
#[wasm_bindgen]
pub struct Cut {
    /// Left edge in pixels of the page.
    pub x: i32,
    /// Top edge.
    pub y: i32,
    /// Width.
    pub width: u32,
    /// Height.
    pub height: u32,
    jpeg: Vec<u8>,
}

#[wasm_bindgen]
impl Cut {
    /// Makes it of the patch of a panel without a border; see `page::pdf::picture::cut`.
    #[wasm_bindgen(constructor)]
    #[allow(clippy::too_many_arguments)] // The fields of a patch, which cross one by one.
    pub fn new(
        document: &str,
        index: usize,
        x: i32,
        y: i32,
        width: usize,
        height: usize,
        rgba: &[u8],
        quality: u8,
    ) -> std::result::Result<Cut, JsValue> {
        let area = PixelRect { x: i64::from(x), y: i64::from(y), width, height };
        let cut =
            || -> Result<Picture> { picture::cut(&Document::parse(document)?, index, area, rgba, quality) };
        let Picture { area, jpeg, .. } = cut().map_err(thrown)?;
        let (width, height) = (area.width as u32, area.height as u32);
        Ok(Self { x: area.x as i32, y: area.y as i32, width, height, jpeg })
    }

    /// Moves the file out.
    #[must_use]
    pub fn take(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.jpeg)
    }
}

/// Pages of a PDF file.
#[wasm_bindgen]
#[derive(Default)]
pub struct Book {
    leaves: Vec<Leaf>,
}

#[wasm_bindgen]
impl Book {
    /// A book without pages.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a page.
    pub fn add_page(&mut self, document: &str) -> std::result::Result<(), JsValue> {
        let document = Document::parse(document).map_err(thrown)?;
        self.leaves.push(Leaf { document, pictures: Vec::new() });
        Ok(())
    }

    /// Adds a picture to the page that was added last.
    pub fn add_picture(&mut self, index: usize, x: i32, y: i32, width: usize, height: usize, jpeg: Vec<u8>) {
        let area = PixelRect { x: i64::from(x), y: i64::from(y), width, height };
        if let Some(leaf) = self.leaves.last_mut() {
            leaf.pictures.push(Picture { index, area, jpeg });
        }
    }

    /// The file.
    pub fn finish(&self, lettering: &Lettering, title: &str) -> std::result::Result<Vec<u8>, JsValue> {
        pdf::write(&self.leaves, title, lettering.letters()).map_err(thrown)
    }
}
