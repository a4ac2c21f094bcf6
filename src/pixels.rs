//! Pixels, and files of them.

use crate::failure::Failure;
use inkpanel_engine::error::Error;
use inkpanel_engine::page::{jpeg, png};
use inkpanel_engine::raster::Image;

/// An image in sRGB.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Pixels {
    /// Pixels of a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// `3 * width * height` bytes: red, green and blue of each pixel, row by row from the top.
    pub rgb: Vec<u8>,
    /// Pixels an inch that files announce to a printer.
    pub dpi: u32,
}

impl Pixels {
    /// Pixels of an image at 96 PPI.
    ///
    /// # Errors
    /// `buffer-size` if `rgb` does not have `3 * width * height` bytes.
    pub fn new(width: usize, height: usize, rgb: Vec<u8>) -> Result<Self, Failure> {
        let (expected, actual) = (width.saturating_mul(height).saturating_mul(3), rgb.len());
        if expected == 0 || actual != expected {
            return Err(Error::BufferSize { width, height, expected, actual }.into());
        }
        Ok(Self { width, height, rgb, dpi: 96 })
    }

    /// A PNG file.
    ///
    /// # Errors
    /// `encode`.
    pub fn png(&self) -> Result<Vec<u8>, Failure> {
        Ok(png::encode_rgb(self.width, self.height, &self.rgb, self.dpi)?)
    }

    /// A JPEG file of a quality from 1 to 100.
    ///
    /// # Errors
    /// `invalid-argument` for another quality; `encode`.
    pub fn jpeg(&self, quality: u8) -> Result<Vec<u8>, Failure> {
        if !(1..=100).contains(&quality) {
            return Err(Failure::argument("quality", "must be from 1 to 100"));
        }
        Ok(jpeg::encode_rgb(self.width, self.height, &self.rgb, self.dpi, quality)?)
    }

    pub(crate) fn image(&self) -> Result<Image, Failure> {
        Ok(Image::from_interleaved_rgb(self.width, self.height, &self.rgb)?)
    }
}
