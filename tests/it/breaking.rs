//! Subjects that break their panel border: their visibility, and the file formats that show them.

use std::collections::BTreeMap;

use inkpanel_engine::framing::{PhotoMeta, Subject};
use inkpanel_engine::layout::{Bounds, Point, ResolvedShape};
use inkpanel_engine::native;
use inkpanel_engine::page::breaking::{breaks, broken};
use inkpanel_engine::page::rect::PixelRect;
use inkpanel_engine::page::request::Request;
use inkpanel_engine::page::shuffle::plan;
use inkpanel_engine::page::words::given::GivenFonts;
use inkpanel_engine::page::words::{Letters, TextItem, draw};
use inkpanel_engine::page::{Document, Scene, compose, mask, pdf};
use inkpanel_engine::raster::guided::softened;
use inkpanel_engine::raster::{Image, Matte, Plane};
use inkpanel_engine::style::Context;
use oorandom::Rand64;
use serde_json::{Value, json};

const WIDTH: usize = 420;

fn style() -> Value {
    json!({ "id": "plain", "name": "Plain", "tags": [], "background": [] })
}

/// A person with a round head on an oval body, with a detected face. Some are in the middle, some end at the
/// photo's edge.
fn photo(i: u64, random: &mut Rand64) -> (PhotoMeta, Image) {
    let (width, height) = if i.is_multiple_of(3) { (600, 800) } else { (900, 600) };
    let mut between = |low: f64, high: f64| low + random.rand_float() * (high - low);
    let (x, head) = (between(0.2, 0.8), between(0.05, 0.14));
    let top = between(0.02, 0.35);
    let (bottom, half) = (between(top + 0.4, 1.1), between(0.06, 0.2));
    let aspect = f64::from(width) / f64::from(height);
    let within = |px: f64, py: f64| {
        let face = ((px - x) * aspect).hypot(py - top - head) < head;
        let middle = f64::midpoint(top + 2.0 * head, bottom);
        face || ((px - x) / half).hypot((py - middle) / (bottom - middle)) < 1.0
    };
    let at = |px: usize, py: usize| {
        within((px as f64 + 0.5) / f64::from(width), (py as f64 + 0.5) / f64::from(height))
    };
    let shares = Plane::from_fn(width as usize, height as usize, |x, y| if at(x, y) { 255 } else { 0 });
    let plane = |within: u8, beside: u8| {
        Plane::from_fn(width as usize, height as usize, |x, y| if at(x, y) { within } else { beside })
    };
    let image = Image::from_rgb([plane(220, 40), plane(40, 120), plane(60, 200)]).unwrap();
    let face = Subject {
        x: x - head / aspect,
        y: top,
        width: 2.0 * head / aspect,
        height: 2.0 * head,
        label: "face".into(),
        score: 0.9,
        points: None,
        expression: None,
        light: None,
    };
    let meta = PhotoMeta {
        mask: Some(Matte::new(&shares, (width as usize, height as usize))),
        subjects: vec![face],
        fingerprint: i.wrapping_mul(0x9e37_79b9_7f4a_7c15),
        ..PhotoMeta::unmeasured(&format!("p{i}"), width, height)
    };
    (meta, image)
}

fn album(seed: u64, count: u64) -> Vec<(PhotoMeta, Image)> {
    let mut random = Rand64::new(u128::from(seed));
    (0..count).map(|i| photo(i + 10 * seed, &mut random)).collect()
}

fn page(photos: &[(PhotoMeta, Image)], seed: u32) -> Document {
    plan(&Request {
        seed,
        photos: photos.iter().map(|(meta, _)| meta.clone()).collect(),
        style: Some(serde_json::from_value(style()).unwrap()),
        figures: Some(true),
        ..Request::default()
    })
    .unwrap()
}

fn image<'a>(photos: &'a [(PhotoMeta, Image)], id: &str) -> Option<&'a Image> {
    photos.iter().find(|(meta, _)| meta.id == id).map(|(_, image)| image)
}

fn pictures(photos: &[(PhotoMeta, Image)]) -> native::Photos {
    photos.iter().map(|(meta, image)| (meta.id.clone(), image.clone().into())).collect()
}

/// The faces that panels other than one show, in pixels of the page.
fn faces(scene: &Scene, count: usize, but: usize) -> Vec<Bounds> {
    let mut faces = Vec::new();
    for (_, panel) in scene.panels[..count].iter().enumerate().filter(|(i, _)| *i != but) {
        let Bounds { x, y, width, height } = panel.image_bounds;
        faces.extend(panel.faces.iter().map(|face| Bounds {
            x: x + (face.x - panel.crop.x) / panel.crop.width * width,
            y: y + (face.y - panel.crop.y) / panel.crop.height * height,
            width: face.width / panel.crop.width * width,
            height: face.height / panel.crop.height * height,
        }));
    }
    faces
}

