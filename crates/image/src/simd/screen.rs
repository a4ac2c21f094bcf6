//! The choice of a pattern for each tone, on lanes.

use super::mix::load;
use wide::u8x16;

/// Pixels a step.
const STEP: usize = 16;

/// Replaces each sample in `row` by the sample of its level's row in `patterns`: level floor(sample * levels
/// / 256). The rows are as long as `row` or longer, and there are at most 255.
pub fn select(row: &mut [u8], patterns: &[Vec<u8>]) {
    let levels = patterns.len();
    // The smallest sample with floor(sample * levels / 256) >= level.
    let from = |level: usize| (256 * level).div_ceil(levels) as u8;
    let (chunks, tail) = row.as_chunks_mut::<STEP>();
    let whole = chunks.len() * STEP;
    for (i, chunk) in chunks.iter_mut().enumerate() {
        let samples = u8x16::new(*chunk);
        let mut out = load(&patterns[0], i * STEP);
        for (level, pattern) in patterns.iter().enumerate().skip(1) {
            let reached = samples.simd_ge(u8x16::splat(from(level)));
            out = reached.bitselect(load(pattern, i * STEP), out);
        }
        *chunk = out.to_array();
    }
    for (x, sample) in (whole..).zip(tail) {
        *sample = patterns[usize::from(*sample) * levels / 256][x];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_sample_takes_the_pattern_of_its_level() {
        for (levels, n) in (2..=8usize).cycle().zip(1..=67).chain((2..=8).map(|levels| (levels, 256))) {
            let patterns: Vec<Vec<u8>> = (0..levels).map(|level| vec![level as u8; n]).collect();
            let before: Vec<u8> = (0..n).map(|x| (x * 255 / n.max(255) * 7 % 256) as u8 ^ x as u8).collect();
            let mut row = before.clone();
            select(&mut row, &patterns);
            for (&level, &y) in row.iter().zip(&before) {
                assert_eq!(usize::from(level), usize::from(y) * levels / 256);
            }
        }
    }
}
