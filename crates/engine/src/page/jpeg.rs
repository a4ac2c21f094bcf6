//! JPEG files of pages, and of panels in a PDF file.

use super::srgb;
use crate::error::{Error, Result};
use jpeg_encoder::{ColorType, Encoder, PixelDensity, SamplingFactor};

/// Encodes interleaved RGB with a quality from 1 to 100, with its resolution and sRGB profile, and without
/// other metadata.
///
/// # Errors
/// `encode` when `rgb` does not hold `3 * width * height` bytes, or a side is longer than 65,535 pixels.
pub fn encode_rgb(width: usize, height: usize, rgb: &[u8], dpi: u32, quality: u8) -> Result<Vec<u8>> {
    encode(width, height, (rgb, ColorType::Rgb), dpi, quality, true)
}

/// Encodes an image that is embedded in a file with a colour profile: RGBA, whose alpha is dropped, or gray if `samples`
/// has one value per pixel.
///
/// # Errors
/// `encode` as above.
pub fn encode_part(width: usize, height: usize, samples: &[u8], dpi: u32, quality: u8) -> Result<Vec<u8>> {
    let gray = samples.len() == width * height;
    let kind = if gray { ColorType::Luma } else { ColorType::Rgba };
    encode(width, height, (samples, kind), dpi, quality, false)
}

fn encode(
    width: usize,
    height: usize,
    (samples, kind): (&[u8], ColorType),
    dpi: u32,
    quality: u8,
    alone: bool,
) -> Result<Vec<u8>> {
    let failed = |reason: String| Error::Encode(reason);
    let channels = match kind {
        ColorType::Luma => 1,
        ColorType::Rgb => 3,
        _ => 4,
    };
    if samples.len() != width * height * channels {
        return Err(failed("the number of pixels does not match width and height".into()));
    }
    let side = |pixels: usize| {
        u16::try_from(pixels).map_err(|_| failed(format!("a side has {pixels} pixels, at most {}", u16::MAX)))
    };
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, quality.clamp(1, 100));
    // Colours keep their full size, because subsampling blurs thin coloured lines.
    encoder.set_sampling_factor(SamplingFactor::R_4_4_4);
    encoder.set_density(PixelDensity::dpi(dpi.min(u32::from(u16::MAX)) as u16));
    if alone {
        encoder.add_icc_profile(srgb::profile()).map_err(|error| failed(error.to_string()))?;
    }
    encoder.encode(samples, side(width)?, side(height)?, kind).map_err(|error| failed(error.to_string()))?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::decode::{Limits, decode};

    #[test]
    fn the_file_says_its_resolution_and_has_the_pixels() {
        let rgb: Vec<u8> = (0..40 * 30).flat_map(|i| [(i % 40 * 6) as u8, (i / 40 * 8) as u8, 90]).collect();
        let bytes = encode_rgb(40, 30, &rgb, 300, 95).unwrap();
        // The JFIF segment: horizontal and vertical DPI.
        assert_eq!(&bytes[6..11], b"JFIF\0");
        assert_eq!(bytes[13..18], [1, 1, 44, 1, 44]);
        let back = decode(&bytes, &Limits::default()).unwrap().image;
        assert_eq!((back.width(), back.height()), (40, 30));
        let off: u32 =
            back.to_rgb().iter().zip(&rgb).map(|(&a, &b)| u32::from(a.abs_diff(b))).sum::<u32>() / 3600;
        assert!(off < 3, "{off}");
        let poor = encode_rgb(40, 30, &rgb, 300, 20).unwrap();
        assert!(poor.len() < bytes.len());
        let holds = |file: &[u8]| file.windows(12).any(|window| window == b"ICC_PROFILE\0");
        let rgba: Vec<u8> = rgb.chunks_exact(3).flat_map(|rgb| [rgb[0], rgb[1], rgb[2], 7]).collect();
        let part = encode_part(40, 30, &rgba, 300, 95).unwrap();
        assert_eq!((holds(&bytes), holds(&part)), (true, false));
    }

    #[test]
    fn too_few_pixels_are_an_error() {
        assert_eq!(encode_rgb(4, 4, &[0; 12], 96, 90).unwrap_err().code(), "encode");
    }
}
