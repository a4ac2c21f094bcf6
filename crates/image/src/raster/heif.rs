//! Photos in ISO base media files: HEIC and AVIF. Their kind and their EXIF record are read here. With the feature `heic`, HEIC is
//! decoded by `heic-decoder`. No decoder of AVIF is in this crate.
//!
//! Orientation, mirroring and crop are properties of the container. The orientation of the EXIF record repeats them, and is ignored.
//! Sources: ISO/IEC 14496-12, ISO/IEC 23008-12 (HEIF), ITU-T H.273 (colour codes).

use super::exif::{self, Exif};
use super::limits::Limits;
use super::samples::Pixels;
use crate::error::{Error, Result};

/// Brands of HEIC files.
pub const HEIC: [&[u8; 4]; 8] = [b"heic", b"heix", b"heim", b"heis", b"hevc", b"hevx", b"mif1", b"msf1"];
/// Brands of AVIF files.
pub const AVIF: [&[u8; 4]; 2] = [b"avif", b"avis"];
/// Bytes of a file that are searched for brands.
const MOST_BRANDS: usize = 256;
/// Maximum size of an EXIF record, in bytes.
const MOST_EXIF: usize = 1 << 20;

/// Returns the name of the format by content: HEIC or AVIF.
#[must_use]
pub fn kind(bytes: &[u8]) -> Option<&'static str> {
    let length = bytes.first_chunk().map_or(0, |&length| u32::from_be_bytes(length) as usize);
    if bytes.get(4..8) != Some(b"ftyp") {
        return None;
    }
    let listed = bytes.get(16..length.min(bytes.len()).min(MOST_BRANDS)).unwrap_or_default();
    let brands = || bytes.get(8..12).into_iter().chain(listed.chunks_exact(4));
    let any = |wanted: &[&[u8; 4]]| brands().any(|brand| wanted.iter().any(|&wanted| wanted == brand));
    if any(&AVIF) {
        return Some("AVIF");
    }
    any(&HEIC).then_some("HEIC")
}

/// Returns the capture time of a HEIC or AVIF file as in [`super::decode::Decoded::taken`].
#[must_use]
pub fn taken(bytes: &[u8]) -> Option<String> {
    exif::read(&record(bytes)?).taken
}

/// Returns width and height of the upright picture, from the properties of the primary item. The beginning of the file is
/// enough. Returns `None` for files of other kinds, and if the properties are beyond the given bytes.
pub(super) fn size(bytes: &[u8]) -> Option<(u32, u32)> {
    kind(bytes)?;
    let meta = find(bytes, *b"meta")?.get(4..)?;
    let properties = find(meta, *b"iprp")?;
    let listed: Vec<_> = boxes(find(properties, *b"ipco")?).collect();
    let number = |value: Option<u64>| u32::try_from(value?).ok();
    let mut size = None;
    for index in associated(find(properties, *b"ipma")?, primary_item(meta)?)? {
        let Some(&(kind, content)) = index.checked_sub(1).and_then(|index| listed.get(index)) else {
            continue;
        };
        let mut numbers = Numbers(content);
        match &kind {
            b"ispe" => {
                numbers.next(4)?;
                size = Some((number(numbers.next(4))?, number(numbers.next(4))?));
            }
            b"clap" => {
                let mut side = || number(numbers.next(4)?.checked_div(numbers.next(4)?));
                size = Some((side()?, side()?));
            }
            // An odd number of quarter turns.
            b"irot" if numbers.next(1)? & 1 == 1 => size = size.map(|(width, height)| (height, width)),
            _ => {}
        }
    }
    size
}

/// Number of the item that viewers show.
fn primary_item(meta: &[u8]) -> Option<u64> {
    let mut numbers = Numbers(find(meta, *b"pitm")?);
    let version = numbers.next(1)?;
    numbers.next(3)?;
    numbers.next(if version == 0 { 2 } else { 4 })
}

