//! Noise of a given size, identical on every platform. It simulates the irregularity of paper, pencils and
//! printing presses.
//!
//! Value noise: a repeating lattice of hashed values with smooth interpolation. Positions are in units of the
//! picture's scale, so that preview and print have the same grain.

/// Lattice points before noise repeats.
const PERIOD: u32 = 256;

/// Returns a pseudo-random number for a position and a seed.
fn hash(x: u32, y: u32, seed: u32) -> u32 {
    // The finalizer of MurmurHash3 over a sum of odd multiples.
    let mut h = x.wrapping_mul(0x9e37_79b1) ^ y.wrapping_mul(0x85eb_ca77) ^ seed.wrapping_mul(0xc2b2_ae3d);
    h = (h ^ (h >> 16)).wrapping_mul(0x7feb_352d);
    h = (h ^ (h >> 15)).wrapping_mul(0x846c_a68b);
    h ^ (h >> 16)
}

/// Returns the hash as a number from 0 to 1.
#[must_use]
pub fn chance(x: u32, y: u32, seed: u32) -> f32 {
    // 24 bits, which an f32 holds exactly.
    (hash(x, y, seed) >> 8) as f32 / 16_777_216.0
}

/// Value noise: 0 to 1 about a mean of 1/2.
#[derive(Debug, Clone)]
pub struct Grain {
    lattice: Vec<f32>,
    /// Lattice points for a pixel, to the right and down.
    steps: (f32, f32),
}

impl Grain {
    /// Noise whose spots are `size` pixels wide and `height` high.
    #[must_use]
    pub fn new(seed: u32, (width, height): (f32, f32)) -> Self {
        let lattice = (0..PERIOD * PERIOD).map(|i| chance(i % PERIOD, i / PERIOD, seed));
        Self { lattice: lattice.collect(), steps: (1.0 / width.max(0.5), 1.0 / height.max(0.5)) }
    }

    /// Fills a row of pixels, from the left border on.
    pub fn row(&self, y: usize, out: &mut [f32]) {
        let (down, between) = place(y, self.steps.1);
        let line = |y: usize| {
            let y = y % PERIOD as usize;
            &self.lattice[y * PERIOD as usize..(y + 1) * PERIOD as usize]
        };
        let (above, below) = (line(down), line(down + 1));
        // Returns one line of the lattice at this height. Pixels are between two of its points.
        let points: Vec<f32> =
            above.iter().zip(below).map(|(above, below)| above + between * (below - above)).collect();
        for (x, out) in out.iter_mut().enumerate() {
            let (right, between) = place(x, self.steps.0);
            let (a, b) = (points[right % PERIOD as usize], points[(right + 1) % PERIOD as usize]);
            *out = a + between * (b - a);
        }
    }
}

/// The lattice point before a pixel, and how far it is beyond it, smoothed.
#[inline]
fn place(pixel: usize, step: f32) -> (usize, f32) {
    let at = (pixel as f32 + 0.5) * step;
    let whole = at as usize;
    let rest = at - whole as f32;
    (whole, rest * rest * (3.0 - 2.0 * rest))
}

/// Noise drawn once on a square that repeats.
#[derive(Debug, Clone)]
pub struct Tile {
    side: usize,
    /// 0 to 255 about a mean of 128.
    samples: Vec<u8>,
}

impl Tile {
    /// Returns noise with spots of about `size` pixels on a square of about `side` pixels: a whole number of
    /// spots.
    #[must_use]
    pub fn new(seed: u32, size: f32, side: f32) -> Self {
        let size = size.max(0.5);
        let side = (side.round() as usize).max(8);
        let spots = ((side as f32 / size).round() as usize).clamp(2, PERIOD as usize);
        let step = spots as f32 / side as f32;
        let lattice: Vec<f32> =
            (0..spots * spots).map(|i| chance((i % spots) as u32, (i / spots) as u32, seed)).collect();
        let places: Vec<(usize, f32)> = (0..side).map(|pixel| place(pixel, step)).collect();
        let mut samples = Vec::with_capacity(side * side);
        let mut line = vec![0.0; spots + 1];
        for &(down, between) in &places {
            let (above, below) = (&lattice[down * spots..], &lattice[(down + 1) % spots * spots..]);
            for (out, (above, below)) in line.iter_mut().zip(above.iter().zip(below)) {
                *out = above + between * (below - above);
            }
            line[spots] = line[0];
            samples.extend(places.iter().map(|&(right, between)| {
                (255.0 * (line[right] + between * (line[right + 1] - line[right])) + 0.5) as u8
            }));
        }
        Self { side, samples }
    }

    /// Fills a row of pixels, `shift` pixels into the square.
    pub fn row(&self, y: usize, shift: usize, out: &mut [u8]) {
        let row = &self.samples[y % self.side * self.side..][..self.side];
        let first = shift % self.side;
        let (start, rest) = out.split_at_mut((self.side - first).min(out.len()));
        start.copy_from_slice(&row[first..first + start.len()]);
        for part in rest.chunks_mut(self.side) {
            part.copy_from_slice(&row[..part.len()]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_has_its_mean_and_its_size_and_is_the_same_at_every_scale() {
        let rows = |scale: f32| {
            let grain = Grain::new(3, (4.0 * scale, 4.0 * scale));
            let side = (200.0 * scale) as usize;
            (0..side)
                .map(|y| {
                    let mut row = vec![0.0; side];
                    grain.row(y, &mut row);
                    row
                })
                .collect::<Vec<_>>()
        };
        let (small, large) = (rows(1.0), rows(2.0));
        let mean = small.iter().flatten().sum::<f32>() / 40_000.0;
        assert!((mean - 0.5).abs() < 0.02, "{mean}");
        for (y, row) in small.iter().enumerate() {
            for (x, &tone) in row.iter().enumerate() {
                let four = large[2 * y][2 * x] + large[2 * y][2 * x + 1];
                let four = four + large[2 * y + 1][2 * x] + large[2 * y + 1][2 * x + 1];
                assert!((four / 4.0 - tone).abs() < 0.06);
            }
        }
    }
}
