//! Names of places by location.

use crate::failure::Failure;
use inkpanel_engine::places::Places;
use std::path::Path;

/// A table of places, which names where photos were taken. It is loaded once for any number of albums. Its file is
/// `places.bin`. `cargo xtask models` makes it from `GeoNames` (CC BY 4.0), and releases have it next to the command line.
pub struct PlaceNames(pub(crate) Places);

impl PlaceNames {
    /// Reads the table from a folder.
    ///
    /// # Errors
    /// `no-models` if the file is missing; `damaged` if it is not a table of places.
    pub fn open(folder: impl AsRef<Path>) -> Result<Self, Failure> {
        let file = folder.as_ref().join("places.bin");
        let table = std::fs::read(&file)
            .map_err(|error| Failure::new("no-models", format!("{}: {error}", file.display())))?;
        Self::from_bytes(&table)
    }

    /// Reads the table from the bytes of its file.
    ///
    /// # Errors
    /// `damaged` if the bytes are not a table of places.
    pub fn from_bytes(table: &[u8]) -> Result<Self, Failure> {
        Ok(Self(Places::read(table)?))
    }
}
