//! Custom texture for Pattern Filling: a small PNG or JPEG file, stored in the style as a data URL. So a
//! style remains a single file.

use crate::raster::Plane;
use crate::raster::decode::{Limits, decode_fit};
use crate::simd::point::luma_plane;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// Bytes of the picture's file.
pub const MOST_BYTES: usize = 256 << 10;

/// Pixels of the longer side that are drawn; a larger picture is reduced.
const LONGEST: usize = 512;

/// Limits for decoding: a texture of a few kilobytes may announce a huge picture.
const LIMITS: Limits = Limits { max_pixels: 16_000_000, max_side: 8192, max_bytes: 128 << 20 };

/// Minimum difference between the darkest and the lightest tone, in grey levels. A texture with less contrast
/// cannot draw tones.
const LEAST_CONTRAST: u8 = 8;

/// Parts of a grey step in which a blur is computed.
const PARTS: u32 = 16;

/// A decoded texture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Texture {
    url: String,
    tones: Plane,
}

impl Texture {
    /// Reads `data:image/png;base64,...` or the same with `image/jpeg`.
    ///
    /// # Errors
    /// The reason as the end of a sentence about the texture.
    pub fn read(url: &str) -> Result<Self, String> {
        const SHAPE: &str =
            "must be a PNG or JPEG picture as a data URL: data:image/png;base64, and its bytes in base64";
        let rest = ["image/png", "image/jpeg"]
            .iter()
            .find_map(|kind| url.strip_prefix("data:")?.strip_prefix(kind)?.strip_prefix(";base64,"));
        let rest = rest.ok_or(SHAPE)?;
        let size = rest.trim_end_matches('=').len() * 3 / 4;
        if size > MOST_BYTES {
            let kilobytes = size.div_ceil(1024);
            return Err(format!(
                "is a picture of {kilobytes} kB, it may have at most {}; save it smaller",
                MOST_BYTES >> 10
            ));
        }
        let bytes = STANDARD.decode(rest).map_err(|error| format!("is not valid base64: {error}"))?;
        let decoded =
            decode_fit(&bytes, &LIMITS, LONGEST).map_err(|error| format!("cannot be read: {error}"))?;
        if !["PNG", "JPEG"].contains(&decoded.format) {
            return Err(format!("holds a {} picture; {SHAPE}", decoded.format));
        }
        let luma = luma_plane(&decoded.image);
        let (darkest, lightest) =
            luma.samples().iter().fold((255, 0), |(low, high), &v| (v.min(low), v.max(high)));
        if lightest < darkest.saturating_add(LEAST_CONTRAST) {
            return Err("has one tone only, so nothing can be drawn with it".into());
        }
        Ok(Self { url: url.to_owned(), tones: tones(&luma) })
    }

    /// The data URL.
    #[must_use]
    pub fn url(&self) -> &str {
        &self.url
    }

    /// Returns the order in which pixels take ink, the darkest first. Two thirds are the tone of a pixel, one
    /// third the tone of its surroundings, so that lines swell in a picture of only two tones.
    pub(crate) fn tones(&self) -> &Plane {
        &self.tones
    }
}

fn tones(luma: &Plane) -> Plane {
    let (width, height) = (luma.width(), luma.height());
    let radius = (width.min(height) / 48).max(1);
    let mut around: Vec<u32> = luma.samples().iter().map(|&v| u32::from(v) * PARTS).collect();
    // Three boxes are nearly a Gaussian.
    for _ in 0..3 {
        for row in around.chunks_exact_mut(width) {
            let means = box_means(row, radius);
            row.copy_from_slice(&means);
        }
        for x in 0..width {
            let column: Vec<u32> = around.iter().skip(x).step_by(width).copied().collect();
            for (y, mean) in box_means(&column, radius).into_iter().enumerate() {
                around[y * width + x] = mean;
            }
        }
    }
    Plane::from_fn(width, height, |x, y| {
        let sum = 2 * PARTS * u32::from(luma.at(x, y)) + around[y * width + x];
        ((sum + 3 * PARTS / 2) / (3 * PARTS)) as u8
    })
}

/// Returns the mean of `2 radius + 1` values around each value of a cyclic line.
fn box_means(line: &[u32], radius: usize) -> Vec<u32> {
    let (length, count) = (line.len(), 2 * radius + 1);
    let at = |i: usize| line[i % length];
    // Whole periods are added, so that no index is below zero.
    let start = length * radius.div_ceil(length) - radius;
    let mut sum: u32 = (start..start + count).map(at).sum();
    (0..length)
        .map(|i| {
            let mean = (sum + count as u32 / 2) / count as u32;
            sum = sum + at(start + i + count) - at(start + i);
            mean
        })
        .collect()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// A data URL of a gray PNG.
    pub(crate) fn url_of(width: u32, height: u32, tone: impl Fn(u32, u32) -> u8) -> String {
        let samples: Vec<u8> =
            (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| tone(x, y)).collect();
        let mut file = Vec::new();
        let mut encoder = ::png::Encoder::new(&mut file, width, height);
        encoder.set_color(::png::ColorType::Grayscale);
        encoder.write_header().unwrap().write_image_data(&samples).unwrap();
        format!("data:image/png;base64,{}", STANDARD.encode(file))
    }

    #[test]
    fn a_picture_comes_back_as_it_was_told() {
        let url = url_of(32, 16, |x, _| if x % 8 < 4 { 0 } else { 255 });
        let texture = Texture::read(&url).unwrap();
        assert_eq!(texture.url(), url);
        assert_eq!((texture.tones().width(), texture.tones().height()), (32, 16));
        // The middle of a dark stripe is darker than its border, though the picture has two tones.
        let row = texture.tones().row(7);
        assert!(row[1] < row[3] && row[3] < row[4] && row[4] < row[6], "{row:?}");
    }

    #[test]
    fn each_fault_has_its_reason() {
        let good = url_of(16, 16, |x, _| (x * 16) as u8);
        let cut = &good[..22 + (good.len() - 22) / 2 / 4 * 4];
        let noise = |x: u32, y: u32| ((x ^ y).wrapping_mul(0x9e37_79b9) >> 9) as u8 ^ (x * y) as u8;
        let cases = [
            ("hatch.png".to_owned(), "must be a PNG or JPEG picture as a data URL"),
            ("data:image/gif;base64,AAAA".to_owned(), "must be a PNG or JPEG"),
            ("data:image/png;base64,*".to_owned(), "is not valid base64"),
            ("data:image/png;base64,AAAA".to_owned(), "cannot be read"),
            (cut.to_owned(), "cannot be read"),
            (format!("data:image/png;base64,{}", "A".repeat(360_000)), "at most 256"),
            (url_of(16, 16, |_, _| 90), "one tone only"),
        ];
        for (url, reason) in cases {
            let told = Texture::read(&url).unwrap_err();
            assert!(told.contains(reason), "{told}");
        }
        assert!(Texture::read(&url_of(40, 40, noise)).is_ok());
    }

    #[test]
    fn means_of_a_line_go_round_it_however_short_it_is() {
        assert_eq!(box_means(&[3, 0, 0, 0], 1), [1, 1, 0, 1]);
        assert_eq!(box_means(&[8], 3), [8]);
        assert_eq!(box_means(&[0, 10], 2), [4, 6]);
    }
}
