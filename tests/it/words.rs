//! Text items on the page: the rendering does not change, stays inside of its shape, is similar at every
//! size, and avoids faces.

use std::fs;

use crate::golden::Goldens;
use inkpanel_engine::framing::Subject;
use inkpanel_engine::layout::Point;
use inkpanel_engine::page::words::given::{GivenFonts, missing};
use inkpanel_engine::page::words::wording;
use inkpanel_engine::page::words::{Letters, TextItem, draw, layout, place};
use inkpanel_engine::page::{Document, Scene, compose, png};
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::resize::{Region, resample_image};
use inkpanel_engine::raster::{Image, Plane};
use inkpanel_engine::simd::point::luma_plane;
use inkpanel_engine::style::Context;
use serde_json::{Value, json};

fn letters() -> Letters {
    Letters::bundled().unwrap()
}

/// A text item as a list.
fn items(word: Value) -> Vec<TextItem> {
    vec![TextItem::read(word).unwrap()]
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
    drawn_with(document, width, &letters())
}

fn drawn_with(document: &Document, width: usize, letters: &Letters) -> Image {
    let scene = Scene::new(document, width).unwrap();
    let mut sheet = compose::compose(&scene, |_| None, &mut Context::default()).unwrap();
    draw::lay_words(&mut sheet, document, letters).unwrap();
    let bytes = png::encode(&sheet, 96).unwrap();
    decode(&bytes, &Limits::default()).unwrap().image
}

#[test]
fn a_page_of_words_looks_as_it_did() {
    // Letters and shapes are lines: no style is in the way, and no pixel may differ.
    let mut goldens = Goldens::of("words", 0.0);
    goldens.hold("every-kind", &drawn(&every_kind(), 620));
    let columns = in_columns();
    let letters = fonts(&["japanese.ttf"]).letters(&columns.words).unwrap();
    goldens.hold("columns", &drawn_with(&columns, 620, &letters));
    goldens.finish();
}

/// A folder of fonts, see `tests/oracles/fonts.py`.
fn font_file(name: &str) -> Vec<u8> {
    fs::read(crate::root("tests/oracles/data/fonts").join(name)).unwrap()
}

fn fonts(files: &[&str]) -> GivenFonts {
    let mut fonts = GivenFonts::default();
    for name in files {
        fonts.add(font_file(name)).unwrap();
    }
    fonts
}

fn said(text: &str) -> Value {
    json!({ "kind": "balloon", "text": text, "panel": 1, "x": 0.5, "y": 0.5 })
}

#[test]
fn given_fonts_are_shaped_as_harfbuzz_does() {
    let rows: Value = serde_json::from_slice(&font_file("shaped.json")).unwrap();
    for row in rows.as_array().unwrap() {
        let word = row["word"].as_str().unwrap();
        let letters = fonts(&[row["file"].as_str().unwrap()]).letters(&items(said(word))).unwrap();
        let font = letters.font("comic-neue").unwrap();
        let run = letters.cleaned(word);
        assert_eq!(run.len(), 1, "{word} is one letter by now");
        assert_eq!((letters.learnt(run[0]), letters.missing(word, font)), (Some(word), vec![]));
        assert!((letters.width(font, &run) - row["advance"].as_f64().unwrap()).abs() < 1e-4, "{word}");
        let points = font.outline(run[0], 0.001).concat();
        let sides: [fn(&Point) -> f64; 4] = [|p| p.x, |p| p.y, |p| -p.x, |p| -p.y];
        for (side, expected) in sides.iter().zip(row["bounds"].as_array().unwrap()) {
            let least = points.iter().map(side).fold(f64::MAX, f64::min).abs();
            assert!((least - expected.as_f64().unwrap().abs()).abs() < 0.002, "{word}: {least} {expected}");
        }
    }
}

