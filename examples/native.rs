//! Times blocks on one thread of this machine, outside the browser, and prints JSON: milliseconds by operation.
//! `bench/native.py` times the same by `OpenCV`; `cargo xtask bench native` runs both.

use std::time::Instant;

use inkpanel_engine::error::Result;
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::resize::{Region, resample_image};
use inkpanel_engine::style::{Context, Style, chain};
use serde_json::{Map, Value, json};

/// Name in the table, whether on luma, and the block.
const ROWS: &[(&str, bool, &str)] = &[
    ("To GrayScale, colour", false, r#"{"block": "to_gray"}"#),
    ("Posterization", true, r#"{"block": "posterize"}"#),
    ("Soft Threshold", true, r#"{"block": "soft_threshold"}"#),
    ("Saturation, colour", false, r#"{"block": "saturation"}"#),
    ("Hue, angle 30, colour", false, r#"{"block": "hue", "angle": 30}"#),
    ("Gaussian Smoothing", true, r#"{"block": "gaussian"}"#),
    ("Gaussian Smoothing, sigma 6", true, r#"{"block": "gaussian", "sigma": 6}"#),
    ("Gaussian Smoothing, sigma 6, colour", false, r#"{"block": "gaussian", "sigma": 6}"#),
    ("Image Detail Control, delta -100", true, r#"{"block": "detail", "delta": -100}"#),
    ("Sobel", true, r#"{"block": "sobel"}"#),
    ("XDoG", true, r#"{"block": "xdog"}"#),
    ("Size, percent 50", true, r#"{"block": "size", "percent": 50}"#),
    ("Size, percent 50, colour", false, r#"{"block": "size", "percent": 50}"#),
    ("Size, percent 200", true, r#"{"block": "size", "percent": 200}"#),
    ("Linear Histogram Equalization", true, r#"{"block": "equalize"}"#),
    ("Flow Lines", true, r#"{"block": "flow_lines"}"#),
    ("Anisotropic Kuwahara, one pass, colour", false, r#"{"block": "kuwahara", "passes": 1}"#),
    ("Engraving", true, r#"{"block": "engrave"}"#),
    ("Pencil Strokes", true, r#"{"block": "strokes"}"#),
    ("Flat Areas, colour", false, r#"{"block": "flatten"}"#),
    ("Printing Plates, colour", false, r#"{"block": "plates"}"#),
    ("Paper, colour", false, r#"{"block": "paper"}"#),
];

/// Timed runs of each, after a few that warm up.
const RUNS: usize = 25;
const WARM: usize = 3;

fn main() -> std::result::Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("usage: native PHOTO")?;
    let photo = decode(&std::fs::read(path)?, &Limits::default())?.image;
    let photo = resample_image(&photo, Region::whole(photo.width(), photo.height()), 1920, 1080);
    let mut times = Map::new();
    for &(name, luma, block) in ROWS {
        times.insert(name.to_owned(), json!(median(&photo, luma, block)?));
    }
    println!("{}", Value::Object(times));
    Ok(())
}

/// Milliseconds of one run, which changes a copy in place; copying is not timed.
fn median(photo: &inkpanel_engine::raster::Image, luma: bool, block: &str) -> Result<f64> {
    let style = |blocks: &str| {
        Style::parse("row", &format!(r#"{{"id": "row", "name": "Row", "background": [{blocks}]}}"#))
    };
    let mut context = Context::for_image(photo);
    let mut source = photo.clone();
    if luma {
        source = chain::run_owned(&style(r#"{"block": "to_gray"}"#)?.background, source, &mut context)?;
    }
    let first = if luma { r#"{"block": "to_gray"}, "# } else { "" };
    let style = style(&format!("{first}{block}"))?;
    let steps = &style.background[usize::from(luma)..];
    let mut times = Vec::new();
    for _ in 0..WARM + RUNS {
        let image = source.clone();
        let start = Instant::now();
        let out = chain::run_owned(steps, image, &mut context)?;
        times.push(start.elapsed().as_secs_f64() * 1000.0);
        drop(out);
    }
    let mut times = times.split_off(WARM);
    times.sort_by(f64::total_cmp);
    Ok(times[RUNS / 2])
}
