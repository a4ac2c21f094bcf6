//! Tables from one luma value to another. A table is analysed once, and most run as arithmetic on lanes: a gain, levels
//! at equal distances, a few steps, a curve over a part of the tones. The others are look-ups.

use super::lanes::{interleave_high, interleave_low, narrow, widen_high, widen_low};
use wide::{i8x16, i16x8, u8x16};

/// More steps than this and look-ups are faster than compares.
const MAX_STEPS: usize = 12;

/// More blocks than this and look-ups one by one are faster than in registers.
const MAX_BLOCKS: usize = 8;

/// A 256-entry table in the form in which it runs fastest.
#[derive(Clone, Debug)]
pub struct Table {
    entries: [u8; 256],
    form: Form,
}

#[derive(Clone, Debug)]
enum Form {
    Identity,
    /// The value at 0, then (last input before the step, wrapping difference) of each step.
    Steps(u8, Vec<(u8, u8)>),
    Levels(Levels),
    Affine(Affine),
    /// The commonest value, then (first input, values xored with the commonest) of each block of sixteen inputs
    /// that are not all like it.
    Blocks(u8, Vec<(u8, [u8; 16])>),
    Lookup,
}

/// ((v * count) >> 8) * height + half, from Q7.
#[derive(Clone, Copy, Debug)]
struct Levels {
    count: i16,
    height: i16,
    half: i16,
}

/// (v << shift) * gain + offset * unit, from Q19, and clipped. The offset holds the half that rounds.
#[derive(Clone, Copy, Debug)]
struct Affine {
    shift: u32,
    gain: i16,
    offset: i16,
    unit: i16,
}

impl Table {
    /// Analyses the entries.
    #[must_use]
    pub fn new(entries: [u8; 256]) -> Self {
        let steps: Vec<(u8, u8)> = (0..255u8)
            .map(|v| (v, entries[usize::from(v) + 1].wrapping_sub(entries[usize::from(v)])))
            .filter(|&(_, difference)| difference != 0)
            .collect();
        let form = if entries.iter().enumerate().all(|(v, &out)| v == usize::from(out)) {
            Form::Identity
        } else if let Some(levels) = Levels::of(&entries, steps.len() + 1) {
            Form::Levels(levels)
        } else if steps.len() <= MAX_STEPS {
            Form::Steps(entries[0], steps)
        } else if let Some(affine) = Affine::of(&entries) {
            Form::Affine(affine)
        } else {
            blocks(&entries).unwrap_or(Form::Lookup)
        };
        Self { entries, form }
    }

    /// Tabulates a function of 0..=255, rounding and clipping its values.
    #[must_use]
    pub fn from_fn(f: impl Fn(f32) -> f32) -> Self {
        Self::new(std::array::from_fn(|v| f(v as f32).round().clamp(0.0, 255.0) as u8))
    }

    /// The entries.
    #[must_use]
    pub fn entries(&self) -> &[u8; 256] {
        &self.entries
    }

    /// Returns the composition: this table, then `next`.
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        Self::new(self.entries.map(|v| next.entries[usize::from(v)]))
    }

    /// Replaces every sample.
    pub fn apply(&self, samples: &mut [u8]) {
        if matches!(self.form, Form::Identity) {
            return;
        }
        let (chunks, tail) = samples.as_chunks_mut::<16>();
        match &self.form {
            Form::Identity => {}
            Form::Steps(first, steps) => apply_steps(*first, steps, chunks),
            Form::Levels(levels) => levels.apply(chunks),
            Form::Affine(affine) => affine.apply(chunks),
            Form::Blocks(common, blocks) => apply_blocks(*common, blocks, chunks),
            Form::Lookup => self.look_up(chunks.as_flattened_mut()),
        }
        self.look_up(tail);
    }

    fn look_up(&self, samples: &mut [u8]) {
        for sample in samples {
            *sample = self.entries[usize::from(*sample)];
        }
    }
}

impl Levels {
    /// The form of a table with this number of values, if it applies.
    fn of(entries: &[u8; 256], count: usize) -> Option<Self> {
        if !(2..=64).contains(&count) {
            return None;
        }
        let height = (255.0 * 128.0 / (count - 1) as f32).round() as i16;
        // The height is rounded, too: another half than 64 can make up for it.
        (32..96).map(|half| Self { count: count as i16, height, half }).find(|levels| {
            let one =
                |v: usize| (((v * count) >> 8) as i32 * i32::from(height) + i32::from(levels.half)) >> 7;
            (0..256).all(|v| one(v) == i32::from(entries[v]))
        })
    }

    fn apply(self, chunks: &mut [[u8; 16]]) {
        let [count, height, half] = [self.count, self.height, self.half].map(i16x8::splat);
        let level = |v: i16x8| (((v * count) >> 8u32) * height + half) >> 7u32;
        for chunk in chunks {
            let v = u8x16::new(*chunk);
            *chunk = u8x16::narrow_i16x8(level(widen_low(v)), level(widen_high(v))).to_array();
        }
    }
}