/// Bounds of a glyph in vertical text, in pixels of a page with a width of 1000, relative to the middle of
/// the column's top.
fn standing_bounds(letter: &str, letters: &Letters) -> [f64; 4] {
    let page =
        document(&json!([columns(letter, &json!({ "kind": "caption", "boxless": true, "size": 0.1 }))]));
    let laid = &layout::lay_all(&page, letters).unwrap()[0];
    let patch = draw::render(&page, 0, 1000, letters).unwrap();
    // A caption without a box has an outline around its glyphs, in another colour.
    let (mut low, mut high) = ((f64::MAX, f64::MAX), (f64::MIN, f64::MIN));
    for i in 0..patch.area.width * patch.area.height {
        if patch.rgba[i * 4 + 3] == 255 && patch.rgba[i * 4] < 100 {
            let x = (i % patch.area.width) as f64 + patch.area.x as f64 + 0.5;
            let y = (i / patch.area.width) as f64 + patch.area.y as f64 + 0.5;
            low = (low.0.min(x), low.1.min(y));
            high = (high.0.max(x), high.1.max(y));
        }
    }
    let (x, y) = (laid.middle.x * 1000.0, (laid.middle.y - laid.setting.lines[0].1 / 2.0) * 1000.0);
    [low.0 - x, low.1 - y, high.0 - x, high.1 - y]
}

#[test]
fn letters_of_columns_have_the_forms_that_their_font_has_for_them() {
    let rows: Vec<Value> = serde_json::from_slice(&font_file("columns.json")).unwrap();
    let told: String = rows.iter().filter_map(|row| row["letter"].as_str()).collect();
    for letter in "「」、。っー…".chars() {
        assert!(told.contains(letter), "the font has a form of its own for {letter}");
    }
    for row in &rows {
        let letter = row["letter"].as_str().unwrap();
        let letters = fonts(&["japanese.ttf"]).letters(&items(columns(letter, &json!({})))).unwrap();
        let font = letters.font("comic-neue").unwrap();
        if letters.cleaned(letter).iter().all(|&own| letters.learnt(own).is_none()) {
            continue;
        }
        assert_eq!(letters.missing(letter, font), [], "{letter}");
        let bounds = standing_bounds(letter, &letters);
        let expected: Vec<f64> =
            row["bounds"].as_array().unwrap().iter().map(|side| side.as_f64().unwrap() * 100.0).collect();
        let expected = [expected[0], -expected[3], expected[2], -expected[1]];
        for (found, side) in bounds.iter().zip(expected) {
            assert!((found - side).abs() < 2.0, "{letter}: {bounds:?} {expected:?}");
        }
    }
}

#[test]
fn forms_for_columns_are_for_columns_alone() {
    let text = "「っ」";
    let lying = fonts(&["japanese.ttf"]).letters(&items(said(text))).unwrap();
    let both = fonts(&["japanese.ttf"]).letters(&items(columns(text, &json!({})))).unwrap();
    let word = document(&json!([said(text)]));
    let [one, other] = [&lying, &both].map(|letters| draw::render(&word, 0, 600, letters).unwrap().rgba);
    assert_eq!(one, other);
    // Characters without a vertical form in the font are rotated and moved as before.
    let columned = document(&json!([columns("漢字", &json!({}))]));
    let [one, other] = [said("漢字"), columns("漢字", &json!({}))].map(|word| {
        draw::render(&columned, 0, 600, &fonts(&["japanese.ttf"]).letters(&items(word)).unwrap())
            .unwrap()
            .rgba
    });
    assert_eq!(one, other);
}

/// Returns the rows of a text item on a square page: characters, scale and positions.
fn ruby_page(text: &str, more: &Value) -> (layout::Laid, Letters) {
    let mut word = said(text);
    for (name, value) in more.as_object().unwrap() {
        word[name] = value.clone();
    }
    let page = document(&json!([word]));
    let letters = fonts(&["japanese.ttf"]).letters(&page.words).unwrap();
    let laid = layout::lay_all(&page, &letters).unwrap().remove(0);
    (laid, letters)
}

