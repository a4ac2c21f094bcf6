//! Convolutions with many channels, in 16-bit integers.
//!
//! Rows are interleaved: all channels of a pixel are neighbours. The window of a pixel is therefore one run of
//! samples per row of the kernel. Two neighbouring samples are multiplied by their two weights and added in one
//! operation, for four outputs at once. Sums are 32-bit integers, so all platforms give the same numbers.

use bytemuck::cast;
use wide::{i16x8, i32x4, i32x8};

/// Outputs of one vector of sums.
pub const GROUP: usize = 4;

/// Largest sum of the absolute weights of an output. With 16-bit samples, no sum exceeds 32 bits.
pub const MAX_WEIGHT_SUM: i32 = 65_535;

/// Weights of a convolution, in the order in which [`Weights::row`] reads them.
#[derive(Debug, Clone)]
pub struct Weights {
    /// Rows of the kernel.
    rows: usize,
    /// Pairs of samples in a row of a window.
    pairs: usize,
    /// Vectors of sums: a fourth of the outputs.
    groups: usize,
    /// For each block of groups: rows, pairs, groups.
    values: Vec<i16x8>,
}

/// Sizes of blocks of groups, from the largest. Eight sums fit in the registers of all platforms.
const BLOCKS: [usize; 3] = [4, 2, 1];

/// Start and size of each block of groups.
fn blocks(groups: usize) -> impl Iterator<Item = (usize, usize)> {
    let mut start = 0;
    std::iter::from_fn(move || {
        let size = *BLOCKS.iter().find(|&&size| start + size <= groups)?;
        start += size;
        Some((start - size, size))
    })
}

impl Weights {
    /// Arranges weights. `weight(output, row, i)` is the weight of sample `i` in a row of the window, which has
    /// `length` samples. `outputs` is a multiple of [`GROUP`].
    #[must_use]
    pub fn new(
        (outputs, rows, length): (usize, usize, usize),
        weight: impl Fn(usize, usize, usize) -> i16,
    ) -> Self {
        let (pairs, groups) = (length.div_ceil(2), outputs / GROUP);
        let at = |output: usize, row: usize, i: usize| if i < length { weight(output, row, i) } else { 0 };
        let mut values = Vec::with_capacity(rows * pairs * groups);
        for (start, size) in blocks(groups) {
            for row in 0..rows {
                for pair in 0..pairs {
                    values.extend((start..start + size).map(|group| {
                        let lane = |i: usize| at(GROUP * group + i / 2, row, 2 * pair + i % 2);
                        i16x8::new(std::array::from_fn(lane))
                    }));
                }
            }
        }
        Self { rows, pairs, groups, values }
    }

    /// Number of outputs.
    #[must_use]
    pub fn outputs(&self) -> usize {
        GROUP * self.groups
    }

    /// Convolves one row: `rows` are the rows of the window. The window moves by `step` samples per pixel.
    /// `out` receives the sums divided by 2^`shift`, rounded and limited to 16 bits. Every row needs one sample
    /// after the last window.
    pub fn row(&self, rows: &[&[i16]], step: usize, shift: u32, out: &mut [i16]) {
        let mut rest = self.values.as_slice();
        for (start, size) in blocks(self.groups) {
            let (values, later) = rest.split_at(self.rows * self.pairs * size);
            rest = later;
            match size {
                4 => self.block::<2, 4>(values, rows, step, (shift, GROUP * start), out),
                2 => self.block::<4, 2>(values, rows, step, (shift, GROUP * start), out),
                _ => self.block::<8, 1>(values, rows, step, (shift, GROUP * start), out),
            }
        }
    }

    /// One block of groups, for `P` pixels at once. `first` is its first output.
    fn block<const P: usize, const G: usize>(
        &self,
        values: &[i16x8],
        rows: &[&[i16]],
        step: usize,
        (shift, first): (u32, usize),
        out: &mut [i16],
    ) {
        let outputs = self.outputs();
        let together = out.len() / outputs / P * P;
        let mut pixels = out.chunks_exact_mut(outputs).enumerate();
        for start in (0..together).step_by(P) {
            let sums = self.sums::<P, G>(values, rows, start * step, step);
            for (sums, (_, pixel)) in sums.iter().zip(pixels.by_ref().take(P)) {
                write(sums, shift, &mut pixel[first..first + GROUP * G]);
            }
        }
        for (x, pixel) in pixels {
            let [sums] = self.sums::<1, G>(values, rows, x * step, step);
            write(&sums, shift, &mut pixel[first..first + GROUP * G]);
        }
    }

