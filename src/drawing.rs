//! Pages of the command line as files: rendered from the photos at their full size, with their words.

use crate::{Complaint, decode_file};
use inkpanel::Error;
use inkpanel::page::import::Imported;
use inkpanel::page::words::{Letters, draw as word_drawing, place};
use inkpanel::page::{Document, Scene, compose, png};
use inkpanel::raster::Image;
use inkpanel::style::Context;
use rayon::prelude::*;
use std::collections::HashMap;
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

/// Renders a document from the files of its photos, decoded at their full size.
pub(crate) fn draw(document: &Document, photos: &[(PathBuf, Imported)]) -> Result<Vec<u8>, Complaint> {
    let scene = Scene::new(document, document.page.width as usize).map_err(|error| error.to_string())?;
    let wanted: Vec<_> = photos
        .iter()
        .filter(|(_, photo)| scene.panels.iter().any(|panel| panel.photo.as_ref() == Some(&photo.meta.id)))
        .collect();
    let images: HashMap<&str, Image> = wanted
        .par_iter()
        .map(|(path, photo)| Ok((photo.meta.id.as_str(), decode_file(path)?)))
        .collect::<Result<_, Complaint>>()?;
    let render = |index: usize| -> inkpanel::Result<compose::Patch> {
        let photo = scene.panels[index].photo.as_deref().and_then(|id| images.get(id));
        compose::render_panel(&scene, index, photo, &mut Context::default())
    };
    let patches: Vec<_> = (0..scene.panels.len())
        .into_par_iter()
        .map(render)
        .collect::<Result<_, Error>>()
        .map_err(|error| error.to_string())?;
    let mut sheet = compose::Sheet::new(&scene);
    for patch in patches {
        sheet.lay(patch.area, &patch.rgba).map_err(|error| error.to_string())?;
    }
    let lay = |letters: Letters| word_drawing::lay_words(&mut sheet, document, &letters);
    Letters::bundled().and_then(lay).map_err(|error| error.to_string())?;
    png::encode(&sheet, document.page.dpi).map_err(|error| error.to_string())
}
