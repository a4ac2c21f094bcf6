//! The command line with many files, some of them bad: those are named and left out, the others are done.
#![allow(clippy::unwrap_used, reason = "a test may stop at the first thing that is not as expected")]

#[allow(dead_code, reason = "the example makes more of it")]
#[path = "../examples/hostile/made.rs"]
mod made;

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use made::Tiff;

/// A folder with a photo, tiles in planes that do not divide their image, and files that are no photos.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let sample = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/oracles/data/files/jpeg-444.jpg");
    fs::copy(sample, folder.path().join("good.jpg")).unwrap();
    let tiles = Tiff { tile: Some((16, 16)), planar: true, ..Tiff::rgb(45, 27) };
    fs::write(folder.path().join("tiles.tif"), tiles.file()).unwrap();
    let photo = fs::read(folder.path().join("good.jpg")).unwrap();
    fs::write(folder.path().join("cut.jpg"), &photo[..photo.len() / 2]).unwrap();
    fs::write(folder.path().join("words.png"), "no picture").unwrap();
    fs::write(folder.path().join("empty.gif"), "").unwrap();
    folder
}

fn inkpanel(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_inkpanel")).args(arguments).current_dir(folder).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

const FILES: [&str; 6] = ["cut.jpg", "good.jpg", "words.png", "tiles.tif", "empty.gif", "missing.jpg"];
const BAD: [&str; 4] = ["cut.jpg", "words.png", "empty.gif", "missing.jpg"];

fn check_complaints(output: &Output) {
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}");
    for file in BAD {
        let lines = said.lines().filter(|line| line.contains(file)).count();
        assert_eq!(lines, 1, "{file} is named once: {said}");
    }
    assert!(!said.contains("good.jpg") && !said.contains("panicked"), "{said}");
}

#[test]
fn select_goes_on_without_the_bad_files() {
    let folder = folder();
    let output = inkpanel(folder.path(), &[&["select", "--json"][..], &FILES].concat());
    check_complaints(&output);
    let rows: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let names: Vec<_> = rows.as_array().unwrap().iter().map(|row| row["file"].as_str().unwrap()).collect();
    assert_eq!(names, ["good.jpg", "tiles.tif"]);
}

#[test]
fn render_goes_on_without_the_bad_files() {
    let folder = folder();
    for page in ["page.png", "page.pdf"] {
        let options = ["render", "--no-detect", "--width", "200", "--panels", "2", "-o", page];
        let output = inkpanel(folder.path(), &[&options[..], &FILES].concat());
        check_complaints(&output);
        assert!(fs::metadata(folder.path().join(page)).unwrap().len() > 500);
    }
}

#[test]
fn nothing_left_is_a_failure() {
    let folder = folder();
    for options in [&["select"][..], &["render", "--no-detect", "-o", "page.png"]] {
        let output = inkpanel(folder.path(), &[options, &BAD].concat());
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.contains("there is no usable photo"), "{said}");
        assert!(BAD.iter().all(|file| said.contains(file)), "{said}");
    }
    assert!(!folder.path().join("page.png").exists());
}
