//! Runs a network of painters.

use super::onnx::{EPSILON, Graph, Layer};
use crate::error::Result;
use crate::raster::{Image, Plane};
use crate::simd::convolve::{GROUP, MAX_WEIGHT_SUM, Weights};
use wide::{f32x8, i16x8, i32x8};

/// Lanes of a vector of samples.
const LANES: usize = 8;
/// Units of an activation of 1.
const UNIT: f32 = 512.0;
/// Units of a grey step of the image, and the grey level of 0.
const GREY: (i16, i16) = (64, 128);
/// Sums are divided by 2 to this power: of the image, and of activations.
const SHIFTS: (u32, u32) = (14, 12);
/// Rows between two checks for cancellation.
const ROWS: usize = 16;

/// Two painters and the share of the second one, 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Choice {
    /// Index of the first painter.
    pub first: usize,
    /// Index of the second painter.
    pub second: usize,
    /// Share of the second painter.
    pub share: f32,
}

/// Scale and offset of each channel of each layer, as measured in a picture.
pub type Norms = Vec<Vec<(f32, f32)>>;

#[derive(Debug)]
pub(super) struct Network {
    stages: Vec<Stage>,
    painters: usize,
    /// Grey levels of the sigmoid, [`SIGMOID`] entries.
    sigmoid: Vec<u8>,
}

/// A layer with integer weights.
#[derive(Debug)]
struct Stage {
    layer: Layer,
    weights: Weights,
    /// Samples of a pixel of the input.
    channels: usize,
    shift: u32,
    /// Result of the convolution for one unit of its sample.
    units: Vec<f32>,
    /// Whether a later layer reads the result, at most.
    last_use: usize,
}

/// A picture with interleaved channels. The samples are padded to whole vectors.
struct Tensor {
    width: usize,
    height: usize,
    channels: usize,
    samples: Vec<i16>,
}

impl Network {
    pub(super) fn new(Graph { layers, painters }: Graph) -> Self {
        let count = layers.len();
        let uses = |i: usize| {
            let reads = |layer: &Layer| layer.from == Some(i) || layer.added == Some(i);
            layers.iter().rposition(reads).unwrap_or(count)
        };
        let last_uses: Vec<usize> = (0..count).map(uses).collect();
        let stored: Vec<usize> = layers.iter().map(|layer| layer.outputs.next_multiple_of(GROUP)).collect();
        let stages = layers.into_iter().zip(last_uses).map(|(layer, last_use)| {
            let channels = layer.from.map_or(3, |from| stored[from]);
            Stage::new(layer, channels, last_use)
        });
        Self { stages: stages.collect(), painters, sigmoid: sigmoid() }
    }

    pub(super) fn painters(&self) -> usize {
        self.painters
    }

    pub(super) fn run(
        &self,
        image: &Image,
        choice: Choice,
        norms: Option<&Norms>,
        check: &dyn Fn() -> Result<()>,
    ) -> Result<(Image, Norms)> {
        let picture = Tensor::of(image);
        let mut found: Vec<Option<Tensor>> = Vec::with_capacity(self.stages.len());
        let mut used = Norms::with_capacity(self.stages.len());
        for (i, stage) in self.stages.iter().enumerate() {
            let input = stage.layer.from.and_then(|from| found[from].as_ref()).unwrap_or(&picture);
            let (mut result, sums) = stage.convolve(input, check)?;
            let norms = match norms.and_then(|norms| norms.get(i)) {
                Some(norms) => norms.clone(),
                None => stage.norms(&sums, result.width * result.height, choice),
            };
            if i + 1 < self.stages.len() {
                let added = stage.layer.added.and_then(|added| found[added].as_ref());
                result.normalise(&norms, stage.layer.relu, added);
            }
            used.push(norms);
            found.push(Some(result));
            for (before, tensor) in self.stages.iter().zip(&mut found) {
                if before.last_use <= i {
                    *tensor = None;
                }
            }
        }
        let last = found.pop().flatten().unwrap_or(picture);
        let planes = [0, 1, 2].map(|channel| {
            let (scale, offset) =
                used.last().and_then(|norms| norms.get(channel)).copied().unwrap_or_default();
            let mut samples = last.samples.iter().skip(channel).step_by(last.channels);
            let mut sample = || samples.next().copied().unwrap_or_default();
            Plane::from_fn(last.width, last.height, |_, _| self.tone(scale * f32::from(sample()) + offset))
        });
        Ok((Image::from_rgb(planes)?, used))
    }

