//! Spectra of sound: the frequencies in a frame of samples, and their measurements.
//!
//! The transform is a plain radix-2 FFT of one small size. Libraries add planners for every size, or sine
//! tables of half the size of the `films` module.

use crate::simd::fft;

/// Seconds between two frames.
pub(super) const STEP: f32 = 0.01;
/// Minimum duration of a frame in seconds. The number of samples is the next power of two.
const WIDTH: f32 = 0.025;
/// Frequency range in Hz for measuring flatness. It excludes mains hum below and codec hiss above.
const BAND: [f32; 2] = [150.0, 5000.0];
/// How strongly loud parts of a spectrum are pressed down before two are compared.
const PRESSED: f32 = 300.0;
/// Power of a bin below which it is silence.
const NOTHING: f32 = 1e-12;

/// Measurements of a frame.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Frame {
    /// Loudness in dB below full scale, -120 at least: the root of the mean square of the samples.
    pub level: f32,
    /// Increase relative to the previous frame, summed over the frequencies that have become stronger:
    /// spectral flux (S. Dixon, *Onset detection revisited*, `DAFx` 2006, equation 2) of magnitudes pressed
    /// by a logarithm; the mean a bin.
    pub flux: f32,
    /// The mean frequency in Hz, weighted by power: the spectral centroid.
    pub centroid: f32,
    /// The geometric by the arithmetic mean of the power: the spectral flatness, 0 for a tone, about 0.5 for noise.
    pub flatness: f32,
    /// Similarity of the magnitudes to those a tenth of a second earlier, as a cosine, 0 to 1.
    pub steadiness: f32,
}

/// The frames of a sound.
#[derive(Debug, Default)]
pub(super) struct Frames {
    pub all: Vec<Frame>,
    /// Samples of a frame, and from one to the next.
    pub size: usize,
    pub step: usize,
}

impl Frames {
    /// Measures `samples` with full scale 1 at `rate` samples per second. Samples shorter than a frame give
    /// no frame.
    pub(super) fn of(samples: &[f32], rate: f32) -> Self {
        let size = ((rate * WIDTH) as usize).next_power_of_two().max(4);
        let step = ((rate * STEP) as usize).max(1);
        let transform = Transform::new(size);
        let hertz = rate / size as f32;
        let bins = size / 2;
        let band = BAND.map(|edge| ((edge / hertz) as usize).clamp(1, bins));
        // Magnitudes of the last tenth of a second, in a ring.
        let past = (0.1 / STEP) as usize;
        let mut ring = vec![vec![0f32; bins]; past];
        let mut pressed = vec![0f32; bins];
        let mut wave = [vec![0f32; size], vec![0f32; size]];
        let mut all = Vec::with_capacity(samples.len() / step);
        for (i, part) in samples.windows(size).step_by(step).enumerate() {
            let square = part.iter().map(|sample| sample * sample).sum::<f32>() / size as f32;
            transform.windowed(part, &mut wave);
            transform.run(&mut wave);
            let old = &mut ring[i % past];
            let (mut flux, mut power, mut moment) = (0f32, 0f32, 0f32);
            let (mut logs, mut mean, mut alike) = (0f32, 0f32, [0f32; 3]);
            for bin in 1..bins {
                let (real, imaginary) = (wave[0][bin], wave[1][bin]);
                let here = real * real + imaginary * imaginary;
                power += here;
                moment += here * bin as f32;
                let magnitude = here.sqrt();
                let log = (1.0 + PRESSED * magnitude).ln();
                if i > 0 {
                    flux += (log - pressed[bin]).max(0.0);
                }
                pressed[bin] = log;
                if (band[0]..band[1]).contains(&bin) {
                    logs += here.max(NOTHING).ln();
                    mean += here.max(NOTHING);
                    alike[0] += magnitude * old[bin];
                    alike[1] += here;
                    alike[2] += old[bin] * old[bin];
                }
                old[bin] = magnitude;
            }
            let count = (band[1] - band[0]).max(1) as f32;
            all.push(Frame {
                level: 10.0 / std::f32::consts::LN_10 * square.max(1e-12).ln(),
                flux: flux / bins as f32,
                centroid: if power > NOTHING { moment / power * hertz } else { 0.0 },
                flatness: if mean > 0.0 { (logs / count).exp() / (mean / count) } else { 1.0 },
                steadiness: alike[0] / (alike[1] * alike[2]).sqrt().max(NOTHING),
            });
        }
        Self { all, size, step }
    }
}

