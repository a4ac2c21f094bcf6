//! Reads where a photo was taken, from the GPS fields of its EXIF record (CIPA DC-008, Exif 2.32, section 4.6.6).
//!
//! Decoding never reads these fields. A caller reads them to name a place, and stores only the name.

use super::exif::Tiff;
use super::{exif, heif, jpeg, png};

/// Directory of the GPS fields, and its fields: the reference (north or south, east or west) and the angle.
const GPS_DIRECTORY: u16 = 0x8825;
const LATITUDE: [u16; 2] = [1, 2];
const LONGITUDE: [u16; 2] = [3, 4];

/// A point on earth, in degrees of WGS 84.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Location {
    /// -90 (south) to 90 (north).
    pub latitude: f64,
    /// -180 (west) to 180 (east).
    pub longitude: f64,
}

/// Returns where a photo was taken. `None` without valid GPS fields, and for files other than JPEG, PNG, HEIC and AVIF;
/// with the feature `rare`, also WebP and TIFF. The beginning of a JPEG or PNG file is enough.
#[must_use]
pub fn location(file: &[u8]) -> Option<Location> {
    if heif::kind(file).is_some() {
        return of_record(&heif::record(file)?);
    }
    match file.first_chunk()? {
        [0xff, 0xd8, 0xff, _] => of_record(jpeg::exif(file)?),
        b"\x89PNG" => of_record(png::exif(file)?),
        #[cfg(feature = "rare")]
        b"RIFF" => of_record(super::decode::exif_of_webp(file)?),
        #[cfg(feature = "rare")]
        b"II*\0" | b"MM\0*" => of_record(file),
        _ => None,
    }
}

fn of_record(record: &[u8]) -> Option<Location> {
    let tiff = Tiff::of(exif::without_mark(record))?;
    let pointer = tiff.find(tiff.directory()?, GPS_DIRECTORY)?;
    let directory = tiff.u32(pointer + 8)?;
    let degrees = |[reference, angle]: [u16; 2], negative: u8, most: f64| {
        let degrees = tiff.angle(tiff.find(directory, angle)?)?;
        let sign = if tiff.byte(tiff.find(directory, reference)?)? == negative { -1.0 } else { 1.0 };
        (degrees <= most).then_some(sign * degrees)
    };
    let (latitude, longitude) = (degrees(LATITUDE, b'S', 90.0)?, degrees(LONGITUDE, b'W', 180.0)?);
    // A receiver without a fix writes zeros.
    (latitude != 0.0 || longitude != 0.0).then_some(Location { latitude, longitude })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A record with a latitude and a longitude, each as degrees, minutes and hundredths of seconds.
    fn record(little: bool, [latitude, longitude]: [(u8, [u32; 3]); 2]) -> Vec<u8> {
        let u16 = |v: u16| if little { v.to_le_bytes() } else { v.to_be_bytes() };
        let u32 = |v: u32| if little { v.to_le_bytes() } else { v.to_be_bytes() };
        let mut out = if little { b"II*\0".to_vec() } else { b"MM\0*".to_vec() };
        let field = |tag: u16, kind: u16, count: u32, value: [u8; 4]| {
            [&u16(tag)[..], &u16(kind), &u32(count), &value].concat()
        };
        out.extend(u32(8));
        out.extend(u16(1));
        out.extend(field(GPS_DIRECTORY, 4, 1, u32(26)));
        out.extend([0; 4]);
        out.extend(u16(4));
        for (at, (tags, (reference, _))) in
            [(LATITUDE, latitude), (LONGITUDE, longitude)].into_iter().enumerate()
        {
            out.extend(field(tags[0], 2, 2, [reference, 0, 0, 0]));
            out.extend(field(tags[1], 5, 3, u32(80 + 24 * at as u32)));
        }
        out.extend([0; 4]);
        for (_, angle) in [latitude, longitude] {
            for (part, divisor) in angle.into_iter().zip([1, 1, 100]) {
                out.extend([u32(part), u32(divisor)].concat());
            }
        }
        out
    }

    /// A JPEG file that ends after its EXIF record.
    fn jpeg(record: &[u8]) -> Vec<u8> {
        let length = (record.len() as u16 + 8).to_be_bytes();
        [&[0xff, 0xd8, 0xff, 0xe1], &length[..], b"Exif\0\0", record].concat()
    }

    const SINTRA: [(u8, [u32; 3]); 2] = [(b'N', [38, 47, 1600]), (b'W', [9, 23, 2600])];

    #[test]
    fn the_location_is_read_in_both_byte_orders() {
        for little in [false, true] {
            let record = record(little, SINTRA);
            let found = location(&jpeg(&record)).unwrap();
            assert!((found.latitude - (38.0 + 47.0 / 60.0 + 16.0 / 3600.0)).abs() < 1e-9, "{found:?}");
            assert!((found.longitude + (9.0 + 23.0 / 60.0 + 26.0 / 3600.0)).abs() < 1e-9, "{found:?}");
            let chunk =
                [&(record.len() as u32).to_be_bytes()[..], b"eXIf", record.as_slice(), &[0; 4]].concat();
            assert_eq!(location(&[b"\x89PNG\r\n\x1a\n", chunk.as_slice()].concat()), Some(found));
        }
    }

    #[test]
    fn no_fix_and_wrong_angles_are_no_location() {
        let of = |fields| location(&jpeg(&record(true, fields)));
        assert_eq!(of([(b'N', [0, 0, 0]), (b'E', [0, 0, 0])]), None);
        assert_eq!(of([(b'N', [91, 0, 0]), (b'E', [9, 0, 0])]), None);
        assert!(of([(b'S', [33, 0, 0]), (b'E', [151, 0, 0])]).is_some_and(|found| found.latitude < 0.0));
        assert_eq!(location(b""), None);
        assert_eq!(
            location(include_bytes!("../../../../tests/oracles/data/files/jpeg-icc-exif-6.jpg")),
            None
        );
    }

    proptest! {
        #[test]
        fn damaged_records_never_panic(at in 0usize..140, value: u8, length in 0usize..140) {
            let mut bytes = jpeg(&record(at % 2 == 0, SINTRA));
            bytes[at] = value;
            if let Some(found) = location(&bytes[..length.min(bytes.len())]) {
                prop_assert!(found.latitude.abs() <= 90.0 && found.longitude.abs() <= 180.0);
            }
        }
    }
}
