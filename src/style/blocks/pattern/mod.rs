//! Pattern Filling: luma in a few levels, each drawn with its own tile of lines or dots, from white paper to
//! solid black. The tile sets are drawn by code, see [`tiles`].

mod tiles;

use super::{Block, Channels, Kernel};
use crate::error::Result;
use crate::raster::Plane;
use crate::style::context::Context;
use crate::style::params::{Kind, Param, Unit, integer, number};
use tiles::Tile;

pub(super) static BLOCK: Block = Block {
    id: "pattern",
    label: "Pattern Filling",
    help: "Draws tones with hatching, dots or cuts, like an engraver.",
    input: Channels::Luma,
    output: Channels::Luma,
    params: &[
        integer("levels", "Levels", "How many tones, white paper and black among them.", (5, 2, 8)),
        Param {
            id: "pattern",
            label: "Pattern",
            help: "What the tones are drawn with.",
            kind: Kind::Choice { names: tiles::NAMES },
        },
        number("scale", "Scale", "Size of the pattern.", (1.0, 0.25, 4.0, 0.05), Unit::None),
    ],
    kernel: Kernel::Planes(|args, plane, context| {
        let scale = args.number(2) * context.scale();
        let tiles = tiles::draw(args.choice(1), args.number(0) as usize, scale);
        fill(plane, &tiles, context)
    }),
};

/// Replaces each pixel by that of the tile of its level: floor(Y levels / 256).
fn fill(mut plane: Plane, tiles: &[Tile], context: &mut Context<'_>) -> Result<Plane> {
    context.check_cancelled()?;
    let (width, height) = (plane.width(), plane.height());
    let side = tiles[0].side();
    let mut rows = vec![vec![0; width]; tiles.len()];
    // All rows that share a row of the tiles, one after the other: it is laid out once.
    for phase in 0..side.min(height) {
        for (row, tile) in rows.iter_mut().zip(tiles) {
            tile.repeat_row(phase, row);
        }
        for y in (phase..height).step_by(side) {
            select(plane.row_mut(y), &rows);
        }
    }
    Ok(plane)
}

/// Samples in `row` become those of the level's row: one compare a level, a loop that runs on lanes.
fn select(row: &mut [u8], rows: &[Vec<u8>]) {
    const TILE: usize = 64;
    let levels = rows.len();
    let mut out = [0; TILE];
    for (start, chunk) in row.chunks_mut(TILE).enumerate().map(|(i, chunk)| (i * TILE, chunk)) {
        let n = chunk.len();
        out[..n].copy_from_slice(&rows[0][start..start + n]);
        for (level, pattern) in rows.iter().enumerate().skip(1) {
            // The smallest Y with floor(Y levels / 256) >= level.
            let from = (256 * level).div_ceil(levels) as u8;
            let pattern = &pattern[start..start + n];
            for ((out, &pattern), &y) in out[..n].iter_mut().zip(pattern).zip(chunk.iter()) {
                *out = if y >= from { pattern } else { *out };
            }
        }
        chunk.copy_from_slice(&out[..n]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_pixel_takes_the_tile_of_its_level() {
        for levels in 2..=8usize {
            let rows: Vec<Vec<u8>> = (0..levels).map(|level| vec![level as u8; 256]).collect();
            let mut row: Vec<u8> = (0..=255).collect();
            select(&mut row, &rows);
            assert!(row.iter().enumerate().all(|(y, &level)| usize::from(level) == y * levels / 256));
        }
    }

    #[test]
    fn darker_gray_gets_more_ink_in_every_pattern() {
        for pattern in 0..tiles::NAMES.len() {
            for scale in [0.3, 1.0, 2.3] {
                let mut before = -1.0;
                for level in 0..6 {
                    let gray = (level * 51) as u8;
                    let tiles = tiles::draw(pattern, 6, scale);
                    let plane = fill(Plane::filled(300, 300, gray), &tiles, &mut Context::default()).unwrap();
                    let sum: f64 = plane.samples().iter().map(|&v| f64::from(v)).sum();
                    assert!(sum > before, "{} scale {scale} level {level}", tiles::NAMES[pattern]);
                    before = sum;
                }
            }
        }
    }
}
