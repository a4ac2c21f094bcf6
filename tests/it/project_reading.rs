//! Reading of saved projects: valid ones within the limits, or an error with the position.
#![allow(clippy::needless_pass_by_value, reason = "JSON that is made for one call")]

use inkpanel_engine::document::file::ProjectFile;
use inkpanel_engine::document::history::History;
use inkpanel_engine::document::kept;
use inkpanel_engine::document::project::Project;
use inkpanel_engine::framing::PhotoMeta;
use inkpanel_engine::layout::{self, PageSettings};
use inkpanel_engine::page::document::Document;
use inkpanel_engine::page::request::Request;
use inkpanel_engine::page::{Scene, shuffle};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::collections::HashSet;
use std::time::{Duration, Instant};

/// The minimum of a PNG file that a board accepts.
const LOGO: &str = "data:image/png;base64,iVBORw0KGgo=";

fn photos(count: usize) -> Vec<Value> {
    let photo = |i| {
        json!({
            "id": format!("p{i}"), "name": format!("{i}.jpg"), "path": format!("photos/{i:03}.jpg"), "type": "image/jpeg",
            "measured": true, "rank": i, "credit": "Ann", "subjects": [{ "label": "face", "score": 0.9, "x": 0.1, "y": 0.2, "width": 0.3, "height": 0.3 }],
            "like": { "hash": "", "fingerprint": "0123456789abcdef", "width": 1500, "height": 1000 },
        })
    };
    (0..count).map(photo).collect()
}

fn page(seed: u32, layout: Value, style: Value, words: Value) -> Value {
    let metas: Vec<_> = (0..6).map(|i| PhotoMeta::unmeasured(&format!("p{i}"), 1500, 1000)).collect();
    let mut request: Request =
        serde_json::from_value(json!({ "seed": seed, "layout": layout, "style": style })).unwrap();
    request.photos = metas;
    let mut page = serde_json::from_str::<Value>(&shuffle::plan(&request).unwrap().to_json()).unwrap();
    page["words"] = words;
    page
}

fn own_layout() -> Value {
    json!({
        "id": "mine-1", "name": "Mine", "family": "custom", "aspect": 0.7,
        "tree": { "rows": ["panel", { "columns": ["panel", "panel"], "shares": [1, 2] }] },
    })
}

fn own_style() -> Value {
    json!({ "id": "my-1", "name": "Mine", "tags": [], "background": [{ "block": "posterize", "levels": 5 }] })
}

/// A project that has all that a project can have.
fn whole() -> Value {
    let words = json!([
        { "kind": "balloon", "text": "Hi", "panel": 1, "x": 0.4, "y": 0.4, "tail": { "x": 0.5, "y": 0.9 }, "size": "auto" },
        { "kind": "caption", "text": "Later", "auto": true },
        { "kind": "effect", "text": "BAM", "angle": -8, "arc": 0.5 },
    ]);
    let mut first = page(1, json!("grid-4"), json!("comic"), words);
    first["merges"] = json!([[0, 1]]);
    first["panels"][0]["crop"] = json!({ "x": 0.1, "y": 0.1, "width": 0.5, "height": 0.5 });
    first["panels"][0]["edited"] = json!(true);
    let second = page(2, own_layout(), own_style(), json!([]));
    let present = json!({
        "name": "Trip", "alike": 12, "order": "name", "panels": 4, "pageId": 3, "sheet": 0, "at": 1,
        "tray": [{ "id": "p0", "use": null, "mask": "2x2:ap2a" }, { "id": "p1", "use": true, "focus": { "x": 0.2, "y": 0.7 } }, { "id": "p2", "use": false, "shot": { "scene": "1", "number": "4A", "action": "She turns.", "dialogue": "Oh!", "notes": "dusk", "frames": 36, "more": { "Lens": "35" } } }],
        "locks": { "layout": true, "style": false, "photos": false },
        "settings": first["page"], "page": first,
        "others": [{ "page": second, "pageId": 2, "sheet": 4 }],
        "draft": {
            "id": "my-2", "name": "Draft", "tags": ["ink"], "ink": "#101014", "foreground": [],
            "background": [{ "key": 1, "block": "posterize", "values": { "levels": 7 }, "bypass": false }],
        },
        "mine": [own_style()], "favourites": [own_style()], "ownLayouts": [own_layout()], "loved": [1, 3],
        "styling": { "invented": 0.5, "keepLines": true, "keepColours": false },
        "board": { "fps": 25, "columns": ["Lens"], "frames": 8, "aspect": "2.39", "beside": true, "ruled": true, "author": "Ann", "date": "May", "logo": LOGO, "order": ["p2", "p0"] },
    });
    let shown = json!([
        { "id": 1, "page": page(3, json!("cinema-3"), json!("noir"), json!([])) },
        { "id": 3, "page": present["page"], "from": 1 },
        { "id": 2, "page": present["others"][0]["page"], "sheet": 4 },
    ]);
    let videos = json!([{ "key": "v1", "name": "a.mp4", "path": "videos/007-a.mp4", "ids": ["p1"], "duration": 4.5, "start": 0, "end": null }]);
    json!({ "format": "inkpanel", "version": 1, "history": { "present": present, "shown": shown }, "photos": photos(6), "videos": videos })
}

