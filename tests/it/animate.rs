//! Animatics: the shot and the camera position of each frame. Command line: the number of frames matches the
//! durations, a shot without camera move is a single picture, and interrupted work resumes. Animated pages:
//! each frame shows the active panel with the text that has appeared so far.

use inkpanel_engine::document::listing::ordered_shots;
use inkpanel_engine::document::saved::Saved;
use inkpanel_engine::framing::{Crop, FACE, Subject};
use inkpanel_engine::native::{self, Photo, Photos};
use inkpanel_engine::output::animatic::{Animatic, Clip, Picture, Request};
use inkpanel_engine::output::motion;
use inkpanel_engine::output::reading::{Reading, Said, Stop};
use inkpanel_engine::output::shots::timecode::Pace;
use inkpanel_engine::output::shots::{ListedShot, ShotList};
use inkpanel_engine::page::Document;
use inkpanel_engine::page::breaking::{breaks, broken};
use inkpanel_engine::page::words::given::GivenFonts;
use inkpanel_engine::page::words::{Letters, TextItem};
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::resize::{Region, resample_image};
use inkpanel_engine::raster::{Image, Matte, Plane};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::fs;
use std::io::{Cursor, Read, Write};
use std::path::{Path, PathBuf};
use std::process::Output;

fn project() -> PathBuf {
    crate::root("tests/data/saved/version-1/storyboard.inkpanel")
}

fn animate(project: &Path, folder: &Path, more: &[&str]) -> Output {
    let mut command = crate::inkpanel();
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
    let shots = ordered_shots(Saved::read(fs::read(project()).unwrap()).unwrap().unwrap().project()).len();
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
    // Lengths in 6 frames at 24 frames per second become frames at 30 per second. The total duration does not
    // change.
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
    assert!(String::from_utf8_lossy(&refused.stderr).contains("page.txt: not an Inkpanel project"));
    assert!(!folder.path().join("frames").exists());
    for wrong in [["--size", "10x10"], ["--fps", "0"], ["--dissolve", "-1"], ["--seconds", "soon"]] {
        let usage = animate(&project(), folder.path(), &wrong);
        assert_eq!(usage.status.code(), Some(2), "{wrong:?}");
    }
    let place = animate(&project(), &file, &SMALL);
    assert_eq!(place.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&place.stderr).contains("page.txt"));
}

/// A page of four panels, with three text items in the first one.
fn page() -> PathBuf {
    crate::root("tests/data/saved/version-1/merged-words.png")
}

const READ: [&str; 8] = ["--pages", "--size", "320x180", "--fps", "10", "--seconds", "0.5", "--json"];

fn as_read(pages: Vec<Document>) -> motion::Request {
    motion::Request { pages, size: [320, 180], fps: 10, seconds: 0.5, dissolve: 0.0, moves: true, living: 0 }
}

fn pages_of(project: &Path) -> Vec<Document> {
    let saved = Saved::read(fs::read(project).unwrap()).unwrap().unwrap();
    saved.pages().0.iter().map(|page| Document::clone(page)).collect()
}

fn plan_of(request: &motion::Request) -> Animatic {
    request.planned(&Letters::bundled().unwrap()).unwrap()
}

/// Renders the page of a clip at the size of the video, with its first `words` text items in reading order.
fn drawn(project: &Path, (clip, page): (&Clip, &Document), words: usize) -> Image {
    let mut document = clip.picture.clone();
    let said = &clip.reading.as_ref().unwrap().said[..words];
    let shown = |(i, word): (usize, &TextItem)| said.iter().any(|said| said.word == i).then(|| word.clone());
    document.words = page.words.iter().enumerate().filter_map(shown).collect();
    let mut saved = Saved::read(fs::read(project).unwrap()).unwrap().unwrap();
    let photo = |id: String| {
        let file = saved.photo_file(&id).unwrap().unwrap();
        (id, Photo::from(decode(&file, &Limits::default()).unwrap().image))
    };
    let photos: Photos = native::photos_of(&document).unwrap().into_iter().map(photo).collect();
    let sheet = native::sheet(&document, &photos, &GivenFonts::default()).unwrap();
    Image::from_interleaved_rgb(sheet.width(), sheet.height(), sheet.rgb()).unwrap()
}

/// The smallest and the largest corner of a panel, in fractions of the page.
fn corners(reading: &Reading, panel: usize) -> [(f64, f64); 2] {
    let ends = |along: &dyn Fn(&(f64, f64)) -> f64| {
        let all = reading.panels[panel].iter().map(along);
        all.fold((1.0_f64, 0.0_f64), |(least, most), at| (least.min(at), most.max(at)))
    };
    let ((left, right), (top, bottom)) = (ends(&|point| point.0), ends(&|point| point.1));
    [(left, top), (right, bottom)]
}

