//! PNG: pixels from the `png` crate, metadata chunks from this reader.
//!
//! If a file is damaged, the rows before the damage are decoded. That crate inflates a colour profile
//! completely, even if it is not used. Therefore it skips all metadata, and this module reads the required
//! chunks. Source: PNG, third edition, sections 5 and 11.

use std::io::Cursor;

use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;
use png::{
    BitDepth, ColorType, Decoder, DecodingError, InterlaceInfo, Reader, Transformations, splat_interlaced_row,
};

use super::channels::Channels;
use super::exif::{self, Exif};
use super::limits::{Damage, Limits, MOST_PROFILE, check_memory, out_of_memory};
use super::samples::{self, Alpha, Pixels};
use crate::error::{Error, Result};

/// Most bytes that the decoder may collect besides pixels: EXIF records are all that it cannot pass over.
const MOST_COLLECTED: usize = 8 << 20;

/// Reads a file; of an animation the picture that programs without animation show.
pub(super) fn read(file: &[u8], name: &'static str, limits: &Limits) -> Result<(Pixels, Exif)> {
    let mut decoder = decoder(file);
    let failed = |error| explained(error, name);
    let (width, height) = decoder.read_header_info().map_err(failed)?.size();
    limits.check(width, height, name)?;
    let size = (width as usize, height as usize);
    let mut reader = decoder.read_info().map_err(failed)?;
    let mut samples = Samples::new(&reader, size, limits)?;
    let damage = match reader.next_frame(&mut samples.bytes) {
        Err(DecodingError::IoError(_) | DecodingError::Format(_)) => {
            let rows = |decoder: Decoder<Cursor<&[u8]>>| {
                let mut reader = decoder.read_info().map_err(failed)?;
                let mut samples = Samples::grey(&reader, size, limits)?;
                let damage = samples.read(&mut reader);
                Ok((samples, damage))
            };
            let intact = rows(self::decoder(before_damage(file)))
                .and_then(|(samples, damage)| Ok((samples, damage.checked(name)?)));
            let (rescued, damage) = if let Ok(rescued) = intact {
                rescued
            } else {
                // A file of few chunks: their checksums do not locate the damage.
                let mut unchecked = self::decoder(file);
                unchecked.ignore_checksums(true);
                let (samples, Damage { missing, coarse }) = rows(unchecked)?;
                let damage = Damage { missing: missing.max(1.0 / f64::from(height)), coarse };
                (samples, damage.checked(name)?)
            };
            samples = rescued;
            damage
        }
        whole => whole.map(|_| None).map_err(failed)?,
    };
    let Samples { mut bytes, color, depth, .. } = samples;
    if depth == BitDepth::Sixteen {
        bytes = bytes.as_chunks().0.iter().map(|&two| samples::of_16_bits(u16::from_be_bytes(two))).collect();
    }
    let alpha = if color.samples() % 2 == 0 { Alpha::Straight } else { Alpha::None };
    let channels = if color.samples() < 3 { Channels::Grey } else { Channels::Rgb };
    let Records { profile, exif } = records(file);
    let pixels = Pixels::flattened(size, bytes, channels, alpha).with_profile(profile);
    Ok((Pixels { damage, ..pixels }, exif))
}

fn decoder(file: &[u8]) -> Decoder<Cursor<&[u8]>> {
    let mut decoder = Decoder::new_with_limits(Cursor::new(file), png::Limits { bytes: MOST_COLLECTED });
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    decoder.set_transformations(Transformations::EXPAND);
    decoder
}

/// Samples of a picture in rows, without padding. Samples of 16 bits are big-endian.
///
/// Two decoders of one damaged file can have different types: a transparency chunk with a wrong checksum is
/// skipped unless checksums are ignored.
struct Samples {
    bytes: Vec<u8>,
    color: ColorType,
    depth: BitDepth,
    height: usize,
}

impl Samples {
    /// Black samples in the type of a reader.
    fn new(reader: &Reader<Cursor<&[u8]>>, size: (usize, usize), limits: &Limits) -> Result<Self> {
        let (color, depth) = reader.output_color_type();
        check_memory(size, (color.samples() * bytes_of(depth)) as u64, limits)?;
        let length = reader.output_buffer_size().ok_or_else(|| out_of_memory(size, limits))?;
        Ok(Self { bytes: vec![0; length], color, depth, height: size.1 })
    }

    /// Grey and opaque samples in the type of a reader.
    fn grey(reader: &Reader<Cursor<&[u8]>>, size: (usize, usize), limits: &Limits) -> Result<Self> {
        let mut grey = Self::new(reader, size, limits)?;
        grey.bytes.fill(128);
        if matches!(grey.color, ColorType::GrayscaleAlpha | ColorType::Rgba) {
            let bytes = bytes_of(grey.depth);
            for pixel in grey.bytes.chunks_mut(grey.color.samples() * bytes) {
                let alpha = pixel.len() - bytes;
                pixel[alpha..].fill(255);
            }
        }
        Ok(grey)
    }

    /// Reads the rows up to the first damage.
    fn read(&mut self, reader: &mut Reader<Cursor<&[u8]>>) -> Damage {
        let stride = self.bytes.len() / self.height;
        let bits = 8 * (self.color.samples() * bytes_of(self.depth)) as u8;
        let (mut read, mut covered) = (0, 0);
        while let Ok(Some(row)) = reader.next_interlaced_row() {
            read += row.data().len();
            match row.interlace() {
                InterlaceInfo::Null(_) => {
                    self.bytes[covered * stride..][..stride].copy_from_slice(row.data());
                    covered += 1;
                }
                InterlaceInfo::Adam7(pass) => {
                    splat_interlaced_row(&mut self.bytes, stride, row.data(), pass, bits);
                    // A row of the first pass covers eight rows.
                    covered = (covered + 8).min(self.height);
                }
            }
        }
        let [covered, read] = [covered as f64 / self.height as f64, read as f64 / self.bytes.len() as f64];
        Damage { missing: 1.0 - covered, coarse: covered - read }
    }
}

/// Bytes of a sample.
fn bytes_of(depth: BitDepth) -> usize {
    if depth == BitDepth::Sixteen { 2 } else { 1 }
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
