//! TIFF: reads samples with the `tiff` crate, and combines and interprets them here.
//!
//! The crate (0.11.3) only reads chunks (strips or tiles) of raw samples, which works well. The crate and
//! `image` handle these cases wrongly or not at all:
//!
//! - A tiled image with separate planes causes a panic if the tiles do not divide the height: `get_padding`
//!   uses the tile number over all planes as one of the first plane. Each chunk is correct, but longer than
//!   the image. The rows below the image are removed here.
//! - Samples beyond the photometric interpretation (associated alpha, unknown ones) are dropped before the
//!   predictor is undone. Palettes are rejected, and grey with alpha has bands without a meaning. The
//!   workaround declares every image as grey: the crate then returns all samples of a pixel, and this module
//!   interprets them.
//! - `FillOrder` is passed over.
//! - A missing end of strips, `RowsPerStrip` of 2^32 - 1, does not fit its sizes in wasm.
//! - JPEG chunks are decoded at whatever size they announce, lists of places and counts are read at any length.
//!
//! Source: TIFF 6.0; TIFF technical notes 1 and 2 (JPEG in TIFF).

use std::io::{Cursor, Read, Result as IoResult, Seek, SeekFrom};

use tiff::TiffError;
use tiff::decoder::{ChunkType, Decoder, DecodingResult};
use tiff::tags::Tag;

use super::channels::Channels;
use super::exif::{ICC_PROFILE, Tiff};
use super::jpeg::Markers;
use super::limits::{Limits, check_memory, out_of_memory};
use super::samples::{Alpha, Pixels, of_16_bits, of_float, rgb_of_ycc};
use crate::error::{Error, Result};

const PHOTOMETRIC: u16 = 262;
const ROWS_PER_STRIP: u16 = 278;
const HEIGHT: u16 = 257;
const FILL_ORDER: u16 = 266;
/// All tags whose values the crate turns into lists of 32 bytes a value.
const LISTS: [u16; 20] =
    [256, 257, 258, 259, 262, 273, 277, 278, 279, 284, 317, 320, 322, 323, 324, 325, 338, 339, 347, 530];
/// Most values of such a list: tiles of 16 pixels in four planes of the largest image are fewer.
const MOST_VALUES: u32 = 1 << 21;
/// Most samples of a pixel, and of colours and alpha among them.
const MOST_SAMPLES: usize = 16;
/// `Compression` of JPEG as technical note 2 has it.
const JPEG: u16 = 7;

/// Reads the first image of a file.
pub(super) fn read(file: &[u8], name: &'static str, limits: &Limits) -> Result<Pixels> {
    let failed = |error| explained(error, name);
    let header = Header::read(file, name)?;
    let mut decoder = Decoder::new(header.source(file)).map_err(failed)?;
    let layout = Layout::read(&mut decoder, header.photometric, name, limits)?;
    let (width, height) = layout.size;
    let pixels = width * height;
    check_memory(layout.size, layout.used as u64, limits)?;
    let mut allowance = tiff::decoder::Limits::default();
    allowance.decoding_buffer_size = limits.max_bytes as usize - pixels * layout.used;
    allowance.intermediate_buffer_size = allowance.decoding_buffer_size;
    if layout.compression == JPEG {
        check_jpegs(file, &mut decoder, name)?;
    }
    let mut decoder = decoder.with_limits(allowance);
    // JPEG data always has the normal bit order, as in libtiff.
    decoder.inner().turned = header.fill_order == 2 && layout.compression != JPEG;
    let mut samples = vec![0; pixels * layout.used];
    let mut row = Vec::new();
    for place in layout.chunks() {
        let chunk = decoder.read_chunk(place.number).map_err(|error| match error {
            TiffError::LimitsExceeded => out_of_memory(layout.size, limits),
            error => explained(error, name),
        })?;
        layout.lay(&chunk, &place, &mut row, &mut samples, name)?;
    }
    decoder.inner().turned = false;
    layout.finished(samples, &mut decoder, name)
}

/// Fields that are checked before the crate reads the file.
struct Header {
    photometric: u32,
    fill_order: u32,
    /// Fields as the crate is to see them, and where they stand.
    fields: Vec<(u64, [u8; 12])>,
}

