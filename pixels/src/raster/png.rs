//! PNG: the pixels as the `png` crate unpacks them, the records as they stand in the file.
//!
//! That crate inflates a colour profile whole before anyone asks for it, so it is told to pass over all that is not
//! pixels, and what matters is found here. Source: PNG, third edition, sections 5 and 11.

use std::io::Cursor;

use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;
use png::{BitDepth, Decoder, DecodingError, Transformations};

use super::decode::{Limits, MOST_PROFILE, check_memory, out_of_memory};
use super::exif::{self, Exif};
use super::samples::{self, Alpha, Channels, Pixels};
use crate::error::{Error, Result};

/// Most bytes that the decoder may collect besides pixels: EXIF records are all that it cannot pass over.
const MOST_COLLECTED: usize = 8 << 20;

/// Reads a file; of an animation the picture that programs without animation show.
pub(super) fn read(file: &[u8], name: &'static str, limits: &Limits) -> Result<(Pixels, Exif)> {
    let mut decoder = Decoder::new_with_limits(Cursor::new(file), png::Limits { bytes: MOST_COLLECTED });
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    decoder.set_transformations(Transformations::EXPAND);
    let failed = |error| explained(error, name);
    let (width, height) = decoder.read_header_info().map_err(failed)?.size();
    limits.check(width, height, name)?;
    let mut reader = decoder.read_info().map_err(failed)?;
    let (color, depth) = reader.output_color_type();
    let size = (width as usize, height as usize);
    let bytes = if depth == BitDepth::Sixteen { 2 } else { 1 };
    check_memory(size, (color.samples() * bytes) as u64, limits)?;
    let length = reader.output_buffer_size().ok_or_else(|| out_of_memory(size, limits))?;
    let mut samples = vec![0; length];
    reader.next_frame(&mut samples).map_err(failed)?;
    if depth == BitDepth::Sixteen {
        samples =
            samples.as_chunks().0.iter().map(|&two| samples::of_16_bits(u16::from_be_bytes(two))).collect();
    }
    let alpha = if color.samples() % 2 == 0 { Alpha::Straight } else { Alpha::None };
    let channels = if color.samples() < 3 { Channels::Grey } else { Channels::Rgb };
    let Records { profile, exif } = records(file);
    let pixels = Pixels::flattened(size, samples, channels, alpha).with_profile(profile);
    Ok((pixels, exif))
}

/// What a file says besides its pixels.
#[derive(Default)]
struct Records {
    exif: Exif,
    profile: Option<Vec<u8>>,
}

fn records(file: &[u8]) -> Records {
    let mut records = Records::default();
    let (mut profile, mut exif) = (None, None);
    let mut rest = file.get(8..).unwrap_or_default();
    while let Some((kind, body, after)) = chunk(rest) {
        match kind {
            b"iCCP" if profile.is_none() => profile = Some(body),
            b"eXIf" if exif.is_none() => exif = Some(body),
            _ => {}
        }
        rest = after;
    }
    records.profile = profile.and_then(inflated);
    records.exif = exif.map(exif::read).unwrap_or_default();
    records
}

/// The kind and the body of the first chunk, and what follows it.
fn chunk(bytes: &[u8]) -> Option<(&[u8; 4], &[u8], &[u8])> {
    let length = u32::from_be_bytes(*bytes.first_chunk()?) as usize;
    let (kind, rest) = bytes[4..].split_first_chunk()?;
    let (body, rest) = rest.split_at_checked(length)?;
    Some((kind, body, rest.get(4..)?))
}

/// The profile of an `iCCP` chunk: a name, a zero, the one method, the stream. One that is too large is none.
fn inflated(body: &[u8]) -> Option<Vec<u8>> {
    let name = body.iter().take(80).position(|&byte| byte == 0)?;
    let stream = body[name + 1..].strip_prefix(&[0])?;
    decompress_to_vec_zlib_with_limit(stream, MOST_PROFILE).ok()
}

fn explained(error: DecodingError, format: &'static str) -> Error {
    match error {
        DecodingError::LimitsExceeded => {
            Error::damaged(format, "it says more besides its pixels than any camera does")
        }
        error => Error::damaged(format, error),
    }
}
