//! Converts a TensorFlow.js graph model to ONNX: the part of a detector between its prepared image and its
//! raw outputs. Constants that multiply or shift the channels of a convolution (batch normalisation, biases)
//! are folded into its weights.

use std::collections::HashMap;

use anyhow::{Context, Result, bail, ensure};
use serde_json::Value;

use super::fold::Open;
use super::net::{self, Constant, Padding, Tensor, Window, long};
use super::onnx::{Attribute, Graph};

/// The part of the graph to extract.
pub(super) struct Cut<'a> {
    /// The node whose result is the model's input.
    pub(super) input: &'a str,
    /// Side of the square input in pixels.
    pub(super) side: usize,
    /// The nodes whose results are the model's outputs.
    pub(super) outputs: &'a [&'a str],
}

/// Converts `model.json` and the bytes of its shards, one after the other. The input is named `image` (NCHW), the
/// outputs as their nodes.
pub(super) fn convert(model: &Value, shards: &[u8], cut: &Cut) -> Result<Vec<u8>> {
    let mut nodes = HashMap::new();
    let mut uses: HashMap<&str, usize> = HashMap::new();
    for node in model["modelTopology"]["node"].as_array().context("the model has no graph")? {
        nodes.insert(node["name"].as_str().context("a node without a name")?, node);
        for input in inputs(node) {
            *uses.entry(input).or_default() += 1;
        }
    }
    let weights = read_weights(model, shards)?;
    let mut graph = Graph::default();
    let side = cut.side;
    let name = graph.input("image", &long(&[1, 3, side, side]));
    let image = Outcome::Tensor(Tensor { name, shape: vec![1, side, side, 3] });
    let done = HashMap::from([(cut.input, image)]);
    let mut converter = Converter { nodes, uses, weights, graph, done };
    for output in cut.outputs {
        let result = converter.tensor(output)?;
        converter.graph.output(&result.name, output, &long(&result.shape));
    }
    Ok(converter.graph.finish("objects"))
}

/// Returns the names of a node's inputs without the output number, because all nodes here have one output.
fn inputs(node: &Value) -> impl Iterator<Item = &str> {
    let names = node["input"].as_array().into_iter().flatten().filter_map(Value::as_str);
    names.map(|name| name.trim_start_matches('^').split(':').next().unwrap_or(name))
}

/// All constants by name. Whole numbers become floats; ours are small sizes, which floats hold exactly.
fn read_weights<'a>(model: &'a Value, shards: &[u8]) -> Result<HashMap<&'a str, Constant>> {
    let mut weights = HashMap::new();
    let mut rest = shards;
    for group in model["weightsManifest"].as_array().context("the model names no weights")? {
        for weight in group["weights"].as_array().into_iter().flatten() {
            let name = weight["name"].as_str().context("weights without a name")?;
            ensure!(weight["quantization"].is_null(), "{name} is quantised");
            let shape = whole_numbers(&weight["shape"]);
            let count: usize = shape.iter().product();
            let (bytes, after) = rest.split_at_checked(4 * count).context("the shards are too short")?;
            rest = after;
            let bytes = bytes.as_chunks::<4>().0.iter();
            let values = match weight["dtype"].as_str() {
                Some("float32") => bytes.map(|value| f32::from_le_bytes(*value)).collect(),
                Some("int32") => bytes.map(|value| i32::from_le_bytes(*value) as f32).collect(),
                other => bail!("{name} is of type {other:?}"),
            };
            weights.insert(name, Constant { values, shape });
        }
    }
    ensure!(rest.is_empty(), "the shards are too long");
    Ok(weights)
}

fn whole_numbers(list: &Value) -> Vec<usize> {
    list.as_array().into_iter().flatten().filter_map(whole_number).collect()
}

/// JSON of protocol buffers has 64-bit numbers as texts.
fn whole_number(value: &Value) -> Option<usize> {
    let text = value.as_str().and_then(|text| text.parse().ok());
    text.or_else(|| value.as_u64().map(|number| number as usize))
}

/// Result of a node.
#[derive(Clone, Debug)]
enum Outcome {
    Tensor(Tensor),
    Constant(Constant),
    /// A convolution that is not written yet.
    Open(Open),
}

struct Converter<'a> {
    nodes: HashMap<&'a str, &'a Value>,
    /// How many nodes read a result.
    uses: HashMap<&'a str, usize>,
    weights: HashMap<&'a str, Constant>,
    graph: Graph,
    done: HashMap<&'a str, Outcome>,
}

