//! The web boundary of the core, with the files of `wasm/`. It holds no algorithm.
//!
//! Structured data crosses as JSON text, pixels as byte arrays. Every error is a JavaScript `Error` with a
//! `code` in addition to its `message`. The page calls the functions for planning; a worker holds a
//! [`Studio`].

// Every function that returns a Result throws as the module's documentation says.
#![allow(clippy::missing_errors_doc)]

pub mod album;
#[cfg(feature = "bench")]
pub mod bench;
pub mod booking;
pub mod document_reading;
pub mod drafting;
pub mod editing;
mod frames;
pub mod layouts;
pub mod placing;
pub mod planning;
pub mod style;

use inkpanel_engine::error::{Error, Result};
use inkpanel_engine::framing::Crop;
use inkpanel_engine::json::plain as parse;
use inkpanel_engine::layout::Template;
use inkpanel_engine::page::compose::{Sheet, compose, render_together};
use inkpanel_engine::page::cutout::cut_out;
use inkpanel_engine::page::import::{Imported, import, import_draft};
use inkpanel_engine::page::rect::PixelRect;
use inkpanel_engine::page::{Document, StyleRef};
use inkpanel_engine::page::{Scene, catalogue, png};
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::header::Header;
use inkpanel_engine::raster::heif;
use inkpanel_engine::raster::resize::{Region, resample_image};
use inkpanel_engine::raster::{Image, Matte, Plane};
use inkpanel_engine::style::context::scale_of;
use inkpanel_engine::style::painters::Painters;
use inkpanel_engine::style::part::subject_in;
use inkpanel_engine::style::{Context, Style, stylize};
use serde::Serialize;
use std::collections::HashMap;
use std::sync::Arc;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(start)]
fn start() {
    console_error_panic_hook::set_once();
}

/// The capture time of a HEIC or AVIF file, which the browser decodes: `YYYY:MM:DD HH:MM:SS`, perhaps with a fraction of the second.
#[wasm_bindgen]
#[must_use]
pub fn taken_in_boxes(bytes: &[u8]) -> Option<String> {
    heif::taken(bytes)
}

/// The header of a photo; see `raster::header::Header`.
#[wasm_bindgen(getter_with_clone)]
pub struct PhotoHeader {
    /// Width of the upright photo in pixels.
    pub width: u32,
    /// Height of the upright photo in pixels.
    pub height: u32,
    /// EXIF orientation of the thumbnail, 1 to 8.
    pub orientation: u8,
    /// The thumbnail that the camera stored, a JPEG file.
    pub thumbnail: Option<Vec<u8>>,
}

/// Reads the header of a photo from the beginning of its file. Undefined for unknown files.
#[wasm_bindgen]
#[must_use]
pub fn photo_header(bytes: &[u8]) -> Option<PhotoHeader> {
    let Header { width, height, orientation, thumbnail } = Header::read(bytes)?;
    Some(PhotoHeader { width, height, orientation, thumbnail: thumbnail.map(<[u8]>::to_vec) })
}

/// Descriptors of all filter blocks, a JSON array.
#[wasm_bindgen]
#[must_use]
pub fn blocks() -> String {
    listed(&catalogue::blocks())
}

/// All page templates in unit coordinates, a JSON array.
#[wasm_bindgen]
#[must_use]
pub fn layouts() -> String {
    listed(&catalogue::layouts())
}

/// Number of painters in a model of the user. Throws `damaged-painters`, `large-painters`, `slow-painters` or
/// `invalid-painters`.
#[wasm_bindgen]
pub fn painters_in(onnx: &[u8]) -> Result<usize> {
    Ok(Painters::new(onnx)?.count())
}

/// All designed styles, a JSON array of style files.
#[wasm_bindgen]
#[must_use]
pub fn styles() -> String {
    catalogue::styles().to_string()
}

/// Writes strings and numbers as JSON, which cannot fail.
fn listed(list: &impl Serialize) -> String {
    serde_json::to_string(list).unwrap_or_default()
}

