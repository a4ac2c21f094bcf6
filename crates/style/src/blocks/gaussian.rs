//! Gaussian Smoothing, every plane on its own; borders repeat the edge.

use super::{Block, Channels, Kernel};
use crate::params::{Gaps, Unit, number};
use crate::simd::gaussian::blur_plane;

pub(super) static BLOCK: Block = Block {
    id: "gaussian",
    label: "Gaussian Smoothing",
    plain: "Blur",
    help: "Blurs, so that small detail and noise go away.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[number(
        "sigma",
        "Radius",
        "Standard deviation of the blur.",
        (2.0, 0.3, 50.0, 0.1),
        Unit::Pixels,
    )
    .correcting(Gaps { texture: -0.7, ..Gaps::NONE })],
    kernel: Kernel::Planes(|args, mut plane, context| {
        let sigma = args.pixels(0);
        if sigma < NOTHING {
            return Ok(plane);
        }
        blur_plane(&mut plane, sigma, &mut context.blurs);
        Ok(plane)
    }),
    ..Block::PLAIN
};

/// Below this sigma the neighbours' weight is under a tenth of a grey step.
const NOTHING: f32 = 0.18;
