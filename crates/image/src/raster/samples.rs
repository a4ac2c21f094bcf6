//! Converts decoded samples of any depth, with or without alpha, to 8 bits per sample on white, and to an
//! sRGB image.

use ::image::ColorType;

use super::channels::Channels;
use super::limits::Damage;
use super::resize::{self, Region};
use super::{Image, Plane, icc};
use crate::error::Result;

/// A photo as it was decoded: interleaved samples of eight bits.
pub(super) struct Pixels {
    /// Width and height.
    pub(super) size: (usize, usize),
    pub(super) samples: Vec<u8>,
    pub(super) channels: Channels,
    /// The file's ICC profile.
    pub(super) profile: Option<Vec<u8>>,
    /// The damage of the file, if any.
    pub(super) damage: Option<Damage>,
}

/// Meaning of the alpha channel.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Alpha {
    /// No alpha channel.
    None,
    /// How much the colours count, which are whole.
    Straight,
    /// Premultiplied: the colours are already multiplied by alpha.
    Multiplied,
}

impl Pixels {
    /// Flattens transparency on white paper.
    pub(super) fn flattened(
        size: (usize, usize),
        samples: Vec<u8>,
        channels: Channels,
        alpha: Alpha,
    ) -> Self {
        let samples = match (channels, alpha) {
            (_, Alpha::None) => samples,
            (Channels::Grey, _) => on_paper::<1, 2>(samples, alpha, 255),
            (Channels::Rgb, _) => on_paper::<3, 4>(samples, alpha, 255),
            (Channels::Cmyk, _) => on_paper::<4, 5>(samples, alpha, 0),
        };
        Self { size, samples, channels, profile: None, damage: None }
    }

    /// Sets the profile of the file.
    pub(super) fn with_profile(mut self, profile: Option<Vec<u8>>) -> Self {
        self.profile = profile;
        self
    }

    /// The picture in sRGB, reduced by exact area.
    pub(super) fn image(mut self, size: (usize, usize)) -> Result<Image> {
        match correction(self.profile.take(), self.channels)? {
            // After the reduction, which leaves less to do; all that was averaged lies close together.
            Some(correction) => correction.image(self.planes(size)?),
            None => Image::from_planes(self.without_inks().planes(size)?),
        }
    }

    /// Converts inks to light without a profile: each ink removes its complementary third.
    fn without_inks(mut self) -> Self {
        if self.channels == Channels::Cmyk {
            let mut kept = 0;
            for start in (0..self.samples.len() / 4 * 4).step_by(4) {
                let paper = 255 - u32::from(self.samples[start + 3]);
                for ink in start..start + 3 {
                    self.samples[kept] = (((255 - u32::from(self.samples[ink])) * paper + 127) / 255) as u8;
                    kept += 1;
                }
            }
            self.samples.truncate(kept);
            self.channels = Channels::Rgb;
        }
        self
    }

    fn planes(self, size: (usize, usize)) -> Result<Vec<Plane>> {
        let (width, height) = self.size;
        match self.channels {
            Channels::Grey => {
                let plane = Plane::from_samples(width, height, self.samples)?;
                let whole = Region::whole(width, height);
                Ok(vec![if size == self.size {
                    plane
                } else {
                    resize::resample(&plane, whole, size.0, size.1)
                }])
            }
            Channels::Rgb => resize::planes_of_interleaved::<3>(&self.samples, self.size, size),
            Channels::Cmyk => resize::planes_of_interleaved::<4>(&self.samples, self.size, size),
        }
    }
}

/// The picture in sRGB that planes without inks are, one or three of them.
pub(super) fn image_of(planes: Vec<Plane>, profile: Option<Vec<u8>>) -> Result<Image> {
    let channels = if planes.len() == 1 { Channels::Grey } else { Channels::Rgb };
    match correction(profile, channels)? {
        Some(correction) => correction.image(planes),
        None => Image::from_planes(planes),
    }
}

fn correction(profile: Option<Vec<u8>>, channels: Channels) -> Result<Option<icc::Correction>> {
    Ok(profile.map(|profile| icc::correction(&profile, channels)).transpose()?.flatten())
}

/// From brightness and two differences of colour, as JPEG has them (ITU-T T.871), to RGB.
pub(super) fn rgb_of_ycc([y, u, v]: [u8; 3]) -> [u8; 3] {
    let (y, u, v) = (f32::from(y), f32::from(u) - 128.0, f32::from(v) - 128.0);
    // The casts end at 0 and 255.
    [y + 1.402 * v, y - 0.344_136 * u - 0.714_136 * v, y + 1.772 * u].map(|value| (value + 0.5) as u8)
}