fn read(value: &Value) -> Result<ProjectFile, (&'static str, String)> {
    ProjectFile::parse(&value.to_string()).map_err(|error| (error.code(), error.to_string()))
}

/// The message with which a changed project is refused.
fn refused(change: impl FnOnce(&mut Value)) -> String {
    let mut value = whole();
    change(&mut value);
    let (code, message) = read(&value).unwrap_err();
    let beyond = message.contains("entries, at most") || message.contains("longer than 1000 characters");
    assert_eq!(code, if beyond { "too-large-project" } else { "damaged-project" }, "{message}");
    message
}

/// Adds the photo of each text item. The default is the photo of its panel. An automatic size is written as
/// a missing size.
fn tell_photos_of_words(value: &mut Value) {
    match value {
        Value::Array(list) => list.iter_mut().for_each(tell_photos_of_words),
        Value::Object(map) => {
            let panels = map.get("panels").cloned().unwrap_or_default();
            for word in map.get_mut("words").and_then(Value::as_array_mut).into_iter().flatten() {
                let photo = word["panel"].as_u64().map(|panel| &panels[panel as usize]["photo"]);
                let Some(word) = word.as_object_mut() else { continue };
                if let Some(Value::String(photo)) = photo {
                    word.entry("photo").or_insert(json!(photo));
                }
                if word.get("size") == Some(&json!("auto")) {
                    word.remove("size");
                }
            }
            map.values_mut().for_each(tell_photos_of_words);
        }
        _ => {}
    }
}

#[test]
fn a_whole_project_is_read_as_it_is() {
    let project = read(&whole()).unwrap();
    assert_eq!(project.dropped, Vec::<String>::new());
    let text = project.write();
    let mut again: Value = serde_json::from_str(&text).unwrap();
    let mut before = whole();
    again.as_object_mut().unwrap().remove("dropped");
    // Adds all fields of a photo.
    for photo in before["photos"].as_array_mut().unwrap() {
        photo["absent"] = json!(false);
    }
    before["videos"][0]["type"] = json!("");
    tell_photos_of_words(&mut before);
    assert_eq!(compared(again), compared(before));
    assert_eq!(read(&serde_json::from_str(&text).unwrap()).unwrap().write(), text);
}

#[test]
fn a_mask_that_was_corrected_wins_over_the_one_that_was_found_whatever_the_photo_is_called() {
    let mut value = whole();
    value["photos"][0]["mask"] = json!("1x1:p");
    value["photos"][3]["mask"] = json!("1x1:a");
    for project in [read(&value).unwrap(), read(&value).unwrap().renamed("new-")] {
        let masks: Vec<_> = project.masks().map(|(id, mask)| (id, mask.text())).collect();
        let ids = [0, 3].map(|i| project.photos[i].id.as_str());
        assert_eq!(masks, [(ids[0], "2x2:ap2a"), (ids[1], "1x1:a")]);
    }
}

#[test]
fn a_corrected_mask_that_is_none_is_left_out_and_nothing_else_is_lost() {
    let tray = |value: &Value| read(value).unwrap().history.present.tray.clone();
    let mut value = whole();
    let good = tray(&value);
    assert_eq!(good[0].mask.as_ref().unwrap().text(), "2x2:ap2a");
    let long = format!("320x320:{}", "a".repeat(70_000));
    for wrong in [json!("2x2:a9"), json!(["a"]), json!(null), json!("400x1:a400"), json!(long)] {
        value["history"]["present"]["tray"][0]["mask"] = wrong;
        let read = read(&value).unwrap();
        assert!(read.dropped.is_empty());
        let after = &read.history.present.tray;
        assert_eq!((after[0].mask.clone(), after[0].id.as_str(), &after[1..]), (None, "p0", &good[1..]));
        assert!(!read.write().contains("\"mask\""));
    }
}

/// Numbers as JavaScript has them: 0 is 0.0.
fn compared(value: Value) -> Value {
    match value {
        Value::Number(number) => json!(number.as_f64()),
        Value::Array(list) => list.into_iter().map(compared).collect(),
        Value::Object(map) => map.into_iter().map(|(name, value)| (name, compared(value))).collect(),
        other => other,
    }
}

#[test]
fn a_page_keeps_the_order_of_its_fields() {
    // The page compares pages as text.
    let text = read(&whole()).unwrap().write();
    let order = r#""page":{"version":1,"seed":1,"layout":"grid-4","style":"comic","order":["#;
    assert!(text.contains(order), "{text}");
}

