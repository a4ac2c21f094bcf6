//! Saturation: Y + a (rgb - Y), where a is the amount: 0 is gray, 1 unchanged. Amounts above 1 can spare strong colours,
//! which would lose their detail: a = 1 + (amount - 1) (1 - spare c), where c is the largest less the smallest channel, in
//! parts of white. Photo editors call this vibrance.

use super::{Block, Channels, Kernel};
use crate::params::{Unit, number};
use crate::point_op::{ColorOp, PointOp, UNCHANGED};

pub(super) static BLOCK: Block = Block {
    id: "saturation",
    label: "Saturation",
    plain: "Colour strength",
    help: "Makes colours stronger or weaker.",
    input: Channels::Color,
    output: Channels::Color,
    params: &[
        number(
            "amount",
            "Amount",
            "0 is gray, 1 changes nothing, 2 doubles the colour.",
            (1.5, 0.0, 4.0, 0.05),
            Unit::None,
        ),
        number(
            "spare",
            "Spare strong colours",
            "How much less strong colours change, if the amount is above 1.",
            (0.0, 0.0, 100.0, 5.0),
            Unit::Percent,
        ),
    ],
    kernel: Kernel::Point(|args| {
        let most = f32::from(i16::MAX);
        let amount = (args.number(0) * f32::from(UNCHANGED)).round().min(most) as i16;
        let spare = (args.number(1) / 100.0 * most).round() as i16;
        PointOp::Color(if spare > 0 && amount > UNCHANGED {
            ColorOp::Vibrance(amount, spare)
        } else {
            ColorOp::Saturation(amount)
        })
    }),
    is_coloring: true,
    ..Block::PLAIN
};