/// Returns the pixels of a frame that show a part of the page: left, top, right and lower edge.
fn pixels_of(frame: &Image, view: &Crop, [from, to]: [(f64, f64); 2]) -> [usize; 4] {
    let at = |place: f64, from: f64, length: f64, side: usize| (place - from) / length * side as f64;
    let (wide, high) = (frame.width(), frame.height());
    [
        at(from.0, view.x, view.width, wide).ceil().max(0.0) as usize,
        at(from.1, view.y, view.height, high).ceil().max(0.0) as usize,
        at(to.0, view.x, view.width, wide).floor().min(wide as f64) as usize,
        at(to.1, view.y, view.height, high).floor().min(high as f64) as usize,
    ]
}

/// Returns the mean difference, of 255, between a part of the page in a frame and on the page.
fn difference(frame: &Image, page: &Image, view: &Crop, part: [(f64, f64); 2]) -> f64 {
    let [left, top, right, bottom] = pixels_of(frame, view, part);
    let (width, height) = (right - left, bottom - top);
    assert!(width > 40 && height > 40, "{width} x {height}");
    let (across, down) = (view.width / frame.width() as f64, view.height / frame.height() as f64);
    let (wide, high) = (page.width() as f64, page.height() as f64);
    let region = Region {
        x: (view.x + left as f64 * across) * wide,
        y: (view.y + top as f64 * down) * high,
        width: width as f64 * across * wide,
        height: height as f64 * down * high,
    };
    let expected = resample_image(page, region, width, height);
    let shown = Region { x: left as f64, y: top as f64, width: width as f64, height: height as f64 };
    let shown = resample_image(frame, shown, width, height).to_rgb();
    let sum: u32 = shown.iter().zip(expected.to_rgb()).map(|(a, b)| u32::from(a.abs_diff(b))).sum();
    f64::from(sum) / shown.len() as f64
}

fn picture(file: &[u8]) -> Image {
    decode(file, &Limits::default()).unwrap().image
}

#[test]
fn pages_are_read_as_the_plan_of_the_page_says() {
    for (project, more, dissolve) in
        [(project(), &["--dissolve", "0.4"][..], 0.4), (page(), &["--still"], 0.0)]
    {
        let request = motion::Request { dissolve, moves: dissolve > 0.0, ..as_read(pages_of(&project)) };
        let plan = plan_of(&request);
        let folder = tempfile::tempdir().unwrap();
        let made = done(&animate(&project, folder.path(), &[&READ[..], more].concat()));
        assert_eq!(frames(folder.path()).len(), plan.frames as usize);
        assert_eq!(
            (&made["frames"], &made["fps"], &made["width"]),
            (&plan.frames.into(), &10.into(), &320.into())
        );
        let pages = made["pages"].as_array().unwrap();
        assert_eq!(pages.len(), plan.clips.len());
        for (i, (told, clip)) in pages.iter().zip(&plan.clips).enumerate() {
            let reading = clip.reading.as_ref().unwrap();
            let stop = |stop: &Stop| {
                json!({
                    "panel": stop.panel.map(|panel| panel + 1), "first": stop.from + 1,
                    "frames": stop.to - stop.from, "from": stop.first, "to": stop.last,
                })
            };
            let word = |said: &Said| json!({ "word": said.word + 1, "panel": said.panel + 1, "first": said.from + 1 });
            let expected = json!({
                "page": i + 1, "first": clip.start + 1, "frames": clip.frames,
                "stops": reading.stops.iter().map(stop).collect::<Vec<_>>(),
                "words": reading.said.iter().map(word).collect::<Vec<_>>(),
            });
            assert_eq!(told, &expected);
        }
    }
}

#[test]
fn the_camera_shows_the_panel_that_is_read_and_veils_the_others() {
    let (folder, document) = (tempfile::tempdir().unwrap(), &pages_of(&page())[0]);
    done(&animate(&page(), folder.path(), &READ));
    let files = frames(folder.path());
    let clip = &plan_of(&as_read(pages_of(&page()))).clips[0];
    let reading = clip.reading.as_ref().unwrap();
    let whole = drawn(&page(), (clip, document), 3);
    for (i, stop) in reading.stops.iter().enumerate() {
        let frame = picture(&files[stop.to as usize - 1]);
        let Some(panel) = stop.panel else {
            // At the beginning, no text is visible.
            let shown = if i == 0 { &drawn(&page(), (clip, document), 0) } else { &whole };
            assert!(difference(&frame, shown, &stop.last, [(0.0, 0.0), (1.0, 1.0)]) < 0.3);
            continue;
        };
        let part = corners(reading, panel);
        let away = difference(&frame, &whole, &stop.last, part);
        assert!(away < 0.3, "panel {panel}: {away}");
        // The panel fills most of the frame, and its surroundings are dark. One text item of the first panel
        // extends beyond it.
        let [left, top, right, bottom] = pixels_of(&frame, &stop.last, part);
        assert!(right - left > 160 || bottom - top > 120, "{left} {top} {right} {bottom}");
        let beside = |x: usize, y: usize| x + 1 < left || x > right || y + 1 < top || y > bottom;
        let bright = (0..180)
            .flat_map(|y| (0..320).map(move |x| (x, y)))
            .filter(|&(x, y)| beside(x, y) && frame.planes().iter().any(|plane| plane.at(x, y) > 75));
        assert!(panel == 0 || bright.count() == 0, "panel {panel}");
    }
    // On its way no frame is as the one before.
    let [from, to] = [reading.stops[1].to as usize - 1, reading.stops[2].from as usize];
    assert!(to - from > 5 && (from..to).all(|i| files[i] != files[i + 1]));
}

