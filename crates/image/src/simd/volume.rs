//! Rows of a volume of cells over (x, tone): gathers pixels into cells, blurs, and reads a base for each
//! pixel. The pixel then moves towards its base or away from it.
//!
//! During gathering, cells are pairs of floats, a weight and a weighted tone. After the division they are
//! 16-bit tones with [`FRACTION`] bits. The eight cells around a pixel are then adjacent ([`surround`]), so
//! that an interpolation is three dot products of pairs: along the tone, along y and along x.

use super::lanes::{interleave_high, interleave_low, narrow, widen_low};
use bytemuck::cast;
use wide::{f32x4, i16x8, i32x4, u8x16, u32x4, u64x2};

/// Floats a step.
const LANES: usize = 4;

/// A float of this size has units of 1, so that adding it rounds.
const UNITS: f32 = (3 << 22) as f32;

/// Fraction bits of a cell's tone.
pub const FRACTION: u32 = 7;

/// Fraction bits of the shares of two neighbours.
const SHARE_BITS: u32 = 14;

/// The shares of two neighbours, which sum to exactly 1, for a position between them of 0..=1.
#[must_use]
pub fn shares(position: f32) -> [i16; 2] {
    let second = (position * (1 << SHARE_BITS) as f32).round() as i16;
    [(1 << SHARE_BITS) - second, second]
}

/// Position of a grey step among the cells of a column.
#[derive(Clone, Copy, Debug, Default)]
pub struct Level {
    /// The cell below it.
    pub cell: u32,
    /// The shares of that cell and of the next.
    pub shares: [i16; 2],
    /// Weight and weighted tone that it adds to that cell and to the next.
    pub parts: [f32; 4],
}

/// Adds every `stride`-th pixel of a row to its slot. A slot has four sums: two for the cell and two for the
/// next cell. `columns` has the first cell of each pixel's column.
pub fn gather(row: &[u8], columns: &[u32], stride: usize, levels: &[Level; 256], slots: &mut [[f32; 4]]) {
    let columns = &columns[..row.len()];
    // Indices, because a zip iterator with a step also reads the skipped elements.
    for x in (0..row.len()).step_by(stride) {
        let level = &levels[usize::from(row[x])];
        if let Some(slot) = slots.get_mut((columns[x] + level.cell) as usize) {
            *slot = (f32x4::new(*slot) + f32x4::new(level.parts)).to_array();
        }
    }
}

/// Makes cells of slots, and empties these.
pub fn collect(slots: &mut [[f32; 4]], cells: &mut [f32]) {
    let (cells, _) = cells.as_chunks_mut::<2>();
    let mut next = [0.0; 2];
    for (cell, slot) in cells.iter_mut().zip(slots) {
        *cell = [slot[0] + next[0], slot[1] + next[1]];
        next = [slot[2], slot[3]];
        *slot = [0.0; 4];
    }
}

/// `target[i]` = [1 4 6 4 1] / 16 of `source` at distances of `shift`, with zeros beyond the ends. Both have
/// one length.
pub fn binomial(source: &[f32], shift: usize, target: &mut [f32]) {
    let n = source.len();
    let edge = (2 * shift).min(n);
    let at = |i: usize, k: usize| (i + k).checked_sub(2 * shift).and_then(|i| source.get(i)).unwrap_or(&0.0);
    let one = |i: usize| {
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|k| *at(i, k * shift));
        (a + e) * 0.0625 + (b + d) * 0.25 + c * 0.375
    };
    let inner_end = n.saturating_sub(2 * shift).max(edge);
    let whole = edge + (inner_end - edge) / LANES * LANES;
    for i in (0..edge).chain(whole..n) {
        target[i] = one(i);
    }
    let tap = |k: usize| source[k * shift..][..whole - edge].as_chunks::<LANES>().0;
    if whole == edge {
        return;
    }
    let (out, _) = target[edge..whole].as_chunks_mut::<LANES>();
    let taps = tap(0).iter().zip(tap(1)).zip(tap(2)).zip(tap(3)).zip(tap(4));
    for (out, ((((a, b), c), d), e)) in out.iter_mut().zip(taps) {
        *out = weighted([a, b, c, d, e]).to_array();
    }
}

#[inline]
fn weighted(taps: [&[f32; LANES]; 5]) -> f32x4 {
    let [a, b, c, d, e] = taps.map(|tap| f32x4::new(*tap));
    (a + e) * f32x4::splat(0.0625) + (b + d) * f32x4::splat(0.25) + c * f32x4::splat(0.375)
}

