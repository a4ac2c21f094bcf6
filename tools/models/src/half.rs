//! Half precision: 1 bit of sign, 5 of exponent, 10 of fraction.

/// The nearest half-precision number, ties to even, as its bits; too large a value is infinity.
pub(super) fn half(value: f32) -> u16 {
    let bits = value.to_bits();
    let sign = (bits >> 16 & 0x8000) as u16;
    let magnitude = bits & 0x7fff_ffff;
    if magnitude >= 0x7f80_0000 {
        // Infinity, or not a number.
        return sign | 0x7c00 | u16::from(magnitude > 0x7f80_0000) << 9;
    }
    // Number of dropped low bits: 13 in the normal range, more below 2^-14.
    let exponent = magnitude >> 23;
    let (fraction, dropped) = if exponent >= 113 {
        (magnitude - (112 << 23), 13)
    } else {
        (magnitude & 0x7f_ffff | u32::from(exponent > 0) << 23, 126u32.saturating_sub(exponent).min(31))
    };
    let kept = fraction >> dropped;
    let rest = fraction & ((1 << dropped) - 1);
    let middle = 1 << (dropped - 1);
    let up = rest > middle || rest == middle && kept & 1 == 1;
    sign | (kept + u32::from(up)).min(0x7c00) as u16
}

/// The number of a half's bits.
pub(super) fn whole(bits: u16) -> f32 {
    let sign = if bits & 0x8000 == 0 { 1.0 } else { -1.0 };
    let (exponent, fraction) = (i32::from(bits >> 10 & 31), f32::from(bits & 0x3ff) / 1024.0);
    sign * match exponent {
        0 => fraction * 2f32.powi(-14),
        31 if fraction > 0.0 => f32::NAN,
        31 => f32::INFINITY,
        _ => (1.0 + fraction) * 2f32.powi(exponent - 15),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_half_comes_back_as_itself() {
        for bits in 0..=u16::MAX {
            let value = whole(bits);
            assert!(value.is_nan() || half(value) == bits, "{bits:04x} is {value}, back {:04x}", half(value));
        }
    }

    #[test]
    fn between_two_halves_the_nearer_is_taken_and_the_even_one_in_the_middle() {
        let one = 0x3c00;
        let step = 2f32.powi(-10);
        assert_eq!(half(1.0 + 0.4 * step), one);
        assert_eq!(half(1.0 + 0.5 * step), one);
        assert_eq!(half(1.0 + 0.6 * step), one + 1);
        assert_eq!(half(1.0 + 1.5 * step), one + 2);
        assert_eq!(half(65519.0), 0x7bff);
        assert_eq!(half(65520.0), 0x7c00);
        assert_eq!(half(2f32.powi(-25)), 0);
        assert_eq!(half(1.5 * 2f32.powi(-25)), 1);
        assert!(whole(half(f32::NAN)).is_nan());
    }
}
