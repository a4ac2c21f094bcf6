//! Shot lists: `OpenTimelineIO` reads the same shots in them, to the frame (`tests/oracles/shots.py`), and
//! they match the saved project.

use inkpanel_engine::document::file::ProjectFile;
use inkpanel_engine::document::listing::shot_list;
use inkpanel_engine::output::shots::timecode::{Pace, Rate, StartTimecode};
use inkpanel_engine::output::shots::{Film, Kind, ListedShot, ShotList};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Rates of boards, each with the name of its files.
const RATES: [(&str, u32, Pace); 6] = [
    ("24", 24, Pace::Clock),
    ("25", 25, Pace::Clock),
    ("30", 30, Pace::Clock),
    ("23.976", 24, Pace::Ntsc),
    ("29.97", 30, Pace::Ntsc),
    ("29.97drop", 30, Pace::Drop),
];

fn folder() -> PathBuf {
    crate::root("tests/oracles/data/shots")
}

/// Pictures, three with one name, and positions in videos. Two have lengths that end between two seconds, two
/// have one name, and two are from cameras with a timecode.
fn list((fps, pace): (u32, Pace)) -> ShotList {
    let film = |key: &str, name: &str, time, length| {
        let start = match key {
            "clip" => StartTimecode::parse("10:00:59;20", 30),
            "a" => StartTimecode::parse("09:59:59:12", 25),
            _ => None,
        };
        Some(Film { key: key.into(), name: name.into(), time, length: Some(length), timecode: start })
    };
    let night = |time| film("night", "Nacht & Tag.mp4", time, 7_261.44);
    let clip = |time| film("clip", "clip.mov", time, 7_261.44);
    let card = |key, time| film(key, "C0001.MP4", time, 2.0);
    let shot = |i: usize, film: Option<Film>| ListedShot {
        number: format!("{}{}", i / 2 + 1, if i % 2 == 1 { "A" } else { "" }),
        scene: ["1", "Küche", ""][i % 3].into(),
        action: "She opens the \"door\",\nlooks out & waits.".into(),
        dialogue: ["", "Hallo? <niemand>"][i % 2].into(),
        notes: ["dusk", "=1+1", ""][i % 3].into(),
        frames: [Some(1), Some(37), None, Some(fps), Some(fps * 61 + 7)][i % 5],
        more: BTreeMap::from([("Lens".into(), "35 mm".into())]),
        name: if i < 10 { format!("photo {i}.jpg") } else { "IMG_0001.jpg".into() },
        film,
        ..ListedShot::default()
    };
    let films = [
        None,
        night(0.0),
        night(3_599.98),
        clip(12.345),
        None,
        clip(1.0 / 3.0),
        night(7_200.04),
        card("a", 0.96),
        card("b", 1.2),
        card("a", 0.0),
        None,
        None,
        None,
    ];
    let shots = films.into_iter().enumerate().map(|(i, film)| shot(i, film)).collect();
    ShotList { title: "Abend".into(), fps, pace, columns: vec!["Lens".into()], headings: Vec::new(), shots }
}

/// Its files by their names.
fn files() -> impl Iterator<Item = (String, (u32, Pace), String)> {
    let all = RATES.into_iter().flat_map(|rate| Kind::ALL.map(|(ending, kind)| (rate, ending, kind)));
    all.map(|((name, fps, pace), ending, kind)| {
        (format!("list-{name}.{ending}"), (fps, pace), list((fps, pace)).written(kind))
    })
}

fn is_edl(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|ending| ending == "edl")
}

/// `cargo xtask bless shots` updates them. Then `tests/oracles/shots.py` reads them.
#[test]
fn lists_are_those_that_were_read() {
    for (name, _, text) in files() {
        let path = folder().join(&name);
        let found = fs::read_to_string(&path).unwrap_or_default();
        if std::env::var_os("BLESS").is_some() && found != text {
            fs::create_dir_all(folder()).unwrap();
            fs::write(path, text).unwrap();
            continue;
        }
        assert_eq!(
            found, text,
            "{name}: `cargo xtask bless shots` writes it anew, then run tests/oracles/shots.py"
        );
    }
}

