//! Saved projects and pages on the command line: drawn as the page itself exports them.

use crate::{Complaint, drawing, reading, survived, write};
use inkpanel::document::file::FilePhoto;
use inkpanel::document::saved::Saved;
use inkpanel::document::sheets::photos_on;
use inkpanel::framing::Subject;
use inkpanel::page::Document;
use inkpanel::raster::Image;
use inkpanel::raster::decode::{Limits, decode};
use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

/// What says that a file is meant as a project.
const EXTENSION: &str = "inkpanel";

/// Reads a project file, or a PNG with its project.
///
/// Returns nothing where the file is neither: then it is a photo.
pub(crate) fn open(input: &Path) -> Option<Result<Saved, Complaint>> {
    let named = is_project(input);
    let complain = |reason: String| Err(format!("{}: {reason}", input.display()));
    let bytes = match std::fs::read(input) {
        Ok(bytes) => bytes,
        // What of a photo cannot be read is told where photos are.
        Err(error) => return named.then(|| complain(error.to_string())),
    };
    match survived(|| Saved::read(bytes)) {
        Ok(Some(saved)) => Some(Ok(saved)),
        Ok(None) => named.then(|| complain("this is no project of Inkpanel".into())),
        Err(reason) => Some(complain(reason)),
    }
}

/// Draws the present page, or the one of that number, from 1; a comic has all pages unless one is told.
pub(crate) fn draw(
    saved: Saved,
    input: &Path,
    number: Option<u32>,
    output: &Path,
    language: &str,
) -> Result<(), Complaint> {
    let file = match reading::Kind::of(output) {
        Some(kind) => comic(saved, number, output, kind, language),
        None => drawn(saved, number, output),
    };
    write(output, &file.map_err(|reason| format!("{}: {reason}", input.display()))?)
}

/// The pages of a project as a comic, called as the project is, or as the file.
fn comic(
    mut saved: Saved,
    number: Option<u32>,
    output: &Path,
    kind: reading::Kind,
    language: &str,
) -> Result<Vec<u8>, Complaint> {
    let (mut pages, _) = saved.pages();
    if number.is_some() || pages.is_empty() {
        let page = chosen(&saved, number)?;
        pages = vec![page];
    }
    let own = saved.project().history.present.name.trim().to_owned();
    let stem = output.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let title = if own.is_empty() { stem } else { own };
    let known: HashMap<String, Vec<Subject>> =
        saved.project().photos.iter().map(|photo| (photo.id.clone(), subjects(photo))).collect();
    let telling = reading::Telling { title: &title, language };
    let found = |id: &str| known.get(id).map_or(&[][..], Vec::as_slice);
    let mut picture = |page: &Document| {
        let files = files(&mut saved, page)?;
        drawing::jpeg_of(page, &|id: &str| photo(&saved, &files, id))
    };
    let pages: Vec<&Document> = pages.iter().map(|page| &**page).collect();
    reading::made(kind, telling, &pages, &found, &mut picture)
}

/// What the file says was found in a photo, as far as it can be read.
fn subjects(photo: &FilePhoto) -> Vec<Subject> {
    let told = photo.subjects.iter().flatten();
    told.filter_map(|subject| serde_json::from_value(subject.clone()).ok()).collect()
}

/// Whether its name says that a file is a project.
pub(crate) fn is_project(file: &Path) -> bool {
    file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(EXTENSION))
}

fn drawn(mut saved: Saved, number: Option<u32>, output: &Path) -> Result<Vec<u8>, Complaint> {
    let page = chosen(&saved, number)?;
    let files = files(&mut saved, &page)?;
    drawing::draw(&page, &|id: &str| photo(&saved, &files, id), output)
}

/// The present page, or the one of that number.
fn chosen(saved: &Saved, number: Option<u32>) -> Result<Arc<Document>, Complaint> {
    let (pages, present) = saved.pages();
    let at = number.map_or(present, |number| number as usize - 1);
    pages.get(at).cloned().ok_or_else(|| match pages.len() {
        0 => "there is no page in it".to_owned(),
        1 => format!("there is no page {} in it, only one", at + 1),
        count => format!("there is no page {} in it, only {count}", at + 1),
    })
}

/// A photo at its full size, of the files of a page.
fn photo(saved: &Saved, files: &HashMap<String, Vec<u8>>, id: &str) -> Result<Option<Image>, Complaint> {
    let Some(bytes) = files.get(id) else { return Ok(None) };
    let name = saved.photo(id).map_or(id, |photo| &photo.name);
    let decoded = survived(|| decode(bytes, &Limits::default()));
    decoded.map(|decoded| Some(decoded.image)).map_err(|reason| format!("the photo {name}: {reason}"))
}

/// The files of the photos that a page shows, by their ids.
fn files(saved: &mut Saved, page: &Document) -> Result<HashMap<String, Vec<u8>>, Complaint> {
    let mut shown: Vec<&str> = photos_on(&[page]).into_iter().collect();
    shown.sort_unstable();
    let mut files = HashMap::new();
    for id in &shown {
        if let Some(file) = saved.photo_file(id).map_err(|error| error.to_string())? {
            files.insert((*id).to_owned(), file);
        }
    }
    match (shown.len() - files.len(), shown.len()) {
        (0, _) => Ok(files),
        (1, 1) => Err("its photo is not in it; save it again with the photo".into()),
        (missing, all) => {
            Err(format!("{missing} of its {all} photos are not in it; save it again with the photos"))
        }
    }
}