    /// Grey level of a sum before the sigmoid.
    fn tone(&self, sum: f32) -> u8 {
        let place = (sum + SIGMOID.0) * SIGMOID.1;
        self.sigmoid[(place + 0.5).clamp(0.0, (self.sigmoid.len() - 1) as f32) as usize]
    }
}

/// Range of sums in the table of the sigmoid, and entries per unit.
const SIGMOID: (f32, f32) = (8.0, 256.0);

fn sigmoid() -> Vec<u8> {
    let count = (2.0 * SIGMOID.0 * SIGMOID.1) as i32;
    let tone = |i: i32| {
        let x = f64::from(i) / f64::from(SIGMOID.1) - f64::from(SIGMOID.0);
        (255.0 / (1.0 + exp(-x))).round() as u8
    };
    (0..=count).map(tone).collect()
}

/// e to the power of `x`, with operations that all platforms round identically.
fn exp(x: f64) -> f64 {
    let t = x / 1024.0;
    let mut power = 1.0 + t * (1.0 + t / 2.0 * (1.0 + t / 3.0 * (1.0 + t / 4.0)));
    for _ in 0..10 {
        power *= power;
    }
    power
}

impl Stage {
    fn new(layer: Layer, channels: usize, last_use: usize) -> Self {
        let Layer { side, inputs, outputs, .. } = layer;
        let size = inputs * side * side;
        let kernel = |output: usize| &layer.weights[output * size..(output + 1) * size];
        // Weights are as large as sums of 32 bits allow; rounding adds at most a half to each.
        let factors: Vec<f32> = (0..outputs)
            .map(|output| {
                let sum: f32 = kernel(output).iter().map(|weight| weight.abs()).sum();
                let largest =
                    kernel(output).iter().fold(0.0_f32, |largest, weight| largest.max(weight.abs()));
                ((MAX_WEIGHT_SUM as f32 - size as f32) / sum.max(1e-9)).min(32_767.0 / largest.max(1e-9))
            })
            .collect();
        let weights =
            Weights::new((outputs.next_multiple_of(GROUP), side, side * channels), |output, row, i| {
                let (column, input) = (i / channels, i % channels);
                if output >= outputs || input >= inputs {
                    return 0;
                }
                let weight = kernel(output)[(input * side + row) * side + column];
                (weight * factors[output]).round() as i16
            });
        let (shift, unit) = match layer.from {
            None => (SHIFTS.0, 255.0 * f32::from(GREY.0)),
            Some(_) => (SHIFTS.1, UNIT),
        };
        let units = factors.iter().map(|factor| (1 << shift) as f32 / (factor * unit)).collect();
        Self { layer, weights, channels, shift, units, last_use }
    }

    /// Convolves a picture. Returns the result, and per channel the sums of its samples and of their squares.
    fn convolve(&self, input: &Tensor, check: &dyn Fn() -> Result<()>) -> Result<(Tensor, Vec<(f64, f64)>)> {
        let Layer { side, stride, doubled, .. } = self.layer;
        let times = 1 + usize::from(doubled);
        let (width, height) =
            ((times * input.width).div_ceil(stride), (times * input.height).div_ceil(stride));
        let mut result = Tensor::new(width, height, self.weights.outputs());
        let mut sums = Sums::new(result.channels);
        // The rows of a window, each at its number modulo the height of the window.
        let mut rows = vec![Vec::new(); side];
        let mut next = 0;
        for (y, out) in result.samples.chunks_mut(width * self.weights.outputs()).take(height).enumerate() {
            if y.is_multiple_of(ROWS) {
                check()?;
            }
            let start = y * stride;
            next = next.max(start);
            while next < start + side {
                input.padded_row(next, side / 2, times, &mut rows[next % side]);
                next += 1;
            }
            let window: Vec<&[i16]> = (start..start + side).map(|row| rows[row % side].as_slice()).collect();
            self.weights.row(&window, stride * self.channels, self.shift, out);
            sums.add(out);
        }
        Ok((result, sums.totals))
    }

