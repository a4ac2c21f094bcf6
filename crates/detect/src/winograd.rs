//! Convolutions of 3 x 3 pixels with a quarter of the products: Winograd's minimal filtering, four pixels by four at a time.
//!
//! A. Lavin and S. Gray, "Fast Algorithms for Convolutional Neural Networks" (2016), F(4 x 4, 3 x 3). A tile
//! of 6 x 6 pixels and the weights are transformed to 36 values, whose products, summed over the channels,
//! are transformed back to 4 x 4 pixels. Results differ only by rounding, about 1e-5 for values around 1.

#[allow(clippy::wildcard_imports, reason = "tract means it as a prelude for operators")]
use tract_onnx::tract_hir::internal::*;
use tract_onnx::tract_hir::ops::cnn::{Conv, PaddingSpec};
use wide::f32x4;

use super::constants::constant;
use super::planes::{self, Work};

/// Pixels along a tile of the result, and along what it is made of.
const STEP: usize = 4;
const SIDE: usize = 6;
/// Values of a transformed tile.
const VALUES: usize = SIDE * SIDE;
/// Numbers in a register.
const LANES: usize = 4;
/// Channels and tiles whose sums are held in registers: eight of these.
const OUTPUTS: usize = 4;
const TILES: usize = 2 * LANES;
/// Number of tiles of a row that are transformed together. With 128 channels, their data has three quarters
/// of a megabyte.
const STRETCH: usize = 40;

/// Minimum number of channels and minimum side in pixels at which this algorithm is faster.
const LEAST_CHANNELS: usize = 16;
const LEAST_SIDE: usize = 80;

/// Whether this is faster: in a browser, with registers of four numbers and without fused multiply-add. On
/// other platforms, tract has kernels for wider registers that do both at once.
const WORTH_IT: bool = cfg!(target_arch = "wasm32");

/// The weights of a convolution, transformed.
#[derive(Debug)]
pub(super) struct Filter {
    /// By value, four of the outputs, input and output.
    weights: Vec<f32>,
    /// Added to each output.
    bias: Vec<f32>,
    inputs: usize,
}

impl Filter {
    /// `weights` are ordered by output, input, row and column; `bias` by output. The number of outputs must
    /// be a multiple of four.
    pub(super) fn new(weights: &[f32], bias: Vec<f32>) -> Self {
        let inputs = weights.len() / 9 / bias.len();
        let mut transformed = vec![0.0; VALUES * inputs * bias.len()];
        for (at, kernel) in weights.as_chunks::<9>().0.iter().enumerate() {
            let (output, input) = (at / inputs, at % inputs);
            // Columns first, as 6 x 3, then rows.
            let mut tall = [[0.0f64; 3]; SIDE];
            for x in 0..3 {
                let column = spread([0, 1, 2].map(|y| f64::from(kernel[3 * y + x])));
                for (row, value) in tall.iter_mut().zip(column) {
                    row[x] = value;
                }
            }
            for (value, of) in tall.into_iter().flat_map(spread).zip(0..) {
                let block = (of * bias.len() / OUTPUTS + output / OUTPUTS) * inputs + input;
                transformed[block * OUTPUTS + output % OUTPUTS] = value as f32;
            }
        }
        Self { weights: transformed, bias, inputs }
    }

