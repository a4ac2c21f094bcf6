//! Operators that both source formats have, on tensors whose logical order is NHWC and whose order in the file is
//! NCHW (four dimensions) or the logical one (fewer).

use anyhow::{Result, ensure};

use super::onnx::{Attribute, Graph};

/// A result in the graph.
#[derive(Clone, Debug)]
pub(super) struct Tensor {
    /// Its name in the file.
    pub(super) name: String,
    /// Batch, height, width, channels; or any fewer dimensions.
    pub(super) shape: Vec<usize>,
}

/// A constant, in its source's order.
#[derive(Clone, Debug)]
pub(super) struct Constant {
    pub(super) values: Vec<f32>,
    pub(super) shape: Vec<usize>,
}

/// How the edges of a convolution are treated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Padding {
    /// As many results as strides fit into the input, the odd pixel of padding at the end.
    Same,
    /// No padding.
    Valid,
    /// Equal padding before and after: the window is centred on the first pixel of every stride.
    Around,
}

/// A window that slides: height before width.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    pub(super) size: [usize; 2],
    pub(super) stride: [usize; 2],
    pub(super) dilation: [usize; 2],
    pub(super) padding: Padding,
}

impl Window {
    /// Padding before and after, and the size of the result, along one axis.
    fn along(&self, axis: usize, input: usize) -> Result<(usize, usize, usize)> {
        let (stride, reach) = (self.stride[axis], (self.size[axis] - 1) * self.dilation[axis] + 1);
        ensure!(stride > 0, "a stride of 0");
        let padding = match self.padding {
            Padding::Same => ((input.div_ceil(stride) - 1) * stride + reach).saturating_sub(input),
            Padding::Valid => 0,
            Padding::Around => reach / 2 * 2,
        };
        ensure!(input + padding >= reach, "a window of {reach} on {input} values");
        Ok((padding / 2, padding - padding / 2, (input + padding - reach) / stride + 1))
    }

    /// The paddings in ONNX's order, and the result's height and width.
    fn on(&self, shape: &[usize]) -> Result<([i64; 4], [usize; 2])> {
        ensure!(shape.len() == 4, "a window slides over four dimensions, not {shape:?}");
        let (top, bottom, height) = self.along(0, shape[1])?;
        let (left, right, width) = self.along(1, shape[2])?;
        Ok(([top, left, bottom, right].map(|side| side as i64), [height, width]))
    }
}

/// A convolution: `weights` in ONNX's order (out, in over groups, height, width) with their shape, one bias for
/// each result channel.
pub(super) fn convolution(
    graph: &mut Graph,
    from: &Tensor,
    weights: &Constant,
    bias: Option<&[f32]>,
    window: Window,
) -> Result<Tensor> {
    let (pads, [height, width]) = window.on(&from.shape)?;
    let [out, per_group] = [weights.shape[0], weights.shape[1]];
    ensure!(from.shape[3].is_multiple_of(per_group), "{per_group} channels a group of {}", from.shape[3]);
    let name = graph.weights(&weights.values, &long(&weights.shape));
    let mut inputs = vec![from.name.clone(), name];
    if let Some(bias) = bias {
        inputs.push(graph.weights(bias, &[out as i64]));
    }
    let inputs: Vec<&str> = inputs.iter().map(String::as_str).collect();
    let name = graph.node(
        "Conv",
        &inputs,
        &[
            ("pads", Attribute::Ints(&pads)),
            ("strides", Attribute::Ints(&long(&window.stride))),
            ("dilations", Attribute::Ints(&long(&window.dilation))),
            ("group", Attribute::Int((from.shape[3] / per_group) as i64)),
            ("kernel_shape", Attribute::Ints(&long(&window.size))),
        ],
    );
    Ok(Tensor { name, shape: vec![from.shape[0], height, width, out] })
}

/// The largest value of each window.
pub(super) fn max_pool(graph: &mut Graph, from: &Tensor, window: Window) -> Result<Tensor> {
    let (pads, [height, width]) = window.on(&from.shape)?;
    let attributes = [
        ("kernel_shape", Attribute::Ints(&long(&window.size))),
        ("strides", Attribute::Ints(&long(&window.stride))),
        ("pads", Attribute::Ints(&pads)),
    ];
    let name = graph.node("MaxPool", &[&from.name], &attributes);
    Ok(Tensor { name, shape: vec![from.shape[0], height, width, from.shape[3]] })
}

/// The sum of two tensors of one shape.
pub(super) fn sum(graph: &mut Graph, a: &Tensor, b: &Tensor) -> Result<Tensor> {
    ensure!(a.shape == b.shape, "a sum of {:?} and {:?}", a.shape, b.shape);
    Ok(Tensor { name: graph.node("Add", &[&a.name, &b.name], &[]), shape: a.shape.clone() })
}