impl Header {
    fn read(file: &[u8], name: &'static str) -> Result<Self> {
        let none = || Error::damaged(name, "it has no directory of fields");
        let tiff = Tiff::of(file).ok_or_else(none)?;
        let directory = tiff.directory().ok_or_else(none)?;
        let number = |tag| tiff.find(directory, tag).and_then(|field| tiff.number(field));
        let photometric = number(PHOTOMETRIC)
            .ok_or_else(|| Error::damaged(name, "it does not define the meaning of its samples"))?;
        let rows = number(HEIGHT).zip(number(ROWS_PER_STRIP)).map(|(height, rows)| rows.min(height));
        let mut fields = Vec::new();
        for field in tiff.fields(directory) {
            let tag = tiff.u16(field).unwrap_or(0);
            if LISTS.contains(&tag) && tiff.u32(field + 4).is_none_or(|count| count > MOST_VALUES) {
                return Err(Error::damaged(
                    name,
                    format!("field {tag} has more values than an image has parts"),
                ));
            }
            if tag == ICC_PROFILE && tiff.bytes(field).is_none() {
                // The pixels may exist, but their format is unknown.
                return Err(Error::damaged(name, "it is truncated"));
            }
            let new = match tag {
                // 1: grey, black is 0.
                PHOTOMETRIC => Some(1),
                ROWS_PER_STRIP => rows,
                _ => None,
            };
            if let Some(value) = new {
                fields.push((field.into(), tiff.field(tag, value)));
            }
        }
        let fill_order = number(FILL_ORDER).unwrap_or(1);
        Ok(Self { photometric, fill_order, fields })
    }

    fn source<'a>(&'a self, file: &'a [u8]) -> Patched<'a> {
        Patched { file: Cursor::new(file), fields: &self.fields, turned: false }
    }
}

/// A file with some fields replaced.
struct Patched<'a> {
    file: Cursor<&'a [u8]>,
    fields: &'a [(u64, [u8; 12])],
    /// Whether bytes have their lowest bit first, which the crate does not know.
    turned: bool,
}

impl Read for Patched<'_> {
    fn read(&mut self, out: &mut [u8]) -> IoResult<usize> {
        let start = self.file.position();
        let count = self.file.read(out)?;
        let end = start + count as u64;
        for (at, field) in self.fields {
            for place in start.max(*at)..end.min(at + field.len() as u64) {
                out[(place - start) as usize] = field[(place - at) as usize];
            }
        }
        if self.turned {
            out[..count].iter_mut().for_each(|byte| *byte = byte.reverse_bits());
        }
        Ok(count)
    }
}

impl Seek for Patched<'_> {
    fn seek(&mut self, to: SeekFrom) -> IoResult<u64> {
        self.file.seek(to)
    }
}

/// Colour model of a pixel.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Colors {
    Grey { white_is_zero: bool },
    Rgb,
    Palette,
    Cmyk,
    YCbCr,
}

/// Positions and meanings of the samples.
struct Layout {
    size: (usize, usize),
    chunk: (usize, usize),
    /// Samples a pixel.
    samples: usize,
    bits: u16,
    planar: bool,
    compression: u16,
    colors: Colors,
    alpha: Alpha,
    /// Number of used samples per pixel: colours, then alpha.
    used: usize,
}

/// A chunk of an image: of all samples, or of one where they lie in planes.
struct Place {
    number: u32,
    plane: usize,
    left: usize,
    top: usize,
}

impl Layout {
    fn read(
        decoder: &mut Decoder<Patched>,
        photometric: u32,
        name: &'static str,
        limits: &Limits,
    ) -> Result<Self> {
        let failed = |error| explained(error, name);
        let unsupported = |reason: &str| Error::Unsupported { format: name, reason: reason.to_owned() };
        let (width, height) = decoder.dimensions().map_err(failed)?;
        limits.check(width, height, name)?;
        let mut list = |tag| decoder.find_tag_unsigned_vec::<u16>(tag).map_err(failed);
        let mut first =
            |tag, missing| Ok(list(tag)?.and_then(|list| list.first().copied()).unwrap_or(missing));
        let samples = usize::from(first(Tag::SamplesPerPixel, 1)?);
        let bits = first(Tag::BitsPerSample, 1)?;
        let planar = first(Tag::PlanarConfiguration, 1)? == 2;
        let compression = first(Tag::Compression, 1)?;
        let extra = list(Tag::ExtraSamples)?.unwrap_or_default();
        let subsampling = list(Tag::ChromaSubsampling)?;
        let colors = match photometric {
            0 | 1 => Colors::Grey { white_is_zero: photometric == 0 },
            2 => Colors::Rgb,
            3 if bits <= 8 => Colors::Palette,
            5 => Colors::Cmyk,
            // JPEG brings all samples to one size, other methods leave them at two.
            6 if !planar && (compression == JPEG || subsampling.as_deref() == Some(&[1, 1])) => Colors::YCbCr,
            6 => return Err(unsupported("its chroma is subsampled")),
            other => return Err(unsupported(&format!("its samples are of kind {other}"))),
        };
        let count = match colors {
            Colors::Grey { .. } | Colors::Palette => 1,
            Colors::Rgb | Colors::YCbCr => 3,
            Colors::Cmyk => 4,
        };
        if samples < count {
            return Err(Error::damaged(
                name,
                format!("it has {samples} samples per pixel instead of {count}"),
            ));
        }
        if samples > MOST_SAMPLES {
            return Err(unsupported(&format!("it has {samples} samples per pixel")));
        }
        let alpha = match extra.first() {
            _ if samples == count || colors == Colors::Palette => Alpha::None,
            Some(1) => Alpha::Multiplied,
            Some(2) => Alpha::Straight,
            // For programs that omit the field.
            None if (colors, samples) == (Colors::Rgb, 4) => Alpha::Straight,
            _ => Alpha::None,
        };
        let (chunk_width, chunk_height) = match decoder.get_chunk_type() {
            ChunkType::Strip => (width, decoder.chunk_dimensions().1),
            ChunkType::Tile => decoder.chunk_dimensions(),
        };
        if chunk_width.max(chunk_height) > limits.max_side {
            return Err(Error::damaged(
                name,
                format!("it has tiles of {chunk_width} x {chunk_height} pixels"),
            ));
        }
        Ok(Self {
            size: (width as usize, height as usize),
            chunk: (chunk_width as usize, chunk_height as usize),
            samples,
            bits,
            planar,
            compression,
            colors,
            alpha,
            used: count + usize::from(alpha != Alpha::None),
        })
    }

