//! wasm bindings of the decoders for rare photos: WebP, TIFF, GIF, and colours of scanners or presses. It is
//! loaded with the first such file, and converts it to a format that the core reads.

// Every function that returns a Result throws as the module's documentation says.
#![allow(clippy::missing_errors_doc)]

use inkpanel_image::error::Result;
use inkpanel_image::raster::animation;
use inkpanel_image::raster::decode::Limits;
pub(crate) use inkpanel_image::raster::decode::decode;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(start)]
fn start() {
    console_error_panic_hook::set_once();
}

/// An animated GIF or WebP file, frame by frame.
#[wasm_bindgen]
pub struct Animation {
    pictures: animation::Animation,
}

#[wasm_bindgen]
impl Animation {
    /// Opens a file. Throws `unknown-format`, `damaged` and `too-large`.
    #[wasm_bindgen(constructor)]
    pub fn new(bytes: Vec<u8>) -> Result<Animation> {
        let pictures = animation::Animation::new(bytes, &Limits::default())?;
        Ok(Self { pictures })
    }

    /// Advances to the next frame. Returns `false` after the last frame. Throws `damaged` if the file is
    /// truncated.
    pub fn advance(&mut self) -> Result<bool> {
        self.pictures.advance()
    }

    /// The current frame, on white, in sRGB.
    pub fn picture(&mut self) -> Result<Picture> {
        let image = self.pictures.picture()?;
        Ok(Picture { width: image.width(), height: image.height(), rgba: image.to_rgba() })
    }
}

/// One frame of an animation.
#[wasm_bindgen]
pub struct Picture {
    /// In pixels.
    #[wasm_bindgen(readonly)]
    pub width: usize,
    /// In pixels.
    #[wasm_bindgen(readonly)]
    pub height: usize,
    rgba: Vec<u8>,
}

#[wasm_bindgen]
impl Picture {
    /// Its RGBA, which is given away.
    #[must_use]
    pub fn take(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.rgba)
    }
}