/// Checks a style file and returns it normalised. Throws `invalid-style`.
#[wasm_bindgen]
pub fn check_style(json: &str, file: &str) -> Result<String> {
    Style::parse(file, json).map(|style| style.to_value().to_string())
}

/// Checks a layout file and returns it normalised. Throws `invalid-layout`.
#[wasm_bindgen]
pub fn check_layout(json: &str, file: &str) -> Result<String> {
    Template::parse(file, json).map(|template| template.to_json())
}

/// Which photos of `{photos: [{id, name, measures...}], duplicateThreshold}` are worth a panel: `[{id, group, kept, why}]`.
#[wasm_bindgen]
pub fn choose_photos(json: &str) -> Result<String> {
    catalogue::choose(json)
}

/// A rectangle of rendered pixels.
#[wasm_bindgen]
pub struct Patch {
    area: PixelRect,
    rgba: Vec<u8>,
}

#[wasm_bindgen]
impl Patch {
    /// Left edge in page pixels.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn x(&self) -> i32 {
        self.area.x as i32
    }

    /// Top edge in page pixels.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn y(&self) -> i32 {
        self.area.y as i32
    }

    /// Width in pixels.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn width(&self) -> u32 {
        self.area.width as u32
    }

    /// Height in pixels.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn height(&self) -> u32 {
        self.area.height as u32
    }

    /// Moves the straight-alpha RGBA out; the patch is empty afterwards.
    #[must_use]
    pub fn take(&mut self) -> js_sys::Uint8ClampedArray {
        js_sys::Uint8ClampedArray::from(std::mem::take(&mut self.rgba).as_slice())
    }
}

impl Patch {
    /// Returns an image without a position in a photo.
    fn whole(width: usize, height: usize, rgba: Vec<u8>) -> Self {
        Self { area: PixelRect { x: 0, y: 0, width, height }, rgba }
    }
}

/// A worker's photos and scratch memory.
#[wasm_bindgen]
#[derive(Default)]
pub struct Studio {
    photos: HashMap<String, Image>,
    subjects: HashMap<String, Matte>,
    context: Context<'static>,
    sheet: Option<(Sheet, u32)>,
    file: Vec<u8>,
    /// Frames of the panel that moves and is drawn next.
    living: Vec<Image>,
    designs: style::Designs,
}

#[wasm_bindgen]
impl Studio {
    /// An empty studio.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Decodes a file into `ID/work` and `ID/small`. Returns the photo's measurements as JSON.
    pub fn import_photo(&mut self, id: &str, bytes: &[u8]) -> Result<String> {
        let photo = import(id, bytes, &Limits::default())?;
        self.take_in(photo)
    }

    /// Like `import_photo` at a smaller size, for large JPEG files. Returns `undefined` for other files.
    pub fn import_draft(&mut self, id: &str, bytes: &[u8]) -> Result<Option<String>> {
        let photo = import_draft(id, bytes, &Limits::default())?;
        photo.map(|photo| self.take_in(photo)).transpose()
    }

    /// The red, green and blue planes of a photo, one after the other.
    pub fn photo_planes(&self, key: &str) -> Result<Vec<u8>> {
        let image = self.photo(key)?;
        Ok(image.planes().iter().map(Plane::samples).collect::<Vec<_>>().concat())
    }

    /// Stores the planes of a photo.
    pub fn put_photo(&mut self, key: &str, width: usize, height: usize, planes: &[u8]) -> Result<()> {
        let image = Image::from_rgb_planes(width, height, planes)?;
        self.photos.insert(key.to_owned(), image);
        Ok(())
    }

    /// Decodes a file at its full size into `ID/full`.
    pub fn import_full(&mut self, id: &str, bytes: &[u8]) -> Result<()> {
        let decoded = decode(bytes, &Limits::default())?;
        self.photos.insert(format!("{id}/full"), decoded.image);
        Ok(())
    }

    /// The isolated subject of a photo as a PNG with alpha, or `None` if the mask is invalid.
    pub fn cut_out(&self, key: &str, mask: String) -> Result<Option<Vec<u8>>> {
        let photo = self.photo(key)?;
        let cut = Matte::try_from(mask).ok().map(|mask| cut_out(photo, &mask));
        cut.transpose()
    }

