//! One axis of a separable resampling: which source samples make an output sample, and with which weights.

use crate::simd::mix::{Pair, Precision};

/// The taps of every output sample along one axis, as whole pairs of fixed-point weights.
pub(super) struct Axis {
    spans: Vec<Span>,
    pairs: Vec<Pair>,
    samples: usize,
    precision: Precision,
    halved_from: Option<usize>,
    doubled: bool,
}

/// Pairs `offset..offset + pairs`, the first of them on the source samples `start` and `start + 1`.
#[derive(Clone, Copy)]
struct Span {
    start: u32,
    offset: u32,
    pairs: u32,
}

impl Axis {
    /// Taps of `count` outputs that share the stretch `[origin, origin + length)` of `samples` inputs
    /// equally. An output that covers a sample or more is an exact area mean, with fractional coverage at
    /// both ends. An output that covers less is interpolated with Catmull-Rom at its centre, on replicated
    /// borders.
    pub(super) fn new(samples: usize, origin: f64, length: f64, count: usize) -> Self {
        let step = length / count as f64;
        let taps = |i: usize, weights: &mut Vec<f64>| {
            let from = origin + i as f64 * step;
            if step >= 1.0 {
                area(samples, from, origin + (i + 1) as f64 * step, weights)
            } else {
                cubic(samples, from + 0.5 * step - 0.5, weights)
            }
        };
        let mut weights = Vec::new();
        // The weights of one axis are alike, but for those at the borders of a Catmull-Rom, which are Coarse anyway.
        taps(0, &mut weights);
        let precision = Precision::for_weight(weights.iter().copied().fold(0.0, f64::max));
        let halved = (step - 2.0).abs() < 1e-12 && origin.fract() == 0.0 && origin + length <= samples as f64;
        let halved_from = halved.then_some(origin as usize);
        // The page's modules would be 7 kB larger for it.
        let doubled = cfg!(not(target_arch = "wasm32"))
            && (step - 0.5).abs() < 1e-12
            && origin == 0.0
            && count == 2 * samples;
        let spans = Vec::with_capacity(count);
        let mut axis = Self { spans, pairs: Vec::new(), samples, precision, halved_from, doubled };
        for i in 0..count {
            let start = taps(i, &mut weights);
            axis.push(start, &weights);
        }
        axis
    }

    /// Number of outputs.
    pub(super) fn count(&self) -> usize {
        self.spans.len()
    }

    /// Index of the first sample if every output is the mean of two separate samples, `None` otherwise.
    pub(super) fn halved_from(&self) -> Option<usize> {
        self.halved_from
    }

    /// Whether all samples become two each, where that is made apart: the page's modules would be 7 kB larger for it.
    pub(super) fn is_doubled(&self) -> bool {
        cfg!(not(target_arch = "wasm32")) && self.doubled
    }

    /// Precision of the weights.
    pub(super) fn precision(&self) -> Precision {
        self.precision
    }

    /// First source sample and weights of output `i`; an index past the end means the last one.
    pub(super) fn taps(&self, i: usize) -> (usize, &[Pair]) {
        let span = self.spans[i.min(self.spans.len() - 1)];
        (span.start as usize, &self.pairs[span.offset as usize..(span.offset + span.pairs) as usize])
    }

    /// The source samples that any output uses: first, and one past the last.
    pub(super) fn extent(&self) -> (usize, usize) {
        let start = self.spans.iter().map(|span| span.start).min().unwrap_or(0) as usize;
        let end = self.spans.iter().map(|span| span.start + 2 * span.pairs).max().unwrap_or(0) as usize;
        (start, end.min(self.samples))
    }

    /// Rounds the weights so that they still sum to exactly 1: flat areas keep their value.
    fn push(&mut self, start: usize, weights: &[f64]) {
        let offset = self.pairs.len() as u32;
        let one = f64::from(1 << self.precision.bits());
        let (mut sum, mut rounded) = (0.0, 0.0);
        let mut fixed = |weight: Option<&f64>| {
            sum += weight.unwrap_or(&0.0);
            let weight = (sum * one).round() - rounded;
            rounded += weight;
            weight as i16
        };
        for pair in weights.chunks(2) {
            self.pairs.push(Pair::new(fixed(pair.first()), fixed(pair.get(1))));
        }
        let pairs = self.pairs.len() as u32 - offset;
        self.spans.push(Span { start: start as u32, offset, pairs });
    }
}

