//! Reads a model of painters from an ONNX file: a chain of convolutions with conditional instance normalisation.
//!
//! The graph may have these operators, in their usual order: `Resize` (nearest, doubled), `Pad` (reflect), `Conv`,
//! `InstanceNormalization`, `Relu`, `Add` (of an earlier result), and `Sigmoid` at the end. A matrix with one row per
//! painter, multiplied by the weights of the painters, gives scale and offset of a normalisation.
//!
//! The file is untrusted input. Its size, its layers and its cost per pixel have limits.

use super::protobuf::Message;
use crate::error::{Error, Result};
use std::collections::HashMap;

/// Largest file, in bytes.
pub const MAX_BYTES: usize = 4 << 20;
/// Largest number of convolutions.
const MAX_LAYERS: usize = 40;
/// Largest number of channels.
const MAX_CHANNELS: usize = 128;
/// Largest side of a kernel.
const MAX_SIDE: usize = 9;
/// Largest number of painters.
pub const MAX_PAINTERS: usize = 64;
/// Most multiplications per pixel.
const MAX_COST: usize = 40_000;

/// A convolution and its normalisation.
#[derive(Debug)]
pub(super) struct Layer {
    /// Side of the square kernel, odd.
    pub(super) side: usize,
    /// Pixels of the input per pixel of the output.
    pub(super) stride: usize,
    /// Whether the input is doubled first.
    pub(super) doubled: bool,
    /// Index of the layer whose result is the input; `None` for the image.
    pub(super) from: Option<usize>,
    /// Input channels.
    pub(super) inputs: usize,
    /// Output channels.
    pub(super) outputs: usize,
    /// Weights by output, input, row and column.
    pub(super) weights: Vec<f32>,
    /// Scales by painter and output.
    pub(super) scales: Vec<f32>,
    /// Offsets by painter and output.
    pub(super) offsets: Vec<f32>,
    /// Whether negative results become 0.
    pub(super) relu: bool,
    /// Index of a layer whose result is added.
    pub(super) added: Option<usize>,
    /// Whether the normalisation is known yet.
    normalised: bool,
}

/// Layers in their order. The last one has three outputs, which a sigmoid follows.
#[derive(Debug)]
pub(super) struct Graph {
    pub(super) layers: Vec<Layer>,
    pub(super) painters: usize,
}

/// A constant of the file.
struct Constant {
    shape: Vec<usize>,
    values: Vec<f32>,
}

/// Result of a node.
#[derive(Clone, Copy)]
enum Found {
    /// A picture: the layer that made it, and what happens to it before the next convolution.
    Picture { layer: Option<usize>, doubled: bool, pad: usize },
    /// The picture after the sigmoid.
    Last,
    /// The weights of the painters.
    Choice,
}

/// Reads a model.
///
/// # Errors
/// `damaged-painters`, `large-painters`, `slow-painters` or `invalid-painters`, with the reason.
pub(super) fn read(bytes: &[u8]) -> Result<Graph> {
    if bytes.len() > MAX_BYTES {
        let reason = format!("it has {} bytes, the limit is {MAX_BYTES}", bytes.len());
        return Err(Error::LargePainters(reason));
    }
    let model = Message::new(bytes)?;
    let graph =
        Message::new(model.bytes(7).ok_or_else(|| Error::DamagedPainters("it has no graph".into()))?)?;
    let mut reader =
        Reader { constants: HashMap::new(), found: HashMap::new(), layers: Vec::new(), painters: 1 };
    for tensor in graph.messages(5)? {
        reader.constants.insert(tensor.text(8), constant(&tensor)?);
    }
    for input in graph.messages(11)? {
        let name = input.text(1);
        if reader.constants.contains_key(name) {
            continue;
        }
        let pictures = reader.found.values().any(|found| matches!(found, Found::Picture { .. }));
        let found =
            if pictures { Found::Choice } else { Found::Picture { layer: None, doubled: false, pad: 0 } };
        reader.found.insert(name, found);
    }
    for node in graph.messages(1)? {
        reader.node(&node)?;
    }
    let outputs = graph.messages(12)?;
    let output = outputs.first().map(|output| output.text(1)).unwrap_or_default();
    if !matches!(reader.found.get(output), Some(Found::Last)) {
        return Err(invalid("its output is not a picture after a Sigmoid"));
    }
    reader.finish()
}

