//! Convolutions that absorb following constants.

use anyhow::{Result, ensure};

use super::net::{self, Constant, Tensor, Window};
use super::onnx::Graph;

/// A convolution that may still absorb following operators.
#[derive(Clone, Debug)]
pub(super) struct Open {
    pub(super) from: Tensor,
    /// In ONNX's order.
    pub(super) weights: Constant,
    pub(super) bias: Option<Vec<f32>>,
    pub(super) window: Window,
}

impl Open {
    /// Multiplies each result channel (or all by one number).
    pub(super) fn scale(&mut self, by: &[f32]) -> Result<()> {
        let (channels, each) = self.channels(by.len())?;
        for channel in 0..channels {
            let by = by[channel % by.len()];
            self.weights.values[channel * each..(channel + 1) * each].iter_mut().for_each(|w| *w *= by);
            if let Some(bias) = &mut self.bias {
                bias[channel] *= by;
            }
        }
        Ok(())
    }

    /// Adds a value to each result channel. A single value applies to all channels.
    pub(super) fn shift(&mut self, by: &[f32]) -> Result<()> {
        let (channels, _) = self.channels(by.len())?;
        let bias = self.bias.get_or_insert_with(|| vec![0.0; channels]);
        bias.iter_mut().enumerate().for_each(|(channel, value)| *value += by[channel % by.len()]);
        Ok(())
    }

    /// The number of result channels, and of the weights of each.
    fn channels(&self, given: usize) -> Result<(usize, usize)> {
        let channels = self.weights.shape[0];
        ensure!(given == 1 || given == channels, "{given} values for {channels} channels");
        Ok((channels, self.weights.values.len() / channels))
    }

    /// Adds it to the graph in its current form.
    pub(super) fn write(&self, graph: &mut Graph) -> Result<Tensor> {
        net::convolution(graph, &self.from, &self.weights, self.bias.as_deref(), self.window)
    }
}

#[cfg(test)]
mod tests {
    use super::super::net::Padding;
    use super::*;

    #[test]
    fn what_is_folded_acts_on_its_channel_alone() {
        let window = Window { size: [1, 1], stride: [1, 1], dilation: [1, 1], padding: Padding::Same };
        let from = Tensor { name: "x".into(), shape: vec![1, 4, 4, 2] };
        let weights = Constant { values: vec![1.0, 2.0, 3.0, 4.0], shape: vec![2, 2, 1, 1] };
        let mut open = Open { from, weights, bias: None, window };
        open.scale(&[2.0, 10.0]).unwrap();
        open.shift(&[1.0, -1.0]).unwrap();
        open.scale(&[3.0]).unwrap();
        assert_eq!(open.weights.values, [6.0, 12.0, 90.0, 120.0]);
        assert_eq!(open.bias, Some(vec![3.0, -3.0]));
        assert!(open.scale(&[1.0, 2.0, 3.0]).is_err());
    }
}
