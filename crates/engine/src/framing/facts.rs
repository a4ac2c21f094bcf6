//! Properties of a photo for styles and page breaks: tones, texture, colours. Measured once, at import, on
//! the small copy.

use serde::{Deserialize, Serialize};

use super::bars::bars;
use super::pixel::{luma, rgb};
use crate::raster::Image;

/// Maximum pixels along the longer side that are analysed.
const SAMPLES: usize = 240;
/// Steps of luma that are counted.
pub(super) const TONES: usize = 16;
/// Minimum difference of luma between neighbours at an edge, in grey levels.
const EDGE: u32 = 20;

/// Facts about the pixels of a photo. Shares are in 255ths of the whole photo.
///
/// As JSON a string of two hexadecimal digits for each of their 25 numbers, shares in 255ths. The bars follow if there are any.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Facts {
    /// Share of each sixteenth of luma, dark first, in 255ths of the whole photo.
    pub tones: [u8; TONES],
    /// The share of pixels on an edge, between neighbours and between pixels eight times as far apart.
    pub edges: [u8; 2],
    /// Mean distance of the largest to the smallest channel.
    pub chroma: u8,
    /// Mean R, G and B of the upper and of the lower half. They distinguish scenes, such as a beach and a
    /// bar.
    pub colours: [u8; 6],
    /// Widths of uniform bars at the left, top, right and bottom edge, in 255ths of the side.
    pub bars: [u8; 4],
}

impl Facts {
    /// Measures a photo (any size; a small one will do).
    #[must_use]
    pub fn of(image: &Image) -> Self {
        let (width, height) = (image.width(), image.height());
        let step = width.max(height).div_ceil(SAMPLES);
        let far = 8 * step;
        let mut tones = [0u64; TONES];
        let (mut count, mut fine, mut coarse, mut chroma) = (0u64, 0u64, 0u64, 0u64);
        let mut halves = [([0u64; 3], 0u64); 2];
        for y in (0..height).step_by(step) {
            for x in (0..width).step_by(step) {
                let pixel = rgb(image, x, y);
                let here = luma(pixel);
                let edge = |apart: usize| {
                    let across = luma(rgb(image, (x + apart).min(width - 1), y)).abs_diff(here);
                    let down = luma(rgb(image, x, (y + apart).min(height - 1))).abs_diff(here);
                    u64::from(across.max(down) > EDGE)
                };
                count += 1;
                fine += edge(step);
                coarse += edge(far);
                tones[(here as usize * TONES / 256).min(TONES - 1)] += 1;
                chroma += u64::from(pixel.iter().max().unwrap_or(&0) - pixel.iter().min().unwrap_or(&0));
                let half = &mut halves[usize::from(2 * y >= height)];
                half.1 += 1;
                for (sum, value) in half.0.iter_mut().zip(pixel) {
                    *sum += u64::from(value);
                }
            }
        }
        let share = |n: u64| (255.0 * n as f64 / count.max(1) as f64).round() as u8;
        let mean = |half: usize, channel: usize| (halves[half].0[channel] / halves[half].1.max(1)) as u8;
        // A photo of one row has no lower half.
        let lower = usize::from(halves[1].1 > 0);
        Self {
            tones: tones.map(share),
            edges: [share(fine), share(coarse)],
            chroma: (chroma / count.max(1)) as u8,
            colours: [mean(0, 0), mean(0, 1), mean(0, 2), mean(lower, 0), mean(lower, 1), mean(lower, 2)],
            bars: bars(image),
        }
    }

    /// Mean and standard deviation of the luma, 0 to 1.
    #[must_use]
    pub fn spread(&self) -> (f64, f64) {
        let level = |i: usize| (i as f64 + 0.5) / TONES as f64;
        let total: f64 = self.tones.iter().map(|&n| f64::from(n)).sum::<f64>().max(1.0);
        let sum = |f: &dyn Fn(f64) -> f64| -> f64 {
            self.tones.iter().enumerate().map(|(i, &n)| f64::from(n) * f(level(i))).sum::<f64>() / total
        };
        let mean = sum(&|v| v);
        (mean, sum(&|v| (v - mean).powi(2)).sqrt())
    }
}

impl From<Facts> for String {
    fn from(facts: Facts) -> Self {
        let Facts { tones, edges, chroma, colours, bars } = facts;
        let bars = if bars == [0; 4] { Vec::new() } else { bars.to_vec() };
        let digit = |value: u8| char::from_digit(u32::from(value), 16).unwrap_or('0');
        let bytes = tones.into_iter().chain(edges).chain([chroma]).chain(colours).chain(bars);
        bytes.flat_map(|value| [digit(value >> 4), digit(value & 15)]).collect()
    }
}

impl TryFrom<String> for Facts {
    type Error = &'static str;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        const WRONG: &str = "photo metrics must have 50 or 58 hexadecimal digits";
        let digits: Option<Vec<u8>> =
            text.chars().map(|digit| digit.to_digit(16).map(|value| value as u8)).collect();
        let lengths = [2 * (TONES + 9), 2 * (TONES + 13)];
        let digits = digits.filter(|digits| lengths.contains(&digits.len())).ok_or(WRONG)?;
        let byte = |i: usize| digits[2 * i] << 4 | digits[2 * i + 1];
        Ok(Self {
            tones: std::array::from_fn(byte),
            edges: std::array::from_fn(|i| byte(TONES + i)),
            chroma: byte(TONES + 2),
            colours: std::array::from_fn(|i| byte(TONES + 3 + i)),
            bars: std::array::from_fn(|i| if digits.len() > lengths[0] { byte(TONES + 9 + i) } else { 0 }),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Plane;

    fn gray(width: usize, height: usize, at: impl Fn(usize, usize) -> u8) -> Image {
        Image::from_luma(Plane::from_fn(width, height, at))
    }

    #[test]
    fn tones_texture_and_colours_are_told_apart() {
        let black = Facts::of(&gray(80, 60, |_, _| 0));
        assert_eq!((black.tones[0], black.edges, black.chroma), (255, [0, 0], 0));
        assert!(black.spread().1 < 1e-9);
        let checks = Facts::of(&gray(80, 60, |x, y| if (x + y) % 2 == 0 { 0 } else { 255 }));
        assert!(checks.edges[0] > 230 && checks.edges[1] < 77 && checks.spread().1 > 0.4);
        let planes = [255, 0, 0].map(|v| Plane::filled(40, 40, v));
        let red = Facts::of(&Image::from_rgb(planes).unwrap());
        assert!(red.chroma == 255);
        assert_eq!(red.colours, [255, 0, 0, 255, 0, 0]);
    }

    #[test]
    fn any_size_has_facts_that_survive_json() {
        for (width, height) in [(1, 1), (1, 900), (900, 1), (1000, 7)] {
            let facts = Facts::of(&gray(width, height, |x, y| (x + y) as u8));
            let json = serde_json::to_string(&facts).unwrap();
            assert_eq!(serde_json::from_str::<Facts>(&json).unwrap(), facts);
        }
        for bad in ["\"\"", "\"zz\"", "7", "\"00\""] {
            assert!(serde_json::from_str::<Facts>(bad).is_err(), "{bad}");
        }
    }
}