    /// For each value and output the sum over the inputs, by tile.
    fn multiply(&self, values: &[f32], sums: &mut [f32], stretch: usize) {
        let weights = self.weights.chunks_exact(self.inputs * OUTPUTS);
        let blocks = self.bias.len() / OUTPUTS;
        for (at, (weights, sums)) in weights.zip(sums.chunks_exact_mut(OUTPUTS * stretch)).enumerate() {
            let values = &values[at / blocks * self.inputs * stretch..][..self.inputs * stretch];
            for (block, values) in values.chunks_exact(self.inputs * TILES).enumerate() {
                let mut held = [[f32x4::ZERO; 2]; OUTPUTS];
                for (weights, values) in
                    weights.as_chunks::<OUTPUTS>().0.iter().zip(values.as_chunks::<TILES>().0)
                {
                    let [a, b, c, d, e, f, g, h] = *values;
                    let pair = [f32x4::new([a, b, c, d]), f32x4::new([e, f, g, h])];
                    for (held, weight) in held.iter_mut().zip(weights) {
                        let weight = f32x4::splat(*weight);
                        held[0] += weight * pair[0];
                        held[1] += weight * pair[1];
                    }
                }
                for (row, held) in sums.chunks_exact_mut(stretch).zip(held) {
                    let row = &mut row[block * TILES..][..TILES];
                    row[..LANES].copy_from_slice(&held[0].to_array());
                    row[LANES..].copy_from_slice(&held[1].to_array());
                }
            }
        }
    }
}

impl Work for Filter {
    const NAME: &'static str = "Winograd";

    fn shape(&self, [_, height, width]: [usize; 3]) -> [usize; 3] {
        [self.bias.len(), height, width]
    }

    /// The convolution of planes with zeros round them. Height and width are multiples of four.
    fn run(&self, input: &[f32], (height, width): (usize, usize)) -> Vec<f32> {
        let across = width / STEP;
        let mut output = vec![0.0; self.bias.len() * height * width];
        let stretch = across.min(STRETCH).next_multiple_of(TILES);
        let mut values = vec![0.0; VALUES * self.inputs * stretch];
        let mut sums = vec![0.0; VALUES * self.bias.len() * stretch];
        let mut transform = Transform::new(stretch);
        for row in 0..height / STEP {
            for first in (0..across).step_by(stretch) {
                for (channel, plane) in input.chunks_exact(height * width).enumerate() {
                    transform.read(plane, (height, width), (row, first));
                    transform.write(&mut values, (channel, self.inputs));
                }
                self.multiply(&values, &mut sums, stretch);
                let tiles = (across - first).min(stretch);
                for (channel, plane) in output.chunks_exact_mut(height * width).enumerate() {
                    let sums = Sums { all: &sums, channel, channels: self.bias.len(), stretch };
                    sums.write(plane, self.bias[channel], (width, row, first), tiles);
                }
            }
        }
        output
    }
}

/// Three weights as six.
fn spread([a, b, c]: [f64; 3]) -> [f64; SIDE] {
    let (even, odd) = (a + c, a / 4.0 + c);
    [a / 4.0, -(even + b) / 6.0, -(even - b) / 6.0, (odd + b / 2.0) / 6.0, (odd - b / 2.0) / 6.0, c]
}

/// Six neighbours as six values.
fn forth([a, b, c, d, e, f]: [f32x4; SIDE]) -> [f32x4; SIDE] {
    let (two, four, five) = (f32x4::splat(2.0), f32x4::splat(4.0), f32x4::splat(5.0));
    let (even, odd) = (e - four * c, d - four * b);
    let (near, far) = (e - c, two * (d - b));
    [four * a - five * c + e, even + odd, even - odd, near + far, near - far, four * b - five * d + f]
}

/// Six values as four pixels.
fn back([a, b, c, d, e, f]: [f32x4; SIDE]) -> [f32x4; STEP] {
    let (two, four, eight) = (f32x4::splat(2.0), f32x4::splat(4.0), f32x4::splat(8.0));
    let (near, far) = ((b + c, b - c), (d + e, d - e));
    [a + near.0 + far.0, near.1 + two * far.1, near.0 + four * far.0, near.1 + eight * far.1 + f]
}

/// The transform of one channel of a row of tiles.
struct Transform {
    /// Six rows of pixels, zeros where the picture ends; then of each column six values.
    rows: [Vec<f32>; SIDE],
    stretch: usize,
}

impl Transform {
    fn new(stretch: usize) -> Self {
        // The last tile is two pixels wider than its step.
        Self { rows: [(); SIDE].map(|()| vec![0.0; (stretch + 1) * STEP]), stretch }
    }