    /// Scale and offset of each output for samples with these sums.
    fn norms(&self, sums: &[(f64, f64)], pixels: usize, choice: Choice) -> Vec<(f32, f32)> {
        let outputs = self.layer.outputs;
        let mixed = |values: &[f32], output: usize| {
            let [a, b] = [choice.first, choice.second]
                .map(|painter| values.get(painter * outputs + output).copied().unwrap_or_default());
            a + (b - a) * choice.share
        };
        let norm = |output: usize| {
            let (sum, square) = sums[output];
            let mean = sum / pixels as f64;
            let variance = (square / pixels as f64 - mean * mean).max(0.0);
            let unit = f64::from(self.units[output]);
            let scale = f64::from(mixed(&self.layer.scales, output))
                / (variance + f64::from(EPSILON) / (unit * unit)).sqrt();
            (scale as f32, (f64::from(mixed(&self.layer.offsets, output)) - mean * scale) as f32)
        };
        (0..outputs).map(norm).collect()
    }
}

/// Sums per channel, collected row by row.
struct Sums {
    channels: usize,
    totals: Vec<(f64, f64)>,
}

impl Sums {
    fn new(channels: usize) -> Self {
        Self { channels, totals: vec![(0.0, 0.0); channels] }
    }

    fn add(&mut self, row: &[i16]) {
        // Vectors that begin with the same channel.
        let period =
            if self.channels.is_multiple_of(LANES) { self.channels } else { 2 * self.channels } / LANES;
        let mut sums = vec![(f32x8::ZERO, f32x8::ZERO); period];
        let (vectors, rest) = row.as_chunks::<LANES>();
        for vectors in vectors.chunks(period) {
            for ((sum, square), vector) in sums.iter_mut().zip(vectors) {
                let values = floats(vector);
                *sum += values;
                *square += values * values;
            }
        }
        for (i, (sum, square)) in sums.iter().enumerate() {
            for (lane, (sum, square)) in sum.to_array().into_iter().zip(square.to_array()).enumerate() {
                let (total, squares) = &mut self.totals[(LANES * i + lane) % self.channels];
                *total += f64::from(sum);
                *squares += f64::from(square);
            }
        }
        for (i, &value) in rest.iter().enumerate() {
            let (total, squares) = &mut self.totals[(LANES * vectors.len() + i) % self.channels];
            *total += f64::from(value);
            *squares += f64::from(value).powi(2);
        }
    }
}

fn floats(samples: &[i16; LANES]) -> f32x8 {
    f32x8::from_i32x8(i32x8::from_i16x8(i16x8::new(*samples)))
}

impl Tensor {
    fn new(width: usize, height: usize, channels: usize) -> Self {
        let samples = vec![0; (width * height * channels).next_multiple_of(LANES)];
        Self { width, height, channels, samples }
    }

    fn of(image: &Image) -> Self {
        let mut tensor = Self::new(image.width(), image.height(), 3);
        let last = image.planes().len() - 1;
        for channel in 0..3 {
            let plane = image.planes()[channel.min(last)].samples();
            for (sample, &tone) in tensor.samples.iter_mut().skip(channel).step_by(3).zip(plane) {
                *sample = (i16::from(tone) - GREY.1) * GREY.0;
            }
        }
        tensor
    }