#[test]
fn what_is_missing_is_usual_at_every_depth() {
    let bare =
        json!({ "version": 1, "seed": 1, "layout": "grid-4", "style": "comic", "panels": [{}, {}, {}, {}] });
    let value = json!({
        "format": "inkpanel", "version": 1, "photos": [], "history": { "present": {
            "page": bare, "tray": [{ "id": "x" }], "locks": { "style": true }, "settings": { "width": 500 }, "styling": {},
            "others": [{ "page": bare, "pageId": 1, "sheet": 1 }],
        } },
    });
    let present = Project::clone(&read(&value).unwrap().history.present);
    assert_eq!((present.alike, present.settings.width, present.settings.height), (10, 500, 3508));
    assert!(present.locks.style && !present.locks.photos && present.tray[0].used.is_none());
    assert_eq!(present.page().unwrap().page, PageSettings::default());
}

#[test]
fn fields_of_another_program_are_kept() {
    let mut value = whole();
    let mark = |value: &mut Value| value["fresh"] = json!({ "a": [1, 2] });
    let present = &mut value["history"]["present"];
    for path in [
        "",
        "/page",
        "/page/panels/0",
        "/page/words/0",
        "/tray/0",
        "/locks",
        "/styling",
        "/tray/2/shot",
        "/board",
        "/others/0",
        "/draft",
        "/draft/background/0",
    ] {
        mark(present.pointer_mut(path).unwrap());
    }
    mark(&mut value["history"]["shown"][0]);
    let text = read(&value).unwrap().write();
    assert_eq!(text.matches(r#""fresh":{"a":[1,2]}"#).count(), 13);
    // If an unknown field would change the picture, it is rejected.
    assert!(
        refused(|v| mark(&mut v["history"]["present"]["settings"])).starts_with("present.settings.fresh: ")
    );
    assert!(
        refused(|v| mark(&mut v["history"]["present"]["page"]["panels"][0]["crop"]))
            .starts_with("present.page.panels[0].crop.fresh: ")
    );
}

#[test]
fn what_is_wrong_is_refused_with_its_place() {
    let long = "x".repeat(11_000);
    let many = |count: usize| vec![json!({ "kind": "caption", "text": "x" }); count];
    let cases: Vec<(&str, Value, &str)> = vec![
        ("/history/present/page/words", json!([null]), "present.page.words[0]: must be an object"),
        ("/history/present/page/words/1/text", json!(7), "present.page.words[1].text: must be a string"),
        (
            "/history/present/page/words/1/text",
            json!(long),
            "present.page.words[1].text: is longer than 10000 characters",
        ),
        ("/history/present/page/words", json!(many(1_000)), "present.page.words: has 1000 entries"),
        ("/history/present/page/words", json!(many(20_000)), "present.page.words: has 20000 entries"),
        ("/history/present/alike", json!(10.5), "present.alike: must be a whole number from 0 to 64"),
        ("/history/present/alike", json!(65), "present.alike: "),
        ("/history/present/settings/width", Value::Null, "present.settings.width: "),
        ("/history/present/settings/gutter", json!(0.5), "present.settings.gutter: must be from 0 to 0.1"),
        ("/history/present/page/page/width", Value::Null, "present.page.page.width: "),
        ("/history/present/page/page/paper", json!("red"), "present.page.page.paper: "),
        ("/history/present/page/merges", json!([null]), "present.page.merges[0]: must be a list"),
        ("/history/present/page/merges", json!([[0, 1], [1, 2]]), "present.page.merges: panel 1"),
        ("/history/present/page/merges", json!([[0, 9]]), "present.page.merges: panel 9"),
        ("/history/present/page/layout", json!("gone"), "present.page.layout: there is no layout"),
        ("/history/present/page/layout", json!(5), "present.page.layout: must be an id or an object"),
        (
            "/history/present/page/layout",
            json!("cinema-3"),
            "present.page.panels: has 4 entries, the layout has 3",
        ),
        ("/history/present/page/style", json!("gone"), "present.page.style: there is no style"),
        (
            "/history/present/page/style",
            json!({ "background": [{ "block": "nope" }] }),
            "present.page.style.background[0]: ",
        ),
        (
            "/history/present/page/panels/1/crop",
            json!({ "x": 0.9, "y": 0, "width": 0.5, "height": 1 }),
            "present.page.panels[1].crop: reaches",
        ),
        ("/history/present/page/panels/1/crop/x", json!("a"), "present.page.panels[1].crop.x: "),
        ("/history/present/page/panels/1/crop/width", json!(0), "present.page.panels[1].crop.width: "),
        ("/history/present/page/panels/2", json!(null), "present.page.panels[2]: must be an object"),
        ("/history/present/page/panels/2/photo", json!(3), "present.page.panels[2].photo: must be a string"),
        ("/history/present/page/seed", json!(-1), "present.page.seed: "),
        ("/history/present/page/version", json!("1"), "present.page.version: "),
        ("/history/present/others/0/page/layout/aspect", json!(0), "present.others[0].page.layout.aspect: "),
        ("/history/present/others/0/sheet", json!(0), "present.others[0].sheet: is a duplicate page"),
        ("/history/present/at", json!(2), "present.at: "),
        ("/history/present/page", Value::Null, "present.at: "),
        ("/history/present/name", json!("x".repeat(2_000)), "present.name: is longer than 1000 characters"),
        ("/history/present/name", json!(5), "present.name: must be a string"),
        ("/history/present/tray", json!([1]), "present.tray[0]: must be an object"),
        ("/history/present/tray/1/id", json!(""), "present.tray[1].id: is empty"),
        ("/history/present/tray/1/focus", json!({ "x": 1e9, "y": 0 }), "present.tray[1].focus.x: "),
        ("/history/present/pageId", json!(1.5), "present.pageId: "),
        ("/history/present/panels", json!(0), "present.panels: "),
        ("/history/present/order", json!("size"), "present.order: must be one of"),
        ("/history/present/locks/style", json!(1), "present.locks.style: "),
        ("/history/present/styling/invented", json!(2), "present.styling.invented: "),
        ("/history/present/tray/2/shot", json!([]), "present.tray[2].shot: must be an object"),
        ("/history/present/tray/2/shot/frames", json!(1.5), "present.tray[2].shot.frames: "),
        (
            "/history/present/tray/2/shot/more",
            json!({ "Lens": 35 }),
            "present.tray[2].shot.more.Lens: must be a string",
        ),
        ("/history/present/board/fps", json!(23), "present.board.fps: "),
        ("/history/present/board/columns", json!(["a", "a"]), "present.board.columns: "),
        ("/history/present/board/aspect", json!("3:2"), "present.board.aspect: "),
        ("/history/present/board/logo", json!("logo.png"), "present.board.logo: must be a PNG data URL"),
        ("/history/present/loved", json!([-1]), "present.loved[0]: "),
        (
            "/history/present/draft/background/0/values/levels",
            json!(1),
            "present.draft.background[0].values.levels: ",
        ),
        ("/history/present/draft/background/0/block", json!("nope"), "present.draft.background[0].block: "),
        ("/history/present/mine", json!(5), "present.mine: must be a list"),
        ("/history/present", json!([]), "present: must be an object"),
        ("/history", json!(7), "history: must be an object"),
        ("/format", json!("other"), "project.json: was not saved by Inkpanel"),
        ("/version", json!("1"), "version: "),
        ("/version", json!(0), "version: "),
        ("/photos", json!({ "length": 1e9 }), "photos: must be a list"),
        ("/photos/3", json!({ "name": "x" }), "photos[3].id: is missing"),
        ("/photos/3/id", json!("p0"), "photos[3].id: is used twice"),
        ("/videos/0/path", json!("photos/003.jpg"), "videos[0].path: is used twice"),
        ("/videos/0/ids", json!([3]), "videos[0].ids[0]: must be a string"),
    ];
    for (path, wrong, start) in cases {
        let message = refused(|value| *value.pointer_mut(path).unwrap() = wrong.clone());
        assert!(message.starts_with(start), "{path}: {message}");
    }
    assert!(
        refused(|value| drop(value.as_object_mut().unwrap().remove("version")))
            .starts_with("version: is missing")
    );
}

#[test]
fn what_is_newer_is_told_so() {
    for path in ["/version", "/history/present/page/version"] {
        let mut value = whole();
        *value.pointer_mut(path).unwrap() = json!(2);
        assert_eq!(read(&value).unwrap_err().0, "newer-project", "{path}");
    }
}

#[test]
fn what_is_wrong_beside_the_present_is_left_out_and_told() {
    let mut value = whole();
    let history = &mut value["history"];
    history["shown"][0]["page"]["layout"] = json!("gone");
    history["shown"][2]["id"] = json!(3);
    history["present"]["mine"] =
        json!([own_style(), own_style(), { "id": "x", "background": [{ "block": "nope" }] }, null]);
    history["present"]["ownLayouts"][0]["tree"] = json!("pane");
    let project = read(&value).unwrap();
    assert_eq!((project.history.shown.len(), project.history.present.mine.len()), (1, 1));
    assert!(project.history.present.own_layouts.is_empty());
    let told: Vec<_> = project.dropped.iter().map(|told| told.split(": ").next().unwrap()).collect();
    let expected = [
        "present.mine[1].id",
        "present.mine[2].background[0]",
        "present.mine[3].id",
        "present.ownLayouts[0].tree",
        "shown[0].page.layout",
        "shown[2].id",
    ];
    assert_eq!(told, expected);
    // A photo that is twice in the tray is one.
    value["history"]["present"]["tray"] = json!([{ "id": "a", "use": true }, { "id": "a" }]);
    assert_eq!(read(&value).unwrap().history.present.tray.len(), 1);
}

#[test]
fn half_a_character_is_no_fault() {
    let text = whole().to_string().replace("Trip", "Trip \\ud83c");
    assert_eq!(ProjectFile::parse(&text).unwrap().history.present.name, "Trip \u{fffd}");
}

#[test]
fn what_has_no_end_is_refused_at_once() {
    let huge = "x".repeat(20 << 20);
    let nested = "[".repeat(100_000) + &"]".repeat(100_000);
    let one_path: Vec<_> = photos(5_000)
        .into_iter()
        .map(|mut photo| {
            photo["path"] = json!("photos/1.jpg");
            photo
        })
        .collect();
    let cases: [(&str, String, &str); 6] = [
        (
            "name",
            with("/history/present/name", &json!(huge)),
            "history.present.name: is a text of more than 512 KB",
        ),
        ("photo", with("/photos/0/name", &json!(huge)), "photos[0].name: is a text of more than 512 KB"),
        ("photos on one path", with("/photos", &json!(one_path)), "photos[1].path: is used twice"),
        (
            "too many photos",
            with("/photos", &json!(photos(20_001))),
            "photos: has 20001 entries, at most 20000",
        ),
        (
            "nested",
            whole().to_string().replace("\"Trip\"", &nested),
            "project.json: is not valid JSON: recursion limit",
        ),
        (
            "lists",
            whole().to_string().replace("\"Trip\"", &format!("[{}0]", "[],".repeat(2_500_000))),
            "history.present.name[",
        ),
    ];
    for (what, text, start) in cases {
        let begin = Instant::now();
        let error = ProjectFile::parse(&text).unwrap_err();
        let twice = what == "photos on one path";
        assert_eq!(
            error.code(),
            if twice { "damaged-project" } else { "too-large-project" },
            "{what}: {error}"
        );
        assert!(error.to_string().trim_start_matches("project.json.").starts_with(start), "{what}: {error}");
        // A limit for a search that never ends, not a measurement.
        assert!(begin.elapsed() < Duration::from_mins(1), "{what}: {:?}", begin.elapsed());
    }
    assert!(ProjectFile::parse(&" ".repeat(33 << 20)).is_err());
}

fn with(path: &str, value: &Value) -> String {
    let mut project = whole();
    *project.pointer_mut(path).unwrap() = value.clone();
    project.to_string()
}

#[test]
fn fresh_ids_are_given_to_photos_alone() {
    let mut value = whole();
    // An id that is also the id of a layout, and the id of a photo that the file does not contain.
    let text = value.to_string().replace("\"p0\"", "\"grid-4\"").replace("\"p5\"", "\"elsewhere\"");
    value = serde_json::from_str(&text).unwrap();
    value["photos"].as_array_mut().unwrap().pop();
    let project = read(&value).unwrap().renamed("q");
    let ids: Vec<_> = project.photos.iter().map(|photo| photo.id.as_str()).collect();
    assert_eq!(
        (ids.as_slice(), project.videos[0].ids[0].as_str()),
        (["q0", "q1", "q2", "q3", "q4"].as_slice(), "q1")
    );
    let present = &project.history.present;
    let page = present.page().unwrap();
    assert_eq!((page.layout.built_in(), present.tray[0].id.as_str()), (Some("grid-4"), "q0"));
    let shown = project.history.shown.iter().flat_map(|shown| &shown.page.panels).chain(&page.panels);
    assert!(shown.filter_map(|panel| panel.photo.as_ref()).chain(&page.order).all(|id| id.starts_with('q')));
}

/// A video as the app stores it: its key is the id of its first frame at the time when it was added.
fn video(key: &str, number: usize, ids: &[&str]) -> Value {
    json!({
        "key": key, "name": "a.mp4", "path": format!("videos/{number:03}-a.mp4"), "type": "video/mp4", "ids": ids,
        "duration": 4.5, "start": 0, "end": 4.5,
    })
}

/// Marks photos as frames of a video.
fn frames_of(value: &mut Value, key: &str, ids: &[&str]) {
    for photo in value["photos"].as_array_mut().unwrap() {
        if ids.iter().any(|id| photo["id"] == *id) {
            photo["video"] = json!(key);
            photo["time"] = json!(0.5);
            photo["shot"] = json!(1);
        }
    }
}

/// Projects in the shape in which the app saves them, one for each kind.
fn kinds() -> Vec<(&'static str, Value)> {
    let of = |videos: &[(&str, &[&str])]| {
        let mut value = whole();
        let list = videos.iter().enumerate().map(|(i, (key, ids))| video(key, i + 7, ids));
        value["videos"] = list.collect();
        for (key, ids) in videos {
            frames_of(&mut value, key, ids);
        }
        value
    };
    let mut bare = whole();
    bare["videos"] = json!([]);
    let mut waiting = of(&[("p0", &["p0", "p1"])]);
    waiting["history"]["present"]["waiting"] =
        json!([{ "kind": "balloon", "text": "Hi", "photo": "p1", "panel": 0, "cue": "a.mp4 1" }]);
    let mut gif = of(&[("p2", &["p2", "p3"])]);
    gif["videos"][0]["type"] = json!("image/gif");
    gif["videos"][0]["duration"] = Value::Null;
    let mut removed = of(&[("p0", &["p0", "p1"])]);
    removed["photos"].as_array_mut().unwrap().remove(0);
    removed["videos"][0]["ids"] = json!(["p1"]);
    let mut gone = of(&[("p0", &["p0", "p1"])]);
    gone["videos"] = json!([]);
    vec![
        ("photos, several pages, masks, styles, layouts, a storyboard", bare),
        ("a video", of(&[("p0", &["p0", "p1", "p2"])])),
        ("two videos", of(&[("p0", &["p0", "p1"]), ("p3", &["p3", "p4"])])),
        ("a video that was sampled again", of(&[("p0", &["p0", "p1"]), ("p2", &["p2", "p3"])])),
        ("a video whose key is the id of a photo that is not its frame", of(&[("p5", &["p1", "p2"])])),
        ("a video without its first frame", removed),
        ("frames without their video", gone),
        ("an animated GIF", gif),
        ("unplaced text of a video", waiting),
    ]
}

/// The frames of each video by name, and the video of each photo as a position in the list.
fn links(project: &ProjectFile) -> (Vec<Vec<Option<usize>>>, Vec<Option<usize>>) {
    let photo = |id: &String| project.photos.iter().position(|photo| photo.id == *id);
    let frames = project.videos.iter().map(|video| video.ids.iter().map(photo).collect());
    let video = |key: &String| project.videos.iter().position(|video| video.key == *key);
    (frames.collect(), project.photos.iter().map(|photo| photo.video.as_ref().and_then(video)).collect())
}

#[test]
fn every_kind_of_saved_project_opens_as_it_was() {
    for (kind, value) in kinds() {
        let project = read(&value).unwrap_or_else(|(_, message)| panic!("{kind}: {message}"));
        assert_eq!(project.dropped, Vec::<String>::new(), "{kind}");
        let text = project.write();
        let again = ProjectFile::parse(&text).unwrap();
        assert_eq!(again.write(), text, "{kind}");
        assert_eq!(again.history, project.history, "{kind}");
        // Opened in the app, where all ids are new.
        let renamed = project.clone().renamed("new-");
        let opened = ProjectFile::parse(&renamed.write()).unwrap_or_else(|error| panic!("{kind}: {error}"));
        assert_eq!(links(&opened), links(&project), "{kind}");
        assert_eq!(opened.photos.len(), project.photos.len(), "{kind}");
        let keys: HashSet<&String> = opened.videos.iter().map(|video| &video.key).collect();
        assert!(opened.photos.iter().all(|photo| !keys.contains(&photo.id)), "{kind}");
        let photo = |file: &ProjectFile| {
            let of = |id: &str| file.photos.iter().position(|photo| photo.id == id);
            let pages = file.history.present.sheets();
            let shown = pages.iter().flat_map(|sheet| &sheet.page.panels);
            let shown: Vec<_> = shown.map(|panel| panel.photo.as_deref().and_then(of)).collect();
            let waiting = file.history.present.waiting.iter();
            (shown, waiting.map(|word| of(word.photo.as_deref().unwrap())).collect::<Vec<_>>())
        };
        assert_eq!(photo(&opened), photo(&project), "{kind}");
        usable(&opened);
    }
}

#[test]
fn a_file_may_have_more_photos_than_the_tray_and_as_many_videos() {
    let mut value = whole();
    let count = 6_000;
    value["photos"] = json!(photos(count));
    value["videos"] = (0..count).map(|i| video(&format!("p{i}"), i, &[&format!("p{i}")])).collect();
    let project = read(&value).unwrap();
    assert_eq!((project.photos.len(), project.videos.len()), (count, count));
}

#[test]
fn two_files_have_neither_one_name_nor_one_path() {
    let mut value = whole();
    value["videos"] = json!([video("p0", 7, &["p0"]), video("p0", 8, &["p1"])]);
    assert_eq!(read(&value).unwrap_err().1, "videos[1].key: is used twice");
    value["videos"] = json!([video("p0", 7, &["p0"]), video("p1", 7, &["p1"])]);
    assert_eq!(read(&value).unwrap_err().1, "videos[1].path: is used twice");
    value["videos"][0]["path"] = json!("photos/003.jpg");
    assert_eq!(read(&value).unwrap_err().1, "videos[0].path: is used twice");
    value["photos"][2]["id"] = json!("p1");
    assert_eq!(read(&value).unwrap_err().1, "photos[2].id: is used twice");
}

/// The states of the project, with tables as the app writes them.
fn tables() -> Value {
    let whole = whole();
    let present = &whole["history"]["present"];
    let mut state = present.clone();
    for (field, index) in [
        ("tray", 0),
        ("settings", 0),
        ("page", 0),
        ("others", 0),
        ("draft", 0),
        ("board", 0),
        ("mine", 0),
        ("favourites", 0),
        ("ownLayouts", 0),
    ] {
        state[field] = json!(index);
    }
    let mut before = state.clone();
    (before["name"], before["page"], before["others"], before["at"]) =
        (json!(""), Value::Null, json!(1), json!(0));
    let sheet = json!({ "page": 1, "pageId": 2, "sheet": 4 });
    json!({ "version": 1, "history": {
        "parts": {
            "items": present["tray"], "trays": [[0, 1, 2]], "pages": [present["page"], present["others"][0]["page"]],
            "sheets": [sheet], "books": [[0], []], "styles": [own_style()], "shelves": [[0]], "layouts": [own_layout()],
            "layoutShelves": [[0]], "settings": [present["settings"]], "drafts": [present["draft"]], "boards": [present["board"]],
        },
        "past": [before, state, state], "present": state, "future": [before], "shown": [{ "id": 3, "page": 0 }, { "id": 2, "page": 1, "sheet": 4, "from": 3 }],
    } })
}

#[test]
fn states_share_what_they_shared() {
    let (history, dropped) = kept::parse(&tables().to_string()).unwrap();
    assert!(dropped.is_empty());
    let History { past, present, future, shown } = &history;
    assert_eq!((past.len(), future.len(), shown.len()), (3, 1, 2));
    assert!(std::ptr::eq(present.tray.as_ptr(), past[1].tray.as_ptr()));
    assert!(std::sync::Arc::ptr_eq(&present.pages.edited().unwrap().page, &shown[0].page));
    assert!(std::sync::Arc::ptr_eq(&present.board, &past[0].board));
    assert_eq!(present.board.logo, LOGO);
    let text = kept::write(&history, &dropped);
    assert_eq!(text.matches(LOGO).count(), 1);
    let written: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(written["history"]["parts"]["pages"].as_array().unwrap().len(), 2);
    assert_eq!(kept::parse(&text).unwrap().0, history);
}

#[test]
fn a_wrong_part_costs_the_states_that_have_it() {
    let cases = [
        ("/history/parts/pages/0/words/0/x", json!("a"), None),
        ("/history/parts/items/0/id", json!(5), None),
        ("/history/present/tray", json!("0"), None),
        ("/history/present/tray", json!(7), None),
        ("/history/present/board", json!(1), None),
        ("/history/parts/boards/0/logo", json!("logo.png"), None),
        ("/history/past", json!(vec![0; 501]), None),
        ("/history/parts/books/1", json!([9]), Some(["past[0].others[0]", "future[0].others[0]"].as_slice())),
        ("/history/past/1/alike", json!(10.5), Some(["past[1].alike"].as_slice())),
        ("/history/shown/1/page", json!("1"), Some(["shown[1].page"].as_slice())),
        ("/history/parts/styles/0/background", json!(5), Some(["styles[0].background"].as_slice())),
    ];
    for (path, wrong, expected) in cases {
        let mut value = tables();
        *value.pointer_mut(path).unwrap() = wrong;
        match (kept::parse(&value.to_string()), expected) {
            (Err(error), None) => {
                let beyond = path == "/history/past";
                assert_eq!(
                    error.code(),
                    if beyond { "too-large-project" } else { "damaged-project" },
                    "{path}"
                );
            }
            (Ok((_, dropped)), Some(expected)) => {
                let told: Vec<_> = dropped.iter().map(|told| told.split(": ").next().unwrap()).collect();
                assert_eq!(told, expected, "{path}");
            }
            (answer, _) => panic!("{path}: {answer:?}"),
        }
    }
    let mut value = tables();
    value["history"]["parts"]["pages"][0]["words"][0]["x"] = json!("a");
    assert!(
        kept::parse(&value.to_string()).unwrap_err().to_string().starts_with("present.page.words[0].x: ")
    );
}

#[test]
fn an_empty_merge_is_no_merge() {
    let mut value = whole();
    value["history"]["present"]["page"]["merges"] = json!([[], [2], [0, 1]]);
    let project = read(&value).unwrap();
    let page = project.history.present.page().unwrap();
    assert_eq!(page.merges, [[0, 1]]);
    value["history"]["present"]["page"]["merges"] = json!([[]]);
    usable(&read(&value).unwrap());
}

/// Checks that drawing and planning accept the project.
fn usable(project: &ProjectFile) {
    let History { present, shown, .. } = &project.history;
    let pages = present.sheets().iter().map(|sheet| &sheet.page).chain(shown.iter().map(|shown| &shown.page));
    for page in pages {
        Scene::new(page, 300).unwrap();
        assert!(page.words.iter().all(|word| word.validate().is_ok()));
        let template = page.template().unwrap();
        assert_eq!(layout::resolve(&template, page.page.aspect(), &page.page).len(), page.panels.len());
        let keep = json!({ "layout": true, "style": true, "photos": true });
        let mut request: Request = serde_json::from_value(json!({ "seed": 1, "keep": keep })).unwrap();
        request.photos = (0..4).map(|i| PhotoMeta::unmeasured(&format!("p{i}"), 1500, 1000)).collect();
        (request.current, request.page) = (Some(Document::clone(page)), page.page.clone());
        let planned = shuffle::plan(&request).unwrap();
        assert!(
            planned
                .panels
                .iter()
                .filter_map(|panel| panel.crop)
                .all(|crop| crop.width.is_finite() && crop.x.is_finite())
        );
    }
    let text = project.write();
    assert_eq!(
        ProjectFile::parse(&text).unwrap().write().replace(&told(project), "[]"),
        text.replace(&told(project), "[]")
    );
    assert!(ProjectFile::parse(&project.clone().renamed("q").write()).is_ok());
}

fn told(project: &ProjectFile) -> String {
    serde_json::to_string(&project.dropped).unwrap()
}

/// Paths of all values of a document.
fn paths(value: &Value, at: &str, all: &mut Vec<String>) {
    all.push(at.to_owned());
    match value {
        Value::Array(list) => {
            list.iter().enumerate().for_each(|(i, value)| paths(value, &format!("{at}/{i}"), all));
        }
        Value::Object(map) => map.iter().for_each(|(name, value)| paths(value, &format!("{at}/{name}"), all)),
        _ => {}
    }
}

/// Something that has no business there.
fn stray() -> impl Strategy<Value = Option<Value>> {
    prop_oneof![
        Just(None),
        Just(Some(Value::Null)),
        any::<bool>().prop_map(|flag| Some(json!(flag))),
        any::<i64>().prop_map(|number| Some(json!(number))),
        (-2i64..70).prop_map(|number| Some(json!(number))),
        (-1.5f64..2.5).prop_map(|number| Some(json!(number))),
        prop::num::f64::NORMAL.prop_map(|number| Some(json!(number))),
        ".{0,20}".prop_map(|text| Some(json!(text))),
        prop::sample::select(vec!["grid-4", "comic", "p1", "auto", "#ffffff", "time", "balloon"])
            .prop_map(|text| Some(json!(text))),
        Just(Some(json!([]))),
        Just(Some(json!([null]))),
        Just(Some(json!([[]]))),
        Just(Some(json!({}))),
        Just(Some(json!({ "id": "x" }))),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1_000))]

    /// Any change of a valid project gives an error with its position, or a usable project.
    #[test]
    fn a_changed_project_is_refused_or_usable(changes in prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>(), stray()), 1..4)) {
        let mut value = whole();
        for (at, from, stray) in changes {
            let mut all = Vec::new();
            paths(&value, "", &mut all);
            let path = at.get(&all).clone();
            let Some(target) = value.pointer_mut(&path) else { continue };
            match stray {
                Some(stray) => *target = stray,
                // Another part of the document, or nothing.
                None if path.ends_with('e') => {
                    let (parent, name) = path.rsplit_once('/').unwrap();
                    if let Some(Value::Object(map)) = value.pointer_mut(parent) {
                        map.remove(name);
                    }
                }
                None => {
                    let other: &String = from.get(&all);
                    let other = value.pointer(other).cloned().unwrap_or_default();
                    *value.pointer_mut(&path).unwrap() = other;
                }
            }
        }
        match read(&value) {
            Ok(project) => usable(&project),
            Err((code, message)) => {
                prop_assert!(["damaged-project", "newer-project", "too-large-project"].contains(&code));
                let (place, reason) = message.split_once(": ").unwrap();
                prop_assert!(!place.is_empty() && !reason.is_empty(), "{message}");
            }
        }
    }
}

