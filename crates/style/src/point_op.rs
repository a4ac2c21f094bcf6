//! Operations on single pixels, which the chain joins in one pass.

use crate::simd::point::{luma_q7, round};
use crate::simd::table::Table;
use wide::i16x8;

/// An operation on single pixels.
#[derive(Debug, Clone)]
pub enum PointOp {
    /// One table on every plane.
    Table(Table),
    /// A table on luma; colour images keep their colour differences.
    LumaTable(Table),
    /// R, G, B from R, G, B.
    Color(ColorOp),
    /// Luma from R, G, B; U and V are stored if a later To Color needs them.
    ToGray,
    /// R, G, B from luma and the kept U and V.
    ToColor,
    /// R, G, B from luma: Y plus these shares (Q15) of 255 - |2 Y - 255|.
    Tint([i16; 3]),
}

/// The amount of saturation that changes nothing, as Q13.
pub const UNCHANGED: i16 = 1 << 13;

/// Linear maps of colour, in the arithmetic of the lanes.
#[derive(Debug, Clone)]
pub enum ColorOp {
    /// Y + amount * (rgb - Y), the amount as Q13.
    Saturation(i16),
    /// Like `Saturation`, but an amount (Q13, at least 1) is less for strong colours: the second number (Q15) is the part
    /// of the change that a colour of full strength does not get.
    Vibrance(i16, i16),
    /// A 3 x 3 matrix (Q13, row by row) and a bias (1/16 grey steps).
    Matrix([[i16; 3]; 3], [i16; 3]),
}

impl ColorOp {
    /// Eight pixels.
    #[inline]
    #[must_use]
    pub fn apply(&self, r: i16x8, g: i16x8, b: i16x8) -> (i16x8, i16x8, i16x8) {
        match self {
            Self::Saturation(amount) => saturated(i16x8::splat(*amount), r, g, b),
            Self::Vibrance(amount, spare) => {
                let chroma = r.max(g).max(b) - r.min(g).min(b);
                // 255 becomes one.
                let strength = (chroma << 7u32) + (chroma >> 1u32);
                let weight = i16x8::splat(i16::MAX) - strength.mul_scale_round_n(*spare);
                let change = weight.mul_scale_round_n(*amount - UNCHANGED);
                saturated(i16x8::splat(UNCHANGED) + change, r, g, b)
            }
            Self::Matrix(rows, bias) => {
                let term = |channel: i16x8, weight: i16| (channel << 6u32).mul_scale_round_n(weight);
                let row = |i: usize| {
                    let sum = term(r, rows[i][0])
                        .saturating_add(term(g, rows[i][1]))
                        .saturating_add(term(b, rows[i][2]))
                        .saturating_add(i16x8::splat(bias[i]));
                    round::<4>(sum)
                };
                (row(0), row(1), row(2))
            }
        }
    }
}

/// Eight pixels. The difference to luma keeps 7 fraction bits going in and 5 coming out: amounts up to 4 fit.
#[inline]
fn saturated(amount: i16x8, r: i16x8, g: i16x8, b: i16x8) -> (i16x8, i16x8, i16x8) {
    let y = luma_q7(r, g, b);
    let base = y >> 2u32;
    let away = |channel: i16x8| {
        let difference = (channel << 7u32) - y;
        round::<5>(base.saturating_add(difference.mul_scale_round(amount)))
    };
    (away(r), away(g), away(b))
}
