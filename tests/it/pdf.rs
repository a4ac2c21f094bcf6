//! Pages as PDF files: their size, the pictures of their panels, and text that can be found. That they look as the page
//! of pixels does is for the browser tests, which have a program that draws them.

use inkpanel_engine::page::pdf::{Imposition, Leaf, Options, impose, picture, write};
use inkpanel_engine::page::plates::{self, Separation};
use inkpanel_engine::page::rect::PixelRect;
use inkpanel_engine::page::words::{Letters, truetype};
use inkpanel_engine::page::{Document, Scene, StyleRef, compose};
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::{Image, Plane};
use inkpanel_engine::style::Context;
use miniz_oxide::inflate::decompress_to_vec_zlib;
use serde_json::{Value, json};
use std::process::Command;
use ttf_parser::{Face, GlyphId, OutlineBuilder};

fn letters() -> Letters {
    Letters::bundled().unwrap()
}

fn titled(title: &str) -> Options {
    Options { title: title.into(), ..Options::default() }
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

/// The first panel in its form for a PDF file.
fn first_panel(document: &Document) -> picture::Picture {
    let photo = Image::from_luma(
        Plane::from_samples(64, 64, (0..64 * 64).map(|i| (i % 64 * 4) as u8).collect()).unwrap(),
    );
    let mut scene = Scene::new(document, 1240).unwrap();
    scene.bordered = false;
    let patch = compose::render_panel(&scene, 0, Some(&photo), &mut Context::default()).unwrap();
    picture::cut(document, (0, patch.area, &patch.rgba), 90, None).unwrap()
}

fn count(bytes: &[u8], what: &str) -> usize {
    bytes.windows(what.len()).filter(|window| *window == what.as_bytes()).count()
}

/// Returns the decompressed streams of the file, except pictures.
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
    let leaves = [
        Leaf { document: first, pictures: vec![own], alts: Vec::new() },
        Leaf { document: second, pictures: Vec::new(), alts: Vec::new() },
    ];
    let file = write(&leaves, &titled("Two pages"), &letters()).unwrap();
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
    let wrong =
        picture::cut(&document, (9, own.area, &vec![0; own.area.width * own.area.height * 4]), 90, None);
    assert_eq!(wrong.err().unwrap().code(), "invalid-document");
    assert_eq!(
        picture::cut(&document, (0, own.area, &[0; 4]), 90, None).err().unwrap().code(),
        "buffer-size"
    );
}

#[test]
fn a_page_too_large_for_points_has_larger_units() {
    let mut document = document(&json!([]));
    (document.page.width, document.page.height, document.page.dpi) = (2000, 10_000, 36);
    let file =
        write(&[Leaf { document, pictures: Vec::new(), alts: Vec::new() }], &titled(""), &letters()).unwrap();
    assert_eq!(count(&file, "/MediaBox[0 0 2000 10000]") + count(&file, "/UserUnit 2"), 2);
}

#[test]
fn text_is_there_with_what_it_stands_for_and_only_its_letters() {
    let words = json!([
        { "kind": "balloon", "text": "Où est-il?", "panel": 0, "capitals": false },
        { "kind": "effect", "text": "BAM 😀", "panel": 1, "angle": 20 },
        { "kind": "effect", "text": "ZOOM", "panel": 2, "arc": 0.8 },
    ]);
    let leaf = Leaf { document: document(&words), pictures: Vec::new(), alts: Vec::new() };
    let file = write(&[leaf], &titled("Words"), &letters()).unwrap();
    assert_eq!(count(&file, "/Subtype/CIDFontType2"), 2);
    let streams = streams(&file);
    let maps: Vec<&Vec<u8>> = streams.iter().filter(|stream| count(stream, "beginbfchar") > 0).collect();
    assert_eq!(maps.len(), 2);
    let mapped = |code: &str| maps.iter().filter(|map| count(map, &format!("<{code}>\n")) > 0).count();
    // ù of the balloon, Z of an effect, and a character that the fonts lack, but no x.
    assert_eq!([mapped("00F9"), mapped("005A"), mapped("D83DDE00"), mapped("0078")], [1, 1, 1, 0]);
    let drawing = streams.iter().find(|stream| count(stream, "BT\n") > 0).unwrap();
    assert_eq!(count(drawing, "3 Tr\n"), 1, "the bent word alone is unseen text");
}

/// Runs a Poppler program on a file, and returns its output.
fn poppler(program: &str, arguments: &[&str], file: &[u8]) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("file.pdf");
    std::fs::write(&path, file).unwrap();
    let done = Command::new(program).args(arguments).arg(&path).output().expect("Poppler is installed");
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    assert!(done.stderr.is_empty(), "{}", String::from_utf8_lossy(&done.stderr));
    done.stdout
}