struct Reader<'a> {
    constants: HashMap<&'a str, Constant>,
    found: HashMap<&'a str, Found>,
    layers: Vec<Layer>,
    painters: usize,
}

impl<'a> Reader<'a> {
    #[allow(clippy::too_many_lines, reason = "one arm for each operator")]
    fn node(&mut self, node: &Message<'a>) -> Result<()> {
        let operator = node.text(4);
        let inputs = node.texts(1);
        let output = node.texts(2).first().copied().unwrap_or_default();
        let input = |i: usize| inputs.get(i).copied().unwrap_or_default();
        let attributes = node.messages(5)?;
        let attribute = |name: &str| attributes.iter().find(|attribute| attribute.text(1) == name);
        let found = match operator {
            "Constant" => {
                let tensor = attribute("value").and_then(|value| value.bytes(5));
                let tensor = Message::new(tensor.ok_or_else(|| invalid("a Constant has no tensor"))?)?;
                self.constants.insert(output, constant(&tensor)?);
                return Ok(());
            }
            "Cast" | "Identity" => {
                if let Some(constant) = self.constants.remove(input(0)) {
                    self.constants.insert(output, constant);
                    return Ok(());
                }
                *self.get(input(0), operator)?
            }
            // Scale or offset: the constant is used by the normalisation.
            "MatMul" => {
                let matrix = self.constants.remove(input(1));
                let (Found::Choice, Some(matrix)) = (self.get(input(0), operator)?, matrix) else {
                    return Err(invalid("a MatMul does not multiply the weights of painters by a constant"));
                };
                self.constants.insert(output, matrix);
                return Ok(());
            }
            "Resize" | "Upsample" => {
                let (layer, doubled, pad) = self.picture(input(0), operator)?;
                let nearest = attribute("mode").is_none_or(|mode| mode.bytes(4) == Some(b"nearest"));
                let scales = inputs
                    .iter()
                    .skip(1)
                    .find_map(|name| self.constants.get(name).filter(|scales| scales.values.len() == 4));
                if doubled || pad > 0 || !nearest || scales.is_none_or(|it| it.values != [1.0, 1.0, 2.0, 2.0])
                {
                    return Err(invalid("a Resize does not double with nearest neighbours"));
                }
                Found::Picture { layer, doubled: true, pad }
            }
            "Pad" => {
                let (layer, doubled, before) = self.picture(input(0), operator)?;
                let reflects = attribute("mode").and_then(|mode| mode.bytes(4)) == Some(b"reflect");
                let pad = self.constants.get(input(1)).map(|pads| pads.values.as_slice());
                let Some(&[0.0, 0.0, pad, left, 0.0, 0.0, below, right]) = pad else {
                    return Err(invalid("a Pad has no constant sizes"));
                };
                if !reflects
                    || before > 0
                    || [left, below, right].iter().any(|&side| side as i64 != pad as i64)
                    || !(0.0..=9.0).contains(&pad)
                {
                    return Err(invalid("a Pad does not reflect, or not equally on all sides"));
                }
                Found::Picture { layer, doubled, pad: pad as usize }
            }
            "Conv" => {
                let numbers = |name: &str, default: u64| -> Result<u64> {
                    let list = attribute(name).map(|it| it.numbers(8)).transpose()?.unwrap_or_default();
                    let first = list.first().copied().unwrap_or(default);
                    let same = list.iter().all(|&number| number == first);
                    if same { Ok(first) } else { Err(invalid(format!("a Conv has unequal {name}"))) }
                };
                let (stride, pads, dilation) =
                    (numbers("strides", 1)?, numbers("pads", 0)?, numbers("dilations", 1)?);
                let group = attribute("group").and_then(|group| group.number(3)).unwrap_or(1);
                if pads != 0 || dilation != 1 || group != 1 || !(1..=2).contains(&stride) {
                    return Err(invalid("a Conv has zero padding, dilation, groups, or a stride above 2"));
                }
                let picture = self.picture(input(0), operator)?;
                let weights = self.constants.remove(input(1));
                let weights = weights.ok_or_else(|| invalid("a Conv has no constant weights"))?;
                self.convolution(picture, weights, stride as usize)?
            }
            "InstanceNormalization" => {
                let (layer, ..) = self.picture(input(0), operator)?;
                let epsilon = attribute("epsilon").and_then(|epsilon| epsilon.bytes(2));
                let epsilon =
                    epsilon.and_then(|bytes| bytes.try_into().ok()).map_or(1e-5, f32::from_le_bytes);
                let constants = [1, 2].map(|i| self.constants.remove(input(i)));
                let [Some(scales), Some(offsets)] = constants else {
                    return Err(invalid("an InstanceNormalization has no constant scale or offset"));
                };
                if (epsilon - EPSILON).abs() > EPSILON {
                    return Err(invalid(format!("an InstanceNormalization has the epsilon {epsilon}")));
                }
                self.normalisation(layer, scales, offsets)?;
                Found::Picture { layer, doubled: false, pad: 0 }
            }
            "Relu" => {
                let last = self.last(input(0), operator)?;
                self.layers[last].relu = true;
                Found::Picture { layer: Some(last), doubled: false, pad: 0 }
            }
            "Add" => {
                let [a, b] = [self.picture(input(0), operator)?, self.picture(input(1), operator)?];
                let newest = self.layers.len().checked_sub(1);
                let (last, other) = if a.0 == newest { (input(0), b) } else { (input(1), a) };
                let last = self.last(last, operator)?;
                let (Some(other), false, 0) = other else {
                    return Err(invalid("an Add does not add an earlier result"));
                };
                if other >= last || self.layers[other].outputs != self.layers[last].outputs {
                    return Err(invalid("an Add joins results of different sizes"));
                }
                self.layers[last].added = Some(other);
                Found::Picture { layer: Some(last), doubled: false, pad: 0 }
            }
            "Sigmoid" => {
                self.last(input(0), operator)?;
                Found::Last
            }
            other => return Err(invalid(format!("it has the operator {other}, which painters do not have"))),
        };
        self.found.insert(output, found);
        Ok(())
    }

