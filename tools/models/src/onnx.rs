//! Writes the subset of the ONNX file format that the models need. ONNX files are protocol buffers, which
//! consist of tags, lengths and bytes, so no library is needed. Field numbers follow `onnx.proto3`, IR
//! version 8, opset 13.
//!
//! Large weights are stored in half precision and cast when the model is loaded, which halves the file.

use super::half::half;

const IR_VERSION: i64 = 8;
const OPSET: i64 = 13;

/// `TensorProto.DataType`.
const FLOAT: i64 = 1;
const INT64: i64 = 7;
const FLOAT16: i64 = 10;

/// Tensors with more values than this are stored in half precision.
const SMALL: usize = 64;

/// An attribute of a node.
pub(super) enum Attribute<'a> {
    Int(i64),
    Ints(&'a [i64]),
    Text(&'a str),
}

/// A graph under construction. Every method that adds an operator returns the name of its result.
#[derive(Default)]
pub(super) struct Graph {
    nodes: Message,
    weights: Message,
    inputs: Message,
    outputs: Message,
    count: usize,
    /// Whether weights are stored without rounding, even if there are many.
    pub(super) exact: bool,
}

impl Graph {
    /// The model's input, f32. A negative side may have any length.
    pub(super) fn input(&mut self, name: &str, shape: &[i64]) -> String {
        self.inputs.message(11, &value_info(name, shape));
        name.to_owned()
    }

    /// Gives a result to the outside under another name.
    pub(super) fn output(&mut self, from: &str, name: &str, shape: &[i64]) {
        self.add("Identity", &[from], &[], name);
        self.outputs.message(12, &value_info(name, shape));
    }

    /// A constant of `shape`; the values in row-major order.
    pub(super) fn weights(&mut self, values: &[f32], shape: &[i64]) -> String {
        let name = self.fresh();
        if values.len() <= SMALL || self.exact {
            let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
            self.weights.message(5, &tensor(&name, FLOAT, shape, &bytes));
            return name;
        }
        let stored = format!("{name}h");
        let bytes: Vec<u8> = values.iter().flat_map(|value| half(*value).to_le_bytes()).collect();
        self.weights.message(5, &tensor(&stored, FLOAT16, shape, &bytes));
        self.add("Cast", &[&stored], &[("to", Attribute::Int(FLOAT))], &name);
        name
    }

    /// A constant list of whole numbers.
    pub(super) fn integers(&mut self, values: &[i64]) -> String {
        let name = self.fresh();
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        self.weights.message(5, &tensor(&name, INT64, &[values.len() as i64], &bytes));
        name
    }

    /// An operator with one result; an input that is left out is an empty name.
    pub(super) fn node(
        &mut self,
        operator: &str,
        inputs: &[&str],
        attributes: &[(&str, Attribute)],
    ) -> String {
        let name = self.fresh();
        self.add(operator, inputs, attributes, &name);
        name
    }

    /// The values limited to 0..=6.
    pub(super) fn relu6(&mut self, from: &str) -> String {
        let (low, high) = (self.weights(&[0.0], &[]), self.weights(&[6.0], &[]));
        self.node("Clip", &[from, &low, &high], &[])
    }

    /// The file.
    pub(super) fn finish(self, name: &str) -> Vec<u8> {
        let mut graph = self.nodes;
        graph.text(2, name);
        for part in [self.weights, self.inputs, self.outputs] {
            graph.0.extend(part.0);
        }
        let mut opset = Message::default();
        opset.text(1, "");
        opset.integer(2, OPSET);
        let mut model = Message::default();
        model.integer(1, IR_VERSION);
        model.text(2, "inkpanel");
        model.message(7, &graph);
        model.message(8, &opset);
        model.0
    }

    fn fresh(&mut self) -> String {
        self.count += 1;
        format!("t{}", self.count)
    }

    fn add(&mut self, operator: &str, inputs: &[&str], attributes: &[(&str, Attribute)], result: &str) {
        let mut node = Message::default();
        for input in inputs {
            node.text(1, input);
        }
        node.text(2, result);
        node.text(3, &format!("{result}n"));
        node.text(4, operator);
        for (name, value) in attributes {
            let mut attribute = Message::default();
            attribute.text(1, name);
            let kind = match value {
                Attribute::Int(value) => {
                    attribute.integer(3, *value);
                    2
                }
                Attribute::Text(value) => {
                    attribute.text(4, value);
                    3
                }
                Attribute::Ints(values) => {
                    values.iter().for_each(|value| attribute.integer(8, *value));
                    7
                }
            };
            attribute.integer(20, kind);
            node.message(5, &attribute);
        }
        self.nodes.message(1, &node);
    }
}

fn tensor(name: &str, kind: i64, shape: &[i64], bytes: &[u8]) -> Message {
    let mut tensor = Message::default();
    for side in shape {
        tensor.integer(1, *side);
    }
    tensor.integer(2, kind);
    tensor.text(8, name);
    tensor.bytes(9, bytes);
    tensor
}

fn value_info(name: &str, shape: &[i64]) -> Message {
    let mut dimensions = Message::default();
    for (i, side) in shape.iter().enumerate() {
        let mut dimension = Message::default();
        if *side < 0 {
            dimension.text(2, &format!("side{i}"));
        } else {
            dimension.integer(1, *side);
        }
        dimensions.message(1, &dimension);
    }
    let (mut tensor, mut kind, mut info) = (Message::default(), Message::default(), Message::default());
    tensor.integer(1, FLOAT);
    tensor.message(2, &dimensions);
    kind.message(1, &tensor);
    info.text(1, name);
    info.message(2, &kind);
    info
}

/// A protocol-buffer message: tags and values, one after the other.
#[derive(Default)]
struct Message(Vec<u8>);

impl Message {
    fn integer(&mut self, field: u64, value: i64) {
        self.number(field << 3);
        self.number(value as u64);
    }

    fn bytes(&mut self, field: u64, value: &[u8]) {
        self.number(field << 3 | 2);
        self.number(value.len() as u64);
        self.0.extend_from_slice(value);
    }

    fn text(&mut self, field: u64, value: &str) {
        self.bytes(field, value.as_bytes());
    }

    fn message(&mut self, field: u64, value: &Self) {
        self.bytes(field, &value.0);
    }

    /// Seven bits a byte, the lowest first.
    fn number(&mut self, mut value: u64) {
        while value >= 0x80 {
            self.0.push(value as u8 | 0x80);
            value >>= 7;
        }
        self.0.push(value as u8);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_texts_are_written_as_the_format_wants() {
        let mut message = Message::default();
        message.integer(1, 300);
        message.text(2, "ab");
        message.integer(20, -1);
        let mut expected = vec![0x08, 0xac, 0x02, 0x12, 2, b'a', b'b', 0xa0, 0x01];
        expected.extend([0xff; 9]);
        expected.push(1);
        assert_eq!(message.0, expected);
    }

    #[test]
    fn large_weights_take_two_bytes_a_value() {
        let size = |count: usize| {
            let mut graph = Graph::default();
            graph.weights(&vec![1.0; count], &[count as i64]);
            graph.finish("net").len()
        };
        assert!(size(1000) < 2200 && size(64) > 4 * 64);
        let mut graph = Graph { exact: true, ..Graph::default() };
        graph.weights(&[1.0; 1000], &[1000]);
        assert!(graph.finish("net").len() > 4000);
    }
}
