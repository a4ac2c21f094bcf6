//! To Color: R, G, B from luma and the U and V that To `GrayScale` kept (BT.601, full range): R = Y + 1.402 V,
//! G = Y - .344 U - .714 V, B = Y + 1.772 U. Without stored U and V the result is neutral.

use super::{Block, Channels, Kernel};
use crate::point_op::PointOp;

pub(super) static BLOCK: Block = Block {
    id: "to_color",
    label: "To Color",
    plain: "Restore colour",
    help: "Brings back the colours that To GrayScale took away.",
    input: Channels::Any,
    output: Channels::Color,
    params: &[],
    kernel: Kernel::Point(|_| PointOp::ToColor),
    restores_color: true,
    is_coloring: true,
    ..Block::PLAIN
};
