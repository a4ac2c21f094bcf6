//! Saturation: Y + amount (rgb - Y). 0 is gray, 1 unchanged.

use super::{Block, Channels, ColorOp, Kernel, PointOp};
use crate::params::{Unit, number};
use crate::simd::point::{luma_q7, round};
use wide::i16x8;

pub(super) static BLOCK: Block = Block {
    id: "saturation",
    label: "Saturation",
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

/// Eight pixels. The difference to luma keeps 7 fraction bits going in and 5 coming out: amounts up to 4 fit.
#[inline]
pub(super) fn lanes(amount: i16, r: i16x8, g: i16x8, b: i16x8) -> (i16x8, i16x8, i16x8) {
    let y = luma_q7(r, g, b);
    let base = y >> 2u32;
    let away = |channel: i16x8| {
        let difference = (channel << 7u32) - y;
        round::<5>(base.saturating_add(difference.mul_scale_round_n(amount)))
    };
    (away(r), away(g), away(b))
}
