//! The file of a filter bank, and the filters of a strength. The format is `crates/style/src/banks/README.md`.

use crate::error::{Error, Result};
use crate::simd::blade::{FRACTION, Filter, SIDE};
use wide::i16x8;

/// First bytes of a file.
const MAGIC: [u8; 4] = *b"BLDE";

/// Format that is read and written.
const VERSION: u16 = 1;

/// Orientations of an edge, over half a turn.
pub const ORIENTATIONS: usize = 16;

/// Weights that a filter stores: those before its centre. It is symmetric about the centre, because turning a
/// photo by half a turn changes no bucket, and its weights add up to 1, which gives the centre.
pub const WEIGHTS: usize = (SIDE * SIDE - 1) / 2;

/// One, as a weight.
const ONE: i32 = 1 << FRACTION;

/// Bytes before the edges.
const HEADER: usize = 12;

/// Below this share of the first level's effect nothing can be seen.
const NOTHING: f32 = 0.01;

/// How features are quantised.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// Rising limits of the gradient, in grey steps for a pixel of the halved luma.
    pub strengths: Vec<f32>,
    /// Rising limits of (s1 - s2) / (s1 + s2), of the gradients along and across, within 0..1.
    pub coherences: Vec<f32>,
}

impl Shape {
    /// Buckets of this shape, at most 256. Their order is (orientation, strength, coherence).
    #[must_use]
    pub fn buckets(&self) -> usize {
        ORIENTATIONS * (self.strengths.len() + 1) * (self.coherences.len() + 1)
    }
}

/// Filters for each bucket at a few strengths of an operator.
#[derive(Debug, Clone, PartialEq)]
pub struct Bank {
    shape: Shape,
    levels: Vec<(f32, Vec<[i16; WEIGHTS]>)>,
}

impl Bank {
    /// Puts a bank together. A level is its strength and the filters of all buckets.
    ///
    /// # Errors
    /// `invalid-bank` when a limit does not rise or a level has another number of filters.
    pub fn new(name: &str, shape: Shape, levels: Vec<(f32, Vec<[i16; WEIGHTS]>)>) -> Result<Self> {
        let invalid = |reason: &str| Error::InvalidBank { name: name.to_owned(), reason: reason.to_owned() };
        let rises = |values: &[f32]| {
            values.iter().all(|value| value.is_finite() && *value > 0.0) && values.is_sorted_by(|a, b| a < b)
        };
        if shape.buckets() > 256 {
            return Err(invalid("has more than 256 buckets"));
        }
        if !rises(&shape.strengths) || !rises(&shape.coherences) || shape.coherences.iter().any(|c| *c >= 1.0)
        {
            return Err(invalid("its limits must be above 0 and rise"));
        }
        let strengths: Vec<f32> = levels.iter().map(|level| level.0).collect();
        if strengths.is_empty() || !rises(&strengths) {
            return Err(invalid("its levels must be above 0 and rise"));
        }
        if levels.iter().any(|(_, filters)| filters.len() != shape.buckets()) {
            return Err(invalid("a level must have one filter per bucket"));
        }
        Ok(Self { shape, levels })
    }

    /// Reads a file.
    ///
    /// # Errors
    /// `invalid-bank`, saying what is wrong.
    pub fn parse(name: &str, bytes: &[u8]) -> Result<Self> {
        let invalid = |reason: String| Error::InvalidBank { name: name.to_owned(), reason };
        let Some((header, rest)) = bytes.split_first_chunk::<HEADER>() else {
            return Err(invalid(format!("is {} bytes long, its header requires {HEADER}", bytes.len())));
        };
        if header[..4] != MAGIC {
            return Err(invalid("does not begin with BLDE".to_owned()));
        }
        let version = u16::from_le_bytes([header[4], header[5]]);
        if version != VERSION {
            return Err(invalid(format!("has version {version}, but this program reads version {VERSION}")));
        }
        let expected = [SIDE as u8, FRACTION as u8, ORIENTATIONS as u8];
        if header[6..9] != expected {
            let found = &header[6..9];
            return Err(invalid(format!(
                "has side, fraction bits, orientations {found:?}, not {expected:?}"
            )));
        }
        let [strengths, coherences, levels] = [header[9], header[10], header[11]].map(usize::from);
        let limits = strengths.saturating_sub(1) + coherences.saturating_sub(1) + levels;
        let buckets = ORIENTATIONS * strengths * coherences;
        let length = HEADER + limits * 4 + levels * buckets * WEIGHTS * 2;
        if strengths == 0 || coherences == 0 || bytes.len() != length {
            return Err(invalid(format!("is {} bytes long, its header requires {length}", bytes.len())));
        }
        let (limits, weights) = rest.split_at(limits * 4);
        let mut limits = limits.as_chunks::<4>().0.iter().map(|bytes| f32::from_le_bytes(*bytes));
        let shape = Shape {
            strengths: limits.by_ref().take(strengths - 1).collect(),
            coherences: limits.by_ref().take(coherences - 1).collect(),
        };
        let mut weights = weights.as_chunks::<2>().0.iter().map(|bytes| i16::from_le_bytes(*bytes));
        let mut filter = || std::array::from_fn(|_| weights.next().unwrap_or(0));
        let levels = limits.map(|at| (at, (0..buckets).map(|_| filter()).collect())).collect();
        Self::new(name, shape, levels)
    }