/// A page that is one panel, without gutter, margin or line.
fn style(file: Value) -> StyleRef {
    serde_json::from_value(file).unwrap()
}

fn full_page() -> Document {
    let value = json!({
        "version": 1, "seed": 1, "layout": "splash", "style": "noir", "merges": [], "words": [],
        "panels": [{ "photo": "a", "crop": null }],
        "page": { "width": 600, "height": 400, "dpi": 150, "gutter": 0, "margin": 0, "border": 0, "paper": "#00ff00" },
    });
    Document::parse(&value.to_string()).unwrap()
}

#[test]
fn what_is_read_has_an_order_and_pictures_have_words() {
    let words = json!([
        { "kind": "balloon", "text": "Second", "panel": 0, "capitals": false, "x": 0.7, "y": 0.8 },
        { "kind": "balloon", "text": "First", "panel": 0, "capitals": false, "x": 0.3, "y": 0.2 },
        { "kind": "effect", "text": "KRAK\nOOM", "panel": 1, "angle": 20 },
    ]);
    let document = document(&words);
    let own = first_panel(&document);
    let leaf = Leaf { document, pictures: vec![own], alts: vec!["A gray slope & more".into()] };
    let options = Options { title: "Sea <1>".into(), language: "pt-BR".into(), ..Options::default() };
    let file = write(&[leaf], &options, &letters()).unwrap();
    assert_eq!(count(&file, "/Lang(pt-BR)") + count(&file, "/Marked true"), 2);
    assert_eq!(count(&file, "<rdf:li xml:lang=\"x-default\">Sea &lt;1&gt;</rdf:li>"), 1);
    assert_eq!(count(&file, "/Alt(A gray slope & more)"), 1);
    // A line break adds no character.
    assert_eq!(count(&file, "/ActualText(KRAK OOM)"), 1);
    assert_eq!(count(&file, "/S/GTS_PDFA1"), 1);
    assert_eq!(count(&file, "/TrimBox[0 0 595.2 841.92]"), 1);
    let order = |file: &[u8], names: &[&str]| {
        let place = |name: &&str| file.windows(name.len()).position(|window| window == name.as_bytes());
        names.iter().map(|name| place(name).unwrap()).is_sorted()
    };
    assert!(order(&file, &["/Alt(A gray", "/ActualText(First)", "/ActualText(Second)", "/ActualText(KRAK"]));
    let printed = String::from_utf8(poppler("pdfinfo", &["-struct-text"], &file)).unwrap();
    let lines: Vec<&str> = printed.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    let text = lines.join(" ");
    assert!(order(text.as_bytes(), &["Document", "Sect", "Figure", "First", "Second", "KRAK"]), "{text}");
}

#[test]
fn the_same_pages_make_the_same_file() {
    let file = || {
        let document = document(&json!([{ "kind": "caption", "text": "Again" }]));
        let own = first_panel(&document);
        write(&[Leaf { document, pictures: vec![own], alts: Vec::new() }], &titled("Same"), &letters())
            .unwrap()
    };
    assert!(file() == file());
}

#[test]
fn pages_go_where_another_program_puts_them() {
    let told: Value = serde_json::from_str(include_str!("../oracles/data/impose.json")).unwrap();
    let mut seen = 0;
    for (name, how) in Imposition::ALL {
        for (pages, expected) in told[name].as_object().into_iter().flatten() {
            let pages: usize = pages.parse().unwrap();
            assert_eq!(json!(impose::sides(Some(how), pages)), *expected, "{name} of {pages}");
            seen += 1;
        }
    }
    assert_eq!(seen, 6);
}

#[test]
fn sheets_hold_their_pages_and_fit_their_paper() {
    let leaves = || -> Vec<Leaf> {
        let leaf = |_| Leaf { document: document(&json!([])), pictures: Vec::new(), alts: Vec::new() };
        (0..5).map(leaf).collect()
    };
    let file = |options: Options| write(&leaves(), &options, &letters()).unwrap();
    let booklet = file(Options { imposition: Some(Imposition::Booklet), ..Options::default() });
    assert_eq!(count(&booklet, "/Type/Page/"), 4);
    assert_eq!(count(&booklet, "/MediaBox[0 0 1190.4 841.92]"), 4);
    let paper = Some([210.0, 297.0]);
    let zine = file(Options { imposition: Some(Imposition::Zine), paper, ..Options::default() });
    assert_eq!((count(&zine, "/Type/Page/"), count(&zine, "/MediaBox[0 0 841.8898 595.2756]")), (1, 1));
    let spreads = file(Options { imposition: Some(Imposition::Spreads), ..Options::default() });
    let single = count(&spreads, "/MediaBox[0 0 595.2 841.92]");
    assert_eq!((single, count(&spreads, "/MediaBox[0 0 1190.4 841.92]")), (1, 2));
}

