//! Pages planned of photos, as the command line plans them.

use crate::failure::{Done, Failure, detached};
use crate::page::{Album, Page};
use crate::photos::{Photo, id, import_all};
use crate::settings::Settings;
use crate::{failure, nets};
use inkpanel::framing::Subject;
use inkpanel::page::import::Imported;
use inkpanel::page::request::Request;
use inkpanel::page::storyboard;
use inkpanel::page::words::given::{GivenFonts, missing};
use inkpanel::page::words::place;
use pyo3::prelude::*;
use rayon::prelude::*;
use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

/// Makes pages of photos; `settings` are JSON.
#[pyfunction]
pub(crate) fn render(py: Python<'_>, photos: Vec<Bound<'_, PyAny>>, settings: &str) -> PyResult<Vec<Page>> {
    let photos = photos
        .iter()
        .enumerate()
        .map(|(place, given)| Photo::new(place, given))
        .collect::<PyResult<Vec<_>>>()?;
    detached(py, || planned(photos, &Settings::read(settings)?))
}

fn planned(photos: Vec<Photo>, settings: &Settings) -> Done<Vec<Page>> {
    let mut notes = Vec::new();
    let fonts = given_fonts(&settings.fonts)?;
    let mut read: Vec<(usize, Imported)> = Vec::new();
    for (place, imported) in import_all(&photos).into_iter().enumerate() {
        match imported {
            Ok(imported) => read.push((place, imported)),
            Err(failure) if settings.skip_broken => notes.push(format!("{}; left out", failure.message())),
            Err(failure) => return Err(failure),
        }
    }
    if let Some(folder) = &settings.models {
        find_subjects(&mut read, Path::new(folder), (&photos, &mut notes))?;
    }
    for place in &settings.star {
        let starred = read.iter_mut().find(|(own, _)| own == place);
        starred.ok_or_else(|| Failure::argument("star", "names a photo that is not there"))?.1.meta.starred =
            true;
    }
    let names: Vec<&str> = read.iter().map(|(place, _)| photos[*place].name.as_str()).collect();
    let imported: Vec<&Imported> = read.iter().map(|(_, imported)| imported).collect();
    let (used, verdicts) = storyboard::chosen(&names, &imported, settings.choice);
    let left = names.iter().zip(&verdicts).filter(|(_, verdict)| !verdict.kept);
    notes.extend(left.map(|(name, verdict)| format!("{name}: left out: {}", verdict.why)));
    let request = Request {
        seed: settings.seed,
        photos: used,
        page: settings.page.clone(),
        layout: settings.layout.clone(),
        style: settings.style.clone(),
        panels: settings.panels,
        merge: Some(settings.merge),
        ..Request::default()
    };
    let mut documents: Vec<_> =
        storyboard::pages(&request, settings.pages)?.into_iter().map(|page| page.document).collect();
    let subjects: HashMap<String, Vec<Subject>> =
        read.iter().map(|(place, imported)| (id(*place), imported.meta.subjects.clone())).collect();
    if let (Some(first), false) = (documents.first_mut(), settings.words.is_empty()) {
        let of = |id: &str| subjects.get(id).map_or(&[][..], Vec::as_slice).into();
        let letters = fonts.letters(&settings.words)?;
        place::add(first, settings.words.clone(), of, &letters)?;
        let missing = missing(&letters, &settings.words);
        if !missing.is_empty() {
            let letters = missing.join(" ");
            notes.push(format!("no font has these letters, so a question mark stands for each: {letters}"));
        }
    }
    let album = Arc::new(Album { photos, subjects, fonts, notes });
    Ok(documents.into_iter().map(|document| Page::new(album.clone(), document)).collect())
}

/// The fonts of some files.
fn given_fonts(files: &[String]) -> Done<GivenFonts> {
    let mut fonts = GivenFonts::default();
    for file in files {
        let wrong = |reason: &str| Failure::argument("fonts", &format!("{file}: {reason}"));
        let bytes = std::fs::read(file).map_err(|error| wrong(&error.to_string()))?;
        fonts.add(bytes).map_err(wrong)?;
    }
    Ok(fonts)
}

/// Tells framing what is in the photos. What fails in one photo is told and counts as nothing found.
fn find_subjects(
    read: &mut [(usize, Imported)],
    folder: &Path,
    (photos, notes): (&[Photo], &mut Vec<String>),
) -> Done<()> {
    let nets = nets::of(folder)?;
    let found: Vec<_> =
        read.par_iter().map(|(_, imported)| failure::survived(|| Ok(nets.detect(&imported.work)?))).collect();
    for ((place, imported), found) in read.iter_mut().zip(found) {
        match found {
            Ok(found) => imported.meta.find(found.into_iter().map(Into::into)),
            Err(failure) => notes.push(format!("{}: {}", photos[*place].name, failure.message())),
        }
    }
    Ok(())
}