/// A discrete Fourier transform of one size, in place (Cooley and Tukey 1965), under a Hann window.
struct Transform {
    window: Vec<f32>,
    /// Cosines and sines of a turn in as many parts as the size, of half a turn.
    turns: Vec<[f32; 2]>,
}

impl Transform {
    /// `size`: a power of two, 4 at least.
    fn new(size: usize) -> Self {
        let turns = fft::turns(size);
        // A sine of full scale has a magnitude of 1 in its bin. The second half of the cosines is the first
        // half, negated.
        let cosines = turns.iter().map(|[x, _]| *x).chain(turns.iter().map(|[x, _]| -x));
        let window = cosines.map(|cosine| 2.0 * (1.0 - cosine) / size as f32).collect();
        Self { window, turns }
    }

    /// The samples under the window, in the order that the transform begins with; real and imaginary parts apart.
    fn windowed(&self, samples: &[f32], [real, imaginary]: &mut [Vec<f32>; 2]) {
        for (i, (sample, window)) in samples.iter().zip(&self.window).enumerate() {
            real[fft::reversed(i, self.window.len())] = sample * window;
        }
        imaginary.fill(0.0);
    }

    fn run(&self, [real, imaginary]: &mut [Vec<f32>; 2]) {
        fft::steps(self.window.len(), |a, b, turn| {
            let [cos, sin] = self.turns[turn];
            let x = real[b] * cos - imaginary[b] * sin;
            let y = real[b] * sin + imaginary[b] * cos;
            (real[b], imaginary[b]) = (real[a] - x, imaginary[a] - y);
            real[a] += x;
            imaginary[a] += y;
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f32::consts::TAU;

    #[test]
    fn a_transform_is_the_sum_that_defines_it() {
        let size = 32;
        let transform = Transform::new(size);
        let mut random = oorandom::Rand32::new(5);
        let samples: Vec<f32> = (0..size).map(|_| random.rand_float() - 0.5).collect();
        let mut wave = [vec![0.0; size], vec![0.0; size]];
        transform.windowed(&samples, &mut wave);
        transform.run(&mut wave);
        for (bin, (real, imaginary)) in wave[0].iter().zip(&wave[1]).enumerate() {
            let sum =
                samples.iter().zip(&transform.window).enumerate().fold([0f64; 2], |[x, y], (i, (s, w))| {
                    let angle = std::f64::consts::TAU * (i * bin) as f64 / size as f64;
                    let value = f64::from(s * w);
                    [x + value * angle.cos(), y - value * angle.sin()]
                });
            assert!((f64::from(*real) - sum[0]).abs() < 1e-5, "{bin}");
            assert!((f64::from(*imaginary) - sum[1]).abs() < 1e-5, "{bin}");
        }
    }

    #[test]
    fn a_tone_has_its_frequency_and_noise_is_flat() {
        let rate = 16_000.0;
        let tone: Vec<f32> = (0..8000).map(|i| (TAU * 1000.0 * i as f32 / rate).sin()).collect();
        let Frames { all: frames, size, step } = Frames::of(&tone, rate);
        assert_eq!((size, step), (512, 160));
        assert!((frames[20].centroid - 1000.0).abs() < 2.0, "{:?}", frames[20]);
        assert!((frames[20].level + 3.01).abs() < 0.1, "{:?}", frames[20]);
        assert!(frames[20].flatness < 1e-3 && frames[20].steadiness > 0.99, "{:?}", frames[20]);
        let mut random = oorandom::Rand32::new(5);
        let noise: Vec<f32> = (0..8000).map(|_| random.rand_float() - 0.5).collect();
        let frames = Frames::of(&noise, rate).all;
        let mean = frames.iter().map(|frame| frame.flatness).sum::<f32>() / frames.len() as f32;
        assert!((0.4..0.7).contains(&mean), "{mean}");
    }
}
