//! Pages as PDF files: their size, the pictures of their panels, and text that can be found. That they look as the page
//! of pixels does is for the browser tests, which have a program that draws them.
#![allow(clippy::unwrap_used, reason = "a test may stop at the first thing that is not as expected")]

use inkpanel::page::mask::PixelRect;
use inkpanel::page::pdf::{Leaf, picture, write};
use inkpanel::page::words::{Letters, truetype};
use inkpanel::page::{Document, Scene, compose};
use inkpanel::raster::decode::{Limits, decode};
use inkpanel::raster::{Image, Plane};
use inkpanel::style::Context;
use miniz_oxide::inflate::decompress_to_vec_zlib;
use serde_json::{Value, json};
use ttf_parser::{Face, GlyphId, OutlineBuilder};

fn letters() -> Letters {
    Letters::bundled().unwrap()
}

/// Six panels, the first with a photo.
fn document(words: &Value) -> Document {
    let panels: Vec<Value> =
        (0..6).map(|i| json!({ "photo": (i == 0).then_some("a"), "crop": null })).collect();
    let value = json!({
        "version": 1, "seed": 1, "layout": "grid-6", "style": "noir", "panels": panels, "words": words,
        "page": { "width": 1240, "height": 1754, "dpi": 150 },
    });
    Document::parse(&value.to_string()).unwrap()
}

/// The first panel as it is drawn for a PDF file.
fn first_panel(document: &Document) -> picture::Picture {
    let photo = Image::from_luma(
        Plane::from_samples(64, 64, (0..64 * 64).map(|i| (i % 64 * 4) as u8).collect()).unwrap(),
    );
    let scene = Scene::new(&picture::bare(document), 1240).unwrap();
    let patch = compose::render_panel(&scene, 0, Some(&photo), &mut Context::default()).unwrap();
    picture::cut(document, 0, patch.area, &patch.rgba, 90).unwrap()
}

fn count(bytes: &[u8], what: &str) -> usize {
    bytes.windows(what.len()).filter(|window| *window == what.as_bytes()).count()
}

/// What is packed in the file, but for pictures.
fn streams(bytes: &[u8]) -> Vec<Vec<u8>> {
    let starts = (0..bytes.len() - 8)
        .filter(|&i| bytes[i..].starts_with(b"stream\n") && !bytes[..i].ends_with(b"end"));
    starts.filter_map(|start| decompress_to_vec_zlib(&bytes[start + 7..]).ok()).collect()
}

#[test]
fn pages_have_their_size_and_their_pictures() {
    let first = document(&json!([]));
    let mut second = first.clone();
    (second.page.width, second.page.height, second.page.dpi) = (2000, 1000, 96);
    let own = first_panel(&first);
    let jpeg = own.jpeg.clone();
    let leaves =
        [Leaf { document: first, pictures: vec![own] }, Leaf { document: second, pictures: Vec::new() }];
    let file = write(&leaves, "Two pages", &letters()).unwrap();
    assert!(file.starts_with(b"%PDF-1.7") && file.ends_with(b"%%EOF"));
    assert_eq!(count(&file, "/Type/Page/"), 2);
    assert_eq!(count(&file, "/MediaBox[0 0 595.2 841.92]"), 1);
    assert_eq!(count(&file, "/MediaBox[0 0 1500 750]"), 1);
    assert_eq!(count(&file, "/Filter/DCTDecode"), 1);
    assert!(file.windows(jpeg.len()).any(|window| window == jpeg));
    assert_eq!(count(&file, "(Two pages)"), 1);
    // Nothing of when or where.
    assert_eq!(count(&file, "CreationDate") + count(&file, "/Author"), 0);
}

#[test]
fn a_picture_is_the_whole_rectangle_of_its_panel_without_a_border() {
    let document = document(&json!([]));
    let own = first_panel(&document);
    let image = decode(&own.jpeg, &Limits::default()).unwrap().image;
    assert_eq!((image.width(), image.height()), (own.area.width, own.area.height));
    let scene = Scene::new(&document, 1240).unwrap();
    assert_eq!(own.area, PixelRect::around(scene.panels[0].image_bounds, 0.0));
    let wrong = picture::cut(&document, 9, own.area, &vec![0; own.area.width * own.area.height * 4], 90);
    assert_eq!(wrong.err().unwrap().code(), "invalid-document");
    assert_eq!(picture::cut(&document, 0, own.area, &[0; 4], 90).err().unwrap().code(), "buffer-size");
}

