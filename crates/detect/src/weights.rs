//! Converts weights from half precision, as in the model files, to single precision.

use std::collections::HashMap;

use tract_onnx::pb::tensor_proto::DataType;
use tract_onnx::pb::{ModelProto, TensorProto};
use tract_onnx::prelude::TractResult;
use tract_onnx::tract_hir::internal::bail;

/// Returns the model with each `Cast` of half-precision weights replaced by weights in single precision.
/// Nearly half of a model's operators are such casts. The time in which tract prepares a model grows faster
/// than the number of operators.
pub(super) fn unpacked(mut net: ModelProto) -> TractResult<ModelProto> {
    let Some(graph) = &mut net.graph else { bail!("a model without a graph") };
    let mut casts: HashMap<String, String> = HashMap::new();
    graph.node.retain(|node| {
        let cast = node.op_type == "Cast";
        if let (true, [from], [to]) = (cast, &node.input[..], &node.output[..]) {
            casts.insert(from.clone(), to.clone());
        }
        !cast
    });
    for weights in &mut graph.initializer {
        if let Some(name) = casts.remove(&weights.name) {
            single(weights);
            weights.name = name;
        }
    }
    Ok(net)
}

fn single(weights: &mut TensorProto) {
    let (halves, _) = weights.raw_data.as_chunks::<2>();
    weights.raw_data =
        halves.iter().flat_map(|bytes| whole(u16::from_le_bytes(*bytes)).to_le_bytes()).collect();
    weights.data_type = DataType::Float as i32;
}

/// The number of a half's bits, which is finite: the exponent's place is moved, and its offset corrected by a factor,
/// which is right for the numbers below the normal range too.
fn whole(bits: u16) -> f32 {
    let magnitude = f32::from_bits(u32::from(bits & 0x7fff) << 13) * f32::from_bits((254 - 15) << 23);
    f32::from_bits(magnitude.to_bits() | u32::from(bits & 0x8000) << 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_finite_half_is_the_number_that_its_bits_say() {
        for bits in (0..=u16::MAX).filter(|bits| bits >> 10 & 31 < 31) {
            let (exponent, fraction) = (i32::from(bits >> 10 & 31), f64::from(bits & 0x3ff) / 1024.0);
            let magnitude = match exponent {
                0 => fraction * 2f64.powi(-14),
                _ => (1.0 + fraction) * 2f64.powi(exponent - 15),
            };
            let expected = if bits >> 15 == 0 { magnitude } else { -magnitude };
            assert_eq!(f64::from(whole(bits)).to_bits(), expected.to_bits(), "{bits:04x}");
        }
    }
}
