//! Frames of videos. The browser decodes them and passes their pixels.

use super::{Patch, Studio};
use inkpanel_engine::error::Result;
use inkpanel_engine::page;
use inkpanel_engine::page::import::{Frame, import_frame, small_frame};
use inkpanel_engine::page::living::living;
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::Limits;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Studio {
    /// Imports a frame of a video as RGBA: `width` x `height` pixels that represent `square_width` x
    /// `square_height` square pixels, to be rotated clockwise by `rotation` degrees. Returns the data of
    /// `import_photo`. `take_file` then returns the frame as a PNG file.
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
    ) -> Result<String> {
        let frame = Frame { size: (width, height), rgba, square: (square_width, square_height), rotation };
        let (photo, file) = import_frame(id, &frame, &Limits::default())?;
        self.file = file;
        self.take_in(photo)
    }

    /// The file that the last `import_frame` made; empty afterwards.
    #[must_use]
    pub fn take_file(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.file)
    }

    /// Rotates a frame of a video, in the form of `import_frame`, and reduces it to a long side of at most
    /// `longest` pixels. Returns RGBA.
    #[allow(clippy::too_many_arguments, reason = "JavaScript passes numbers, not structs")]
    pub fn small_frame(
        &self,
        width: usize,
        height: usize,
        rgba: &[u8],
        square_width: usize,
        square_height: usize,
        rotation: u32,
        longest: usize,
    ) -> Result<Patch> {
        let frame = Frame { size: (width, height), rgba, square: (square_width, square_height), rotation };
        let image = small_frame(&frame, longest, &Limits::default())?;
        Ok(Patch::whole(image.width(), image.height(), image.to_rgba()))
    }

    /// Adds a frame of the video for the next call of `draw_living`.
    pub fn add_living(&mut self, width: usize, height: usize, rgba: &[u8]) -> Result<()> {
        // Drop the frames of a failed panel.
        let frame = Image::from_rgba(width, height, rgba, [255; 3]).inspect_err(|_| self.living.clear());
        self.living.push(frame?);
        Ok(())
    }

    /// Draws an animated panel of a page as a loop of the added frames. `still` is the index of its photo;
    /// see `page::living`. Returns no frames for a still panel.
    pub fn draw_living(
        &mut self,
        document: &str,
        index: usize,
        width: usize,
        still: usize,
    ) -> Result<Vec<Patch>> {
        let frames = std::mem::take(&mut self.living);
        let mut drawn = || -> Result<_> {
            let scene = self.scene(document, width, "work")?;
            living(&scene, index, (&frames, still), &mut self.context)
        };
        let told = |patch: page::Patch| Patch { area: patch.area, rgba: patch.rgba };
        Ok(drawn()?.into_iter().map(told).collect())
    }
}
