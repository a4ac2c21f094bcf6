//! Reads the size of a photo, and the thumbnail that its camera stored, from the beginning of the file.
//!
//! The page uses both before photos are decoded. Sources: ITU-T T.81, annex B; PNG (third edition), 11.2.1; RFC 9649;
//! ISO/IEC 23008-12; CIPA DC-008 (Exif 2.32), 4.5.5.

use super::exif::{self, Exif, Tiff};
use super::{heif, jpeg, orient, png};

/// Directory entries of a thumbnail: its position in the record, and its length in bytes.
const THUMBNAIL: [u16; 2] = [0x0201, 0x0202];

/// The header of a photo.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Header<'a> {
    /// Width of the upright photo in pixels, at least 1.
    pub width: u32,
    /// Height of the upright photo in pixels, at least 1.
    pub height: u32,
    /// EXIF orientation of the stored pixels, 1 to 8; 1 if the file rotates them in another way.
    pub orientation: u8,
    /// A JPEG file, stored with the same orientation as the pixels.
    pub thumbnail: Option<&'a [u8]>,
}

impl<'a> Header<'a> {
    /// Reads the beginning of a JPEG, PNG, WebP, HEIC or AVIF file. Usually 128 kB are enough.
    ///
    /// Returns `None` for other files, and if the size is zero or beyond the given bytes. The orientation of a PNG or WebP
    /// file may be beyond them as well; then it is 1.
    #[must_use]
    pub fn read(bytes: &'a [u8]) -> Option<Self> {
        let (size, record) = match bytes.first_chunk()? {
            [0xff, 0xd8, 0xff, _] => {
                let markers = jpeg::Markers::of(bytes);
                (markers.size?, markers.exif)
            }
            b"\x89PNG" => (png_size(bytes)?, png::exif(bytes)),
            b"RIFF" => (webp_size(bytes)?, None),
            _ => (heif::size(bytes)?, None),
        };
        let Exif { orientation, .. } = record.map(exif::read).unwrap_or_default();
        let (width, height) = if orient::swaps_sides(orientation) { (size.1, size.0) } else { size };
        let header = Self { width, height, orientation, thumbnail: record.and_then(thumbnail) };
        (width > 0 && height > 0).then_some(header)
    }
}

/// The size in the first chunk.
fn png_size(bytes: &[u8]) -> Option<(u32, u32)> {
    let body = bytes.get(12..24)?.strip_prefix(b"IHDR")?;
    let ([width, height], []) = body.as_chunks::<4>() else { return None };
    Some((u32::from_be_bytes(*width), u32::from_be_bytes(*height)))
}

/// The size in the first chunk, which is lossy, lossless or extended.
fn webp_size(bytes: &[u8]) -> Option<(u32, u32)> {
    let (kind, body) = bytes.get(8..)?.strip_prefix(b"WEBP")?.split_first_chunk::<4>()?;
    let number = |at: usize| Some(u32::from_le_bytes(*body.get(at..)?.first_chunk()?));
    match kind {
        // A three-byte frame tag and a start code precede the sides.
        b"VP8 " => number(10).map(|sides| (sides & 0x3fff, sides >> 16 & 0x3fff)),
        b"VP8L" => number(5).map(|sides| (1 + (sides & 0x3fff), 1 + (sides >> 14 & 0x3fff))),
        // Three bytes each.
        b"VP8X" => Some((1 + (number(8)? & 0xff_ffff), 1 + (number(10)? >> 8))),
        _ => None,
    }
}

