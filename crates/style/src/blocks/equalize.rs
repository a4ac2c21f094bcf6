//! Linear Histogram Equalization: (v - lo) 255 / (hi - lo), where lo and hi are percentiles of luma (inverted
//! CDF); unchanged where they meet. For a colour image, either only luma is stretched, as in the paper, or
//! each channel, which makes colours stronger.
//!
//! A knee compresses tones at both ends instead of cutting them off. It begins at 1 - k of the range. The distance x from
//! there, in parts of k, becomes x / (1 + x (1 - 1 / X)), where X is the distance of 0 or 255. The slope is steady, and 0
//! and 255 are reached.

use super::{Block, Channels, Kernel};
use crate::params::{Gaps, Unit, channels, number};
use crate::point_op::PointOp;
use crate::simd::table::Table;

pub(super) static BLOCK: Block = Block {
    id: "equalize",
    label: "Linear Histogram Equalization",
    plain: "Auto levels",
    help: "Stretches the tones, so that hazy photos get real blacks and whites.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[
        number(
            "low",
            "Black from",
            "Share of pixels that turn black.",
            (5.0, 0.0, 100.0, 0.5),
            Unit::Percent,
        ),
        number(
            "high",
            "White from",
            "Share of pixels that stay darker than white.",
            (95.0, 0.0, 100.0, 0.5),
            Unit::Percent,
        )
        .correcting(Gaps { tone: -0.25, ..Gaps::NONE }),
        channels(&["luma", "each"]),
        number(
            "knee",
            "Keep detail",
            "How much of the darkest and lightest tones keeps detail, instead of turning black or white.",
            (0.0, 0.0, 50.0, 1.0),
            Unit::Percent,
        ),
    ],
    kernel: Kernel::Tones(|args, tones| {
        let [low, high] = [0, 1].map(|i| f32::from(tones.percentile(args.number(i))));
        let knee = args.number(3) / 100.0;
        let part = |v: f32| (v - low) / (high - low);
        let (below, above) = (1.0 - part(0.0), part(255.0));
        let stretch = |v: f32| {
            let at = bent(part(v), above, knee);
            255.0 * (1.0 - bent(1.0 - at, below, knee))
        };
        let table = Table::from_fn(|v| if high <= low { v } else { stretch(v) });
        if args.choice(2) == 0 { PointOp::LumaTable(table) } else { PointOp::Table(table) }
    }),
    ..Block::PLAIN
};

/// A tone of the range 0 to 1 with a knee at its upper end. `most`: the largest tone, which becomes 1.
fn bent(at: f32, most: f32, knee: f32) -> f32 {
    let start = 1.0 - knee;
    if at <= start || most <= 1.0 {
        return at;
    }
    let [x, end] = [at, most].map(|at| (at - start) / knee.max(f32::EPSILON));
    start + knee * x / (1.0 + x * (1.0 - 1.0 / end))
}
