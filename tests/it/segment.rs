//! Subjects against ONNX Runtime, their refinement against `OpenCV`; the values are made by
//! `tests/oracles/segment.py`. Also the command line.

use std::fs;
use std::path::Path;

use inkpanel_engine::detect::{SEGMENT_SIDE, Segmenter};
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::guided::guided;
use inkpanel_engine::raster::{Image, Plane};
use serde_json::Value;

/// The model of `cargo xtask models`.
fn segmenter() -> Segmenter {
    let onnx = fs::read(crate::root("www/models/subject.onnx")).expect("run `cargo xtask models`");
    Segmenter::new(&onnx).unwrap()
}

fn photo(file: &str) -> Image {
    decode(&fs::read(crate::root(file)).unwrap(), &Limits::default()).unwrap().image
}

fn expected() -> Value {
    serde_json::from_slice(&fs::read(crate::root("tests/oracles/data/segment.json")).unwrap()).unwrap()
}

fn bytes(hexadecimal: &Value) -> Vec<u8> {
    let digits = hexadecimal.as_str().unwrap();
    (0..digits.len()).step_by(2).map(|at| u8::from_str_radix(&digits[at..at + 2], 16).unwrap()).collect()
}

#[test]
fn subjects_are_those_of_onnx_runtime() {
    let net = segmenter();
    let rows = expected()["subjects"].as_array().unwrap().clone();
    assert_eq!(rows.len(), 10);
    for row in rows.iter().step_by(crate::trials(3, 1) as usize) {
        let file = row["file"].as_str().unwrap();
        let shares = net.shares(&photo(file)).unwrap();
        let expected = bytes(&row["shares"]);
        assert_eq!(expected.len(), 1600);
        let at = |i: usize| shares[(4 + i / 40 * 8) * SEGMENT_SIDE + 4 + i % 40 * 8];
        let apart: f64 =
            expected.iter().enumerate().map(|(i, share)| (at(i) - f64::from(*share) / 255.0).abs()).sum();
        let mean = apart / expected.len() as f64;
        println!("{file}: {mean:.5}");
        assert!(mean <= 0.01, "{file}: shares differ by {mean:.4} in the mean");
    }
}

#[test]
fn a_look_in_steps_is_the_look_at_once() {
    let net = segmenter();
    let photo = photo("www/public/samples/02-kitten.jpg");
    let at_once = String::from(net.look(&photo).unwrap());
    // Two at a time, because they are independent.
    let mut looks = [net.begin(&photo).unwrap(), net.begin(&photo).unwrap()];
    let mut steps = 0;
    loop {
        steps += 1;
        let [first, second] = looks.each_mut().map(|look| look.advance().unwrap());
        assert_eq!(first.is_some(), second.is_some());
        if let Some(mask) = first {
            assert_eq!(String::from(mask), at_once);
            break;
        }
    }
    // About one step per operator, so that other work on the core waits only briefly.
    assert!(steps > 100, "{steps} steps");
}

#[test]
fn masks_are_refined_as_opencv_does_it() {
    let data = expected()["guided"].clone();
    let side = |key: &str| data[key].as_u64().unwrap() as usize;
    let (width, height, radius) = (side("width"), side("height"), side("radius"));
    let plane = |key: &str| Plane::from_samples(width, height, bytes(&data[key])).unwrap();
    let (filtered, expected) = (guided(&plane("guide"), &plane("mask"), radius, 1e-4), plane("filtered"));
    // OpenCV mirrors the image beyond its edge, so values within two radii of it differ.
    for y in 2 * radius..height - 2 * radius {
        for x in 2 * radius..width - 2 * radius {
            let (got, wanted) = (filtered.at(x, y), expected.at(x, y));
            assert!(got.abs_diff(wanted) <= 1, "{got} for {wanted} at {x}, {y}");
        }
    }
}

#[test]
fn the_command_writes_masks_and_leaves_out_what_is_no_photo() {
    let folder = std::env::temp_dir().join(format!("inkpanel-segment-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let broken = folder.join("broken.jpg");
    fs::write(&broken, "no photo").unwrap();
    let masks = folder.join("masks");
    let run = |files: &[&Path]| {
        crate::inkpanel().arg("segment").args(files).args(["--json", "-o"]).arg(&masks).output().unwrap()
    };
    let kitten = crate::root("www/public/samples/02-kitten.jpg");
    let told = run(&[&broken, &kitten, &kitten]);
    assert!(told.status.success(), "{}", String::from_utf8_lossy(&told.stderr));
    assert!(String::from_utf8_lossy(&told.stderr).contains("broken.jpg"));
    let rows: Vec<Value> = serde_json::from_slice(&told.stdout).unwrap();
    assert_eq!(rows.len(), 2);
    assert_eq!(rows[0]["file"].as_str(), kitten.to_str());
    assert_eq!(rows[0]["mask"].as_str(), masks.join("02-kitten.png").to_str());
    assert_eq!(rows[1]["mask"].as_str(), masks.join("02-kitten-2.png").to_str());
    let (mask, photo) = (photo(rows[0]["mask"].as_str().unwrap()), photo("www/public/samples/02-kitten.jpg"));
    assert_eq!((mask.width(), mask.height()), (photo.width(), photo.height()));
    // The kitten's face, and the table before it.
    let at = |x: f64, y: f64| {
        mask.planes()[0].at((x * photo.width() as f64) as usize, (y * photo.height() as f64) as usize)
    };
    assert!(at(0.48, 0.55) > 240 && at(0.1, 0.2) < 15);
    let share = |key: &str| rows[0][key].as_f64().unwrap();
    assert!((0.15..0.3).contains(&share("coverage")) && share("confidence") > 0.5, "{rows:?}");
    let none = run(&[&broken]);
    assert_eq!(none.status.code(), Some(1));
    fs::remove_dir_all(&folder).unwrap();
}