/// Weight of the tone that a cell has without pixels: far below what any pixel about it gives.
const PRIOR: f32 = 1e-5;

/// Tones of a row of cells: the same blur over five rows, then weighted tone / weight. `own` is the tone that a cell
/// without pixels has. The number of cells is a multiple of eight.
pub fn divide(rows: [&[f32]; 5], own: &[f32], tones: &mut [i16]) {
    let count = own.len() / LANES;
    let rows = rows.map(|row| &row.as_chunks::<LANES>().0[..2 * count]);
    let own = &own.as_chunks::<LANES>().0[..count];
    let four = |k: usize| {
        let [a, b] = [2 * k, 2 * k + 1].map(|i| weighted(rows.map(|row| &row[i])));
        // Alternating values of both. The compiler merges these shuffles.
        let (low, high) = (a.unpack_lo(b), a.unpack_hi(b));
        let (weights, sums) = (low.unpack_lo(high), low.unpack_hi(high));
        let sums = sums + f32x4::new(own[k]) * f32x4::splat(PRIOR);
        let tones = sums / (weights + f32x4::splat(PRIOR)) * f32x4::splat((1 << FRACTION) as f32);
        cast::<f32x4, i32x4>(tones + f32x4::splat(UNITS)) - i32x4::splat(UNITS.to_bits() as i32)
    };
    let (groups, _) = tones.as_chunks_mut::<8>();
    for (i, out) in groups.iter_mut().enumerate().take(count / 2) {
        *out = narrow(four(2 * i), four(2 * i + 1)).to_array();
    }
}

/// The eight cells about a place between them: two along the tone, of two rows, of two columns.
pub type Corners = [i16; 8];

/// Puts the cells about every place side by side, out of two neighbouring rows. Rows hold a column and a cell more than
/// there are corners, whose number is a multiple of eight.
pub fn surround([upper, lower]: [&[i16]; 2], column: usize, corners: &mut [Corners]) {
    let count = corners.len();
    let rows = [upper, lower].map(|row| [0, column].map(|shift| &row[shift..=shift + count]));
    let (groups, _) = corners.as_chunks_mut::<8>();
    for (i, group) in groups.iter_mut().enumerate() {
        let pairs = rows.map(|row| {
            row.map(|cells| {
                let [a, b] = [8 * i, 8 * i + 1].map(|from| lanes(cells, from));
                [interleave_low(a, b), interleave_high(a, b)].map(cast::<i16x8, u32x4>)
            })
        });
        for half in 0..2 {
            let [near, far] = [0, 1].map(|side| {
                let (upper, lower) = (pairs[0][side][half], pairs[1][side][half]);
                [upper.unpack_lo(lower), upper.unpack_hi(lower)].map(cast::<u32x4, u64x2>)
            });
            for (k, (near, far)) in near.into_iter().zip(far).enumerate() {
                let both = [near.unpack_lo(far), near.unpack_hi(far)];
                for (i, corners) in both.into_iter().enumerate() {
                    group[4 * half + 2 * k + i] = cast::<u64x2, i16x8>(corners).to_array();
                }
            }
        }
    }
}

#[inline]
fn lanes(row: &[i16], from: usize) -> i16x8 {
    row[from..].first_chunk().map_or(i16x8::ZERO, |lanes| i16x8::new(*lanes))
}

/// Positions of the pixels of a row among the columns of cells.
#[derive(Clone, Copy, Debug)]
pub struct Across<'a> {
    /// The first cell of the column before each pixel.
    pub columns: &'a [u32],
    /// The shares of that column and of the next.
    pub shares: &'a [[i16; 2]],
}