/// A caption and a balloon in the middle of a subject that breaks its border.
fn words_on(area: PixelRect, height: usize) -> Vec<TextItem> {
    let middle = (area.x as f64 + area.width as f64 / 2.0, area.y as f64 + area.height as f64 / 2.0);
    let x = (middle.0 / WIDTH as f64).clamp(0.2, 0.8);
    let word = |kind: &str, down: f64, fill: &str| {
        let y = ((middle.1 + down) / WIDTH as f64).clamp(0.1, height as f64 / WIDTH as f64 - 0.1);
        let word = json!({ "kind": kind, "text": "HERE", "x": x, "y": y, "size": 0.03, "fill": fill, "color": "#000000" });
        TextItem::read(word).unwrap()
    };
    vec![word("caption", -20.0, "#00ff00"), word("balloon", 20.0, "#ffff00")]
}

/// Returns the number of opaque text pixels of a page, and how many of them are hidden.
fn seen_of_words(page: &Document, photos: &native::Photos) -> (usize, usize) {
    let sheet = native::sheet(page, photos, &GivenFonts::default()).unwrap();
    let letters = Letters::bundled().unwrap();
    let mut seen: BTreeMap<(i64, i64), [u8; 3]> = BTreeMap::new();
    for index in 0..page.words.len() {
        let patch = draw::render(page, index, WIDTH, &letters).unwrap();
        for (i, pixel) in patch.rgba.chunks_exact(4).enumerate().filter(|(_, pixel)| pixel[3] > 0) {
            let at =
                (patch.area.x + (i % patch.area.width) as i64, patch.area.y + (i / patch.area.width) as i64);
            // If two subjects overlap, the later one is on top.
            if pixel[3] == 255 {
                seen.insert(at, [pixel[0], pixel[1], pixel[2]]);
            } else {
                seen.remove(&at);
            }
        }
    }
    let inside =
        |x: i64, y: i64| (0..sheet.width() as i64).contains(&x) && (0..sheet.height() as i64).contains(&y);
    seen.retain(|(x, y), _| inside(*x, *y));
    let covered = seen.iter().filter(|((x, y), color)| {
        let at = (*y as usize * sheet.width() + *x as usize) * 3;
        sheet.rgb()[at..at + 3] != color[..]
    });
    (seen.len(), covered.count())
}

#[test]
fn on_random_pages_no_figure_covers_a_face_or_a_word_or_leaves_the_margin() {
    let (mut stepped, mut lettered) = (0, 0);
    let mut photos = Vec::new();
    let pages = crate::trials(50, 500) as u32;
    for seed in 0..pages {
        if seed.is_multiple_of(25) {
            photos = album(u64::from(seed) / 25, 7);
        }
        let page = page(&photos, seed);
        let told = breaks(&page).unwrap();
        let count = page.panels.len();
        assert!(page.panels.iter().filter(|panel| panel.figure.is_some()).count() <= 1, "seed {seed}");
        let scene = Scene::new(&page, WIDTH).unwrap();
        assert_eq!(scene.panels.len() - count, usize::from(told.contains(&true)), "seed {seed}");
        let Some(own) = told.iter().position(|breaks| *breaks) else { continue };
        stepped += 1;
        let photo = image(&photos, page.panels[own].photo.as_deref().unwrap());
        let patch = compose::render_panel(&scene, count, photo, &mut Context::default()).unwrap();
        let inside = mask::inside(&scene.panels[own].shape, scene.corner_radius, patch.area);
        let margin = page.page.margin * WIDTH as f64;
        let faces = faces(&scene, count, own);
        for (i, pixel) in patch.rgba.chunks_exact(4).enumerate() {
            // The subject itself, without the paper outline around it.
            let figure = pixel[3] > 128 && i16::from(pixel[0]) - i16::from(pixel[1]) > 90 && pixel[2] < 120;
            if !figure || inside[i] > 0 {
                continue;
            }
            let x = (patch.area.x + (i % patch.area.width) as i64) as f64 + 0.5;
            let y = (patch.area.y + (i / patch.area.width) as i64) as f64 + 0.5;
            let room = margin - 1.5..WIDTH as f64 - margin + 1.5;
            let down = margin - 1.5..scene.height as f64 - margin + 1.5;
            assert!(room.contains(&x) && down.contains(&y), "seed {seed}: {x}, {y} is in the margin");
            let covered = faces.iter().any(|face| {
                (face.x..face.x + face.width).contains(&x) && (face.y..face.y + face.height).contains(&y)
            });
            assert!(!covered, "seed {seed}: a face at {x}, {y} is covered");
        }
        let mut written = page.clone();
        (written.page.width, written.page.height) = (scene.width as u32, scene.height as u32);
        written.words = words_on(patch.area, scene.height);
        let (there, covered) = seen_of_words(&written, &pictures(&photos));
        assert!(there > 200 && covered == 0, "seed {seed}: {covered} of {there} pixels of words are covered");
        lettered += there;
    }
    println!(
        "{stepped} of {pages} pages have a figure that steps out; {lettered} pixels of words lie on them"
    );
    assert!(stepped > pages / 5, "{stepped} of {pages}");
}

