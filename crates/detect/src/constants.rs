//! Constant inputs of operators.

#[allow(clippy::wildcard_imports, reason = "tract means it as a prelude for operators")]
use tract_onnx::tract_hir::internal::*;

/// The constant that an input is.
pub(super) fn constant(model: &TypedModel, input: OutletId) -> TractResult<Arc<Tensor>> {
    model.outlet_fact(input)?.konst.clone().context("an input that should be constant is not")
}
