//! Light score: the quality of a stylised photo, from 0 to 1, by simple statistics and without a model.
//!
//! It filters generated styles: it drops flat results, noise, and results that equal the photo. Weights are
//! this project's own.

use crate::raster::{Image, Plane};
use crate::simd::point::luma_plane;
use crate::simd::table::histogram;

/// Spread of tones that counts as full contrast, in grey steps.
const FULL_CONTRAST: f64 = 64.0;
/// Colourfulness after Hasler and Suesstrunk that counts as full.
const FULL_COLOUR: f64 = 80.0;
/// Roughness (mean difference to the mean of the neighbours, in grey steps) of pure noise.
const ALL_NOISE: f64 = 40.0;
/// Share of black and white pixels up to which a picture is not called clipped: line drawings are white by nature.
const FREE_CLIPPING: f64 = 0.75;
/// Similarity to the photo above which a style has done too little.
const TOO_ALIKE: f64 = 0.9;
/// Light scores below this are of rubbish.
const POOR: f64 = 0.2;
/// Minimum spread of a picture with content, in grey levels.
const FLAT: f64 = 6.0;

/// Minimum share of nearly white pixels at which a picture counts as mostly blank, and how much higher than
/// in the photo it must be.
const PALE: (f64, f64) = (0.55, 0.3);
/// Minimum share of the photo's edges that remain if most of the picture is paper. Drawings have more.
const KEPT: f64 = 0.5;
/// Lowest grey level that counts as nearly white.
const WHITE: usize = 226;
/// Differences of neighbours, in grey steps, that are an edge in a photo, and that show in a picture.
const EDGES: (f64, f64) = (12.0, 6.0);
/// Share of light pixels below which a picture is mostly night, and its mean up to which it is.
const MURKY: (f64, f64) = (0.06, 50.0);
/// Grey step between dark and light.
const MIDDLE: usize = 128;
/// Minimum similarity to the photo at which a style counts as having no effect, if the colours match too.
const SAME: f64 = 0.93;
/// Mean difference of the colours, in grey steps, up to which they are the photo's.
const SAME_COLOUR: f64 = 14.0;

/// The reason to reject a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    /// Hardly any contrast.
    Flat,
    /// Mostly white, with most of the photo lost in it.
    Pale,
    /// Nearly black.
    Murky,
    /// Nearly the photo.
    Unchanged,
    /// Noise, or little of the photo: a score that only rubbish has.
    Poor,
}

impl Fault {
    /// Its name for programs.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::Flat => "flat",
            Self::Pale => "pale",
            Self::Murky => "murky",
            Self::Unchanged => "unchanged",
            Self::Poor => "poor",
        }
    }
}

/// Measurements of a stylised picture without a model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Judgement {
    /// The light score, 0 to 1.
    pub score: f64,
    /// The factor of the score: 1, down to 0.5 for a result that equals the photo.
    pub novelty: f64,
    /// The fault of the picture, if any.
    pub fault: Option<Fault>,
}

