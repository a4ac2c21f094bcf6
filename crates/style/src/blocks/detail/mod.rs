//! Image Detail Control: in + delta / 100 (in - B(in)), where B is a bilateral filter: -100 gives the smooth
//! base itself, positive values bring texture forward.
//!
//! B runs on a bilateral grid: pixels are gathered in cells of space and tone, the cells are blurred and read
//! back by interpolation.
//!
//! ```text
//! splat   every second pixel of every second row into the nearest cell of space, shared by two of tone
//! blur    [1 4 6 4 1] / 16 along both axes of space and tone; then value / weight
//! slice   between the eight cells about a pixel
//! ```
//!
//! All three run in one sweep over the rows, so only a few rows of cells are in memory.
//!
//! Source: Chen, Paris and Durand, "Real-time edge-aware image processing with the bilateral grid", 2007.

mod grid;

use super::{Block, Channels, Kernel};
use crate::params::{Unit, number};
use grid::Grid;

pub(super) static BLOCK: Block = Block {
    id: "detail",
    label: "Image Detail Control",
    plain: "Fine detail",
    help: "Removes or enhances texture without changing edges.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[
        number(
            "delta",
            "Detail",
            "-100 removes all texture, 0 changes nothing, 100 doubles it.",
            (50.0, -100.0, 300.0, 1.0),
            Unit::Percent,
        ),
        number(
            "sigma_s",
            "Radius",
            "Maximum size of details that count as texture.",
            (8.0, 1.0, 32.0, 0.5),
            Unit::Pixels,
        ),
        number(
            "sigma_r",
            "Edge height",
            "Steps of tone above this are edges.",
            (25.0, 1.0, 128.0, 1.0),
            Unit::Grey,
        ),
    ],
    kernel: Kernel::Luma(|args, mut plane, context| {
        let amount = args.number(0) / 100.0;
        if amount == 0.0 {
            return Ok(plane);
        }
        let size = (plane.width(), plane.height());
        let buffers = context.take().unwrap_or_default();
        let mut grid = Grid::new(size, args.pixels(1), args.number(2), buffers);
        let done = grid.run(&mut plane, amount, context);
        context.give(grid.into_buffers());
        done?;
        Ok(plane)
    }),
    ..Block::PLAIN
};