#[test]
fn readings_make_their_balloon_larger_and_are_read_behind_their_letters() {
    for vertical in [false, true] {
        let more = json!({ "vertical": vertical, "size": 0.02 });
        let (with, letters) = ruby_page("漢字《そうか》でも縦書き", &more);
        let (without, _) = ruby_page("漢字でも縦書き", &more);
        let text = |laid: &layout::Laid| -> String {
            laid.setting
                .lines
                .iter()
                .flat_map(|(line, _)| line)
                .map(|&letter| letters.text_of(letter))
                .collect()
        };
        // The ruby notation is not part of the text, and the reading does not widen the line.
        assert_eq!(text(&with), "漢字でも縦書き");
        let area = |laid: &layout::Laid| laid.setting.half.0 * laid.setting.half.1;
        assert!(area(&with) > 1.1 * area(&without), "{} {}", area(&with), area(&without));
        assert_eq!(wording::read(&with.word), "漢字（そうか）でも縦書き");
    }
}

#[test]
fn letters_and_their_reading_stay_in_one_line() {
    let text = "だって漢字《そうかそうか》でも漢字《そうか》見た漢字《そう》だって書《か》き";
    for vertical in [false, true] {
        for width in [0.1, 0.14, 0.2, 0.3] {
            let (laid, _) = ruby_page(text, &json!({ "vertical": vertical, "width": width, "size": 0.018 }));
            let mut seen = Vec::new();
            for under in &laid.setting.under {
                let mut numbers: Vec<u16> =
                    under.iter().map(|under| under.reading).filter(|n| *n > 0).collect();
                numbers.dedup();
                assert!(numbers.iter().all(|number| !seen.contains(number)), "{width}: {numbers:?} {seen:?}");
                seen.extend(numbers);
            }
            assert_eq!(seen, [1, 2, 3, 4], "{vertical} {width}");
        }
    }
}

#[test]
fn readings_touch_neither_each_other_nor_their_letters_nor_the_next_line() {
    // Long readings over single characters, adjacent and in several lines.
    let text = "漢《そうかそうか》字《だってだって》でも見《だってだ》た縦《そうか》書《か》き";
    for vertical in [false, true] {
        for width in [0.14, 0.24] {
            let (laid, letters) =
                ruby_page(text, &json!({ "vertical": vertical, "width": width, "size": 0.02 }));
            let boxes = draw::boxes(&laid, 2000.0, &letters);
            assert!(boxes.iter().filter(|(scale, _)| *scale < 1.0).count() >= 20, "{}", boxes.len());
            for (i, (scale, a)) in boxes.iter().enumerate() {
                for (other, b) in boxes.iter().skip(i + 1) {
                    if scale.min(*other) > 0.99 {
                        continue;
                    }
                    let shared = |low: f64, high: f64, from: f64, to: f64| high.min(to) - low.max(from);
                    let (x, y) = (shared(a.0, a.2, b.0, b.2), shared(a.1, a.3, b.1, b.3));
                    assert!(x < 0.6 || y < 0.6, "{vertical} {width}: {a:?} {b:?}");
                }
                // All of it is in the balloon.
                let (half, middle) = (laid.setting.half, laid.middle);
                for (x, y) in [(a.0, a.1), (a.2, a.1), (a.0, a.3), (a.2, a.3)] {
                    let x = (x / 2000.0 - middle.x).abs() / half.0;
                    let y = (y / 2000.0 - middle.y).abs() / half.1;
                    assert!(x.powf(2.4) + y.powf(2.4) < 1.0, "{vertical} {width}: {x} {y}");
                }
            }
        }
    }
}

