//! Moves between lane widths that the `wide` crate leaves to scalars on wasm.

use bytemuck::cast;
use wide::{i16x8, i32x4, i32x8, u8x16};

/// The lower eight bytes as 16-bit lanes, little end first as on every platform that has lanes.
#[inline]
#[must_use]
pub fn widen_low(bytes: u8x16) -> i16x8 {
    cast(u8x16::unpack_low(bytes, u8x16::ZERO))
}

/// The upper eight bytes as 16-bit lanes.
#[inline]
#[must_use]
pub fn widen_high(bytes: u8x16) -> i16x8 {
    cast(u8x16::unpack_high(bytes, u8x16::ZERO))
}

/// Lanes 0..4 of both, in turn: a0 b0 a1 b1 a2 b2 a3 b3.
#[inline]
#[must_use]
pub fn interleave_low(a: i16x8, b: i16x8) -> i16x8 {
    #[cfg(target_feature = "simd128")]
    return core::arch::wasm32::i16x8_shuffle::<0, 8, 1, 9, 2, 10, 3, 11>(a.into(), b.into()).into();
    #[cfg(not(target_feature = "simd128"))]
    {
        let ([a, b, c, d, ..], [e, f, g, h, ..]) = (a.to_array(), b.to_array());
        i16x8::new([a, e, b, f, c, g, d, h])
    }
}

/// Lanes 4..8 of both, in turn: a4 b4 a5 b5 a6 b6 a7 b7.
#[inline]
#[must_use]
pub fn interleave_high(a: i16x8, b: i16x8) -> i16x8 {
    #[cfg(target_feature = "simd128")]
    return core::arch::wasm32::i16x8_shuffle::<4, 12, 5, 13, 6, 14, 7, 15>(a.into(), b.into()).into();
    #[cfg(not(target_feature = "simd128"))]
    {
        let ([.., a, b, c, d], [.., e, f, g, h]) = (a.to_array(), b.to_array());
        i16x8::new([a, e, b, f, c, g, d, h])
    }
}

/// Lanes 0, 2, 4 and 6 of `a`, then of `b`.
#[inline]
#[must_use]
pub fn even_lanes(a: i16x8, b: i16x8) -> i16x8 {
    #[cfg(target_feature = "simd128")]
    return core::arch::wasm32::i16x8_shuffle::<0, 2, 4, 6, 8, 10, 12, 14>(a.into(), b.into()).into();
    #[cfg(not(target_feature = "simd128"))]
    {
        let lower = |pairs: i16x8| (cast::<i16x8, i32x4>(pairs) << 16u32) >> 16u32;
        narrow(lower(a), lower(b))
    }
}

/// Lanes 1, 3, 5 and 7 of `a`, then of `b`.
#[inline]
#[must_use]
pub fn odd_lanes(a: i16x8, b: i16x8) -> i16x8 {
    #[cfg(target_feature = "simd128")]
    return core::arch::wasm32::i16x8_shuffle::<1, 3, 5, 7, 9, 11, 13, 15>(a.into(), b.into()).into();
    #[cfg(not(target_feature = "simd128"))]
    {
        let upper = |pairs: i16x8| cast::<i16x8, i32x4>(pairs) >> 16u32;
        narrow(upper(a), upper(b))
    }
}

/// Eight 32-bit lanes as 16-bit ones, clamped.
#[inline]
#[must_use]
pub fn narrow(low: i32x4, high: i32x4) -> i16x8 {
    i16x8::from_i32x8_saturate(cast::<[i32x4; 2], i32x8>([low, high]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_land_where_their_names_say() {
        let bytes = u8x16::new(std::array::from_fn(|i| 240 + i as u8));
        assert_eq!(widen_low(bytes).to_array(), std::array::from_fn(|i| 240 + i as i16));
        assert_eq!(widen_high(bytes).to_array(), std::array::from_fn(|i| 248 + i as i16));
        let (a, b) = (i16x8::new([0, 1, 2, 3, 4, 5, 6, 7]), i16x8::new([10, 11, 12, 13, 14, 15, 16, 17]));
        assert_eq!(interleave_low(a, b).to_array(), [0, 10, 1, 11, 2, 12, 3, 13]);
        assert_eq!(interleave_high(a, b).to_array(), [4, 14, 5, 15, 6, 16, 7, 17]);
        assert_eq!(even_lanes(a, b).to_array(), [0, 2, 4, 6, 10, 12, 14, 16]);
        assert_eq!(odd_lanes(a, b).to_array(), [1, 3, 5, 7, 11, 13, 15, 17]);
        let ends = i16x8::new([i16::MIN, i16::MAX, -1, 0, i16::MAX, i16::MIN, 0, -1]);
        assert_eq!(even_lanes(ends, a).to_array(), [i16::MIN, -1, i16::MAX, 0, 0, 2, 4, 6]);
        assert_eq!(odd_lanes(ends, a).to_array(), [i16::MAX, 0, i16::MIN, -1, 1, 3, 5, 7]);
        let wide = |first: i32| i32x4::new([first, -1, 40_000, -40_000]);
        assert_eq!(
            narrow(wide(5), wide(6)).to_array(),
            [5, -1, i16::MAX, i16::MIN, 6, -1, i16::MAX, i16::MIN]
        );
    }
}
