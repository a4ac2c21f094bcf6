//! The operators of the models. A full ONNX registry would add all operators to the wasm module.

use tract_onnx::Onnx;
use tract_onnx::model::{OnnxOpRegister, ParsingContext};
use tract_onnx::pb::NodeProto;
#[allow(clippy::wildcard_imports, reason = "tract means it as a prelude for operators")]
use tract_onnx::tract_hir::internal::*;
use tract_onnx::tract_hir::ops::cnn::{Conv, HirMaxPool, PaddingSpec, PoolSpec};
use tract_onnx::tract_hir::ops::identity::Identity;
use tract_onnx::tract_hir::ops::nn::{DataFormat, GlobalAvgPool};
use tract_onnx::tract_hir::ops::{activations, array, math};
use tract_onnx::tract_hir::tract_core::ops::change_axes::to_axis_ops_with_onnx_rules;

use super::constants::constant;
use super::enlarge::Enlarge;
use super::prelu::PRelu;
use super::winograd::Convolution;

type Built = TractResult<(Box<dyn InferenceOp>, Vec<String>)>;

/// Returns a reader of ONNX files with these operators.
pub(super) fn reader() -> Onnx {
    let mut known = OnnxOpRegister::default();
    known.insert("Add", |_, _| built(math::Add.into_hir()));
    known.insert("Clip", |_, _| built(expand(Clip)));
    known.insert("Concat", |_, node| built(expand(array::Concat::new(node.get_attr("axis")?))));
    known.insert("Conv", convolution);
    known.insert("GlobalAveragePool", |_, _| built(expand(GlobalAvgPool)));
    known.insert("Identity", |_, _| built(Box::<Identity>::default()));
    known.insert("MaxPool", max_pool);
    known.insert("Pad", |_, _| built(expand(Pad)));
    known.insert("PRelu", |_, _| built(expand(PRelu)));
    known.insert("Relu", |_, _| built(expand(activations::Clip::new(Some(0.0), None))));
    known.insert("Reshape", |_, _| built(expand(Reshape)));
    known.insert("Resize", |_, node| built(expand(Enlarge::read(node)?)));
    known.insert("Transpose", |_, node| {
        let order: Vec<usize> = node.get_attr_vec("perm")?;
        built(expand(array::PermuteAxes::new(Some(order.into()))))
    });
    Onnx { op_register: known, ..Onnx::default() }
}

#[allow(clippy::unnecessary_wraps, reason = "it is what every builder answers")]
fn built(operator: Box<dyn InferenceOp>) -> Built {
    Ok((operator, Vec::new()))
}

fn padding(node: &NodeProto) -> TractResult<PaddingSpec> {
    let pads: TVec<usize> = node.get_attr_tvec("pads")?;
    let (before, after) = pads.split_at(pads.len() / 2);
    Ok(PaddingSpec::Explicit(before.into(), after.into()))
}

fn convolution(_: &ParsingContext, node: &NodeProto) -> Built {
    let mut operator = Conv::default()
        .padding(padding(node)?)
        .kernel_shape(node.get_attr_tvec("kernel_shape")?)
        .group(node.get_attr("group")?)
        .dilations(node.get_attr_tvec("dilations")?)
        .strides(node.get_attr_tvec("strides")?);
    if node.input.len() == 3 {
        operator = operator.bias_input(2);
    }
    built(expand(Convolution(operator)))
}

fn max_pool(_: &ParsingContext, node: &NodeProto) -> Built {
    let (size, strides) = (node.get_attr_tvec("kernel_shape")?, node.get_attr_tvec("strides")?);
    let pool = PoolSpec::new(DataFormat::NCHW, size, padding(node)?, None, Some(strides), 0, 0);
    built(expand(HirMaxPool::new(pool, None)))
}

/// Limits by two constants.
#[derive(Debug, Clone)]
struct Clip;

impl Expansion for Clip {
    fn name(&self) -> StaticName {
        "Clip".into()
    }