impl Affine {
    const BITS: u32 = 19;

    /// The form of a table that is a straight line, clipped at both ends, if it is one.
    fn of(entries: &[u8; 256]) -> Option<Self> {
        let inner = |v: &usize| (1..255).contains(&entries[*v]);
        let (first, last) = ((0..256).find(inner)?, (0..256).rfind(inner)?);
        let rise = f64::from(entries[last]) - f64::from(entries[first]);
        let run = (last - first) as f64;
        if rise < 8.0 {
            return None;
        }
        let one = f64::from(1u32 << Self::BITS);
        // Rounding hides the slope. If no offset fits all entries, the conflicting entries show its
        // direction.
        let (mut least, mut most) = ((rise - 1.0) / run, (rise + 1.0) / run);
        let shift = (0..=7).find(|&shift| most * one / f64::from(1u32 << shift) < 32767.0)?;
        for _ in 0..16 {
            let gain = (f64::midpoint(least, most) * one / f64::from(1u32 << shift)).round();
            let slope = gain * f64::from(1u32 << shift) / one;
            let ((low, from), (high, to)) = bounds(entries, slope);
            if low < high {
                let affine = Self::new(shift, gain as i16, f64::midpoint(low, high))?;
                return (0..256).all(|v| affine.one(v as i32) == i32::from(entries[v])).then_some(affine);
            }
            if from > to {
                least = slope;
            } else {
                most = slope;
            }
        }
        None
    }

    /// With the finest unit in which the offset fits.
    fn new(shift: u32, gain: i16, offset: f64) -> Option<Self> {
        let offset = (offset + 0.5) * f64::from(1u32 << Self::BITS);
        let unit =
            (0..15).map(|bits| 1i16 << bits).find(|&unit| (offset / f64::from(unit)).abs() < 32767.0)?;
        Some(Self { shift, gain, offset: (offset / f64::from(unit)).round() as i16, unit })
    }

    fn one(self, v: i32) -> i32 {
        let sum = (v << self.shift) * i32::from(self.gain) + i32::from(self.offset) * i32::from(self.unit);
        (sum >> Self::BITS).clamp(0, 255)
    }

    fn apply(self, chunks: &mut [[u8; 16]]) {
        // Pairs of lanes: (v, unit) and (gain, offset).
        let shift = i16x8::splat(1 << self.shift);
        let unit = i16x8::splat(self.unit);
        let factors = interleave_low(i16x8::splat(self.gain), i16x8::splat(self.offset));
        let line = |v: i16x8| {
            let v = v * shift;
            let sum = |pairs: i16x8| pairs.dot(factors) >> Self::BITS;
            narrow(sum(interleave_low(v, unit)), sum(interleave_high(v, unit)))
        };
        for chunk in chunks {
            let v = u8x16::new(*chunk);
            *chunk = u8x16::narrow_i16x8(line(widen_low(v)), line(widen_high(v))).to_array();
        }
    }
}

/// Returns the lowest and the highest offset at which a line of this slope, clipped at both ends, rounds to
/// all entries. With each offset comes the input that limits it.
fn bounds(entries: &[u8; 256], slope: f64) -> ((f64, usize), (f64, usize)) {
    let (mut low, mut high) = ((f64::MIN, 0), (f64::MAX, 0));
    for (v, &entry) in entries.iter().enumerate() {
        let least = f64::from(entry) - 0.5 - slope * v as f64;
        if entry > 0 && least > low.0 {
            low = (least, v);
        }
        if entry < 255 && least + 1.0 < high.0 {
            high = (least + 1.0, v);
        }
    }
    (low, high)
}

/// The blocks that are not all the commonest value, unless they are many.
fn blocks(entries: &[u8; 256]) -> Option<Form> {
    let mut counts = [0u16; 256];
    for &entry in entries {
        counts[usize::from(entry)] += 1;
    }
    let common = (0..=255u8).max_by_key(|&v| counts[usize::from(v)])?;
    let (all, _) = entries.as_chunks::<16>();
    let blocks: Vec<(u8, [u8; 16])> = (0..=255u8)
        .step_by(16)
        .zip(all)
        .filter(|(_, block)| block.iter().any(|&v| v != common))
        .map(|(first, block)| (first, block.map(|v| v ^ common)))
        .collect();
    (blocks.len() <= MAX_BLOCKS).then_some(Form::Blocks(common, blocks))
}

fn apply_blocks(common: u8, blocks: &[(u8, [u8; 16])], chunks: &mut [[u8; 16]]) {
    let mut loaded = [(u8x16::ZERO, u8x16::ZERO); MAX_BLOCKS];
    for (loaded, &(first, block)) in loaded.iter_mut().zip(blocks) {
        *loaded = (u8x16::splat(first), u8x16::new(block));
    }
    for chunk in chunks {
        let v = u8x16::new(*chunk);
        let mut difference = u8x16::ZERO;
        for &(first, block) in &loaded[..blocks.len()] {
            // Inputs of other blocks are beyond the sixteen, which gives 0.
            difference |= block.shuffle_zeroing(v - first);
        }
        *chunk = (difference ^ u8x16::splat(common)).to_array();
    }
}