#[test]
fn other_programs_read_every_length_and_place_to_the_frame() {
    let told = fs::read_to_string(folder().with_extension("json")).unwrap();
    let told: BTreeMap<String, Vec<Value>> = serde_json::from_str(&told).unwrap();
    let mut compared = 0;
    for (name, rate, _) in files().filter(|(name, ..)| told.contains_key(name)) {
        let list = list(rate);
        let mut at = 0;
        let read = &told[&name];
        assert_eq!(read.len(), list.shots.len(), "{name}");
        for (shot, read) in list.shots.iter().zip(read) {
            let counted = Rate { base: rate.0, pace: rate.1 };
            let wanted = u64::from(shot.frames.unwrap_or(2 * rate.0));
            let [start, frames, length, origin] = match &shot.film {
                None => [0, wanted, wanted, 0],
                Some(film) => {
                    let length = (film.length.unwrap() * counted.exact() + 0.1).floor() as u64;
                    let start = counted.frame_at(film.time);
                    let origin = film.timecode.map_or(0, |code| code.frame_in(code.counting_at(counted)));
                    [start, wanted.min(length - start), length, origin]
                }
            };
            let file = shot.film.as_ref().map_or(&shot.name, |film| &film.name);
            let mut expected = json!({ "start": origin + start, "frames": frames, "at": at, "media": file });
            // An EDL does not contain the length of its sources.
            if !is_edl(&name) {
                expected["available"] = json!([origin, length]);
            }
            let mut plain = read.clone();
            plain.as_object_mut().unwrap().remove("source");
            assert_eq!(plain, expected, "{name}");
            at += frames;
            compared += 1;
        }
    }
    assert_eq!(compared, 6 * 3 * 13);
}

/// `source` is what tells files apart: the reel of a decision list, the address of a file in the others.
#[test]
fn other_programs_distinguish_files_of_one_name() {
    let told = fs::read_to_string(folder().with_extension("json")).unwrap();
    let told: BTreeMap<String, Vec<Value>> = serde_json::from_str(&told).unwrap();
    let reels = ["AX", "NACHTTAG", "NACHTTAG", "CLIP", "AX", "CLIP", "NACHTTAG", "C0001", "C00012", "C0001"];
    for (name, read) in &told {
        let of = |i: usize| read[i]["source"].as_str().unwrap();
        let sources: Vec<&str> = (0..13).map(of).collect();
        if is_edl(name) {
            assert_eq!(sources[..10], reels, "{name}");
            assert_eq!(sources[10..], ["AX", "IMG0001", "IMG00012"], "{name}");
        } else {
            assert_eq!(sources[7..10], ["C0001.MP4", "2/C0001.MP4", "C0001.MP4"], "{name}");
            assert_eq!(sources[10..], ["IMG_0001.jpg", "2/IMG_0001.jpg", "3/IMG_0001.jpg"], "{name}");
        }
    }
}

/// Timecodes of frames from `OpenTimelineIO`, and the frames that it reads in them
/// (`tests/oracles/shots.py`).
#[test]
fn time_codes_are_those_of_another_program() {
    let told = fs::read_to_string(folder().with_file_name("timecodes.json")).unwrap();
    let told: BTreeMap<String, Vec<(u64, String)>> = serde_json::from_str(&told).unwrap();
    assert_eq!(told.len(), RATES.len());
    for (name, base, pace) in RATES {
        let rate = Rate { base, pace };
        assert!(told[name].len() > 400, "{name}");
        for (frame, code) in &told[name] {
            assert_eq!(rate.timecode(*frame), *code, "{name}, frame {frame}");
        }
    }
}

