//! Lossless WebP files of pages and of images with alpha, for browsers without a WebP encoder.

use crate::error::{Error, Result};
use image::ExtendedColorType;
use image::codecs::webp::WebPEncoder;

/// Encodes interleaved RGB as a lossless WebP file.
///
/// # Errors
/// `encode` when `rgb` does not hold `3 * width * height` bytes, or a side is 0 or longer than 16,384 pixels.
pub fn encode_rgb(width: usize, height: usize, rgb: &[u8]) -> Result<Vec<u8>> {
    encode((width, height), rgb, (3, ExtendedColorType::Rgb8))
}

/// Encodes interleaved RGB with straight alpha as a lossless WebP file.
///
/// # Errors
/// As [`encode_rgb`], of `4 * width * height` bytes.
pub fn encode_rgba(width: usize, height: usize, rgba: &[u8]) -> Result<Vec<u8>> {
    encode((width, height), rgba, (4, ExtendedColorType::Rgba8))
}

fn encode(
    (width, height): (usize, usize),
    samples: &[u8],
    (channels, color): (usize, ExtendedColorType),
) -> Result<Vec<u8>> {
    if samples.len() != width * height * channels {
        return Err(Error::Encode("the number of pixels does not match width and height".into()));
    }
    let mut bytes = Vec::new();
    WebPEncoder::new_lossless(&mut bytes)
        .encode(samples, width as u32, height as u32, color)
        .map_err(|error| Error::Encode(error.to_string()))?;
    Ok(bytes)
}

#[cfg(all(test, feature = "rare"))]
mod tests {
    use super::*;
    use crate::raster::decode::{Limits, decode};

    #[test]
    fn the_file_has_the_very_pixels() {
        let rgb: Vec<u8> = (0..40 * 30).flat_map(|i| [(i % 40 * 6) as u8, (i / 40 * 8) as u8, 90]).collect();
        let bytes = encode_rgb(40, 30, &rgb).unwrap();
        let back = decode(&bytes, &Limits::default()).unwrap();
        assert_eq!((back.format, back.image.width(), back.image.height()), ("WebP", 40, 30));
        assert_eq!(back.image.to_rgb(), rgb);
    }

    #[test]
    fn alpha_is_kept() {
        let rgba: Vec<u8> = (0..20 * 10).flat_map(|i| [i as u8, 40, 90, (i % 20 * 12) as u8]).collect();
        let bytes = encode_rgba(20, 10, &rgba).unwrap();
        let back = image::load_from_memory_with_format(&bytes, image::ImageFormat::WebP).unwrap();
        assert_eq!(back.to_rgba8().into_raw(), rgba);
        assert_eq!(encode_rgba(4, 4, &[0; 48]).unwrap_err().code(), "encode");
    }

    #[test]
    fn too_few_pixels_and_sides_too_long_are_errors() {
        assert_eq!(encode_rgb(4, 4, &[0; 12]).unwrap_err().code(), "encode");
        assert_eq!(encode_rgb(16_385, 1, &vec![0; 3 * 16_385]).unwrap_err().code(), "encode");
    }
}