/// Numbers from 1 of the properties of an item, in the order in which they apply.
fn associated(associations: &[u8], wanted: u64) -> Option<Vec<usize>> {
    let mut numbers = Numbers(associations);
    let version = numbers.next(1)?;
    // Two-byte numbers; the highest bit marks essential properties.
    let wide = numbers.next(3)? & 1 == 1;
    for _ in 0..numbers.next(4)? {
        let item = numbers.next(if version == 0 { 2 } else { 4 })?;
        let count = numbers.next(1)?;
        let properties: Option<Vec<_>> = (0..count).map(|_| numbers.next(if wide { 2 } else { 1 })).collect();
        if item == wanted {
            let most = if wide { 0x7fff } else { 0x7f };
            return Some(properties?.into_iter().map(|index| (index & most) as usize).collect());
        }
    }
    None
}

/// Decodes a file of the given kind, upright.
///
/// # Errors
/// `unsupported` without a decoder for it, `damaged`, `too-large`.
pub(super) fn read(kind: &'static str, bytes: &[u8], limits: &Limits) -> Result<(Pixels, Exif)> {
    let unsupported = |reason: &str| Error::Unsupported { format: kind, reason: reason.to_owned() };
    if kind == "AVIF" {
        return Err(unsupported("save it as JPEG or PNG, or open it in the app"));
    }
    #[cfg(not(feature = "heic"))]
    {
        let _ = (bytes, limits);
        Err(unsupported("this build has no decoder for it; save it as JPEG"))
    }
    #[cfg(feature = "heic")]
    {
        let exif = Exif { taken: taken(bytes), ..Exif::default() };
        Ok((hevc::decode(bytes, limits)?, exif))
    }
}

/// The boxes of `bytes`: type and content. Ends at a box that does not fit.
fn boxes(bytes: &[u8]) -> impl Iterator<Item = ([u8; 4], &[u8])> {
    let mut rest = bytes;
    std::iter::from_fn(move || {
        let (&length, after) = rest.split_first_chunk::<4>()?;
        let (&kind, mut content) = after.split_first_chunk::<4>()?;
        let mut head = 8;
        let length = match u32::from_be_bytes(length) {
            0 => rest.len(),
            1 => {
                let (&length, after) = content.split_first_chunk::<8>()?;
                (content, head) = (after, 16);
                usize::try_from(u64::from_be_bytes(length)).ok()?
            }
            length => length as usize,
        };
        let content = content.get(..length.checked_sub(head)?)?;
        rest = rest.get(length..)?;
        Some((kind, content))
    })
}

fn find(bytes: &[u8], kind: [u8; 4]) -> Option<&[u8]> {
    boxes(bytes).find(|(found, _)| *found == kind).map(|(_, content)| content)
}

/// Numbers of 0 to 8 bytes, one after the other.
struct Numbers<'b>(&'b [u8]);

impl Numbers<'_> {
    fn next(&mut self, bytes: usize) -> Option<u64> {
        let (number, rest) = self.0.split_at_checked(bytes)?;
        self.0 = rest;
        Some(number.iter().fold(0, |sum, &byte| (sum << 8) | u64::from(byte)))
    }
}

/// The EXIF record of a file, a TIFF file.
pub(super) fn record(bytes: &[u8]) -> Option<Vec<u8>> {
    // The version and the flags come first.
    let meta = find(bytes, *b"meta")?.get(4..)?;
    let item = exif_item(find(meta, *b"iinf")?)?;
    let data = item_data(bytes, meta, item)?;
    let (&skipped, after) = data.split_first_chunk::<4>()?;
    after.get(u32::from_be_bytes(skipped) as usize..).map(<[u8]>::to_vec)
}

/// Number of the EXIF item in a list of items.
fn exif_item(list: &[u8]) -> Option<u64> {
    let mut numbers = Numbers(list);
    let version = numbers.next(1)?;
    numbers.next(3)?;
    numbers.next(if version == 0 { 2 } else { 4 })?;
    boxes(numbers.0).filter(|(kind, _)| kind == b"infe").find_map(|(_, entry)| {
        let mut numbers = Numbers(entry);
        let version = numbers.next(1)?;
        numbers.next(3)?;
        let item = numbers.next(if version < 3 { 2 } else { 4 })?;
        numbers.next(2)?;
        (version >= 2 && numbers.0.starts_with(b"Exif")).then_some(item)
    })
}