    /// Sets the subject mask of a photo as text; `None` if it is unknown. Styles with a part for only the
    /// subject or background use it.
    pub fn know_subject(&mut self, key: &str, mask: Option<String>) {
        // Each job sends the mask; it is only parsed if it changed.
        if self.subjects.get(key).map(Matte::text) == mask.as_deref() {
            return;
        }
        self.designs.forget(key);
        match mask.and_then(|mask| Matte::try_from(mask).ok()) {
            Some(mask) => drop(self.subjects.insert(key.to_owned(), mask)),
            None => drop(self.subjects.remove(key)),
        }
    }

    /// Sets the model of the block Painter. Throws `invalid-painters`.
    pub fn know_painters(&mut self, onnx: &[u8]) -> Result<()> {
        let painters = Painters::new(onnx)?;
        self.context.show_painters(Some(Arc::new(painters)));
        Ok(())
    }

    /// Adds a model of the user, whose references in styles begin with `hash`. Throws as `painters_in`.
    pub fn know_own_painters(&mut self, hash: &str, onnx: &[u8]) -> Result<()> {
        let painters = Painters::new(onnx)?;
        self.context.show_own_painters(hash, Arc::new(painters));
        self.designs = style::Designs::default();
        Ok(())
    }

    /// Removes the models of the user.
    pub fn forget_own_painters(&mut self) {
        self.context.hide_own_painters();
        self.designs = style::Designs::default();
    }

    /// Whether a photo is here.
    #[must_use]
    pub fn has_photo(&self, key: &str) -> bool {
        self.photos.contains_key(key)
    }

    /// Frees a photo.
    pub fn drop_photo(&mut self, key: &str) {
        self.photos.remove(key);
        self.subjects.remove(key);
    }

    /// Bytes of all photos here.
    #[must_use]
    pub fn photo_bytes(&self) -> usize {
        self.photos.values().flat_map(Image::planes).map(|plane| plane.samples().len()).sum()
    }

    /// Images of one panel of a page that is `width` pixels wide, with or without border, from the photos of
    /// a tier (`small`, `work`, `full`).
    pub fn render_panel(
        &mut self,
        document: &str,
        pictures: &[usize],
        width: usize,
        tier: &str,
        bordered: bool,
    ) -> Result<Vec<Patch>> {
        let mut scene = self.scene(document, width, tier)?;
        scene.bordered = bordered;
        let id = pictures.first().map(|first| scene.picture(*first)).transpose()?;
        let id = id.and_then(|picture| picture.photo.as_ref());
        let photo = id.map(|id| find(&self.photos, id, tier)).transpose()?;
        let drawn = render_together(&scene, pictures, photo, &mut self.context)?;
        Ok(drawn.into_iter().map(|patch| Patch { area: patch.area, rgba: patch.rgba }).collect())
    }

    /// Renders a whole page.
    pub fn compose(&mut self, document: &str, width: usize, tier: &str) -> Result<Patch> {
        let scene = self.scene(document, width, tier)?;
        let sheet = compose(&scene, |id| find(&self.photos, id, tier).ok(), &mut self.context)?;
        Ok(Patch::whole(sheet.width(), sheet.height(), sheet.to_rgba()))
    }

    /// Draws a photo in a style. The crop is JSON, or empty for the whole photo.
    pub fn stylize_photo(
        &mut self,
        key: &str,
        style: &str,
        width: usize,
        height: usize,
        crop: &str,
    ) -> Result<Patch> {
        let photo = self.photos.get(key).ok_or_else(|| Error::MissingPhoto(key.to_owned()))?;
        let (w, h) = (photo.width() as f64, photo.height() as f64);
        let mut region = Region::whole(photo.width(), photo.height());
        if !crop.is_empty() {
            let crop: Crop = parse(crop, "crop")?;
            region = Region { x: crop.x * w, y: crop.y * h, width: crop.width * w, height: crop.height * h };
        }
        let image = resample_image(photo, region, width.max(1), height.max(1));
        self.context.fit_scale(&image);
        let style = style_of(style)?;
        self.show_subject(key, region, &image, &style);
        let rgba = stylize(&image, &style, &mut self.context)?.to_rgba();
        Ok(Patch::whole(image.width(), image.height(), rgba))
    }