/// The values, with negative ones multiplied by the slope of their channel.
pub(super) fn prelu(graph: &mut Graph, from: &Tensor, slopes: &Constant) -> Result<Tensor> {
    let channels = from.shape.last().copied().unwrap_or_default();
    ensure!(
        from.shape.len() == 4 && slopes.values.len() == channels && slopes.shape.last() == Some(&channels),
        "slopes of shape {:?} for {:?}",
        slopes.shape,
        from.shape
    );
    let slopes = graph.weights(&slopes.values, &[channels as i64, 1, 1]);
    Ok(Tensor { name: graph.node("PRelu", &[&from.name, &slopes], &[]), ..from.clone() })
}

/// The same values in another logical shape.
pub(super) fn reshape(graph: &mut Graph, from: &Tensor, shape: Vec<usize>) -> Result<Tensor> {
    let (has, wants): (usize, usize) = (from.shape.iter().product(), shape.iter().product());
    ensure!(has == wants, "{:?} cannot become {shape:?}", from.shape);
    ensure!(shape.len() < 4, "a reshape to {shape:?}");
    let mut name = from.name.clone();
    if from.shape.len() == 4 {
        name = graph.node("Transpose", &[&name], &[("perm", Attribute::Ints(&[0, 2, 3, 1]))]);
    }
    let wanted = graph.integers(&long(&shape));
    Ok(Tensor { name: graph.node("Reshape", &[&name, &wanted], &[]), shape })
}

/// The order of sides in the file.
pub(super) fn stored(shape: &[usize]) -> Vec<usize> {
    match *shape {
        [batch, height, width, channels] => vec![batch, channels, height, width],
        _ => shape.to_vec(),
    }
}

/// Sizes in the type of the file format.
pub(super) fn long(sizes: &[usize]) -> Vec<i64> {
    sizes.iter().map(|size| *size as i64).collect()
}

/// A constant of four dimensions in another order: axis `i` of the result is axis `order[i]` of the source.
pub(super) fn transposed(constant: &Constant, order: [usize; 4]) -> Result<Constant> {
    let Ok(shape) = <[usize; 4]>::try_from(constant.shape.as_slice()) else {
        anyhow::bail!("weights of shape {:?}", constant.shape);
    };
    let steps = [shape[1] * shape[2] * shape[3], shape[2] * shape[3], shape[3], 1];
    let (sides, steps) = (order.map(|axis| shape[axis]), order.map(|axis| steps[axis]));
    let mut values = Vec::with_capacity(constant.values.len());
    for a in 0..sides[0] {
        for b in 0..sides[1] {
            for c in 0..sides[2] {
                let start = a * steps[0] + b * steps[1] + c * steps[2];
                values.extend((0..sides[3]).map(|d| constant.values[start + d * steps[3]]));
            }
        }
    }
    Ok(Constant { values, shape: sides.to_vec() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn padding_is_split_with_the_odd_pixel_at_the_end() {
        let window = |padding| Window { size: [3, 3], stride: [2, 2], dilation: [1, 1], padding };
        let (pads, size) = window(Padding::Same).on(&[1, 300, 19, 3]).unwrap();
        assert_eq!((pads, size), ([0, 1, 1, 1], [150, 10]));
        let (pads, size) = window(Padding::Valid).on(&[1, 300, 19, 3]).unwrap();
        assert_eq!((pads, size), ([0; 4], [149, 9]));
        let (pads, size) = window(Padding::Around).on(&[1, 300, 19, 3]).unwrap();
        assert_eq!((pads, size), ([1; 4], [150, 10]));
    }

    #[test]
    fn each_channel_has_one_slope() {
        let from = Tensor { name: "x".into(), shape: vec![1, 4, 5, 2] };
        let slopes = |count: usize| Constant { values: vec![0.5; count], shape: vec![1, 1, count] };
        let mut graph = Graph::default();
        assert_eq!(prelu(&mut graph, &from, &slopes(2)).unwrap().shape, from.shape);
        assert!(prelu(&mut graph, &from, &slopes(5)).is_err());
        assert_eq!(stored(&from.shape), [1, 2, 4, 5]);
    }

    #[test]
    fn transposing_moves_values_with_their_axes() {
        let constant = Constant { values: (0..24).map(|v| v as f32).collect(), shape: vec![1, 2, 3, 4] };
        let turned = transposed(&constant, [3, 2, 0, 1]).unwrap();
        assert_eq!(turned.shape, [4, 3, 1, 2]);
        assert_eq!(&turned.values[..4], [0.0, 12.0, 4.0, 16.0]);
        assert_eq!(&turned.values[6..7], [1.0]);
    }
}