#[test]
fn words_appear_in_their_time_and_frames_without_a_change_are_one_picture() {
    let (folder, document) = (tempfile::tempdir().unwrap(), &pages_of(&page())[0]);
    done(&animate(&page(), folder.path(), &[&READ[..], &["--still"]].concat()));
    let files = frames(folder.path());
    let clip = &plan_of(&motion::Request { moves: false, ..as_read(pages_of(&page())) }).clips[0];
    let reading = clip.reading.as_ref().unwrap();
    let stop = &reading.stops[1];
    let part = corners(reading, 0);
    assert_eq!(reading.said.len(), 3);
    for (i, said) in reading.said.iter().enumerate() {
        let from = said.from as usize;
        let [before, after] = [i, i + 1].map(|words| drawn(&page(), (clip, document), words));
        let away = |frame: usize, page: &Image| difference(&picture(&files[frame]), page, &stop.first, part);
        assert!(away(from - 1, &before) < 0.3 && away(from - 1, &after) > 0.5, "word {i}");
        // It is there within a fifth of a second, at first in part.
        assert!(away(from, &before) > 0.2 && away(from, &after) > 0.2, "word {i}");
        assert!(away(from + 1, &after) < 0.3, "word {i}");
        assert_eq!(files[from + 1], files[from + 2]);
    }
}

#[test]
fn pages_that_were_stopped_go_on_and_progress_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let how = [&READ[..], &["--skip-existing"]].concat();
    done(&animate(&page(), folder.path(), &how));
    let files = frames(folder.path());
    fs::remove_file(folder.path().join("frame-00020.png")).unwrap();
    fs::write(folder.path().join("frame-00001.png"), b"mine").unwrap();
    let again = animate(&page(), folder.path(), &how);
    done(&again);
    let made = frames(folder.path());
    assert_eq!((&made[0][..], &made[1..]), (&b"mine"[..], &files[1..]));
    let steps: Vec<Value> = String::from_utf8_lossy(&again.stderr)
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let panels: Vec<&Value> = steps.iter().map(|step| &step["panel"]).collect();
    assert_eq!(panels, [&Value::Null, &1.into(), &2.into(), &3.into(), &4.into(), &Value::Null]);
    let skipped: u64 = steps.iter().map(|step| step["skipped"].as_u64().unwrap()).sum();
    assert_eq!((skipped, &steps[5]["frames"]), (files.len() as u64 - 1, &files.len().into()));
}

#[test]
fn what_pages_do_not_have_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let frames = folder.path().join("frames");
    for (more, why) in [
        (&["--captions"][..], "--captions cannot be combined"),
        (&["--style", "noir"], "--style cannot be combined"),
        (&["--seconds", "61"], "--seconds is at most 60 with --pages"),
        (&["--dissolve", "1.5"], "--dissolve is at most 1 with --pages"),
    ] {
        let refused = animate(&page(), &frames, &[&["--pages"], more].concat());
        let said = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert_eq!(refused.status.code(), Some(1), "{said}");
        assert!(said.contains(why), "{said}");
    }
    let empty = changed(folder.path(), |project| {
        let present = &mut project["history"]["present"];
        for (field, value) in [("page", Value::Null), ("others", json!([])), ("at", 0.into())] {
            present[field] = value;
        }
    });
    let refused = animate(&empty, &frames, &["--pages"]);
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(refused.status.code() == Some(1) && said.contains("the project has no pages"), "{said}");
    assert!(!frames.exists());
}

