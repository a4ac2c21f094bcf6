//! Colorize: HSL with a fixed hue and saturation and L = Y / 255.
//!
//! With C = S (1 - |2 L - 1|), a channel of the hue's full strength k (0..=1) is L + C (k - 1/2): linear in C,
//! so a pixel costs one product a channel.

use super::{Block, Channels, Kernel};
use crate::params::{Unit, number};
use crate::point_op::PointOp;

pub(super) static BLOCK: Block = Block {
    id: "colorize",
    label: "Colorize",
    plain: "One colour",
    help: "Prints a gray image in one colour, like a duotone.",
    input: Channels::Luma,
    output: Channels::Color,
    params: &[
        number("hue", "Hue", "Place on the colour wheel.", (30.0, 0.0, 360.0, 1.0), Unit::Degrees),
        number(
            "saturation",
            "Saturation",
            "0 stays gray, 1 is full colour.",
            (0.5, 0.0, 1.0, 0.01),
            Unit::None,
        ),
    ],
    kernel: Kernel::Point(|args| {
        let shares = strengths(args.number(0)).map(|k| args.number(1) * (k - 0.5));
        PointOp::Tint(shares.map(|share| (share * 32768.0).round() as i16))
    }),
    is_coloring: true,
    recolors: |_| true,
    ..Block::PLAIN
};

/// Red, green and blue of a fully saturated hue, 0..=1.
fn strengths(hue: f32) -> [f32; 3] {
    [0.0, 240.0, 120.0].map(|offset: f32| {
        let sector = ((hue + offset) / 60.0).rem_euclid(6.0);
        ((sector - 3.0).abs() - 1.0).clamp(0.0, 1.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_wheel_goes_red_yellow_green_cyan_blue_magenta() {
        let wheel = [[1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 1, 1], [0, 0, 1], [1, 0, 1], [1, 0, 0]];
        for (i, color) in wheel.iter().enumerate() {
            assert_eq!(strengths(i as f32 * 60.0).map(|k| k as i32), *color);
        }
    }
}
