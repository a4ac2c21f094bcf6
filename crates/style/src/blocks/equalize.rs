//! Linear Histogram Equalization: (v - lo) 255 / (hi - lo), where lo and hi are percentiles of luma (inverted
//! CDF); unchanged where they meet. For a colour image, either only luma is stretched, as in the paper, or
//! each channel, which makes colours stronger.

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
        number("high", "White from", "Percentile that turns white.", (95.0, 0.0, 100.0, 0.5), Unit::Percent)
            .correcting(Gaps { tone: -0.25, ..Gaps::NONE }),
        channels(&["luma", "each"]),
    ],
    kernel: Kernel::Tones(|args, tones| {
        let [low, high] = [0, 1].map(|i| f32::from(tones.percentile(args.number(i))));
        let stretch = |v: f32| if high <= low { v } else { (v - low) * 255.0 / (high - low) };
        let table = Table::from_fn(stretch);
        if args.choice(2) == 0 { PointOp::LumaTable(table) } else { PointOp::Table(table) }
    }),
    ..Block::PLAIN
};
