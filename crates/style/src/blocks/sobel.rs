//! Sobel: a quarter of the magnitude of the 3 x 3 gradient, so that a step from black to white along an axis
//! gives 255. Borders repeat the edge.

use super::{Block, Channels, Kernel};
use crate::params::{Kind, Unit, number, param};
use crate::simd::edge::{self, magnitude};

pub(super) static BLOCK: Block = Block {
    id: "sobel",
    label: "Sobel",
    plain: "Edges",
    help: "Draws the edges, white on black or, inverted, black on white.",
    input: Channels::Any,
    output: Channels::Luma,
    params: &[
        number("gain", "Gain", "How strongly weak edges show.", (1.0, 0.1, 8.0, 0.1), Unit::None),
        param("invert", "Invert", "Black lines on white, for the line layer.", Kind::Flag { default: false }),
    ],
    kernel: Kernel::Luma(|args, plane, context| {
        let flip = if args.flag(1) { 255 } else { 0 };
        let mut out = context.take_plane(plane.width(), plane.height());
        let last = plane.height() - 1;
        for y in 0..=last {
            let rows = [plane.row(y.saturating_sub(1)), plane.row(y), plane.row((y + 1).min(last))];
            magnitudes(rows, args.number(0) / 4.0, flip, out.row_mut(y));
        }
        context.give_plane(plane);
        Ok(out)
    }),
    ..Block::PLAIN
};

fn magnitudes(rows: [&[u8]; 3], gain: f32, flip: u8, out: &mut [u8]) {
    let [above, here, below] = rows;
    let width = out.len();
    let pixel = |left: usize, x: usize, right: usize| {
        let v = |row: &[u8], x: usize| i16::from(row[x]);
        let dx = v(above, right) - v(above, left) + 2 * (v(here, right) - v(here, left)) + v(below, right)
            - v(below, left);
        let dy = v(below, left) - v(above, left) + 2 * (v(below, x) - v(above, x)) + v(below, right)
            - v(above, right);
        magnitude(dx, dy, gain) ^ flip
    };
    out[0] = pixel(0, 0, 1.min(width - 1));
    if width > 1 {
        out[width - 1] = pixel(width - 2, width - 1, width - 1);
        edge::sobel(rows, gain, flip, &mut out[1..width - 1]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_step_is_white_and_flat_is_black() {
        for width in 1..=67usize {
            let rows: Vec<Vec<u8>> =
                (0..3).map(|_| (0..width).map(|x| if x < width / 2 { 0 } else { 255 }).collect()).collect();
            let mut out = vec![9; width];
            magnitudes([&rows[0], &rows[1], &rows[2]], 0.25, 0, &mut out);
            for (x, &value) in out.iter().enumerate() {
                let on_edge = width > 1 && (x + 1 == width / 2 || x == width / 2);
                assert_eq!(value, if on_edge { 255 } else { 0 }, "{width} {x}");
            }
        }
    }
}
