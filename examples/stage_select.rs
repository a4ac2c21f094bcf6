//! Stage `select`: which of some photos are worth a panel, and why.
//!
//!     cargo run --example stage_select -- PHOTOS...

use std::error::Error;

use inkpanel_engine::raster::decode::{Limits, decode_fit};
use inkpanel_engine::select::{Measures, Settings, choose, measure};

fn main() -> Result<(), Box<dyn Error>> {
    let names: Vec<String> = std::env::args().skip(1).collect();
    // A reduced copy is enough to compare photos by.
    let measured = |name: &String| -> Result<Measures, Box<dyn Error>> {
        Ok(measure(&decode_fit(&std::fs::read(name)?, &Limits::default(), 640)?.image))
    };
    let measures: Vec<Measures> = names.iter().map(measured).collect::<Result<_, _>>()?;
    let short: Vec<&str> = names.iter().map(String::as_str).collect();
    for (name, verdict) in names.iter().zip(choose(&short, &measures, &Settings::default())) {
        println!("{name}: group {}, {}", verdict.group, verdict.reason);
    }
    Ok(())
}
