//! Words on the page: what is drawn is what was drawn before, inside of its shape, alike at every size, and away from
//! faces.
#![allow(clippy::unwrap_used, reason = "a test may stop at the first thing that is not as expected")]

mod golden;

use std::fs;
use std::path::{Path, PathBuf};

use golden::Goldens;
use inkpanel::framing::Subject;
use inkpanel::page::words::{Letters, Word, draw, layout, place};
use inkpanel::page::{Document, Scene, compose, png};
use inkpanel::raster::decode::{Limits, decode};
use inkpanel::raster::resize::{Region, resample_image};
use inkpanel::raster::{Image, Plane};
use inkpanel::simd::point::luma_plane;
use inkpanel::style::Context;
use serde_json::{Value, json};

fn root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn letters() -> Letters {
    Letters::bundled().unwrap()
}

fn document(words: &Value) -> Document {
    let panels: Vec<Value> = (0..6).map(|_| json!({ "photo": null })).collect();
    let value = json!({
        "version": 1, "seed": 1, "layout": "grid-6", "style": "noir", "panels": panels, "words": words,
        "page": { "width": 1240, "height": 1754 },
    });
    Document::parse(&value.to_string()).unwrap()
}

/// One of each kind, with the languages that the fonts have.
fn every_kind() -> Document {
    document(&json!([
        { "kind": "caption", "text": "Meanwhile, at the old lighthouse, nobody slept.", "panel": 0, "x": 0.4, "y": 0.12 },
        { "kind": "balloon", "text": "I never thought we would see it again, not after such a night.", "panel": 0,
          "x": 0.5, "y": 0.55, "tail": { "x": 0.2, "y": 0.95 } },
        { "kind": "balloon", "shape": "thought", "text": "Où est passé l’été… ?", "panel": 1, "x": 0.55, "y": 0.35,
          "tail": { "x": 0.2, "y": 0.85 } },
        { "kind": "balloon", "shape": "shout", "text": "WATCH OUT, EVERYBODY!", "panel": 2, "x": 0.5, "y": 0.4,
          "tail": { "x": 0.75, "y": 0.9 } },
        { "kind": "balloon", "shape": "whisper", "text": "psst… niño, ¿qué pasa? Żółć!", "panel": 3, "x": 0.5, "y": 0.4,
          "tail": { "x": 0.9, "y": 0.8 } },
        { "kind": "effect", "text": "KRAKOOM!", "panel": 4, "x": 0.5, "y": 0.3, "angle": -12, "arc": 0.8, "width": 0.42 },
        { "kind": "effect", "text": "drip\ndrop", "panel": 4, "x": 0.7, "y": 0.8, "color": "#3a6ee8", "fill": "#ffffff" },
        { "kind": "balloon", "text": "Hi", "panel": 5, "x": 0.3, "y": 0.3 },
        { "kind": "caption", "text": "שלום 😀 AVAST", "panel": 5, "x": 0.5, "y": 0.7, "fill": "#111111", "color": "#ffffff" },
    ]))
}

fn drawn(document: &Document, width: usize) -> Image {
    let scene = Scene::new(document, width).unwrap();
    let mut sheet = compose::compose(&scene, |_| None, &mut Context::default()).unwrap();
    draw::lay_words(&mut sheet, document, &letters()).unwrap();
    let bytes = png::encode(&sheet, 96).unwrap();
    decode(&bytes, &Limits::default()).unwrap().image
}

#[test]
fn a_page_of_words_looks_as_it_did() {
    // Letters and shapes are lines: no style is in the way, and no pixel may differ.
    let mut goldens = Goldens::of("words", 0.0);
    goldens.hold("every-kind", &drawn(&every_kind(), 620));
    goldens.finish();
}

/// Mean structural similarity of blocks of 8 x 8 pixels.
fn similarity(a: &Plane, b: &Plane) -> f64 {
    let mut sum = 0.0;
    let mut count = 0.0;
    for top in (0..a.height() - 8).step_by(4) {
        for left in (0..a.width() - 8).step_by(4) {
            let mut moments = [0.0; 5];
            for i in 0..64 {
                let [p, q] = [a, b].map(|plane| f64::from(plane.at(left + i % 8, top + i / 8)));
                for (moment, value) in moments.iter_mut().zip([p, q, p * p, q * q, p * q]) {
                    *moment += value / 64.0;
                }
            }
            let [p, q, pp, qq, pq] = moments;
            sum += (2.0 * p * q + 6.5) * (2.0 * (pq - p * q) + 58.5)
                / ((p * p + q * q + 6.5) * (pp - p * p + qq - q * q + 58.5));
            count += 1.0;
        }
    }
    sum / count
}

