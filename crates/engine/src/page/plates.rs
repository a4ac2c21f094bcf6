//! Spot-colour separation: splits colours into inks, for risographs and screen printing, which need one gray
//! image per ink. The inks come from the style's block of printing plates.
//!
//! Inks multiply (`style/blocks/plates.rs`), so a colour is the product over inks of `1 - a (1 - ink)`. Least squares finds the coverages `a`, one ink after the other. Each step is exact, because the product is linear in one coverage. A table of 33 x 33 x 33 colours has the results, with linear interpolation.

use crate::page::{Document, StyleRef};
use crate::style::Style;
use crate::style::blocks::plates::{self, Ink};
use crate::style::file::Step;

/// Colours along each side of the table.
const SIDE: usize = 33;
/// Rounds over all inks. The remaining error is below one level.
const ROUNDS: usize = 40;

/// Ink coverages of each colour.
pub struct Separation {
    inks: usize,
    /// Coverage of each ink, colour by colour.
    table: Vec<[f32; 3]>,
}

impl Separation {
    /// The separation of a style. `None` if it has no printing plates.
    #[must_use]
    pub fn of(style: &Style) -> Option<Self> {
        inks(style).map(|inks| Self::new(&colours(&inks)))
    }

    /// The separation for inks of these colours on white paper, the strongest last, independent of styles.
    #[must_use]
    pub fn new(inks: &[[u8; 3]]) -> Self {
        Self { inks: inks.len(), table: table(inks) }
    }

    /// How many inks there are.
    #[must_use]
    pub fn inks(&self) -> usize {
        self.inks
    }

    /// Coverage of an ink's plate for a page colour, 0 to 255.
    #[must_use]
    pub fn cover(&self, rgb: [u8; 3], ink: usize) -> u8 {
        let scaled = rgb.map(|tone| f32::from(tone) * (SIDE - 1) as f32 / 255.0);
        let low = scaled.map(|at| (at as usize).min(SIDE - 2));
        let share = [0, 1, 2].map(|i| scaled[i] - low[i] as f32);
        let mut sum = 0.0;
        for corner in 0..8usize {
            let up = [corner >> 2, (corner >> 1) & 1, corner & 1];
            let place = [0, 1, 2].map(|i| low[i] + up[i]);
            let weight: f32 = (0..3).map(|i| if up[i] == 1 { share[i] } else { 1.0 - share[i] }).product();
            sum += weight * self.table[(place[0] * SIDE + place[1]) * SIDE + place[2]][ink.min(2)];
        }
        (sum * 255.0 + 0.5) as u8
    }
}

/// The inks of the last printing plates block of a style. `None` if the block applies to only a part of the
/// image.
#[must_use]
pub fn inks(style: &Style) -> Option<Vec<Ink>> {
    let mut steps = style.background.iter().chain(style.foreground.iter().flatten());
    let last = steps.rfind(|step| plates::inks_of(step).is_some())?;
    if last.part.is_some() || style.parts.background.is_some() {
        return None;
    }
    plates::inks_of(last)
}

/// The colours of inks.
#[must_use]
pub fn colours(inks: &[Ink]) -> Vec<[u8; 3]> {
    inks.iter().map(|ink| ink.rgb).collect()
}

/// The page for drawing plates: without misregistration, grain and paper, which the press adds.
///
/// # Errors
/// `unknown-style`, `invalid-style`.
pub fn exact(document: &Document) -> crate::error::Result<Document> {
    let mut style = document.style()?.into_owned();
    let made_exact = |steps: &mut Vec<Step>| {
        for step in steps {
            match step.block.id {
                "plates" => *step = plates::exact(step),
                "paper" => step.bypass = true,
                _ => {}
            }
        }
    };
    made_exact(&mut style.background);
    style.foreground.iter_mut().for_each(made_exact);
    Ok(Document { style: StyleRef::of(&style), ..document.clone() })
}

fn table(inks: &[[u8; 3]]) -> Vec<[f32; 3]> {
    let missing: Vec<[f32; 3]> =
        inks.iter().map(|ink| ink.map(|tone| 1.0 - f32::from(tone) / 255.0)).collect();
    let tone = |at: usize| at as f32 / (SIDE - 1) as f32;
    let colors = (0..SIDE.pow(3)).map(|i| [tone(i / SIDE / SIDE), tone(i / SIDE % SIDE), tone(i % SIDE)]);
    colors.map(|color| solved(&missing, color)).collect()
}

/// Returns the coverages whose product is nearest to a colour.
fn solved(missing: &[[f32; 3]], color: [f32; 3]) -> [f32; 3] {
    let mut covers = [0.0f32; 3];
    for _ in 0..ROUNDS {
        for ink in 0..missing.len().min(3) {
            let (mut above, mut below) = (0.0, 1e-9);
            for channel in 0..3 {
                let others: f32 = (0..missing.len().min(3))
                    .filter(|&other| other != ink)
                    .map(|other| 1.0 - covers[other] * missing[other][channel])
                    .product();
                let slope = others * missing[ink][channel];
                above += slope * (others - color[channel]);
                below += slope * slope;
            }
            covers[ink] = (above / below).clamp(0.0, 1.0);
        }
    }
    covers
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::catalogue::catalogue;

    #[test]
    fn inks_are_found_again_in_what_they_print() {
        let style = catalogue().iter().find(|style| inks(style).is_some()).unwrap();
        let separation = Separation::of(style).unwrap();
        let inks = inks(style).unwrap();
        assert_eq!(separation.inks(), inks.len());
        let over = |covers: &[f32]| {
            [0, 1, 2].map(|channel| {
                let left: f32 = inks
                    .iter()
                    .zip(covers)
                    .map(|(ink, cover)| 1.0 - cover * (1.0 - f32::from(ink.rgb[channel]) / 255.0))
                    .product();
                (left * 255.0).round() as u8
            })
        };
        for covers in [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.5, 0.25, 0.0], [0.3, 0.9, 0.0]] {
            let color = over(&covers[..inks.len()]);
            for (ink, cover) in covers.iter().enumerate().take(inks.len()) {
                let found = separation.cover(color, ink);
                assert!((f32::from(found) - cover * 255.0).abs() < 7.0, "{covers:?}: {ink} {found}");
            }
        }
    }

    #[test]
    fn a_style_without_plates_has_no_inks() {
        let style = crate::style::catalogue::find("noir").unwrap();
        assert!(Separation::of(style).is_none());
    }
}