    fn get(&self, name: &str, operator: &str) -> Result<&Found> {
        self.found.get(name).ok_or_else(|| invalid(format!("an input of {operator} is unknown")))
    }

    /// A picture: its layer, whether it is doubled, and its padding.
    fn picture(&self, name: &str, operator: &str) -> Result<(Option<usize>, bool, usize)> {
        match *self.get(name, operator)? {
            Found::Picture { layer, doubled, pad } => Ok((layer, doubled, pad)),
            _ => Err(invalid(format!("an input of {operator} is not a picture"))),
        }
    }

    /// The newest layer, if it is the input, normalised, and neither limited nor added to.
    fn last(&self, name: &str, operator: &str) -> Result<usize> {
        let (layer, doubled, pad) = self.picture(name, operator)?;
        let newest = self.layers.len().checked_sub(1);
        let plain = self.layers.last().is_some_and(|it| it.normalised && !it.relu && it.added.is_none());
        match layer {
            Some(layer) if layer == newest.unwrap_or(0) && plain && !doubled && pad == 0 => Ok(layer),
            _ => Err(invalid(format!("a {operator} does not follow an InstanceNormalization"))),
        }
    }

    fn convolution(
        &mut self,
        (from, doubled, pad): (Option<usize>, bool, usize),
        Constant { shape, values }: Constant,
        stride: usize,
    ) -> Result<Found> {
        let &[outputs, inputs, side, across] = shape.as_slice() else {
            return Err(invalid("the weights of a Conv do not have four dimensions"));
        };
        let expected = match from {
            Some(layer) if !self.layers[layer].normalised => {
                return Err(invalid("a Conv has no InstanceNormalization"));
            }
            Some(layer) => self.layers[layer].outputs,
            None => 3,
        };
        if inputs != expected
            || side != across
            || side.is_multiple_of(2)
            || side > MAX_SIDE
            || pad != side / 2
        {
            return Err(invalid(format!("a Conv has weights of {shape:?} and a padding of {pad}")));
        }
        if !(1..=MAX_CHANNELS).contains(&outputs) || self.layers.len() >= MAX_LAYERS {
            let reason = format!("it has over {MAX_LAYERS} layers or {MAX_CHANNELS} channels");
            return Err(Error::SlowPainters(reason));
        }
        self.layers.push(Layer {
            side,
            stride,
            doubled,
            from,
            inputs,
            outputs,
            weights: values,
            scales: Vec::new(),
            offsets: Vec::new(),
            relu: false,
            added: None,
            normalised: false,
        });
        Ok(Found::Picture { layer: Some(self.layers.len() - 1), doubled: false, pad: 0 })
    }

