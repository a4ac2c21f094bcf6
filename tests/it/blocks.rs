//! Every filter block against the same by numpy, scipy, scikit-image or `OpenCV`. The expected images are made by
//! `tests/oracles/blocks.py`; a case that fails leaves expected and actual in `target/oracles/`.

use std::fs;

use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::simd::point::luma_plane;
use inkpanel_engine::style::blocks::ALL;
use inkpanel_engine::style::{Context, Style, chain};
use serde_json::{Map, Value, json};

/// How far a block may be from its oracle.
#[derive(Clone, Copy)]
enum Bound {
    /// Largest difference, in grey steps.
    Max(f64),
    /// Root of the mean square, in grey steps.
    Rmse(f64),
    /// Peak signal to noise ratio, at least, in decibels.
    Decibels(f64),
    /// Maximum difference 1, except for this share of the samples.
    OneBut(f64),
    /// Means of areas of 24 x 24 pixels, as shares of full ink.
    Coverage(f64),
}
use Bound::{Coverage, Decibels, Max, OneBut, Rmse};

/// Luma is rounded from 1/128 steps, so near the edge between two levels it may round to the other one.
const OTHER_LEVEL: Bound = OneBut(0.01);

/// The bound of a case, and why it is not 0. Other blocks may differ by one rounding.
#[allow(clippy::match_same_arms, reason = "each block has a reason of its own")]
fn bound(block: &str, params: &Map<String, Value>) -> Bound {
    let number = |name: &str| params.get(name).and_then(Value::as_f64).unwrap_or(0.0);
    match block {
        // Fixed point of 15 bits rounds to the other side of a half now and then.
        "to_gray" | "saturation" | "hue" | "colorize" => Max(1.0),
        // The stored U and V are bytes. A half that is rounded in the other direction is 1.77 levels of blue.
        "to_color" => OneBut(0.01),
        // Tables of the exact formula; a half is rounded up here and there.
        "posterize" | "dynamic_range" => Max(1.0),
        "soft_threshold" if params.get("channels") != Some(&json!("luma")) => Max(1.0),
        // A gain multiplies the other rounding of luma.
        "brightness" | "equalize" if params.get("channels") != Some(&json!("each")) => Max(3.0),
        "brightness" | "equalize" => Max(1.0),
        "luma_posterize" | "soft_threshold" => OTHER_LEVEL,
        // Two roundings to bytes; the blur itself is exact to a quarter of a grey step.
        "gaussian" => Max(1.0),
        // The dual iteration stops when the eye no longer sees a change: 6 iterations at the default.
        "tvf" if number("time") <= 15.0 => Decibels(42.0),
        "tvf" => Decibels(38.0),
        // The trained filters see 7 x 7 pixels a pass; beyond sigma 2 they are approximate.
        "etf" if number("sigma") <= 2.0 => Decibels(43.0),
        "etf" => Decibels(39.0),
        // p = 20 multiplies the error of the blurs, which store 1/64 of a grey level.
        "xdog" => Rmse(1.0),
        // A grid of cells for a sum over all pixels.
        "detail" if number("delta") < 0.0 => Decibels(40.0),
        "detail" => Decibels(43.0),
        "sobel" => Max(1.0),
        // Rounded and clipped once per axis, which matters if Catmull-Rom overshoots.
        "size" => OneBut(0.001),
        "pattern" => Max(1.0),
        // Radii are stored in bytes: the edge of a dot may be soft by another shade, its area may not differ.
        "halftone" => Coverage(0.025),
        // Averages along the field are rounded to 1/32 grey steps, and a line's end may fall on either side of a tone.
        "flow_lines" => Decibels(45.0),
        // A cell with a direction between two sectors may use either.
        "kuwahara" => Decibels(55.0),
        // Weights and activations are 16-bit integers, and the network amplifies a rounded pixel of its input.
        "painter" => Decibels(38.0),
        // The phase is solved by a number of sweeps, the oracle's by least squares to the end; straight lines are exact.
        "engrave" if number("follow") <= 0.0 => Decibels(80.0),
        "engrave" => Decibels(33.0),
        "strokes" => Decibels(40.0),
        // Both use cells of 8 grey levels for colours. Votes at a border are single precision in one and
        // double precision in the other.
        "flatten" => Decibels(50.0),
        "plates" => Decibels(48.0),
        // Heights are bytes.
        "paper" => Decibels(48.0),
        _ => Max(1.0),
    }
}

