//! A model from an ONNX file, run by tract.

use std::collections::HashSet;
use std::io::Cursor;
use std::sync::Arc;

use tract_onnx::prelude::*;
use tract_onnx::tract_hir::tract_core::optim::Optimizer;

use super::operators;
use super::weights::unpacked;
use inkpanel_image::error::{Error, Result};

/// A model with one input `[1, 3, side, side]` and a known number of outputs.
pub(super) struct Net<const OUTPUTS: usize = 2> {
    plan: Arc<TypedRunnableModel>,
    steps: Arc<[Step]>,
    side: usize,
}

impl<const OUTPUTS: usize> Net<OUTPUTS> {
    /// Reads a model and prepares it for running.
    pub(super) fn new(onnx: &[u8], side: usize) -> Result<Self> {
        let shape = [1, 3, side, side];
        let reader = operators::reader();
        let plan = reader
            .proto_model_for_read(&mut Cursor::new(onnx))
            .and_then(|net| reader.model_for_proto_model(&unpacked(net)?))
            .and_then(|model| model.with_input_fact(0, f32::fact(shape).into()))
            .and_then(InferenceModelExt::into_typed)
            .and_then(optimised)
            .and_then(IntoRunnable::into_runnable)
            .map_err(|error| failed(&error))?;
        if plan.model().outputs.len() != OUTPUTS {
            return Err(Error::Detector("the file has another model".into()));
        }
        Ok(Self { steps: steps(&plan), plan, side })
    }

    /// Side of the square input in pixels.
    pub(super) fn side(&self) -> usize {
        self.side
    }

    /// The outputs as plain lists, in row-major order. `input` are three planes of `side * side` values.
    pub(super) fn run(&self, input: &[f32]) -> Result<[Vec<f32>; OUTPUTS]> {
        let mut run = self.begin(input)?;
        loop {
            if let Some(outputs) = run.advance()? {
                return Ok(outputs);
            }
        }
    }

    /// Begins a run in steps.
    pub(super) fn begin(&self, input: &[f32]) -> Result<Run<OUTPUTS>> {
        let begin = || -> TractResult<TypedSimpleState> {
            let input = Tensor::from_shape(&[1, 3, self.side, self.side], input)?;
            let mut state = self.plan.spawn()?;
            state.set_inputs(tvec!(input.into()))?;
            Ok(state)
        };
        let state = begin().map_err(|error| failed(&error))?;
        Ok(Run { state, steps: Arc::clone(&self.steps), next: 0 })
    }
}

/// A run of a model on one input. The caller can pause between steps while more urgent work needs the core.
pub(super) struct Run<const OUTPUTS: usize> {
    state: TypedSimpleState,
    steps: Arc<[Step]>,
    next: usize,
}

impl<const OUTPUTS: usize> Run<OUTPUTS> {
    /// Computes one operator. After the last one, returns the outputs of [`Net::run`].
    pub(super) fn advance(&mut self) -> Result<Option<[Vec<f32>; OUTPUTS]>> {
        self.computed().map_err(|error| failed(&error))
    }

    fn computed(&mut self) -> TractResult<Option<[Vec<f32>; OUTPUTS]>> {
        if let Some(Step { node, done }) = self.steps.get(self.next) {
            let inputs = self.state.prepare_inputs(*node)?;
            // An operator may overwrite an input that has no other owner.
            for node in done {
                self.state.turn_state.values[*node] = None;
            }
            self.state.compute_one_with_inputs(*node, inputs)?;
            self.next += 1;
        }
        if self.next < self.steps.len() {
            return Ok(None);
        }
        let mut lists = [const { Vec::new() }; OUTPUTS];
        for (list, output) in lists.iter_mut().zip(&self.state.outputs()?) {
            list.extend(output.to_plain_array_view::<f32>()?.iter().copied());
        }
        Ok(Some(lists))
    }
}

/// An operator, and the values that are not needed after it.
struct Step {
    node: usize,
    done: Vec<usize>,
}

/// Returns the order of operations of a model.
fn steps(plan: &TypedRunnableModel) -> Arc<[Step]> {
    let model = plan.model();
    let mut needed: HashSet<usize> = model.outputs.iter().map(|outlet| outlet.node).collect();
    // From the last on: who reads a value there is its last reader.
    let backwards = plan.order_without_consts().iter().rev().map(|node| {
        let inputs = model.node(*node).inputs.iter().map(|outlet| outlet.node);
        Step { node: *node, done: inputs.filter(|input| needed.insert(*input)).collect() }
    });
    let mut steps: Vec<Step> = backwards.collect();
    steps.reverse();
    steps.into()
}

/// Like `into_optimized`, with the same passes and the same plan, and an eighth of the axis changes. Reshaped
/// weights are folded before the passes that would visit them again.
fn optimised(mut model: TypedModel) -> TractResult<TypedModel> {
    /// tract folds constants first; here once more before pass `before`.
    fn folding_again(mut optimizer: Optimizer, before: usize) -> Optimizer {
        let fold = optimizer.passes[0].clone();
        optimizer.add_pass(before, fold);
        optimizer
    }
    // Before axes are changed, the last pass, and after operators were chosen.
    let (simplify, choose) = (Optimizer::declutter(), Optimizer::codegen());
    let axes = simplify.passes.len() - 1;
    folding_again(simplify, axes).optimize(&mut model)?;
    model.optimize_with_session(&mut folding_again(choose, 3).session())?;
    Ok(model)
}

/// tract returns a chain of errors; the root cause is the useful part.
fn failed(error: &TractError) -> Error {
    Error::Detector(error.root_cause().to_string())
}
