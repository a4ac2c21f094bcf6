//! What a JPEG file says before its pixels: size, EXIF record, and whether it is whole.
//!
//! The decoder paints the missing part of a file that was cut short in grey and says nothing, so the end is
//! looked for here. Source: ITU-T T.81, annex B. The pixels are `zune-jpeg`'s.

use crate::error::{Error, Result};
use zune_jpeg::JpegDecoder;
use zune_jpeg::errors::DecodeErrors;
use zune_jpeg::zune_core::bytestream::ZCursor;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

/// A file whose headers were read. Grey stays grey; every other colour space becomes RGB.
pub(super) struct Decoder {
    /// Of the very type that `tiff` uses for JPEG in TIFF: another one would be in the module a second time.
    file: JpegDecoder<ZCursor<Vec<u8>>>,
    size: (usize, usize),
    grey: bool,
    name: &'static str,
}

impl Decoder {
    /// Reads the headers; `name` is that of the format, for messages.
    pub(super) fn new(bytes: &[u8], name: &'static str) -> Result<Self> {
        // Files with small faults are drawn by every other program, too; the sides are checked by the caller.
        let options = DecoderOptions::default()
            .set_strict_mode(false)
            .set_max_width(usize::MAX)
            .set_max_height(usize::MAX);
        let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes.to_vec()), options);
        decoder.decode_headers().map_err(|error| explained(error, name))?;
        let grey = decoder.input_colorspace() == Some(ColorSpace::Luma);
        let out = if grey { ColorSpace::Luma } else { ColorSpace::RGB };
        decoder.set_options(options.jpeg_set_out_colorspace(out));
        let size = decoder.dimensions().ok_or_else(|| Error::damaged(name, "it announces no pixels"))?;
        Ok(Self { file: decoder, size, grey, name })
    }

    /// Width and height in pixels.
    pub(super) fn size(&self) -> (usize, usize) {
        self.size
    }

    /// Whether there is one sample a pixel; else there are three.
    pub(super) fn is_grey(&self) -> bool {
        self.grey
    }

    /// The ICC profile, put together from its parts.
    pub(super) fn profile(&self) -> Option<Vec<u8>> {
        self.file.icc_profile()
    }

    /// The samples, interleaved.
    pub(super) fn samples(&mut self) -> Result<Vec<u8>> {
        self.file.decode().map_err(|error| explained(error, self.name))
    }
}

fn explained(error: DecodeErrors, format: &'static str) -> Error {
    match error {
        DecodeErrors::Unsupported(reason) => Error::Unsupported { format, reason: format!("{reason:?}") },
        error => Error::damaged(format, error),
    }
}

/// The markers of a file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Markers<'a> {
    /// Width and height as announced.
    pub(super) size: Option<(u32, u32)>,
    /// Number of colour components.
    pub(super) components: u8,
    /// The EXIF record, without its mark.
    pub(super) exif: Option<&'a [u8]>,
    /// True when the end of the image is there.
    pub(super) complete: bool,
}

const END_OF_IMAGE: u8 = 0xD9;
const APP1: u8 = 0xE1;

impl<'a> Markers<'a> {
    /// Walks through the segments, and through the coded data between them.
    pub(super) fn of(bytes: &'a [u8]) -> Self {
        let mut markers = Self { size: None, components: 0, exif: None, complete: false };
        let mut at = 2;
        while let Some((marker, after)) = next_marker(bytes, at) {
            if marker == END_OF_IMAGE {
                markers.complete = true;
                break;
            }
            let Some(&[high, low]) = bytes.get(after..).and_then(<[u8]>::first_chunk) else { break };
            let end = after + usize::from(u16::from_be_bytes([high, low]));
            let Some(payload) = bytes.get(after + 2..end) else { break };
            match marker {
                APP1 if markers.exif.is_none() => markers.exif = payload.strip_prefix(b"Exif\0\0"),
                // Start of frame: C0..CF but for DHT, JPG and DAC.
                0xC0..=0xCF if !matches!(marker, 0xC4 | 0xC8 | 0xCC) => {
                    if let Some(&[_, h1, h0, w1, w0, components]) = payload.first_chunk() {
                        let size = [[w1, w0], [h1, h0]].map(|side| u32::from(u16::from_be_bytes(side)));
                        markers.size = markers.size.or(Some((size[0], size[1])));
                        markers.components = components;
                    }
                }
                _ => {}
            }
            at = end;
        }
        markers
    }

    /// True when coded data of `length` bytes can hold the announced pixels: a block of 64 takes a bit at least.
    pub(super) fn plausible(&self, length: usize) -> bool {
        let (width, height) = self.size.unwrap_or((0, 0));
        u64::from(width) * u64::from(height) <= length as u64 * 8 * 64
    }
}

/// The next marker from `at`, and the position after it. Stuffed zeros, fill bytes and restarts are passed over,
/// and with them the coded data.
fn next_marker(bytes: &[u8], mut at: usize) -> Option<(u8, usize)> {
    loop {
        at += bytes.get(at..)?.iter().position(|&byte| byte == 0xFF)?;
        match *bytes.get(at + 1)? {
            0xFF => at += 1,
            0x00 | 0x01 | 0xD0..=0xD8 => at += 2,
            marker => return Some((marker, at + 2)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const START_OF_SCAN: u8 = 0xDA;

    #[test]
    fn the_end_inside_a_thumbnail_is_not_the_end_of_the_image() {
        // SOI, an APP1 that holds a whole little file, SOF0 of 300 x 200 with 3 components, coded data.
        let mut file = vec![0xFF, 0xD8, 0xFF, APP1, 0, 8, 1, 2, 0xFF, END_OF_IMAGE, 3, 4];
        file.extend([0xFF, 0xC0, 0, 8, 8, 0, 200, 1, 44, 3]);
        file.extend([0xFF, START_OF_SCAN, 0, 2, 1, 2, 0xFF, 0, 3, 0xFF, 0xD0, 4]);
        let markers = Markers::of(&file);
        assert_eq!((markers.size, markers.components, markers.complete), (Some((300, 200)), 3, false));
        file.extend([0xFF, END_OF_IMAGE]);
        assert!(Markers::of(&file).complete);
        for length in 0..file.len() {
            assert!(!Markers::of(&file[..length]).complete, "{length}");
        }
    }
}