#[test]
fn faces_of_any_version_are_read_and_wrong_points_are_not_faces() {
    let mut value = whole();
    let points = json!([[0.1, 0.2], [0.2, 0.2], [0.15, 0.25], [0.15, 0.3], [0.05, 0.25], [0.25, 0.25]]);
    value["photos"][0]["subjects"][0]["points"] = points.clone();
    value["photos"][1]["subjects"][0]["points"] = json!([[0.1, 0.2]]);
    value["photos"][2]["subjects"][0]["points"] = json!([[9.0, 0], [0, 0], [0, 0], [0, 0], [0, 0], [0, 0]]);
    let photos = read(&value).unwrap().photos;
    assert_eq!(json!(photos[0].subjects.as_ref().unwrap()[0].points), points);
    // Photos without valid subjects are searched again.
    assert_eq!((&photos[1].subjects, &photos[2].subjects), (&None, &None));
    // Projects of older versions have faces without points.
    assert_eq!(photos[3].subjects.as_ref().unwrap().len(), 1);
}

#[test]
fn expressions_of_faces_are_read_and_impossible_ones_are_not_faces() {
    let mut value = whole();
    let expression = json!({ "rightEye": 0.3, "leftEye": 0.1, "mouth": 0.0, "smile": -0.1 });
    value["photos"][0]["subjects"][0]["expression"] = expression.clone();
    value["photos"][1]["subjects"][0]["expression"] = json!({ "rightEye": 0.3 });
    value["photos"][2]["subjects"][0]["expression"] =
        json!({ "rightEye": 1e9, "leftEye": 0.1, "mouth": 0, "smile": 0 });
    let photos = read(&value).unwrap().photos;
    assert_eq!(json!(photos[0].subjects.as_ref().unwrap()[0].expression), expression);
    assert_eq!((&photos[1].subjects, &photos[2].subjects), (&None, &None));
}
