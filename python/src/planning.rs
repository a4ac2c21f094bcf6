//! Pages planned of photos, as the command line plans them.

use crate::failure::{Done, Failure, detached};
use crate::page::Page;
use crate::settings::Settings;
use crate::{nets, photos};
use inkpanel::{Album, Photo, PlaceNames};
use pyo3::prelude::*;
use std::path::Path;

/// Makes pages of photos; `settings` are JSON.
#[pyfunction]
pub(crate) fn render(py: Python<'_>, photos: Vec<Bound<'_, PyAny>>, settings: &str) -> PyResult<Vec<Page>> {
    let photos = photos
        .iter()
        .enumerate()
        .map(|(place, given)| photos::given(place, given))
        .collect::<PyResult<Vec<_>>>()?;
    detached(py, || planned(photos, Settings::read(settings)?))
}

fn planned(photos: Vec<Photo>, settings: Settings) -> Done<Vec<Page>> {
    // Report invalid settings before photos are read.
    let fonts = settings.fonts.iter().map(|file| font(file)).collect::<Done<Vec<_>>>()?;
    let mut album =
        if settings.skip_broken { Album::read_skipping_broken(photos) } else { Album::read(photos)? };
    for (file, bytes) in settings.fonts.iter().zip(fonts) {
        album.add_font(bytes).map_err(|failure| Failure::argument("fonts", &format!("{file}: {failure}")))?;
    }
    if let Some(folder) = &settings.models {
        album.detect(&*nets::of(Path::new(folder))?);
    }
    if let Some(table) = &settings.places {
        let bytes = std::fs::read(table)
            .map_err(|error| Failure::argument("places", &format!("{table}: {error}")))?;
        album.locate(&PlaceNames::from_bytes(&bytes)?);
    }
    for place in settings.star {
        album.star(place)?;
    }
    let pages = match (&settings.book, settings.pages) {
        (Some(book), _) => album.book(&settings.options, book)?,
        (None, Some(most)) => album.pages(&settings.options, most)?,
        (None, None) => vec![album.page(&settings.options)?],
    };
    Ok(pages.into_iter().map(Page::new).collect())
}

/// The bytes of a file of fonts.
fn font(file: &str) -> Done<Vec<u8>> {
    std::fs::read(file).map_err(|error| Failure::argument("fonts", &format!("{file}: {error}")))
}
