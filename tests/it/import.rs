//! Files in, pixels out: every format against what Pillow sees, and every way to be broken.
//! The files and the expectations are made by `tests/oracles/decode.py`.

use std::fs;

use inkpanel_engine::Error;
use inkpanel_engine::page::import::{DRAFT_SIDE, import, import_draft};
use inkpanel_engine::raster::decode::{Limits, decode, decode_fit, decode_reduced};
use proptest::prelude::*;
use serde::Deserialize;

#[derive(Deserialize)]
struct Expected {
    file: String,
    width: usize,
    height: usize,
    orientation: u8,
    taken: Option<String>,
    offset: usize,
}

fn files(folder: &str) -> Vec<(String, Vec<u8>)> {
    let paths = fs::read_dir(crate::root(folder)).unwrap().map(|entry| entry.unwrap().path());
    let photos = paths.filter(|path| !matches!(path.extension().unwrap().to_str(), Some("md" | "json")));
    let mut files: Vec<_> = photos
        .map(|path| (path.file_name().unwrap().to_str().unwrap().to_owned(), fs::read(path).unwrap()))
        .collect();
    files.sort();
    files
}

#[test]
fn every_format_is_seen_as_pillow_sees_it() {
    let data = crate::root("tests/oracles/data");
    let expected: Vec<Expected> =
        serde_json::from_slice(&fs::read(data.join("expected.json")).unwrap()).unwrap();
    let pixels = fs::read(data.join("expected.bin")).unwrap();
    assert_eq!(expected.len(), files("tests/oracles/data/files").len());
    let mut failures = Vec::new();
    for expected in expected {
        let file = &expected.file;
        let bytes = fs::read(data.join("files").join(file)).unwrap();
        let decoded = decode(&bytes, &Limits::default()).unwrap_or_else(|error| panic!("{file}: {error}"));
        assert_eq!(
            (decoded.image.width(), decoded.image.height()),
            (expected.width, expected.height),
            "{file}"
        );
        assert_eq!((decoded.orientation, decoded.taken), (expected.orientation, expected.taken), "{file}");
        let format = decoded.format.to_lowercase();
        assert!(file.starts_with(&format), "{file} is no {format}");
        let expected = &pixels[expected.offset..][..expected.width * expected.height * 3];
        let differences = || decoded.image.to_rgb().into_iter().zip(expected).map(|(a, &b)| a.abs_diff(b));
        let sum: u32 = differences().map(u32::from).sum();
        let (mean, most) = (f64::from(sum) / expected.len() as f64, differences().max().unwrap());
        // Lossless formats are exact, except one rounding of alpha. JPEG decoders differ slightly in
        // upsampling.
        let lossy = format == "jpeg" || file.contains("lossy");
        // Tables are read between their entries, in other ways here and in littlecms.
        let (mean_allowed, most_allowed) = match (file.contains("icc-tables"), lossy) {
            (true, _) => (1.5, 8),
            (false, true) => (2.0, 8),
            (false, false) => (0.3, 1),
        };
        if file.contains("icc-tables") {
            println!("{file}: mean difference {mean:.3}, largest {most}");
        }
        if mean > mean_allowed || most > most_allowed {
            failures.push(format!("{file}: mean difference {mean:.3}, largest {most}"));
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

#[test]
fn a_truncated_file_is_reported_or_refused() {
    let folders = ["tests/oracles/data/files", "tests/photos", "www/public/samples"];
    for (name, bytes) in folders.into_iter().flat_map(files) {
        for part in (1..40).step_by(crate::trials(3, 1) as usize) {
            let cut = &bytes[..bytes.len() * part / 40];
            match decode_fit(cut, &Limits::default(), 64) {
                Err(Error::Damaged { .. } | Error::MostlyDamaged { .. } | Error::UnknownFormat) => {}
                Err(error) => panic!("{name} cut at {part}/40: {error:?}"),
                // The first frame of an animation may be complete.
                Ok(_) if name.contains("animated") && part > 19 => {}
                // At least half of the picture is there, and the rest is reported.
                Ok(found) if found.damage.is_some_and(|damage| damage.missing <= 0.5) => {}
                Ok(found) => {
                    let whole = decode_fit(&bytes, &Limits::default(), 64).unwrap();
                    assert_eq!(found.image.to_rgb(), whole.image.to_rgb(), "{name} cut at {part}/40");
                }
            }
        }
    }
}

#[test]
fn a_header_that_lies_is_refused_before_memory_is_taken() {
    let jpeg = fs::read(crate::root("tests/oracles/data/files/jpeg-420.jpg")).unwrap();
    let frame = jpeg.windows(2).position(|pair| pair == [0xFF, 0xC0]).unwrap();
    let sized = |width: u16, height: u16| {
        let mut file = jpeg.clone();
        file[frame + 5..frame + 7].copy_from_slice(&height.to_be_bytes());
        file[frame + 7..frame + 9].copy_from_slice(&width.to_be_bytes());
        decode(&file, &Limits::default()).unwrap_err().code()
    };
    assert_eq!(sized(60_000, 60_000), "too-large");
    assert_eq!(sized(20_000, 20_000), "too-large");
    assert_eq!(sized(9_000, 9_000), "damaged");
    assert_eq!(sized(0, 9_000), "damaged");

    let mut png = fs::read(crate::root("tests/oracles/data/files/png-rgb.png")).unwrap();
    png[16..24].copy_from_slice(&[0, 0, 0xEA, 0x60, 0, 0, 0xEA, 0x60]);
    let crc = crc32(&png[12..29]);
    png[29..33].copy_from_slice(&crc.to_be_bytes());
    let error = decode(&png, &Limits::default()).unwrap_err();
    assert_eq!(error.code(), "too-large");
    assert_eq!(
        error.to_string(),
        "the image is too large: 60000 x 60000 pixels, the limit is 32768 pixels per side"
    );
}

#[test]
fn limits_hold_for_every_format() {
    for (name, bytes) in files("tests/oracles/data/files") {
        let code = |limits: Limits| decode(&bytes, &limits).map(|_| ()).unwrap_err().code();
        let free = Limits::default();
        assert_eq!(code(Limits { max_side: 44, ..free }), "too-large", "{name}");
        assert_eq!(code(Limits { max_pixels: 45 * 27 - 1, ..free }), "too-large", "{name}");
        assert_eq!(code(Limits { max_bytes: 45 * 27 * 4, ..free }), "too-large", "{name}");
    }
}

#[test]
fn what_is_no_image_is_unknown() {
    for bytes in
        [&b""[..], b"\xFF", b"hello, this is text", b"%PDF-1.7\n", b"\0\0\0\x1CftypisomABCD", b"<svg/>"]
    {
        assert_eq!(decode(bytes, &Limits::default()).unwrap_err().code(), "unknown-format");
    }
    // The beginning of an image without the rest.
    for bytes in [
        &b"\xFF\xD8\xFF\xE0"[..],
        b"\x89PNG\r\n\x1a\n",
        b"GIF89a",
        b"BM",
        b"II*\0",
        b"RIFF\x04\0\0\0WEBP",
        b"\0\0\0\x1CftypheicABCD",
    ] {
        assert_eq!(decode(bytes, &Limits::default()).unwrap_err().code(), "damaged");
    }
}

#[test]
fn a_fitted_photo_tells_its_full_size_upright() {
    let bytes = fs::read(crate::root("tests/oracles/data/files/jpeg-exif-6.jpg")).unwrap();
    let fitted = decode_fit(&bytes, &Limits::default(), 15).unwrap();
    assert_eq!((fitted.width, fitted.height), (27, 45));
    assert_eq!((fitted.image.width(), fitted.image.height()), (9, 15));
}

/// How far apart two pictures of one size are: in the mean, and at most.
fn difference(a: &[u8], b: &[u8]) -> (f64, u8) {
    assert_eq!(a.len(), b.len());
    let differences = || a.iter().zip(b).map(|(&a, &b)| a.abs_diff(b));
    let sum: u32 = differences().map(u32::from).sum();
    (f64::from(sum) / a.len() as f64, differences().max().unwrap())
}

/// Files of an ending that are made by `tests/oracles/reduced.py`, by name.
fn reducible(ending: &str) -> Vec<(String, Vec<u8>)> {
    let files = files("tests/oracles/data/reduced").into_iter();
    files.filter_map(|(name, bytes)| Some((name.strip_suffix(ending)?.to_owned(), bytes))).collect()
}

#[test]
fn a_reduced_file_is_seen_as_libjpeg_sees_it() {
    let (photos, seen) = (reducible(".jpg"), reducible(".png"));
    assert_eq!((photos.len(), seen.len()), (6, 18));
    for (name, bytes) in seen {
        let expected = decode(&bytes, &Limits::default()).unwrap().image;
        let (photo, _) = name.rsplit_once('-').unwrap();
        let (_, photo) = photos.iter().find(|(name, _)| *name == photo).unwrap();
        let reduced = decode_reduced(photo, &Limits::default(), expected.width()).unwrap();
        assert_eq!((reduced.width, reduced.height), (216, 152), "the size of the whole photo");
        let (mean, most) = difference(&reduced.image.to_rgb(), &expected.to_rgb());
        // Both round brightness and colours apart, and then again.
        assert!(mean < 0.3 && most <= 3, "{name}: {mean} in the mean, {most} at most");
    }
}

#[test]
fn a_reduced_photo_is_the_whole_one_made_smaller() {
    for name in ["04-dandelions", "11-giraffe"] {
        let bytes = fs::read(crate::root(format!("www/public/samples/{name}.jpg"))).unwrap();
        for longest in [700, 333, 100] {
            let [reduced, whole] =
                [decode_reduced, decode_fit].map(|way| way(&bytes, &Limits::default(), longest));
            let (reduced, whole) = (reduced.unwrap(), whole.unwrap());
            assert_eq!((reduced.width, reduced.height), (whole.width, whole.height));
            let (mean, most) = difference(&reduced.image.to_rgb(), &whole.image.to_rgb());
            assert!(mean < 1.5 && most > 0, "{name} at {longest}: {mean} in the mean");
        }
    }
}

#[test]
fn a_draft_is_a_smaller_copy_of_a_large_file() {
    let bytes = fs::read(crate::root("www/public/samples/11-giraffe.jpg")).unwrap();
    let draft = import_draft("p", &bytes, &Limits::default()).unwrap().unwrap();
    let photo = import("p", &bytes, &Limits::default()).unwrap();
    assert_eq!(draft.work.width().max(draft.work.height()), DRAFT_SIDE);
    assert_eq!((draft.meta.width, draft.meta.height), (photo.meta.width, photo.meta.height));
    let bits = (draft.measures.fingerprint ^ photo.measures.fingerprint).count_ones();
    assert!(bits <= 2, "{bits} bits of the fingerprint differ");
    // Other formats, and files that are not much larger.
    for name in ["jpeg-progressive.jpg", "png-bits.png"] {
        let bytes = fs::read(crate::root(format!("tests/oracles/data/files/{name}"))).unwrap();
        assert!(import_draft("p", &bytes, &Limits::default()).unwrap().is_none(), "{name}");
    }
}

#[test]
fn what_cannot_be_reduced_is_decoded_whole() {
    for (name, bytes) in files("tests/oracles/data/files") {
        // At no less than half its size.
        let [reduced, whole] =
            [decode_reduced, decode_fit].map(|way| way(&bytes, &Limits::default(), 23).unwrap());
        assert_eq!(reduced.image, whole.image, "{name}");
    }
    let progressive = fs::read(crate::root("tests/oracles/data/files/jpeg-progressive.jpg")).unwrap();
    let [reduced, whole] =
        [decode_reduced, decode_fit].map(|way| way(&progressive, &Limits::default(), 10).unwrap());
    assert_eq!(reduced.image, whole.image);
}

#[test]
fn what_is_broken_is_told_as_of_a_whole_file() {
    let told = |way: fn(
        &[u8],
        &Limits,
        usize,
    ) -> inkpanel_engine::error::Result<inkpanel_engine::raster::decode::Decoded>,
                bytes: &[u8]| {
        way(bytes, &Limits::default(), 40)
            .map(|seen| (seen.width, seen.height))
            .map_err(|error| error.to_string())
    };
    for (name, bytes) in reducible(".jpg") {
        for length in (0..bytes.len()).step_by(97) {
            assert_eq!(
                told(decode_reduced, &bytes[..length]),
                told(decode_fit, &bytes[..length]),
                "{name} cut at {length}"
            );
        }
        // Its end is there, and something before it is not.
        let torn = [&bytes[..bytes.len() / 2], &[0xFF, 0xD9]].concat();
        assert_eq!(told(decode_reduced, &torn), told(decode_fit, &torn), "{name} torn");
    }
    let small = Limits { max_pixels: 10_000, ..Limits::default() };
    let bytes = fs::read(crate::root("tests/oracles/data/reduced/grey.jpg")).unwrap();
    assert_eq!(decode_reduced(&bytes, &small, 40).unwrap_err().code(), "too-large");
    let little = Limits { max_bytes: 100_000, ..Limits::default() };
    assert_eq!(decode_reduced(&bytes, &little, 40).unwrap_err().code(), "too-large");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn flipped_bits_of_a_reduced_file_never_panic(file in 0usize..6, flips in prop::collection::vec((any::<u32>(), 0u8..8), 1..6)) {
        let (_, mut bytes) = reducible(".jpg").swap_remove(file);
        for (at, bit) in flips {
            // Most of a file is coded data, most faults that matter are before them.
            let at = if at % 2 == 0 { at as usize / 2 % 700 } else { at as usize / 2 % bytes.len() };
            bytes[at] ^= 1 << bit;
        }
        let limits = Limits { max_pixels: 1_000_000, max_bytes: 1 << 24, ..Limits::default() };
        if let Ok(decoded) = decode_reduced(&bytes, &limits, 40) {
            prop_assert!(decoded.image.width().max(decoded.image.height()) <= 40);
        }
    }

    #[test]
    fn flipped_bits_never_panic(file in 0usize..100, flips in prop::collection::vec((any::<u32>(), 0u8..8), 1..6)) {
        let files = files("tests/oracles/data/files");
        let (_, mut bytes) = files[file % files.len()].clone();
        for (at, bit) in flips {
            let at = at as usize % bytes.len();
            bytes[at] ^= 1 << bit;
        }
        let limits = Limits { max_pixels: 1_000_000, max_bytes: 1 << 24, ..Limits::default() };
        if let Ok(decoded) = decode(&bytes, &limits) {
            prop_assert!(decoded.image.width() * decoded.image.height() <= 1_000_000);
        }
    }

    #[test]
    fn random_bytes_behind_a_magic_number_never_panic(kind in 0usize..7, tail in prop::collection::vec(any::<u8>(), 0..400)) {
        let magic: [&[u8]; 7] = [b"\xFF\xD8\xFF", b"\x89PNG\r\n\x1a\n", b"GIF89a", b"BM", b"II*\0", b"MM\0*", b"RIFF\x04\0\0\0WEBPVP8 "];
        let bytes = [magic[kind], &tail].concat();
        let _ = decode(&bytes, &Limits { max_pixels: 1_000_000, max_bytes: 1 << 24, ..Limits::default() });
    }
}

/// The check sum of PNG chunks, bit by bit.
fn crc32(bytes: &[u8]) -> u32 {
    let step = |crc: u32| if crc & 1 == 1 { (crc >> 1) ^ 0xEDB8_8320 } else { crc >> 1 };
    !bytes.iter().fold(!0, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), |crc, _| step(crc)))
}
