//! Detection on photos against ONNX Runtime and numpy; the values are made by `tests/oracles/detect.py`. Also
//! the command line.

use std::collections::BTreeMap;
use std::fs;

use inkpanel_engine::detect::{Detection, Detectors, FacePoints, worth_a_closer_look};
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::resize::{Region, resample_image};
use inkpanel_engine::raster::{Image, Plane};
use serde_json::Value;

/// The models of `cargo xtask models`.
fn detectors() -> Detectors {
    let read = |name: &str| fs::read(crate::root("www/models").join(name)).expect("run `cargo xtask models`");
    Detectors::new(&read("faces.onnx"), &read("objects.onnx")).unwrap()
}

fn photo(file: &str) -> Image {
    decode(&fs::read(crate::root(file)).unwrap(), &Limits::default()).unwrap().image
}

/// COCO's numbers of the labels that the expected boxes have.
fn numbers() -> BTreeMap<&'static str, u64> {
    [
        ("person", 1),
        ("car", 3),
        ("boat", 9),
        ("traffic light", 10),
        ("bench", 15),
        ("bird", 16),
        ("cat", 17),
        ("dog", 18),
        ("horse", 19),
        ("sheep", 20),
        ("cow", 21),
        ("bear", 23),
        ("giraffe", 25),
        ("frisbee", 34),
        ("cup", 47),
        ("sandwich", 54),
        ("cake", 61),
        ("chair", 62),
        ("dining table", 67),
        ("toothbrush", 90),
    ]
    .into()
}

/// Left, top, right, bottom.
fn corners(found: &Detection) -> [f64; 4] {
    [found.x, found.y, found.x + found.width, found.y + found.height]
}

#[test]
fn boxes_are_those_of_onnx_runtime() {
    let detectors = detectors();
    let rows: Vec<Value> =
        serde_json::from_slice(&fs::read(crate::root("tests/oracles/data/detect.json")).unwrap()).unwrap();
    assert!(rows.len() >= 35, "{} photos", rows.len());
    let numbers = numbers();
    let (mut compared, mut faces) = (0, 0);
    for row in rows {
        let file = row["file"].as_str().unwrap();
        let photo = photo(file);
        let mut found = detectors.faces.look(&photo).unwrap();
        found.extend(detectors.objects.look(&photo).unwrap());
        let mut expected: Vec<&Vec<Value>> =
            row["boxes"].as_array().unwrap().iter().map(|b| b.as_array().unwrap()).collect();
        for found in &found {
            let same = |other: &&Vec<Value>| {
                let label = other[0].as_str() == Some(&found.label)
                    || other[0].as_u64().is_some_and(|n| numbers.get(found.label.as_str()) == Some(&n));
                // One of the model's 300 pixels along the longer side of the photo is a larger fraction of
                // the shorter one.
                let near = |(a, b): (f64, &Value)| (a - b.as_f64().unwrap()).abs() <= 1.0 / 300.0;
                label
                    && (found.score - other[1].as_f64().unwrap()).abs() <= 0.01
                    && corners(found).into_iter().zip(&other[2..]).all(near)
            };
            let at = expected.iter().position(same);
            if let (Some(at), Some(points)) = (at, found.points) {
                let wanted: FacePoints = serde_json::from_value(expected[at][6].clone()).unwrap();
                let pairs = points.iter().flatten().zip(wanted.iter().flatten());
                assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() <= 1.0 / 192.0), "{file}: {points:?}");
                faces += 1;
            }
            assert!(at.is_some(), "{file}: {found:?} is none of {expected:?}");
            expected.remove(at.unwrap());
            compared += 1;
        }
        assert!(expected.is_empty(), "{file}: {expected:?} was not found");
    }
    assert!(compared >= 40 && faces == 9, "only {compared} boxes and {faces} faces");
}