    /// Row `y` of the picture enlarged `times`, with `pad` mirrored pixels on all sides. `y` counts from the top of the
    /// padding.
    fn padded_row(&self, y: usize, pad: usize, times: usize, row: &mut Vec<i16>) {
        let channels = self.channels;
        let y = mirrored(y, pad, times * self.height) / times;
        let source = &self.samples[y * self.width * channels..(y + 1) * self.width * channels];
        let width = times * self.width;
        row.resize((width + 2 * pad) * channels + 2, 0);
        if times == 1 {
            row[pad * channels..(pad + width) * channels].copy_from_slice(source);
        } else {
            let inner = row[pad * channels..].chunks_exact_mut(times * channels);
            for (two, pixel) in inner.zip(source.chunks_exact(channels)) {
                for one in two.chunks_exact_mut(channels) {
                    one.copy_from_slice(pixel);
                }
            }
        }
        for x in (0..pad).chain(pad + width..width + 2 * pad) {
            let from = (pad + mirrored(x, pad, width)) * channels;
            row.copy_within(from..from + channels, x * channels);
        }
    }

    /// Scales samples to activations, and adds the activations of another picture.
    fn normalise(&mut self, norms: &[(f32, f32)], relu: bool, added: Option<&Self>) {
        let channels = self.channels;
        let period = if channels.is_multiple_of(LANES) { channels } else { 2 * channels } / LANES;
        let norm = |i: usize| norms.get(i % channels).copied().unwrap_or_default();
        let factors: Vec<(f32x8, f32x8)> = (0..period)
            .map(|i| {
                let lane = |lane: usize| norm(LANES * i + lane);
                (
                    f32x8::new(std::array::from_fn(|i| UNIT * lane(i).0)),
                    f32x8::new(std::array::from_fn(|i| UNIT * lane(i).1)),
                )
            })
            .collect();
        let least = f32x8::splat(if relu { 0.0 } else { f32::from(i16::MIN) });
        let most = f32x8::splat(f32::from(i16::MAX));
        let vectors = self.samples.as_chunks_mut::<LANES>().0;
        let added = added.map(|added| added.samples.as_chunks::<LANES>().0);
        for (i, vectors) in vectors.chunks_mut(period).enumerate() {
            for (k, (vector, (scale, offset))) in vectors.iter_mut().zip(&factors).enumerate() {
                let mut values = floats(vector) * *scale + *offset;
                if let Some(added) = added.and_then(|added| added.get(i * period + k)) {
                    values += floats(added);
                }
                let values = values.fast_max(least).fast_min(most).round_int();
                *vector = i16x8::from_i32x8_saturate(values).to_array();
            }
        }
    }
}

/// Position in a row of `length` pixels, mirrored at its ends, without its ends. `at` counts from the start of the
/// padding.
fn mirrored(at: usize, pad: usize, length: usize) -> usize {
    let inner = pad.abs_diff(at);
    let inner = if inner >= length { (2 * length).saturating_sub(2 + inner) } else { inner };
    inner.min(length - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_are_mirrored_without_the_edge_itself() {
        let row: Vec<usize> = (0..9).map(|at| mirrored(at, 2, 5)).collect();
        assert_eq!(row, [2, 1, 0, 1, 2, 3, 4, 3, 2]);
        assert!((0..12).all(|at| mirrored(at, 4, 2) < 2), "a padding larger than the picture");
    }

    #[test]
    fn the_sigmoid_follows_its_formula() {
        for x in [-7.5_f64, -1.0, 0.0, 0.3, 4.0] {
            assert!((exp(x) / x.exp() - 1.0).abs() < 1e-9, "{x}");
        }
        let table = sigmoid();
        assert_eq!((table[0], table[2048], table[4096]), (0, 128, 255));
    }

    #[test]
    fn sums_are_those_of_plain_loops() {
        for (channels, width) in [(4, 3), (8, 5), (12, 3), (32, 2)] {
            let row: Vec<i16> = (0..channels * width).map(|i| (i * 37 % 101) as i16 - 50).collect();
            let mut sums = Sums::new(channels);
            sums.add(&row);
            sums.add(&row);
            for (channel, found) in sums.totals.iter().enumerate() {
                let values = || row.iter().skip(channel).step_by(channels).map(|&value| f64::from(value));
                let expected = (2.0 * values().sum::<f64>(), 2.0 * values().map(|v| v * v).sum::<f64>());
                assert!((found.0 - expected.0).abs() < 1e-3 && (found.1 - expected.1).abs() < 1e-3);
            }
        }
    }
}
