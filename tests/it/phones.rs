//! Photos as phones and cameras write them: EXIF records of every shape, and files with something behind the picture.

use inkpanel_engine::raster::decode::{Decoded, Limits, decode};
use proptest::prelude::*;
use std::fs;

/// A small photo without metadata.
fn photo() -> Vec<u8> {
    fs::read(crate::root("tests/oracles/data/files/jpeg-444.jpg")).unwrap()
}

fn read(bytes: &[u8]) -> Decoded {
    decode(bytes, &Limits::default()).unwrap()
}

/// Puts a segment behind the start of a JPEG file.
fn with_segment(marker: u8, body: &[u8]) -> Vec<u8> {
    let photo = photo();
    let length = (body.len() as u16 + 2).to_be_bytes();
    [&photo[..2], &[0xFF, marker], &length, body, &photo[2..]].concat()
}

/// Types of whole numbers in EXIF: their number and their size in bytes.
const INTEGERS: [(u16, usize); 6] = [(1, 1), (3, 2), (4, 4), (6, 1), (8, 2), (9, 4)];

/// A date with its tag and the tag of the fraction of the second, and the fraction as it is written.
#[derive(Clone, Debug)]
struct Date {
    tags: (u16, u16),
    second: u32,
    fraction: String,
}

/// An EXIF record.
#[derive(Clone, Debug)]
struct Record {
    is_little: bool,
    orientation: Option<(u8, usize)>,
    /// Dates in `DateTimeOriginal`, `DateTimeDigitized` and `DateTime`. Each may be missing.
    dates: [Option<Date>; 3],
    /// Bytes between the parts of the record.
    gap: usize,
    /// Fields of other tags.
    others: usize,
}

const TAGS: [(u16, u16); 3] = [(0x9003, 0x9291), (0x9004, 0x9292), (0x0132, 0x9290)];

impl Record {
    fn short(&self, value: u16) -> Vec<u8> {
        if self.is_little { value.to_le_bytes().to_vec() } else { value.to_be_bytes().to_vec() }
    }

    fn long(&self, value: u32) -> Vec<u8> {
        if self.is_little { value.to_le_bytes().to_vec() } else { value.to_be_bytes().to_vec() }
    }

    /// Writes a directory at `at` with its values behind it.
    fn directory(&self, at: usize, mut fields: Vec<(u16, u16, u32, Vec<u8>)>) -> Vec<u8> {
        fields.sort_by_key(|field| field.0);
        let mut out = self.short(fields.len() as u16);
        let mut values = vec![0; self.gap];
        let behind = at + 2 + 12 * fields.len() + 4;
        for (tag, kind, count, value) in fields {
            out.extend([self.short(tag), self.short(kind), self.long(count)].concat());
            if value.len() <= 4 {
                out.extend(value.iter().copied().chain(std::iter::repeat(0)).take(4));
            } else {
                out.extend(self.long((behind + values.len()) as u32));
                values.extend(value);
            }
        }
        [out, vec![0; 4], values].concat()
    }

    fn written(&self) -> Vec<u8> {
        let text = |text: String| {
            let bytes = [text.into_bytes(), vec![0]].concat();
            (2u16, bytes.len() as u32, bytes)
        };
        let mut main: Vec<(u16, u16, u32, Vec<u8>)> = Vec::new();
        let mut inner = Vec::new();
        for i in 0..self.others {
            main.push((0x0100 + i as u16, 3, 1, self.short(7)));
        }
        if let Some((value, kind)) = self.orientation {
            let (number, size) = INTEGERS[kind];
            let value = u32::from(value);
            let bytes = match size {
                1 => vec![value as u8],
                2 => self.short(value as u16),
                _ => self.long(value),
            };
            main.push((0x0112, number, 1, bytes));
        }
        for date in self.dates.iter().flatten() {
            let (kind, count, value) = text(date.text());
            let field = (date.tags.0, kind, count, value);
            if date.tags.0 == 0x0132 {
                main.push(field);
            } else {
                inner.push(field);
            }
            if !date.fraction.is_empty() {
                let (kind, count, value) = text(date.fraction.clone());
                inner.push((date.tags.1, kind, count, value));
            }
        }
        // The offset of the second directory depends only on the size of the first.
        main.push((0x8769, 4, 1, self.long(0)));
        let at = 8 + self.directory(8, main.clone()).len() + self.gap;
        main.last_mut().unwrap().3 = self.long(at as u32);
        let mut out = if self.is_little { b"II*\0".to_vec() } else { b"MM\0*".to_vec() };
        out.extend(self.long(8));
        out.extend(self.directory(8, main));
        out.resize(at, 0);
        out.extend(self.directory(at, inner));
        out
    }

