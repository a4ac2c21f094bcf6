//! Exact percentiles of a plane without a full histogram. A sparse sample estimates the percentile. One SIMD
//! pass over the plane then counts the samples below the tones around it.

use super::table::histogram;
use wide::u8x16;

/// Samples a step.
const STEP: usize = 16;

/// Tones that one pass tries.
const TRIED: usize = 4;

/// Sampling interval of the first estimate, in groups of samples.
const SPARSE: usize = 29;

/// Below this many samples the histogram of all of them costs next to nothing.
const FEW: usize = 1 << 16;

/// The tones of a plane.
#[derive(Debug)]
pub struct Tones<'a> {
    samples: &'a [u8],
    /// How often each tone occurs in the sample.
    counts: [u32; 256],
    whole: bool,
}

impl<'a> Tones<'a> {
    /// Prepares at least one sample.
    #[must_use]
    pub fn new(samples: &'a [u8]) -> Self {
        let whole = samples.len() <= FEW;
        let counts = if whole { histogram(samples) } else { sparse(samples) };
        Self { samples, counts, whole }
    }

    /// The smallest tone that at least `percent` of the samples do not exceed (inverted CDF).
    #[must_use]
    pub fn percentile(&self, percent: f32) -> u8 {
        let total = self.samples.len() as u64;
        let rank = ((f64::from(percent) / 100.0 * total as f64).ceil() as u64).max(1);
        if self.whole {
            return reach(&self.counts, rank);
        }
        let seen: u64 = self.counts.iter().map(|&n| u64::from(n)).sum();
        let guess = reach(&self.counts, (rank * seen).div_ceil(total));
        let first = guess.saturating_sub(2);
        let below = count(self.samples, first);
        // The first one is the smallest only if no sample is below it.
        match below.iter().position(|&n| n >= rank) {
            Some(k) if k > 0 || first == 0 => first.saturating_add(k as u8),
            _ => reach(&histogram(self.samples), rank),
        }
    }
}

/// The first tone up to which there are `rank` or more.
fn reach(counts: &[u32; 256], rank: u64) -> u8 {
    let mut below = 0;
    for (tone, &count) in (0..=255).zip(counts) {
        below += u64::from(count);
        if below >= rank {
            return tone;
        }
    }
    255
}

/// The histogram of some groups of samples.
fn sparse(samples: &[u8]) -> [u32; 256] {
    let mut counts = [0; 256];
    for group in samples.as_chunks::<STEP>().0.iter().step_by(SPARSE) {
        for &sample in group {
            counts[usize::from(sample)] += 1;
        }
    }
    counts
}

/// Counts the samples of at most `first`, and of at most each of the following tones.
fn count(samples: &[u8], first: u8) -> [u64; TRIED] {
    /// Maximum number of steps before a one-byte counter can overflow.
    const FULL: usize = 255;
    let bounds: [u8; TRIED] = std::array::from_fn(|k| first.saturating_add(k as u8));
    let mut totals = [0; TRIED];
    let (groups, tail) = samples.as_chunks::<STEP>();
    let [a, b, c, d] = bounds.map(u8x16::splat);
    for groups in groups.chunks(FULL) {
        let (mut at_a, mut at_b, mut at_c, mut at_d) = (u8x16::ZERO, u8x16::ZERO, u8x16::ZERO, u8x16::ZERO);
        for group in groups {
            let v = u8x16::new(*group);
            // A compare that holds is all ones, which is -1.
            at_a -= v.min(a).simd_eq(v);
            at_b -= v.min(b).simd_eq(v);
            at_c -= v.min(c).simd_eq(v);
            at_d -= v.min(d).simd_eq(v);
        }
        for (total, lanes) in totals.iter_mut().zip([at_a, at_b, at_c, at_d]) {
            *total += lanes.to_array().iter().map(|&n| u64::from(n)).sum::<u64>();
        }
    }
    for (total, bound) in totals.iter_mut().zip(bounds) {
        *total += tail.iter().filter(|&&v| v <= bound).count() as u64;
    }
    totals
}

#[cfg(test)]
mod tests {
    use super::*;

    fn naive(samples: &[u8], percent: f32) -> u8 {
        let mut sorted = samples.to_vec();
        sorted.sort_unstable();
        let rank = (f64::from(percent) / 100.0 * sorted.len() as f64).ceil().max(1.0) as usize;
        sorted[rank - 1]
    }

    #[test]
    fn percentiles_are_those_of_the_inverted_cdf() {
        let mut samples = [20; 100];
        samples[..5].fill(10);
        samples[95..].fill(200);
        let tones = Tones::new(&samples);
        let found = [0.0, 5.0, 5.1, 95.0, 95.1, 100.0].map(|percent| tones.percentile(percent));
        assert_eq!(found, [10, 10, 20, 20, 200, 200]);
    }

    #[test]
    fn large_planes_have_exact_percentiles_also_where_the_sample_misleads() {
        let mut random = oorandom::Rand32::new(7);
        let n = FEW + 1 + 37;
        let noise: Vec<u8> =
            (0..n).map(|_| (random.rand_range(0..200) / 3 + random.rand_range(0..180)) as u8).collect();
        let flat = vec![255; n];
        let ramp: Vec<u8> = (0..n).map(|i| (i * 256 / n) as u8).collect();
        // The sampled values are very different from the rest.
        let hidden: Vec<u8> = (0..n)
            .map(|i| if (i / STEP).is_multiple_of(SPARSE) { 3 } else { (100 + i % 90) as u8 })
            .collect();
        for samples in [noise, flat, ramp, hidden] {
            let tones = Tones::new(&samples);
            for percent in [0.0, 0.5, 5.0, 33.3, 50.0, 95.0, 99.9, 100.0] {
                assert_eq!(tones.percentile(percent), naive(&samples, percent), "{percent}");
            }
        }
    }

    #[test]
    fn counts_are_right_at_every_length() {
        let mut random = oorandom::Rand32::new(8);
        for n in (1..=67).chain([STEP * 255, STEP * 600 + 5]) {
            let samples: Vec<u8> = (0..n).map(|_| random.rand_u32() as u8).collect();
            for first in [0, 100, 252, 254, 255] {
                let expected: Vec<u64> = (0..TRIED)
                    .map(|k| {
                        samples.iter().filter(|&&v| usize::from(v) <= usize::from(first) + k).count() as u64
                    })
                    .collect();
                assert_eq!(count(&samples, first).to_vec(), expected);
            }
        }
    }
}
