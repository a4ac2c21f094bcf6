//! Words that letter by the conventions of letterers: how they look, and where they go by themselves on pages of the photos
//! that come with the program.
#![allow(clippy::unwrap_used, reason = "a test may stop at the first thing that is not as expected")]

mod golden;
#[path = "../examples/lettering/measure.rs"]
mod measure;
#[path = "../examples/lettering/pages.rs"]
mod pages;

use std::path::Path;

use golden::Goldens;
use inkpanel::page::words::layout::{Chain, lay_all, measured};
use inkpanel::page::words::{Letters, draw, place};
use inkpanel::page::{Document, Scene, compose, png};
use inkpanel::raster::decode::{Limits, decode};
use inkpanel::style::Context;
use measure::{Figures, measure};
use serde_json::{Value, json};

fn letters() -> Letters {
    Letters::bundled().unwrap()
}

fn every_kind() -> Document {
    Document::parse(include_str!("../examples/lettering/kinds.json")).unwrap()
}

#[test]
fn a_page_by_a_letterer_looks_as_it_did() {
    let document = every_kind();
    let scene = Scene::new(&document, 620).unwrap();
    let mut sheet = compose::compose(&scene, |_| None, &mut Context::default()).unwrap();
    draw::lay_words(&mut sheet, &document, &letters()).unwrap();
    let image = decode(&png::encode(&sheet, 96).unwrap(), &Limits::default()).unwrap().image;
    let mut goldens = Goldens::of("lettering", 0.0);
    goldens.hold("every-kind", &image);
    goldens.finish();
}

#[test]
fn balloons_on_forty_pages_cover_no_face_and_say_who_speaks() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (photos, letters) = (pages::photos(&pages::known(root).unwrap()), letters());
    let mut all = Figures::default();
    for number in 0..pages::PAGES {
        let page = pages::page(&photos, number, &letters).unwrap();
        all.add(measure(&page, &photos, &letters, &format!("page {number}")).unwrap());
    }
    let told = all.told.join("\n");
    assert_eq!(all.balloons, pages::PAGES as usize * pages::BALLOONS);
    assert!(all.faces.0 > 60, "{} faces are too few to tell", all.faces.0);
    let none = (all.faces.1, all.outside, all.overlaps, all.crossing, all.disorder);
    assert_eq!(none, (0, 0, 0, 0, 0), "{told}");
    assert!(all.covered_bodies() < 2.0, "{} % of bodies are covered", all.covered_bodies());
    assert!(all.right_tails() >= 95.0, "{}\n{told}", all.right_tails());
    assert!(all.points.unwrap().0 >= 6.0, "{:?}", all.points);
}

#[test]
fn joined_balloons_are_one_shape_with_one_tail() {
    let document = every_kind();
    let all = lay_all(&document, &letters()).unwrap();
    let first = all.iter().find(|laid| laid.word.id.as_deref() == Some("a")).unwrap();
    let Chain::First { bodies, necks } = &first.chain else { panic!("{:?}", first.chain) };
    assert_eq!((bodies.len(), necks.len()), (1, 1));
    let later = all.iter().position(|laid| laid.word.joined.is_some()).unwrap();
    assert_eq!(all[later].chain, Chain::Later);
    // The later one draws its letters alone: nothing around them.
    let patch = draw::render(&document, later, 600, &letters()).unwrap();
    assert_eq!(patch.rgba[3], 0);
    // Without the other it is a balloon like any.
    let mut alone = document.clone();
    alone.words[later]["joined"] = json!("nobody");
    assert!(lay_all(&alone, &letters()).unwrap().iter().all(|laid| laid.chain == Chain::None));
}

fn page_of(words: &[Value]) -> Document {
    let mut document = every_kind();
    document.words = words.to_vec();
    document
}

#[test]
fn odd_text_gets_an_answer_and_nothing_of_it_is_lost() {
    let letters = letters();
    let long = "All work and no play. ".repeat(454);
    let texts = [
        long.as_str(),
        &"x".repeat(10_000),
        &"*".repeat(10_000),
        &"'".repeat(10_000),
        &"\n".repeat(10_000),
        "\u{0}\u{7}\u{1b}[31m\u{7f}",
        "\u{202e}txet sdrawkcab\u{202c} \u{2066}\u{2069}",
        "\u{f8f0}\u{f8f1} private",
        "e\u{301}\u{301}\u{301}\u{301}",
        "😀 שלום 漢字",
        "",
    ];
    for text in texts {
        for kind in ["caption", "balloon", "effect"] {
            let mut page =
                page_of(&[json!({ "kind": kind, "craft": 2, "text": text, "panel": 1, "language": "en" })]);
            place::settle(&mut page, |_| &[], &letters).unwrap();
            assert_eq!(page.words[0]["text"], json!(text), "it is kept as it was written");
            let boxes = measured(&page, &letters).unwrap();
            assert!(boxes[0].width <= 1.0 && boxes[0].height <= 1754.0 / 1240.0, "{kind} {text:.20}");
            assert!(!draw::render(&page, 0, 300, &letters).unwrap().rgba.is_empty());
        }
    }
}

#[test]
fn two_hundred_words_of_a_page_are_placed_on_it() {
    let word =
        |i: usize| json!({ "kind": "balloon", "craft": 2, "text": format!("Number {i}"), "panel": i % 2 });
    let mut page = page_of(&(0..200).map(word).collect::<Vec<_>>());
    place::settle(&mut page, |_| &[], &letters()).unwrap();
    let boxes = measured(&page, &letters()).unwrap();
    assert_eq!(boxes.len(), 200);
    assert!(boxes.iter().all(|area| area.x >= -1e-9 && area.x + area.width <= 1.0 + 1e-9));
}

#[test]
fn words_go_on_to_stand_where_they_were_placed() {
    let word = |text: &str| json!({ "kind": "balloon", "craft": 2, "text": text, "panel": 0 });
    let mut page = page_of(&[word("Who goes there?"), word("Nobody, sir, but me and my dog.")]);
    let letters = letters();
    place::settle(&mut page, |_| &[], &letters).unwrap();
    let mut again = page.clone();
    place::settle(&mut again, |_| &[], &letters).unwrap();
    assert_eq!(page.words, again.words);
}
