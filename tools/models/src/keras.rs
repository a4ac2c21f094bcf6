//! Converts the weights of a Keras `MobileNet` (HDF5, one group per layer) to ONNX: the model that rates how
//! good a picture looks. The file has only weights, so the layers are defined here. Batch normalisation is
//! folded into them.
//!
//! A. Howard et al., "`MobileNets`: Efficient Convolutional Neural Networks for Mobile Vision Applications" (2017);
//! H. Talebi, P. Milanfar, "NIMA: Neural Image Assessment" (2018).

use anyhow::{Context, Result, ensure};
use hdf5_reader::Hdf5File;

use super::fold::Open;
use super::net::{self, Constant, Padding, Tensor, Window, long, transposed};
use super::onnx::Graph;

/// Side of the square input in pixels.
const SIDE: usize = 224;
/// Pairs of a depthwise and a pointwise convolution.
const PAIRS: usize = 13;
/// Layers that halve the sides.
const HALVING: [usize; 4] = [2, 4, 6, 12];
/// Value that Keras adds to the variances of this model.
const EPSILON: f32 = 1e-3;

/// Converts the weights. The input is named `image` (NCHW); the output `scores` has one logit for each of the scores
/// from 1 to 10.
pub(super) fn convert(hdf5: Vec<u8>) -> Result<Vec<u8>> {
    let mut net = MobileNet {
        file: Hdf5File::from_vec(hdf5).context("the weights are no HDF5 file")?,
        graph: Graph::default(),
    };
    let name = net.graph.input("image", &long(&[1, 3, SIDE, SIDE]));
    let image = Tensor { name, shape: vec![1, SIDE, SIDE, 3] };
    // Height, width, in, out becomes out, in, height, width; a depthwise kernel has one weight for each input, last.
    let mut last = net.layer(&image, "conv1", "kernel", [3, 2, 0, 1], 2)?;
    for pair in 1..=PAIRS {
        let stride = if HALVING.contains(&pair) { 2 } else { 1 };
        let name = format!("conv_dw_{pair}");
        last = net.layer(&last, &name, "depthwise_kernel", [2, 3, 0, 1], stride)?;
        last = net.layer(&last, &format!("conv_pw_{pair}"), "kernel", [3, 2, 0, 1], 1)?;
    }
    let scores = net.head(&last)?;
    net.graph.output(&scores.name, "scores", &long(&scores.shape));
    Ok(net.graph.finish("aesthetics"))
}

struct MobileNet {
    file: Hdf5File,
    graph: Graph,
}

impl MobileNet {
    /// A convolution, its batch normalisation and the limit to 0..=6.
    fn layer(
        &mut self,
        from: &Tensor,
        name: &str,
        kernel: &str,
        order: [usize; 4],
        stride: usize,
    ) -> Result<Tensor> {
        let weights = transposed(&self.read(name, kernel)?, order)?;
        let size = [weights.shape[2], weights.shape[3]];
        // This model was trained with equal padding before and after, unlike the default of Keras.
        let window = Window { size, stride: [stride; 2], dilation: [1; 2], padding: Padding::Around };
        let mut layer = Open { from: from.clone(), weights, bias: None, window };
        let norm = format!("{name}_bn");
        let [gamma, beta, mean, variance] =
            ["gamma", "beta", "moving_mean", "moving_variance"].map(|part| self.read(&norm, part));
        let variance = variance?.values;
        let scale: Vec<f32> =
            gamma?.values.iter().zip(&variance).map(|(gamma, v)| gamma / (v + EPSILON).sqrt()).collect();
        let shift: Vec<f32> = (beta?.values.iter().zip(mean?.values).zip(&scale))
            .map(|((beta, mean), scale)| beta - mean * scale)
            .collect();
        layer.scale(&scale)?;
        layer.shift(&shift)?;
        // The depthwise kernels are few, and folding makes their values so unequal that half precision shows.
        self.graph.exact = kernel == "depthwise_kernel";
        let Tensor { name, shape } = layer.write(&mut self.graph)?;
        self.graph.exact = false;
        Ok(Tensor { name: self.graph.relu6(&name), shape })
    }

    /// The mean of each channel, and from these a logit for each score: a dense layer, which is a convolution of one
    /// pixel.
    fn head(&mut self, from: &Tensor) -> Result<Tensor> {
        let channels = from.shape[3];
        let name = self.graph.node("GlobalAveragePool", &[&from.name], &[]);
        let means = Tensor { name, shape: vec![1, 1, 1, channels] };
        let (kernel, bias) = (self.read("dense_1", "kernel")?, self.read("dense_1", "bias")?);
        let [inputs, scores] = kernel.shape[..] else {
            anyhow::bail!("a dense layer of shape {:?}", kernel.shape);
        };
        ensure!(inputs == channels, "a dense layer for {inputs} channels of {channels}");
        let kernel = Constant { values: kernel.values, shape: vec![1, 1, inputs, scores] };
        let weights = transposed(&kernel, [3, 2, 0, 1])?;
        let window = Window { size: [1; 2], stride: [1; 2], dilation: [1; 2], padding: Padding::Valid };
        let logits = net::convolution(&mut self.graph, &means, &weights, Some(&bias.values), window)?;
        let wanted = self.graph.integers(&[1, scores as i64]);
        let name = self.graph.node("Reshape", &[&logits.name, &wanted], &[]);
        Ok(Tensor { name, shape: vec![1, scores] })
    }

    /// A layer's weights by their name in it. Keras repeats the layer's name.
    fn read(&self, layer: &str, name: &str) -> Result<Constant> {
        let path = format!("{layer}/{layer}/{name}:0");
        let dataset = self.file.dataset(&path).with_context(|| format!("no {path}"))?;
        let array = dataset.read_array::<f32>().with_context(|| format!("cannot read {path}"))?;
        Ok(Constant { shape: array.shape().to_vec(), values: array.iter().copied().collect() })
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn other_files_are_refused() {
        for bytes in [&b""[..], b"no weights", &[0x89, b'H', b'D', b'F', 13, 10, 26, 10, 0, 0]] {
            let error = super::convert(bytes.to_vec()).unwrap_err().to_string();
            assert_eq!(error, "the weights are no HDF5 file");
        }
    }
}
