//! Default colours of text items, from the style of their page: ink, paper and accent. `build.rs` computes
//! them for the built-in styles, so that the `words` module does not contain styles.
//!
//! Text has a contrast of at least 7 : 1 with its background (WCAG 2.2, success criterion 1.4.6).

use serde_json::Value;

/// Colours as red, green and blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Palette {
    /// Text and outlines.
    pub ink: [u8; 3],
    /// Inside of balloons.
    pub paper: [u8; 3],
    /// Inside of captions.
    pub note: [u8; 3],
    /// Text of sound effects.
    pub accent: [u8; 3],
    /// Outline of sound effects.
    pub edge: [u8; 3],
}

/// Minimum contrast of text to its background.
const CONTRAST: f64 = 7.0;

/// The palette of a complete style. Invalid styles get the palette of an empty style.
#[must_use]
pub fn of(style: &Value) -> Palette {
    let ink = style["ink"].as_str().and_then(hex).unwrap_or([0; 3]);
    let blocks: Vec<&Value> = style["background"].as_array().into_iter().flatten().collect();
    let runs =
        |name: &str| blocks.iter().rposition(|block| block["block"] == name && block["bypass"] != true);
    // White lines are on a dark ground, so the paper of text is as light as the lines.
    let light = luma(ink) > 0.35;
    let paper = if light { mixed(ink, [255; 3], 0.6) } else { paper(&blocks, &runs) };
    let ink = readable(if light { [16, 18, 26] } else { ink }, paper);
    let coloured = runs("to_color").max(runs("colorize")).max(runs("plates"));
    let gray = runs("to_gray").is_some_and(|gray| coloured.is_none_or(|colour| colour < gray))
        || runs("brightness").is_some_and(|at| number(blocks[at], "gain") == Some(0.0));
    let accent = if gray { paper } else { accent(&blocks, &runs) };
    let note = if gray { mixed(paper, ink, 0.07) } else { mixed(paper, accent, 0.2) };
    Palette { ink, paper, note: if contrast(ink, note) < CONTRAST { paper } else { note }, accent, edge: ink }
}

/// The sheet under the picture: flat colour, tinted paper, or white.
fn paper(blocks: &[&Value], runs: &impl Fn(&str) -> Option<usize>) -> [u8; 3] {
    let flat = runs("brightness").filter(|&at| number(blocks[at], "gain") == Some(0.0));
    if let Some(hue) = flat.and_then(|at| blocks.get(at + 1)).filter(|block| block["block"] == "hue") {
        let part = |name: &str| number(hue, name).unwrap_or(0.0).clamp(0.0, 255.0) as u8;
        let colour = ["red", "green", "blue"].map(part);
        if luma(colour) > 0.5 {
            return mixed(colour, [255; 3], 0.35);
        }
    }
    match runs("paper").and_then(|at| blocks[at]["tint"].as_str()) {
        Some("ivory") => [255, 253, 243],
        Some("cream") => [255, 249, 232],
        Some("newsprint") => [250, 246, 235],
        Some("kraft") => [248, 236, 216],
        Some("blue") => [243, 247, 252],
        Some("rose") => [253, 244, 244],
        _ => [255; 3],
    }
}

/// The accent colour of a style.
fn accent(blocks: &[&Value], runs: &impl Fn(&str) -> Option<usize>) -> [u8; 3] {
    let inks = runs("plates").map(|at| blocks[at]["inks"].as_str().unwrap_or("red-blue"));
    match inks {
        Some(inks) if inks.contains("yellow") => return [255, 216, 30],
        Some(inks) if inks.starts_with("pink") => return [255, 120, 170],
        Some(inks) if inks.starts_with("teal") => return [90, 205, 190],
        Some(inks) if inks.starts_with("orange") || inks.starts_with("violet") => return [255, 150, 50],
        Some(inks) if inks.starts_with("coral") => return [255, 140, 120],
        Some(_) => return [250, 90, 75],
        None => {}
    }
    match runs("flatten").and_then(|at| blocks[at]["palette"].as_str()) {
        Some("pastel") => [255, 208, 160],
        Some("retro") => [244, 180, 70],
        Some("earth") => [226, 166, 90],
        Some("night") => [140, 205, 255],
        Some("sunset") => [255, 150, 70],
        Some("gouache") => [248, 202, 100],
        _ => [255, 210, 31],
    }
}

/// Returns the ink, or a darker colour if it is unreadable on the paper.
fn readable(ink: [u8; 3], paper: [u8; 3]) -> [u8; 3] {
    let darker = (0..=10).map(|step| mixed(ink, [0; 3], f64::from(step) / 10.0));
    darker.into_iter().find(|ink| contrast(*ink, paper) >= CONTRAST).unwrap_or([0; 3])
}

fn number(block: &Value, name: &str) -> Option<f64> {
    block[name].as_f64()
}

fn hex(text: &str) -> Option<[u8; 3]> {
    let value = u32::from_str_radix(text.strip_prefix('#').filter(|digits| digits.len() == 6)?, 16).ok()?;
    Some([(value >> 16) as u8, (value >> 8) as u8, value as u8])
}

fn mixed(from: [u8; 3], to: [u8; 3], part: f64) -> [u8; 3] {
    [0, 1, 2].map(|i| (f64::from(from[i]) * (1.0 - part) + f64::from(to[i]) * part).round() as u8)
}

/// Relative luminance, 0 to 1.
fn luma(colour: [u8; 3]) -> f64 {
    let linear = |part: u8| {
        let part = f64::from(part) / 255.0;
        if part <= 0.040_45 { part / 12.92 } else { ((part + 0.055) / 1.055).powf(2.4) }
    };
    0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2])
}

/// From 1 to 21.
#[must_use]
pub fn contrast(a: [u8; 3], b: [u8; 3]) -> f64 {
    let (a, b) = (luma(a), luma(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}