/// A page with a breakout, its panel, and its photos.
fn example() -> (Document, usize, Vec<(PhotoMeta, Image)>) {
    let found = (0..50).find_map(|seed| {
        let photos = album(3, 7);
        let page = page(&photos, seed);
        let own = breaks(&page).unwrap().iter().position(|breaks| *breaks)?;
        Some((page, own, photos))
    });
    let (mut page, own, photos) = found.unwrap();
    (page.page.width, page.page.height) = (620, 877);
    (page, own, photos)
}

/// A photo of a broad object with a clear border, on a foot with a vague border. The mask as a whole is clear
/// enough.
fn with_a_vague_foot(i: u64) -> (PhotoMeta, Image) {
    let (width, height) = (900, 600);
    let x = 330 + 40 * (i as usize % 4);
    let share = |px: usize, py: usize| {
        let (across, foot) = (px.abs_diff(x), 380..500);
        match py {
            60..380 if across < 200 => 255,
            _ if foot.contains(&py) && across < 60 => 150,
            _ => 0,
        }
    };
    let shares = Plane::from_fn(width, height, share);
    let image = Image::from_rgb([0, 1, 2].map(|_| shares.clone())).unwrap();
    let mask = Matte::new(&shares, (width, height));
    let sure = mask.facts().confidence;
    assert!(sure > 0.68, "{sure}");
    let fingerprint = i.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let meta =
        PhotoMeta { mask: Some(mask), fingerprint, ..PhotoMeta::unmeasured(&format!("p{i}"), 900, 600) };
    (meta, image)
}

#[test]
fn what_has_a_vague_border_stays_in_its_panel_unless_somebody_asks() {
    let photos: Vec<_> = (1..7).map(with_a_vague_foot).collect();
    // Whether the foot is drawn outside of its panel, on several pages with a breakout.
    let foot_outside = |page: &Document, own: usize| {
        let scene = Scene::new(page, WIDTH).unwrap();
        let id = page.panels[own].photo.as_deref().unwrap();
        let drawn =
            compose::render_panel(&scene, page.panels.len(), image(&photos, id), &mut Context::default())
                .unwrap();
        let (crop, bounds) = (scene.panels[own].crop, scene.panels[own].image_bounds);
        let number: usize = id[1..].parse().unwrap();
        let (x, y) = ((330.0 + 40.0 * (number % 4) as f64) / 900.0, 430.0 / 600.0);
        let x = bounds.x + (x - crop.x) / crop.width * bounds.width;
        let y = bounds.y + (y - crop.y) / crop.height * bounds.height;
        let (column, row) = (x as i64 - drawn.area.x, y as i64 - drawn.area.y);
        let there =
            (0..drawn.area.width as i64).contains(&column) && (0..drawn.area.height as i64).contains(&row);
        y > bounds.y + bounds.height
            && there
            && drawn.rgba[(row as usize * drawn.area.width + column as usize) * 4 + 3] > 0
    };
    let (mut stepped, mut asked) = (0, 0);
    for seed in 0..60 {
        let page = page(&photos, seed);
        if let Some(own) = breaks(&page).unwrap().iter().position(|breaks| *breaks) {
            stepped += 1;
            assert!(!foot_outside(&page, own), "seed {seed}: the foot of panel {own} is outside");
        }
        let mut plain = page.clone();
        for panel in &mut plain.panels {
            panel.figure = None;
        }
        for own in 0..plain.panels.len() {
            let Some(id) = plain.panels[own].photo.clone() else { continue };
            let mask = photos.iter().find(|(meta, _)| meta.id == id).and_then(|(meta, _)| meta.mask.clone());
            let out = broken(&plain, own, &mask.unwrap()).unwrap();
            asked += usize::from(out.is_some_and(|out| foot_outside(&out, own)));
        }
    }
    assert!(stepped > 10 && asked > 10, "{stepped} stepped out, {asked} were asked to, with their feet");
}

