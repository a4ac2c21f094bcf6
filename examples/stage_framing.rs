//! Stage `framing`: assigns photos to panels, and crops them.
//!
//!     cargo run --example stage_framing -- cinema-4 PHOTOS...

use std::error::Error;

use inkpanel_engine::framing::PhotoMeta;
use inkpanel_engine::layout::{PageSettings, find, resolve};
use inkpanel_engine::page::import::import;
use inkpanel_engine::plan::{Order, assign, slots};
use inkpanel_engine::raster::decode::Limits;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [layout, names @ ..] = arguments.as_slice() else {
        return Err("usage: stage_framing ID PHOTOS...".into());
    };
    let facts = |name: &String| -> Result<PhotoMeta, Box<dyn Error>> {
        Ok(import(name, &std::fs::read(name)?, &Limits::default())?.meta)
    };
    let photos: Vec<PhotoMeta> = names.iter().map(facts).collect::<Result<_, _>>()?;
    let page = PageSettings::default();
    let panels = resolve(find(layout)?, page.aspect(), &page);
    let wanted = slots(&panels, f64::from(page.width));
    for (i, shown) in assign(&photos, &wanted, Order::Kept, 7).iter().enumerate() {
        let crop = shown.crop;
        println!(
            "panel {}: {}, {:.2} x {:.2} at {:.2}, {:.2}",
            i + 1,
            photos[shown.photo].id,
            crop.width,
            crop.height,
            crop.x,
            crop.y
        );
    }
    Ok(())
}