#[test]
fn a_saved_project_tells_its_shots_in_their_order_with_their_films() {
    let panels = json!([{ "photo": "a" }, {}, {}, {}]);
    let tray = json!([
        { "id": "a", "shot": { "action": "Enters.", "frames": 12, "more": { "Lens": "35" } } }, { "id": "b", "use": true },
        { "id": "c", "use": false }, { "id": "d" }, { "id": "e", "use": true, "shot": { "number": "1B" } },
    ]);
    let word = |kind: &str, text: &str| json!({ "kind": kind, "text": text, "panel": 0 });
    let words = [word("caption", "Later"), word("balloon", "*Who* is it?"), word("effect", "BANG")];
    let page = json!({ "version": 1, "seed": 1, "layout": "grid-4", "style": "comic", "panels": panels, "words": words });
    let photo = |id: &str, rank: u64| json!({ "id": id, "name": format!("{id}.jpg"), "path": format!("photos/{id}.jpg"), "rank": rank });
    let mut photos = json!([photo("a", 3), photo("b", 1), photo("c", 0), photo("d", 2), photo("e", 4)]);
    photos[1]["video"] = json!("v");
    photos[1]["time"] = json!(2.5);
    let project = json!({
        "format": "inkpanel", "version": 1, "photos": photos,
        "videos": [{ "key": "v", "name": "film.mp4", "path": "film.mp4", "ids": ["b"], "duration": 60, "timecode": { "frame": 900_000, "fps": 25 } }],
        "history": { "present": { "name": "N", "tray": tray, "page": page, "board": { "fps": 25, "columns": ["Lens"], "order": ["e", "b"] } } },
    });
    let list = shot_list(&ProjectFile::parse(&project.to_string()).unwrap());
    let told: Vec<_> = list.shots.iter().map(|shot| (shot.name.as_str(), shot.number.as_str())).collect();
    // `a` is on the page, `d` is not, and `c` is excluded. Moved shots keep their order.
    assert_eq!(told, [("a.jpg", "1"), ("e.jpg", "1B"), ("b.jpg", "2")]);
    let film = Film {
        key: "v".into(),
        name: "film.mp4".into(),
        time: 2.5,
        length: Some(60.0),
        timecode: Some(StartTimecode { frame: 900_000, fps: 25, drop: false }),
    };
    assert_eq!((list.shots[2].film.as_ref(), list.shots[0].frames, list.fps), (Some(&film), Some(12), 25));
    assert_eq!(list.shots[0].more["Lens"], "35");
    let said = |shot: &ListedShot| [shot.dialogue.clone(), shot.caption.clone(), shot.sound.clone()];
    assert_eq!(said(&list.shots[0]), ["Who is it?", "Later", "BANG"]);
    assert_eq!(said(&list.shots[1]), ["", "", ""]);
}

#[test]
fn a_timecode_is_written_with_its_video_and_one_that_is_not_valid_is_left_out() {
    let video = |timecode: Value| {
        let mut video = json!({ "key": "v", "name": "a.mov", "path": "a.mov", "type": "", "ids": [], "duration": 1, "start": 0, "end": null });
        if !timecode.is_null() {
            video["timecode"] = timecode;
        }
        video
    };
    let written = |timecode: Value| {
        let project = json!({
            "format": "inkpanel", "version": 1, "photos": [], "videos": [video(timecode)], "history": { "present": {} },
        });
        let text = ProjectFile::parse(&project.to_string()).unwrap().write();
        let written: Value = serde_json::from_str(&text).unwrap();
        written["videos"][0]["timecode"].clone()
    };
    let valid = json!({ "frame": 1_078_920, "fps": 30, "drop": true });
    assert_eq!(written(valid.clone()), valid);
    assert_eq!(written(json!({ "frame": 1, "fps": 24 })), json!({ "frame": 1, "fps": 24, "drop": false }));
    for wrong in [
        Value::Null,
        json!("10:00:00:00"),
        json!({ "frame": 1 }),
        json!({ "frame": -1, "fps": 24 }),
        json!({ "frame": 0.5, "fps": 24 }),
        json!({ "frame": 2_073_600, "fps": 24 }),
        json!({ "frame": 1, "fps": 0 }),
        json!({ "frame": 1, "fps": 24, "drop": true }),
        json!({ "frame": 1, "fps": 24, "drop": 1 }),
    ] {
        assert_eq!(written(wrong.clone()), Value::Null, "{wrong}");
    }
}
