//! Text items by lettering rules: their rendering, and their automatic placement on pages of the bundled
//! photos.

#[path = "../../examples/lettering/measure.rs"]
mod measure;
#[path = "../../examples/lettering/pages.rs"]
mod pages;

use crate::golden::Goldens;
use inkpanel_engine::framing::{PhotoMeta, Subject};
use inkpanel_engine::layout::Point;
use inkpanel_engine::page::words::layout::{Chain, Ground, lay_all, measured};
use inkpanel_engine::page::words::place::{self, Known};
use inkpanel_engine::page::words::{Letters, TextItem, draw};
use inkpanel_engine::page::{Document, Scene, compose, png};
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::{Matte, Plane};
use inkpanel_engine::style::Context;
use measure::{Figures, measure};
use serde_json::{Value, json};

fn letters() -> Letters {
    Letters::bundled().unwrap()
}

fn every_kind() -> Document {
    Document::parse(include_str!("../../examples/lettering/kinds.json")).unwrap()
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
    let root = crate::root("");
    let (photos, letters) = (pages::photos(&pages::known(&root).unwrap()), letters());
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

/// The shape of a standing person in a box: a head over shoulders as wide as the box, then legs. Positions
/// are fractions of the box.
fn is_body(x: f64, y: f64) -> bool {
    let head = ((x - 0.5) / 0.17).hypot((y - 0.13) / 0.13) < 1.0;
    let trunk = (0.24..0.62).contains(&y) && (x - 0.5).abs() < 0.5 - 0.35 * (y - 0.24);
    head || trunk || y >= 0.62 && (0.06..0.3).contains(&(x - 0.5).abs())
}

/// Adds a mask of the people and animals to a photo. A photo without them gets no mask.
fn masked(photo: &PhotoMeta) -> PhotoMeta {
    let bodies: Vec<&Subject> =
        photo.subjects.iter().filter(|subject| subject.is_alive() && subject.label != "face").collect();
    let size = (photo.width as usize, photo.height as usize);
    let (width, height) = (240, 240 * size.1 / size.0);
    let shares = Plane::from_fn(width, height, |x, y| {
        let (x, y) = ((x as f64 + 0.5) / width as f64, (y as f64 + 0.5) / height as f64);
        let within = |body: &&&Subject| is_body((x - body.x) / body.width, (y - body.y) / body.height);
        if bodies.iter().find(within).is_some() { 255 } else { 0 }
    });
    let mask = (!bodies.is_empty()).then(|| Matte::new(&shares, size));
    PhotoMeta { mask, ..photo.clone() }
}

#[test]
fn masks_keep_balloons_off_bodies_better_than_boxes_do() {
    let root = crate::root("");
    let (plain, letters) = (pages::photos(&pages::known(&root).unwrap()), letters());
    let masked: Vec<PhotoMeta> = plain.iter().map(masked).collect();
    let (mut by_boxes, mut by_masks, mut moved) = (Figures::default(), Figures::default(), 0);
    for number in 0..pages::PAGES {
        let page = pages::page(&plain, number, &letters).unwrap();
        let again = pages::placed_again(&page, &masked, &letters).unwrap();
        moved += usize::from(again.words != page.words);
        by_boxes.add(measure(&page, &masked, &letters, &format!("page {number}")).unwrap());
        by_masks.add(measure(&again, &masked, &letters, &format!("page {number}")).unwrap());
    }
    let told = by_masks.told.join("\n");
    let shares = (by_boxes.covered_figures(), by_masks.covered_figures());
    println!("bodies covered: {:.2} % by boxes, {:.2} % by masks; {moved} pages differ", shares.0, shares.1);
    println!("tails right: {:.1} %, {:.1} %", by_boxes.right_tails(), by_masks.right_tails());
    assert!(by_masks.silhouettes.0 > 0.5 && shares.1 < 0.7 * shares.0, "{shares:?}");
    let none = (by_masks.faces.1, by_masks.outside, by_masks.overlaps, by_masks.crossing, by_masks.disorder);
    assert_eq!(none, (0, 0, 0, 0, 0), "{told}");
    assert!(by_masks.right_tails() >= 95.0, "{}\n{told}", by_masks.right_tails());
}

#[test]
fn a_mask_that_is_none_changes_no_place() {
    let root = crate::root("");
    let (plain, letters) = (pages::photos(&pages::known(&root).unwrap()), letters());
    let vague = |photo: &PhotoMeta, shares: fn(usize, usize) -> u8| {
        let size = (photo.width as usize, photo.height as usize);
        PhotoMeta { mask: Some(Matte::new(&Plane::from_fn(200, 150, shares), size)), ..photo.clone() }
    };
    let clouds: Vec<PhotoMeta> = plain.iter().map(|photo| vague(photo, |x, y| (x + y / 2) as u8)).collect();
    let specks: Vec<PhotoMeta> =
        plain.iter().map(|photo| vague(photo, |x, y| if x / 9 + y / 9 == 0 { 255 } else { 0 })).collect();
    for number in 0..8 {
        let page = pages::page(&plain, number, &letters).unwrap();
        for photos in [&clouds, &specks] {
            assert_eq!(
                pages::placed_again(&page, photos, &letters).unwrap().words,
                page.words,
                "page {number}"
            );
        }
    }
}

/// Returns the text items of a page with their positions. Each panel shows a photo with the given subjects.
fn placed_by(
    words: &[TextItem],
    subjects: &[Subject],
    shares: Option<fn(f64, f64) -> bool>,
) -> Vec<TextItem> {
    let mask = shares.map(|within| {
        let pixel = |x: usize, y: usize| within((x as f64 + 0.5) / 120.0, (y as f64 + 0.5) / 100.0);
        Matte::new(&Plane::from_fn(120, 100, |x, y| if pixel(x, y) { 255 } else { 0 }), (120, 100))
    });
    let mut page = page_of(words);
    for panel in &mut page.panels {
        panel.photo = Some("photo".into());
    }
    place::settle(&mut page, |_| Known { subjects, mask: mask.as_ref() }, &letters()).unwrap();
    page.words
}

#[test]
fn of_places_otherwise_alike_the_one_with_least_of_the_figure_is_taken() {
    // Nothing was detected in the photo. Its subject fills the upper left, the usual place of text.
    let corner: fn(f64, f64) -> bool = |x, y| x < 0.5 && y < 0.5;
    for kind in ["balloon", "caption", "effect"] {
        let word = [item(json!({ "kind": kind, "text": "Look!", "panel": 1 }))];
        let at = |words: Vec<TextItem>| [words[0].x.unwrap(), words[0].y.unwrap()];
        let [x, y] = at(placed_by(&word, &[], Some(corner)));
        assert!(x > 0.5 || y > 0.5, "{kind}: {x}, {y}");
    }
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
    // The later item draws only its glyphs, and nothing around them.
    let patch = draw::render(&document, later, 600, &letters()).unwrap();
    assert_eq!(patch.rgba[3], 0);
    // Without the other it is a balloon like any.
    let mut alone = document.clone();
    alone.words[later].joined = Some("nobody".into());
    assert!(lay_all(&alone, &letters()).unwrap().iter().all(|laid| laid.chain == Chain::None));
}

fn item(value: Value) -> TextItem {
    TextItem::read(value).unwrap()
}

fn page_of(words: &[TextItem]) -> Document {
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
            let word = json!({ "kind": kind, "text": text, "panel": 1, "language": "en" });
            let mut page = page_of(&[item(word)]);
            place::settle(&mut page, |_| Known::default(), &letters).unwrap();
            assert_eq!(page.words[0].text, text, "it is kept as it was written");
            let boxes = measured(&page, &letters).unwrap();
            assert!(boxes[0].width <= 1.0 && boxes[0].height <= 1754.0 / 1240.0, "{kind} {text:.20}");
            assert!(!draw::render(&page, 0, 300, &letters).unwrap().rgba.is_empty());
        }
    }
}

