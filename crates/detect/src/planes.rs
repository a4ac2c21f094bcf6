//! Custom operators from planes to planes.

use std::fmt::Debug;
use std::sync::Arc;

#[allow(clippy::wildcard_imports, reason = "tract means it as a prelude for operators")]
use tract_onnx::tract_hir::internal::*;

/// The computation of such an operator.
pub(super) trait Work: Debug + Send + Sync + 'static {
    const NAME: &'static str;

    /// Number, height and width of the output planes for these input planes.
    fn shape(&self, input: [usize; 3]) -> [usize; 3];

    /// Planes in sequence, row by row; `sides` are height and width of the input.
    fn run(&self, input: &[f32], sides: (usize, usize)) -> Vec<f32>;
}

/// Adds an operator to a model.
pub(super) fn wire(
    work: impl Work,
    name: &str,
    model: &mut TypedModel,
    input: OutletId,
) -> TractResult<TVec<OutletId>> {
    model.wire_node(name, OfPlanes(Arc::new(work)), &[input])
}

#[derive(Debug)]
struct OfPlanes<W>(Arc<W>);

impl<W> Clone for OfPlanes<W> {
    fn clone(&self) -> Self {
        Self(Arc::clone(&self.0))
    }
}

impl<W> PartialEq for OfPlanes<W> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl<W> Eq for OfPlanes<W> {}

impl<W: Work> Op for OfPlanes<W> {
    fn name(&self) -> StaticName {
        W::NAME.into()
    }

    op_as_typed_op!();
}

impl<W: Work> EvalOp for OfPlanes<W> {
    op_out_of_plan!();

    fn eval(&self, _: &EvalContext, inputs: TVec<TValue>) -> TractResult<TVec<TValue>> {
        let input = args_1!(inputs);
        let sides = sides(input.shape())?;
        let [channels, height, width] = self.0.shape(sides);
        let output = self.0.run(input.try_as_plain_ram()?.as_slice()?, (sides[1], sides[2]));
        let planes = tract_ndarray::Array4::from_shape_vec((1, channels, height, width), output)?;
        Ok(tvec!(planes.into_tvalue()))
    }
}

impl<W: Work> TypedOp for OfPlanes<W> {
    fn output_facts(&self, inputs: &[&TypedFact]) -> TractResult<TVec<TypedFact>> {
        let shape = inputs[0].shape.as_concrete().context("planes of unknown size")?;
        let [channels, height, width] = self.0.shape(sides(shape)?);
        Ok(tvec!(f32::fact([1, channels, height, width])))
    }

    as_op!();
}

/// Planes, height and width of a single image.
fn sides(shape: &[usize]) -> TractResult<[usize; 3]> {
    let &[1, channels, height, width] = shape else { bail!("planes were expected, not {shape:?}") };
    Ok([channels, height, width])
}
