//! Rendered output does not change: a page of each family of layouts, and every built-in style.

use std::fs;

use crate::golden::Goldens;
use inkpanel_engine::framing::frame;
use inkpanel_engine::layout::{self, FAMILIES, PageSettings, Template, resolve};
use inkpanel_engine::page::import::{Imported, import};
use inkpanel_engine::page::{Document, Scene, compose};
use inkpanel_engine::plan::slots;
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::resize::{Region, resample_image};
use inkpanel_engine::style::catalogue::catalogue;
use inkpanel_engine::style::{Context, stylize};
use serde_json::{Value, json};

/// Width of all goldens in pixels.
const WIDTH: usize = 240;

/// Share of pixels that may differ. If a style has a threshold, the last bit of a float decides between black
/// and white.
const ALLOWED: f64 = 0.0005;

/// Photos of the panels, in turn.
const PHOTOS: [&str; 3] = ["cat", "pagoda", "macaw"];

/// The part of `macaw.jpg` that every style is shown on: flat and busy, light and dark, of all colours.
const HEAD_AND_WING: Region = Region { x: 170.0, y: 50.0, width: 480.0, height: 320.0 };

/// Pixels of the stylised picture per pixel of a 1920 x 1080 picture, so that lines are wide enough to
/// compare.
const SCALE: f32 = 0.5;

fn photo(name: &str) -> Vec<u8> {
    fs::read(crate::root(format!("tests/photos/{name}.jpg"))).unwrap()
}

/// A style without a file, so that changes of built-in styles do not change the pages.
fn style_of_the_pages() -> Value {
    json!({
        "id": "golden",
        "name": "Golden",
        "tags": ["comic"],
        "background": [{ "block": "tvf", "time": 40 }, { "block": "posterize", "levels": 6 }],
        "foreground": [
            { "block": "to_gray" },
            { "block": "xdog", "sigma": 3, "p": 22 },
            { "block": "soft_threshold", "phi": 0.05, "epsilon": 60 },
        ],
        "ink": "#101018",
    })
}

/// Renders a page in the shape of its layout. Photos fill the panels in order, with automatic crops. It does
/// not use the planner, whose preferences may change.
fn page(template: &Template, photos: &[Imported]) -> Image {
    let settings = PageSettings::default();
    let height = (f64::from(settings.width) / template.aspect()).round() as u32;
    let settings = PageSettings { height, ..settings };
    let resolved = resolve(template, settings.aspect(), &settings);
    let slots = slots(&resolved, f64::from(settings.width));
    let panels = slots.iter().zip(photos.iter().cycle()).map(|(slot, photo)| {
        let crop = frame(&photo.meta, &slot.target, 0);
        json!({ "photo": photo.meta.id, "crop": crop })
    });
    let document = json!({
        "version": 1, "seed": 1, "layout": template.id(), "style": style_of_the_pages(),
        "panels": panels.collect::<Vec<_>>(), "page": settings,
    });
    let scene = Scene::new(&Document::parse(&document.to_string()).unwrap(), WIDTH).unwrap();
    let find = |id: &str| photos.iter().find(|photo| photo.meta.id == id).map(|photo| &photo.work);
    let sheet = compose::compose(&scene, find, &mut Context::default()).unwrap();
    Image::from_interleaved_rgb(sheet.width(), sheet.height(), sheet.rgb()).unwrap()
}

#[test]
fn a_page_of_each_family_of_layouts_looks_as_it_did() {
    let photos = PHOTOS.map(|name| import(name, &photo(name), &Limits::default()).unwrap());
    let mut goldens = Goldens::of("pages", ALLOWED);
    for family in FAMILIES {
        let first = layout::catalogue().iter().find(|template| template.family() == family);
        // Families of custom and generated layouts have no files.
        if let Some(template) = first {
            goldens.hold(family, &page(template, &photos));
        }
    }
    goldens.finish();
}

#[test]
fn every_designed_style_looks_as_it_did() {
    let macaw = decode(&photo("macaw"), &Limits::default()).unwrap().image;
    let macaw = resample_image(&macaw, HEAD_AND_WING, WIDTH, WIDTH * 2 / 3);
    let mut goldens = Goldens::of("styles", ALLOWED);
    for style in catalogue() {
        let mut context = Context::default();
        context.set_scale(SCALE);
        context.show_painters(Some(crate::painters::painters()));
        goldens.hold(&style.id, &stylize(&macaw, style, &mut context).unwrap());
    }
    goldens.finish();
}