#[test]
fn text_is_read_panel_by_panel_from_top_to_bottom() {
    let at = |panel: usize, x: f64, y: f64| {
        item(json!({ "kind": "balloon", "text": "Oh.", "panel": panel, "auto": false, "x": x, "y": y }))
    };
    let words = [at(1, 0.5, 0.2), at(0, 0.8, 0.8), at(0, 0.7, 0.22), at(0, 0.2, 0.2)];
    let turns: Vec<usize> =
        measured(&page_of(&words), &letters()).unwrap().iter().map(|area| area.turn).collect();
    assert_eq!(turns, [3, 2, 1, 0]);
}

#[test]
fn two_hundred_words_of_a_page_are_placed_on_it() {
    let word = |i: usize| item(json!({ "kind": "balloon", "text": format!("Number {i}"), "panel": i % 2 }));
    let mut page = page_of(&(0..200).map(word).collect::<Vec<_>>());
    place::settle(&mut page, |_| Known::default(), &letters()).unwrap();
    let boxes = measured(&page, &letters()).unwrap();
    assert_eq!(boxes.len(), 200);
    assert!(boxes.iter().all(|area| area.x >= -1e-9 && area.x + area.width <= 1.0 + 1e-9));
}

#[test]
fn words_go_on_to_stand_where_they_were_placed() {
    let word = |text: &str| item(json!({ "kind": "balloon", "text": text, "panel": 0 }));
    let mut page = page_of(&[word("Who goes there?"), word("Nobody, sir, but me and my dog.")]);
    let letters = letters();
    place::settle(&mut page, |_| Known::default(), &letters).unwrap();
    let mut again = page.clone();
    place::settle(&mut again, |_| Known::default(), &letters).unwrap();
    assert_eq!(page.words, again.words);
}

