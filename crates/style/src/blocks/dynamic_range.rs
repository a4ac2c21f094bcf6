//! Histogram Minimum Dynamic Range: widens the tones if the 5 and 95 percentiles of luma are closer than the
//! requested range. The tones are scaled around their midpoint to that range, and shifted so that both are in
//! 0..=255.

use super::{Block, Channels, Kernel};
use crate::params::{Unit, number};
use crate::point_op::PointOp;
use crate::simd::table::Table;

pub(super) static BLOCK: Block = Block {
    id: "dynamic_range",
    label: "Histogram Minimum Dynamic Range",
    plain: "Minimum contrast",
    help: "Gives dull photos a minimum contrast. Other photos do not change.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[number(
        "range",
        "Least range",
        "Distance between the darkest and the lightest tone.",
        (128.0, 0.0, 255.0, 1.0),
        Unit::Grey,
    )],
    kernel: Kernel::Tones(|args, tones| {
        let range = args.number(0);
        let [low, high] = [5.0, 95.0].map(|percent| f32::from(tones.percentile(percent)));
        if high <= low || high - low >= range {
            return PointOp::Table(Table::from_fn(|v| v));
        }
        let middle = f32::midpoint(low, high);
        let start = (middle - range / 2.0).clamp(0.0, 255.0 - range);
        PointOp::Table(Table::from_fn(|v| start + (v - low) * range / (high - low)))
    }),
    ..Block::PLAIN
};