#[test]
fn panels_that_move_in_the_page_are_told_to_stand_still() {
    let folder = tempfile::tempdir().unwrap();
    let of_film = changed(folder.path(), |project| {
        let shown = project["history"]["present"]["page"]["panels"][0]["photo"].clone();
        let photos = project["photos"].as_array_mut().unwrap();
        let photo = photos.iter_mut().find(|photo| photo["id"] == shown).unwrap();
        photo["video"] = "film".into();
        photo["time"] = 1.5.into();
        project["videos"] = json!([{
            "key": "film", "name": "cat.mp4", "path": "videos/001-cat.mp4", "type": "video/mp4", "ids": [shown],
            "duration": 10, "start": 0, "end": null,
        }]);
    });
    for (more, what) in [(&READ[..], "1 panel is"), (&SMALL[..], "1 shot is")] {
        let made = animate(&of_film, &folder.path().join(what), &[more, &["--still"]].concat());
        done(&made);
        let said = String::from_utf8_lossy(&made.stderr).into_owned();
        assert!(said.contains(&format!("{what} a video frame; here it does not move")), "{said}");
    }
    let plain = animate(&project(), &folder.path().join("plain"), &READ);
    done(&plain);
    assert!(!String::from_utf8_lossy(&plain.stderr).contains("does not move"));
}

#[test]
fn a_figure_that_steps_out_is_read_with_its_panel() {
    let shares =
        Plane::from_fn(90, 60, |x, y| if (x as f64 - 44.5).hypot(y as f64 - 29.5) < 25.0 { 255 } else { 0 });
    let mask = Matte::new(&shares, (900, 600));
    let mut stepping = None;
    let films = [true, false].map(|steps| {
        let folder = tempfile::tempdir().unwrap();
        let project = changed(folder.path(), |project| {
            let page = &mut project["history"]["present"]["page"];
            let document = Document::parse(&page.to_string()).unwrap();
            let found = (0..document.panels.len()).find_map(|panel| {
                let out = broken(&document, panel, &mask).unwrap()?;
                breaks(&out).unwrap()[panel].then_some((panel, out))
            });
            let (panel, mut out) = found.unwrap();
            if !steps {
                out.panels[panel].figure = None;
            }
            *page = serde_json::from_str(&out.to_json()).unwrap();
            stepping = Some(panel);
        });
        let made = folder.path().join("frames");
        done(&animate(&project, &made, &READ));
        (folder, project, frames(&made))
    });
    let panel = stepping.unwrap();
    let [(_folder, project, files), (_other, _, without)] = &films;
    let pages = pages_of(project);
    let plan = plan_of(&as_read(pages.clone()));
    let found = pages.iter().zip(&plan.clips).find(|(page, _)| page.breaks_frame(panel));
    let (document, clip) = found.unwrap();
    let whole = drawn(project, (clip, document), 0);
    for stop in &clip.reading.as_ref().unwrap().stops {
        let [frame, kept] = [files, without].map(|files| picture(&files[stop.to as usize - 1]));
        if stop.panel.is_none() {
            let all = [(0.0, 0.0), (1.0, 1.0)];
            assert!(difference(&frame, &whole, &stop.last, all) < 0.3);
            assert!(difference(&kept, &whole, &stop.last, all) > 0.6);
        } else if stop.panel == Some(panel) {
            // Everything outside the panel is dimmed, except its subject.
            let bright = |image: &Image, x, y| image.planes().iter().any(|plane| plane.at(x, y) > 100);
            let pixels = (0..180).flat_map(|y| (0..320).map(move |x| (x, y)));
            let lit = pixels.filter(|&(x, y)| bright(&frame, x, y) && !bright(&kept, x, y)).count();
            assert!(lit > 30, "{lit}");
        }
    }
}

/// Returns the saved project with a change.
fn changed(folder: &Path, change: impl FnOnce(&mut Value)) -> PathBuf {
    let mut archive = zip::ZipArchive::new(fs::File::open(project()).unwrap()).unwrap();
    let mut writer = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let mut change = Some(change);
    for i in 0..archive.len() {
        let mut entry = archive.by_index(i).unwrap();
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes).unwrap();
        if entry.name() == "project.json" {
            let mut value: Value = serde_json::from_slice(&bytes).unwrap();
            change.take().unwrap()(&mut value);
            bytes = value.to_string().into_bytes();
        }
        writer.start_file(entry.name(), zip::write::SimpleFileOptions::default()).unwrap();
        writer.write_all(&bytes).unwrap();
    }
    let path = folder.join("changed.inkpanel");
    fs::write(&path, writer.finish().unwrap().into_inner()).unwrap();
    path
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
    Subject {
        x,
        y,
        width: side,
        height: side,
        label: label.into(),
        score: 0.9,
        points: None,
        expression: None,
        light: None,
    }
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
        style: "storyboard".into(),
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
    // A requested rate is used.
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
        let seen = clip.picture.panels[0].crop.unwrap();
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
    // Camera moves in, out, and along a panel without people.
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
        assert_eq!((clip.picture.page.width, clip.picture.page.height), (1920, 1080));
        assert_eq!(clip.caption, None);
    }
    let plan = Request { captions: true, ..request(&[None]) }.planned().unwrap();
    assert_eq!(plan.clips[0].caption.as_ref().unwrap().words[0].text, "Who is there?");
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
