//! GIF: the first frame, on its screen.
//!
//! The screen grows if the first frame extends beyond it, as in browsers. Pixels outside the frame are
//! transparent. The background colour of the file is ignored.

use gif::{ColorOutput, DecodeOptions, DecodingError};

use super::channels::Channels;
use super::limits::{Limits, check_memory, out_of_memory};
use super::samples::{Alpha, Pixels};
use crate::error::{Error, Result};

/// Reads the first frame of a file.
pub(super) fn read(file: &[u8], name: &'static str, limits: &Limits) -> Result<Pixels> {
    let failed = |error: DecodingError| Error::damaged(name, error);
    let mut options = DecodeOptions::new();
    options.set_color_output(ColorOutput::RGBA);
    let mut decoder = options.read_info(file).map_err(failed)?;
    let screen = (usize::from(decoder.width()), usize::from(decoder.height()));
    let first = decoder.next_frame_info().map_err(failed)?;
    let first = first.ok_or_else(|| Error::damaged(name, "it has no picture"))?;
    let [left, top, width, height] = [first.left, first.top, first.width, first.height].map(usize::from);
    let size = (screen.0.max(left + width), screen.1.max(top + height));
    limits.check(size.0 as u32, size.1 as u32, name)?;
    check_memory(size, if (width, height) == size { 4 } else { 8 }, limits)?;
    let mut frame = vec![0; decoder.buffer_size()];
    decoder.read_into_buffer(&mut frame).map_err(failed)?;
    if frame.len() != 4 * width * height {
        return Err(out_of_memory(size, limits));
    }
    if (width, height) == size {
        return Ok(Pixels::flattened(size, frame, Channels::Rgb, Alpha::Straight));
    }
    let mut samples = vec![0; 4 * size.0 * size.1];
    if width > 0 {
        for (y, row) in frame.chunks_exact(4 * width).enumerate() {
            samples[4 * ((top + y) * size.0 + left)..][..4 * width].copy_from_slice(row);
        }
    }
    Ok(Pixels::flattened(size, samples, Channels::Rgb, Alpha::Straight))
}