impl<'a> Converter<'a> {
    /// A node's result, written to the graph if need be.
    fn tensor(&mut self, name: &'a str) -> Result<Tensor> {
        let tensor = match self.outcome(name)? {
            Outcome::Tensor(tensor) => return Ok(tensor),
            Outcome::Open(open) => open.write(&mut self.graph)?,
            Outcome::Constant(_) => bail!("{name} is a constant"),
        };
        self.done.insert(name, Outcome::Tensor(tensor.clone()));
        Ok(tensor)
    }

    fn outcome(&mut self, name: &'a str) -> Result<Outcome> {
        if let Some(done) = self.done.get(name) {
            return Ok(done.clone());
        }
        let node = *self.nodes.get(name).with_context(|| format!("there is no node {name}"))?;
        let located = |error: anyhow::Error| {
            // The error names the failing node, not the nodes that depend on it.
            if error.chain().len() > 1 { error } else { error.context(format!("node {name}")) }
        };
        let outcome = self.evaluate(name, node).map_err(located)?;
        self.done.insert(name, outcome.clone());
        Ok(outcome)
    }

    fn constant(&mut self, name: &'a str) -> Result<Constant> {
        match self.outcome(name)? {
            Outcome::Constant(constant) => Ok(constant),
            _ => bail!("{name} is no constant"),
        }
    }

    fn evaluate(&mut self, name: &'a str, node: &'a Value) -> Result<Outcome> {
        let from: Vec<&'a str> = inputs(node).collect();
        let input = |i: usize| from.get(i).copied().context("it lacks an input");
        let operator = node["op"].as_str().context("it has no operator")?;
        Ok(match operator {
            "Const" => Outcome::Constant(self.weights.get(name).context("it has no weights")?.clone()),
            "Conv2D" => self.convolution(node, input(0)?, input(1)?, [3, 2, 0, 1])?,
            "DepthwiseConv2dNative" => self.convolution(node, input(0)?, input(1)?, [2, 3, 0, 1])?,
            "Mul" | "Add" | "AddN" | "BiasAdd" => {
                let (a, b) = (self.outcome(input(0)?)?, self.outcome(input(1)?)?);
                let (open, constant, of) = match (a, b) {
                    (Outcome::Open(open), Outcome::Constant(constant)) => (open, constant, input(0)?),
                    (Outcome::Constant(constant), Outcome::Open(open)) => (open, constant, input(1)?),
                    _ if operator == "Mul" || operator == "BiasAdd" => bail!("it cannot be folded"),
                    (Outcome::Tensor(tensor), Outcome::Constant(constant))
                    | (Outcome::Constant(constant), Outcome::Tensor(tensor)) => {
                        return self.shifted(&tensor, &constant);
                    }
                    _ => {
                        let (a, b) = (self.tensor(input(0)?)?, self.tensor(input(1)?)?);
                        return Ok(Outcome::Tensor(net::sum(&mut self.graph, &a, &b)?));
                    }
                };
                let mut open = self.sole(open, of)?;
                if operator == "Mul" {
                    open.scale(&constant.values)?;
                } else {
                    open.shift(&constant.values)?;
                }
                Outcome::Open(open)
            }
            "FusedBatchNorm" => {
                let Outcome::Open(open) = self.outcome(input(0)?)? else { bail!("it cannot be folded") };
                let mut open = self.sole(open, input(0)?)?;
                let mut values = |i: usize| -> Result<Vec<f32>> { Ok(self.constant(input(i)?)?.values) };
                let [gamma, beta, mean, variance] = [values(1)?, values(2)?, values(3)?, values(4)?];
                let epsilon = node["attr"]["epsilon"]["f"].as_f64().context("it has no epsilon")? as f32;
                let scale: Vec<f32> =
                    gamma.iter().zip(&variance).map(|(g, v)| g / (v + epsilon).sqrt()).collect();
                let shift: Vec<f32> =
                    beta.iter().zip(&mean).zip(&scale).map(|((b, m), s)| b - m * s).collect();
                open.scale(&scale)?;
                open.shift(&shift)?;
                Outcome::Open(open)
            }
            "Relu6" => {
                let from = self.tensor(input(0)?)?;
                Outcome::Tensor(Tensor { name: self.graph.relu6(&from.name), ..from })
            }
            "ConcatV2" => self.joined(&from)?,
            "Shape" => {
                let shape = self.tensor(input(0)?)?.shape;
                let values = shape.iter().map(|side| *side as f32).collect();
                Outcome::Constant(Constant { values, shape: vec![shape.len()] })
            }
            "StridedSlice" => {
                let (list, at) = (self.constant(input(0)?)?, self.constant(input(1)?)?);
                let at = *at.values.first().context("it has no start")? as usize;
                let value = *list.values.get(at).context("it starts beyond the end")?;
                Outcome::Constant(Constant { values: vec![value], shape: Vec::new() })
            }
            "Pack" => {
                let mut values = Vec::new();
                for name in &from {
                    values.extend(self.constant(name)?.values);
                }
                Outcome::Constant(Constant { shape: vec![values.len()], values })
            }
            "Reshape" => {
                let (from, shape) = (self.tensor(input(0)?)?, self.constant(input(1)?)?);
                let count: usize = from.shape.iter().product();
                let known: usize = shape.values.iter().filter(|s| **s > 0.0).map(|s| *s as usize).product();
                let side = |s: &f32| if *s < 0.0 { count / known.max(1) } else { *s as usize };
                let shape: Vec<usize> = shape.values.iter().map(side).collect();
                // Boxes have the shape [1, n, 1, 4]. Squeeze would change it to [1, n, 4] at the end.
                let shape = if shape.len() == 4 && shape[2] == 1 {
                    vec![shape[0], shape[1], shape[3]]
                } else {
                    shape
                };
                Outcome::Tensor(net::reshape(&mut self.graph, &from, shape)?)
            }
            "Squeeze" => {
                let from = self.tensor(input(0)?)?;
                ensure!(from.shape.len() == 3, "a squeeze of {:?}", from.shape);
                Outcome::Tensor(from)
            }
            other => bail!("operator {other} is not known here"),
        })
    }