#[test]
fn a_page_too_large_for_points_has_larger_units() {
    let mut document = document(&json!([]));
    (document.page.width, document.page.height, document.page.dpi) = (2000, 10_000, 36);
    let file = write(&[Leaf { document, pictures: Vec::new() }], "", &letters()).unwrap();
    assert_eq!(count(&file, "/MediaBox[0 0 2000 10000]") + count(&file, "/UserUnit 2"), 2);
}

#[test]
fn text_is_there_with_what_it_stands_for_and_only_its_letters() {
    let words = json!([
        { "kind": "balloon", "text": "Où est-il?", "panel": 0 },
        { "kind": "effect", "text": "BAM 😀", "panel": 1, "angle": 20 },
        { "kind": "effect", "text": "ZOOM", "panel": 2, "arc": 0.8 },
    ]);
    let leaf = Leaf { document: document(&words), pictures: Vec::new() };
    let file = write(&[leaf], "Words", &letters()).unwrap();
    assert_eq!(count(&file, "/Subtype/CIDFontType2"), 2);
    let streams = streams(&file);
    let maps: Vec<&Vec<u8>> = streams.iter().filter(|stream| count(stream, "beginbfchar") > 0).collect();
    assert_eq!(maps.len(), 2);
    let mapped = |code: &str| maps.iter().filter(|map| count(map, &format!("<{code}>\n")) > 0).count();
    // ù of the balloon, Z of an effect, and a letter that the fonts lack; no x.
    assert_eq!([mapped("00F9"), mapped("005A"), mapped("D83DDE00"), mapped("0078")], [1, 1, 1, 0]);
    let drawing = streams.iter().find(|stream| count(stream, "BT\n") > 0).unwrap();
    assert_eq!(count(drawing, "3 Tr\n"), 1, "the bent word alone is unseen text");
}

/// The corners of a glyph's curves.
#[derive(Default)]
struct Corners(Vec<(f32, f32)>);

impl OutlineBuilder for Corners {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.push((x, y));
    }
    fn line_to(&mut self, x: f32, y: f32) {
        self.0.push((x, y));
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.0.extend([(x1, y1), (x, y)]);
    }
    fn curve_to(&mut self, _: f32, _: f32, _: f32, _: f32, _: f32, _: f32) {}
    fn close(&mut self) {}
}

#[test]
fn the_font_of_some_letters_has_the_outlines_of_the_whole() {
    let letters = letters();
    let whole = std::fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/fonts/Bangers-Regular.ttf")).unwrap();
    let whole = Face::parse(&whole, 0).unwrap();
    let font = letters.font("bangers").unwrap();
    let used = [' ', 'A', 'g', 'é'];
    let small = truetype::subset(font, &used);
    let small = Face::parse(&small, 0).unwrap();
    assert_eq!((small.number_of_glyphs(), small.units_per_em()), (5, whole.units_per_em()));
    for (i, letter) in used.into_iter().enumerate() {
        let (own, other) = (GlyphId(i as u16 + 1), whole.glyph_index(letter).unwrap());
        assert_eq!(small.glyph_hor_advance(own), whole.glyph_hor_advance(other), "{letter}");
        assert_eq!(small.glyph_bounding_box(own), whole.glyph_bounding_box(other), "{letter}");
        let corners = |face: &Face, glyph: GlyphId| {
            let mut corners = Corners::default();
            let _ = face.outline_glyph(glyph, &mut corners);
            corners.0.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
            corners.0.dedup();
            corners.0
        };
        let (mine, theirs) = (corners(&small, own), corners(&whole, other));
        assert_eq!(mine.is_empty(), letter == ' ');
        // The table rounds the points between two controls.
        let near =
            |a: &(f32, f32)| theirs.iter().any(|b| (a.0 - b.0).abs() <= 0.5 && (a.1 - b.1).abs() <= 0.5);
        assert_eq!((mine.len(), mine.iter().all(near)), (theirs.len(), true), "{letter}");
    }
}
