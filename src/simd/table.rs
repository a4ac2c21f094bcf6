//! Tables from one luma value to another. A table is analysed once; one with few steps (posterisation, a
//! threshold) runs as compares on lanes, the others as look-ups.

use wide::{i8x16, u8x16};

/// More steps than this and look-ups are faster than compares.
const MAX_STEPS: usize = 12;

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
    Lookup,
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
        } else if steps.len() <= MAX_STEPS {
            Form::Steps(entries[0], steps)
        } else {
            Form::Lookup
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

    /// The table that gives what `next` makes of this one's results.
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        Self::new(self.entries.map(|v| next.entries[usize::from(v)]))
    }

    /// Replaces every sample.
    pub fn apply(&self, samples: &mut [u8]) {
        match &self.form {
            Form::Identity => {}
            Form::Steps(first, steps) => {
                let (chunks, tail) = samples.as_chunks_mut::<16>();
                apply_steps(*first, steps, chunks);
                self.look_up(tail);
            }
            Form::Lookup => self.look_up(samples),
        }
    }

    fn look_up(&self, samples: &mut [u8]) {
        for sample in samples {
            *sample = self.entries[usize::from(*sample)];
        }
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
    // Four tables, so that equal neighbours do not wait for each other.
    let mut counts = [[0u32; 256]; 4];
    let (chunks, tail) = samples.as_chunks::<4>();
    for chunk in chunks {
        for (count, &sample) in counts.iter_mut().zip(chunk) {
            count[usize::from(sample)] += 1;
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
