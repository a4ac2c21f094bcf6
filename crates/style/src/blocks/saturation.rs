//! Saturation: Y + amount (rgb - Y). 0 is gray, 1 unchanged.

use super::{Block, Channels, Kernel};
use crate::params::{Unit, number};
use crate::point_op::{ColorOp, PointOp};

pub(super) static BLOCK: Block = Block {
    id: "saturation",
    label: "Saturation",
    plain: "Colour strength",
    help: "Makes colours stronger or weaker.",
    input: Channels::Color,
    output: Channels::Color,
    params: &[number(
        "amount",
        "Amount",
        "0 is gray, 1 changes nothing, 2 doubles the colour.",
        (1.5, 0.0, 4.0, 0.05),
        Unit::None,
    )],
    kernel: Kernel::Point(|args| {
        let amount = (args.number(0) * 8192.0).round().min(f32::from(i16::MAX));
        PointOp::Color(ColorOp::Saturation(amount as i16))
    }),
    is_coloring: true,
    ..Block::PLAIN
};