fn read(name: &str) -> Image {
    let bytes = fs::read(crate::root("tests/oracles/data/blocks").join(name)).unwrap();
    decode(&bytes, &Limits::default()).unwrap().image
}

/// One row of `blocks.json`.
struct Case {
    block: String,
    params: Map<String, Value>,
    source: String,
    top: usize,
    size: (usize, usize),
}

fn cases() -> Vec<Case> {
    let text = fs::read_to_string(crate::root("tests/oracles/data/blocks/blocks.json")).unwrap();
    let rows: Vec<Value> = serde_json::from_str(&text).unwrap();
    let length = |value: &Value| usize::try_from(value.as_u64().unwrap()).unwrap();
    rows.iter()
        .map(|row| Case {
            block: row["block"].as_str().unwrap().to_owned(),
            params: row["params"].as_object().unwrap().clone(),
            source: row["source"].as_str().unwrap().to_owned(),
            top: length(&row["top"]),
            size: (length(&row["size"][0]), length(&row["size"][1])),
        })
        .collect()
}

/// Returns the result of the block as three planes or one, row by row.
fn actual(case: &Case) -> Image {
    let mut image = read(&format!("{}.png", case.source));
    if case.source == "luma" {
        image = Image::from_luma(luma_plane(&image));
    }
    let mut step = case.params.clone();
    step.insert("block".into(), json!(case.block));
    let mut steps = vec![Value::Object(step)];
    if ["to_color", "colorize", "pattern"].contains(&case.block.as_str()) {
        steps.insert(0, json!({"block": "to_gray"}));
    }
    let style = Style::parse("case", &json!({ "background": steps }).to_string()).unwrap();
    let mut context = Context::default();
    context.set_scale(1.0);
    context.show_painters(Some(crate::painters::painters()));
    chain::run_owned(&style.background, image, &mut context).unwrap()
}

fn expected(case: &Case, channels: usize) -> Vec<Vec<u8>> {
    let sheet = read(&format!("{}.png", case.block));
    let plane = |i: usize| {
        let plane = &sheet.planes()[i.min(sheet.planes().len() - 1)];
        let rows = case.top..case.top + case.size.1;
        rows.flat_map(|y| plane.row(y)[..case.size.0].iter().copied()).collect()
    };
    (0..channels).map(plane).collect()
}

/// Returns whether the samples are within the limit, and the measured value.
fn judge(bound: Bound, actual: &[Vec<u8>], expected: &[Vec<u8>], width: usize) -> (bool, f64) {
    let pairs = || actual.iter().flatten().zip(expected.iter().flatten());
    let count = pairs().count() as f64;
    let square: f64 = pairs().map(|(&a, &b)| f64::from(a.abs_diff(b)).powi(2)).sum::<f64>() / count;
    match bound {
        Max(most) => {
            let worst = pairs().map(|(&a, &b)| a.abs_diff(b)).max().map_or(0.0, f64::from);
            (worst <= most, worst)
        }
        Rmse(most) => (square.sqrt() <= most, square.sqrt()),
        Decibels(least) => {
            let decibels = 10.0 * (255.0 * 255.0 / square.max(1e-9)).log10();
            (decibels >= least, decibels)
        }
        OneBut(share) => {
            let others = pairs().filter(|&(&a, &b)| a.abs_diff(b) > 1).count() as f64 / count;
            (others <= share, others)
        }
        Coverage(most) => {
            let worst = actual
                .iter()
                .zip(expected)
                .flat_map(|(a, b)| means(a, width).into_iter().zip(means(b, width)))
                .map(|(a, b)| (a - b).abs() / 255.0)
                .fold(0.0, f64::max);
            (worst <= most, worst)
        }
    }
}