    /// Takes the pixels of tiles from `first` on, and transforms their columns.
    fn read(&mut self, plane: &[f32], (height, width): (usize, usize), (row, first): (usize, usize)) {
        let from = (first * STEP) as isize - 1;
        let left = usize::from(from < 0);
        let source = from.max(0) as usize;
        let count = (width - source).min((self.stretch + 1) * STEP - left);
        for (at, out) in self.rows.iter_mut().enumerate() {
            let y = (row * STEP + at).wrapping_sub(1);
            out.fill(0.0);
            if y < height {
                out[left..left + count].copy_from_slice(&plane[y * width + source..][..count]);
            }
        }
        for x in (0..(self.stretch + 1) * STEP).step_by(LANES) {
            let column = forth(std::array::from_fn(|y| load(&self.rows[y], x)));
            for (row, value) in self.rows.iter_mut().zip(column) {
                row[x..x + LANES].copy_from_slice(&value.to_array());
            }
        }
    }

    /// Transforms the rows: of each value, eight tiles of all inputs side by side.
    fn write(&self, values: &mut [f32], (channel, channels): (usize, usize)) {
        for (row, down) in self.rows.iter().zip(0..) {
            for first in (0..self.stretch).step_by(LANES) {
                let at = |tile: usize| load(row, (first + tile) * STEP);
                let [a, b, c, d] = f32x4::transpose([at(0), at(1), at(2), at(3)]);
                // The last two pixels of a tile are the first two of the next one.
                let [e, f, ..] = f32x4::transpose([at(1), at(2), at(3), at(4)]);
                for (value, across) in forth([a, b, c, d, e, f]).into_iter().zip(0..) {
                    let block = (down * SIDE + across) * self.stretch / TILES + first / TILES;
                    let at = (block * channels + channel) * TILES + first % TILES;
                    values[at..at + LANES].copy_from_slice(&value.to_array());
                }
            }
        }
    }
}

/// Sums of all values, outputs and tiles of a stretch, for one of the outputs.
struct Sums<'a> {
    all: &'a [f32],
    channel: usize,
    channels: usize,
    stretch: usize,
}

impl Sums<'_> {
    /// Transforms tiles back and writes their pixels.
    fn write(&self, plane: &mut [f32], bias: f32, (width, row, first): (usize, usize, usize), tiles: usize) {
        let bias = f32x4::splat(bias);
        for tile in (0..tiles).step_by(LANES) {
            let value = |down: usize, across: usize| {
                let line = (down * SIDE + across) * self.channels + self.channel;
                load(self.all, line * self.stretch + tile)
            };
            let columns: [[f32x4; STEP]; SIDE] =
                std::array::from_fn(|across| back(std::array::from_fn(|down| value(down, across))));
            for y in 0..STEP {
                let pixels = back(columns.map(|column| column[y])).map(|pixel| pixel + bias);
                let from = (row * STEP + y) * width + (first + tile) * STEP;
                let out = &mut plane[from..from + (tiles - tile).min(LANES) * STEP];
                for (out, tile) in out.chunks_exact_mut(STEP).zip(f32x4::transpose(pixels)) {
                    out.copy_from_slice(&tile.to_array());
                }
            }
        }
    }
}

fn load(list: &[f32], at: usize) -> f32x4 {
    let mut lanes = [0.0; LANES];
    lanes.copy_from_slice(&list[at..at + LANES]);
    f32x4::new(lanes)
}

/// A convolution, by [`Filter`] where that is faster.
#[derive(Debug, Clone)]
pub(super) struct Convolution(pub(super) Conv);

impl Expansion for Convolution {
    fn name(&self) -> StaticName {
        self.0.name()
    }

    fn validation(&self) -> Validation {
        self.0.validation()
    }

    fn rules<'r, 'p: 'r, 's: 'r>(
        &'s self,
        s: &mut Solver<'r>,
        inputs: &'p [TensorProxy],
        outputs: &'p [TensorProxy],
    ) -> InferenceResult {
        self.0.rules(s, inputs, outputs)
    }

    fn wire(&self, name: &str, model: &mut TypedModel, inputs: &[OutletId]) -> TractResult<TVec<OutletId>> {
        let filter = if WORTH_IT { self.filter(model, inputs)? } else { None };
        match filter {
            Some(filter) => planes::wire(filter, name, model, inputs[0]),
            None => self.0.wire(name, model, inputs),
        }
    }
}

