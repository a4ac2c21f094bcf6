//! Sound effects behind the subject of their panel.

use inkpanel_engine::native::{self, Photo, Photos};
use inkpanel_engine::page::words::given::GivenFonts;
use inkpanel_engine::page::words::{Letters, TextItem, TextKind};
use inkpanel_engine::page::{Document, Scene, compose, pdf};
use inkpanel_engine::raster::{Image, Matte, Plane};
use inkpanel_engine::style::Context;
use serde_json::{Value, json};

const WIDTH: usize = 600;
/// Colours of the photo's subject, of its background, and of the effect.
const SUBJECT: [u8; 3] = [40, 60, 220];
const BESIDE: [u8; 3] = [230, 225, 205];

/// A page of two panels. The photo of the first panel has its subject in the left half. A sound effect
/// crosses it.
fn page(behind: bool) -> Document {
    let panel = |photo: Value| json!({ "photo": photo, "crop": { "x": 0, "y": 0, "width": 1, "height": 1 } });
    let words = json!([
        { "kind": "effect", "text": "BOOOM", "panel": 0, "x": 0.5, "y": 0.5, "size": 0.12, "width": 0.9, "color": "#d01010",
          "fill": "#d01010", "behind": behind },
    ]);
    let page = json!({
        "version": 1, "seed": 1, "layout": "grid-2", "merges": [], "order": ["a"],
        "style": { "id": "plain", "name": "Plain", "tags": [], "background": [] },
        "page": { "width": WIDTH, "height": 850, "dpi": 72 },
        "panels": [panel("a".into()), panel(Value::Null)], "words": words,
    });
    Document::parse(&page.to_string()).unwrap()
}

fn photos(mask: bool) -> Photos {
    let plane = |c: usize| Plane::from_fn(400, 300, |x, _| if x < 200 { SUBJECT[c] } else { BESIDE[c] });
    let image = Image::from_rgb([plane(0), plane(1), plane(2)]).unwrap();
    let shares = Plane::from_fn(320, 240, |x, _| if x < 160 { 255 } else { 0 });
    let subject = mask.then(|| Matte::new(&shares, (400, 300)));
    Photos::from([("a".to_owned(), Photo { image, subject })])
}

fn drawn(page: &Document, mask: bool) -> Vec<[u8; 3]> {
    let sheet = native::sheet(page, &photos(mask), &GivenFonts::default()).unwrap();
    sheet.rgb().chunks_exact(3).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
}

fn is_effect([red, green, blue]: [u8; 3]) -> bool {
    red > 180 && green < 60 && blue < 60
}

/// How many pixels of the effect are left and right of the subject's edge, a few about it left out.
fn halves(pixels: &[[u8; 3]], middle: f64) -> (usize, usize) {
    let effect =
        pixels.iter().enumerate().filter(|(_, pixel)| is_effect(**pixel)).map(|(i, _)| (i % WIDTH) as f64);
    effect.fold((0, 0), |(left, right), x| {
        (left + usize::from(x < middle - 4.0), right + usize::from(x > middle + 4.0))
    })
}

/// The x of the subject's edge on the page.
fn edge(page: &Document) -> f64 {
    let bounds = Scene::new(page, WIDTH).unwrap().panels[0].image_bounds;
    bounds.x + bounds.width / 2.0
}

#[test]
fn the_figure_is_seen_before_the_effect_and_beside_it_the_effect() {
    let (behind, before) = (page(true), page(false));
    let middle = edge(&behind);
    let plain = drawn(&before, true);
    let (left, right) = halves(&plain, middle);
    assert!(left > 500 && right > 500, "{left}, {right}");
    let cut = drawn(&behind, true);
    assert_eq!(halves(&cut, middle), (0, right));
    // Inside the mask is the subject itself, as without the effect.
    let mut bare = before.clone();
    bare.words.clear();
    let bare = drawn(&bare, true);
    for (i, ((cut, bare), plain)) in cut.iter().zip(&bare).zip(&plain).enumerate() {
        let wanted = if ((i % WIDTH) as f64) < middle - 4.0 { bare } else { plain };
        let near = ((i % WIDTH) as f64 - middle).abs() <= 4.0;
        assert!(near || cut == wanted, "{cut:?} for {wanted:?} at {}, {}", i % WIDTH, i / WIDTH);
    }
}

