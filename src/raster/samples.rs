//! Samples as decoders give them, of any depth and with or without alpha, as 8-bit RGB or grey on white.

use ::image::ColorType;

/// 8-bit samples: interleaved RGB, or grey.
pub(super) struct Samples {
    /// One or three a pixel.
    pub(super) bytes: Vec<u8>,
    /// Whether there is one a pixel.
    pub(super) grey: bool,
}

/// Reduces to 8 bits a channel and flattens transparency on white. Wide samples are in this machine's byte order;
/// 16 bits are rounded, floats are taken as 0 to 1.
pub(super) fn flattened(color: ColorType, bytes: Vec<u8>) -> Samples {
    let channels = color.channel_count();
    let narrow = match color.bytes_per_pixel() / channels {
        2 => bytes.as_chunks().0.iter().map(|&two| of_16_bits(u16::from_ne_bytes(two))).collect(),
        4 => bytes.as_chunks().0.iter().map(|&four| of_float(f32::from_ne_bytes(four))).collect(),
        _ => bytes,
    };
    match channels {
        2 => Samples { bytes: on_white::<1, 2>(narrow), grey: true },
        4 => Samples { bytes: on_white::<3, 4>(narrow), grey: false },
        count => Samples { bytes: narrow, grey: count == 1 },
    }
}

fn of_16_bits(value: u16) -> u8 {
    ((u32::from(value) + 128) / 257) as u8
}

fn of_float(value: f32) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
}

/// `COLORS` samples and an alpha a pixel, in place.
fn on_white<const COLORS: usize, const ALL: usize>(mut samples: Vec<u8>) -> Vec<u8> {
    let pixels = samples.len() / ALL;
    for i in 0..pixels {
        let alpha = u32::from(samples[ALL * i + COLORS]);
        for channel in 0..COLORS {
            let value = u32::from(samples[ALL * i + channel]);
            samples[COLORS * i + channel] = ((value * alpha + 255 * (255 - alpha) + 127) / 255) as u8;
        }
    }
    samples.truncate(COLORS * pixels);
    samples
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_depth_gives_the_same_eight_bits() {
        for value in 0..=255u8 {
            let wide = (u16::from(value) * 257).to_ne_bytes();
            assert_eq!(flattened(ColorType::L16, wide.to_vec()).bytes, [value]);
            let float = (f32::from(value) / 255.0).to_ne_bytes();
            assert_eq!(flattened(ColorType::Rgb32F, float.repeat(3)).bytes, [value; 3]);
        }
        assert_eq!(of_16_bits(128), 0);
        assert_eq!(of_16_bits(129), 1);
        assert_eq!((of_float(-1.0), of_float(f32::NAN), of_float(7.0)), (0, 0, 255));
    }

    #[test]
    fn what_is_clear_is_white() {
        let grey = flattened(ColorType::La8, vec![10, 0, 10, 255, 10, 128]);
        assert!(grey.grey);
        assert_eq!(grey.bytes, [255, 10, 132]);
        let rgb = flattened(ColorType::Rgba8, vec![9, 8, 7, 255, 0, 0, 0, 0]);
        assert_eq!((rgb.bytes.as_slice(), rgb.grey), ([9, 8, 7, 255, 255, 255].as_slice(), false));
        let wide = [1000u16, 2000, 3000, 65535].map(u16::to_ne_bytes).concat();
        assert_eq!(flattened(ColorType::Rgba16, wide).bytes, [4, 8, 12]);
    }
}
