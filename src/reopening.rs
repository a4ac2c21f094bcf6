//! Saved projects and pages on the command line: drawn as the page itself exports them.

use crate::drawing;
use crate::{Complaint, survived, write};
use inkpanel::document::saved::Saved;
use inkpanel::document::sheets::photos_on;
use inkpanel::page::Document;
use inkpanel::raster::decode::{Limits, decode};
use std::collections::HashMap;
use std::path::Path;

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

/// Draws the present page, or the one of that number, from 1.
pub(crate) fn draw(saved: Saved, input: &Path, number: Option<u32>, output: &Path) -> Result<(), Complaint> {
    let file = drawn(saved, number, output).map_err(|reason| format!("{}: {reason}", input.display()))?;
    write(output, &file)
}

/// Whether its name says that a file is a project.
pub(crate) fn is_project(file: &Path) -> bool {
    file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(EXTENSION))
}

fn drawn(mut saved: Saved, number: Option<u32>, output: &Path) -> Result<Vec<u8>, Complaint> {
    let (pages, present) = saved.pages();
    let at = number.map_or(present, |number| number as usize - 1);
    let page = pages.get(at).ok_or_else(|| match pages.len() {
        0 => "there is no page in it".to_owned(),
        1 => format!("there is no page {} in it, only one", at + 1),
        count => format!("there is no page {} in it, only {count}", at + 1),
    })?;
    let files = files(&mut saved, page)?;
    let photos = |id: &str| {
        let Some(bytes) = files.get(id) else { return Ok(None) };
        let name = saved.photo(id).map_or(id, |photo| &photo.name);
        let decoded = survived(|| decode(bytes, &Limits::default()));
        decoded.map(|decoded| Some(decoded.image)).map_err(|reason| format!("the photo {name}: {reason}"))
    };
    drawing::draw(page, &photos, output)
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
