//! Photos as Python gives them: paths, files as bytes, or arrays.

use crate::arrays;
use inkpanel::Photo;
use numpy::PyUntypedArray;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyBytes;
use std::path::PathBuf;

/// Reads a Python value as the photo at index `place`.
pub(crate) fn given(place: usize, given: &Bound<'_, PyAny>) -> PyResult<Photo> {
    let name = format!("photo {place}");
    if given.is_instance_of::<PyUntypedArray>() {
        let (image, _) = arrays::image(&name, given)?;
        return Ok(Photo::from_image(name, image));
    }
    if given.is_instance_of::<PyBytes>() {
        return Ok(Photo::from_bytes(name, given.extract::<PyBackedBytes>()?));
    }
    let Ok(path) = given.extract::<PathBuf>() else {
        let kind = given.get_type().qualname()?;
        return Err(PyTypeError::new_err(format!(
            "{name}: must be a path, bytes or a numpy array, not {kind}"
        )));
    };
    Ok(Photo::open(path))
}
