//! Eyelids and lips of faces against `LiteRT` and numpy; the values are made by `tests/oracles/landmarks.py`. Also the
//! command line.

use std::fs;

use inkpanel_engine::detect::{Detection, Detectors, Expression, FacePoints, Landmarks};
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::{Image, Plane};
use serde::Deserialize;
use serde_json::Value;

fn model(name: &str) -> Vec<u8> {
    fs::read(crate::root("www/models").join(name)).expect("run `cargo xtask models`")
}

fn photo(file: &str) -> Image {
    decode(&fs::read(crate::root(file)).unwrap(), &Limits::default()).unwrap().image
}

/// A quarter turn: the left edge becomes the upper edge.
fn turned(photo: &Image) -> Image {
    let (width, height) = (photo.height(), photo.width());
    let planes = photo.planes().iter();
    let planes = planes.map(|plane| Plane::from_fn(width, height, |x, y| plane.at(y, width - 1 - x)));
    Image::from_rgb(planes.collect::<Vec<_>>().try_into().unwrap()).unwrap()
}

#[derive(Deserialize)]
struct Row {
    file: String,
    turned: bool,
    #[serde(rename = "box")]
    corners: [f64; 4],
    points: FacePoints,
    presence: f64,
    /// Tenths of a pixel.
    mesh: Vec<f64>,
}

#[test]
fn points_are_those_of_litert() {
    let landmarks = Landmarks::new(&model("landmarks.onnx")).unwrap();
    let rows = fs::read(crate::root("tests/oracles/data/landmarks.json")).unwrap();
    let rows: Vec<Row> = serde_json::from_slice(&rows).unwrap();
    assert!(rows.len() >= 10, "{} faces", rows.len());
    for row in &rows {
        let photo = photo(&row.file);
        let photo = if row.turned { turned(&photo) } else { photo };
        let [left, top, right, bottom] = row.corners;
        let face = Detection {
            label: "face".into(),
            score: 0.9,
            x: left,
            y: top,
            width: right - left,
            height: bottom - top,
            points: Some(row.points),
            expression: None,
            light: None,
        };
        let mesh = landmarks.mesh(&photo, &face).unwrap();
        assert!(
            (mesh.presence - row.presence).abs() < 0.02,
            "{}: {} {}",
            row.file,
            mesh.presence,
            row.presence
        );
        let side = 1.5 * (face.width * photo.width() as f64).max(face.height * photo.height() as f64);
        let (expected, rest) = row.mesh.as_chunks::<2>();
        assert_eq!((expected.len(), rest.len(), mesh.points.len()), (468, 0, 468));
        for (at, ([x, y, _], expected)) in mesh.points.iter().zip(expected).enumerate() {
            let away = (x - expected[0] / 10.0).hypot(y - expected[1] / 10.0) / side;
            assert!(away <= 0.01, "{}: point {at} is {away:.4} away", row.file);
        }
    }
}

/// The largest face of a photo, with and without the landmark model.
fn astronaut() -> [Detection; 2] {
    let photo = photo("www/public/samples/19-astronaut.jpg");
    let plain = Detectors::new(&model("faces.onnx"), &model("objects.onnx")).unwrap();
    let without = plain.detect(&photo).unwrap().remove(0);
    let with = plain.with_landmarks(&model("landmarks.onnx")).unwrap().detect(&photo).unwrap().remove(0);
    [without, with]
}

#[test]
fn a_smiling_face_with_open_eyes_is_read() {
    let [without, with] = astronaut();
    assert_eq!(without.expression, None);
    let Expression { right_eye, left_eye, mouth, smile } = with.expression.unwrap();
    assert!(right_eye > 0.2 && left_eye > 0.2, "{right_eye} {left_eye}");
    // She shows her teeth.
    assert!((0.05..0.5).contains(&mouth) && smile > 0.05, "{mouth} {smile}");
    // Only the mouth moves, and not far.
    let (before, after) = (without.points.unwrap(), with.points.unwrap());
    let moved: Vec<usize> =
        (0..6).filter(|&at| before[at].map(f64::to_bits) != after[at].map(f64::to_bits)).collect();
    assert_eq!(moved, [3]);
    assert!((before[3][1] - after[3][1]).abs() < 0.1 * with.height, "{before:?} {after:?}");
    assert_eq!(Detection { points: None, expression: None, ..with }, Detection { points: None, ..without });
}

#[test]
fn another_file_is_not_the_landmark_model() {
    let landmarks = model("landmarks.onnx");
    for wrong in [&b"no net"[..], &landmarks[..landmarks.len() / 2]] {
        assert_eq!(Landmarks::new(wrong).err().unwrap().code(), "detector");
    }
    // A model of the same input with other outputs.
    let faces = Landmarks::new(&model("faces.onnx")).unwrap();
    let [face, _] = astronaut();
    let error = faces.mesh(&photo("www/public/samples/19-astronaut.jpg"), &face).err().unwrap();
    assert!(error.to_string().contains("landmark"), "{error}");
}

#[test]
fn the_command_prints_the_expression() {
    let file = "www/public/samples/19-astronaut.jpg";
    let answer =
        crate::inkpanel().args(["detect", "--json", file]).current_dir(crate::root("")).output().unwrap();
    let rows: Value = serde_json::from_slice(&answer.stdout).unwrap();
    let [_, face] = astronaut();
    assert_eq!(rows[0]["boxes"][0]["expression"], serde_json::to_value(face.expression).unwrap());
}

#[test]
fn the_selection_compares_eyes() {
    let eyes = |options: &[&str]| {
        let mut select = crate::inkpanel();
        select.args(["select", "--json", "www/public/samples/19-astronaut.jpg"]).args(options);
        let answer = select.current_dir(crate::root("")).output().unwrap();
        let rows: Value = serde_json::from_slice(&answer.stdout).unwrap();
        (rows[0]["eyes"].clone(), String::from_utf8(answer.stderr).unwrap())
    };
    let [_, face] = astronaut();
    let (open, said) = eyes(&[]);
    // The photo is reduced at import, so that the points differ a little.
    let expected = face.expression.map(|found| f64::midpoint(found.right_eye, found.left_eye)).unwrap();
    assert!((open.as_f64().unwrap() - expected).abs() < 0.1, "{open} {expected}");
    assert_eq!(said, "");
    assert_eq!(eyes(&["--no-detect"]), (Value::Null, String::new()));
    let (missing, said) = eyes(&["--models", "nowhere"]);
    assert!(missing.is_null() && said.contains("eyes are not compared"), "{said}");
}