/// Reduces the output of the crate `image` to 8 bits per channel. Wide samples are in this machine's byte
/// order; 16 bits are rounded, floats are taken as 0 to 1.
pub(super) fn narrowed(color: ColorType, bytes: Vec<u8>) -> (Vec<u8>, Channels, Alpha) {
    let channels = color.channel_count();
    let alpha = if channels.is_multiple_of(2) { Alpha::Straight } else { Alpha::None };
    let narrow = match color.bytes_per_pixel() / channels {
        2 => bytes.as_chunks().0.iter().map(|&two| of_16_bits(u16::from_ne_bytes(two))).collect(),
        4 => bytes.as_chunks().0.iter().map(|&four| of_float(f32::from_ne_bytes(four))).collect(),
        _ => bytes,
    };
    (narrow, if channels < 3 { Channels::Grey } else { Channels::Rgb }, alpha)
}

pub(super) fn of_16_bits(value: u16) -> u8 {
    ((u32::from(value) + 128) / 257) as u8
}

/// Light of 0 to 1.
pub(super) fn of_float(value: f32) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
}

/// `COLORS` samples and an alpha a pixel, in place; `paper` is the value of white paper.
fn on_paper<const COLORS: usize, const ALL: usize>(mut samples: Vec<u8>, kind: Alpha, paper: u32) -> Vec<u8> {
    let pixels = samples.len() / ALL;
    for i in 0..pixels {
        let alpha = u32::from(samples[ALL * i + COLORS]);
        let bare = paper * (255 - alpha);
        for channel in 0..COLORS {
            let value = u32::from(samples[ALL * i + channel]);
            let value = if kind == Alpha::Multiplied {
                (value + bare / 255).min(255)
            } else {
                (value * alpha + bare + 127) / 255
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
        let (samples, channels, alpha) = narrowed(color, bytes);
        let pixels = samples.len() / usize::from(color.channel_count());
        Pixels::flattened((pixels, 1), samples, channels, alpha).samples
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
        let on_white = |channels, samples: &[u8]| {
            Pixels::flattened((1, 1), samples.to_vec(), channels, Alpha::Straight).samples
        };
        assert_eq!(on_white(Channels::Grey, &[10, 0, 10, 255, 10, 128]), [255, 10, 132]);
        // Paper has no ink.
        assert_eq!(
            on_white(Channels::Cmyk, &[10, 20, 30, 40, 0, 10, 20, 30, 40, 255]),
            [0, 0, 0, 0, 10, 20, 30, 40]
        );
        let rgb = flattened(ColorType::Rgba8, vec![9, 8, 7, 255, 0, 0, 0, 0]);
        assert_eq!(rgb, [9, 8, 7, 255, 255, 255]);
        let wide = [1000u16, 2000, 3000, 65535].map(u16::to_ne_bytes).concat();
        assert_eq!(flattened(ColorType::Rgba16, wide), [4, 8, 12]);
    }

    #[test]
    fn colours_that_are_multiplied_already_are_not_multiplied_again() {
        let on_white = |channels, samples: &[u8]| {
            Pixels::flattened((1, 1), samples.to_vec(), channels, Alpha::Multiplied).samples
        };
        assert_eq!(on_white(Channels::Rgb, &[128, 0, 0, 128]), [255, 127, 127]);
        assert_eq!(on_white(Channels::Cmyk, &[64, 0, 0, 10, 128]), [64, 0, 0, 10]);
        // More colour than there can be ends at white.
        assert_eq!(on_white(Channels::Grey, &[200, 100]), [255]);
    }

    #[test]
    fn inks_take_light_away() {
        let seen = |inks: [u8; 4]| {
            let pixels = Pixels::flattened((1, 1), inks.to_vec(), Channels::Cmyk, Alpha::None);
            pixels.image((1, 1)).unwrap().to_rgb()
        };
        assert_eq!(seen([0; 4]), [255; 3]);
        assert_eq!(seen([255, 0, 0, 0]), [0, 255, 255]);
        assert_eq!(seen([0, 0, 0, 255]), [0; 3]);
        assert_eq!(seen([51, 0, 102, 51]), [163, 204, 122]);
    }
}