#[test]
fn a_figure_that_may_step_out_and_does_not_is_seen_before_the_effect_as_any_other() {
    let wanted = drawn(&page(true), true);
    let mut figure = page(true);
    figure.panels[0].figure = photos(true)["a"].subject.clone();
    let scene = Scene::new(&figure, WIDTH).unwrap();
    let figures = scene.by_panel();
    assert_eq!((figures[0].len(), figures[1].len()), (3, 1));
    assert!(drawn(&figure, true) == wanted);
}

#[test]
fn a_page_in_layers_is_the_page() {
    let page = page(true);
    let (mut sheet, words) = native::layers(&page, &photos(true), &Letters::bundled().unwrap()).unwrap();
    assert_eq!(words.len(), 1);
    for (place, patch) in words {
        assert_eq!(place, 0);
        sheet.lay(patch.area, &patch.rgba).unwrap();
    }
    let whole = native::sheet(&page, &photos(true), &GivenFonts::default()).unwrap();
    assert!(sheet.rgb() == whole.rgb());
}

#[test]
fn the_border_and_what_is_outside_of_the_panel_are_no_figure() {
    let mut page = page(true);
    page.page.border = 0.02;
    let scene = |page: &Document| {
        let mut scene = Scene::new(page, WIDTH).unwrap();
        scene.show_subjects(&|id| photos(true).get(id)?.subject.clone());
        scene
    };
    let scene = scene(&page);
    let photos = photos(true);
    let front = scene.panels.len();
    let patch =
        compose::render_panel(&scene, front, Some(&photos["a"].image), &mut Context::default()).unwrap();
    let bounds = scene.panels[0].image_bounds;
    let alpha = |x: f64, y: f64| {
        let (column, row) = ((x as i64 - patch.area.x) as usize, (y as i64 - patch.area.y) as usize);
        patch.rgba[(row * patch.area.width + column) * 4 + 3]
    };
    let (x, y) = (bounds.x, bounds.y + bounds.height / 2.0);
    assert_eq!(alpha(x + 1.0, y), 0, "the border");
    assert_eq!(alpha(x + bounds.width * 0.25, y), 255, "the subject");
    assert_eq!(alpha(x + bounds.width * 0.75, y), 0, "beside it");
}

#[test]
fn without_a_mask_the_effect_stands_before_the_photo() {
    let middle = edge(&page(true));
    assert_eq!(drawn(&page(true), false), drawn(&page(false), false));
    assert!(halves(&drawn(&page(true), false), middle).0 > 500);
    // Also on a panel that the page does not have, and for a text item that is not a sound effect.
    let word = &page(true).words[0];
    let far = TextItem { panel: Some(7), ..word.clone() };
    let caption = TextItem { kind: TextKind::Caption, ..word.clone() };
    for word in [far, caption] {
        let other = Document { words: vec![word], ..page(true) };
        assert!(other.fronts().is_empty(), "{other:?}");
    }
}

#[test]
fn other_words_lie_over_figure_and_effect() {
    let mut both = page(true);
    let caption = json!({ "kind": "caption", "text": "MEANWHILE", "panel": 0, "x": 0.25, "y": 0.5, "width": 0.3,
        "fill": "#00ff00", "color": "#000000" });
    both.words.insert(0, TextItem::read(caption).unwrap());
    let middle = edge(&both);
    let pixels = drawn(&both, true);
    let green = |pixel: &[u8; 3]| *pixel == [0, 255, 0];
    let left = pixels.iter().enumerate().filter(|(i, pixel)| green(pixel) && ((i % WIDTH) as f64) < middle);
    assert!(left.count() > 300);
}

#[test]
fn a_pdf_file_has_the_figure_as_a_picture_after_the_effect() {
    let file = |page: &Document, mask: bool| {
        let leaf = native::leaf(page, &photos(mask), Vec::new(), (None, native::QUALITY)).unwrap();
        let alphas = leaf.pictures.iter().filter(|picture| picture.alpha.is_some()).count();
        (pdf::write(&[leaf], &pdf::Options::default(), &Letters::bundled().unwrap()).unwrap(), alphas)
    };
    let has = |file: &[u8]| file.windows(6).any(|text| text == b"/SMask");
    let (with, without) = (file(&page(true), true), file(&page(false), true));
    assert!(has(&with.0) && with.1 == 1);
    assert!(!has(&without.0) && without.1 == 0);
}
