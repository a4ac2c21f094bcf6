//! Converts the model of painters: an ONNX file of `PyTorch`, whose weights come from a TensorFlow demo. The converter
//! writes the network with fewer operators, and with some of its painters.

use std::collections::HashMap;

use anyhow::{Context, Result, ensure};

use super::net::Constant;
use super::onnx::{Attribute, Graph};
use super::protobuf::Message;
use super::u2net::read_weights;

/// Painters of the file.
const ALL: usize = 26;

/// Residual blocks of two convolutions.
const RESIDUALS: usize = 6;

/// Converts the file. `painters` are the painters to keep, in their new order. The inputs are `image`, NCHW of any size
/// with RGB from 0 to 1, and `painters`, one weight per painter. The output `painting` is like `image`.
pub(super) fn convert(file: &[u8], painters: &[usize]) -> Result<Vec<u8>> {
    let model = Message::new(file)?;
    let graph = model.message(7)?.context("the file has no graph")?;
    let mut weights = HashMap::new();
    for tensor in graph.messages(5)? {
        let (name, constant) = read_weights(&tensor)?;
        weights.insert(name, constant);
    }
    let mut graph = Graph::default();
    let mut picture = graph.input("image", &[1, 3, -1, -1]);
    let choice = graph.input("painters", &[painters.len() as i64]);
    let mut layers = Layers { weights, painters, choice, graph };
    for (i, stride) in [(0, 1), (1, 2), (2, 2)] {
        picture = layers.relu(&format!("contract.{i}"), &picture, stride)?;
    }
    for i in 0..RESIDUALS {
        let inner = layers.relu(&format!("res.{i}.0"), &picture, 1)?;
        let outer = layers.layer(&format!("res.{i}.1"), &inner, 1)?;
        picture = layers.graph.node("Add", &[&picture, &outer], &[]);
    }
    for i in 0..2 {
        picture = layers.doubled(&picture);
        picture = layers.relu(&format!("expand.{i}"), &picture, 1)?;
    }
    picture = layers.layer("expand.2", &picture, 1)?;
    let mut graph = layers.graph;
    let painting = graph.node("Sigmoid", &[&picture], &[]);
    graph.output(&painting, "painting", &[1, 3, -1, -1]);
    Ok(graph.finish("painters"))
}

struct Layers<'a> {
    weights: HashMap<String, Constant>,
    painters: &'a [usize],
    choice: String,
    graph: Graph,
}

impl Layers<'_> {
    /// A convolution with its normalisation, and without negative results.
    fn relu(&mut self, name: &str, from: &str, stride: i64) -> Result<String> {
        let layer = self.layer(name, from, stride)?;
        Ok(self.graph.node("Relu", &[&layer], &[]))
    }

    /// A convolution with its normalisation.
    fn layer(&mut self, name: &str, from: &str, stride: i64) -> Result<String> {
        let kernel = self.take(&format!("{name}.w"))?;
        let &[outputs, _, side, _] = kernel.shape.as_slice() else {
            anyhow::bail!("{name}: its weights have the shape {:?}", kernel.shape);
        };
        let pad = side as i64 / 2;
        let pads = self.graph.integers(&[0, 0, pad, pad, 0, 0, pad, pad]);
        let padded = self.graph.node("Pad", &[from, &pads], &[("mode", Attribute::Text("reflect"))]);
        let shape: Vec<i64> = kernel.shape.iter().map(|side| *side as i64).collect();
        let weights = self.graph.weights(&kernel.values, &shape);
        let strides = [("strides", Attribute::Ints(&[stride, stride]))];
        let sums = self.graph.node("Conv", &[&padded, &weights], &strides);
        let scale = self.mixed(&format!("{name}.norm.gamma"), outputs)?;
        let offset = self.mixed(&format!("{name}.norm.beta"), outputs)?;
        Ok(self.graph.node("InstanceNormalization", &[&sums, &scale, &offset], &[]))
    }

    /// Values per channel, as the weights of the painters mix them.
    fn mixed(&mut self, name: &str, channels: usize) -> Result<String> {
        let Constant { values, shape } = self.take(name)?;
        ensure!(shape == [ALL, channels], "{name} has the shape {shape:?}");
        let kept: Vec<f32> = self
            .painters
            .iter()
            .flat_map(|&painter| &values[painter * channels..][..channels])
            .copied()
            .collect();
        let matrix = self.graph.weights(&kept, &[self.painters.len() as i64, channels as i64]);
        Ok(self.graph.node("MatMul", &[&self.choice, &matrix], &[]))
    }

    /// Every pixel four times.
    fn doubled(&mut self, from: &str) -> String {
        let scales = self.graph.weights(&[1.0, 1.0, 2.0, 2.0], &[4]);
        let attributes = [
            ("mode", Attribute::Text("nearest")),
            ("coordinate_transformation_mode", Attribute::Text("asymmetric")),
            ("nearest_mode", Attribute::Text("floor")),
        ];
        self.graph.node("Resize", &[from, "", &scales], &attributes)
    }

    fn take(&mut self, name: &str) -> Result<Constant> {
        self.weights.remove(name).with_context(|| format!("the file has no {name}"))
    }
}
