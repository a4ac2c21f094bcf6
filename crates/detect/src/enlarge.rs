//! Bilinear enlargement of planes by integer factors, with aligned pixel centres (ONNX: `linear`,
//! `half_pixel`). The general resize operator of tract uses tables of values. It took a third of the time of subject detection.

use tract_onnx::pb::NodeProto;
#[allow(clippy::wildcard_imports, reason = "tract means it as a prelude for operators")]
use tract_onnx::tract_hir::internal::*;

use super::constants::constant;
use super::planes::{self, Work};

/// Upscaling by factors in a constant.
#[derive(Debug, Clone)]
pub(super) struct Enlarge;

impl Enlarge {
    /// # Errors
    /// For any other way of resizing.
    pub(super) fn read(node: &NodeProto) -> TractResult<Self> {
        let attribute = |name: &str| node.get_attr::<String>(name);
        let (mode, places) = (attribute("mode")?, attribute("coordinate_transformation_mode")?);
        ensure!((mode.as_str(), places.as_str()) == ("linear", "half_pixel"), "resizing by {mode}, {places}");
        Ok(Self)
    }
}

impl Expansion for Enlarge {
    fn name(&self) -> StaticName {
        "Enlarge".into()
    }

    fn rules<'r, 'p: 'r, 's: 'r>(
        &'s self,
        s: &mut Solver<'r>,
        inputs: &'p [TensorProxy],
        outputs: &'p [TensorProxy],
    ) -> InferenceResult {
        // tract leaves out the optional one between them.
        check_input_arity(inputs, 2)?;
        s.equals(&inputs[0].datum_type, &outputs[0].datum_type)?;
        s.equals(&inputs[0].rank, 4)?;
        s.equals(&outputs[0].rank, 4)?;
        s.given(&inputs[1].value, move |s, scales| {
            let [down, across] = factors(&scales)?;
            for (axis, factor) in [1, 1, down, across].into_iter().enumerate() {
                s.equals(&outputs[0].shape[axis], factor as i64 * inputs[0].shape[axis].bex())?;
            }
            Ok(())
        })
    }

    fn wire(&self, name: &str, model: &mut TypedModel, inputs: &[OutletId]) -> TractResult<TVec<OutletId>> {
        let factors = factors(&*constant(model, inputs[1])?)?;
        planes::wire(Enlarged { factors }, name, model, inputs[0])
    }
}

/// Factors of the height and the width.
fn factors(scales: &Tensor) -> TractResult<[usize; 2]> {
    match scales.try_as_plain_ram()?.as_slice::<f32>()? {
        [1.0, 1.0, down, across]
            if [down, across].iter().all(|&&factor| factor >= 1.0 && factor.fract() == 0.0) =>
        {
            Ok([*down as usize, *across as usize])
        }
        other => bail!("resizing by {other:?}"),
    }
}

/// Upscaling by known factors.
#[derive(Debug)]
struct Enlarged {
    factors: [usize; 2],
}

impl Work for Enlarged {
    const NAME: &'static str = "Enlarge";

    fn shape(&self, [channels, height, width]: [usize; 3]) -> [usize; 3] {
        let [down, across] = self.factors;
        [channels, down * height, across * width]
    }

    fn run(&self, input: &[f32], sides: (usize, usize)) -> Vec<f32> {
        enlarged(input, sides, self.factors)
    }
}

/// Interpolation of a position on an enlarged line: the pixels before and after it, and the weight of the
/// second.
struct Between {
    pixels: [usize; 2],
    share: f32,
}

/// All places along a line of `side` pixels that is enlarged.
fn places(side: usize, factor: usize) -> Vec<Between> {
    let place = |at: usize| {
        let along = ((at as f32 + 0.5) / factor as f32 - 0.5).clamp(0.0, (side - 1) as f32);
        let before = along as usize;
        Between { pixels: [before, (before + 1).min(side - 1)], share: along - before as f32 }
    };
    (0..side * factor).map(place).collect()
}

fn enlarged(planes: &[f32], (height, width): (usize, usize), [down, across]: [usize; 2]) -> Vec<f32> {
    let (rows, columns) = (places(height, down), places(width, across));
    let mut output = Vec::with_capacity(planes.len() * down * across);
    let mut line = vec![0.0; width];
    for plane in planes.chunks_exact(height * width) {
        for row in &rows {
            let [above, below] = row.pixels.map(|y| &plane[y * width..][..width]);
            for ((value, above), below) in line.iter_mut().zip(above).zip(below) {
                *value = above + row.share * (below - above);
            }
            output.extend(columns.iter().map(|column| {
                let [left, right] = column.pixels.map(|x| line[x]);
                left + column.share * (right - left)
            }));
        }
    }
    output
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slope_stays_a_slope_and_ends_as_it_began() {
        // Values increase by 10 per pixel in x, and by 100 in y.
        let plane: Vec<f32> = (0..12).map(|at| (at % 4 * 10 + at / 4 * 100) as f32).collect();
        let output = enlarged(&plane, (3, 4), [2, 4]);
        assert_eq!(output.len(), 6 * 16);
        for (at, value) in output.iter().enumerate() {
            let place =
                |at: usize, factor: f32, side: f32| ((at as f32 + 0.5) / factor - 0.5).clamp(0.0, side);
            let expected = 10.0 * place(at % 16, 4.0, 3.0) + 100.0 * place(at / 16, 2.0, 2.0);
            assert!((value - expected).abs() < 1e-4, "{at}: {value}, {expected}");
        }
    }
}
