//! Planes of 16-bit samples in 1/64 grey steps.
//!
//! A blur that is later multiplied must not be rounded to whole grey levels in between. `XDoG` multiplies the
//! difference of two blurs by about twenty. Samples of at most 255 * 64 allow the sum of two in an i16.

use super::fir::LANES;
use crate::raster::Plane;

/// Fraction bits of a fine sample.
pub const FRACTION: u32 = 6;

/// `width * height` samples of 0..=16320, rows packed.
#[derive(Clone, Debug, Default)]
pub struct Fine {
    width: usize,
    height: usize,
    samples: Vec<i16>,
}

impl Fine {
    /// A plane of zeros that reuses the memory of `samples`. Both sides are at least 1.
    #[must_use]
    pub fn reusing(mut samples: Vec<i16>, width: usize, height: usize) -> Self {
        let (width, height) = (width.max(1), height.max(1));
        // Only growth is zeroed: every user of a reused plane writes all of it before reading.
        samples.resize(width * height, 0);
        Self { width, height, samples }
    }

    /// Width in pixels.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Height in pixels.
    #[must_use]
    pub fn height(&self) -> usize {
        self.height
    }

    /// Row `y`, where rows above and below the plane repeat its first and last.
    #[must_use]
    pub fn row_clamped(&self, y: isize) -> &[i16] {
        let y = y.clamp(0, self.height as isize - 1) as usize;
        &self.samples[y * self.width..(y + 1) * self.width]
    }

    /// One row, to be changed.
    pub fn row_mut(&mut self, y: usize) -> &mut [i16] {
        &mut self.samples[y * self.width..(y + 1) * self.width]
    }

    /// Gives the memory back for reuse.
    #[must_use]
    pub fn into_samples(self) -> Vec<i16> {
        self.samples
    }

    /// Converts a plane of whole grey levels. Both have one size.
    pub fn widen(&mut self, plane: &Plane) {
        widen_row(plane.samples(), &mut self.samples);
    }

    /// Rounds to whole grey levels. Both have one size.
    pub fn narrow(&self, plane: &mut Plane) {
        narrow_row(&self.samples, plane.samples_mut());
    }
}

/// Converts whole grey levels to fine samples.
pub fn widen_row(row: &[u8], out: &mut [i16]) {
    for (fine, &sample) in out.iter_mut().zip(row) {
        *fine = i16::from(sample) << FRACTION;
    }
}

/// Rounds fine samples to whole grey levels.
pub fn narrow_row(fine: &[i16], out: &mut [u8]) {
    for (out, &fine) in out.iter_mut().zip(fine) {
        *out = ((fine + (1 << (FRACTION - 1))) >> FRACTION).clamp(0, 255) as u8;
    }
}

/// Copies a row into `padded`. Its first sample is repeated `before` times at the start, and its last sample
/// at the end, up to `length` and a whole number of SIMD lanes.
pub fn pad_row(row: &[i16], before: usize, length: usize, padded: &mut Vec<i16>) {
    padded.clear();
    padded.resize(before, row[0]);
    padded.extend_from_slice(row);
    let length = length.max(padded.len()).next_multiple_of(LANES) + LANES;
    padded.resize(length, row[row.len() - 1]);
}