fn face(x: f64, y: f64) -> Subject {
    Subject {
        x,
        y,
        width: 0.12,
        height: 0.16,
        label: "face".into(),
        score: 0.9,
        points: None,
        expression: None,
        light: None,
    }
}

/// A face whose points put the mouth into the lower left corner of its box.
fn turned(x: f64, y: f64) -> Subject {
    let at = |right: f64, down: f64| [x + 0.12 * right, y + 0.16 * down];
    let points = [at(0.1, 0.3), at(0.3, 0.3), at(0.05, 0.5), at(0.15, 0.75), at(0.6, 0.4), at(0.7, 0.4)];
    Subject { points: Some(points), ..face(x, y) }
}

/// Returns placed balloons on one panel with the given texts and speakers, around faces.
fn said(lines: &[(&str, Option<&str>)], faces: &[Subject]) -> Vec<TextItem> {
    let word = |(text, by): &(&str, Option<&str>)| {
        item(json!({ "kind": "balloon", "text": text, "panel": 0, "by": by }))
    };
    placed_by(&lines.iter().map(word).collect::<Vec<_>>(), faces, None)
}

/// Returns the number of the balloon that each text item was linked to.
fn links(words: &[TextItem]) -> Vec<Option<usize>> {
    let of = |word: &TextItem| words.iter().position(|other| other.id == word.linked && other.id.is_some());
    words.iter().map(of).collect()
}

#[test]
fn balloons_of_one_mouth_hang_together_by_themselves_and_the_first_has_the_tail() {
    let words = said(&[("Did you hear that?", None), ("It came from below.", None)], &[face(0.3, 0.6)]);
    assert_eq!(links(&words), [None, Some(0)]);
    assert!(words[0].tail.is_some() && words[1].tail.is_none(), "{words:?}");
    let all = lay_all(&page_of(&words), &letters()).unwrap();
    assert!(matches!(&all[0].chain, Chain::First { bodies, necks } if bodies.len() == 1 && necks.len() == 1));
    // Down, and aside.
    let (dx, dy) = (all[1].middle.x - all[0].middle.x, all[1].middle.y - all[0].middle.y);
    assert!(dy > 0.0 && dx.abs() > 0.005, "{dx} {dy}");
    // Placing them again does not move them.
    assert_eq!(placed_by(&words, &[face(0.3, 0.6)], None), words);
}

#[test]
fn a_tail_points_to_the_mouth_that_was_found() {
    let mut tails = Vec::new();
    for face in [face(0.45, 0.6), turned(0.45, 0.6)] {
        let words = said(&[("Did you hear that?", None)], std::slice::from_ref(&face));
        let all = lay_all(&page_of(&words), &letters()).unwrap();
        let frame = Ground::new(&page_of(&words)).unwrap().panels[0].bounds;
        let [x, y] = face.mouth();
        let mouth = Point::new(frame.x + x * frame.width, frame.y + y * frame.height);
        let (middle, tip) = (all[0].middle, all[0].tip.unwrap());
        let (dx, dy) = (tip.x - middle.x, tip.y - middle.y);
        let aside = ((mouth.x - middle.x) * dy - (mouth.y - middle.y) * dx).abs() / dx.hypot(dy);
        assert!(aside < 0.1 * face.height * frame.height, "{aside} beside the lips");
        tails.push(words[0].tail);
    }
    assert_ne!(tails[0], tails[1]);
}