    /// The chunks with used samples.
    fn chunks(&self) -> impl Iterator<Item = Place> {
        let (across, down) = (self.size.0.div_ceil(self.chunk.0), self.size.1.div_ceil(self.chunk.1));
        let planes = if self.planar { self.used } else { 1 };
        (0..planes * across * down).map(move |number| {
            let (plane, in_plane) = (number / (across * down), number % (across * down));
            let (left, top) = (in_plane % across * self.chunk.0, in_plane / across * self.chunk.1);
            Place { number: number as u32, plane, left, top }
        })
    }

    /// Puts the samples of a chunk where they belong. A chunk may reach beyond the lower edge of the image.
    fn lay(
        &self,
        chunk: &DecodingResult,
        place: &Place,
        row: &mut Vec<u8>,
        out: &mut [u8],
        name: &'static str,
    ) -> Result<()> {
        let columns = self.chunk.0.min(self.size.0 - place.left);
        let rows = self.chunk.1.min(self.size.1 - place.top);
        let samples = if self.planar { 1 } else { self.samples };
        let kept = if self.planar { 1 } else { self.used };
        for y in 0..rows {
            self.narrow_row(chunk, y, columns * samples, row, name)?;
            let start = ((place.top + y) * self.size.0 + place.left) * self.used + place.plane;
            if kept == self.used && kept == samples {
                out[start..start + row.len()].copy_from_slice(row);
                continue;
            }
            let pixels = out[start..].chunks_mut(self.used);
            for (pixel, values) in pixels.zip(row.chunks_exact(samples)) {
                pixel[..kept].copy_from_slice(&values[..kept]);
            }
        }
        Ok(())
    }

    /// A row of a chunk in eight bits; entries of a palette stay what they are.
    fn narrow_row(
        &self,
        chunk: &DecodingResult,
        y: usize,
        count: usize,
        row: &mut Vec<u8>,
        name: &'static str,
    ) -> Result<()> {
        fn part<T>(all: &[T], y: usize, count: usize) -> impl Iterator<Item = &T> {
            all.chunks_exact(count).nth(y).into_iter().flatten()
        }
        row.clear();
        match chunk {
            DecodingResult::U8(all) if self.bits == 8 => row.extend(part(all, y, count)),
            DecodingResult::U8(all) => {
                let bits = usize::from(self.bits);
                let bytes = all.chunks_exact((count * bits).div_ceil(8)).nth(y).unwrap_or_default();
                let values = (0..count).map_while(|i| packed(bytes, i * bits, bits));
                let most = (1 << bits) - 1;
                let is_entry = self.colors == Colors::Palette;
                row.extend(values.map(|value| {
                    if is_entry { value as u8 } else { ((value * 255 + most / 2) / most) as u8 }
                }));
            }
            DecodingResult::U16(all) => row.extend(part(all, y, count).map(|&value| of_16_bits(value))),
            DecodingResult::F16(all) => row.extend(part(all, y, count).map(|value| of_float(value.to_f32()))),
            DecodingResult::F32(all) => row.extend(part(all, y, count).map(|&value| of_float(value))),
            DecodingResult::F64(all) => row.extend(part(all, y, count).map(|&value| of_float(value as f32))),
            _ => {
                let reason = format!("its samples are whole numbers of {} bits", self.bits);
                return Err(Error::Unsupported { format: name, reason });
            }
        }
        if row.len() == count { Ok(()) } else { Err(Error::damaged(name, "a part of it is too short")) }
    }

