//! Names of the places where photos were taken.

use inkpanel_engine::error::Result;
use inkpanel_engine::places::Places;
use wasm_bindgen::prelude::*;

/// Whether the GPS fields of a photo have its location. The beginning of a JPEG or PNG file is enough.
#[wasm_bindgen]
#[must_use]
pub fn has_location(file: &[u8]) -> bool {
    inkpanel_engine::raster::location::location(file).is_some()
}

/// A table of places.
#[wasm_bindgen]
pub struct PlaceTable {
    places: Places,
}

#[wasm_bindgen]
impl PlaceTable {
    /// Reads the table that is not compressed.
    #[wasm_bindgen(constructor)]
    pub fn new(table: &[u8]) -> Result<Self> {
        Ok(Self { places: Places::parse(table)? })
    }

    /// Returns the name of the place where a photo was taken. Nothing without GPS fields, or if the place is unknown.
    #[must_use]
    pub fn name_of(&self, file: &[u8]) -> Option<String> {
        self.places.of_photo(file).map(str::to_owned)
    }
}