impl Convolution {
    /// Returns `None` for another kind of convolution, or a small one.
    fn filter(&self, model: &TypedModel, inputs: &[OutletId]) -> TractResult<Option<Filter>> {
        let Conv { padding, strides, dilations, group, kernel_shape, .. } = &self.0;
        let ones = |list: &Option<TVec<usize>>| list.iter().flatten().all(|&one| one == 1);
        let one_round = |list: &[usize]| list == [1, 1];
        let small = kernel_shape.as_deref() == Some(&[3, 3])
            && ones(strides)
            && ones(dilations)
            && group.is_none_or(|groups| groups == 1)
            && matches!(padding, PaddingSpec::Explicit(before, after) if one_round(before) && one_round(after));
        let sides = model.outlet_fact(inputs[0])?.shape.as_concrete().map(<[usize]>::to_vec);
        let (Some([1, channels, height, width]), true, &[_, weights, bias]) =
            (sides.as_deref(), small, inputs)
        else {
            return Ok(None);
        };
        let (weights, bias) = (constant(model, weights)?, constant(model, bias)?);
        let bias: Vec<f32> = bias.try_as_plain_ram()?.as_slice()?.to_vec();
        let fits = [height, width].iter().all(|side| **side >= LEAST_SIDE && side.is_multiple_of(STEP))
            && *channels.min(&bias.len()) >= LEAST_CHANNELS
            && bias.len().is_multiple_of(OUTPUTS);
        Ok(if fits { Some(Filter::new(weights.try_as_plain_ram()?.as_slice()?, bias)) } else { None })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers between -1 and 1, the same each time.
    fn numbers(count: usize, seed: u32) -> Vec<f32> {
        let next = |state: &u32| Some(state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223));
        std::iter::successors(Some(seed), next)
            .take(count)
            .map(|state| (state >> 8) as f32 / (1 << 23) as f32 - 1.0)
            .collect()
    }

    /// Sum by sum, as a convolution is defined.
    fn defined(input: &[f32], weights: &[f32], bias: &[f32], (height, width): (usize, usize)) -> Vec<f64> {
        let inputs = input.len() / height / width;
        let pixel = |channel: usize, y: usize, x: usize| {
            let inside = (1..=height).contains(&y) && (1..=width).contains(&x);
            if inside { f64::from(input[(channel * height + y - 1) * width + x - 1]) } else { 0.0 }
        };
        let mut output = Vec::new();
        for (kernels, bias) in weights.chunks_exact(9 * inputs).zip(bias) {
            for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
                let sum: f64 = kernels
                    .iter()
                    .enumerate()
                    .map(|(i, weight)| f64::from(*weight) * pixel(i / 9, y + i % 9 / 3, x + i % 3))
                    .sum();
                output.push(sum + f64::from(*bias));
            }
        }
        output
    }

    #[test]
    fn it_is_the_convolution_that_it_stands_for() {
        // Less than a stretch of tiles, and more; tiles that fill no eight.
        for (inputs, outputs, height, width) in [(3, 8, 12, 20), (5, 4, 8, 172), (16, 16, 16, 64)] {
            let input = numbers(inputs * height * width, 1);
            let weights = numbers(9 * inputs * outputs, 2);
            let bias = numbers(outputs, 3);
            let output = Filter::new(&weights, bias.clone()).run(&input, (height, width));
            let expected = defined(&input, &weights, &bias, (height, width));
            assert_eq!(output.len(), expected.len());
            let far =
                output.iter().zip(&expected).map(|(a, b)| (f64::from(*a) - b).abs()).fold(0.0, f64::max);
            assert!(far < 1e-4, "{inputs} to {outputs} planes of {height} x {width}: {far}");
        }
    }
}
