//! Converts the model that finds the subject of a photo: an ONNX file from `PyTorch`, which computes shapes
//! at run time. The converter computes them once, retains only the finest of its seven masks, and halves the
//! size of the weights.

use std::collections::HashMap;

use anyhow::{Context, Result, bail, ensure};

use super::net::{self, Constant, Padding, Tensor, Window};
use super::onnx::{Attribute, Graph};
use super::protobuf::{Message, Value};

/// `TensorProto.DataType` of single precision.
const FLOAT: u64 = 1;

/// A node of the file.
struct Node<'a> {
    operator: String,
    inputs: Vec<String>,
    attributes: HashMap<String, Vec<i64>>,
    texts: HashMap<String, &'a [u8]>,
}

/// Converts the file. The input is named `image` (NCHW, `side` x `side` pixels). The output `mask` has logits
/// of the same size.
pub(super) fn convert(file: &[u8], side: usize) -> Result<Vec<u8>> {
    let model = Message::new(file)?;
    let graph = model.message(7)?.context("the file has no graph")?;
    let mut weights = HashMap::new();
    for tensor in graph.messages(5)? {
        let (name, constant) = read_weights(&tensor)?;
        weights.insert(name, constant);
    }
    let mut nodes = HashMap::new();
    for node in graph.messages(1)? {
        let output = node.text(2)?.context("a node without a result")?;
        nodes.insert(output, read_node(&node)?);
    }
    let input = graph.messages(11)?.first().and_then(|info| info.text(1).ok().flatten());
    let input = input.context("the file has no input")?;
    let output = graph.messages(12)?.first().and_then(|info| info.text(1).ok().flatten());
    let output = output.context("the file has no output")?;
    let mut written = Graph::default();
    let name = written.input("image", &[1, 3, side as i64, side as i64]);
    let image = Tensor { name, shape: vec![1, side, side, 3] };
    let mut converter = Converter { nodes, weights, graph: written, done: HashMap::from([(input, image)]) };
    // The last step converts logits to probabilities. It is dropped, because the detection code does it.
    let last = converter.nodes.get(&output).context("the output is made by no node")?;
    ensure!(last.operator == "Sigmoid", "the output is made by {}", last.operator);
    let logits = last.inputs.first().context("a node without input")?.clone();
    let mask = converter.tensor(&logits)?;
    ensure!(mask.shape == [1, side, side, 1], "the mask has the shape {:?}", mask.shape);
    converter.graph.output(&mask.name, "mask", &[1, 1, side as i64, side as i64]);
    Ok(converter.graph.finish("subject"))
}

/// Reads the name and the values of weights.
pub(super) fn read_weights(tensor: &Message<'_>) -> Result<(String, Constant)> {
    let name = tensor.text(8)?.context("weights without a name")?;
    ensure!(tensor.number(2)? == Some(FLOAT), "{name} are not in single precision");
    let shape: Vec<usize> = tensor.numbers(1)?.into_iter().map(|side| side as usize).collect();
    let (bytes, rest) = tensor.bytes(9)?.context("weights that are not raw")?.as_chunks::<4>();
    let values: Vec<f32> = bytes.iter().map(|value| f32::from_le_bytes(*value)).collect();
    ensure!(rest.is_empty() && values.len() == shape.iter().product::<usize>(), "{name} are cut off");
    Ok((name, Constant { values, shape }))
}

fn read_node<'a>(node: &Message<'a>) -> Result<Node<'a>> {
    let (mut attributes, mut texts) = (HashMap::new(), HashMap::new());
    for attribute in node.messages(5)? {
        let name = attribute.text(1)?.context("an attribute without a name")?;
        if let Some(text) = attribute.bytes(4)? {
            texts.insert(name, text);
            continue;
        }
        let mut values = attribute.numbers(8)?;
        values.extend(attribute.number(3)?);
        attributes.insert(name, values.into_iter().map(|value| value as i64).collect());
    }
    let inputs = node.all(1)?.into_iter().map(Value::text).collect::<Result<_>>()?;
    Ok(Node { operator: node.text(4)?.context("a node without operator")?, inputs, attributes, texts })
}

struct Converter<'a> {
    nodes: HashMap<String, Node<'a>>,
    weights: HashMap<String, Constant>,
    graph: Graph,
    done: HashMap<String, Tensor>,
}