fn apply_steps(first: u8, steps: &[(u8, u8)], chunks: &mut [[u8; 16]]) {
    // Lanes compare as signed, so both sides are moved by 128.
    let mut bounds = [(i8x16::ZERO, i8x16::ZERO); MAX_STEPS];
    for (bound, &(before, difference)) in bounds.iter_mut().zip(steps) {
        *bound = (i8x16::splat((before ^ 0x80) as i8), i8x16::splat(difference as i8));
    }
    let (bounds, first) = (&bounds[..steps.len()], i8x16::splat(first as i8));
    for chunk in chunks {
        let value = i8x16::new(u8x16::to_array(u8x16::new(*chunk) ^ u8x16::splat(0x80)).map(|v| v as i8));
        let mut sum = first;
        for &(before, difference) in bounds {
            sum += value.simd_gt(before) & difference;
        }
        *chunk = sum.to_array().map(|v| v as u8);
    }
}

/// How often each value occurs.
#[must_use]
pub fn histogram(samples: &[u8]) -> [u32; 256] {
    // Eight tables, so that increments of equal neighbours do not depend on each other, and one load for
    // eight samples.
    let mut counts = [[0u32; 256]; 8];
    let (chunks, tail) = samples.as_chunks::<8>();
    for chunk in chunks {
        let word = u64::from_le_bytes(*chunk);
        for (i, count) in counts.iter_mut().enumerate() {
            count[usize::from((word >> (8 * i)) as u8)] += 1;
        }
    }
    for &sample in tail {
        counts[0][usize::from(sample)] += 1;
    }
    std::array::from_fn(|v| counts.iter().map(|count| count[v]).sum())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_and_look_ups_agree_at_every_width() {
        for levels in [2u32, 3, 7, 12, 13, 40] {
            let table =
                Table::from_fn(|v| ((v * levels as f32 / 256.0).floor() * 255.0) / (levels - 1) as f32);
            for n in 1..=67 {
                let samples: Vec<u8> = (0..n).map(|i| (i * 37 + 11) as u8).collect();
                let mut out = samples.clone();
                table.apply(&mut out);
                let naive: Vec<u8> = samples.iter().map(|&v| table.entries()[usize::from(v)]).collect();
                assert_eq!(out, naive);
            }
        }
        let mut all: Vec<u8> = (0..=255).collect();
        Table::from_fn(|v| if v > 127.0 { 0.0 } else { 200.0 }).apply(&mut all);
        assert_eq!((all[0], all[127], all[128], all[255]), (200, 200, 0, 0));
    }

    #[test]
    fn every_form_gives_the_entries_of_its_table() {
        let mut forms = [0; 6];
        let mut check = |table: &Table| {
            forms[match table.form {
                Form::Identity => 0,
                Form::Steps(..) => 1,
                Form::Levels(_) => 2,
                Form::Affine(_) => 3,
                Form::Blocks(..) => 4,
                Form::Lookup => 5,
            }] += 1;
            let mut all: Vec<u8> = (0..=255).chain(3..19).collect();
            table.apply(&mut all[..271]);
            assert_eq!(&all[..256], table.entries(), "{:?}", table.form);
        };
        check(&Table::from_fn(|v| v));
        for gain in 1..=80u8 {
            check(&Table::from_fn(|v| v * f32::from(gain) * 0.05));
            let (low, high) = (f32::from(gain), 255.0 - f32::from(gain) * 0.5);
            check(&Table::from_fn(|v| (v - low) * 255.0 / (high - low)));
        }
        for levels in 2..=64u8 {
            let levels = f32::from(levels);
            check(&Table::from_fn(|v| (v * levels / 256.0).floor() * 255.0 / (levels - 1.0)));
            check(&Table::from_fn(|v| 255.0 * (1.0 + (0.03 * (v - 2.0 * levels).min(0.0)).tanh())));
            check(&Table::from_fn(|v| (v * levels).sin() * 128.0 + 128.0));
            check(&Table::from_fn(|v| if v < levels { 0.0 } else { 200.0 }));
        }
        assert!(forms.iter().all(|&count| count > 0), "{forms:?}");
        assert!(forms[2] >= 30 && forms[3] >= 150, "{forms:?}");
    }

    #[test]
    fn two_tables_fuse_into_one() {
        let (double, invert) = (Table::from_fn(|v| v * 2.0), Table::from_fn(|v| 255.0 - v));
        let fused = double.then(&invert);
        assert_eq!((fused.entries()[10], fused.entries()[200]), (235, 0));
    }

    #[test]
    fn the_histogram_counts_everything_once() {
        let samples: Vec<u8> = (0..1003).map(|i| (i % 7) as u8).collect();
        let counts = histogram(&samples);
        assert_eq!(counts.iter().sum::<u32>(), 1003);
        assert_eq!(counts[0], 144);
        assert_eq!(counts[7], 0);
    }
}