#[test]
fn a_tail_ends_before_the_head_of_an_animal_without_a_face() {
    for (x, width) in [(0.1, 0.8), (0.0, 0.7), (0.3, 0.7)] {
        let cat = Subject { label: "cat".into(), x, y: 0.2, width, height: 0.8, ..face(0.0, 0.0) };
        for text in ["Look!", "Did you hear that?", "We could have taken the train, you know."] {
            let page = page_of(&said(&[(text, None)], std::slice::from_ref(&cat)));
            let laid = lay_all(&page, &letters()).unwrap().remove(0);
            let frame = Ground::new(&page).unwrap().panels[0].bounds;
            let tip = laid.tip.unwrap_or(laid.middle);
            let at = ((tip.x - frame.x) / frame.width, (tip.y - frame.y) / frame.height);
            // The head is in the middle of the upper half. A balloon next to it has a short tail.
            let head = (x + 0.25 * width..x + 0.75 * width, 0.22..0.55);
            let before = !head.0.contains(&at.0) || !head.1.contains(&at.1);
            let (a, b) = laid.setting.half;
            let away =
                ((tip.x - laid.middle.x).abs() / a).powf(2.4) + ((tip.y - laid.middle.y).abs() / b).powf(2.4);
            let length = tip.distance(laid.middle) * (1.0 - away.powf(-1.0 / 2.4));
            assert!(before || length < 0.02, "{text} at {at:?}, cat at {x}");
        }
    }
}

#[test]
fn the_whole_tail_avoids_other_faces() {
    let letters = letters();
    let mut tails = 0;
    for number in 0..60 {
        let part = |step: usize, of: usize| (number * step % of) as f64 / of as f64;
        let faces = [
            face(0.1 + 0.7 * part(7, 13), 0.45 + 0.35 * part(5, 11)),
            face(0.75 * part(3, 17), 0.2 + 0.4 * part(11, 7)),
        ];
        let said = said(&[("We could have taken the train, you know.", None), ("No.", None)], &faces);
        let page = page_of(&said);
        let frame = Ground::new(&page).unwrap().panels[0].bounds;
        for index in 0..2 {
            tails += usize::from(page.words[index].tail.is_some());
            let patch = draw::render(&page, index, 620, &letters).unwrap();
            for Subject { x, y, width, height, .. } in &faces {
                let inside = |px: usize, py: usize| {
                    let right = (patch.area.x as f64 + px as f64 + 0.5) / 620.0;
                    let down = (patch.area.y as f64 + py as f64 + 0.5) / 620.0;
                    let (right, down) = ((right - frame.x) / frame.width, (down - frame.y) / frame.height);
                    (*x..x + width).contains(&right) && (*y..y + height).contains(&down)
                };
                let opaque = |px: usize, py: usize| patch.rgba[(py * patch.area.width + px) * 4 + 3] > 127;
                let covered = (0..patch.area.height)
                    .flat_map(|py| (0..patch.area.width).map(move |px| (px, py)))
                    .filter(|&(px, py)| opaque(px, py) && inside(px, py))
                    .count();
                assert_eq!(covered, 0, "page {number}, word {index}: {:?}", page.words);
            }
        }
    }
    assert!(tails > 60, "{tails}");
}

#[test]
fn balloons_of_others_stay_apart() {
    let faces = [face(0.3, 0.6)];
    let names = |one, other| links(&said(&[("Who is it?", one), ("Me.", other)], &faces));
    assert_eq!(names(Some("anna"), Some("anna")), [None, Some(0)]);
    assert_eq!(names(Some("anna"), Some("ben")), [None, None]);
    // The user can separate them. A different look means another voice.
    let word = |more: Value| {
        let mut word = json!({ "kind": "balloon", "text": "Me.", "panel": 0 });
        word.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        item(word)
    };
    for second in [json!({ "apart": true }), json!({ "shape": "shout" }), json!({ "fill": "#ffcccc" })] {
        let words = placed_by(&[word(json!({})), word(second.clone())], &faces, None);
        assert_eq!(links(&words), [None, None], "{second}");
    }
    // Two people at a distance alternate.
    let two = [face(0.05, 0.7), face(0.83, 0.7)];
    assert_eq!(links(&said(&[("Who is it?", Some("anna")), ("Me.", Some("ben"))], &two)), [None, None]);
}

/// Returns the x coordinates of the ends of the tails, in fractions of the panel.
fn tips(words: &[TextItem]) -> Vec<f64> {
    words.iter().filter_map(|word| word.tail).map(|tail| tail.x).collect()
}

