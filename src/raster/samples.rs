//! Samples as decoders give them, of any depth and with or without alpha, as 8-bit RGB or grey on white.

use ::image::ColorType;

use super::resize::{self, Region};
use super::{Image, Plane};
use crate::error::Result;

/// A photo as it was decoded: interleaved RGB, or grey, of eight bits a sample.
pub(super) struct Pixels {
    /// Width and height.
    pub(super) size: (usize, usize),
    /// One or three a pixel.
    pub(super) samples: Vec<u8>,
    /// Whether there is one a pixel.
    pub(super) grey: bool,
    /// The file's ICC profile.
    pub(super) profile: Option<Vec<u8>>,
}

/// What the last sample of a pixel says of the others.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Alpha {
    /// It is one of them.
    None,
    /// How much the colours count, which are whole.
    Straight,
    /// The same, and the colours are multiplied with it already.
    Multiplied,
}

impl Pixels {
    /// Flattens transparency on white; what is not alpha is grey or RGB by its number.
    pub(super) fn flattened(size: (usize, usize), samples: Vec<u8>, alpha: Alpha) -> Self {
        let channels = samples.len() / (size.0 * size.1).max(1);
        let (samples, grey) = match (channels, alpha) {
            (1 | 3, _) | (_, Alpha::None) => (samples, channels == 1),
            (2, _) => (on_white::<1, 2>(samples, alpha), true),
            _ => (on_white::<3, 4>(samples, alpha), false),
        };
        Self { size, samples, grey, profile: None }
    }

    /// The same with the file's profile.
    pub(super) fn with_profile(mut self, profile: Option<Vec<u8>>) -> Self {
        self.profile = profile;
        self
    }

    /// Reduces to another size by exact area.
    pub(super) fn reduced(self, (new_width, new_height): (usize, usize)) -> Result<Image> {
        let (width, height) = self.size;
        if !self.grey {
            return resize::planes_of_interleaved(&self.samples, self.size, (new_width, new_height));
        }
        let mut plane = Plane::from_samples(width, height, self.samples)?;
        if (new_width, new_height) != (width, height) {
            plane = resize::resample(&plane, Region::whole(width, height), new_width, new_height);
        }
        Image::from_rgb([plane.clone(), plane.clone(), plane])
    }
}

/// Reduces what `image` decodes to 8 bits a channel. Wide samples are in this machine's byte order; 16 bits are rounded,
/// floats are taken as 0 to 1.
pub(super) fn narrowed(color: ColorType, bytes: Vec<u8>) -> (Vec<u8>, Alpha) {
    let channels = color.channel_count();
    let alpha = if channels.is_multiple_of(2) { Alpha::Straight } else { Alpha::None };
    let narrow = match color.bytes_per_pixel() / channels {
        2 => bytes.as_chunks().0.iter().map(|&two| of_16_bits(u16::from_ne_bytes(two))).collect(),
        4 => bytes.as_chunks().0.iter().map(|&four| of_float(f32::from_ne_bytes(four))).collect(),
        _ => bytes,
    };
    (narrow, alpha)
}

pub(super) fn of_16_bits(value: u16) -> u8 {
    ((u32::from(value) + 128) / 257) as u8
}

/// Light of 0 to 1.
pub(super) fn of_float(value: f32) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
}

/// `COLORS` samples and an alpha a pixel, in place.
fn on_white<const COLORS: usize, const ALL: usize>(mut samples: Vec<u8>, kind: Alpha) -> Vec<u8> {
    let pixels = samples.len() / ALL;
    for i in 0..pixels {
        let alpha = u32::from(samples[ALL * i + COLORS]);
        for channel in 0..COLORS {
            let value = u32::from(samples[ALL * i + channel]);
            let value = if kind == Alpha::Multiplied {
                (value + 255 - alpha).min(255)
            } else {
                (value * alpha + 255 * (255 - alpha) + 127) / 255
            };
            samples[COLORS * i + channel] = value as u8;
        }
    }
    samples.truncate(COLORS * pixels);
    samples
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flattened(color: ColorType, bytes: Vec<u8>) -> Vec<u8> {
        let (samples, alpha) = narrowed(color, bytes);
        let pixels = samples.len() / usize::from(color.channel_count());
        Pixels::flattened((pixels, 1), samples, alpha).samples
    }

    #[test]
    fn every_depth_gives_the_same_eight_bits() {
        for value in 0..=255u8 {
            let wide = (u16::from(value) * 257).to_ne_bytes();
            assert_eq!(flattened(ColorType::L16, wide.to_vec()), [value]);
            let float = (f32::from(value) / 255.0).to_ne_bytes();
            assert_eq!(flattened(ColorType::Rgb32F, float.repeat(3)), [value; 3]);
        }
        assert_eq!(of_16_bits(128), 0);
        assert_eq!(of_16_bits(129), 1);
        assert_eq!((of_float(-1.0), of_float(f32::NAN), of_float(7.0)), (0, 0, 255));
    }

    #[test]
    fn what_is_clear_is_white() {
        let grey = Pixels::flattened((3, 1), vec![10, 0, 10, 255, 10, 128], Alpha::Straight);
        assert!(grey.grey);
        assert_eq!(grey.samples, [255, 10, 132]);
        let rgb = flattened(ColorType::Rgba8, vec![9, 8, 7, 255, 0, 0, 0, 0]);
        assert_eq!(rgb, [9, 8, 7, 255, 255, 255]);
        let wide = [1000u16, 2000, 3000, 65535].map(u16::to_ne_bytes).concat();
        assert_eq!(flattened(ColorType::Rgba16, wide), [4, 8, 12]);
    }

    #[test]
    fn colours_that_are_multiplied_already_are_not_multiplied_again() {
        let half_red = Pixels::flattened((1, 1), vec![128, 0, 0, 128], Alpha::Multiplied);
        assert_eq!((half_red.samples.as_slice(), half_red.grey), ([255, 127, 127].as_slice(), false));
        // More colour than there can be ends at white.
        let wrong = Pixels::flattened((1, 1), vec![200, 100], Alpha::Multiplied);
        assert_eq!((wrong.samples.as_slice(), wrong.grey), ([255].as_slice(), true));
    }
}
