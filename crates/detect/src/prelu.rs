//! Rectifier with a slope for the negative values of each channel.

#[allow(clippy::wildcard_imports, reason = "tract means it as a prelude for operators")]
use tract_onnx::tract_hir::internal::*;

use super::constants::constant;
use super::planes::{self, Work};

/// The operator of ONNX, with slopes in a constant.
#[derive(Debug, Clone)]
pub(super) struct PRelu;

impl Expansion for PRelu {
    fn name(&self) -> StaticName {
        Slopes::NAME.into()
    }

    fn rules<'r, 'p: 'r, 's: 'r>(
        &'s self,
        s: &mut Solver<'r>,
        inputs: &'p [TensorProxy],
        outputs: &'p [TensorProxy],
    ) -> InferenceResult {
        check_input_arity(inputs, 2)?;
        s.equals(&inputs[0].datum_type, &outputs[0].datum_type)?;
        s.equals(&inputs[0].shape, &outputs[0].shape)
    }

    fn wire(&self, name: &str, model: &mut TypedModel, inputs: &[OutletId]) -> TractResult<TVec<OutletId>> {
        let slopes = constant(model, inputs[1])?.try_as_plain_ram()?.as_slice()?.to_vec();
        planes::wire(Slopes(slopes), name, model, inputs[0])
    }
}

/// One slope per channel.
#[derive(Debug)]
struct Slopes(Vec<f32>);

impl Work for Slopes {
    const NAME: &'static str = "PRelu";

    fn shape(&self, input: [usize; 3]) -> [usize; 3] {
        input
    }

    fn run(&self, input: &[f32], (height, width): (usize, usize)) -> Vec<f32> {
        let mut output = Vec::with_capacity(input.len());
        for (plane, slope) in input.chunks_exact(height * width).zip(&self.0) {
            output.extend(plane.iter().map(|value| if *value < 0.0 { slope * value } else { *value }));
        }
        output
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_negative_values_are_multiplied_by_the_slope_of_their_channel() {
        let output = Slopes(vec![0.5, -2.0]).run(&[1.0, -1.0, 0.0, -4.0], (1, 2));
        assert_eq!(output, [1.0, -0.5, 0.0, 8.0]);
    }
}
