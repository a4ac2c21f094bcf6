//! Generated styles: random chains of blocks, by the rules of "Graphic Narrative with Interactive Stylization
//! Design" (Garcia-Dorado et al., section on procedural styles). Three additional rules avoid results that
//! are nearly white or nearly the photo: see `STRETCH`, `DARK` and `STRONG`.
//!
//! The same seed gives the same style on every machine and in every release.

use super::blocks::{self, Block, Channels};
use super::file::{Step, Style};
use super::part::Parts;
use oorandom::Rand64;

/// Blocks of a chain, fewest and most.
const LENGTH: (u64, u64) = (4, 9);

/// Chance of a gray style.
const GRAY_CHANCE: f64 = 0.2;

/// A block that may be drawn, and the ranges of its values.
struct Draw {
    block: &'static str,
    /// Parameter, minimum and maximum. The others have their default values.
    ranges: &'static [(&'static str, f64, f64)],
    /// Whether it may occur more than once.
    repeats: bool,
}

/// The blocks to choose from. Ranges are from the paper.
const DRAWS: &[Draw] = &[
    Draw { block: "xdog", ranges: &[("sigma", 0.5, 8.0), ("p", 1.0, 40.0)], repeats: true },
    Draw { block: "tvf", ranges: &[("time", 3.0, 40.0)], repeats: true },
    Draw {
        block: "soft_threshold",
        ranges: &[("phi", 0.013, 0.059), ("epsilon", 50.0, 110.0)],
        repeats: false,
    },
    Draw { block: "detail", ranges: &[("delta", -100.0, 60.0)], repeats: false },
    Draw { block: "luma_posterize", ranges: &[("levels", 5.0, 12.0)], repeats: false },
    Draw { block: "saturation", ranges: &[("amount", 1.5, 2.2)], repeats: false },
    Draw { block: "size", ranges: &[("percent", 100.0, 300.0)], repeats: false },
];

/// The block before Soft Threshold. Soft Threshold turns everything above a rather dark gray into paper, so
/// most of a photo would become white. After this stretch, a good part of any photo lies below that gray.
const STRETCH: Draw =
    Draw { block: "equalize", ranges: &[("low", 12.0, 32.0), ("high", 96.0, 100.0)], repeats: false };

/// Least product of Soft Threshold's softness and threshold: with less, even black becomes a gray.
const DARK: f32 = 1.4;

/// Blocks with a visible effect on any photo.
const STRONG: [&str; 2] = ["xdog", "soft_threshold"];

/// First and second words of generated names.
const NAMES: [[&str; 16]; 2] = [
    [
        "Quiet", "Bold", "Dusty", "Late", "Wild", "Pale", "Deep", "Loose", "Sharp", "Warm", "Cold", "Rough",
        "Slow", "Bright", "Faded", "Night",
    ],
    [
        "Etching", "Poster", "Sketch", "Press", "Brush", "Plate", "Print", "Marker", "Charcoal", "Linocut",
        "Gouache", "Crayon", "Stencil", "Zine", "Mural", "Cartoon",
    ],
];

/// The style of a seed: four to nine blocks in one layer. Its id is `invented-SEED`.
#[must_use]
pub fn invent(seed: u32) -> Style {
    // Neighbouring seeds would give similar first numbers.
    let mut random =
        Rand64::new(u128::from(seed).wrapping_mul(0x9e37_79b9_7f4a_7c15_f39c_c060_5ced_c835) | 1);
    let count = random.rand_range(LENGTH.0..LENGTH.1 + 1) as usize;
    let mut chain: Vec<Step> = Vec::with_capacity(count);
    let gray = random.rand_float() < GRAY_CHANCE;
    if gray {
        chain.extend(blocks::find("to_gray").map(Step::new));
    }
    while chain.len() < count {
        let draw = &DRAWS[random.rand_range(0..DRAWS.len() as u64) as usize];
        let taken = !draw.repeats && chain.iter().any(|step| step.block.id == draw.block);
        let Some(block) = blocks::find(draw.block).filter(|_| !taken) else { continue };
        if gray && block.input == Channels::Color {
            continue;
        }
        if draw.block == "soft_threshold" {
            if chain.len() + 2 <= count {
                threshold(&mut chain, step_of(draw, block, &mut random), &mut random);
            }
            continue;
        }
        chain.push(step_of(draw, block, &mut random));
    }
    if !chain.iter().any(|step| STRONG.contains(&step.block.id)) {
        let at = random.rand_range(u64::from(gray)..chain.len() as u64) as usize;
        if let Some(xdog) = blocks::find(DRAWS[0].block) {
            chain[at] = step_of(&DRAWS[0], xdog, &mut random);
        }
    }
    if gray {
        // Any position except the last. At the end, the block could only undo changes of the colours.
        let to = random.rand_range(0..chain.len() as u64 - 1) as usize;
        let step = chain.remove(0);
        chain.insert(to, step);
    }
    Style {
        id: format!("invented-{seed}"),
        name: name(&mut random),
        tags: vec!["invented".to_owned()],
        background: chain,
        foreground: None,
        parts: Parts::default(),
        ink: [0; 3],
        faces: true,
        dark: false,
        score: None,
    }
}

