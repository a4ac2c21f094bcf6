//! Pages of the command line as files: rendered from the photos at their full size, with their words.

use crate::Complaint;
use inkpanel::Error;
use inkpanel::page::import::Imported;
use inkpanel::page::pdf::{self, picture};
use inkpanel::page::words::{Letters, draw as word_drawing, place};
use inkpanel::page::{Document, Scene, compose, jpeg, png};
use inkpanel::raster::Image;
use inkpanel::style::Context;
use rayon::prelude::*;
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

/// Puts the words of a file on a page; those without a place go where they hide no face.
pub(crate) fn add_words(
    document: &mut Document,
    file: &Path,
    photos: &[(PathBuf, Imported)],
) -> Result<(), Complaint> {
    let complain = |reason: String| format!("{}: {reason}", file.display());
    let json = std::fs::read_to_string(file).map_err(|error| complain(error.to_string()))?;
    document.words = serde_json::from_str(&json).map_err(|error| complain(error.to_string()))?;
    let subjects = |id: &str| {
        let photo = photos.iter().find(|(_, photo)| photo.meta.id == id);
        photo.map_or(&[][..], |(_, photo)| &photo.meta.subjects)
    };
    let settle = |letters: Letters| place::settle(document, subjects, &letters);
    Letters::bundled().and_then(settle).map_err(|error| complain(error.to_string()))
}

/// A kind of file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Png,
    Jpeg,
    Pdf,
}

impl Kind {
    /// What the ending of a file names.
    pub(crate) fn of(output: &Path) -> Result<Self, Complaint> {
        let ending = output.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            Some("png") => Ok(Self::Png),
            Some("jpg" | "jpeg") => Ok(Self::Jpeg),
            Some("pdf") => Ok(Self::Pdf),
            _ => Err(format!("{}: give the page a name that ends in .png, .jpg or .pdf", output.display())),
        }
    }
}

/// Decodes a photo at its full size by its id; gives nothing for one that is not there.
pub(crate) type Photos<'p> = dyn Fn(&str) -> Result<Option<Image>, Complaint> + Sync + 'p;

/// Renders a document from its photos, decoded at their full size, as the kind of file that `output` names.
pub(crate) fn draw(document: &Document, photos: &Photos<'_>, output: &Path) -> Result<Vec<u8>, Complaint> {
    let kind = Kind::of(output)?;
    if kind == Kind::Pdf {
        return draw_pdf(document, photos, output);
    }
    let mut sheet = compose::Sheet::new(&scene_of(document)?);
    for patch in patches(document, photos)? {
        sheet.lay(patch.area, &patch.rgba).map_err(|error| error.to_string())?;
    }
    let lay = |letters: Letters| word_drawing::lay_words(&mut sheet, document, &letters);
    Letters::bundled().and_then(lay).map_err(|error| error.to_string())?;
    let dpi = document.page.dpi;
    let file = match kind {
        Kind::Jpeg => jpeg::encode_rgb(sheet.width(), sheet.height(), sheet.rgb(), dpi, QUALITY),
        _ => png::encode(&sheet, dpi),
    };
    file.map_err(|error| error.to_string())
}

/// Of JPEG files and of the pictures in PDF files.
const QUALITY: u8 = 90;

/// The same as a file of one page whose title is the file's name.
fn draw_pdf(document: &Document, photos: &Photos<'_>, output: &Path) -> Result<Vec<u8>, Complaint> {
    draw_book(std::slice::from_ref(document), photos, output)
}

/// Pages as one PDF file whose title is the file's name.
pub(crate) fn draw_book(
    documents: &[Document],
    photos: &Photos<'_>,
    output: &Path,
) -> Result<Vec<u8>, Complaint> {
    let leaves = documents.iter().map(|document| leaf(document, photos)).collect::<Result<Vec<_>, _>>()?;
    let title = output.file_stem().map(|stem| stem.to_string_lossy()).unwrap_or_default();
    let write = |letters: Letters| pdf::write(&leaves, &title, &letters);
    Letters::bundled().and_then(write).map_err(|error| error.to_string())
}

fn leaf(document: &Document, photos: &Photos<'_>) -> Result<pdf::Leaf, Complaint> {
    let scene = scene_of(document)?;
    let patches = patches(&picture::bare(document), photos)?;
    let pictures = patches
        .par_iter()
        .enumerate()
        .filter(|(index, _)| scene.panels[*index].photo.is_some())
        .map(|(index, patch)| picture::cut(document, index, patch.area, &patch.rgba, QUALITY))
        .collect::<Result<Vec<_>, Error>>()
        .map_err(|error| error.to_string())?;
    Ok(pdf::Leaf { document: document.clone(), pictures })
}

fn scene_of(document: &Document) -> Result<Scene, Complaint> {
    Scene::new(document, document.page.width as usize).map_err(|error| error.to_string())
}

/// The panels of a document in their order.
fn patches(document: &Document, photos: &Photos<'_>) -> Result<Vec<compose::Patch>, Complaint> {
    let scene = scene_of(document)?;
    let wanted: HashSet<&str> = scene.panels.iter().filter_map(|panel| panel.photo.as_deref()).collect();
    let images: HashMap<&str, Image> = wanted
        .into_par_iter()
        .filter_map(|id| photos(id).transpose().map(|image| Ok((id, image?))))
        .collect::<Result<_, Complaint>>()?;
    let render = |index: usize| -> inkpanel::Result<compose::Patch> {
        let photo = scene.panels[index].photo.as_deref().and_then(|id| images.get(id));
        compose::render_panel(&scene, index, photo, &mut Context::default())
    };
    (0..scene.panels.len())
        .into_par_iter()
        .map(render)
        .collect::<Result<_, Error>>()
        .map_err(|error| error.to_string())
}