    /// The samples as grey, RGB or inks, on white paper.
    fn finished(
        &self,
        mut samples: Vec<u8>,
        decoder: &mut Decoder<Patched>,
        name: &'static str,
    ) -> Result<Pixels> {
        match self.colors {
            Colors::Grey { white_is_zero: true } => {
                samples.chunks_exact_mut(self.used).for_each(|pixel| pixel[0] = 255 - pixel[0]);
            }
            Colors::Grey { .. } | Colors::Rgb | Colors::Cmyk => {}
            Colors::Palette => {
                let map = decoder.find_tag_unsigned_vec::<u16>(Tag::ColorMap);
                let map = map.map_err(|error| explained(error, name))?.unwrap_or_default();
                samples =
                    painted(&samples, &map).ok_or_else(|| Error::damaged(name, "its palette is missing"))?;
            }
            Colors::YCbCr => {
                for pixel in samples.chunks_exact_mut(self.used) {
                    let rgb = rgb_of_ycc([pixel[0], pixel[1], pixel[2]]);
                    pixel[..3].copy_from_slice(&rgb);
                }
            }
        }
        let channels = match self.colors {
            Colors::Grey { .. } => Channels::Grey,
            Colors::Rgb | Colors::Palette | Colors::YCbCr => Channels::Rgb,
            Colors::Cmyk => Channels::Cmyk,
        };
        Ok(Pixels::flattened(self.size, samples, channels, self.alpha))
    }
}

/// The number of `bits` bits that begins at a bit of a row, the highest bit first.
fn packed(bytes: &[u8], at: usize, bits: usize) -> Option<u32> {
    let two = u32::from(*bytes.get(at / 8)?) << 8 | u32::from(*bytes.get(at / 8 + 1).unwrap_or(&0));
    Some(two >> (16 - at % 8 - bits) & ((1 << bits) - 1))
}

/// The colours of a palette: all reds, all greens, all blues, of 16 bits; of eight where a writer got that wrong.
fn painted(entries: &[u8], map: &[u16]) -> Option<Vec<u8>> {
    let count = map.len() / 3;
    let narrow = map.iter().all(|&value| value < 256);
    let value = |channel: usize, entry: u8| {
        let value = *map.get(channel * count + usize::from(entry))?;
        Some(if narrow { value as u8 } else { of_16_bits(value) })
    };
    let last = count.checked_sub(1)?.min(255) as u8;
    let mut rgb = Vec::with_capacity(3 * entries.len());
    for entry in entries {
        let entry = (*entry).min(last);
        rgb.extend([value(0, entry)?, value(1, entry)?, value(2, entry)?]);
    }
    Some(rgb)
}

/// Checks JPEG chunks. They are separate images, which the crate decodes at their announced size. They must
/// not be larger than a chunk, and their total must not exceed the limits of the file.
fn check_jpegs(file: &[u8], decoder: &mut Decoder<Patched>, name: &'static str) -> Result<()> {
    let failed = |error| explained(error, name);
    let [offsets, counts] = match decoder.get_chunk_type() {
        ChunkType::Strip => [Tag::StripOffsets, Tag::StripByteCounts],
        ChunkType::Tile => [Tag::TileOffsets, Tag::TileByteCounts],
    };
    let mut list = |tag| decoder.find_tag_unsigned_vec::<u64>(tag).map_err(failed);
    let (offsets, counts) = (list(offsets)?.unwrap_or_default(), list(counts)?.unwrap_or_default());
    let tables = list(Tag::JPEGTables)?.unwrap_or_default();
    let tables: Vec<u8> = tables.into_iter().map(|value| value as u8).collect();
    let total = counts.iter().fold(0u64, |sum, &count| sum.saturating_add(count));
    if Markers::of(&tables).size.is_some() || total > 4 * file.len() as u64 {
        return Err(Error::damaged(name, "its parts are not JPEG images"));
    }
    let (width, height) = decoder.chunk_dimensions();
    for (offset, count) in offsets.into_iter().zip(counts) {
        let [offset, count] = [offset, count].map(|value| usize::try_from(value).unwrap_or(usize::MAX));
        let part = file.get(offset..).unwrap_or_default();
        let part = &part[..part.len().min(count)];
        let fits = |(w, h): (u32, u32)| w <= width.next_multiple_of(16) && h <= height.next_multiple_of(16);
        if !Markers::of(part).size.is_some_and(fits) {
            return Err(Error::damaged(name, "a part of it has a different size than the image"));
        }
    }
    Ok(())
}

fn explained(error: TiffError, format: &'static str) -> Error {
    match error {
        TiffError::UnsupportedError(reason) => Error::Unsupported { format, reason: reason.to_string() },
        error => Error::damaged(format, error),
    }
}
