//! Luma Posterization: the levels of Posterization on Y; the colour differences stay.

use super::{Block, Channels, Kernel, posterize};
use crate::params::integer;
use crate::point_op::PointOp;

pub(super) static BLOCK: Block = Block {
    id: "luma_posterize",
    label: "Luma Posterization",
    plain: "Few tones",
    help: "Leaves only a few levels of brightness and keeps the colours.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[integer("levels", "Levels", "How many levels of brightness stay.", (8, 2, 64))],
    kernel: Kernel::Point(|args| PointOp::LumaTable(posterize::table(args.number(0)))),
    is_coloring: true,
    adapt_to_face: posterize::more_levels,
    ..Block::PLAIN
};