#[test]
fn cubic_outlines_are_those_of_quadratic_ones() {
    let ink = |file: &str| {
        let letters = fonts(&[file]).letters(&items(said("漢字"))).unwrap();
        let font = letters.font("comic-neue").unwrap();
        let area = |line: &[Point]| {
            line.iter().zip(line.iter().cycle().skip(1)).map(|(a, b)| a.x * b.y - b.x * a.y).sum::<f64>()
        };
        let run = letters.cleaned("漢字");
        assert!(run.iter().all(|&letter| letters.learnt(letter).is_some()), "{file}");
        run.iter()
            .map(|&l| font.outline(l, 0.001).iter().map(|line| area(line)).sum::<f64>())
            .collect::<Vec<_>>()
    };
    for (one, other) in ink("cubic.otf").iter().zip(ink("japanese.ttf")) {
        assert!(*one < -0.1 && (one - other).abs() < 0.01 * other.abs(), "{one} {other}");
    }
}

#[test]
fn the_first_font_that_has_a_letter_gives_it_and_what_none_has_is_named() {
    let word = items(said("مرحبا 漢字 ок 😀 \u{e000}"));
    let both = fonts(&["arabic.ttf", "cubic.otf", "japanese.ttf"]);
    let letters = both.letters(&word).unwrap();
    assert_eq!(missing(&letters, &word), ["😀", "U+E000"]);
    let none = GivenFonts::default().letters(&word).unwrap();
    assert_eq!(missing(&none, &word).len(), 9);
}

#[test]
fn fonts_that_are_broken_are_refused_or_read_as_far_as_they_are_whole() {
    let mut fonts = GivenFonts::default();
    assert!(fonts.add(Vec::new()).unwrap_err().contains("not a valid TrueType"));
    assert!(fonts.add(b"no font at all".to_vec()).unwrap_err().contains("not a valid TrueType"));
    assert!(fonts.add(vec![0; (64 << 20) + 1]).unwrap_err().contains("64 MB"));
    for name in ["arabic.ttf", "japanese.ttf", "cubic.otf"] {
        let whole = font_file(name);
        let mut state = 7u32;
        for _ in 0..120 {
            let mut file = whole.clone();
            for _ in 0..12 {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                let at = state as usize % file.len();
                file[at] = (state >> 16) as u8;
            }
            file.truncate(file.len() - (state >> 8) as usize % 300);
            let mut fonts = GivenFonts::default();
            if fonts.add(file).is_ok() {
                let document = document(&json!([said("漢字 何だ 「夜」 مرحبا بالعالم")]));
                let letters = fonts.letters(&document.words).unwrap();
                assert!(draw::render(&document, 0, 300, &letters).is_ok());
            }
        }
    }
}

fn columns(text: &str, more: &Value) -> Value {
    let mut word = said(text);
    word["vertical"] = json!(true);
    for (name, value) in more.as_object().unwrap() {
        word[name] = value.clone();
    }
    word
}

const NIGHT: &str = "「夜の灯台、見た？」そうか…だって！漢字でも縦書き。";

/// Columns in balloons, a caption and an effect.
fn in_columns() -> Document {
    document(&json!([
        columns(NIGHT, &json!({ "panel": 0, "tail": { "x": 0.2, "y": 0.95 } })),
        columns("何だって！？", &json!({ "panel": 1, "kind": "effect", "angle": 8 })),
        columns("漢字でも縦書き 24台、OK!? 2026", &json!({ "panel": 2, "kind": "caption" })),
        columns(NIGHT, &json!({ "panel": 3, "width": 0.3 })),
        columns(NIGHT, &json!({ "panel": 4, "shape": "thought", "size": 0.012 })),
        columns("見*た*ってー", &json!({ "panel": 5, "shape": "shout" })),
    ]))
}