/// Rates `result` as a stylised version of `source`. Both have one size, and thumbnails are enough. A picture
/// may be as pale or as dark as its photo.
#[must_use]
pub fn judge(source: &Image, result: &Image) -> Judgement {
    let (before, after) = (luma_plane(source), luma_plane(result));
    let (mean, spread) = mean_and_spread(after.samples());
    if (before.width(), before.height()) != (after.width(), after.height()) || spread < FLAT {
        return Judgement { score: 0.0, novelty: 1.0, fault: Some(Fault::Flat) };
    }
    let shares = shares(&after);
    let (edges, left) = (gradients(&before), gradients(&after));
    let structure = correlation(&edges, &left).max(0.0);
    let contrast = (spread / FULL_CONTRAST).min(1.0);
    let balance = 1.0 - (mean - 127.5).abs() / 127.5;
    let colour = (colourfulness(result) / FULL_COLOUR).min(1.0);
    let calm = 1.0 - (roughness(&after) / ALL_NOISE).min(1.0);
    let sum = 0.25 * structure
        + 0.2 * contrast
        + 0.15 * balance
        + 0.15 * colour
        + 0.15 * entropy(&shares)
        + 0.1 * calm;
    let clipped = shares[..3].iter().chain(&shares[253..]).sum::<f64>();
    let unclipped = 1.0 - ((clipped - FREE_CLIPPING) / (1.0 - FREE_CLIPPING)).max(0.0);
    let alike = similarity(&before, &after);
    let novelty = 1.0 - 0.5 * ((alike - TOO_ALIKE) / (1.0 - TOO_ALIKE)).max(0.0);
    let score = (sum * unclipped * novelty).clamp(0.0, 1.0);
    let was = self::shares(&before);
    let (was_white, is_white) = (above(&was, WHITE), above(&shares, WHITE));
    let (was_light, is_light) = (above(&was, MIDDLE), above(&shares, MIDDLE));
    let fault = if spread < 2.0 * FLAT {
        Some(Fault::Flat)
    } else if is_white > PALE.0.max(was_white + PALE.1) && kept(&edges, &left) < KEPT {
        Some(Fault::Pale)
    } else if mean < MURKY.1 && is_light < MURKY.0.min(was_light) {
        Some(Fault::Murky)
    } else if alike > SAME && colour_difference(source, result) < SAME_COLOUR {
        Some(Fault::Unchanged)
    } else {
        (score < POOR).then_some(Fault::Poor)
    };
    Judgement { score, novelty, fault }
}

/// The light score of `result` as a stylised `source`. 0 is flat or empty.
#[must_use]
pub fn score(source: &Image, result: &Image) -> f64 {
    judge(source, result).score
}

/// Returns the rank from 0 to 1 of a picture for the model's mean score `mean`, 1 to 10.
#[must_use]
pub fn rank(mean: f64, judgement: &Judgement) -> f64 {
    if judgement.fault.is_some() { 0.0 } else { ((mean - 1.0) / 9.0 * judgement.novelty).clamp(0.0, 1.0) }
}

/// Share of the pixels from a grey step on.
fn above(shares: &[f64; 256], step: usize) -> f64 {
    shares[step..].iter().sum()
}

/// Returns the share of the photo's edges that the picture still shows; 1 if the photo has no edges.
fn kept(edges: &[f64], left: &[f64]) -> f64 {
    let at = edges.iter().zip(left).filter(|(edge, _)| **edge > EDGES.0);
    let (seen, all) = at
        .fold((0.0, 0.0), |(seen, all), (_, left)| (seen + f64::from(u8::from(*left > EDGES.1)), all + 1.0));
    if all > 0.0 { seen / all } else { 1.0 }
}

/// Mean difference of the channels, in grey steps.
fn colour_difference(a: &Image, b: &Image) -> f64 {
    let (a, b) = (a.to_rgb(), b.to_rgb());
    let sum: u64 = a.iter().zip(&b).map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
    sum as f64 / a.len().max(1) as f64
}

fn mean_and_spread(samples: &[u8]) -> (f64, f64) {
    let count = samples.len().max(1) as f64;
    let mean = samples.iter().map(|&v| f64::from(v)).sum::<f64>() / count;
    let variance = samples.iter().map(|&v| (f64::from(v) - mean).powi(2)).sum::<f64>() / count;
    (mean, variance.sqrt())
}

/// Shares of the grey steps; they sum to 1.
fn shares(plane: &Plane) -> [f64; 256] {
    let count = plane.samples().len().max(1) as f64;
    histogram(plane.samples()).map(|n| f64::from(n) / count)
}

/// Shannon's entropy as a share of 8 bits.
fn entropy(shares: &[f64; 256]) -> f64 {
    -shares.iter().filter(|&&p| p > 0.0).map(|p| p * p.log2()).sum::<f64>() / 8.0
}

