//! Animatics: which frame shows which shot, and how the camera moves; and on the command line, that the frames are as many as
//! the shots are long, that a shot without a move is one picture, and that work that was stopped goes on.
#![allow(clippy::unwrap_used, reason = "a test may stop at the first thing that is not as expected")]

use inkpanel::document::saved::Saved;
use inkpanel::framing::{Crop, FACE, Subject};
use inkpanel::output::animatic::{Animatic, Picture, Request};
use inkpanel::output::shots::timecode::Pace;
use inkpanel::output::shots::{ListedShot, ShotList};
use inkpanel::raster::decode::{Limits, decode};
use proptest::prelude::*;
use serde_json::{Value, json};
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

fn done(output: &Output) -> Value {
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
    let made = done(&animate(&project(), folder.path(), &[&SMALL[..], &["--still", "--fps", "24"]].concat()));
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
    let made = done(&animate(&project(), one.path(), &how));
    done(&animate(&project(), other.path(), &how));
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
    done(&animate(&project(), folder.path(), &how));
    let files = frames(folder.path());
    fs::remove_file(folder.path().join("frame-00008.png")).unwrap();
    fs::write(folder.path().join("frame-00001.png"), b"mine").unwrap();
    done(&animate(&project(), folder.path(), &how));
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

#[test]
fn the_table_of_all_frames_says_what_each_of_them_shows() {
    let request = Request { dissolve: 0.5, moves: true, ..request(&[Some(24), None, Some(5)]) };
    let plan = request.planned().unwrap();
    let table = plan.table();
    assert_eq!(table.len(), plan.frames as usize * Animatic::COLUMNS);
    for (frame, row) in table.chunks(Animatic::COLUMNS).enumerate() {
        let (under, over) = plan.at(frame as u32).unwrap();
        assert_eq!(row[0] as usize, under.clip);
        let near = |value: f32, expected: f64| (f64::from(value) - expected).abs() < 1e-6;
        assert!(near(row[1], under.view.x) && near(row[4], under.view.height), "frame {frame}");
        assert_eq!(row[5] < 0.0, over.is_none(), "frame {frame}");
        if let Some(over) = over {
            assert_eq!(row[5] as usize, over.clip);
            assert!(near(row[6], over.view.x) && near(row[8], over.view.width) && near(row[10], over.share));
        }
    }
    assert!(table.chunks(Animatic::COLUMNS).any(|row| row[5] >= 0.0));
}

fn subject(label: &str, x: f64, y: f64, side: f64) -> Subject {
    Subject { x, y, width: side, height: side, label: label.into(), score: 0.9 }
}

fn request(lengths: &[Option<u32>]) -> Request {
    let shot = |(i, &frames): (usize, &Option<u32>)| ListedShot {
        number: (i + 1).to_string(),
        frames,
        dialogue: "Who is there?".into(),
        ..ListedShot::default()
    };
    let picture = |i: usize| Picture {
        photo: format!("p{i}"),
        crop: Crop { x: 0.0, y: 0.1, width: 1.0, height: 0.75 },
        faces: Vec::new(),
        subjects: Vec::new(),
    };
    Request {
        list: ShotList {
            fps: 24,
            shots: lengths.iter().enumerate().map(shot).collect(),
            ..ShotList::default()
        },
        pictures: (0..lengths.len()).map(picture).collect(),
        size: [1920, 1080],
        style: json!("storyboard"),
        ..Request::default()
    }
}

#[test]
fn it_is_as_long_as_its_shots_whatever_the_rate() {
    let lengths = [Some(36), None, Some(1), Some(49), Some(24)];
    for (fps, frames) in [(0, 158), (24, 158), (25, 165), (30, 198)] {
        let plan = Request { fps, dissolve: 0.5, ..request(&lengths) }.planned().unwrap();
        assert_eq!(plan.frames, frames, "{fps}");
        assert_eq!(plan.clips.iter().map(|clip| clip.frames).sum::<u32>(), frames);
        assert!(plan.at(frames - 1).is_some() && plan.at(frames).is_none());
    }
}

#[test]
fn frames_of_a_slower_second_are_as_many_and_pass_as_slowly() {
    let mut request = request(&[Some(24), Some(24)]);
    request.list.pace = Pace::Ntsc;
    let plan = request.planned().unwrap();
    assert_eq!((plan.fps, plan.frames), (24, 48));
    assert!((plan.rate - 24_000.0 / 1001.0).abs() < 1e-9);
    // Who asks for a rate gets it.
    let plan = Request { fps: 12, ..request }.planned().unwrap();
    assert_eq!((plan.frames, plan.rate.to_bits()), (24, 12f64.to_bits()));
}

#[test]
fn a_cut_shows_one_shot_and_a_dissolve_goes_over_evenly() {
    let plan = request(&[Some(24), Some(24)]).planned().unwrap();
    let clips: Vec<usize> = (0..48).map(|frame| plan.at(frame).unwrap().0.clip).collect();
    assert_eq!(clips, [[0; 24], [1; 24]].concat());
    assert!((0..48).all(|frame| plan.at(frame).unwrap().1.is_none()));
    let plan = Request { dissolve: 0.5, ..request(&[Some(24), Some(24)]) }.planned().unwrap();
    let shares: Vec<f64> =
        (0..48).filter_map(|frame| plan.at(frame).unwrap().1).map(|over| over.share).collect();
    assert_eq!((shares.len(), plan.clips[1].from, plan.clips[0].to), (12, 18, 30));
    assert!((0..12).all(|i| (shares[i] - (i as f64 + 1.0) / 13.0).abs() < 1e-12), "{shares:?}");
}

#[test]
fn the_camera_keeps_faces_and_stays_inside_of_the_crop() {
    let mut request = Request { moves: true, ..request(&[Some(96), Some(96), Some(96)]) };
    request.pictures[0].subjects = vec![subject(FACE, 0.75, 0.15, 0.1), subject("car", 0.1, 0.2, 0.2)];
    request.pictures[1].subjects = vec![subject(FACE, 0.02, 0.5, 0.2), subject(FACE, 0.8, 0.2, 0.15)];
    let plan = request.planned().unwrap();
    for (clip, picture) in plan.clips.iter().zip(&request.pictures) {
        let page = &clip.picture["panels"][0]["crop"];
        let seen: Crop = serde_json::from_value(page.clone()).unwrap();
        for frame in clip.from..clip.to {
            let view = clip.view(frame);
            let of = |part: f64, from: f64, length: f64| from + part * length;
            let (left, top) = (of(view.x, seen.x, seen.width), of(view.y, seen.y, seen.height));
            let (right, bottom) = (left + view.width * seen.width, top + view.height * seen.height);
            assert!(left > -1e-6 && right < 1.0 + 1e-6 && top > 0.1 - 1e-6 && bottom < 0.85 + 1e-6);
            for face in picture.subjects.iter().filter(|subject| subject.label == FACE) {
                assert!(left <= face.x + 1e-6 && right >= face.x + face.width - 1e-6, "{frame}");
                assert!(top <= face.y + 1e-6 && bottom >= face.y + face.height - 1e-6, "{frame}");
            }
            assert!((right - left) / (bottom - top) > 1.32 && (right - left) / (bottom - top) < 1.35);
        }
    }
    // In, out, and along where there is nobody.
    let [first, second, third] = &plan.clips[..] else { panic!() };
    assert!(first.last.width < first.first.width && third.first.x < third.last.x);
    assert!(second.first.width <= second.last.width);
    assert!((third.first.width - third.last.width).abs() < 1e-12);
}

#[test]
fn without_a_move_a_picture_is_a_frame() {
    let plan = request(&[None, None]).planned().unwrap();
    let whole = Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };
    for clip in &plan.clips {
        assert_eq!((clip.first, clip.last), (whole, whole));
        assert_eq!(
            (&clip.picture["page"]["width"], &clip.picture["page"]["height"]),
            (&json!(1920), &json!(1080))
        );
        assert!(clip.caption.is_null());
    }
    let plan = Request { captions: true, ..request(&[None]) }.planned().unwrap();
    assert_eq!(plan.clips[0].caption["words"][0]["text"], "Who is there?");
}