/// The thumbnail in the second directory of an EXIF record without its mark.
fn thumbnail(record: &[u8]) -> Option<&[u8]> {
    let tiff = Tiff::of(record)?;
    let second = tiff.next_directory(tiff.directory()?)?;
    let [start, length] = THUMBNAIL.map(|tag| tiff.find(second, tag).and_then(|field| tiff.u32(field + 8)));
    record.get(start? as usize..)?.get(..length? as usize).filter(|thumbnail| !thumbnail.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::decode::{Limits, decode};
    use proptest::prelude::*;
    use std::fs;
    use std::path::Path;

    /// The EXIF record of a camera: an orientation in the first directory, a thumbnail of five bytes in the second.
    fn record(little: bool, length: u32) -> Vec<u8> {
        let short = |value: u16| if little { value.to_le_bytes() } else { value.to_be_bytes() };
        let long = |value: u32| if little { value.to_le_bytes() } else { value.to_be_bytes() };
        let entry = |tag: u16, value: u32| [&short(tag)[..], &short(4), &long(1), &long(value)].concat();
        let orientation = [&short(0x0112)[..], &short(3), &long(1), &short(6), &short(0)].concat();
        let first = [&short(1)[..], &orientation, &long(26)].concat();
        let second =
            [&short(2)[..], &entry(THUMBNAIL[0], 56), &entry(THUMBNAIL[1], length), &long(0)].concat();
        let mark: &[u8] = if little { b"II*\0" } else { b"MM\0*" };
        [mark, &long(8), &first, &second, b"photo"].concat()
    }

    fn segment(marker: u8, body: &[u8]) -> Vec<u8> {
        [&[0xff, marker], &(body.len() as u16 + 2).to_be_bytes()[..], body].concat()
    }

    /// A JPEG file of 900 x 1600 pixels. A table with a similar marker precedes the frame.
    fn jpeg(record: &[u8]) -> Vec<u8> {
        let frame = segment(0xc0, &[&[8][..], &1600u16.to_be_bytes(), &900u16.to_be_bytes(), &[3]].concat());
        let exif = segment(0xe1, &[b"Exif\0\0", record].concat());
        [&[0xff, 0xd8][..], &segment(0xe0, b"JFIF"), &exif, &segment(0xc4, &[1, 2, 3, 4]), &frame].concat()
    }

    #[test]
    fn headers_have_the_size_of_the_decoded_photo() {
        let folder = Path::new("../../tests/oracles/data/files");
        let mut count = 0;
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let ending = path.extension().unwrap().to_str().unwrap();
            if !["jpg", "png"].contains(&ending) {
                continue;
            }
            let bytes = fs::read(&path).unwrap();
            let Ok(decoded) = decode(&bytes, &Limits::default()) else { continue };
            let header = Header::read(&bytes).unwrap();
            let size = (decoded.image.width() as u32, decoded.image.height() as u32);
            assert_eq!((header.width, header.height), size, "{}", path.display());
            count += 1;
        }
        assert!(count > 40, "{count}");
    }

    #[test]
    fn cameras_store_thumbnails_in_both_byte_orders() {
        for little in [true, false] {
            let file = jpeg(&record(little, 5));
            let header = Header::read(&file).unwrap();
            let expected = Header { width: 1600, height: 900, orientation: 6, thumbnail: Some(b"photo") };
            assert_eq!(header, expected);
            assert_eq!(Header::read(&jpeg(&record(little, 6))).unwrap().thumbnail, None, "beyond its record");
            assert_eq!(Header::read(&jpeg(&record(little, 0))).unwrap().thumbnail, None);
        }
    }

    #[test]
    fn webp_has_its_size_in_the_first_chunk() {
        let webp = |kind: &[u8; 4], at: usize, sides: &[u8]| {
            let mut file = [&b"RIFF....WEBP"[..], kind, &[0; 20]].concat();
            file[at..at + sides.len()].copy_from_slice(sides);
            Header::read(&file).map(|header| (header.width, header.height))
        };
        let size = Some((900, 1600));
        assert_eq!(webp(b"VP8 ", 26, &[132, 3, 64, 6]), size);
        assert_eq!(webp(b"VP8X", 24, &[131, 3, 0, 63, 6, 0]), size);
        assert_eq!(webp(b"VP8L", 21, &(899u32 + (1599 << 14)).to_le_bytes()), size);
        assert_eq!(webp(b"ANIM", 24, &[1]), None);
    }

    #[test]
    fn other_files_have_no_header() {
        for bytes in [
            &b""[..],
            b"GIF89a and more",
            b"RIFF....WEBPVP8 ",
            b"\x89PNG\r\n\x1a\n....IHDR1234",
            b"\xff\xd8\xff\xd9",
        ] {
            assert_eq!(Header::read(bytes), None);
        }
        // Both sides are zero.
        assert_eq!(Header::read(b"\x89PNG\r\n\x1a\n....IHDR\0\0\0\0\0\0\0\0"), None);
    }

    proptest! {
        #[test]
        fn any_bytes_are_read_without_panic(mut bytes in prop::collection::vec(any::<u8>(), 0..200), kind in 0..4) {
            let file = jpeg(&record(true, 5));
            let start: &[u8] = [&file[..], b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", b"RIFF....WEBPVP8X", b"\0\0\0\x14ftypheic"][kind as usize];
            bytes.splice(..0, start.iter().copied());
            let _ = Header::read(&bytes);
        }
    }
}
