//! The inverse discrete cosine transform of JPEG, for blocks of 8 x 8 or reduced to sides of 4, 2 and 1. Each
//! reduced sample is the mean of the samples that it covers. Source: ITU-T T.81, A.3.3; libjpeg reduces so,
//! too (its `jidctred.c`), within rounding.

use wide::f32x4;

/// The coefficients of a block, by rows. Horizontal frequency grows from left to right.
pub type Block = [[f32; 8]; 8];

/// Contribution of each coefficient to each sample, for sides of 1, 2, 4 and 8.
static WEIGHTS: [Block; 4] = [weights(1), weights(2), weights(4), weights(8)];

/// Cosines of 0 to 8 sixteenths of pi.
const COSINES: [f64; 9] = [
    1.0,
    0.980_785_280_403_230_4,
    0.923_879_532_511_286_7,
    0.831_469_612_302_545_2,
    std::f64::consts::FRAC_1_SQRT_2,
    0.555_570_233_019_602_2,
    0.382_683_432_365_089_8,
    0.195_090_322_016_128_27,
    0.0,
];

const fn weights(side: usize) -> Block {
    let mut all = [[0.0; 8]; 8];
    let mut i = 0;
    while i < 64 {
        let (k, x) = (i / 8, i % 8);
        let angle = (2 * x + 1) * k % 32;
        let half = if angle > 16 { 32 - angle } else { angle };
        let cosine = if half > 8 { -COSINES[16 - half] } else { COSINES[half] };
        let given = if k == 0 { COSINES[4] } else { cosine } / 2.0;
        all[k][x * side / 8] += (given * side as f64 / 8.0) as f32;
        i += 1;
    }
    all
}

#[inline]
fn load(row: &[f32; 8], half: usize) -> f32x4 {
    f32x4::new(std::array::from_fn(|i| row[4 * half + i]))
}

/// Writes the samples of a block, moved up by 128, to the first `width` bytes of `height` rows that are
/// `stride` apart. Sides are 1, 2, 4 or 8. Only the first `columns` and `rows` of the coefficients are read.
pub fn inverse(
    block: &Block,
    (columns, rows): (usize, usize),
    (width, height): (usize, usize),
    out: &mut [u8],
    stride: usize,
) {
    let [across, down] = [width, height].map(|side| &WEIGHTS[side.trailing_zeros() as usize & 3]);
    for (y, out) in out.chunks_mut(stride).take(height.min(8)).enumerate() {
        let mut line = [0.0; 8];
        for (half, line) in line.chunks_mut(4).take(columns.div_ceil(4)).enumerate() {
            let mut sum = f32x4::ZERO;
            for (row, weights) in block.iter().zip(down).take(rows) {
                sum += load(row, half) * f32x4::splat(weights[y]);
            }
            line.copy_from_slice(sum.as_array());
        }
        for (half, out) in out[..width].chunks_mut(4).enumerate() {
            // A half more, since what follows cuts off.
            let mut sum = f32x4::splat(128.5);
            for (weights, &value) in across.iter().zip(&line).take(columns) {
                sum += load(weights, half) * f32x4::splat(value);
            }
            let sum = sum.fast_max(f32x4::ZERO).fast_min(f32x4::splat(255.0));
            let four = sum.fast_trunc_int().to_array().map(|value| value as u8);
            match <&mut [u8; 4]>::try_from(&mut *out) {
                Ok(out) => *out = four,
                Err(_) => out.copy_from_slice(&four[..out.len()]),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The definition, in f64.
    fn defined(block: &Block) -> [[f64; 8]; 8] {
        let factor = |k: usize| if k == 0 { 0.5f64.sqrt() } else { 1.0 };
        let cosine = |x: usize, k: usize| ((2 * x + 1) as f64 * k as f64 * std::f64::consts::PI / 16.0).cos();
        std::array::from_fn(|y| {
            std::array::from_fn(|x| {
                let all = (0..64).map(|i| {
                    let (v, u) = (i / 8, i % 8);
                    factor(u) * factor(v) * f64::from(block[v][u]) * cosine(x, u) * cosine(y, v)
                });
                all.sum::<f64>() / 4.0 + 128.0
            })
        })
    }

    proptest! {
        #[test]
        fn samples_are_the_means_of_what_is_defined(
            coefficients in proptest::collection::vec((0usize..8, 0usize..8, -900i32..900), 1..20),
            (across, down) in (0u32..4, 0u32..4),
        ) {
            let mut block = Block::default();
            let (mut columns, mut rows) = (1, 1);
            for (u, v, value) in coefficients {
                block[v][u] = value as f32 / 4.0;
                (columns, rows) = (columns.max(u + 1), rows.max(v + 1));
            }
            let whole = defined(&block);
            let (width, height) = (1 << across, 1 << down);
            let mut out = [7; 8 * 11];
            inverse(&block, (columns, rows), (width, height), &mut out, 11);
            let (wide, high) = (8 / width, 8 / height);
            for (y, row) in out.chunks(11).enumerate() {
                for (x, &sample) in row.iter().enumerate() {
                    if x >= width || y >= height {
                        prop_assert_eq!(sample, 7, "beside the block");
                        continue;
                    }
                    let all = (0..wide * high).map(|i| whole[y * high + i / wide][x * wide + i % wide]);
                    let mean = (all.sum::<f64>() / (wide * high) as f64).clamp(0.0, 255.0);
                    prop_assert!((f64::from(sample) - mean).abs() < 0.51, "{sample} for {mean}");
                }
            }
        }
    }
}