#[test]
fn without_its_figure_a_page_differs_outside_of_the_panel_alone() {
    let (page, own, photos) = example();
    let drawn = |page: &Document| {
        let scene = Scene::new(page, 620).unwrap();
        compose::compose(&scene, |id| image(&photos, id), &mut Context::default()).unwrap()
    };
    let mut plain = page.clone();
    plain.panels[own].figure = None;
    assert!(!breaks(&plain).unwrap().contains(&true));
    let (with, without) = (drawn(&page), drawn(&plain));
    let scene = Scene::new(&page, 620).unwrap();
    let area = PixelRect { x: 0, y: 0, width: 620, height: scene.height };
    let inside = mask::inside(&scene.panels[own].shape, 0.0, area);
    let pixels = with.rgb().chunks_exact(3).zip(without.rgb().chunks_exact(3)).zip(&inside);
    let (mut outside, mut within) = (0, 0);
    for ((with, without), inside) in pixels {
        let differs = with.iter().zip(without).any(|(a, b)| a.abs_diff(*b) > 40);
        outside += usize::from(differs && *inside == 0);
        within += usize::from(differs && *inside == 255);
    }
    let panel: usize = inside.iter().map(|inside| usize::from(*inside == 255)).sum();
    assert!(outside * 200 > panel, "{outside} of {panel}");
    // At the former border, and at the edge of the subject.
    assert!(within * 20 < panel, "{within} of {panel}");
}

#[test]
fn a_panel_and_its_figure_are_cut_out_of_one_drawing() {
    let (mut page, own, photos) = example();
    page.style = "comic".into();
    let mut scene = Scene::new(&page, 620).unwrap();
    let photo = image(&photos, page.panels[own].photo.as_deref().unwrap());
    let pictures = [own, page.panels.len()];
    let together = compose::render_together(&scene, &pictures, photo, &mut Context::default()).unwrap();
    for (index, patch) in pictures.into_iter().zip(&together) {
        let alone = compose::render_panel(&scene, index, photo, &mut Context::default()).unwrap();
        assert!(alone.area == patch.area && alone.rgba == patch.rgba, "picture {index}");
    }
    let [panel, figure] = &together[..] else { panic!("there are two") };
    let inside = mask::inside(&scene.panels[own].shape, scene.corner_radius, figure.area);
    let line = mask::border(&scene.panels[own].shape, scene.corner_radius, scene.border, figure.area);
    scene.bordered = false;
    let bare = compose::render_panel(&scene, own, photo, &mut Context::default()).unwrap();
    let mut met = 0;
    for (i, seen) in figure.rgba.chunks_exact(4).enumerate() {
        if inside[i] < 255 || seen[3] == 0 {
            continue;
        }
        let x = figure.area.x + (i % figure.area.width) as i64 - panel.area.x;
        let y = figure.area.y + (i / figure.area.width) as i64 - panel.area.y;
        let at = (y as usize * panel.area.width + x as usize) * 4;
        // Below the border, too.
        assert_eq!(seen[..3], bare.rgba[at..at + 3], "{x}, {y}");
        assert!(line[i] > 0 || seen[..3] == panel.rgba[at..at + 3], "{x}, {y}");
        met += 1;
    }
    assert!(met > 300, "{met}");
}

