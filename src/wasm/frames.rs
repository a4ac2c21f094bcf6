//! Frames of videos, which the browser decodes and hands over as pixels.

use super::{Studio, thrown};
use crate::page::import::{Frame, import_frame};
use crate::raster::decode::Limits;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Studio {
    /// Takes a frame of a video as RGBA: `width` x `height` pixels that stand for `square_width` x `square_height`
    /// square ones, to be turned clockwise by `rotation` degrees. The facts are those of `import_photo`; the frame
    /// as a PNG file waits for `take_file`.
    #[allow(clippy::too_many_arguments, reason = "JavaScript passes numbers, not structs")]
    pub fn import_frame(
        &mut self,
        id: &str,
        width: usize,
        height: usize,
        rgba: &[u8],
        square_width: usize,
        square_height: usize,
        rotation: u32,
    ) -> Result<String, JsValue> {
        let frame = Frame { size: (width, height), rgba, square: (square_width, square_height), rotation };
        let (photo, file) = import_frame(id, &frame, &Limits::default()).map_err(thrown)?;
        self.file = file;
        self.take_in(photo)
    }

    /// The file that the last `import_frame` made; empty afterwards.
    #[must_use]
    pub fn take_file(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.file)
    }
}
