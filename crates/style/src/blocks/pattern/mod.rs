//! Pattern Filling: luma in a few levels, each drawn with its own tile of lines or dots, from white paper to
//! solid black. Code draws the tile sets, see [`tiles`]. The tones of a custom texture define its ink, see
//! [`own`].

mod own;
mod tiles;

use super::{Block, Channels, Kernel};
use crate::context::Context;
use crate::error::Result;
use crate::params::{FACE_CELLS, FaceLimit, Kind, Repeat, Unit, integer, number, param};
use crate::raster::Plane;
use crate::simd::screen::select;
use tiles::Tile;

/// Pixels of a cell at scale 1.
const CELL: f32 = 5.0;

pub(super) static BLOCK: Block = Block {
    id: "pattern",
    label: "Pattern Filling",
    plain: "Hatching",
    help: "Draws tones with hatching, dots or cuts, like an engraver.",
    input: Channels::Luma,
    output: Channels::Luma,
    params: &[
        integer("levels", "Levels", "How many tones, white paper and black among them.", (5, 2, 8)),
        param(
            "pattern",
            "Pattern",
            "The pattern that draws the tones.",
            Kind::Choice { names: tiles::NAMES },
        ),
        number("scale", "Scale", "Size of the pattern.", (1.0, 0.25, 4.0, 0.05), Unit::None)
            .for_face(FaceLimit::Cell { share: 1.0 / FACE_CELLS / CELL, least: 0.0 })
            .repeating(Repeat::Size),
        param(
            "texture",
            "Own texture",
            "Your picture instead of the pattern: its dark parts take ink first.",
            Kind::Texture,
        ),
    ],
    kernel: Kernel::Planes(|args, plane, context| {
        let scale = args.number(2) * context.scale();
        if let Some(texture) = args.texture() {
            return own::fill(plane, texture, args.number(0) as usize, scale, context);
        }
        let key = (args.choice(1), args.number(0) as usize, scale.to_bits());
        // Drawing takes longer than filling, so tiles are cached across changes of other sliders and panels.
        let drawn = context.take().filter(|drawn: &Drawn| drawn.key == key);
        let drawn = drawn.unwrap_or_else(|| Drawn { key, tiles: tiles::draw(key.0, key.1, scale) });
        let filled = fill(plane, &drawn.tiles, context);
        context.give(drawn);
        filled
    }),
    is_screen: true,
    ..Block::PLAIN
};

/// Tiles and the settings of their drawing: pattern, levels, bits of the scale.
struct Drawn {
    key: (usize, usize, u32),
    tiles: Vec<Tile>,
}

/// Replaces each pixel by the tile pixel of its level: floor(Y levels / 256).
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

#[cfg(test)]
mod tests {
    use super::*;

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
