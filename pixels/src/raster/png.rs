//! PNG: pixels from the `png` crate, metadata chunks from this reader.
//!
//! If a file is damaged, the rows before the damage are decoded. That crate inflates a colour profile
//! completely, even if it is not used. Therefore it skips all metadata, and this module reads the required
//! chunks. Source: PNG, third edition, sections 5 and 11.

use std::io::Cursor;

use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;
use png::{
    BitDepth, ColorType, Decoder, DecodingError, InterlaceInfo, Transformations, splat_interlaced_row,
};

use super::decode::{Damage, Limits, MOST_PROFILE, check_memory, out_of_memory};
use super::exif::{self, Exif};
use super::samples::{self, Alpha, Channels, Pixels};
use crate::error::{Error, Result};

/// Most bytes that the decoder may collect besides pixels: EXIF records are all that it cannot pass over.
const MOST_COLLECTED: usize = 8 << 20;

/// Reads a file; of an animation the picture that programs without animation show.
pub(super) fn read(file: &[u8], name: &'static str, limits: &Limits) -> Result<(Pixels, Exif)> {
    let mut decoder = decoder(file);
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
    let damage = match reader.next_frame(&mut samples) {
        Err(DecodingError::IoError(_) | DecodingError::Format(_)) => {
            let mut rows = |decoder: Decoder<Cursor<&[u8]>>| {
                grey(&mut samples, color, bytes);
                read_rows(decoder, &mut samples, size.1, color.samples() * bytes)
            };
            match rows(self::decoder(before_damage(file))) {
                Ok(damage) if damage.checked(name).is_ok() => damage.checked(name)?,
                // A file of few chunks: their checksums do not locate the damage.
                _ => {
                    let mut unchecked = self::decoder(file);
                    unchecked.ignore_checksums(true);
                    let Damage { missing, coarse } = rows(unchecked).map_err(failed)?;
                    Damage { missing: missing.max(1.0 / f64::from(height)), coarse }.checked(name)?
                }
            }
        }
        whole => whole.map(|_| None).map_err(failed)?,
    };
    if depth == BitDepth::Sixteen {
        samples =
            samples.as_chunks().0.iter().map(|&two| samples::of_16_bits(u16::from_be_bytes(two))).collect();
    }
    let alpha = if color.samples() % 2 == 0 { Alpha::Straight } else { Alpha::None };
    let channels = if color.samples() < 3 { Channels::Grey } else { Channels::Rgb };
    let Records { profile, exif } = records(file);
    let pixels = Pixels::flattened(size, samples, channels, alpha).with_profile(profile);
    Ok((Pixels { damage, ..pixels }, exif))
}

fn decoder(file: &[u8]) -> Decoder<Cursor<&[u8]>> {
    let mut decoder = Decoder::new_with_limits(Cursor::new(file), png::Limits { bytes: MOST_COLLECTED });
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    decoder.set_transformations(Transformations::EXPAND);
    decoder
}

/// Makes all pixels grey and opaque.
fn grey(samples: &mut [u8], color: ColorType, bytes: usize) {
    samples.fill(128);
    if matches!(color, ColorType::GrayscaleAlpha | ColorType::Rgba) {
        for pixel in samples.chunks_mut(color.samples() * bytes) {
            let alpha = pixel.len() - bytes;
            pixel[alpha..].fill(255);
        }
    }
}

/// Decodes the rows of a file up to its first damage. It has `height` rows, and its pixels take `bytes` each.
fn read_rows(
    decoder: Decoder<Cursor<&[u8]>>,
    samples: &mut [u8],
    height: usize,
    bytes: usize,
) -> std::result::Result<Damage, DecodingError> {
    let mut reader = decoder.read_info()?;
    let stride = samples.len() / height;
    let (mut read, mut covered) = (0, 0);
    while let Ok(Some(row)) = reader.next_interlaced_row() {
        read += row.data().len();
        match row.interlace() {
            InterlaceInfo::Null(_) => {
                samples[covered * stride..][..stride].copy_from_slice(row.data());
                covered += 1;
            }
            InterlaceInfo::Adam7(pass) => {
                splat_interlaced_row(samples, stride, row.data(), pass, 8 * bytes as u8);
                // A row of the first pass covers eight rows.
                covered = (covered + 8).min(height);
            }
        }
    }
    let [covered, read] = [covered as f64 / height as f64, read as f64 / samples.len() as f64];
    Ok(Damage { missing: 1.0 - covered, coarse: covered - read })
}

/// A file up to its first chunk of pixels with a wrong checksum.
fn before_damage(file: &[u8]) -> &[u8] {
    let mut rest = file.get(8..).unwrap_or_default();
    while let Some((kind, body, after)) = chunk(rest) {
        let sum = &rest[8 + body.len()..][..4];
        if kind == b"IDAT" && sum != checksum(&rest[4..8 + body.len()]).to_be_bytes() {
            return &file[..file.len() - rest.len()];
        }
        rest = after;
    }
    file
}

/// The checksum of a chunk, CRC-32. It is computed for damaged files only.
fn checksum(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| if crc & 1 == 1 { crc >> 1 ^ 0xEDB8_8320 } else { crc >> 1 };
    !bytes.iter().fold(!0, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), step))
}

/// Metadata of a file.
#[derive(Default)]
struct Records {
    exif: Exif,
    profile: Option<Vec<u8>>,
}

/// The EXIF record of a file.
pub(super) fn exif(file: &[u8]) -> Option<&[u8]> {
    let mut rest = file.get(8..)?;
    while let Some((kind, body, after)) = chunk(rest) {
        if kind == b"eXIf" {
            return Some(body);
        }
        rest = after;
    }
    None
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

/// Returns the type and the data of the first chunk, and the rest.
fn chunk(bytes: &[u8]) -> Option<(&[u8; 4], &[u8], &[u8])> {
    let length = u32::from_be_bytes(*bytes.first_chunk()?) as usize;
    let (kind, rest) = bytes[4..].split_first_chunk()?;
    let (body, rest) = rest.split_at_checked(length)?;
    Some((kind, body, rest.get(4..)?))
}

/// The profile of an `iCCP` chunk: a name, a zero, the one method, the stream. `None` if it is too large.
fn inflated(body: &[u8]) -> Option<Vec<u8>> {
    let name = body.iter().take(80).position(|&byte| byte == 0)?;
    let stream = body[name + 1..].strip_prefix(&[0])?;
    decompress_to_vec_zlib_with_limit(stream, MOST_PROFILE).ok()
}

fn explained(error: DecodingError, format: &'static str) -> Error {
    match error {
        DecodingError::LimitsExceeded => Error::damaged(format, "its metadata exceeds the limit"),
        error => Error::damaged(format, error),
    }
}
