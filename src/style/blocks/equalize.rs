//! Linear Histogram Equalization: (v - lo) 255 / (hi - lo), where lo and hi are percentiles of luma (inverted
//! CDF); unchanged where they meet. A colour image has all channels stretched alike, which stretches its
//! luma by the same rule and keeps its hues.

use super::{Block, Channels, Kernel};
use crate::simd::table::Table;
use crate::style::params::{Unit, number};

pub(super) static BLOCK: Block = Block {
    id: "equalize",
    label: "Linear Histogram Equalization",
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
        number("high", "White from", "Percentile that turns white.", (95.0, 0.0, 100.0, 0.5), Unit::Percent),
    ],
    kernel: Kernel::Tones(|args, tones| {
        let [low, high] = [0, 1].map(|i| f32::from(tones.percentile(args.number(i))));
        if high <= low {
            return Table::from_fn(|v| v);
        }
        Table::from_fn(|v| (v - low) * 255.0 / (high - low))
    }),
};
