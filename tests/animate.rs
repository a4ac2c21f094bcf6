//! Animatics on the command line: the frames are as many as the shots are long, a shot without a move is one picture, and work
//! that was stopped goes on.
#![allow(clippy::unwrap_used, reason = "a test may stop at the first thing that is not as expected")]

use inkpanel::document::saved::Saved;
use inkpanel::raster::decode::{Limits, decode};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn project() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/saved/version-1/storyboard.inkpanel")
}

fn animate(project: &Path, folder: &Path, more: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_inkpanel"));
    command.arg("animate").arg(project).args(more).arg("-o").arg(folder).output().unwrap()
}

fn done(output: Output) -> Value {
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{said}");
    for line in said.lines() {
        assert!(serde_json::from_str::<Value>(line).is_ok(), "{line}");
    }
    serde_json::from_slice(&output.stdout).unwrap()
}

fn frames(folder: &Path) -> Vec<Vec<u8>> {
    let mut names: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    names.sort();
    for (i, name) in names.iter().enumerate() {
        assert_eq!(name.file_name().unwrap().to_str().unwrap(), format!("frame-{:05}.png", i + 1));
    }
    names.iter().map(|name| fs::read(name).unwrap()).collect()
}

const SMALL: [&str; 5] = ["--size", "160x90", "--seconds", "0.25", "--json"];

#[test]
fn there_are_as_many_frames_as_the_shots_are_long_and_still_ones_are_one_picture() {
    let shots = Saved::read(fs::read(project()).unwrap()).unwrap().unwrap().project().shots().len();
    let folder = tempfile::tempdir().unwrap();
    let made = done(animate(&project(), folder.path(), &[&SMALL[..], &["--still", "--fps", "24"]].concat()));
    let files = frames(folder.path());
    assert_eq!((files.len(), &made["frames"], &made["fps"]), (6 * shots, &(6 * shots).into(), &24.into()));
    for (i, file) in files.iter().enumerate() {
        assert_eq!(file, &files[i / 6 * 6], "frame {i}");
    }
    assert_ne!(files[0], files[6]);
    let image = decode(&files[0], &Limits::default()).unwrap().image;
    assert_eq!((image.width(), image.height()), (160, 90));
}

#[test]
fn moves_dissolves_and_captions_change_the_frames_the_same_way_each_time() {
    let (one, other) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let how = [&SMALL[..], &["--dissolve", "0.1", "--captions", "--fps", "30"]].concat();
    let made = done(animate(&project(), one.path(), &how));
    done(animate(&project(), other.path(), &how));
    let files = frames(one.path());
    assert_eq!(files, frames(other.path()));
    assert_eq!(made["frames"], files.len());
    // Lengths at 24 a second, 6 frames each, at 30: the whole is as long as it was.
    let shots = made["shots"].as_array().unwrap();
    assert_eq!(files.len(), (shots.len() * 6 * 30).div_ceil(24));
    assert!(shots.iter().any(|shot| shot["from"] != shot["to"]));
    assert_ne!(files[0], files[1]);
}

#[test]
fn what_is_there_stays_when_it_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let how = [&SMALL[..], &["--still", "--skip-existing"]].concat();
    done(animate(&project(), folder.path(), &how));
    let files = frames(folder.path());
    fs::remove_file(folder.path().join("frame-00008.png")).unwrap();
    fs::write(folder.path().join("frame-00001.png"), b"mine").unwrap();
    done(animate(&project(), folder.path(), &how));
    let again = frames(folder.path());
    assert_eq!(again[0], b"mine");
    assert_eq!(again[1..], files[1..]);
}

#[test]
fn what_is_no_project_or_no_size_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("page.txt");
    fs::write(&file, "no project").unwrap();
    let refused = animate(&file, &folder.path().join("frames"), &[]);
    assert_eq!(refused.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("page.txt: this is no project of Inkpanel"));
    assert!(!folder.path().join("frames").exists());
    for wrong in [["--size", "10x10"], ["--fps", "0"], ["--dissolve", "-1"], ["--seconds", "soon"]] {
        let usage = animate(&project(), folder.path(), &wrong);
        assert_eq!(usage.status.code(), Some(2), "{wrong:?}");
    }
    let place = animate(&project(), &file, &SMALL);
    assert_eq!(place.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&place.stderr).contains("page.txt"));
}
