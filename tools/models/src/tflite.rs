//! Converts a TensorFlow Lite file to ONNX: floating-point convolution models such as `BlazeFace`. Field
//! numbers and codes follow TensorFlow's `schema.fbs`.

use std::collections::HashMap;

use anyhow::{Context, Result, bail, ensure};

use super::flatbuffer::Table;
use super::half::whole;
use super::net::{self, Constant, Padding, Tensor, Window, long};
use super::onnx::{Attribute, Graph};

/// `BuiltinOperator`.
const ADD: i64 = 0;
const CONV_2D: i64 = 3;
const DEPTHWISE_CONV_2D: i64 = 4;
const DEQUANTIZE: i64 = 6;
const MAX_POOL_2D: i64 = 17;
const RELU: i64 = 19;
const RESHAPE: i64 = 22;
const RESIZE_BILINEAR: i64 = 23;
const PAD: i64 = 34;
const PRELU: i64 = 54;

/// Converts a file to a graph called `title`. The input is named `image` (NCHW), the outputs as in the file.
pub(super) fn convert(file: &[u8], title: &str) -> Result<Vec<u8>> {
    let model = Table::root(file)?;
    let net = *model.tables(2)?.first().context("the file holds no net")?;
    let mut reader = Reader {
        tensors: net.tables(0)?,
        buffers: model.tables(4)?,
        constants: HashMap::new(),
        results: HashMap::new(),
        graph: Graph::default(),
    };
    for input in net.integers(1)? {
        let shape = reader.shape(input)?;
        ensure!(shape.len() == 4, "an input of shape {shape:?}");
        let name = reader.graph.input("image", &long(&net::stored(&shape)));
        reader.results.insert(input, Tensor { name, shape });
    }
    let codes = model.tables(1)?;
    for operator in net.tables(3)? {
        let code = codes.get(operator.integer(0, 4, 0)? as usize).context("an operator without a code")?;
        // Files from before the code outgrew a byte have it in another field.
        let code = code.integer(0, 1, 0)?.max(code.integer(3, 4, 0)?);
        reader.operator(code, operator)?;
    }
    for output in net.integers(2)? {
        let name = String::from_utf8_lossy(reader.tensor(output)?.bytes(3)?).into_owned();
        let result = reader.result(output)?;
        let name = name.rsplit('/').next().unwrap_or(&name);
        reader.graph.output(&result.name, name, &long(&net::stored(&result.shape)));
    }
    Ok(reader.graph.finish(title))
}

struct Reader<'a> {
    tensors: Vec<Table<'a>>,
    buffers: Vec<Table<'a>>,
    /// Constants that an operator of the file made.
    constants: HashMap<i32, Constant>,
    results: HashMap<i32, Tensor>,
    graph: Graph,
}

impl<'a> Reader<'a> {
    fn operator(&mut self, code: i64, operator: Table<'a>) -> Result<()> {
        let (inputs, outputs) = (operator.integers(1)?, operator.integers(2)?);
        let input = |i: usize| inputs.get(i).copied().context("an operator lacks an input");
        let output = *outputs.first().context("an operator without a result")?;
        if code == DEQUANTIZE {
            let constant = self.constant(input(0)?)?;
            self.constants.insert(output, constant);
            return Ok(());
        }
        let from = self.result(input(0)?)?;
        let options = Options(operator.table(4)?);
        let result = match code {
            CONV_2D => {
                let weights = net::transposed(&self.constant(input(1)?)?, [0, 3, 1, 2])?;
                let dilation = [options.size(5, 1)?, options.size(4, 1)?];
                self.convolution(&from, &weights, input(2)?, dilation, options, 3)?
            }
            DEPTHWISE_CONV_2D => {
                let weights = net::transposed(&self.constant(input(1)?)?, [3, 0, 1, 2])?;
                let weights = Constant {
                    shape: vec![weights.shape[0], 1, weights.shape[2], weights.shape[3]],
                    ..weights
                };
                let dilation = [options.size(6, 1)?, options.size(5, 1)?];
                self.convolution(&from, &weights, input(2)?, dilation, options, 4)?
            }
            ADD => {
                let other = self.result(input(1)?)?;
                let sum = net::sum(&mut self.graph, &from, &other)?;
                self.activated(sum, options.integer(0, 1, 0)?)?
            }
            RELU => self.activated(from, 1)?,
            PRELU => {
                let slopes = self.constant(input(1)?)?;
                net::prelu(&mut self.graph, &from, &slopes)?
            }
            MAX_POOL_2D => {
                let window = options.window([options.size(4, 0)?, options.size(3, 0)?], [1, 1])?;
                let pooled = net::max_pool(&mut self.graph, &from, window)?;
                self.activated(pooled, options.integer(5, 1, 0)?)?
            }
            PAD => self.padded(&from, input(1)?)?,
            RESIZE_BILINEAR => self.resized(&from, output, options)?,
            RESHAPE => {
                let shape = self.shape(output)?;
                // The model returns lists of anchors. Dimensions of size 1 between list and values are
                // ignored.
                let ends = |i: usize| i == 0 || i == 1 || i + 1 == shape.len();
                let shape = shape.iter().enumerate().filter(|(i, side)| ends(*i) || **side != 1);
                let shape = shape.map(|(_, side)| *side).collect();
                net::reshape(&mut self.graph, &from, shape)?
            }
            other => bail!("operator {other} is not known here"),
        };
        self.results.insert(output, result);
        Ok(())
    }

