//! One image in a style.

use crate::arrays;
use crate::failure::{Done, Failure, detached};
use inkpanel::style::params::Kind;
use inkpanel::style::{Context, Style, blocks, catalogue};
use pyo3::prelude::*;
use serde_json::Value;

/// Draws an array in a style, which is told as JSON: an id, or a style file. A `seed` goes to the blocks that have one.
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
        let style = seeded(read(style)?, seed)?;
        let drawn = inkpanel::style::stylize(&image, &style, &mut Context::for_image(&image))?;
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

/// The style of a text of JSON.
fn read(json: &str) -> Done<Style> {
    let value: Value =
        serde_json::from_str(json).map_err(|error| Failure::argument("style", &error.to_string()))?;
    style_of(&value)
}

/// A style by its id, or in full.
pub(crate) fn style_of(value: &Value) -> Done<Style> {
    Ok(match value {
        Value::String(id) => catalogue::find(id)?.clone(),
        value => Style::from_value("style", value)?,
    })
}

/// The style with a seed in all blocks that leave something to chance.
fn seeded(style: Style, seed: Option<u32>) -> Done<Style> {
    /// As the blocks name it.
    const SEED: &str = "seed";
    let Some(seed) = seed else { return Ok(style) };
    let mut value = style.to_value();
    for layer in ["background", "foreground"] {
        for entry in value.get_mut(layer).and_then(Value::as_array_mut).into_iter().flatten() {
            let block = blocks::ALL.iter().find(|block| entry["block"] == block.id);
            let most = block.and_then(|block| {
                let own = block.params.iter().find(|param| param.id == SEED)?;
                match own.kind {
                    Kind::Integer { max, .. } => u32::try_from(max).ok(),
                    _ => None,
                }
            });
            if let Some(most) = most {
                entry[SEED] = (seed % (most + 1)).into();
            }
        }
    }
    Ok(Style::from_value("style", &value)?)
}