    fn rules<'r, 'p: 'r, 's: 'r>(
        &'s self,
        s: &mut Solver<'r>,
        inputs: &'p [TensorProxy],
        outputs: &'p [TensorProxy],
    ) -> InferenceResult {
        check_input_arity(inputs, 3)?;
        s.equals(&inputs[0].datum_type, &outputs[0].datum_type)?;
        s.equals(&inputs[0].shape, &outputs[0].shape)
    }

    fn wire(&self, name: &str, model: &mut TypedModel, inputs: &[OutletId]) -> TractResult<TVec<OutletId>> {
        let limit = |i: usize| constant(model, inputs[i])?.try_as_plain_ram()?.to_scalar::<f32>().copied();
        let (low, high) = (limit(1)?, limit(2)?);
        activations::Clip::new(Some(low), Some(high)).wire(name, model, &inputs[..1])
    }
}

/// Zero padding of a tensor, with sizes in a constant.
#[derive(Debug, Clone)]
struct Pad;

impl Expansion for Pad {
    fn name(&self) -> StaticName {
        "Pad".into()
    }

    fn rules<'r, 'p: 'r, 's: 'r>(
        &'s self,
        s: &mut Solver<'r>,
        inputs: &'p [TensorProxy],
        outputs: &'p [TensorProxy],
    ) -> InferenceResult {
        check_input_arity(inputs, 2)?;
        s.equals(&inputs[0].datum_type, &outputs[0].datum_type)?;
        s.equals(&inputs[0].rank, &outputs[0].rank)?;
        s.given(&inputs[1].value, move |s, amounts| {
            for (axis, (before, after)) in pairs(&amounts)?.into_iter().enumerate() {
                let grown = inputs[0].shape[axis].bex() + (before + after).to_dim();
                s.equals(&outputs[0].shape[axis], grown)?;
            }
            Ok(())
        })
    }

    fn wire(&self, name: &str, model: &mut TypedModel, inputs: &[OutletId]) -> TractResult<TVec<OutletId>> {
        let amounts = pairs(&*constant(model, inputs[1])?)?;
        let zero = array::PadMode::Constant(Arc::new(0f32.into()));
        model.wire_node(name, array::Pad::new(amounts, zero), &inputs[..1])
    }
}

/// A reshape with a constant shape. tract's own operator converts between all number types, and would take
/// longer to compile in the browser than any other function of the module.
#[derive(Debug, Clone)]
struct Reshape;

impl Expansion for Reshape {
    fn name(&self) -> StaticName {
        "Reshape".into()
    }

    fn rules<'r, 'p: 'r, 's: 'r>(
        &'s self,
        s: &mut Solver<'r>,
        inputs: &'p [TensorProxy],
        outputs: &'p [TensorProxy],
    ) -> InferenceResult {
        check_input_arity(inputs, 2)?;
        s.equals(&inputs[0].datum_type, &outputs[0].datum_type)?;
        s.given(&inputs[1].value, move |s, sides| {
            s.equals(&outputs[0].shape, ShapeFactoid::from(dimensions(&sides)?))
        })
    }

    fn wire(&self, name: &str, model: &mut TypedModel, inputs: &[OutletId]) -> TractResult<TVec<OutletId>> {
        let from = model.outlet_fact(inputs[0])?.shape.to_tvec();
        let to = dimensions(&*constant(model, inputs[1])?)?;
        let mut wire = tvec!(inputs[0]);
        for (i, step) in to_axis_ops_with_onnx_rules(&from, &to, false)?.into_iter().enumerate() {
            wire = model.wire_node(format!("{name}.{i}"), step, &wire)?;
        }
        Ok(wire)
    }
}

fn dimensions(sides: &Tensor) -> TractResult<TVec<TDim>> {
    Ok(integers(sides)?.iter().map(ToDim::to_dim).collect())
}

/// Before and after each axis, from all befores and then all afters.
fn pairs(amounts: &Tensor) -> TractResult<Vec<(usize, usize)>> {
    let list = integers(amounts)?;
    let (before, after) = list.split_at(list.len() / 2);
    Ok(before.iter().zip(after).map(|(before, after)| (*before as usize, *after as usize)).collect())
}

/// Reads integers in the types of the bundled models.
fn integers(list: &Tensor) -> TractResult<&[i64]> {
    list.try_as_plain_ram()?.as_slice()
}
