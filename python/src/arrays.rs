//! Images as numpy arrays: `uint8`, `(height, width, 3)` in RGB or `(height, width)` in gray.

use crate::failure::{Done, Failure};
use inkpanel_engine::raster::decode::Limits;
use inkpanel_engine::raster::{Image, Plane};
use numpy::ndarray::{Array2, Array3, ArrayView2, Axis};
use numpy::{
    IntoPyArray, PyArray2, PyArray3, PyArrayDescrMethods, PyArrayMethods, PyReadonlyArray2, PyReadonlyArray3,
    PyUntypedArray, PyUntypedArrayMethods, dtype,
};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

/// The pixels of an array, planar as the engine has them: the one copy that there is. A gray array has three like planes, as a
/// gray file has. Returns whether it is gray.
pub(crate) fn image(what: &str, array: &Bound<'_, PyAny>) -> PyResult<(Image, bool)> {
    let Ok(untyped) = array.cast::<PyUntypedArray>() else {
        let kind = array.get_type().qualname()?;
        return Err(PyTypeError::new_err(format!("{what}: must be a numpy array of uint8, not {kind}")));
    };
    let py = array.py();
    let shape = untyped.shape().to_vec();
    if !untyped.dtype().is_equiv_to(&dtype::<u8>(py)) {
        let told = format!("is of {}, but must be of uint8, from 0 to 255", untyped.dtype());
        return Err(unfit(what, &told, &shape).into());
    }
    let (height, width) = match shape[..] {
        [height, width] | [height, width, 3] => (height, width),
        [_, _, 4] => return Err(unfit(what, "has an alpha channel: lay it on paper first", &shape).into()),
        _ => return Err(unfit(what, "must be (height, width, 3) or (height, width)", &shape).into()),
    };
    let side = |side: usize| u32::try_from(side).unwrap_or(u32::MAX);
    Limits::default().check(side(width), side(height), "array").map_err(Failure::from)?;
    if shape.len() == 2 {
        let array: PyReadonlyArray2<'_, u8> = array.cast::<PyArray2<u8>>()?.try_readonly()?;
        let plane = plane(array.as_array())?;
        let image = Image::from_rgb([plane.clone(), plane.clone(), plane]).map_err(Failure::from)?;
        return Ok((image, true));
    }
    let array: PyReadonlyArray3<'_, u8> = array.cast::<PyArray3<u8>>()?.try_readonly()?;
    let pixels = array.as_array();
    let image = if let Some(rgb) = pixels.as_slice() {
        Image::from_interleaved_rgb(width, height, rgb)
    } else {
        let [r, g, b] = [0, 1, 2].map(|channel| plane(pixels.index_axis(Axis(2), channel)));
        Image::from_rgb([r?, g?, b?])
    };
    Ok((image.map_err(Failure::from)?, false))
}

fn plane(samples: ArrayView2<'_, u8>) -> Done<Plane> {
    let (height, width) = samples.dim();
    Ok(Plane::from_samples(width, height, samples.iter().copied().collect())?)
}

fn unfit(what: &str, reason: &str, shape: &[usize]) -> Failure {
    let sides: Vec<String> = shape.iter().map(usize::to_string).collect();
    Failure::new("invalid-array", format!("{what}: {reason}; its shape is ({})", sides.join(", ")))
}

/// Returns RGB bytes as an array, without a copy.
pub(crate) fn colour(
    py: Python<'_>,
    (width, height): (usize, usize),
    rgb: Vec<u8>,
) -> PyResult<Bound<'_, PyArray3<u8>>> {
    let array = Array3::from_shape_vec((height, width, 3), rgb);
    Ok(array.map_err(|error| Failure::fault(&error.to_string()))?.into_pyarray(py))
}

/// Returns gray samples as an array, without a copy.
pub(crate) fn gray(
    py: Python<'_>,
    (width, height): (usize, usize),
    samples: Vec<u8>,
) -> PyResult<Bound<'_, PyArray2<u8>>> {
    let array = Array2::from_shape_vec((height, width), samples);
    Ok(array.map_err(|error| Failure::fault(&error.to_string()))?.into_pyarray(py))
}