/// Moves every sample of a row away from its base by `amount` (-1..=3.9) times its distance. A negative
/// `amount` moves samples toward the base. The base is between eight corners. `down` has the weights of the upper and the
/// lower row.
pub fn exaggerate(
    row: &mut [u8],
    across: Across<'_>,
    down: [i16; 2],
    (levels, corners): (&[Level; 256], &[Corners]),
    amount: f32,
) {
    let rows = pair(down);
    // A quarter, so that it is a Q15 below 1.
    let quarter = i16x8::splat((amount / 4.0 * 32768.0).round() as i16);
    let along_tone = |sample: u8, column: u32| {
        let level = &levels[usize::from(sample)];
        let Some(corners) = corners.get((column + level.cell) as usize) else { return i32x4::ZERO };
        i16x8::new(*corners).dot(pair(level.shares)) >> SHARE_BITS
    };
    let eight = |samples: &mut [u8; 8], columns: &[u32; 8], shares: [i16x8; 2]| {
        let along_row = |k: usize| {
            let two = |i: usize| {
                narrow(along_tone(samples[i], columns[i]), along_tone(samples[i + 1], columns[i + 1]))
            };
            let [a, b] = [4 * k, 4 * k + 2].map(|i| two(i).dot(rows) >> SHARE_BITS);
            narrow(a, b).dot(shares[k]) >> SHARE_BITS
        };
        let base = narrow(along_row(0), along_row(1));
        let mut bytes = [0; 16];
        bytes[..8].copy_from_slice(samples);
        let tone = widen_low(u8x16::new(bytes)) << FRACTION;
        let part = (tone - base).mul_scale_round(quarter);
        let half = part.saturating_add(part);
        let sum = tone.saturating_add(half).saturating_add(half);
        let rounded = sum.saturating_add(i16x8::splat(1 << (FRACTION - 1))) >> FRACTION;
        let out = u8x16::narrow_i16x8(rounded, rounded).to_array();
        samples.copy_from_slice(&out[..8]);
    };
    let (groups, tail) = row.as_chunks_mut::<8>();
    let (columns, columns_tail) = across.columns.as_chunks::<8>();
    let (shares, _) = across.shares.as_flattened().as_chunks::<16>();
    for ((samples, columns), &shares) in groups.iter_mut().zip(columns).zip(shares) {
        eight(samples, columns, cast::<[i16; 16], [i16x8; 2]>(shares));
    }
    if !tail.is_empty() {
        let (mut samples, mut columns, mut shares) = ([0; 8], [0; 8], [[0; 2]; 8]);
        samples[..tail.len()].copy_from_slice(tail);
        columns[..tail.len()].copy_from_slice(columns_tail);
        shares[..tail.len()].copy_from_slice(&across.shares[groups.len() * 8..][..tail.len()]);
        // Through the same loop: a second copy of it would only make the module larger.
        let across = Across { columns: &columns, shares: &shares };
        exaggerate(&mut samples, across, down, (levels, corners), amount);
        tail.copy_from_slice(&samples[..tail.len()]);
    }
}