#[test]
fn small_faces_of_a_large_photo_are_found_in_its_parts() {
    let detectors = detectors();
    // A face of 1/25 of a large picture, which is 8 of the model's 192 pixels.
    let photo = astronauts(2400, &[(1500, 300, 512)]);
    let first = detectors.faces.look(&photo).unwrap();
    assert!(worth_a_closer_look(&photo, &first));
    let faces = |boxes: &[Detection]| boxes.iter().filter(|b| b.label == "face").cloned().collect::<Vec<_>>();
    let found = faces(&detectors.detect(&photo).unwrap());
    assert_eq!(found.len(), 1, "{found:?}, at first {first:?}");
    let [left, top, right, bottom] = corners(&found[0]).map(|side| side * 2400.0);
    // The astronaut's face, as detected in the whole picture.
    let expected =
        [1500.0 + 0.339 * 512.0, 300.0 + 0.133 * 512.0, 1500.0 + 0.546 * 512.0, 300.0 + 0.34 * 512.0];
    for (found, expected) in [left, top, right, bottom].iter().zip(expected) {
        assert!((found - expected).abs() < 20.0, "{found} for {expected}");
    }
}

/// A photo that shows the astronaut in squares of it: the side of the photo, then left, top and side of each square.
fn astronauts(side: usize, places: &[(usize, usize, usize)]) -> Image {
    let astronaut = photo("www/public/samples/19-astronaut.jpg");
    let copies: Vec<_> = places
        .iter()
        .map(|&(left, top, side)| {
            let whole = Region::whole(astronaut.width(), astronaut.height());
            (left, top, side, resample_image(&astronaut, whole, side, side))
        })
        .collect();
    let planes = [0, 1, 2].map(|channel| {
        Plane::from_fn(side, side, |x, y| {
            let of_copy = copies.iter().find_map(|(left, top, side, copy)| {
                let inside = (*left..left + side).contains(&x) && (*top..top + side).contains(&y);
                inside.then(|| copy.planes()[channel].at(x - left, y - top))
            });
            of_copy.unwrap_or(128)
        })
    });
    Image::from_rgb(planes).unwrap()
}

#[test]
fn a_small_face_beside_a_large_one_is_found_in_the_box_of_its_person() {
    let detectors = detectors();
    let photo = astronauts(900, &[(0, 300, 600), (660, 100, 200)]);
    let first = detectors.faces.search(&photo).unwrap();
    assert!(first.len() == 1 && !worth_a_closer_look(&photo, &first), "{first:?}");
    let found = detectors.detect(&photo).unwrap();
    let faces: Vec<&Detection> = found.iter().filter(|found| found.label == "face").collect();
    assert_eq!(faces.len(), 2, "{found:?}");
    let small = faces.iter().find(|face| face.x > 0.6).unwrap();
    // The place of the face in the whole picture of the astronaut.
    let expected =
        [660.0 + 0.339 * 200.0, 100.0 + 0.133 * 200.0, 660.0 + 0.546 * 200.0, 100.0 + 0.34 * 200.0];
    for (found, expected) in corners(small).iter().zip(expected) {
        assert!((found * 900.0 - expected).abs() < 10.0, "{small:?} for {expected}");
    }
    // Without the objects, nothing is searched.
    assert_eq!(detectors.faces.look_closer(&photo, &first, &[]).unwrap(), first);
}

#[test]
fn a_face_that_fills_the_photo_is_found_with_a_margin() {
    let detectors = detectors();
    // The face of the astronaut, cut from the forehead to the chin.
    let astronaut = photo("www/public/samples/19-astronaut.jpg");
    let planes = astronaut
        .planes()
        .iter()
        .map(|plane| inkpanel_engine::raster::Plane::from_fn(112, 112, |x, y| plane.at(x + 170, y + 64)));
    let planes: [_; 3] = planes.collect::<Vec<_>>().try_into().unwrap();
    let photo = Image::from_rgb(planes).unwrap();
    let first = detectors.faces.look(&photo).unwrap();
    assert!(first.is_empty(), "{first:?}");
    let found = detectors.detect(&photo).unwrap();
    let faces: Vec<&Detection> = found.iter().filter(|found| found.label == "face").collect();
    assert!(faces.len() == 1 && faces[0].score > 0.7 && faces[0].height > 0.5, "{faces:?}");
}

