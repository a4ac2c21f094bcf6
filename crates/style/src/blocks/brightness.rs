//! Brightness: luma times a gain, clipped. A colour image retains its colour differences, as in the paper.
//! Alternatively, each channel is multiplied by the gain, which changes the strength of colours too.

use super::{Block, Channels, Kernel};
use crate::params::{Gaps, Unit, channels, number};
use crate::point_op::PointOp;
use crate::simd::table::Table;

pub(super) static BLOCK: Block = Block {
    id: "brightness",
    label: "Brightness",
    help: "Makes the image lighter or darker.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[
        number("gain", "Gain", "1 changes nothing, 2 is twice as bright.", (1.2, 0.0, 4.0, 0.05), Unit::None)
            .correcting(Gaps { tone: 0.7, ..Gaps::NONE }),
        channels(&["luma", "each"]),
    ],
    kernel: Kernel::Point(|args| {
        let gain = args.number(0);
        let table = Table::from_fn(|v| v * gain);
        if args.choice(1) == 0 { PointOp::LumaTable(table) } else { PointOp::Table(table) }
    }),
    is_coloring: true,
    // Flat paper.
    recolors: |values| values[0] <= 0.0,
    ..Block::PLAIN
};