    /// An image in a style: RGBA in, RGBA of the same size out.
    pub fn stylize(&mut self, style: &str, width: usize, height: usize, rgba: &[u8]) -> Result<Vec<u8>> {
        let image = Image::from_rgba(width, height, rgba, [255; 3])?;
        self.context.fit_scale(&image);
        Ok(stylize(&image, &style_of(style)?, &mut self.context)?.to_rgba())
    }

    /// Begins a page for the file; patches are laid on it next.
    pub fn begin_page(&mut self, document: &str, width: usize) -> Result<()> {
        let document = Document::parse(document)?;
        self.sheet = Some((Sheet::new(&Scene::new(&document, width)?), document.page.dpi));
        Ok(())
    }

    /// Lays a patch on the page that was begun.
    pub fn add_patch(&mut self, x: i32, y: i32, width: usize, height: usize, rgba: &[u8]) -> Result<()> {
        let (sheet, _) = self.sheet.as_mut().ok_or_else(not_begun)?;
        sheet.lay(PixelRect { x: i64::from(x), y: i64::from(y), width, height }, rgba)
    }

    /// Encodes the page that was begun.
    pub fn finish_png(&mut self) -> Result<Vec<u8>> {
        let (sheet, dpi) = self.sheet.take().ok_or_else(not_begun)?;
        png::encode(&sheet, dpi)
    }

    /// Bytes of this instance's memory.
    #[must_use]
    pub fn memory(&self) -> f64 {
        const PAGE: f64 = 65_536.0;
        core::arch::wasm32::memory_size::<0>() as f64 * PAGE
    }

    /// Stores both copies of an imported photo, and returns its facts as JSON.
    fn take_in(&mut self, photo: Imported) -> Result<String> {
        let facts =
            serde_json::to_string(&photo.entry()).map_err(|error| Error::Encode(error.to_string()))?;
        self.photos.insert(format!("{}/work", photo.meta.id), photo.work);
        self.photos.insert(format!("{}/small", photo.meta.id), photo.small);
        Ok(facts)
    }

    /// A page with the subjects of its photos.
    fn scene(&self, document: &str, width: usize, tier: &str) -> Result<Scene> {
        let mut scene = Scene::new(&Document::parse(document)?, width)?;
        scene.show_subjects(&|id| self.subjects.get(&format!("{id}/{tier}")).cloned());
        Ok(scene)
    }

    /// Sets the subject mask for a picture of a region of a photo, if the subject is known and the style uses
    /// it.
    fn show_subject(&mut self, key: &str, region: Region, picture: &Image, style: &Style) {
        let subject = if style.has_parts() { self.subject_in(key, region, picture) } else { None };
        self.context.show_subject(subject);
    }

    /// Returns the subject mask for a picture of a region of a photo, if the subject is known.
    fn subject_in(&self, key: &str, region: Region, picture: &Image) -> Option<Plane> {
        let (photo, matte) = (self.photos.get(key)?, self.subjects.get(key)?);
        let scale = scale_of(picture.width() as f64 * picture.height() as f64);
        subject_in(matte, region, (photo.width(), photo.height()), (picture, scale))
    }

    fn photo(&self, key: &str) -> Result<&Image> {
        self.photos.get(key).ok_or_else(|| Error::MissingPhoto(key.to_owned()))
    }
}

fn find<'p>(photos: &'p HashMap<String, Image>, id: &str, tier: &str) -> Result<&'p Image> {
    photos.get(&format!("{id}/{tier}")).ok_or_else(|| Error::MissingPhoto(id.to_owned()))
}

#[inline(never)]
fn style_of(json: &str) -> Result<Style> {
    let style: StyleRef = parse(json, "style")?;
    Ok(style.style()?.into_owned())
}

fn not_begun() -> Error {
    Error::Encode("no page is open".into())
}
