//! HEIC files against libheif, and broken ones. `tests/oracles/heic.py` made the files and the pictures.

use inkpanel_engine::raster::decode::{Limits, decode, decode_fit};
use inkpanel_engine::raster::header::Header;
use std::fs;

const FOLDER: &str = "tests/oracles/data/heic";

fn file(name: &str) -> Vec<u8> {
    fs::read(crate::root(FOLDER).join(name)).unwrap()
}

/// Peak signal-to-noise ratio in dB.
fn psnr(a: &[u8], b: &[u8]) -> f64 {
    let error: f64 = a.iter().zip(b).map(|(&a, &b)| f64::from(a.abs_diff(b)).powi(2)).sum();
    10.0 * (255.0 * 255.0 * a.len() as f64 / error.max(1e-9)).log10()
}

#[test]
fn pictures_are_those_of_libheif() {
    let table = fs::read_to_string(crate::root(FOLDER).join("table.json")).unwrap();
    let table: serde_json::Value = serde_json::from_str(&table).unwrap();
    let rows = table.as_array().unwrap();
    assert!(rows.len() >= 12);
    for row in rows {
        let name = row["file"].as_str().unwrap();
        let bytes = file(name);
        let photo = decode(&bytes, &Limits::default()).unwrap_or_else(|error| panic!("{name}: {error}"));
        let expected = decode(&file(row["expected"].as_str().unwrap()), &Limits::default()).unwrap();
        assert_eq!((photo.width, photo.height), (expected.width, expected.height), "{name}");
        let header = Header::read(&bytes[..bytes.len().min(4096)]).unwrap();
        assert_eq!([header.width, header.height], [expected.width, expected.height], "{name}");
        let found = psnr(&photo.image.to_rgb(), &expected.image.to_rgb());
        let least = row["least"].as_f64().unwrap();
        assert!(found >= least, "{name}: {found:.1} dB, at least {least}");
        assert_eq!(photo.format, "HEIC", "{name}");
        assert_eq!(photo.taken.as_deref(), row["taken"].as_str(), "{name}");
    }
}

#[test]
fn a_photo_is_reduced_as_any_other() {
    let photo = decode_fit(&file("grid.heic"), &Limits::default(), 100).unwrap();
    assert_eq!(photo.image.width().max(photo.image.height()), 100);
    assert!(photo.width > 100);
}

#[test]
fn a_broken_file_is_an_error_with_a_code() {
    let whole = file("grid.heic");
    let mut seed = 1u64;
    let mut next = |below: usize| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as usize % below
    };
    for round in 0..crate::trials(60, 1000) {
        let mut bytes = whole.clone();
        if round % 2 == 0 {
            bytes.truncate(next(whole.len()));
        }
        // The boxes are at the beginning, and all others are pixels.
        for _ in 0..next(6) {
            let at = if round % 3 == 0 { next(bytes.len().max(1)) } else { next(bytes.len().clamp(1, 2000)) };
            if let Some(byte) = bytes.get_mut(at) {
                *byte = next(256) as u8;
            }
        }
        if let Err(error) = decode(&bytes, &Limits::default()) {
            let known = ["damaged", "unsupported", "too-large", "unknown-format"];
            assert!(known.contains(&error.code()), "{error}");
        }
    }
}

#[test]
fn limits_hold_before_memory_is_allocated() {
    let limits = Limits { max_pixels: 1000, ..Limits::default() };
    assert_eq!(decode(&file("grid.heic"), &limits).unwrap_err().code(), "too-large");
    let limits = Limits { max_bytes: 100_000, ..Limits::default() };
    assert_eq!(decode(&file("grid.heic"), &limits).unwrap_err().code(), "too-large");
}

#[test]
fn avif_is_named_with_a_way_out() {
    let bytes = fs::read(crate::root("tests/oracles/data/foreign/plain.avif")).unwrap();
    let error = decode(&bytes, &Limits::default()).unwrap_err();
    assert_eq!(error.code(), "unsupported");
    assert!(error.to_string().contains("AVIF") && error.to_string().contains("save it as JPEG"), "{error}");
}