#[test]
fn what_cannot_be_is_refused() {
    let refused = |request: Request| request.planned().is_err();
    assert!(refused(request(&[])));
    assert!(refused(Request { pictures: Vec::new(), ..request(&[None]) }));
    assert!(refused(Request { size: [0, 1080], ..request(&[None]) }));
    assert!(refused(Request { size: [1920, 5000], ..request(&[None]) }));
    assert!(refused(Request { fps: 61, ..request(&[None]) }));
    assert!(refused(request(&[Some(u32::MAX)])));
    assert!(Request::parse("{\"fps\":-1}").is_err());
}

proptest! {
    #[test]
    fn every_frame_has_its_shot(
        lengths in prop::collection::vec(prop::option::of(1u32..60), 1..12),
        (fps, dissolve, moves) in (prop::sample::select(vec![24u32, 25, 30, 60, 1]), 0.0f64..3.0, any::<bool>()),
    ) {
        let plan = Request { fps, dissolve, moves, ..request(&lengths) }.planned().unwrap();
        let mut end = 0;
        for clip in &plan.clips {
            prop_assert_eq!(clip.start, end);
            prop_assert!(clip.frames > 0 && clip.from <= clip.start && clip.to >= clip.start + clip.frames);
            end = clip.start + clip.frames;
        }
        prop_assert_eq!(plan.frames, end);
        for frame in 0..plan.frames {
            let (under, over) = plan.at(frame).unwrap();
            for shown in [Some(under), over].into_iter().flatten() {
                let (clip, view) = (&plan.clips[shown.clip], shown.view);
                prop_assert!((clip.from..clip.to).contains(&frame));
                prop_assert!(shown.share > 0.0 && shown.share <= 1.0);
                prop_assert!(view.x > -1e-9 && view.x + view.width < 1.0 + 1e-9);
            }
            if let Some(over) = over {
                prop_assert!(over.clip == under.clip + 1 && over.share < 1.0);
            }
        }
    }
}
