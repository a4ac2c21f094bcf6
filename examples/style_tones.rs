//! Measures the luma that each built-in style gives for each sixteenth of luma, and writes it to
//! `crates/engine/src/plan/marks.txt`. Marks and uses in the file do not change. A style without a mark gets 6.5.
//!
//!     cargo run --release --example style_tones

use std::fmt::Write as _;
use std::sync::Arc;

use inkpanel_engine::plan::tones;
use inkpanel_engine::raster::{Image, Plane};
use inkpanel_engine::style::painters::Painters;
use inkpanel_engine::style::{Context, catalogue, stylize};

/// Patches of the card across and down, and the side of a patch.
const PATCHES: usize = 4;
const SIDE: usize = 72;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Patches of each tone with some texture, as photos have it.
    let card = Plane::from_fn(PATCHES * SIDE, PATCHES * SIDE, |x, y| {
        let tone = (y / SIDE * PATCHES + x / SIDE) as i32 * 16 + 8;
        let wave = ((x as f32 * 0.11).sin() + (y as f32 * 0.07).cos()) * 5.0;
        let grain = ((x * 7919 + y * 104_729 + x * y * 31) % 13) as i32 - 6;
        (tone + wave as i32 + grain / 2).clamp(0, 255) as u8
    });
    let card = Image::from_rgb([card.clone(), card.clone(), card])?;
    let painters = Arc::new(Painters::new(&std::fs::read("www/models/painters.onnx")?)?);
    let mut lines = Vec::new();
    for style in catalogue::catalogue() {
        let mut context = Context::default();
        context.set_scale(0.7);
        context.show_painters(Some(painters.clone()));
        let drawn = stylize(&card, style, &mut context)?.to_rgb();
        let mut response = String::new();
        for patch in 0..PATCHES * PATCHES {
            let (left, top) = (patch % PATCHES * SIDE, patch / PATCHES * SIDE);
            let (mut sum, mut count) = (0, 0);
            // The rim of a patch is an edge, which the style may draw.
            for y in top + 10..top + SIDE - 10 {
                for x in left + 10..left + SIDE - 10 {
                    let at = 3 * (y * PATCHES * SIDE + x);
                    let [r, g, b] = [0, 1, 2].map(|channel| usize::from(drawn[at + channel]));
                    sum += (77 * r + 150 * g + 29 * b) >> 8;
                    count += 1;
                }
            }
            write!(response, "{:02x}", sum / count)?;
        }
        let uses = tones::uses(&style.id);
        lines.push((tones::rating(&style.id).unwrap_or(6.5), style.id.clone(), format!("{response} {uses}")));
    }
    lines.sort_by(|a, b| b.0.total_cmp(&a.0).then_with(|| a.1.cmp(&b.1)));
    let mut text = String::new();
    for (rating, id, response) in &lines {
        writeln!(text, "{}", format!("{id} {rating} {response}").trim_end())?;
    }
    std::fs::write("crates/engine/src/plan/marks.txt", text)?;
    Ok(())
}