#[test]
fn any_picture_gives_boxes_inside_it() {
    let detectors = detectors();
    for (width, height) in [(1, 1), (1, 700), (700, 3), (67, 41)] {
        let plane = inkpanel_engine::raster::Plane::from_fn(width, height, |x, y| (x * 7 + y * 13) as u8);
        let photo = Image::from_rgb([plane.clone(), plane.clone(), plane]).unwrap();
        for found in detectors.detect(&photo).unwrap() {
            assert!(corners(&found).iter().all(|side| (0.0..=1.0).contains(side)), "{found:?}");
        }
    }
}

#[test]
fn another_file_is_no_net() {
    let _ = detectors();
    let faces = fs::read(crate::root("www/models/faces.onnx")).unwrap();
    let cut = &faces[..faces.len() / 2];
    for wrong in [&b"no net"[..], b"", cut] {
        let error = Detectors::new(wrong, wrong).err().unwrap();
        assert_eq!(error.code(), "detector", "{error}");
    }
}

#[test]
fn the_command_answers_in_pixels_and_passes_over_what_is_no_photo() {
    let run =
        |arguments: &[&str]| crate::inkpanel().args(arguments).current_dir(crate::root("")).output().unwrap();
    let answer = run(&["detect", "--json", "Cargo.toml", "www/public/samples/19-astronaut.jpg"]);
    assert!(answer.status.success());
    assert!(String::from_utf8_lossy(&answer.stderr).contains("Cargo.toml"));
    let rows: Value = serde_json::from_slice(&answer.stdout).unwrap();
    assert_eq!(rows.as_array().unwrap().len(), 1);
    assert_eq!(rows[0]["file"], "www/public/samples/19-astronaut.jpg");
    let face = &rows[0]["boxes"][0];
    assert_eq!(face["label"], "face");
    let number = |key: &str| face[key].as_f64().unwrap();
    assert!(
        (number("x") - 0.339 * 512.0).abs() < 3.0 && (number("width") - 0.207 * 512.0).abs() < 3.0,
        "{face}"
    );
    assert!(number("score") > 0.9);
    assert_eq!(run(&["detect", "--json", "Cargo.toml"]).status.code(), Some(1));
    assert_eq!(run(&["detect"]).status.code(), Some(2));
    let elsewhere = run(&["detect", "--models", "src", "www/public/samples/19-astronaut.jpg"]);
    assert_eq!(elsewhere.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&elsewhere.stderr).contains("faces.onnx"));
}

#[test]
fn a_photo_in_a_style_has_its_faces_protected() {
    let folder = tempfile::tempdir().unwrap();
    let drawn = |file: &str, more: &[&str]| {
        let output = folder.path().join("drawn.png");
        let mut command = crate::inkpanel();
        command.args(["stylize", "--style", "lacquer-poster"]).arg(crate::root(file)).args(more);
        assert!(command.arg("-o").arg(&output).output().unwrap().status.success());
        decode(&fs::read(&output).unwrap(), &Limits::default()).unwrap().image
    };
    let face = "www/public/samples/19-astronaut.jpg";
    let (cared, plain) = (drawn(face, &[]), drawn(face, &["--no-detect"]));
    let found: Vec<Detection> = detectors().detect(&photo(face)).unwrap();
    let [left, top, right, bottom] = corners(found.iter().find(|found| found.label == "face").unwrap());
    let at = |x: f64, y: f64| ((x * 512.0) as usize, (y * 512.0) as usize);
    let differ = |(x, y): (usize, usize)| {
        (0..3).any(|c: usize| cared.planes()[c].at(x, y).abs_diff(plain.planes()[c].at(x, y)) > 12)
    };
    let (first, last) = (at(left, top), at(right, bottom));
    let inside = (first.1..last.1).flat_map(|y| (first.0..last.0).map(move |x| (x, y)));
    let changed = inside.clone().filter(|&place| differ(place)).count() as f64 / inside.count() as f64;
    assert!(changed > 0.1, "{changed} of the face");
    // Photos without faces and animals have nothing to protect.
    let nobody = "www/public/samples/15-sunset.jpg";
    assert!(drawn(nobody, &[]) == drawn(nobody, &["--no-detect"]));
}