#[test]
fn consecutive_balloons_point_at_different_faces_of_one_size() {
    let apart = json!({ "kind": "balloon", "text": "Nobody but me.", "panel": 0, "apart": true });
    for (left, right) in [(0.2, 0.5), (0.3, 0.6), (0.35, 0.55), (0.5, 0.75)] {
        let smaller = Subject { width: 0.11, height: 0.15, ..face(right, 0.65) };
        let faces = [face(left, 0.65), smaller];
        let middle = f64::midpoint(left, right) + 0.06;
        // Placed together, and the second one after the first one was fixed.
        let words = [said(&[("Who goes there?", None)], &faces), vec![item(apart.clone())]].concat();
        let together = placed_by(&words, &faces, None);
        let fixed = TextItem { auto: Some(false), ..words[0].clone() };
        let later = placed_by(&[fixed, words[1].clone()], &faces, None);
        for words in [together, later] {
            let tips = tips(&words);
            assert_eq!(tips.len(), 2);
            assert!((tips[0] < middle) != (tips[1] < middle), "{tips:?} at {left} and {right}");
        }
    }
    // A face in the background does not speak.
    let small = Subject { width: 0.03, height: 0.04, ..face(0.8, 0.5) };
    let words = said(&[("Who goes there?", None)], &[face(0.2, 0.6), small.clone()]);
    let words = placed_by(&[words, vec![item(apart)]].concat(), &[face(0.2, 0.6), small], None);
    assert!(tips(&words).iter().all(|tip| *tip < 0.5), "{words:?}");
}

#[test]
fn a_sound_effect_is_smaller_where_it_would_cover_a_face() {
    let letters = letters();
    let big = |x: f64| Subject { width: 0.3, height: 0.72, ..face(x, 0.14) };
    let faces = [big(0.02), big(0.35), big(0.68)];
    let word = item(json!({ "kind": "effect", "text": "KRAWUMM", "panel": 0 }));
    let free = page_of(&placed_by(std::slice::from_ref(&word), &[], None));
    let page = page_of(&placed_by(&[word], &faces, None));
    let frame = Ground::new(&page).unwrap().panels[0].bounds;
    let area = |page: &Document| measured(page, &letters).unwrap().remove(0);
    let (small, usual) = (area(&page), area(&free));
    assert!(small.width < usual.width);
    for face in &faces {
        let x = frame.x + face.x * frame.width;
        let y = frame.y + face.y * frame.height;
        let beside = small.x + small.width <= x || small.x >= x + face.width * frame.width;
        let above = small.y + small.height <= y || small.y >= y + face.height * frame.height;
        assert!(beside || above, "{face:?}");
    }
}

#[test]
fn no_more_than_three_balloons_hang_together() {
    let lines = ["One.", "Two.", "Three.", "Four.", "Five."].map(|text| (text, Some("anna")));
    let mut longest = 0;
    for (x, y) in [(0.1, 0.8), (0.4, 0.8), (0.8, 0.8), (0.1, 0.4), (0.8, 0.4), (0.8, 0.1)] {
        let words = said(&lines, &[face(x, y)]);
        let links = links(&words);
        let mut length = 1;
        for (i, link) in links.iter().enumerate() {
            assert!(link.is_none_or(|before| before + 1 == i), "{links:?}");
            length = if link.is_some() { length + 1 } else { 1 };
            longest = longest.max(length);
            // Only the first balloon of a chain has a tail.
            assert_eq!(words[i].tail.is_none(), link.is_some(), "{words:?}");
        }
    }
    assert_eq!(longest, 3);
}

#[test]
fn a_balloon_that_hangs_on_one_that_stays_comes_beside_it() {
    let mut words = said(&[("Did you hear that?", None), ("It came from below.", None)], &[face(0.3, 0.6)]);
    let stands = words[0].clone();
    words[0].auto = Some(false);
    words[1].text = "It came from down there.".into();
    let again = placed_by(&words, &[face(0.3, 0.6)], None);
    assert_eq!((again[0].x, again[0].y), (stands.x, stands.y));
    assert_eq!(links(&again), [None, Some(0)]);
    let boxes = measured(&page_of(&again), &letters()).unwrap();
    let gap = boxes[1].y - boxes[0].y - boxes[0].height;
    assert!(gap < 0.02, "{gap}");
    // Without the other balloon, it has a separate tail.
    let alone = placed_by(&words[1..], &[face(0.3, 0.6)], None);
    assert!(alone[0].linked.is_none() && alone[0].tail.is_some(), "{alone:?}");
}

#[test]
fn names_of_balloons_are_found_anew_where_two_have_the_same() {
    let other = json!({ "kind": "balloon", "text": "Far.", "panel": 1, "id": "b1" });
    let mut words = vec![item(other)];
    for text in ["Did you hear that?", "It came from below."] {
        words.push(item(json!({ "kind": "balloon", "text": text, "panel": 0, "id": "b1" })));
    }
    let words = placed_by(&words, &[face(0.3, 0.6)], None);
    assert_eq!(links(&words), [None, None, Some(1)], "{words:?}");
}
