//! Lists of shots: what they say is what `OpenTimelineIO` reads in them, to the frame (`tests/oracles/shots.py`), and what a saved
//! project tells.

use inkpanel::document::file::ProjectFile;
use inkpanel::output::shots::timecode::{Pace, Rate};
use inkpanel::output::shots::{Film, Kind, ListedShot, ShotList};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

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

/// Pictures and places in two films, of lengths that end on no second.
fn list((fps, pace): (u32, Pace)) -> ShotList {
    let film = |name: &str, time| Some(Film { name: name.into(), time, length: Some(7_261.44) });
    let shot = |i: usize, film: Option<Film>| ListedShot {
        number: format!("{}{}", i / 2 + 1, if i % 2 == 1 { "A" } else { "" }),
        scene: ["1", "Küche", ""][i % 3].into(),
        action: "She opens the \"door\",\nlooks out & waits.".into(),
        dialogue: ["", "Hallo? <niemand>"][i % 2].into(),
        notes: ["dusk", "=1+1", ""][i % 3].into(),
        frames: [Some(1), Some(37), None, Some(fps), Some(fps * 61 + 7)][i % 5],
        more: BTreeMap::from([("Lens".into(), "35 mm".into())]),
        name: format!("photo {i}.jpg"),
        film,
    };
    let films = [
        None,
        film("Nacht & Tag.mp4", 0.0),
        film("Nacht & Tag.mp4", 3_599.98),
        film("clip.mov", 12.345),
        None,
        film("clip.mov", 1.0 / 3.0),
        film("Nacht & Tag.mp4", 7_200.04),
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

/// `cargo xtask bless shots` writes them anew; then `tests/oracles/shots.py` reads them.
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
            let frames = u64::from(shot.frames.unwrap_or(2 * rate.0));
            let counted = Rate { base: rate.0, pace: rate.1 };
            let start = shot.film.as_ref().map_or(0, |film| counted.frame_at(film.time));
            let file = shot.film.as_ref().map_or(&shot.name, |film| &film.name);
            let expected = json!({ "start": start, "frames": frames, "at": at, "media": file });
            assert_eq!(*read, expected, "{name}");
            at += frames;
            compared += 1;
        }
    }
    assert_eq!(compared, 6 * 3 * 7);
}

/// The codes that `OpenTimelineIO` gives frames, and the frames that it reads in them (`tests/oracles/shots.py`).
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
    let page = json!({ "version": 1, "seed": 1, "layout": "grid-4", "style": "comic", "panels": panels });
    let photo = |id: &str, rank: u64| json!({ "id": id, "name": format!("{id}.jpg"), "path": format!("photos/{id}.jpg"), "rank": rank });
    let mut photos = json!([photo("a", 3), photo("b", 1), photo("c", 0), photo("d", 2), photo("e", 4)]);
    photos[1]["video"] = json!("v");
    photos[1]["time"] = json!(2.5);
    let project = json!({
        "format": "inkpanel", "version": 1, "photos": photos,
        "videos": [{ "key": "v", "name": "film.mp4", "path": "film.mp4", "ids": ["b"], "duration": 60 }],
        "history": { "present": { "name": "N", "tray": tray, "page": page, "board": { "fps": 25, "columns": ["Lens"], "order": ["e", "b"] } } },
    });
    let list = ProjectFile::parse(&project.to_string()).unwrap().shot_list();
    let told: Vec<_> = list.shots.iter().map(|shot| (shot.name.as_str(), shot.number.as_str())).collect();
    // `d` is on no page and nobody chose it, `c` is not used; those that were moved go before.
    assert_eq!(told, [("e.jpg", "1B"), ("b.jpg", "1"), ("a.jpg", "2")]);
    let film = Film { name: "film.mp4".into(), time: 2.5, length: Some(60.0) };
    assert_eq!((list.shots[1].film.as_ref(), list.shots[2].frames, list.fps), (Some(&film), Some(12), 25));
    assert_eq!(list.shots[2].more["Lens"], "35");
}
