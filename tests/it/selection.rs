//! Resampling, fingerprints and sharpness against the same in numpy and scipy.
//! The values are made by `tests/oracles/selection.py`.

use std::fs;

use inkpanel_engine::raster::Plane;
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::resize::{Region, resample};
use inkpanel_engine::select::{fingerprint::distance, measure};
use inkpanel_engine::simd::point::luma_plane;
use serde::Deserialize;

#[derive(Deserialize)]
struct Expected {
    file: String,
    whole: String,
    region: [f64; 4],
    part: String,
    fingerprint: String,
    gradient: f32,
    paper: f32,
    laplacian: f32,
}

/// Mean and largest difference of a plane from expected samples in hexadecimal.
fn difference(plane: &Plane, hex: &str) -> (f64, u8) {
    let expected = (0..hex.len()).step_by(2).map(|i| u8::from_str_radix(&hex[i..i + 2], 16).unwrap());
    let differences: Vec<u8> = plane.samples().iter().zip(expected).map(|(&a, b)| a.abs_diff(b)).collect();
    assert_eq!(differences.len(), hex.len() / 2);
    let sum: f64 = differences.iter().copied().map(f64::from).sum();
    (sum / differences.len() as f64, differences.into_iter().max().unwrap())
}

#[test]
fn photos_are_measured_as_in_numpy() {
    let rows = fs::read(crate::root("tests/oracles/data/selection.json")).unwrap();
    let rows: Vec<Expected> = serde_json::from_slice(&rows).unwrap();
    assert_eq!(rows.len(), 16);
    for expected in rows {
        let file = &expected.file;
        let bytes = fs::read(crate::root("tests/photos").join(file)).unwrap();
        let image = decode(&bytes, &Limits::default()).unwrap().image;
        let luma = luma_plane(&image);
        let whole = resample(&luma, Region::whole(luma.width(), luma.height()), 23, 17);
        // One step: the rounding between the axes, and what two JPEG decoders differ by on average.
        let (mean, most) = difference(&whole, &expected.whole);
        assert!(most <= 1 && mean < 0.3, "{file}: {mean} {most}");
        let [x, y, width, height] = expected.region;
        let part = resample(&luma, Region { x, y, width, height }, 16, 12);
        let (mean, most) = difference(&part, &expected.part);
        assert!(most <= 1 && mean < 0.3, "{file}, region: {mean} {most}");

        let measures = measure(&image);
        let bits = u64::from_str_radix(&expected.fingerprint, 16).unwrap();
        assert!(distance(measures.fingerprint, bits) <= 1, "{file}: {:016x}", measures.fingerprint);
        let near = |actual: f32, expected: f32, part: f32| (actual / expected - 1.0).abs() <= part;
        assert!(near(measures.gradient, expected.gradient, 0.02), "{file}: {}", measures.gradient);
        assert!(near(measures.paper, expected.paper, 0.05), "{file}: {}", measures.paper);
        assert!(near(measures.laplacian, expected.laplacian, 0.02), "{file}: {}", measures.laplacian);
    }
}