#[test]
fn the_preview_is_the_print_made_small() {
    let document = every_kind();
    let print = drawn(&document, 1680);
    let preview = drawn(&document, 420);
    let whole = Region::whole(print.width(), print.height());
    let reduced = resample_image(&print, whole, preview.width(), preview.height());
    let same = similarity(&luma_plane(&reduced), &luma_plane(&preview));
    assert!(same > 0.97, "{same}");
}

#[test]
fn words_are_drawn_inside_of_their_shapes_and_always_alike() {
    let document = every_kind();
    let letters = letters();
    for (index, laid) in layout::lay_all(&document, &letters).unwrap().iter().enumerate() {
        let once = draw::render(&document, index, 900, &letters).unwrap();
        let again = draw::render(&document, index, 900, &letters).unwrap();
        assert_eq!(once.rgba, again.rgba);
        let (a, b) = (layout::extent(&laid.word, &laid.setting).0, laid.setting.half.1);
        let area = once.area;
        assert!(area.x as f64 >= (laid.middle.x - a).min(laid.tip.map_or(1.0, |tip| tip.x)) * 900.0 - 5.0);
        assert!(area.y as f64 <= (laid.middle.y - b * 0.6) * 900.0);
        assert!(once.rgba.chunks(4).any(|pixel| pixel[3] == 255));
        // Letters are dark on light: each line has some, and none at its ends.
        if laid.word.tail.is_some() {
            let rgba = |x: f64, y: f64| {
                let (x, y) = ((x * 900.0) as i64 - area.x, (y * 900.0) as i64 - area.y);
                once.rgba[(y as usize * area.width + x as usize) * 4]
            };
            let last = (laid.setting.lines.len() - 1) as f64 / 2.0;
            for (line, (_, width)) in laid.setting.lines.iter().enumerate() {
                let y = laid.middle.y + (line as f64 - last) * laid.setting.pitch;
                let along = |from: f64, to: f64| {
                    (0..200)
                        .map(move |i| from + (to - from) * f64::from(i) / 200.0)
                        .any(|x| rgba(laid.middle.x + x, y) < 90)
                };
                assert!(along(-width / 2.0, width / 2.0), "word {index}, line {line} is empty");
            }
        }
    }
}

/// A page whose every photo has faces at the same places.
fn settled(words: &Value, faces: &[Subject]) -> Document {
    let mut value: Value = serde_json::from_str(&document(words).to_json()).unwrap();
    for panel in value["panels"].as_array_mut().unwrap() {
        panel["photo"] = json!("p");
    }
    let mut document = Document::parse(&value.to_string()).unwrap();
    place::settle(&mut document, |_| faces, &letters()).unwrap();
    document
}

fn face(x: f64, y: f64) -> Subject {
    Subject { x, y, width: 0.2, height: 0.25, label: "face".into(), score: 0.9 }
}