/// Coverage of the samples by `[from, to)`, as parts of 1. Returns the first sample.
fn area(samples: usize, from: f64, to: f64, weights: &mut Vec<f64>) -> usize {
    // Rounding in `from` and `to` must not leave a tap of no weight, least of all one past the last sample.
    let (from, to) = (snap(from), snap(to));
    let start = (from.floor() as usize).min(samples - 1);
    let end = (to.ceil() as usize).clamp(start + 1, samples);
    weights.clear();
    weights.extend((start..end).map(|x| ((x + 1) as f64).min(to) - (x as f64).max(from)));
    let total: f64 = weights.iter().sum();
    for weight in weights.iter_mut() {
        *weight /= total;
    }
    start
}

/// Catmull-Rom weights about `centre` (in samples, 0 in the middle of the first). Returns the first sample.
fn cubic(samples: usize, centre: f64, weights: &mut Vec<f64>) -> usize {
    let floor = centre.floor();
    let at = |k: isize| (floor as isize + k).clamp(0, samples as isize - 1);
    let start = at(-1);
    weights.clear();
    weights.resize((at(2) - start + 1) as usize, 0.0);
    for (k, weight) in (-1..).zip(catmull_rom(centre - floor)) {
        weights[(at(k) - start) as usize] += weight;
    }
    start as usize
}

/// Weights of the samples at -1, 0, 1 and 2 for a position `t` in 0..1 (Catmull and Rom 1974, tension .5).
fn catmull_rom(t: f64) -> [f64; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [-0.5 * t3 + t2 - 0.5 * t, 1.5 * t3 - 2.5 * t2 + 1.0, -1.5 * t3 + 2.0 * t2 + 0.5 * t, 0.5 * t3 - 0.5 * t2]
}

/// Brings a position that is a rounding error away from a whole number onto it.
fn snap(x: f64) -> f64 {
    if (x - x.round()).abs() < 1e-9 { x.round() } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn taps_lie_inside_the_source_and_sum_to_one(
            samples in 1usize..200, count in 1usize..200, from in 0.0f64..1.0, part in 0.001f64..1.0,
        ) {
            let origin = from * samples as f64 * 0.999;
            let length = (samples as f64 - origin) * part;
            let step = length / count as f64;
            let mut weights = Vec::new();
            for i in 0..count {
                let start = if step >= 1.0 {
                    area(samples, origin + i as f64 * step, origin + (i + 1) as f64 * step, &mut weights)
                } else {
                    cubic(samples, origin + (i as f64 + 0.5) * step - 0.5, &mut weights)
                };
                prop_assert!(start + weights.len() <= samples);
                prop_assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-9);
            }
            let axis = Axis::new(samples, origin, length, count);
            prop_assert_eq!(axis.count(), count);
            prop_assert!(axis.extent().1 <= samples);
        }
    }

    #[test]
    fn fractional_ends_count_by_their_coverage() {
        let mut weights = Vec::new();
        assert_eq!(area(5, 0.5, 2.0, &mut weights), 0);
        assert_eq!(weights, [0.5 / 1.5, 1.0 / 1.5]);
        assert_eq!(area(5, 2.0, 3.5, &mut weights), 2);
        assert_eq!(weights, [1.0 / 1.5, 0.5 / 1.5]);
    }

    #[test]
    fn an_enlarged_border_replicates_its_samples() {
        let mut weights = Vec::new();
        assert_eq!(cubic(5, -0.25, &mut weights), 0);
        assert_eq!(weights.len(), 2);
        assert_eq!(cubic(1, 0.3, &mut weights), 0);
        assert!(weights.len() == 1 && (weights[0] - 1.0).abs() < 1e-12);
    }
}