    fn normalisation(&mut self, layer: Option<usize>, scales: Constant, offsets: Constant) -> Result<()> {
        let newest = self.layers.len().checked_sub(1);
        let Some(last) = self.layers.last_mut().filter(|last| layer == newest && !last.normalised) else {
            return Err(invalid("an InstanceNormalization does not follow a Conv"));
        };
        let painters = scales.values.len() / last.outputs;
        let fits =
            scales.values.len() == painters * last.outputs && offsets.values.len() == scales.values.len();
        let first = newest == Some(0);
        if !fits || !(1..=MAX_PAINTERS).contains(&painters) || (!first && painters != self.painters) {
            return Err(invalid("the scales of an InstanceNormalization do not fit its channels"));
        }
        self.painters = painters;
        (last.scales, last.offsets, last.normalised) = (scales.values, offsets.values, true);
        Ok(())
    }

    fn finish(self) -> Result<Graph> {
        // Size of each result: the base-2 logarithm of its reduction.
        let mut sizes: Vec<i32> = Vec::new();
        let mut cost = 0.0;
        for layer in &self.layers {
            let before = layer.from.map_or(0, |from| sizes[from]) - i32::from(layer.doubled);
            let size = before + i32::from(layer.stride == 2);
            if !(0..=2).contains(&before) || !(0..=2).contains(&size) {
                return Err(invalid("it reduces pictures by more than 4, or enlarges them"));
            }
            if layer.added.is_some_and(|added| sizes[added] != size) {
                return Err(invalid("an Add joins results of different sizes"));
            }
            sizes.push(size);
            cost += layer.weights.len() as f64 / f64::from(1 << (2 * size));
        }
        if sizes.last() != Some(&0) || self.layers.last().is_none_or(|last| last.outputs != 3) {
            return Err(invalid("its output is not a colour picture of the size of its input"));
        }
        if cost > MAX_COST as f64 {
            let reason = format!("it multiplies {cost:.0} times per pixel, the limit is {MAX_COST}");
            return Err(Error::SlowPainters(reason));
        }
        let values = self.layers.iter().flat_map(|it| it.weights.iter().chain(&it.scales).chain(&it.offsets));
        if values.clone().any(|value| value.is_nan() || value.abs() > 1e4) {
            return Err(invalid("it has weights that are not numbers, or too large"));
        }
        Ok(Graph { layers: self.layers, painters: self.painters })
    }
}

/// Constant of a normalisation that avoids a division by 0.
pub(super) const EPSILON: f32 = 1e-5;

/// Data types of tensors.
const FLOAT: u64 = 1;
const INT64: u64 = 7;
const FLOAT16: u64 = 10;

fn constant(tensor: &Message<'_>) -> Result<Constant> {
    let shape: Vec<usize> = tensor.numbers(1)?.into_iter().map(|side| side.min(1 << 24) as usize).collect();
    let raw = tensor.bytes(9).unwrap_or_default();
    let values: Vec<f32> = match tensor.number(2) {
        Some(FLOAT) if raw.is_empty() => {
            let packed = tensor.bytes(4).unwrap_or_default().as_chunks().0;
            packed.iter().map(|value| f32::from_le_bytes(*value)).collect()
        }
        Some(FLOAT) => raw.as_chunks().0.iter().map(|value| f32::from_le_bytes(*value)).collect(),
        Some(FLOAT16) => {
            raw.as_chunks().0.iter().map(|value| from_half(u16::from_le_bytes(*value))).collect()
        }
        Some(INT64) if raw.is_empty() => {
            tensor.numbers(7)?.into_iter().map(|value| value as i64 as f32).collect()
        }
        Some(INT64) => raw.as_chunks().0.iter().map(|value| i64::from_le_bytes(*value) as f32).collect(),
        _ => return Err(invalid("it has weights of an unknown type")),
    };
    if shape.iter().try_fold(1_usize, |product, &side| product.checked_mul(side)) != Some(values.len()) {
        return Err(invalid("it has weights that do not fit their shape"));
    }
    Ok(Constant { shape, values })
}

/// A number in half precision.
fn from_half(bits: u16) -> f32 {
    let (exponent, fraction) = (i32::from(bits >> 10 & 31), f32::from(bits & 1023));
    let value = match exponent {
        0 => fraction * (1.0 / (1 << 24) as f32),
        31 => f32::NAN,
        _ => (1024.0 + fraction) * 2_f32.powi(exponent - 25),
    };
    if bits >> 15 == 1 { -value } else { value }
}

fn invalid(reason: impl Into<String>) -> Error {
    Error::InvalidPainters(reason.into())
}
