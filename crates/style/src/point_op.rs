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

/// Linear maps of colour, in the arithmetic of the lanes.
#[derive(Debug, Clone)]
pub enum ColorOp {
    /// Y + amount * (rgb - Y), the amount as Q13.
    Saturation(i16),
    /// A 3 x 3 matrix (Q13, row by row) and a bias (1/16 grey steps).
    Matrix([[i16; 3]; 3], [i16; 3]),
}

impl ColorOp {
    /// Eight pixels.
    #[inline]
    #[must_use]
    pub fn apply(&self, r: i16x8, g: i16x8, b: i16x8) -> (i16x8, i16x8, i16x8) {
        match self {
            Self::Saturation(amount) => saturated(*amount, r, g, b),
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
fn saturated(amount: i16, r: i16x8, g: i16x8, b: i16x8) -> (i16x8, i16x8, i16x8) {
    let y = luma_q7(r, g, b);
    let base = y >> 2u32;
    let away = |channel: i16x8| {
        let difference = (channel << 7u32) - y;
        round::<5>(base.saturating_add(difference.mul_scale_round_n(amount)))
    };
    (away(r), away(g), away(b))
}
