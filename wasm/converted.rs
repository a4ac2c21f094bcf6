//! wasm bindings of photos that become files for the core, shared by the modules of decoders.

// Every function that returns a Result throws as the module's documentation says.
#![allow(clippy::missing_errors_doc)]

use super::boundary::decode;
use inkpanel_image::error::Result;
use inkpanel_image::raster::Image;
use inkpanel_image::raster::decode::{Damage, Decoded, Limits};
use wasm_bindgen::prelude::*;

/// Bytes before the pixels of a BMP file.
const HEADER: usize = 54;

/// A photo as another file.
#[wasm_bindgen]
pub struct Converted {
    format: &'static str,
    taken: Option<String>,
    damage: Option<Damage>,
    file: Vec<u8>,
}

#[wasm_bindgen]
impl Converted {
    /// Decodes a file: upright, in sRGB, laid on white. Throws `unknown-format`, `unsupported`, `damaged` and `too-large`.
    #[wasm_bindgen(constructor)]
    pub fn new(bytes: &[u8]) -> Result<Converted> {
        let photo = decode(bytes, &Limits::default())?;
        let Decoded { image, format, taken, damage, .. } = photo;
        Ok(Self { format, taken, damage, file: bmp(&image) })
    }

    /// Name of its format.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn format(&self) -> String {
        self.format.to_owned()
    }

    /// Capture time, `YYYY:MM:DD HH:MM:SS`, if the file contains it.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn taken(&self) -> Option<String> {
        self.taken.clone()
    }

    /// Missing share of the image, drawn grey, from 0 to 1.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn missing(&self) -> f64 {
        self.damage.map_or(0.0, |damage| damage.missing)
    }

    /// Share of the image without detail, from 0 to 1.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn coarse(&self) -> f64 {
        self.damage.map_or(0.0, |damage| damage.coarse)
    }

    /// The BMP file, which is given away.
    #[must_use]
    pub fn take(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.file)
    }
}

/// A BMP file with 24 bits per pixel, from top to bottom.
fn bmp(image: &Image) -> Vec<u8> {
    let (width, height) = (image.width(), image.height());
    let stride = (3 * width).next_multiple_of(4);
    let mut file = vec![0; HEADER + stride * height];
    let length = file.len() as u32;
    file[..2].copy_from_slice(b"BM");
    // Length, offset of the pixels, header size, width and height (negative: from top to bottom), planes,
    // bits.
    let fields = [
        (2, length),
        (10, HEADER as u32),
        (14, 40),
        (18, width as u32),
        (22, (height as u32).wrapping_neg()),
        (26, (24 << 16) | 1),
    ];
    for (at, value) in fields {
        file[at..at + 4].copy_from_slice(&value.to_le_bytes());
    }
    let planes = image.planes();
    let [red, green, blue] = [0, 1, 2].map(|i| &planes[i.min(planes.len() - 1)]);
    for (y, row) in file[HEADER..].chunks_exact_mut(stride.max(1)).enumerate() {
        let samples = red.row(y).iter().zip(green.row(y)).zip(blue.row(y));
        for (pixel, ((&r, &g), &b)) in row.chunks_exact_mut(3).zip(samples) {
            pixel.copy_from_slice(&[b, g, r]);
        }
    }
    file
}
