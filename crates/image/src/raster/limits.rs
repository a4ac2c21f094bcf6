//! Limits of decoding, and the damage that a decoded file may have.

use std::fmt::{self, Display, Formatter};

use serde::Serialize;

use crate::error::{Error, Result};

/// Maximum size of an ICC profile or another metadata record, in bytes. Larger records are skipped. No
/// camera, screen or press writes such records.
pub(super) const MOST_PROFILE: usize = 4 << 20;

/// Limits for a decoded file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Limits {
    /// Width times height.
    pub max_pixels: u64,
    /// The longer side, in pixels.
    pub max_side: u32,
    /// Memory for decoding, in bytes: the decoder's pixels and ours together.
    pub max_bytes: u64,
}

impl Default for Limits {
    /// 120 megapixels (more than most phones produce by default), 32768 pixels per side, 1 GiB.
    fn default() -> Self {
        Self { max_pixels: 120_000_000, max_side: 32_768, max_bytes: 1 << 30 }
    }
}

impl Limits {
    /// Checks the announced sides before memory is allocated. `name` is the name of the format.
    ///
    /// # Errors
    /// `damaged` for a side of 0, `too-large` for a side or an area beyond the limits.
    pub fn check(&self, width: u32, height: u32, name: &'static str) -> Result<()> {
        if width == 0 || height == 0 {
            return Err(Error::damaged(name, "its width or height is zero or missing"));
        }
        if width.max(height) > self.max_side {
            return Err(too_large(width, height, format!("{} pixels per side", self.max_side)));
        }
        if u64::from(width) * u64::from(height) > self.max_pixels {
            return Err(too_large(width, height, format!("{} megapixels", self.max_pixels / 1_000_000)));
        }
        Ok(())
    }
}

/// Damage of a file that was decoded nevertheless.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Damage {
    /// Missing share of the image, drawn grey, from 0 to 1.
    pub missing: f64,
    /// Share of the image without detail, from 0 to 1.
    pub coarse: f64,
}

impl Damage {
    /// Maximum share of a picture that may be missing.
    const MAX_MISSING: f64 = 0.5;

    /// Returns `None` for a picture without damage, and an error for one that is mostly missing.
    pub(super) fn checked(self, format: &'static str) -> Result<Option<Self>> {
        if self.missing > Self::MAX_MISSING {
            return Err(Error::MostlyDamaged { format, percent: ((1.0 - self.missing) * 100.0) as u8 });
        }
        Ok((self.missing > 0.0 || self.coarse > 0.0).then_some(self))
    }
}

/// Describes the damage: `12 % of the picture is damaged and drawn grey`.
impl Display for Damage {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let (share, what) = if self.missing > 0.0 {
            (self.missing, "is damaged and drawn grey")
        } else {
            (self.coarse, "lacks detail, because the file is damaged or incomplete")
        };
        match (share * 100.0).round() {
            0.0 => write!(out, "less than 1 % of the picture {what}"),
            percent => write!(out, "{percent} % of the picture {what}"),
        }
    }
}

/// The decoder's pixels and ours together must fit.
pub(super) fn check_memory(size: (usize, usize), bytes_per_pixel: u64, limits: &Limits) -> Result<()> {
    let pixels = size.0 as u64 * size.1 as u64;
    if pixels.saturating_mul(bytes_per_pixel + 4) > limits.max_bytes {
        return Err(out_of_memory(size, limits));
    }
    Ok(())
}

/// The error of an image that needs more memory than the limits allow.
pub(super) fn out_of_memory((width, height): (usize, usize), limits: &Limits) -> Error {
    too_large(width as u32, height as u32, format!("{} MB of memory", limits.max_bytes >> 20))
}

fn too_large(width: u32, height: u32, limit: String) -> Error {
    Error::TooLarge { width: width.into(), height: height.into(), limit }
}