/// Returns the means of the complete 24 x 24 areas of a plane.
fn means(samples: &[u8], width: usize) -> Vec<f64> {
    const SIDE: usize = 24;
    let rows: Vec<&[u8]> = samples.chunks_exact(width).collect();
    let mut means = Vec::new();
    for band in rows.chunks_exact(SIDE) {
        for x in (0..=width - SIDE).step_by(SIDE) {
            let area = band.iter().flat_map(|row| &row[x..x + SIDE]);
            means.push(area.map(|&v| f64::from(v)).sum::<f64>() / (SIDE * SIDE) as f64);
        }
    }
    means
}

fn keep(case: &Case, number: usize, image: &Image, expected: &[Vec<u8>]) {
    let folder = crate::root("target/oracles");
    fs::create_dir_all(&folder).unwrap();
    let (width, height) = (image.width() as u32, image.height() as u32);
    let pixel = |planes: [&[u8]; 3], i: usize| [planes[0][i], planes[1][i], planes[2][i]];
    let save = |name: &str, planes: Vec<&[u8]>| {
        let planes = [0, 1, 2].map(|i: usize| planes[i.min(planes.len() - 1)]);
        let bytes: Vec<u8> = (0..planes[0].len()).flat_map(|i| pixel(planes, i)).collect();
        let file = fs::File::create(folder.join(format!("{}-{number}-{name}.png", case.block))).unwrap();
        let mut encoder = png::Encoder::new(file, width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.write_header().unwrap().write_image_data(&bytes).unwrap();
    };
    save("actual", image.planes().iter().map(inkpanel_engine::raster::Plane::samples).collect());
    save("expected", expected.iter().map(Vec::as_slice).collect());
}

#[test]
fn every_block_draws_what_its_oracle_draws() {
    let mut failures = Vec::new();
    for (number, case) in cases().iter().enumerate() {
        // A block that is not there is the matter of the next test.
        if inkpanel_engine::style::blocks::find(&case.block).is_none() {
            continue;
        }
        let image = actual(case);
        let line = format!("{} {:?} on {}", case.block, case.params, case.source);
        assert_eq!((image.width(), image.height()), case.size, "{line}");
        let planes: Vec<Vec<u8>> = image.planes().iter().map(|plane| plane.samples().to_vec()).collect();
        let expected = expected(case, planes.len());
        let bound = bound(&case.block, &case.params);
        let (within, measured) = judge(bound, &planes, &expected, image.width());
        println!("{line}: {measured:.4}");
        if !within {
            keep(case, number, &image, &expected);
            failures.push(format!("{line}: {measured:.4}"));
        }
    }
    assert!(failures.is_empty(), "see target/oracles:\n  {}", failures.join("\n  "));
}

#[test]
fn every_block_has_an_oracle() {
    let cases = cases();
    for block in ALL {
        assert!(cases.iter().any(|case| case.block == block.id), "{} has no case in blocks.py", block.id);
    }
}

/// A flat grey of any tone gets the requested coverage, for any size of the dots.
#[test]
fn halftone_covers_what_it_should() {
    for pitch in [6.0, 7.5, 10.0, 16.0, 25.0, 40.0] {
        for gray in (0..=255u8).step_by(17) {
            let image = Image::from_luma(inkpanel_engine::raster::Plane::filled(480, 480, gray));
            let style = json!({"background": [{"block": "halftone", "pitch": pitch}]}).to_string();
            let style = Style::parse("case", &style).unwrap();
            let mut context = Context::default();
            context.set_scale(1.0);
            let out = chain::run_owned(&style.background, image, &mut context).unwrap();
            let sum: f64 = out.planes()[0].samples().iter().map(|&v| f64::from(v)).sum();
            let paper = sum / (480.0 * 480.0 * 255.0);
            let error = (paper - f64::from(gray) / 255.0).abs();
            assert!(error <= 0.025, "pitch {pitch}, gray {gray}: {error:.4}");
        }
    }
}