/// The bytes of an item, which may be in several places.
fn item_data(file: &[u8], meta: &[u8], wanted: u64) -> Option<Vec<u8>> {
    let mut numbers = Numbers(find(meta, *b"iloc")?);
    let version = numbers.next(1)?;
    numbers.next(3)?;
    let (sizes, more) = (numbers.next(1)? as usize, numbers.next(1)? as usize);
    let (of_offset, of_length, of_base) = (sizes >> 4, sizes & 15, more >> 4);
    let of_index = if version == 0 { 0 } else { more & 15 };
    let of_item = if version < 2 { 2 } else { 4 };
    let count = numbers.next(of_item)?;
    for _ in 0..count {
        let item = numbers.next(of_item)?;
        let method = if version == 0 { 0 } else { numbers.next(2)? & 15 };
        numbers.next(2)?;
        let base = numbers.next(of_base)?;
        let extents = numbers.next(2)?;
        let from = match method {
            0 => Some(file),
            1 => find(meta, *b"idat"),
            _ => None,
        };
        let mut data = Vec::new();
        for _ in 0..extents {
            numbers.next(of_index)?;
            let start = usize::try_from(base.checked_add(numbers.next(of_offset)?)?).ok()?;
            let length = usize::try_from(numbers.next(of_length)?).ok()?;
            if item == wanted {
                data.extend_from_slice(from?.get(start..)?.get(..length)?);
                (data.len() <= MOST_EXIF).then_some(())?;
            }
        }
        if item == wanted {
            return Some(data);
        }
    }
    None
}

#[cfg(feature = "heic")]
mod hevc {
    use super::super::channels::Channels;
    use super::super::cicp;
    use super::super::limits::{Limits, check_memory};
    use super::super::samples::{Alpha, Pixels};
    use crate::error::{Error, Result};
    use heic_decoder::{ChromaSampling, ColorInfo, HeifError, decode as decode_heic, probe};

    /// Bytes per pixel during decoding: 32-bit planes, their copies for tiles, and RGB.
    const BYTES_PER_PIXEL: u64 = 16;

    pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<Pixels> {
        let info = probe(bytes).map_err(explained)?;
        let side = |side: usize| u32::try_from(side).unwrap_or(u32::MAX);
        for (width, height) in [(info.coded_width, info.coded_height), (info.width, info.height)] {
            limits.check(side(width), side(height), "HEIC")?;
            check_memory((width, height), BYTES_PER_PIXEL, limits)?;
        }
        let mut image = decode_heic(bytes).map_err(explained)?;
        centre_chroma(&mut image.chroma_sampling);
        let size = (image.width, image.height);
        let profile = image.metadata.icc_profile.take().or_else(|| image.color_info.and_then(profile_of));
        let (samples, channels, alpha) = if image.alpha.is_some() {
            let rgba = image.to_rgba8().map_err(explained)?;
            let alpha = if rgba.premultiplied { Alpha::Multiplied } else { Alpha::Straight };
            (rgba.data, Channels::Rgb, alpha)
        } else {
            (image.to_rgb8().map_err(explained)?.data, Channels::Rgb, Alpha::None)
        };
        drop(image);
        Ok(Pixels::flattened(size, samples, channels, alpha).with_profile(profile))
    }

    /// Moves the samples of colour to the middle of their pixels. Without a position in the file, the HEVC standard puts them
    /// at the left pixel. But libheif and encoders of still pictures use the mean of the pixels.
    fn centre_chroma(chroma: &mut ChromaSampling) {
        // A mirrored picture has the samples at the right pixel.
        let centred = |origin: f32| if origin >= 1.0 { origin - 0.5 } else { origin + 0.5 };
        for (count, origin) in [(chroma.sub_x, &mut chroma.origin_x), (chroma.sub_y, &mut chroma.origin_y)] {
            if count == 2 && origin.fract() == 0.0 {
                *origin = centred(*origin);
            }
        }
    }

    /// An ICC profile for the primaries and the transfer function of a file without one; `None` for sRGB.
    fn profile_of(color: ColorInfo) -> Option<Vec<u8>> {
        cicp::profile(color.color_primaries, color.transfer_characteristics)
    }

    fn explained(error: HeifError) -> Error {
        match error {
            HeifError::Unsupported(reason) => {
                Error::Unsupported { format: "HEIC", reason: format!("{reason}; save it as JPEG") }
            }
            error => Error::damaged("HEIC", error),
        }
    }
}