    /// `order` brings the weights to ONNX's order.
    fn convolution(
        &mut self,
        node: &'a Value,
        from: &'a str,
        weights: &'a str,
        order: [usize; 4],
    ) -> Result<Outcome> {
        let mut weights = net::transposed(&self.constant(weights)?, order)?;
        if order[0] == 2 {
            // Depthwise: channels in, times results of each; one channel a group.
            weights.shape = vec![weights.shape[0] * weights.shape[1], 1, weights.shape[2], weights.shape[3]];
        }
        let pair = |key: &str| -> Result<[usize; 2]> {
            let list = whole_numbers(&node["attr"][key]["list"]["i"]);
            ensure!(list.len() == 4, "{key} are {list:?}");
            Ok([list[1], list[2]])
        };
        let padding = match text(&node["attr"]["padding"]["s"]).as_str() {
            "SAME" => Padding::Same,
            "VALID" => Padding::Valid,
            other => bail!("padding {other:?}"),
        };
        let size = [weights.shape[2], weights.shape[3]];
        let window = Window { size, stride: pair("strides")?, dilation: pair("dilations")?, padding };
        Ok(Outcome::Open(Open { from: self.tensor(from)?, weights, bias: None, window }))
    }

    /// A tensor with a constant for each channel added.
    fn shifted(&mut self, from: &Tensor, constant: &Constant) -> Result<Outcome> {
        let channels = constant.values.len();
        ensure!(from.shape.last() == Some(&channels), "{channels} values for {:?}", from.shape);
        let constant = self.graph.weights(&constant.values, &[1, channels as i64, 1, 1]);
        let name = self.graph.node("Add", &[&from.name, &constant], &[]);
        Ok(Outcome::Tensor(Tensor { name, shape: from.shape.clone() }))
    }

    /// A convolution that only one node reads may be changed by that node.
    fn sole(&self, open: Open, name: &str) -> Result<Open> {
        ensure!(self.uses.get(name) == Some(&1), "{name} is read by others too, so it cannot be folded");
        Ok(open)
    }

    /// Lists of anchors, one after the other.
    fn joined(&mut self, from: &[&'a str]) -> Result<Outcome> {
        let (axis, parts) = from.split_last().context("nothing to join")?;
        ensure!(self.constant(axis)?.values == [1.0], "joined along another axis than 1");
        let parts = parts.iter().map(|name| self.tensor(name)).collect::<Result<Vec<_>>>()?;
        ensure!(parts.iter().all(|part| part.shape.len() == 3), "joined parts are lists of anchors");
        let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
        let name = self.graph.node("Concat", &names, &[("axis", Attribute::Int(1))]);
        let first = parts.first().context("nothing to join")?;
        let shape = vec![first.shape[0], parts.iter().map(|part| part.shape[1]).sum(), first.shape[2]];
        Ok(Outcome::Tensor(Tensor { name, shape }))
    }
}

/// Returns a text that is stored as character codes.
fn text(value: &Value) -> String {
    let codes = value.as_array().into_iter().flatten().filter_map(Value::as_u64);
    codes.map(|code| code as u8 as char).collect()
}