    /// Writes a file.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = MAGIC.to_vec();
        bytes.extend(VERSION.to_le_bytes());
        bytes.extend([SIDE as u8, FRACTION as u8, ORIENTATIONS as u8]);
        let counts = [self.shape.strengths.len() + 1, self.shape.coherences.len() + 1, self.levels.len()];
        bytes.extend(counts.map(|count| count as u8));
        let levels = self.levels.iter().map(|level| &level.0);
        let limits = self.shape.strengths.iter().chain(&self.shape.coherences).chain(levels);
        bytes.extend(limits.flat_map(|limit| limit.to_le_bytes()));
        let weights = self.levels.iter().flat_map(|level| &level.1).flatten();
        bytes.extend(weights.flat_map(|weight| weight.to_le_bytes()));
        bytes
    }

    /// How features are quantised.
    #[must_use]
    pub fn shape(&self) -> &Shape {
        &self.shape
    }

    /// The largest strength that one pass reaches.
    #[must_use]
    pub fn strongest(&self) -> f32 {
        self.levels.last().map_or(0.0, |level| level.0)
    }

    /// Returns the filters for a strength of at most [`Bank::strongest`], one per bucket, or `None` if the
    /// effect is too weak to be visible. Weights between two levels follow the square of the strength, like
    /// the variance of a smoothing filter.
    #[must_use]
    pub fn filters(&self, strength: f32) -> Option<Vec<Filter>> {
        let above = self.levels.iter().position(|level| level.0 >= strength).unwrap_or(self.levels.len() - 1);
        let (top, upper) = &self.levels[above];
        let below = above.checked_sub(1).and_then(|below| self.levels.get(below));
        let bottom = below.map_or(0.0, |level| level.0);
        let square = |value: f32| value * value;
        let share = (square(strength) - square(bottom)) / (square(*top) - square(bottom));
        if below.is_none() && share < NOTHING {
            return None;
        }
        // In Q12, so that the products fit an i32.
        let share = (share.clamp(0.0, 1.0) * 4096.0).round() as i32;
        let lower = below.map(|level| level.1.as_slice());
        let mixed = |bucket: usize, i: usize| {
            let low = lower.map_or(0, |filters| i32::from(filters[bucket][i]));
            low + (((i32::from(upper[bucket][i]) - low) * share + 2048) >> 12)
        };
        Some((0..upper.len()).map(|bucket| whole(std::array::from_fn(|i| mixed(bucket, i)))).collect())
    }
}

/// A filter of all its rows from the weights before its centre.
fn whole(weights: [i32; WEIGHTS]) -> Filter {
    let center = ONE - 2 * weights.iter().sum::<i32>();
    let at = |i: usize| match i {
        i if i < WEIGHTS => weights[i],
        WEIGHTS => center,
        i => weights[2 * WEIGHTS - i],
    };
    let clipped = |i: usize| at(i).clamp(i32::from(i16::MIN), i32::from(i16::MAX)) as i16;
    std::array::from_fn(|row| {
        i16x8::new(std::array::from_fn(|column| if column < SIDE { clipped(row * SIDE + column) } else { 0 }))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bank() -> Bank {
        let shape = Shape { strengths: vec![4.0], coherences: vec![0.5] };
        let level = |weight: i16| vec![[weight; WEIGHTS]; shape.buckets()];
        Bank::new("test", shape.clone(), vec![(1.0, level(40)), (3.0, level(160))]).unwrap()
    }

    #[test]
    fn what_is_written_reads_back_the_same() {
        assert_eq!(Bank::parse("test", &bank().to_bytes()).unwrap(), bank());
    }

    #[test]
    fn a_damaged_file_is_refused_with_its_name_and_the_reason() {
        let good = bank().to_bytes();
        let with = |i: usize, value: u8| {
            let mut bytes = good.clone();
            bytes[i] = value;
            bytes
        };
        let cases = [
            (vec![], "is 0 bytes long"),
            (with(0, b'X'), "does not begin with BLDE"),
            (with(4, 9), "has version 9, but this program reads version 1"),
            (with(6, 5), "has side, fraction bits, orientations [5, 13, 16]"),
            (with(9, 0), "its header requires"),
            (with(11, 3), "its header requires"),
            (good[..good.len() - 1].to_vec(), "its header requires"),
            (with(HEADER + 3, 0xff), "limits must be above 0 and rise"),
            (with(HEADER + 11, 0x7f), "levels must be above 0 and rise"),
        ];
        for (bytes, reason) in cases {
            let error = Bank::parse("test", &bytes).unwrap_err();
            assert_eq!(error.code(), "invalid-bank");
            let message = error.to_string();
            assert!(message.contains("filter bank test") && message.contains(reason), "{reason}: {message}");
        }
    }

    #[test]
    fn filters_add_up_to_one_and_lie_between_the_levels() {
        let bank = bank();
        assert!(bank.filters(0.05).is_none());
        for (strength, weight) in [(1.0, 40), (3.0, 160), (5f32.sqrt(), 100), (0.5f32.sqrt(), 20), (9.0, 160)]
        {
            for filter in bank.filters(strength).unwrap() {
                let weights: Vec<i32> = filter.iter().flat_map(|row| row.to_array()).map(i32::from).collect();
                assert_eq!(weights.iter().sum::<i32>(), ONE);
                assert_eq!((weights[0], weights[6 * 8 + 6], weights[7]), (weight, weight, 0), "{strength}");
            }
        }
    }
}