    fn taken(&self) -> Option<String> {
        let date = self.dates.iter().flatten().next()?;
        let digits = date.fraction.trim_end().trim_end_matches('0');
        Some(if digits.is_empty() { date.text() } else { format!("{}.{digits}", date.text()) })
    }
}

impl Date {
    fn text(&self) -> String {
        format!("2024:05:17 09:30:{:02}", self.second)
    }
}

fn dates() -> impl Strategy<Value = [Option<Date>; 3]> {
    let date = |tags: (u16, u16)| {
        proptest::option::of((0u32..60, "[0-9]{0,8} {0,2}").prop_map(move |(second, fraction)| {
            let fraction = if fraction.starts_with(' ') { String::new() } else { fraction };
            Date { tags, second, fraction }
        }))
    };
    [date(TAGS[0]), date(TAGS[1]), date(TAGS[2])]
}

fn records() -> impl Strategy<Value = Record> {
    let orientation = proptest::option::of((1u8..=8, 0..INTEGERS.len()));
    (any::<bool>(), orientation, dates(), 0usize..5, 0usize..4).prop_map(
        |(is_little, orientation, dates, gap, others)| Record { is_little, orientation, dates, gap, others },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn every_exif_record_is_read(record in records()) {
        let photo = read(&with_segment(0xE1, &[b"Exif\0\0", record.written().as_slice()].concat()));
        prop_assert_eq!(photo.orientation, record.orientation.map_or(1, |(value, _)| value));
        prop_assert_eq!(photo.taken, record.taken());
    }

    #[test]
    fn a_broken_exif_record_costs_no_photo(record in records(), at in any::<prop::sample::Index>(), value: u8) {
        let mut bytes = [b"Exif\0\0", record.written().as_slice()].concat();
        let at = at.index(bytes.len());
        bytes[at] = value;
        let photo = read(&with_segment(0xE1, &bytes));
        prop_assert!((1..=8).contains(&photo.orientation));
    }
}

/// A small video behind a photo.
const VIDEO: &[u8] = b"\0\0\0\x18ftypmp42\0\0\0\0isommp42\0\0\0\x10mdat\xFF\xD8\xFF\xD9\xFF\xDA\0\x01";

#[test]
fn what_is_behind_the_picture_is_ignored() {
    let photo = photo();
    let plain = read(&photo);
    assert!(photo.ends_with(&[0xFF, 0xD9]));
    let without_end = &photo[..photo.len() - 2];
    let gain_map = b"MPF\0II*\0\x08\0\0\0\0\0\0\0\0\0";
    let cases = [
        ("motion photo", [&photo, VIDEO].concat()),
        ("motion photo without an end marker", [without_end, VIDEO].concat()),
        ("trailer of a phone", [without_end, b"SEFH\x6b\0\0\0\x01\0\0\0SEFT"].concat()),
        ("zeros", [without_end, &[0; 4096]].concat()),
        ("zeros behind the end", [&photo[..], &[0; 4096]].concat()),
        ("two pictures (MPO)", [photo.as_slice(), &photo].concat()),
        ("gain map", [with_segment(0xE2, gain_map), photo.clone()].concat()),
    ];
    for (name, bytes) in cases {
        let found = read(&bytes);
        assert_eq!(found.image.to_rgb(), plain.image.to_rgb(), "{name}");
        assert!(found.damage.is_none(), "{name}");
    }
}

#[test]
fn a_burst_is_in_the_order_in_which_it_was_taken() {
    let folder = tempfile::tempdir().unwrap();
    let fractions = ["9", "05", "5", "25"];
    for (i, fraction) in fractions.iter().enumerate() {
        let date = Date { tags: TAGS[0], second: 3, fraction: (*fraction).to_owned() };
        let record =
            Record { is_little: true, orientation: None, dates: [Some(date), None, None], gap: 0, others: 0 };
        let bytes = with_segment(0xE1, &[b"Exif\0\0", record.written().as_slice()].concat());
        fs::write(folder.path().join(format!("{i}.jpg")), bytes).unwrap();
    }
    let mut taken: Vec<_> =
        (0..4).map(|i| (read(&fs::read(folder.path().join(format!("{i}.jpg"))).unwrap()).taken, i)).collect();
    taken.sort();
    assert_eq!(taken.iter().map(|&(_, i)| fractions[i]).collect::<Vec<_>>(), ["05", "25", "5", "9"]);
}