/// The photo of [`full_page`] in red, darker to the left.
fn bled_leaf(crop: Value) -> Leaf {
    let mut document = full_page();
    document.style = style(json!({ "id": "plain", "name": "Plain", "tags": ["paint"], "background": [] }));
    document.panels[0].crop = serde_json::from_value(crop).unwrap();
    document.page.bleed = 0.05;
    let plane =
        |high: usize, low: usize| Plane::from_fn(300, 200, |x, _| (low + x * (high - low) / 299) as u8);
    let photo = Image::from_rgb([plane(250, 100), plane(30, 0), plane(0, 0)]).unwrap();
    let mut scene = Scene::new(&document, 600).unwrap();
    scene.bordered = false;
    let patch = compose::render_panel(&scene, 0, Some(&photo), &mut Context::default()).unwrap();
    let own = picture::cut(&document, (0, patch.area, &patch.rgba), 95, None).unwrap();
    Leaf { document, pictures: vec![own], alts: Vec::new() }
}

#[test]
fn art_goes_on_beyond_the_edge_and_marks_stay_outside() {
    let crops = [json!(null), json!({ "x": 0.25, "y": 0.25, "width": 0.5, "height": 0.5 })];
    for (i, crop) in crops.into_iter().enumerate() {
        let options = Options { marks: true, ..Options::default() };
        let file = write(&[bled_leaf(crop)], &options, &letters()).unwrap();
        // 288 x 192 points, 14.4 of bleed, marks of 14.17 and a rim of 2.83.
        assert_eq!(
            count(&file, "/MediaBox[0 0 350.81573 254.81575]"),
            1,
            "{}",
            String::from_utf8_lossy(&file[..900])
        );
        assert_eq!(count(&file, "/BleedBox["), 1);
        let drawn = poppler("pdftoppm", &["-r", "72", "-singlefile", "-png"], &file);
        let image = decode(&drawn, &Limits::default()).unwrap().image;
        let at = |x: usize, y: usize| [0, 1, 2].map(|i| i32::from(image.planes()[i].at(x, y)));
        let (left, top, right, bottom) = (31, 31, 31 + 288, 31 + 192);
        // Beyond each edge it is red as within, not green as the paper is.
        for (inside, outside) in [
            ((left + 2, 120), (left - 10, 120)),
            ((right - 3, 120), (right + 9, 120)),
            ((170, top + 2), (170, top - 10)),
            ((170, bottom - 3), (170, bottom + 9)),
        ] {
            let (a, b) = (at(inside.0, inside.1), at(outside.0, outside.1));
            assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 25), "{i}: {a:?} {b:?}");
            assert!(b[0] > b[1] + 60, "{i}: {b:?}");
        }
        // The bleed shows more of the photo if there is more, which is darker to the left. Otherwise it shows
        // a mirror image.
        let (edge, far) = (at(left + 1, 120)[0], at(left - 12, 120)[0]);
        assert!(if i == 0 { far >= edge } else { far < edge }, "{i}: {edge} {far}");
        // Between the bleed and the edge of the sheet there are crop marks, only at the corners.
        let dark = |x: usize, y: usize| at(x, y).iter().sum::<i32>() < 700;
        assert!((left - 2..=left + 1).any(|x| dark(x, 8)) && !(100..250).any(|x| dark(x, 8)));
    }
}

#[test]
fn a_page_without_bleed_has_the_pixels_it_had() {
    let mut document = full_page();
    let photo = Image::from_luma(Plane::from_fn(90, 60, |x, y| (x * 2 + y) as u8));
    let drawn = |document: &Document| {
        let scene = Scene::new(document, 300).unwrap();
        compose::compose(&scene, |_| Some(&photo), &mut Context::default()).unwrap().rgb().to_vec()
    };
    let before = drawn(&document);
    // The default is not written, so older projects do not change.
    assert!(!document.to_json().contains("bleed"));
    document.page.bleed = 0.02;
    assert!(document.to_json().contains("bleed"));
    let after = drawn(&document);
    // The trimmed page shows the same part of the photo: hardly any pixel of a line moves.
    let off = before.iter().zip(&after).filter(|(a, b)| a.abs_diff(**b) > 64).count();
    assert!(off * 20 < before.len(), "{off} of {}", before.len());
}

