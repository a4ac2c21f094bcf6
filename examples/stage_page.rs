//! Stage `page`: a page planned from photos and a seed, drawn, and written as PNG.
//!
//!     cargo run --example stage_page -- OUT.png PHOTOS...

use std::collections::HashMap;
use std::error::Error;

use inkpanel_engine::page::import::import;
use inkpanel_engine::page::request::Request;
use inkpanel_engine::page::{Scene, compose, png, shuffle};
use inkpanel_engine::raster::decode::Limits;
use inkpanel_engine::style::Context;
use serde_json::json;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [out, names @ ..] = arguments.as_slice() else {
        return Err("usage: stage_page OUT.png PHOTOS...".into());
    };
    let (mut photos, mut facts) = (HashMap::new(), Vec::new());
    for name in names {
        let photo = import(name, &std::fs::read(name)?, &Limits::default())?;
        facts.push(photo.meta);
        photos.insert(name.clone(), photo.work);
    }
    // Omitted fields are chosen by the seed, or have default values.
    let request = json!({ "seed": 7, "photos": facts, "style": "comic", "panels": names.len() });
    let document = shuffle::plan(&serde_json::from_value::<Request>(request)?)?;
    let scene = Scene::new(&document, 1200)?;
    let sheet = compose::compose(&scene, |id| photos.get(id), &mut Context::default())?;
    std::fs::write(out, png::encode(&sheet, document.page.dpi)?)?;
    Ok(())
}
