//! PNG export.

use super::compose::Sheet;
use crate::error::{Error, Result};
use crate::raster::Plane;
use png::{BitDepth, ColorType, Compression, Encoder, PixelDimensions, SrgbRenderingIntent, Unit};

/// Encodes a page as an 8-bit RGB PNG with its resolution and the sRGB mark.
///
/// # Errors
/// `encode` when the encoder fails, which only memory can make it do.
pub fn encode(sheet: &Sheet, dpi: u32) -> Result<Vec<u8>> {
    encode_rgb(sheet.width(), sheet.height(), sheet.rgb(), dpi)
}

/// Encodes interleaved RGB.
///
/// # Errors
/// `encode` when `rgb` does not hold `3 * width * height` bytes.
pub fn encode_rgb(width: usize, height: usize, rgb: &[u8], dpi: u32) -> Result<Vec<u8>> {
    encoded((width, height), ColorType::Rgb, rgb, dpi)
}

/// Encodes a plane as a gray PNG.
///
/// # Errors
/// As [`encode_rgb`].
pub fn encode_gray(plane: &Plane) -> Result<Vec<u8>> {
    encoded((plane.width(), plane.height()), ColorType::Grayscale, plane.samples(), 72)
}

/// Encodes interleaved RGBA with straight alpha.
///
/// # Errors
/// As [`encode_rgb`].
pub fn encode_rgba(width: usize, height: usize, rgba: &[u8]) -> Result<Vec<u8>> {
    encoded((width, height), ColorType::Rgba, rgba, 72)
}

fn encoded((width, height): (usize, usize), color: ColorType, samples: &[u8], dpi: u32) -> Result<Vec<u8>> {
    let failed = |error: png::EncodingError| Error::Encode(error.to_string());
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width as u32, height as u32);
    encoder.set_color(color);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    // Speed is more important than a few per cent of the size, which take ten times as long.
    encoder.set_compression(Compression::Fast);
    let per_metre = (f64::from(dpi) / 0.0254).round() as u32;
    encoder.set_pixel_dims(Some(PixelDimensions { xppu: per_metre, yppu: per_metre, unit: Unit::Meter }));
    let mut writer = encoder.write_header().map_err(failed)?;
    writer.write_image_data(samples).map_err(failed)?;
    writer.finish().map_err(failed)?;
    Ok(bytes)
}
