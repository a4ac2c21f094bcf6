//! To `GrayScale`: Y = .299 R + .587 G + .114 B (BT.601), remembering U and V for To Color.

use super::{Block, Channels, Kernel};
use crate::point_op::PointOp;

pub(super) static BLOCK: Block = Block {
    id: "to_gray",
    label: "To GrayScale",
    plain: "Grayscale",
    help: "Turns colour into gray; To Color can bring the colours back later.",
    input: Channels::Any,
    output: Channels::Luma,
    params: &[],
    kernel: Kernel::Point(|_| PointOp::ToGray),
    ..Block::PLAIN
};