impl Converter<'_> {
    fn tensor(&mut self, name: &str) -> Result<Tensor> {
        if let Some(done) = self.done.get(name) {
            return Ok(done.clone());
        }
        let tensor = self.evaluate(name).with_context(|| format!("node {name}"))?;
        self.done.insert(name.to_owned(), tensor.clone());
        Ok(tensor)
    }

    fn evaluate(&mut self, name: &str) -> Result<Tensor> {
        let node = self.nodes.get(name).context("there is no such node")?;
        let (operator, inputs) = (node.operator.clone(), node.inputs.clone());
        let input = |i: usize| inputs.get(i).map(String::as_str).context("it lacks an input");
        let window = || -> Result<Window> {
            let pair = |key: &str, default: usize| -> Result<[usize; 2]> {
                let Some(list) = node.attributes.get(key) else { return Ok([default; 2]) };
                ensure!(list.len() >= 2, "{key} are {list:?}");
                Ok([list[0] as usize, list[1] as usize])
            };
            let padded = pair("pads", 0)? != [0, 0];
            let padding = if padded { Padding::Around } else { Padding::Valid };
            let (size, stride) = (pair("kernel_shape", 1)?, pair("strides", 1)?);
            Ok(Window { size, stride, dilation: pair("dilations", 1)?, padding })
        };
        match operator.as_str() {
            "Conv" => {
                let window = window()?;
                let from = self.tensor(input(0)?)?;
                let weights = self.weights.get(input(1)?).context("no weights")?;
                let bias = self.weights.get(input(2)?).context("no bias")?;
                net::convolution(&mut self.graph, &from, weights, Some(&bias.values), window)
            }
            "MaxPool" => {
                let window = window()?;
                let from = self.tensor(input(0)?)?;
                // The sides are even all the way down, so that rounding up never matters.
                ensure!(from.shape[1..3].iter().all(|side| side.is_multiple_of(2)), "odd sides");
                net::max_pool(&mut self.graph, &from, window)
            }
            "Relu" => {
                let from = self.tensor(input(0)?)?;
                Ok(Tensor { name: self.graph.node("Relu", &[&from.name], &[]), ..from })
            }
            "Add" => {
                let (a, b) = (self.tensor(input(0)?)?, self.tensor(input(1)?)?);
                net::sum(&mut self.graph, &a, &b)
            }
            "Concat" => {
                let parts = inputs.iter().map(|name| self.tensor(name)).collect::<Result<Vec<_>>>()?;
                let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
                let name = self.graph.node("Concat", &names, &[("axis", Attribute::Int(1))]);
                let mut shape = parts.first().context("nothing to join")?.shape.clone();
                ensure!(parts.iter().all(|part| part.shape[1..3] == shape[1..3]), "parts of several sizes");
                shape[3] = parts.iter().map(|part| part.shape[3]).sum();
                Ok(Tensor { name, shape })
            }
            "Resize" => {
                ensure!(
                    node.texts.get("mode").is_some_and(|mode| *mode == b"linear")
                        && node
                            .texts
                            .get("coordinate_transformation_mode")
                            .is_some_and(|mode| *mode == b"pytorch_half_pixel"),
                    "it is no linear resizing about the middles of pixels"
                );
                let model = self.sized_as(input(3)?)?;
                let (from, [height, width]) = (self.tensor(input(0)?)?, self.size(&model)?);
                self.resized(&from, [height, width])
            }
            other => bail!("operator {other} is not known here"),
        }
    }

    fn size(&mut self, name: &str) -> Result<[usize; 2]> {
        let shape = self.tensor(name)?.shape;
        Ok([shape[1], shape[2]])
    }

    /// Upscaling by a whole factor.
    fn resized(&mut self, from: &Tensor, [height, width]: [usize; 2]) -> Result<Tensor> {
        let factor = height / from.shape[1];
        ensure!([factor * from.shape[1], factor * from.shape[2]] == [height, width], "no whole factor");
        let scales = self.graph.weights(&[1.0, 1.0, factor as f32, factor as f32], &[4]);
        let attributes = [
            ("mode", Attribute::Text("linear")),
            ("coordinate_transformation_mode", Attribute::Text("half_pixel")),
        ];
        let name = self.graph.node("Resize", &[&from.name, "", &scales], &attributes);
        Ok(Tensor { name, shape: vec![1, height, width, from.shape[3]] })
    }

    /// Returns the tensor whose sides define a list of sizes. The list has sides 2 and 3 of its shape, after
    /// the sides of the resized tensor.
    fn sized_as(&self, sizes: &str) -> Result<String> {
        let mut at = sizes.to_owned();
        for step in ["Concat", "Cast", "Concat", "Unsqueeze", "Gather", "Shape"] {
            let node = self.nodes.get(&at).with_context(|| format!("there is no node {at}"))?;
            ensure!(node.operator == step, "sizes are made by {} instead of {step}", node.operator);
            // The second half of the list has height and width.
            let input = usize::from(at == sizes);
            at.clone_from(node.inputs.get(input).context("it lacks an input")?);
        }
        Ok(at)
    }
}