/// If a subject ends at a side of its panel, the border there stays complete, although the outline of the
/// subject would reach it.
#[test]
fn a_border_that_no_figure_crosses_stays_whole() {
    let (mut whole, mut crossed) = (0, 0);
    let mut photos = Vec::new();
    for seed in 0..40 {
        // It takes longer to make the photos than to draw a page.
        if seed % 8 == 0 {
            photos = album(seed, 7);
        }
        let mut page = page(&photos, seed as u32);
        let Some(own) = breaks(&page).unwrap().iter().position(|breaks| *breaks) else { continue };
        (page.page.width, page.page.height) = (620, 877);
        (page.page.border, page.page.corner_radius) = (0.016, 0.0);
        let mut plain = page.clone();
        plain.panels[own].figure = None;
        let scene = Scene::new(&page, 620).unwrap();
        let ResolvedShape::Polygon(points) = &scene.panels[own].shape else { continue };
        let sides = Bounds::of(points);
        let corner = |point: &Point| {
            let at =
                |at: f64, low: f64, length: f64| (at - low).abs() < 0.01 || (at - low - length).abs() < 0.01;
            at(point.x, sides.x, sides.width) && at(point.y, sides.y, sides.height)
        };
        if points.len() != 4 || !points.iter().all(corner) {
            continue;
        }
        let drawn = |page: &Document| {
            let scene = Scene::new(page, 620).unwrap();
            compose::compose(&scene, |id| image(&photos, id), &mut Context::default()).unwrap()
        };
        let (with, without) = (drawn(&page), drawn(&plain));
        let changed = |x: i64, y: i64| {
            let at = (y as usize * 620 + x as usize) * 3;
            with.rgb()[at..at + 3].iter().zip(&without.rgb()[at..at + 3]).any(|(a, b)| a.abs_diff(*b) > 8)
        };
        let half = scene.border / 2.0;
        let (right, bottom) = (sides.x + sides.width, sides.y + sides.height);
        // Each side as its outward direction and the pixels along it.
        for (edge, across, from, to) in [
            (sides.x, [-1.0, 0.0], sides.y, bottom),
            (right, [1.0, 0.0], sides.y, bottom),
            (sides.y, [0.0, -1.0], sides.x, right),
            (bottom, [0.0, 1.0], sides.x, right),
        ] {
            // Away from the corners, where another side may be crossed.
            let along = (from + 4.0 * half) as i64..(to - 4.0 * half) as i64;
            let any = |off: f64| {
                let line = (edge + (across[0] + across[1]) * off).floor() as i64;
                let inside = if across[0] == 0.0 { 0..scene.height as i64 } else { 0..620 };
                inside.contains(&line)
                    && along
                        .clone()
                        .any(|at| if across[0] == 0.0 { changed(at, line) } else { changed(line, at) })
            };
            if any(half + 3.0) {
                crossed += 1;
            } else {
                whole += 1;
                for off in [-0.6, -0.2, 0.2, 0.6] {
                    assert!(
                        !any(off * half),
                        "seed {seed}: a side that is not crossed lost some of its border"
                    );
                }
            }
        }
    }
    assert!(whole > 20 && crossed > 5, "{whole} sides, {crossed} crossed");
}

#[test]
fn a_pdf_file_has_the_figure_with_its_own_mask() {
    let (page, own, photos) = example();
    let images = pictures(&photos);
    let file = |page: &Document| {
        let leaf = native::leaf(page, &images, Vec::new(), (None, native::QUALITY)).unwrap();
        pdf::write(&[leaf], &pdf::Options::default(), &Letters::bundled().unwrap()).unwrap()
    };
    let has = |file: &[u8]| file.windows(6).any(|text| text == b"/SMask");
    let mut plain = page.clone();
    plain.panels[own].figure = None;
    assert!(has(&file(&page)) && !has(&file(&plain)));
}

#[test]
fn a_figure_is_kept_with_its_panel_and_a_broken_one_is_refused() {
    let (page, own, _) = example();
    let json = page.to_json();
    assert_eq!(Document::parse(&json).unwrap(), page);
    let mut value: Value = serde_json::from_str(&json).unwrap();
    value["panels"][own]["figure"] = "3x3:a8".into();
    let error = Document::parse(&value.to_string()).unwrap_err().to_string();
    assert!(error.contains(&format!("panels[{own}].figure")), "{error}");
}

#[test]
fn a_person_may_break_a_frame_and_a_shared_image_has_none() {
    let (mut page, own, photos) = example();
    let mask = page.panels[own].figure.take().unwrap();
    let out = broken(&page, own, &mask).unwrap().unwrap();
    assert!(breaks(&out).unwrap()[own] && out.panels[own].edited);
    let id = page.panels[own].photo.clone().unwrap();
    let nothing = Matte::new(&Plane::filled(30, 20, 0), (30, 20));
    assert_eq!(broken(&page, own, &nothing).unwrap(), None);
    // The same subject with a blurred mask.
    let cloud = softened(&softened(&mask.plane(), 24), 24);
    let cloud = Matte::new(&cloud, (cloud.width(), cloud.height()));
    assert!(cloud.facts().is_vague(), "{:?}", cloud.facts());
    assert_eq!(broken(&page, own, &cloud).unwrap(), None);
    page.panels[own].photo = None;
    assert_eq!(broken(&page, own, &mask).unwrap(), None);
    page.panels[own].photo = Some(id);
    page.merges = vec![vec![own, usize::from(own == 0)]];
    assert_eq!(broken(&page, own, &mask).unwrap(), None);
    assert_eq!(photos.len(), 7);
}