/// Forward differences, the larger of both directions.
fn gradients(plane: &Plane) -> Vec<f64> {
    let (width, height) = (plane.width(), plane.height());
    let mut out = Vec::with_capacity(width * height);
    for y in 0..height {
        let (row, below) = (plane.row(y), plane.row((y + 1).min(height - 1)));
        for x in 0..width {
            let across = row[x].abs_diff(row[(x + 1).min(width - 1)]);
            out.push(f64::from(across.max(row[x].abs_diff(below[x]))));
        }
    }
    out
}

/// Pearson's correlation; 0 if one of them is constant.
fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let count = a.len().max(1) as f64;
    let (mean_a, mean_b) = (a.iter().sum::<f64>() / count, b.iter().sum::<f64>() / count);
    let (mut both, mut only_a, mut only_b) = (0.0, 0.0, 0.0);
    for (a, b) in a.iter().zip(b) {
        both += (a - mean_a) * (b - mean_b);
        only_a += (a - mean_a).powi(2);
        only_b += (b - mean_b).powi(2);
    }
    if only_a * only_b > 0.0 { both / (only_a * only_b).sqrt() } else { 0.0 }
}

/// Hasler and Suesstrunk, "Measuring colourfulness in natural images" (2003).
fn colourfulness(image: &Image) -> f64 {
    let [r, g, b] = image.planes() else { return 0.0 };
    let pixels = r.samples().iter().zip(g.samples()).zip(b.samples());
    let (mut sums, mut squares) = ([0.0; 2], [0.0; 2]);
    for ((&r, &g), &b) in pixels {
        let (r, g, b) = (f64::from(r), f64::from(g), f64::from(b));
        for (i, value) in [r - g, 0.5 * (r + g) - b].into_iter().enumerate() {
            sums[i] += value;
            squares[i] += value * value;
        }
    }
    let count = r.samples().len().max(1) as f64;
    let means = sums.map(|sum| sum / count);
    let variance = squares[0] / count - means[0].powi(2) + squares[1] / count - means[1].powi(2);
    variance.max(0.0).sqrt() + 0.3 * means[0].hypot(means[1])
}

/// Mean difference of a pixel to the mean of its four neighbours, in grey steps.
fn roughness(plane: &Plane) -> f64 {
    let (width, height) = (plane.width(), plane.height());
    let mut sum = 0.0;
    for y in 0..height {
        let (above, row, below) =
            (plane.row(y.saturating_sub(1)), plane.row(y), plane.row((y + 1).min(height - 1)));
        for x in 0..width {
            let around = u16::from(row[x.saturating_sub(1)])
                + u16::from(row[(x + 1).min(width - 1)])
                + u16::from(above[x])
                + u16::from(below[x]);
            sum += (f64::from(around) / 4.0 - f64::from(row[x])).abs();
        }
    }
    sum / (width * height).max(1) as f64
}