    /// Sums of `P` neighbouring pixels and `G` groups. The window of the first pixel starts at sample `at`.
    #[inline]
    fn sums<const P: usize, const G: usize>(
        &self,
        values: &[i16x8],
        rows: &[&[i16]],
        at: usize,
        step: usize,
    ) -> [[i32x4; G]; P] {
        let mut sums = [[i32x4::ZERO; G]; P];
        for (row, values) in rows.iter().zip(values.chunks_exact(self.pairs * G)) {
            let values = values.as_chunks::<G>().0;
            let taps: [&[[i16; 2]]; P] =
                std::array::from_fn(|p| &row[at + p * step..].as_chunks().0[..values.len()]);
            for (k, weights) in values.iter().enumerate() {
                for (sums, taps) in sums.iter_mut().zip(&taps) {
                    let pair: i16x8 = cast(i32x4::splat(cast::<[i16; 2], i32>(taps[k])));
                    for (sum, weights) in sums.iter_mut().zip(weights) {
                        *sum += pair.dot(*weights);
                    }
                }
            }
        }
        sums
    }
}

/// Writes sums divided by 2^`shift`.
#[inline]
fn write<const G: usize>(sums: &[i32x4; G], shift: u32, out: &mut [i16]) {
    let half = i32x4::splat((1 << shift) >> 1);
    for (sums, out) in sums.chunks(2).zip(out.chunks_mut(2 * GROUP)) {
        let part = |sum: Option<&i32x4>| sum.map_or(i32x4::ZERO, |sum| (*sum + half) >> shift);
        let both: i32x8 = cast([part(sums.first()), part(sums.get(1))]);
        let lanes = i16x8::from_i32x8_saturate(both).to_array();
        out.copy_from_slice(&lanes[..out.len()]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_of_plain_loops() {
        let mut random = oorandom::Rand32::new(5);
        for (channels, outputs, side, step) in [(3, 4, 9, 1), (8, 8, 3, 1), (4, 12, 3, 2), (2, 32, 5, 2)] {
            for width in [1, 2, 5, 8, 13] {
                let length = (width - 1) * step * channels + side * channels;
                let rows: Vec<Vec<i16>> = (0..side)
                    .map(|_| (0..=length).map(|_| random.rand_range(0..4000) as i16 - 2000).collect())
                    .collect();
                let weights: Vec<i16> = (0..outputs * side * side * channels)
                    .map(|_| random.rand_range(0..300) as i16 - 150)
                    .collect();
                let weight = |o: usize, row: usize, i: usize| weights[(o * side + row) * side * channels + i];
                let arranged = Weights::new((outputs, side, side * channels), weight);
                let mut out = vec![0; width * outputs];
                let borrowed: Vec<&[i16]> = rows.iter().map(Vec::as_slice).collect();
                arranged.row(&borrowed, step * channels, 9, &mut out);
                for x in 0..width {
                    for o in 0..outputs {
                        let mut sum = 0_i64;
                        for (y, row) in rows.iter().enumerate() {
                            for i in 0..side * channels {
                                sum += i64::from(row[x * step * channels + i]) * i64::from(weight(o, y, i));
                            }
                        }
                        let expected = ((sum + 256) >> 9).clamp(-32768, 32767);
                        assert_eq!(i64::from(out[x * outputs + o]), expected, "{channels} {outputs} {x} {o}");
                    }
                }
            }
        }
    }

    #[test]
    fn large_sums_are_limited() {
        let weights = Weights::new((4, 1, 2), |_, _, _| 32_767);
        let mut out = [0; 4];
        weights.row(&[&[32_767, 32_767, 0]], 2, 4, &mut out);
        assert_eq!(out, [32_767; 4]);
    }
}
