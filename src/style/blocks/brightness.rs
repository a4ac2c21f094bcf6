//! Brightness: every channel times a gain, clipped.

use super::{Block, Channels, Kernel, PointOp};
use crate::simd::table::Table;
use crate::style::params::{Unit, number};

pub(super) static BLOCK: Block = Block {
    id: "brightness",
    label: "Brightness",
    help: "Makes the image lighter or darker.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[number(
        "gain",
        "Gain",
        "1 changes nothing, 2 is twice as bright.",
        (1.2, 0.0, 4.0, 0.05),
        Unit::None,
    )],
    kernel: Kernel::Point(|args| {
        let gain = args.number(0);
        PointOp::Table(Table::from_fn(|v| v * gain))
    }),
};