/// Mean structural similarity over tiles of 8 x 8 (Wang et al. 2004, with plain windows that do not overlap).
fn similarity(a: &Plane, b: &Plane) -> f64 {
    const TILE: usize = 8;
    let (c1, c2) = ((0.01 * 255.0_f64).powi(2), (0.03 * 255.0_f64).powi(2));
    let (mut sum, mut tiles) = (0.0, 0.0);
    for top in (0..a.height()).step_by(TILE) {
        for left in (0..a.width()).step_by(TILE) {
            let (mut n, mut x, mut y, mut xx, mut yy, mut xy) = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
            for row in top..(top + TILE).min(a.height()) {
                for column in left..(left + TILE).min(a.width()) {
                    let (p, q) = (f64::from(a.at(column, row)), f64::from(b.at(column, row)));
                    n += 1.0;
                    x += p;
                    y += q;
                    xx += p * p;
                    yy += q * q;
                    xy += p * q;
                }
            }
            let (mx, my) = (x / n, y / n);
            let (vx, vy, cov) = (xx / n - mx * mx, yy / n - my * my, xy / n - mx * my);
            sum += (2.0 * mx * my + c1) * (2.0 * cov + c2) / ((mx * mx + my * my + c1) * (vx + vy + c2));
            tiles += 1.0;
        }
    }
    sum / f64::max(tiles, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::decode::{Limits, decode_fit};
    use crate::{Context, catalogue, stylize};

    fn photo() -> Image {
        decode_fit(include_bytes!("../../../tests/photos/raccoon.jpg"), &Limits::default(), 200)
            .unwrap()
            .image
    }

    #[test]
    fn designed_styles_score_well_and_rubbish_badly() {
        let photo = photo();
        let noise = Image::from_luma(Plane::from_fn(photo.width(), photo.height(), |x, y| {
            let mixed = (x as u32).wrapping_mul(0x9e37_79b9) ^ (y as u32).wrapping_mul(0x85eb_ca6b);
            (mixed.wrapping_mul(0xc2b2_ae35) >> 24) as u8
        }));
        let flat = Image::from_luma(Plane::filled(photo.width(), photo.height(), 140));
        let designed: Vec<f64> = catalogue::catalogue()
            .iter()
            .map(|style| score(&photo, &stylize(&photo, style, &mut Context::for_image(&photo)).unwrap()))
            .collect();
        let mut sorted = designed.clone();
        sorted.sort_by(f64::total_cmp);
        let median = sorted[sorted.len() / 2];
        assert!(score(&photo, &flat) < 1e-12);
        assert!(score(&photo, &noise) < median, "noise {} median {median}", score(&photo, &noise));
        assert!(score(&photo, &photo) < median, "itself {} median {median}", score(&photo, &photo));
        assert!(designed.iter().all(|score| (0.0..=1.0).contains(score)));
    }

    #[test]
    fn each_fault_is_named_and_hardly_a_designed_style_has_one() {
        let photo = photo();
        let luma = luma_plane(&photo);
        let mapped = |f: &dyn Fn(u8) -> u8| {
            let picture = Plane::from_fn(luma.width(), luma.height(), |x, y| f(luma.at(x, y)));
            judge(&photo, &Image::from_luma(picture)).fault
        };
        assert_eq!(mapped(&|v| 120 + v / 32), Some(Fault::Flat));
        assert_eq!(mapped(&|v| if v < 20 { 0 } else { 255 }), Some(Fault::Pale));
        assert_eq!(mapped(&|v| if v > 225 { 255 } else { v / 6 }), Some(Fault::Murky));
        assert_eq!(judge(&photo, &photo).fault, Some(Fault::Unchanged));
        assert_eq!(rank(9.0, &judge(&photo, &photo)).to_bits(), 0.0_f64.to_bits());
        let mut faulty = Vec::new();
        for style in catalogue::catalogue() {
            let drawn = stylize(&photo, style, &mut Context::for_image(&photo)).unwrap();
            let judgement = judge(&photo, &drawn);
            match judgement.fault {
                Some(fault) => faulty.push((&style.id, fault)),
                None => assert!(rank(6.0, &judgement) > rank(5.0, &judgement)),
            }
        }
        assert!(faulty.len() * 10 <= catalogue::catalogue().len(), "{faulty:?}");
    }

    #[test]
    fn pictures_of_two_sizes_have_nothing_in_common() {
        assert!(score(&photo(), &Image::from_luma(Plane::filled(3, 3, 9))) < 1e-12);
    }

    #[test]
    fn similarity_is_one_for_the_same_and_falls_with_noise() {
        let luma = luma_plane(&photo());
        assert!((similarity(&luma, &luma) - 1.0).abs() < 1e-9);
        let noisy =
            Plane::from_fn(luma.width(), luma.height(), |x, y| luma.at(x, y) ^ ((x * 7 + y * 13) % 32) as u8);
        assert!(similarity(&luma, &noisy) < 0.95);
    }
}
