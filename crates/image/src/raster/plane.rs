//! One plane of 8-bit samples, rows packed without padding.

use crate::error::{Error, Result};

/// `width * height` samples of 0..=255, row by row from the top left. Both sides are at least 1.
#[derive(Clone, PartialEq, Eq)]
pub struct Plane {
    width: usize,
    height: usize,
    samples: Vec<u8>,
}

impl Plane {
    /// A plane of one value. Sides of 0 are taken as 1, so that no later stage has to ask.
    #[must_use]
    pub fn filled(width: usize, height: usize, value: u8) -> Self {
        let (width, height) = (width.max(1), height.max(1));
        Self { width, height, samples: vec![value; width * height] }
    }

    /// Wraps existing samples.
    ///
    /// # Errors
    /// `buffer-size` when a side is 0 or `samples` does not hold `width * height` bytes.
    pub fn from_samples(width: usize, height: usize, samples: Vec<u8>) -> Result<Self> {
        let expected = width.saturating_mul(height);
        if expected == 0 || samples.len() != expected {
            return Err(Error::BufferSize { width, height, expected, actual: samples.len() });
        }
        Ok(Self { width, height, samples })
    }

    /// Samples a function at every pixel (x, y).
    #[must_use]
    pub fn from_fn(width: usize, height: usize, mut f: impl FnMut(usize, usize) -> u8) -> Self {
        let mut plane = Self::filled(width, height, 0);
        for y in 0..plane.height {
            for (x, sample) in plane.row_mut(y).iter_mut().enumerate() {
                *sample = f(x, y);
            }
        }
        plane
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

    /// All samples.
    #[must_use]
    pub fn samples(&self) -> &[u8] {
        &self.samples
    }

    /// All samples, to be changed.
    pub fn samples_mut(&mut self) -> &mut [u8] {
        &mut self.samples
    }

    /// Returns the samples.
    #[must_use]
    pub fn into_samples(self) -> Vec<u8> {
        self.samples
    }

    /// One row. Panics when `y` is outside.
    #[must_use]
    pub fn row(&self, y: usize) -> &[u8] {
        &self.samples[y * self.width..(y + 1) * self.width]
    }

    /// One row, to be changed. Panics when `y` is outside.
    pub fn row_mut(&mut self, y: usize) -> &mut [u8] {
        &mut self.samples[y * self.width..(y + 1) * self.width]
    }

    /// The sample at (x, y). Panics when outside.
    #[must_use]
    pub fn at(&self, x: usize, y: usize) -> u8 {
        self.samples[y * self.width + x]
    }
}

/// Indices of the samples to the left, right, above and below of a sample, in row order.
pub fn neighbours(at: usize, (width, height): (usize, usize)) -> impl Iterator<Item = usize> {
    let (x, y) = (at % width, at / width);
    let beside = [
        (x > 0).then(|| at - 1),
        (x + 1 < width).then_some(at + 1),
        (y > 0).then(|| at - width),
        (y + 1 < height).then_some(at + width),
    ];
    beside.into_iter().flatten()
}

impl std::fmt::Debug for Plane {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Plane({} x {})", self.width, self.height)
    }
}
