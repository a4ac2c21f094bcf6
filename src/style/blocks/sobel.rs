//! Sobel: the magnitude of the 3 x 3 gradient, a quarter of it, so that a full step from black to white along
//! an axis gives 255; borders repeat the edge.

use super::{Block, Channels, Kernel};
use crate::style::params::{Kind, Param, Unit, number};

pub(super) static BLOCK: Block = Block {
    id: "sobel",
    label: "Sobel",
    help: "Draws the edges, white on black or, inverted, black on white.",
    input: Channels::Any,
    output: Channels::Luma,
    params: &[
        number("gain", "Gain", "How strongly weak edges show.", (1.0, 0.1, 8.0, 0.1), Unit::None),
        Param {
            id: "invert",
            label: "Invert",
            help: "Black lines on white, as a line layer wants them.",
            kind: Kind::Flag { default: false },
        },
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
        interior(rows, gain, flip, &mut out[1..width - 1]);
    }
}

/// Pixels with both neighbours: shifted slices of one length, a loop that compilers turn into lanes.
fn interior([above, here, below]: [&[u8]; 3], gain: f32, flip: u8, out: &mut [u8]) {
    let n = out.len();
    let (a0, a1, a2) = (&above[..n], &above[1..=n], &above[2..n + 2]);
    let (h0, h2) = (&here[..n], &here[2..n + 2]);
    let (b0, b1, b2) = (&below[..n], &below[1..=n], &below[2..n + 2]);
    for i in 0..n {
        let v = |row: &[u8]| i16::from(row[i]);
        let dx = v(a2) - v(a0) + 2 * (v(h2) - v(h0)) + v(b2) - v(b0);
        let dy = v(b0) - v(a0) + 2 * (v(b1) - v(a1)) + v(b2) - v(a2);
        out[i] = magnitude(dx, dy, gain) ^ flip;
    }
}

#[inline]
fn magnitude(dx: i16, dy: i16, gain: f32) -> u8 {
    let (dx, dy) = (f32::from(dx), f32::from(dy));
    ((dx * dx + dy * dy).sqrt() * gain + 0.5).min(255.0) as u8
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
