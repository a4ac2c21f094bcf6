//! The web boundary of the module of files other than PNG: pages as JPEG, WebP and PDF. The core draws the
//! pixels, which arrive as patches.
//!
//! Errors are like in the `words` module.

// Every function that returns a Result throws as the module's documentation says.
#![allow(clippy::missing_errors_doc)]

use crate::letters::Lettering;
use inkpanel_engine::error::{Error, Result};
use inkpanel_engine::page::compose::Sheet;
use inkpanel_engine::page::pdf::{self, Leaf, Options, Picture, picture};
use inkpanel_engine::page::plates::Separation;
use inkpanel_engine::page::rect::PixelRect;
use inkpanel_engine::page::{Document, jpeg, webp};
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
    pub fn new(document: &str, width: usize, height: usize) -> Result<Print> {
        let page = Document::parse(document)?.page;
        Ok(Self { sheet: Sheet::blank(width, height, page.paper_rgb()), dpi: page.dpi })
    }

    /// Lays a patch of the page on it.
    pub fn lay(&mut self, x: i32, y: i32, width: usize, height: usize, rgba: &[u8]) -> Result<()> {
        let area = PixelRect { x: i64::from(x), y: i64::from(y), width, height };
        self.sheet.lay(area, rgba)
    }

    /// The file, with a quality from 1 to 100.
    pub fn jpeg(&self, quality: u8) -> Result<Vec<u8>> {
        let Self { sheet, dpi } = self;
        jpeg::encode_rgb(sheet.width(), sheet.height(), sheet.rgb(), *dpi, quality)
    }

    /// The file as lossless WebP, without a resolution.
    pub fn webp(&self) -> Result<Vec<u8>> {
        let Self { sheet, .. } = self;
        webp::encode_rgb(sheet.width(), sheet.height(), sheet.rgb())
    }
}

/// Encodes an image with straight alpha as a lossless WebP file.
#[wasm_bindgen(js_name = losslessPicture)]
pub fn lossless_picture(width: usize, height: usize, rgba: &[u8]) -> Result<Vec<u8>> {
    webp::encode_rgba(width, height, rgba)
}

/// The image of a panel for a [`Book`].
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
    alpha: Option<Vec<u8>>,
}

/// The plate of an ink, which the panels of pages in one style share.
#[wasm_bindgen]
pub struct Plate {
    separation: Separation,
    ink: usize,
}

#[wasm_bindgen]
impl Plate {
    /// The plate of the ink with index `ink`. `colours` are the inks on white paper: red, green and blue of
    /// each.
    #[wasm_bindgen(constructor)]
    pub fn new(colours: &[u8], ink: usize) -> Result<Plate> {
        let inks = colours.as_chunks::<3>().0;
        if ink >= inks.len() {
            return Err(no_plate());
        }
        Ok(Self { separation: Separation::new(inks), ink })
    }

    /// The image of a panel in gray, as printed with this ink; otherwise like [`Cut`].
    #[allow(clippy::too_many_arguments)] // The fields of a patch, which cross one by one.
    pub fn cut(
        &self,
        document: &str,
        index: usize,
        x: i32,
        y: i32,
        width: usize,
        height: usize,
        rgba: &[u8],
        quality: u8,
    ) -> Result<Cut> {
        let area = PixelRect { x: i64::from(x), y: i64::from(y), width, height };
        Cut::made(document, (index, area, rgba), quality, Some((&self.separation, self.ink)))
    }
}

fn no_plate() -> Error {
    Error::InvalidDocument { location: "style".into(), reason: "has no plate with this number".into() }
}

#[wasm_bindgen]
impl Cut {
    /// Makes it from the patch of a panel without a border; see `page::pdf::picture::cut`.
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
    ) -> Result<Cut> {
        let area = PixelRect { x: i64::from(x), y: i64::from(y), width, height };
        Self::made(document, (index, area, rgba), quality, None)
    }

    /// Moves the file out.
    #[must_use]
    pub fn take(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.jpeg)
    }

    /// Moves out the opacity of each pixel of a subject, packed.
    #[must_use]
    pub fn take_alpha(&mut self) -> Option<Vec<u8>> {
        self.alpha.take()
    }
}

impl Cut {
    fn made(
        document: &str,
        patch: (usize, PixelRect, &[u8]),
        quality: u8,
        plate: Option<(&Separation, usize)>,
    ) -> Result<Cut> {
        let cut = || -> Result<Picture> { picture::cut(&Document::parse(document)?, patch, quality, plate) };
        let Picture { area, jpeg, alpha, .. } = cut()?;
        let (width, height) = (area.width as u32, area.height as u32);
        Ok(Self { x: area.x as i32, y: area.y as i32, width, height, jpeg, alpha })
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

    /// Adds a page. `alts`: alternative texts of its panels, a JSON array.
    pub fn add_page(&mut self, document: &str, alts: &str) -> Result<()> {
        let document = Document::parse(document)?;
        let alts = serde_json::from_str(alts).map_err(|error| refused("alts", &error))?;
        self.leaves.push(Leaf { document, pictures: Vec::new(), alts });
        Ok(())
    }

    /// Adds an image to the last page.
    #[allow(clippy::too_many_arguments)] // The fields of a picture, which cross one by one.
    pub fn add_picture(
        &mut self,
        index: usize,
        x: i32,
        y: i32,
        width: usize,
        height: usize,
        jpeg: Vec<u8>,
        alpha: Option<Vec<u8>>,
    ) {
        let area = PixelRect { x: i64::from(x), y: i64::from(y), width, height };
        if let Some(leaf) = self.leaves.last_mut() {
            leaf.pictures.push(Picture { index, area, jpeg, alpha });
        }
    }

    /// The file. `options`: the options of `page::pdf::options` as JSON.
    pub fn finish(&self, lettering: &Lettering, options: &str) -> Result<Vec<u8>> {
        let options: Options = serde_json::from_str(options).map_err(|error| refused("options", &error))?;
        pdf::write(&self.leaves, &options, lettering.letters())
    }
}

fn refused(what: &str, error: &serde_json::Error) -> Error {
    Error::InvalidDocument { location: what.into(), reason: error.to_string() }
}
