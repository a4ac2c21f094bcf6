//! Panel breakouts.

use inkpanel_engine::error::Result;
use inkpanel_engine::page::{Document, breaking};
use inkpanel_engine::raster::Matte;
use wasm_bindgen::prelude::*;

/// Returns the page with the subject of a panel breaking its border, or an empty string if that is
/// impossible. `mask`: the subject of the panel's photo.
#[wasm_bindgen]
pub fn break_frame(document: &str, panel: usize, mask: String) -> Result<String> {
    let Ok(mask) = Matte::try_from(mask) else { return Ok(String::new()) };
    let broken = breaking::broken(&Document::parse(document)?, panel, &mask)?;
    Ok(broken.map(|page| page.to_json()).unwrap_or_default())
}
