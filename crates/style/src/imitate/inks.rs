//! The paper and the inks of a print, from its colours. Inks multiply, so their overprints are known.

use super::colours::{Colour, delta_e, oklab};
use crate::order::sort_by;

/// Minimum share of the picture for a colour that counts as paper.
const PAPER: f32 = 0.02;

/// Coverages that are tried for each ink.
const COVERAGES: [f32; 4] = [0.0, 0.35, 0.7, 1.0];

/// Minimum reduction of the error for one more ink, in Oklab.
const WORTH: f32 = 0.012;

/// Paper and inks of a printed picture.
#[derive(Debug, Clone, PartialEq)]
#[allow(clippy::struct_field_names, reason = "paper and inks are the printer's words")]
pub(super) struct Inks {
    pub(super) paper: [u8; 3],
    /// One to three, as they look on white, the darkest first.
    pub(super) inks: Vec<[u8; 3]>,
    /// Mean distance of the colours from the printable colours, in Oklab.
    pub(super) error: f32,
}

impl Inks {
    /// The one to three colours of a palette that, laid on its lightest, make all the others best.
    pub(super) fn of(palette: &[Colour]) -> Self {
        let light = |colour: &Colour| oklab(colour.rgb)[0];
        let common = palette.iter().filter(|colour| colour.share >= PAPER);
        let paper = common.max_by(|a, b| light(a).total_cmp(&light(b))).map_or([255; 3], |colour| colour.rgb);
        let others: Vec<[f32; 3]> = palette
            .iter()
            .filter(|colour| delta_e(colour.rgb, paper) > 6.0)
            .map(|colour| [0, 1, 2].map(|c| (f32::from(colour.rgb[c]) / f32::from(paper[c].max(1))).min(1.0)))
            .collect();
        let mut best: Option<(f32, f32, Vec<[f32; 3]>)> = None;
        for set in 1u32..1 << others.len() {
            let inks: Vec<[f32; 3]> =
                (0..others.len()).filter(|i| (set >> i) & 1 == 1).map(|i| others[i]).collect();
            if inks.len() > 3 {
                continue;
            }
            let error = error(palette, paper, &inks);
            let cost = error + WORTH * inks.len() as f32;
            if best.as_ref().is_none_or(|(known, ..)| cost < *known) {
                best = Some((cost, error, inks));
            }
        }
        let (error, inks) = best.map_or((0.0, vec![[0.1; 3]]), |(_, error, inks)| (error, inks));
        let mut inks: Vec<[u8; 3]> =
            inks.iter().map(|ink| ink.map(|share| (share * 255.0).round() as u8)).collect();
        sort_by(&mut inks, |a, b| oklab(*a)[0].total_cmp(&oklab(*b)[0]));
        Self { paper, inks, error }
    }
}

/// Root of the mean square distance of the colours to the nearest that these inks make.
fn error(palette: &[Colour], paper: [u8; 3], inks: &[[f32; 3]]) -> f32 {
    let made: Vec<[f32; 3]> = (0..COVERAGES.len().pow(inks.len() as u32))
        .map(|mut place| {
            let mut colour = paper.map(f32::from);
            for ink in inks {
                let covered = COVERAGES[place % COVERAGES.len()];
                place /= COVERAGES.len();
                for (tone, ink) in colour.iter_mut().zip(ink) {
                    *tone *= 1.0 - covered * (1.0 - ink);
                }
            }
            oklab(colour.map(|tone| tone.round() as u8))
        })
        .collect();
    let (mut sum, mut total) = (0.0, 0.0);
    for colour in palette {
        let point = oklab(colour.rgb);
        let apart = |made: &[f32; 3]| (0..3).map(|i| (made[i] - point[i]).powi(2)).sum::<f32>();
        sum += colour.share * made.iter().map(apart).fold(f32::INFINITY, f32::min);
        total += colour.share;
    }
    (sum / total.max(1e-6f32)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_inks_and_their_overprint_are_told_from_three() {
        let colour = |rgb| Colour { rgb, share: 0.25 };
        // Red, blue, both over each other, on cream.
        let found = Inks::of(&[
            colour([248, 239, 220]),
            colour([234, 75, 52]),
            colour([0, 92, 148]),
            colour([0, 29, 35]),
        ]);
        assert_eq!(found.paper, [248, 239, 220]);
        assert_eq!(found.inks, [[0, 98, 172], [241, 80, 60]]);
        assert!(found.error < 0.03, "{found:?}");
    }
}
