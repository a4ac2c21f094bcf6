//! sRGB profile of exported files (JPEG, PDF): a matrix and a curve of 256 entries, one for each 8-bit value.
//! It is generated, so it has no copyright and is equal on every machine.
//!
//! Sources: ICC.1:2001-04 (version 2 of the format, which everything reads); IEC 61966-2-1 for the curve and the primaries,
//! these adapted to D50 as the profiles of 1998 have them.

use std::sync::OnceLock;

/// Bytes before the table of tags.
const HEADER: usize = 128;
/// Entries of the curve.
const ENTRIES: u16 = 256;
/// Display name of the profile.
const NAME: &[u8] = b"sRGB IEC61966-2.1\0";
const RIGHTS: &[u8] = b"No rights reserved (CC0)\0";
/// White of the connection space, in 1/65536.
const D50: [u32; 3] = [0xf6d6, 0x1_0000, 0xd32d];
/// The primaries under D50, likewise.
const RED: [u32; 3] = [0x6fa2, 0x38f5, 0x0390];
const GREEN: [u32; 3] = [0x6299, 0xb785, 0x18da];
const BLUE: [u32; 3] = [0x24a0, 0x0f84, 0xb6cf];

/// The profile as bytes.
#[must_use]
pub fn profile() -> &'static [u8] {
    static PROFILE: OnceLock<Vec<u8>> = OnceLock::new();
    PROFILE.get_or_init(written)
}

fn written() -> Vec<u8> {
    let curve = curve();
    let tags: [(&[u8; 4], Vec<u8>); 7] = [
        (b"desc", description()),
        (b"cprt", [b"text\0\0\0\0", RIGHTS].concat()),
        (b"wtpt", xyz(D50)),
        (b"rXYZ", xyz(RED)),
        (b"gXYZ", xyz(GREEN)),
        (b"bXYZ", xyz(BLUE)),
        (b"rTRC", curve),
    ];
    // The three curves are one.
    let shared: [&[u8; 4]; 2] = [b"gTRC", b"bTRC"];
    let count = tags.len() + shared.len();
    let (mut table, mut data) = ((count as u32).to_be_bytes().to_vec(), Vec::new());
    let start = HEADER + 4 + 12 * count;
    for (name, body) in &tags {
        let place = [(start + data.len()) as u32, body.len() as u32];
        let names = std::iter::once(*name).chain(shared.into_iter().filter(|_| *name == b"rTRC"));
        for name in names {
            table.extend(name);
            table.extend(place.iter().flat_map(|number| number.to_be_bytes()));
        }
        data.extend(body);
        data.resize(data.len().next_multiple_of(4), 0);
    }
    let mut profile = header((start + data.len()) as u32);
    profile.extend(table);
    profile.extend(data);
    profile
}

/// The size, then what kind of profile it is.
fn header(size: u32) -> Vec<u8> {
    let mut header = vec![0; HEADER];
    header[0..4].copy_from_slice(&size.to_be_bytes());
    header[8..12].copy_from_slice(&[2, 0x10, 0, 0]);
    header[12..24].copy_from_slice(b"mntrRGB XYZ ");
    // A day that never changes: the file of a page is the same whenever it is made.
    for (at, number) in [2001u16, 4, 1, 0, 0, 0].into_iter().enumerate() {
        header[24 + 2 * at..26 + 2 * at].copy_from_slice(&number.to_be_bytes());
    }
    header[36..40].copy_from_slice(b"acsp");
    for (at, number) in D50.into_iter().enumerate() {
        header[68 + 4 * at..72 + 4 * at].copy_from_slice(&number.to_be_bytes());
    }
    header
}

/// The name in ASCII, without other scripts.
fn description() -> Vec<u8> {
    let mut body = b"desc\0\0\0\0".to_vec();
    body.extend((NAME.len() as u32).to_be_bytes());
    body.extend(NAME);
    body.resize(body.len() + 4 + 4 + 2 + 1 + 67, 0);
    body
}

fn xyz(values: [u32; 3]) -> Vec<u8> {
    let mut body = b"XYZ \0\0\0\0".to_vec();
    body.extend(values.iter().flat_map(|value| value.to_be_bytes()));
    body
}

/// Linear light in 1/65535 for each value of a sample.
fn curve() -> Vec<u8> {
    let mut body = b"curv\0\0\0\0".to_vec();
    body.extend(u32::from(ENTRIES).to_be_bytes());
    for entry in 0..ENTRIES {
        let value = f64::from(entry) / f64::from(ENTRIES - 1);
        let light = if value <= 0.040_45 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) };
        body.extend(((light * 65_535.0).round() as u16).to_be_bytes());
    }
    body
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_profile_is_whole_and_small() {
        let profile = profile();
        let size = u32::from_be_bytes([profile[0], profile[1], profile[2], profile[3]]);
        assert_eq!(size as usize, profile.len());
        assert!(profile.len() < 1100, "{}", profile.len());
        assert_eq!(&profile[36..40], b"acsp");
        assert_eq!(profile[131], 9);
    }

    #[test]
    fn another_library_takes_it_for_srgb() {
        use qcms::{DataType, Intent, Profile, Transform};
        let own = Profile::new_from_slice(profile(), false).unwrap();
        let mut srgb = Profile::new_sRGB();
        srgb.precache_output_transform();
        let turn = Transform::new(&own, &srgb, DataType::RGB8, Intent::RelativeColorimetric).unwrap();
        let mut seen: Vec<u8> = (0..=255u8).flat_map(|i| [i, 255 - i, i.wrapping_mul(7)]).collect::<Vec<_>>();
        let before = seen.clone();
        turn.apply(&mut seen);
        assert!(seen.iter().zip(&before).all(|(a, b)| a.abs_diff(*b) <= 1));
    }
}
