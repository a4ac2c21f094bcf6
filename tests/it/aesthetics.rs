//! Scores of pictures by the model, compared with a forward pass in numpy. `tests/oracles/aesthetics.py`
//! makes the values. Also the command line.

use std::fs;

use inkpanel_engine::detect::Aesthetics;
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode};
use serde_json::Value;

/// The model of `cargo xtask models`.
fn net() -> Aesthetics {
    let onnx = fs::read(crate::root("www/models/aesthetics.onnx")).expect("run `cargo xtask models`");
    Aesthetics::new(&onnx).unwrap()
}

fn photo(file: &str) -> Image {
    decode(&fs::read(crate::root(file)).unwrap(), &Limits::default()).unwrap().image
}

#[test]
fn scores_are_those_of_a_forward_pass_in_numpy() {
    let net = net();
    let rows: Vec<Value> =
        serde_json::from_slice(&fs::read(crate::root("tests/oracles/data/aesthetics.json")).unwrap())
            .unwrap();
    assert!(rows.len() >= 35, "{} photos", rows.len());
    let (mut least, mut most, mut worst) = (f64::MAX, f64::MIN, 0.0_f64);
    for row in rows {
        let (file, expected) = (row["file"].as_str().unwrap(), row["mean"].as_f64().unwrap());
        let found = net.score(&photo(file)).unwrap();
        assert!((found - expected).abs() < 0.02, "{file}: {found} for {expected}");
        worst = worst.max((found - expected).abs());
        (least, most) = (least.min(found), most.max(found));
    }
    println!("worst difference {worst:.4}");
    assert!(most - least > 1.0, "all photos are alike to the net: {least} to {most}");
}

#[test]
fn any_picture_has_a_score_and_a_gray_one_that_of_its_three_planes() {
    let net = net();
    for (width, height) in [(1, 1), (1, 700), (700, 3), (67, 41)] {
        let plane = inkpanel_engine::raster::Plane::from_fn(width, height, |x, y| (x * 7 + y * 13) as u8);
        let colour = Image::from_rgb([plane.clone(), plane.clone(), plane.clone()]).unwrap();
        let score = net.score(&colour).unwrap();
        assert!((1.0..=10.0).contains(&score), "{score}");
        assert!((net.score(&Image::from_luma(plane)).unwrap() - score).abs() < 1e-9);
    }
}

#[test]
fn another_file_is_no_net() {
    let Ok(faces) = fs::read(crate::root("www/models/faces.onnx")) else { return };
    for wrong in [&faces[..], b"no net", b""] {
        assert_eq!(Aesthetics::new(wrong).err().unwrap().code(), "detector");
    }
}

#[test]
fn generated_styles_have_scores_with_and_without_the_net() {
    let scores = |models: &str| -> Vec<f64> {
        let answer = crate::inkpanel()
            .args(["generate", "--json", "--seed", "3", "--count", "6", "--models", models])
            .arg("www/public/samples/09-mariachi.jpg")
            .current_dir(crate::root(""))
            .output()
            .unwrap();
        assert!(answer.status.success());
        let styles: Vec<Value> = serde_json::from_slice(&answer.stdout).unwrap();
        styles.iter().map(|style| style["score"].as_f64().unwrap()).collect()
    };
    let light = scores("src");
    assert!(light.len() == 6 && light.iter().all(|score| (0.0..=1.0).contains(score)));
    let judged = scores("www/models");
    assert!(judged.iter().all(|score| (0.0..=1.0).contains(score)));
    assert_ne!(light, judged);
}