/// Adds Soft Threshold and the block that it needs before it. A line block, whose output it turns into ink,
/// stays next to it.
fn threshold(chain: &mut Vec<Step>, mut step: Step, random: &mut Rand64) {
    if let [phi, epsilon, ..] = &mut step.values[..] {
        *phi = phi.max((DARK / *epsilon * 1000.0).ceil() / 1000.0);
    }
    let at = chain.len() - usize::from(chain.last().is_some_and(|last| last.block.id == "xdog"));
    if let Some(block) = blocks::find(STRETCH.block) {
        chain.insert(at, step_of(&STRETCH, block, random));
    }
    chain.push(step);
}

/// Any block that may be drawn, with values of its ranges.
pub(super) fn any_step(random: &mut Rand64) -> Option<Step> {
    let draw = &DRAWS[random.rand_range(0..DRAWS.len() as u64) as usize];
    blocks::find(draw.block).map(|block| step_of(draw, block, random))
}

/// Returns a name of two words.
pub(super) fn name(random: &mut Rand64) -> String {
    let mut word = |list: usize| NAMES[list][random.rand_range(0..16) as usize];
    format!("{} {}", word(0), word(1))
}

fn step_of(draw: &Draw, block: &'static Block, random: &mut Rand64) -> Step {
    let mut step = Step::new(block);
    for &(name, least, most) in draw.ranges {
        let at = block.params.iter().position(|param| param.id == name);
        let value = least + (most - least) * random.rand_float();
        if let Some(at) = at {
            step.values[at] = block.params[at].rounded(value as f32);
        }
    }
    step
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::aesthetic::judge;
    use crate::raster::decode::{Limits, decode_fit};
    use crate::raster::{Image, Plane};
    use crate::{Context, stylize};

    #[test]
    fn every_invented_style_is_a_valid_file_by_the_rules() {
        let mut grays = 0;
        for seed in 0..2000 {
            let style = invent(seed);
            let again = Style::from_value("invented.json", &style.to_value()).unwrap();
            assert_eq!(again.to_value(), invent(seed).to_value());
            assert!((4..=9).contains(&style.background.len()));
            for draw in DRAWS.iter().filter(|draw| !draw.repeats) {
                assert!(style.background.iter().filter(|step| step.block.id == draw.block).count() <= 1);
            }
            assert!(style.background.iter().any(|step| STRONG.contains(&step.block.id)));
            let at = style.background.iter().position(|step| step.block.id == "soft_threshold");
            if let Some(at) = at {
                let before = style.background[..at].iter().map(|step| step.block.id);
                let before: Vec<&str> = before.filter(|id| *id != "to_gray").collect();
                assert!(
                    before.ends_with(&["equalize"]) || before.ends_with(&["equalize", "xdog"]),
                    "{before:?}"
                );
                let values = &style.background[at].values;
                assert!((0.013..=0.059).contains(&values[0]) && (50.0..=110.0).contains(&values[1]));
                assert!(values[0] * values[1] >= DARK - 1e-3);
            }
            grays += u32::from(style.background.iter().any(|step| step.block.id == "to_gray"));
        }
        assert!((340..460).contains(&grays), "{grays} of 2000 are gray");
    }

    #[test]
    fn neighbouring_seeds_give_different_styles() {
        let chains: std::collections::BTreeSet<String> = (0..500)
            .map(|seed| {
                let value = invent(seed).to_value();
                value["background"].to_string()
            })
            .collect();
        assert_eq!(chains.len(), 500);
    }

    /// Before the rules of [`STRETCH`], [`DARK`] and [`STRONG`] it was every sixth.
    #[test]
    fn few_of_them_show_nothing() {
        let photo = include_bytes!("../../../tests/photos/raccoon.jpg");
        let photo = decode_fit(photo, &Limits::default(), 160).unwrap().image;
        let faulty = (0..200).filter(|&seed| {
            let drawn = stylize(&photo, &invent(seed), &mut Context::for_image(&photo)).unwrap();
            judge(&photo, &drawn).fault.is_some()
        });
        let count = faulty.count();
        assert!(count <= 12, "{count} of 200");
    }

    #[test]
    fn two_hundred_of_them_render() {
        let photo = Image::from_rgb(
            [3, 5, 7].map(|step| Plane::from_fn(61, 43, |x, y| ((x * step) ^ (y * 4)) as u8)),
        )
        .unwrap();
        for seed in 0..200 {
            let drawn = stylize(&photo, &invent(seed), &mut Context::for_image(&photo)).unwrap();
            assert_eq!((drawn.width(), drawn.height()), (61, 43), "seed {seed}");
        }
    }
}
