//! Posterization: floor(v n / 256) * 255 / (n - 1) on every channel.

use super::{Block, Channels, Kernel};
use crate::params::integer;
use crate::point_op::PointOp;
use crate::simd::table::Table;

pub(super) static BLOCK: Block = Block {
    id: "posterize",
    label: "Posterization",
    plain: "Few colours",
    help: "Leaves only a few colours, like a screen print.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[integer("levels", "Levels", "How many steps of red, green and blue remain.", (10, 2, 64))],
    kernel: Kernel::Point(|args| PointOp::Table(table(args.number(0)))),
    is_coloring: true,
    adapt_to_face: more_levels,
    ..Block::PLAIN
};

/// Levels of a face relative to its surroundings. With few levels, the edge of a shadow is a hard patch on a cheek.
const FACE_LEVELS: f32 = 1.6;

/// Sets the levels of a face.
pub(super) fn more_levels(values: &mut [f32]) {
    values[0] = (FACE_LEVELS * values[0]).round().min(64.0);
}

/// The table of a posterisation to N levels.
pub(super) fn table(levels: f32) -> Table {
    Table::from_fn(|v| (v * levels / 256.0).floor() * 255.0 / (levels - 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_as_many_levels_as_asked_for_black_and_white_among_them() {
        for levels in 2..=64u16 {
            let table = table(f32::from(levels));
            let mut values = table.entries().to_vec();
            values.dedup();
            assert_eq!(values.len(), usize::from(levels));
            assert_eq!((values[0], values[values.len() - 1]), (0, 255));
        }
    }
}