/// Two values on all lanes in turn.
#[inline]
fn pair(values: [i16; 2]) -> i16x8 {
    cast(u32x4::splat(cast::<[i16; 2], u32>(values)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn floats(n: usize, most: f32, seed: u64) -> Vec<f32> {
        let mut random = oorandom::Rand32::new(seed);
        (0..n).map(|_| random.rand_float() * most).collect()
    }

    #[test]
    fn lanes_blur_like_scalars_at_every_length_and_shift() {
        for n in 1..=67usize {
            let source = floats(n, 1.0, 6);
            for shift in [1, 2, 3, 8, 31, 70] {
                let mut target = vec![9.0; n];
                binomial(&source, shift, &mut target);
                for (i, &target) in target.iter().enumerate() {
                    let v = |k: isize| {
                        let i = i as isize + k * shift as isize;
                        if (0..n as isize).contains(&i) { source[i as usize] } else { 0.0 }
                    };
                    let exact = (v(-2) + 4.0 * v(-1) + 6.0 * v(0) + 4.0 * v(1) + v(2)) / 16.0;
                    assert!((target - exact).abs() < 1e-6, "{n} {shift} {i}");
                }
            }
        }
    }

    #[test]
    fn a_pixel_adds_to_two_cells_and_no_slot_keeps_it() {
        let mut levels = [Level::default(); 256];
        levels[9] = Level { cell: 2, shares: [0; 2], parts: [0.25, 2.25, 0.75, 6.75] };
        levels[4] = Level { cell: 3, shares: [0; 2], parts: [1.0, 4.0, 0.0, 0.0] };
        let mut slots = [[0.0; 4]; 16];
        gather(&[9, 4, 4, 9, 9], &[0, 0, 8, 8, 8], 2, &levels, &mut slots);
        let mut cells = [9.0; 32];
        collect(&mut slots, &mut cells);
        let mut wanted = [0.0; 32];
        wanted[4..8].copy_from_slice(&[0.25, 2.25, 0.75, 6.75]);
        wanted[20..24].copy_from_slice(&[0.25, 2.25, 0.75, 6.75]);
        wanted[22..24].copy_from_slice(&[1.75, 10.75]);
        assert_eq!(cells.map(f32::to_bits), wanted.map(f32::to_bits));
        assert!(slots.as_flattened().iter().all(|&sum| sum == 0.0));
    }

    #[test]
    fn tones_are_weighted_means_and_a_cell_without_pixels_has_its_own() {
        let count = 24;
        let mut rows = [1, 2, 3, 4, 5].map(|seed| floats(2 * count, 200.0, seed));
        for row in &mut rows {
            row[10..12].fill(0.0);
            for cell in row.as_chunks_mut::<2>().0 {
                cell[1] = cell[1].min(255.0 * cell[0]);
            }
        }
        let own: Vec<f32> = (0..count).map(|i| i as f32 * 10.0).collect();
        let mut tones = vec![0; count];
        divide(rows.each_ref().map(Vec::as_slice), &own, &mut tones);
        for i in 0..count {
            let sum = |k: usize| {
                let at = |row: usize| f64::from(rows[row][2 * i + k]);
                (at(0) + 4.0 * at(1) + 6.0 * at(2) + 4.0 * at(3) + at(4)) / 16.0
            };
            let exact = if i == 5 { 50.0 } else { sum(1) / sum(0) };
            assert!((f64::from(tones[i]) / 128.0 - exact).abs() < 0.01, "{i}: {} {exact}", tones[i]);
        }
    }

    /// Cells, corners and pixels of a row of `width`, at random.
    struct Case {
        rows: [Vec<i16>; 2],
        corners: Vec<Corners>,
        levels: [Level; 256],
        across: (Vec<u32>, Vec<[i16; 2]>),
        samples: Vec<u8>,
    }

    const COLUMN: usize = 9;

    fn case(width: usize, random: &mut oorandom::Rand32) -> Case {
        let columns = width / 3 + 2;
        let count = (columns * COLUMN).next_multiple_of(8);
        let rows = [(); 2].map(|()| {
            (0..=count + COLUMN)
                .map(|_| random.rand_range(0..(255 << FRACTION) + 1) as i16)
                .collect::<Vec<i16>>()
        });
        let mut corners = vec![[0; 8]; count];
        surround(rows.each_ref().map(Vec::as_slice), COLUMN, &mut corners);
        let levels = std::array::from_fn(|grey| Level {
            cell: grey as u32 / 37,
            shares: shares(random.rand_float()),
            parts: [0.0; 4],
        });
        let columns = (0..width).map(|x| (x / 3 * COLUMN) as u32).collect();
        let across = (columns, (0..width).map(|_| shares(random.rand_float())).collect());
        let samples = (0..width).map(|_| random.rand_u32() as u8).collect();
        Case { rows, corners, levels, across, samples }
    }

    #[test]
    fn the_base_lies_between_eight_cells_at_every_width() {
        let mut random = oorandom::Rand32::new(8);
        for width in 1..=67 {
            let Case { rows, corners, levels, across: (columns, along), samples } = case(width, &mut random);
            let across = Across { columns: &columns, shares: &along };
            let down = shares(random.rand_float());
            for amount in [-1.0, -0.3, 0.5, 3.0] {
                let mut out = samples.clone();
                exaggerate(&mut out, across, down, (&levels, &corners), amount);
                for x in 0..width {
                    let level = &levels[usize::from(samples[x])];
                    let mut base = 0.0;
                    for corner in 0..8usize {
                        let (z, row, column) = (corner & 1, (corner >> 1) & 1, corner >> 2);
                        let cell = (across.columns[x] + level.cell) as usize + column * COLUMN + z;
                        let share = [level.shares[z], down[row], across.shares[x][column]];
                        let share: f64 = share.map(|share| f64::from(share) / 16384.0).iter().product();
                        base += share * f64::from(rows[row][cell]) / 128.0;
                    }
                    let tone = f64::from(samples[x]);
                    let exact = (tone + f64::from(amount) * (tone - base)).clamp(0.0, 255.0);
                    // Halves, and steps of 1/128 that are multiplied.
                    assert!(
                        (f64::from(out[x]) - exact).abs() <= 0.6,
                        "{width} {x} {amount}: {} {exact}",
                        out[x]
                    );
                }
            }
        }
    }
}