#[test]
fn columns_run_from_right_to_left_inside_of_their_shapes() {
    let page = in_columns();
    let letters = fonts(&["japanese.ttf"]).letters(&page.words).unwrap();
    let all = layout::lay_all(&page, &letters).unwrap();
    let text = |line: &[char]| line.iter().map(|&letter| letters.text_of(letter)).collect::<String>();
    for (index, laid) in all.iter().enumerate() {
        let setting = &laid.setting;
        assert!(!setting.cut && setting.size > 0.009, "word {index}");
        let (a, b) = setting.half;
        let count = setting.lines.len() as f64;
        let longest = setting.lines.iter().map(|line| line.1).fold(0.0, f64::max);
        assert!((count - 1.0) * setting.pitch + setting.size < 2.0 * a + 1e-9, "word {index}");
        assert!(longest < 2.0 * b, "word {index}");
        for (line, _) in &setting.lines {
            let line = text(line);
            assert!(!line.starts_with(['、', '。', '？', '！', '」', 'っ', 'ー', '…']), "{line}");
            assert!(!line.ends_with('「'), "{line}");
        }
    }
    let spoken = &all[0].setting;
    assert!(spoken.lines.len() > 1 && spoken.half.1 > spoken.half.0, "columns are high");
    assert!((all[3].setting.half.0 - 0.15).abs() < 1e-9 && all[3].setting.lines.len() > spoken.lines.len());
    // The first column is on the right: without the glyphs of the other column, there is ink only on the
    // right.
    let one = document(&json!([columns("漢\n…", &json!({ "kind": "caption", "size": 0.04 }))]));
    let letters = fonts(&["japanese.ttf"]).letters(&one.words).unwrap();
    let patch = draw::render(&one, 0, 900, &letters).unwrap();
    let dark = |part: std::ops::Range<usize>| {
        let pixel = |i: &usize| patch.rgba[i * 4 + 3] == 255 && patch.rgba[i * 4] < 90;
        let at = |i: &usize| part.contains(&(i % patch.area.width));
        (0..patch.area.width * patch.area.height).filter(|i| at(i) && pixel(i)).count()
    };
    let half = patch.area.width / 2;
    assert!(dark(half..patch.area.width) > dark(0..half) + 100);
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
        // Glyphs are dark on a light background: each line contains some, and its ends contain no ink.
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
    place::settle(&mut document, |_| faces.into(), &letters()).unwrap();
    document
}

fn face(x: f64, y: f64) -> Subject {
    Subject {
        x,
        y,
        width: 0.2,
        height: 0.25,
        label: "face".into(),
        score: 0.9,
        points: None,
        expression: None,
        light: None,
    }
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
    assert!(one.tail.unwrap().x + 0.2 < two.tail.unwrap().x);
    assert_eq!((mine.x, mine.tail), (Some(0.5), None));
    assert!(one.is_auto(), "it goes on to follow the faces");
}

#[test]
fn words_outlive_a_layout_of_fewer_panels_and_never_leave_the_page() {
    let mut document = document(&json!([{ "kind": "caption", "text": "Here", "panel": 5, "x": 9, "y": -9 }]));
    document.layout = "splash".into();
    document.panels.truncate(1);
    let laid = &layout::lay_all(&document, &letters()).unwrap()[0];
    let (a, b) = layout::extent(&laid.word, &laid.setting);
    assert!(laid.middle.x + a <= 1.0 + 1e-9 && laid.middle.y - b >= -1e-9);
}

/// Runs `inkpanel render` with text on two photos.
fn rendered(words: &str) -> (std::process::Output, Option<Image>) {
    let folder = tempfile::tempdir().unwrap();
    let [list, page] = ["words.json", "page.png"].map(|name| folder.path().join(name));
    fs::write(&list, words).unwrap();
    let output = crate::inkpanel()
        .args(["render", "--no-detect", "--layout", "splash", "--style", "noir", "--width", "400", "--words"])
        .arg(&list)
        .arg("-o")
        .arg(&page)
        .arg(crate::root("tests/photos/bee.jpg"))
        .output()
        .unwrap();
    let image = fs::read(&page).ok().map(|bytes| decode(&bytes, &Limits::default()).unwrap().image);
    (output, image)
}

#[test]
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
