//! One image in a style.

use crate::arrays;
use crate::failure::{Failure, detached};
use crate::settings::style_of;
use inkpanel_engine::native;
use pyo3::prelude::*;
use serde_json::Value;

/// Draws an array in a style, which is given as JSON: an id, or a style file. `seed` sets the seed of all
/// random blocks.
#[pyfunction]
pub(crate) fn stylize(
    py: Python<'_>,
    array: &Bound<'_, PyAny>,
    style: &str,
    seed: Option<u32>,
) -> PyResult<Py<PyAny>> {
    let (image, is_gray) = arrays::image("array", array)?;
    let size = (image.width(), image.height());
    let drawn = detached(py, || {
        let told: Value =
            serde_json::from_str(style).map_err(|error| Failure::argument("style", &error.to_string()))?;
        let style = style_of(&told)?;
        let style = seed.map_or_else(|| Ok(style.clone()), |seed| style.seeded(seed))?;
        // Not `Style::draw`, because gray images stay gray.
        let drawn =
            inkpanel_engine::style::stylize(&image, style.chain(), &mut native::context_for(style.chain(), &image))?;
        Ok(if is_gray && drawn.is_luma() {
            Pixels::Gray(drawn.into_parts().0.swap_remove(0).into_samples())
        } else {
            Pixels::Colour(drawn.to_rgb())
        })
    })?;
    Ok(match drawn {
        Pixels::Gray(samples) => arrays::gray(py, size, samples)?.into_any().unbind(),
        Pixels::Colour(rgb) => arrays::colour(py, size, rgb)?.into_any().unbind(),
    })
}

enum Pixels {
    Gray(Vec<u8>),
    Colour(Vec<u8>),
}
