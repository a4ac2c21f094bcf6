//! Soft Threshold: 255 (1 + tanh(min(0, phi (v - epsilon)))): white from epsilon on, falling off below.
//! A colour image has each channel thresholded, which leaves two levels of each, as the paper has it, or takes the
//! new luma and keeps its colour differences.
//!
//! Source: Winnemöller et al., "`XDoG`: an `eXtended` difference-of-Gaussians compendium", 2012.

use super::{Block, Channels, Kernel};
use crate::params::{Gaps, Unit, channels, number};
use crate::point_op::PointOp;
use crate::simd::table::Table;

pub(super) static BLOCK: Block = Block {
    id: "soft_threshold",
    label: "Soft Threshold",
    plain: "Ink and paper",
    help: "White above a brightness, soft black below: turns XDoG into ink.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[
        number(
            "phi",
            "Softness",
            "How steeply gray falls to black; small is soft.",
            (0.03, 0.001, 1.0, 0.001),
            Unit::None,
        ),
        number(
            "epsilon",
            "Threshold",
            "Minimum brightness of white areas.",
            (80.0, 0.0, 255.0, 1.0),
            Unit::Grey,
        )
        .correcting(Gaps { lines: 0.3, tone: -0.6, ..Gaps::NONE }),
        channels(&["each", "luma"]),
    ],
    kernel: Kernel::Point(|args| {
        let (phi, epsilon) = (args.number(0), args.number(1));
        let table = Table::from_fn(|v| 255.0 * (1.0 + (phi * (v - epsilon)).min(0.0).tanh()));
        if args.choice(2) == 0 { PointOp::Table(table) } else { PointOp::LumaTable(table) }
    }),
    ..Block::PLAIN
};
