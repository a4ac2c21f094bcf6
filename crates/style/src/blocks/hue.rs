//! Hue: turns U and V by an angle (BT.601), then adds a bias to each channel.

use super::{Block, Channels, Kernel};
use crate::params::{Param, Unit, number};
use crate::point_op::{ColorOp, PointOp};

pub(super) static BLOCK: Block = Block {
    id: "hue",
    label: "Hue",
    plain: "Shift colours",
    help: "Turns all colours around the colour wheel, and tints them.",
    input: Channels::Color,
    output: Channels::Color,
    params: &[
        number("angle", "Angle", "Turn of the colour wheel.", (0.0, -180.0, 180.0, 1.0), Unit::Degrees)
            .fixed(),
        bias("red", "Red", "Red added to every pixel."),
        bias("green", "Green", "Green added to every pixel."),
        bias("blue", "Blue", "Blue added to every pixel."),
    ],
    kernel: Kernel::Point(|args| {
        let rows = rotation(f64::from(args.number(0)).to_radians());
        let bias = [1, 2, 3].map(|i| (args.number(i) * 16.0).round() as i16);
        PointOp::Color(ColorOp::Matrix(rows.map(|row| row.map(|w| (w * 8192.0).round() as i16)), bias))
    }),
    is_coloring: true,
    recolors: is_tinting,
    ..Block::PLAIN
};

/// Largest spread of the biases that keeps the colours of the photo, in grey steps.
const NEUTRAL: f32 = 14.0;

fn is_tinting(values: &[f32]) -> bool {
    let [red, green, blue] = [1, 2, 3].map(|i| values[i]);
    let spread = red.max(green).max(blue) - red.min(green).min(blue);
    values[0] != 0.0 || spread > NEUTRAL
}

const fn bias(id: &'static str, label: &'static str, help: &'static str) -> Param {
    number(id, label, help, (0.0, -255.0, 255.0, 1.0), Unit::Grey)
}

/// The matrix of R, G, B that turns (U, V) by `angle` radians and keeps Y.
fn rotation(angle: f64) -> [[f64; 3]; 3] {
    const Y: [f64; 3] = [0.299, 0.587, 0.114];
    let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
    let (sin, cos) = angle.sin_cos();
    // How U and V follow from each channel, turned.
    let uv = [0, 1, 2].map(|j| {
        let (u, v) = ((unit(2, j) - Y[j]) / 1.772, (unit(0, j) - Y[j]) / 1.402);
        (u * cos - v * sin, u * sin + v * cos)
    });
    let row = |cu: f64, cv: f64| [0, 1, 2].map(|j| Y[j] + cu * uv[j].0 + cv * uv[j].1);
    let (gu, gv) = (-0.114 * 1.772 / 0.587, -0.299 * 1.402 / 0.587);
    [row(0.0, 1.402), row(gu, gv), row(1.772, 0.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_turn_is_the_identity_and_a_whole_turn_too() {
        for angle in [0.0, std::f64::consts::TAU] {
            for (i, row) in rotation(angle).iter().enumerate() {
                for (j, weight) in row.iter().enumerate() {
                    assert!((weight - f64::from(u8::from(i == j))).abs() < 1e-9);
                }
            }
        }
    }

    #[test]
    fn luma_does_not_change_and_weights_fit_the_lanes() {
        for degrees in -180..=180 {
            let rows = rotation(f64::from(degrees).to_radians());
            for j in 0..3 {
                let luma = 0.299 * rows[0][j] + 0.587 * rows[1][j] + 0.114 * rows[2][j];
                assert!((luma - [0.299, 0.587, 0.114][j]).abs() < 1e-9);
            }
            assert!(rows.iter().flatten().all(|w| w.abs() < 4.0));
        }
    }
}
