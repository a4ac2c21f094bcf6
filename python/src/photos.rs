//! Photos as Python gives them: paths, files as bytes, or arrays.

use crate::arrays;
use crate::failure::{Done, Failure, survived};
use inkpanel::native;
use inkpanel::page::Document;
use inkpanel::page::import::{Imported, import, import_image};
use inkpanel::raster::Image;
use inkpanel::raster::decode::{Limits, decode};
use numpy::PyUntypedArray;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyBytes;
use rayon::prelude::*;
use std::path::{Path, PathBuf};

/// Where the pixels of a photo come from.
enum Source {
    File(PathBuf),
    Bytes(PyBackedBytes),
    Pixels(Image),
}

/// A photo that was given.
pub(crate) struct Photo {
    /// Its path, or a name of its place in the list.
    pub(crate) name: String,
    source: Source,
}

/// What pages call the photo of a place in the list, as the command line does.
pub(crate) fn id(place: usize) -> String {
    format!("photo-{place}")
}

impl Photo {
    /// Takes what Python gave as the photo of a place.
    pub(crate) fn new(place: usize, given: &Bound<'_, PyAny>) -> PyResult<Self> {
        let name = format!("photo {place}");
        if given.is_instance_of::<PyUntypedArray>() {
            let (image, _) = arrays::image(&name, given)?;
            return Ok(Self { name, source: Source::Pixels(image) });
        }
        if given.is_instance_of::<PyBytes>() {
            return Ok(Self { name, source: Source::Bytes(given.extract()?) });
        }
        let Ok(path) = given.extract::<PathBuf>() else {
            let kind = given.get_type().qualname()?;
            return Err(PyTypeError::new_err(format!(
                "{name}: must be a path, bytes or a numpy array, not {kind}"
            )));
        };
        Ok(Self { name: path.display().to_string(), source: Source::File(path) })
    }

    /// Reads, reduces and measures it.
    fn imported(&self, id: &str) -> Done<Imported> {
        let limits = Limits::default();
        self.told(|| match &self.source {
            Source::File(path) => Ok(import(id, &read(path)?, &limits)?),
            Source::Bytes(bytes) => Ok(import(id, bytes, &limits)?),
            Source::Pixels(image) => Ok(import_image(id, image, &limits)?),
        })
    }

    /// Its pixels at their full size.
    fn full(&self) -> Done<Image> {
        let limits = Limits::default();
        self.told(|| match &self.source {
            Source::File(path) => Ok(decode(&read(path)?, &limits)?.image),
            Source::Bytes(bytes) => Ok(decode(bytes, &limits)?.image),
            Source::Pixels(image) => Ok(image.clone()),
        })
    }

    fn told<T>(&self, work: impl FnOnce() -> Done<T>) -> Done<T> {
        survived(work).map_err(|failure| failure.of(&self.name))
    }
}

fn read(path: &Path) -> Done<Vec<u8>> {
    std::fs::read(path).map_err(|error| {
        let code = if error.kind() == std::io::ErrorKind::NotFound { "not-found" } else { "unreadable" };
        let folder = if path.is_dir() { "; list the files in this folder" } else { "" };
        Failure::new(code, format!("{error}{folder}"))
    })
}

/// Reads photos side by side, each with its own failure.
pub(crate) fn import_all(photos: &[Photo]) -> Vec<Done<Imported>> {
    photos.par_iter().enumerate().map(|(place, photo)| photo.imported(&id(place))).collect()
}

/// The photos that a page shows at their full size, read side by side.
pub(crate) fn shown(document: &Document, photos: &[Photo]) -> Done<native::Photos> {
    let wanted = native::photos_of(document)?;
    let places: Vec<usize> = (0..photos.len()).filter(|place| wanted.contains(&id(*place))).collect();
    places.into_par_iter().map(|place| Ok((id(place), photos[place].full()?.into()))).collect()
}