    fn convolution(
        &mut self,
        from: &Tensor,
        weights: &Constant,
        bias: i32,
        dilation: [usize; 2],
        options: Options,
        activation: usize,
    ) -> Result<Tensor> {
        let bias = self.constant(bias)?.values;
        let window = options.window([weights.shape[2], weights.shape[3]], dilation)?;
        let result = net::convolution(&mut self.graph, from, weights, Some(&bias), window)?;
        self.activated(result, options.integer(activation, 1, 0)?)
    }

    /// `ActivationFunctionType`.
    fn activated(&mut self, from: Tensor, kind: i64) -> Result<Tensor> {
        let name = match kind {
            0 => return Ok(from),
            1 => self.graph.node("Relu", &[&from.name], &[]),
            3 => self.graph.relu6(&from.name),
            other => bail!("activation {other} is not known here"),
        };
        Ok(Tensor { name, ..from })
    }

    fn padded(&mut self, from: &Tensor, amounts: i32) -> Result<Tensor> {
        let amounts = self.integers(amounts)?;
        ensure!(amounts.len() == 8 && from.shape.len() == 4, "a padding by {amounts:?}");
        let order = [0, 3, 1, 2];
        let (before, after) = (order.map(|axis| amounts[2 * axis]), order.map(|axis| amounts[2 * axis + 1]));
        let pads = self.graph.integers(&[before, after].concat());
        let name = self.graph.node("Pad", &[&from.name, &pads], &[("mode", Attribute::Text("constant"))]);
        let grown = from.shape.iter().enumerate();
        let shape = grown.map(|(i, side)| side + (amounts[2 * i] + amounts[2 * i + 1]) as usize).collect();
        Ok(Tensor { name, shape })
    }

    fn resized(&mut self, from: &Tensor, output: i32, options: Options) -> Result<Tensor> {
        let shape = self.shape(output)?;
        ensure!(shape.len() == 4 && from.shape.len() == 4, "a resize to {shape:?}");
        let mode = match (options.integer(2, 1, 0)?, options.integer(3, 1, 0)?) {
            (0, 0) => "asymmetric",
            (0, _) => "half_pixel",
            _ => "align_corners",
        };
        let scale = |axis: usize| shape[axis] as f32 / from.shape[axis] as f32;
        let scales = self.graph.weights(&[1.0, 1.0, scale(1), scale(2)], &[4]);
        let attributes =
            [("mode", Attribute::Text("linear")), ("coordinate_transformation_mode", Attribute::Text(mode))];
        let name = self.graph.node("Resize", &[&from.name, "", &scales], &attributes);
        Ok(Tensor { name, shape })
    }

    fn tensor(&self, index: i32) -> Result<Table<'a>> {
        let tensor = usize::try_from(index).ok().and_then(|index| self.tensors.get(index));
        tensor.copied().with_context(|| format!("there is no tensor {index}"))
    }

    fn shape(&self, index: i32) -> Result<Vec<usize>> {
        let sides = self.tensor(index)?.integers(0)?;
        sides.into_iter().map(|side| Ok(usize::try_from(side)?)).collect()
    }

    fn result(&self, index: i32) -> Result<Tensor> {
        self.results.get(&index).cloned().with_context(|| format!("tensor {index} is used before it is made"))
    }

    fn data(&self, index: i32) -> Result<&'a [u8]> {
        let buffer = self.tensor(index)?.integer(2, 4, 0)? as usize;
        self.buffers.get(buffer).context("a tensor without a buffer")?.bytes(0)
    }

    fn constant(&self, index: i32) -> Result<Constant> {
        if let Some(made) = self.constants.get(&index) {
            return Ok(made.clone());
        }
        let (data, shape) = (self.data(index)?, self.shape(index)?);
        let values: Vec<f32> = match self.tensor(index)?.integer(1, 1, 0)? {
            0 => data.as_chunks::<4>().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect(),
            1 => data.as_chunks::<2>().0.iter().map(|bytes| whole(u16::from_le_bytes(*bytes))).collect(),
            other => bail!("weights of type {other}"),
        };
        ensure!(
            values.len() == shape.iter().product::<usize>(),
            "tensor {index} has {} values",
            values.len()
        );
        Ok(Constant { values, shape })
    }

    fn integers(&self, index: i32) -> Result<Vec<i64>> {
        let data = self.data(index)?;
        Ok(data.as_chunks::<4>().0.iter().map(|bytes| i64::from(i32::from_le_bytes(*bytes))).collect())
    }
}

/// Options of an operator. Without options in the file, all have default values.
#[derive(Clone, Copy)]
struct Options<'a>(Option<Table<'a>>);

impl Options<'_> {
    fn integer(&self, field: usize, size: usize, default: i64) -> Result<i64> {
        self.0.map_or(Ok(default), |table| table.integer(field, size, default))
    }

    fn size(&self, field: usize, default: i64) -> Result<usize> {
        Ok(usize::try_from(self.integer(field, 4, default)?)?)
    }

    /// Convolutions and pools have the same first three fields.
    fn window(&self, size: [usize; 2], dilation: [usize; 2]) -> Result<Window> {
        let padding = if self.integer(0, 1, 0)? == 0 { Padding::Same } else { Padding::Valid };
        Ok(Window { size, stride: [self.size(2, 0)?, self.size(1, 0)?], dilation, padding })
    }
}