#[test]
fn what_has_no_colour_is_gray_and_a_plate_is_the_cover_of_its_ink() {
    let mut gray = document(&json!([]));
    gray.style = style(
        json!({ "id": "gray", "name": "Gray", "tags": ["ink"], "background": [{ "block": "to_gray" }] }),
    );
    let file = write(
        &[Leaf { pictures: vec![first_panel(&gray)], document: gray, alts: Vec::new() }],
        &titled("Gray"),
        &letters(),
    )
    .unwrap();
    assert_eq!((count(&file, "/DeviceGray"), count(&file, "/DeviceRGB")), (1, 0));

    let mut document = full_page();
    document.style = style(json!({ "id": "two", "name": "Two", "tags": ["print"], "background": [
        { "block": "plates", "inks": "red-blue", "shift": 9, "grain": 80 }, { "block": "paper" }
    ] }));
    let exact = plates::exact(&document).unwrap();
    let step = &exact.style().unwrap().background[0];
    assert_eq!(step.values[1..3], [0.0, 0.0]);
    assert!(exact.style().unwrap().background[1].bypass);
    let colours = plates::colours(&plates::inks(&exact.style().unwrap()).unwrap());
    let separation = Separation::new(&colours);
    let area = PixelRect { x: 0, y: 0, width: 600, height: 400 };
    let red: Vec<u8> = [241, 80, 60, 255].repeat(600 * 400);
    for (ink, expected) in [(0, 0), (1, 255)] {
        let own = picture::cut(&exact, (0, area, &red), 95, Some((&separation, ink))).unwrap();
        let image = decode(&own.jpeg, &Limits::default()).unwrap().image;
        let seen = image.planes()[0].at(300, 200);
        assert!(seen.abs_diff(expected) < 14, "{ink}: {seen}");
        let leaf = Leaf { document: exact.clone(), pictures: vec![own], alts: Vec::new() };
        let options = Options { plate: Some(ink), inks: colours.clone(), ..Options::default() };
        let file = write(&[leaf], &options, &letters()).unwrap();
        assert_eq!((count(&file, "/DeviceGray"), count(&file, "OutputIntent")), (1, 0));
    }
    let leaf = Leaf { document: exact, pictures: Vec::new(), alts: Vec::new() };
    let missing =
        write(&[leaf], &Options { plate: Some(2), inks: colours.clone(), ..Options::default() }, &letters());
    assert_eq!(missing.unwrap_err().code(), "invalid-document");
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
    let whole = std::fs::read(crate::root("fonts/Bangers-Regular.ttf")).unwrap();
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

/// Draws a PDF file of one page with Poppler.
fn drawn_by_poppler(file: &[u8], dpi: u32) -> Image {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("page.pdf"), file).unwrap();
    let mut command = std::process::Command::new("pdftoppm");
    command.args(["-r", &dpi.to_string(), "-png", "-singlefile", "page.pdf", "page"]);
    assert!(command.current_dir(folder.path()).status().expect("Poppler is installed").success());
    let png = std::fs::read(folder.path().join("page.png")).unwrap();
    decode(&png, &Limits::default()).unwrap().image
}

#[test]
fn panels_without_a_photo_look_as_on_the_page_of_pixels() {
    let mut document = document(&json!([]));
    document.panels[0].photo = None;
    (document.page.width, document.page.height) = (620, 877);
    document.page.dpi = 75;
    document.page.paper = "#f4e8d0".into();
    document.page.corner_radius = 0.02;
    let scene = Scene::new(&document, 620).unwrap();
    let pixels = compose::compose(&scene, |_| None, &mut Context::default()).unwrap();
    let file =
        write(&[Leaf { document, pictures: Vec::new(), alts: Vec::new() }], &Options::default(), &letters())
            .unwrap();
    let drawn = drawn_by_poppler(&file, 75);
    assert_eq!((drawn.width(), drawn.height().abs_diff(877) <= 1), (620, true));
    let rgb = drawn.to_rgb();
    let rows = drawn.height().min(877) * 620 * 3;
    let far = rgb[..rows]
        .chunks(3)
        .zip(pixels.rgb()[..rows].chunks(3))
        .filter(|(a, b)| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 48));
    // The two smooth the edges of lines in their own ways.
    let (far, all) = (far.count(), rows / 3);
    assert!(far * 200 < all, "{far} of {all} pixels are of another colour");
    let middle = scene.panels[3].image_bounds;
    let at = ((middle.y + middle.height / 2.0) as usize * 620 + (middle.x + middle.width / 2.0) as usize) * 3;
    assert_eq!(rgb[at..at + 3], pixels.rgb()[at..at + 3], "the gray of an empty panel");
}