#[test]
fn words_keep_away_from_faces_and_from_each_other() {
    let letters = letters();
    let spots =
        [[0.1, 0.1], [0.4, 0.1], [0.7, 0.1], [0.1, 0.4], [0.4, 0.4], [0.7, 0.4], [0.1, 0.7], [0.7, 0.7]];
    for [x, y] in spots {
        let words = json!([
            { "kind": "balloon", "text": "Who goes there?", "panel": 1 },
            { "kind": "caption", "text": "Later that night", "panel": 1 },
            { "kind": "effect", "text": "CREAK", "panel": 1, "width": 0.16 },
        ]);
        let document = settled(&words, &[face(x, y)]);
        let ground = layout::Ground::new(&document).unwrap();
        let panel = ground.panels[1].bounds;
        let (left, top) = (panel.x + x * panel.width, panel.y + y * panel.height);
        let (right, bottom) = (left + 0.2 * panel.width, top + 0.25 * panel.height);
        let mut boxes: Vec<[f64; 4]> = vec![[left, top, right, bottom]];
        for laid in layout::lay_all(&document, &letters).unwrap() {
            let (a, b) = layout::extent(&laid.word, &laid.setting);
            let own = [laid.middle.x - a, laid.middle.y - b, laid.middle.x + a, laid.middle.y + b];
            for other in &boxes {
                let apart =
                    own[0] >= other[2] || own[2] <= other[0] || own[1] >= other[3] || own[3] <= other[1];
                assert!(apart, "face at {x} {y}: {:?} lies on another", laid.word.text);
            }
            assert!(own[0] >= panel.x - 1e-4 && own[2] <= panel.x + panel.width + 1e-4);
            if let Some(tip) = laid.tip {
                let mouth = (left.midpoint(right), top + 0.72 * (bottom - top));
                let aim = (tip.x - mouth.0).hypot(tip.y - mouth.1);
                assert!(aim < 0.25 * panel.width, "the tail ends {aim} from the mouth");
            }
            boxes.push(own);
        }
    }
}

#[test]
fn two_balloons_have_two_speakers_and_what_was_moved_stays() {
    let words = json!([
        { "kind": "balloon", "text": "One", "panel": 0 },
        { "kind": "balloon", "text": "Two", "panel": 0 },
        { "kind": "balloon", "text": "Mine", "panel": 0, "x": 0.5, "y": 0.5, "tail": null },
    ]);
    let document = settled(&words, &[face(0.05, 0.6), face(0.7, 0.6)]);
    let [one, two, mine] = &document.words[..] else { panic!() };
    assert!(one["tail"]["x"].as_f64().unwrap() + 0.2 < two["tail"]["x"].as_f64().unwrap());
    assert_eq!((&mine["x"], &mine["tail"]), (&json!(0.5), &Value::Null));
    assert!(Word::parse(one, 0).unwrap().auto, "it goes on to follow the faces");
}

#[test]
fn words_outlive_a_layout_of_fewer_panels_and_never_leave_the_page() {
    let mut document = document(&json!([{ "kind": "caption", "text": "Here", "panel": 5, "x": 9, "y": -9 }]));
    document.layout = json!("splash");
    document.panels.truncate(1);
    let laid = &layout::lay_all(&document, &letters()).unwrap()[0];
    let (a, b) = layout::extent(&laid.word, &laid.setting);
    assert!(laid.middle.x + a <= 1.0 + 1e-9 && laid.middle.y - b >= -1e-9);
}

/// Runs `inkpanel render` with words on two photos.
#[cfg(feature = "cli")]
fn rendered(words: &str) -> (std::process::Output, Option<Image>) {
    let folder = tempfile::tempdir().unwrap();
    let [list, page] = ["words.json", "page.png"].map(|name| folder.path().join(name));
    fs::write(&list, words).unwrap();
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_inkpanel"))
        .args(["render", "--no-detect", "--layout", "splash", "--style", "noir", "--width", "400", "--words"])
        .arg(&list)
        .arg("-o")
        .arg(&page)
        .arg(root("tests/photos/bee.jpg"))
        .output()
        .unwrap();
    let image = fs::read(&page).ok().map(|bytes| decode(&bytes, &Limits::default()).unwrap().image);
    (output, image)
}

#[test]
#[cfg(feature = "cli")]
fn the_command_line_puts_words_on_a_page_and_names_what_is_wrong() {
    let (_, without) = rendered("[]");
    let (output, with) = rendered(r#"[{"kind": "caption", "text": "Once upon a time", "panel": 0}]"#);
    assert!(output.status.success());
    let planes = |image: &Option<Image>| image.as_ref().unwrap().planes().to_vec();
    let differing = planes(&with)
        .iter()
        .zip(&planes(&without))
        .map(|(a, b)| a.samples().iter().zip(b.samples()).filter(|(a, b)| a != b).count())
        .sum::<usize>();
    assert!(differing > 300, "{differing}");
    for (wrong, named) in [("{", "words.json"), (r#"[{"kind": "poem"}]"#, "words[0].kind")] {
        let (output, image) = rendered(wrong);
        assert_eq!((output.status.code(), image.is_none()), (Some(1), true));
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.contains(named), "{said}");
    }
}
