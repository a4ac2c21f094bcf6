//! New styles from two others: their layers are crossed, their values changed a little. All chance comes from the
//! seed, so the same parents, seed and surprise give the same child on every machine.

use super::blocks::{Block, Channels};
use super::file::{Step, Style};
use super::params::Kind;
use super::part::Parts;
use super::procedural;
use oorandom::Rand64;

/// Maximum number of blocks in a layer of a child. More cost time and add nothing new.
const MOST: usize = 10;

/// A child of two styles, or of one that is given twice. `surprise` ranges from 0 (only crossing) to 1, which
/// changes values by up to a factor of four and adds, drops and swaps blocks. Its id is `bred-SEED`.
#[must_use]
pub fn breed(a: &Style, b: &Style, seed: u32, surprise: f64) -> Style {
    let surprise = if surprise.is_finite() { surprise.clamp(0.0, 1.0) } else { 0.0 };
    let mut random =
        Rand64::new(u128::from(seed).wrapping_mul(0xd6e8_feb8_6659_fd93_a5a3_5669_c5e2_17e9) | 1);
    let (first, second) = if random.rand_float() < 0.5 { (a, b) } else { (b, a) };
    let mut background = crossed(&first.background, &second.background, &mut random);
    let lines = if random.rand_float() < 0.5 { a } else { b };
    let mut foreground = match (&a.foreground, &b.foreground) {
        (Some(a), Some(b)) if random.rand_float() < 0.5 => Some(crossed(a, b, &mut random)),
        _ => lines.foreground.clone(),
    };
    for layer in std::iter::once(&mut background).chain(foreground.as_mut()) {
        mutate(layer, surprise, &mut random);
        repair(layer);
    }
    let foreground = foreground.filter(|layer| !layer.is_empty());
    if background.is_empty() && foreground.is_none() {
        background.clone_from(&first.background);
        repair(&mut background);
    }
    Style {
        id: format!("bred-{seed}"),
        name: procedural::name(&mut random),
        tags: vec!["invented".to_owned()],
        background,
        foreground,
        parts: Parts { background: first.parts.background, foreground: lines.parts.foreground },
        ink: lines.ink,
        faces: a.faces && b.faces,
        dark: first.dark,
        score: None,
    }
}

/// The head of one layer and the tail of another, cut at about the same part of each.
fn crossed(a: &[Step], b: &[Step], random: &mut Rand64) -> Vec<Step> {
    let cut = random.rand_float();
    let at = |layer: &[Step]| (cut * (layer.len() + 1) as f64) as usize;
    a[..at(a).min(a.len())].iter().chain(&b[at(b).min(b.len())..]).cloned().collect()
}

fn mutate(layer: &mut Vec<Step>, surprise: f64, random: &mut Rand64) {
    for step in layer.iter_mut() {
        for (param, value) in step.block.params.iter().zip(&mut step.values) {
            if random.rand_float() >= surprise.sqrt() {
                continue;
            }
            // Between -1 and 1, mostly near 0.
            let push = (random.rand_float() + random.rand_float() + random.rand_float()) / 1.5 - 1.0;
            let (least, most) = param.kind.range();
            let changed = match param.kind {
                // Any change of the number would be another colour altogether.
                Kind::Colour { .. } | Kind::Texture | Kind::Model => *value,
                Kind::Flag { .. } | Kind::Choice { .. } => {
                    let other = least + (most - least + 1.0) * random.rand_float() as f32;
                    if random.rand_float() < 0.4 * surprise { other.floor().min(most) } else { *value }
                }
                _ if least >= 0.0 && *value > 0.0 => *value * factor(push * surprise) as f32,
                _ => *value + (push * surprise) as f32 * 0.3 * (most - least),
            };
            *value = param.rounded(changed);
        }
    }
    if random.rand_float() < 0.6 * surprise {
        let place = random.rand_range(0..layer.len() as u64 + 1) as usize;
        match random.rand_range(0..3) {
            0 => layer.extend(procedural::any_step(random)),
            1 if place < layer.len() => drop(layer.remove(place)),
            _ if place + 1 < layer.len() => layer.swap(place, place + 1),
            _ => {
                if let Some(step) = procedural::any_step(random) {
                    layer.insert(place, step);
                }
            }
        }
    }
}

/// Returns 1/4 for -1, 1 for 0 and 4 for 1, by operations with identical rounding on every machine.
fn factor(push: f64) -> f64 {
    if push < 0.0 { 1.0 / (1.0 - 3.0 * push) } else { 1.0 + 3.0 * push }
}

/// Makes a layer valid. It removes blocks whose input channels do not fit, bypassed blocks, a second Size,
/// which would multiply the work, and blocks beyond the maximum.
fn repair(layer: &mut Vec<Step>) {
    let mut channels = Channels::Color;
    let mut sized = false;
    layer.retain(|step| {
        let misfit = misfits(step.block, channels);
        let again = step.block.id == "size" && sized;
        if step.bypass || misfit || again {
            return false;
        }
        sized |= step.block.id == "size";
        channels = step.block.given(channels, step.part);
        true
    });
    layer.truncate(MOST);
}

fn misfits(block: &Block, channels: Channels) -> bool {
    matches!((block.input, channels), (Channels::Luma, Channels::Color) | (Channels::Color, Channels::Luma))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::{Image, Plane};
    use crate::{Context, catalogue, procedural::invent, stylize};

    /// Designed and invented parents by turns.
    fn parents(seed: u32) -> (Style, Style) {
        let designed = catalogue::catalogue();
        let at = |i: usize| designed[i % designed.len()].clone();
        match seed % 3 {
            0 => (invent(seed), invent(seed + 1)),
            1 => (at(seed as usize), invent(seed)),
            _ => (at(seed as usize), at(seed as usize * 7 + 3)),
        }
    }

    #[test]
    fn every_child_is_a_valid_file_and_the_same_again() {
        for seed in 0..1500 {
            let (a, b) = parents(seed);
            let surprise = f64::from(seed % 11) / 10.0;
            let child = breed(&a, &b, seed, surprise);
            let read = Style::from_value("bred.json", &child.to_value()).unwrap();
            assert_eq!(read.to_value(), breed(&a, &b, seed, surprise).to_value());
            assert!(child.background.len() <= MOST);
        }
    }

    #[test]
    fn two_hundred_children_render() {
        let photo = Image::from_rgb(
            [3, 5, 7].map(|step| Plane::from_fn(61, 43, |x, y| ((x * step) ^ (y * 4)) as u8)),
        )
        .unwrap();
        for seed in 0..200 {
            let (a, b) = parents(seed);
            let child = breed(&a, &b, seed, f64::from(seed % 5) / 4.0);
            let drawn = stylize(&photo, &child, &mut Context::for_image(&photo)).unwrap();
            assert_eq!((drawn.width(), drawn.height()), (61, 43), "seed {seed}");
        }
    }

    #[test]
    fn without_surprise_a_style_bred_with_itself_is_itself() {
        for seed in 0..50 {
            let style = invent(seed);
            let child = breed(&style, &style, seed, 0.0);
            assert_eq!(child.to_value()["background"], style.to_value()["background"]);
        }
    }

    #[test]
    fn more_surprise_changes_more() {
        let changed = |surprise: f64| {
            (0..300)
                .filter(|&seed| {
                    let style = invent(seed);
                    let child = breed(&style, &style, seed, surprise);
                    child.to_value()["background"] != style.to_value()["background"]
                })
                .count()
        };
        let [none, little, much] = [0.0, 0.05, 1.0].map(changed);
        assert!(none < little && little < much && much > 290, "{none} {little} {much}");
    }
}
