//! Style from a picture: searches for chains of blocks that give the user's photo the look of a comic page, a
//! print or a painting. The result is an ordinary style, which the user can read and edit.
//!
//! ```text
//! picture -> features (features.rs) -> nothing to imitate? (nothing.rs)
//!                |
//!         search (search.rs): asks for styles to try ──> trial: photo in that style -> features
//!                ^                                           |
//!                └──────────── how far apart (apart.rs) <────┘
//! ```
//!
//! | module | for |
//! |---|---|
//! | `features` | tones, palette, lines, screen, texture of a picture |
//! | `colours`, `lines`, `spectrum` | parts of that |
//! | `inks` | the paper and inks that a print was made with |
//! | `dressing` | designed styles in the colours of the picture |
//! | `apart` | distance between two looks |
//! | `search` | the styles to try and to propose |
//! | `nothing` | pictures without a distinct look |

mod apart;
mod colours;
mod dressing;
mod features;
mod inks;
mod lines;
mod nothing;
mod search;
mod spectrum;

pub use colours::{Colour, delta_e, palette_distance};
pub use features::Features;
pub use lines::Lines;
pub use search::{Ask, Effort, Search, survey};
pub use spectrum::Screen;

use super::context::{Context, scale_of};
use super::look::signature;
use super::{Style, stylize};
use crate::error::Result;
use crate::raster::resize::{Region, resample_image};
use crate::raster::{Image, Plane};
use crate::simd::point::luma_plane;
use features::FINE;
use serde::{Deserialize, Serialize};

/// Reads the look of a picture.
///
/// # Errors
/// `small-picture`, `blank-picture` or `plain-photo` if the picture has no look to imitate.
pub fn read(picture: &Image) -> Result<Features> {
    let features = read_any(picture)?;
    nothing::check_look(picture, &features)?;
    Ok(features)
}

/// Reads the features without the check for plain photos, if the user insists. Only a person can distinguish
/// some paintings from photos.
///
/// # Errors
/// `small-picture`.
pub fn read_any(picture: &Image) -> Result<Features> {
    nothing::check_size(picture)?;
    Ok(Features::of(picture))
}

/// The result of a trial of a style.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Trial {
    /// The look of the photo in it.
    pub features: Features,
    /// See [`signature`].
    pub signature: Vec<u8>,
}

/// A photo as it is seen in trials.
pub struct Seen {
    image: Image,
    scale: f32,
    close: bool,
}

impl Seen {
    /// Returns the photo for a trial. Simultaneous trials use the same photo.
    #[must_use]
    pub fn of(photo: &Image, ask: &Ask) -> Self {
        if ask.close {
            return Self { image: telling(photo, ask.area), scale: scale_of(FINE as f64), close: true };
        }
        let image = features::reduced(photo, ask.area);
        let scale = scale_of(image.width() as f64 * image.height() as f64);
        Self { image, scale, close: false }
    }
}

/// Draws a photo in a style and reads its look.
///
/// # Errors
/// `cancelled` if the context is cancelled.
pub fn attempt(seen: &Seen, style: &Style, context: &mut Context<'_>) -> Result<Trial> {
    context.set_scale(seen.scale);
    let drawn = stylize(&seen.image, style, context)?;
    let mut features = Features::at_size(&drawn);
    if seen.close {
        features.screen = spectrum::screen(&luma_plane(&drawn), seen.scale);
    }
    Ok(Trial { features, signature: signature(&drawn) })
}

/// Pixels of the reduced photo for selecting the close-up.
const SKETCH: usize = 20_000;
/// Number of candidate windows for the close-up, along each side.
const WINDOWS: usize = 5;

/// Returns the part of the photo that shows a screen best, at the scale of a large picture.
fn telling(photo: &Image, area: usize) -> Image {
    let (width, height) = (photo.width() as f64, photo.height() as f64);
    let part = (area as f64 / FINE as f64).sqrt();
    let factor = (FINE as f64 / (width * height)).sqrt();
    let (x, y) = window(&luma_plane(&features::reduced(photo, SKETCH)), part);
    let region = Region { x: x * width, y: y * height, width: width * part, height: height * part };
    let side = |length: f64| ((length * part * factor).round() as usize).max(1);
    resample_image(photo, region, side(width), side(height))
}

/// Returns the left and upper edge, as parts of the whole, of the window with the most middle tones and the
/// least texture. Dots in middle tones have room to grow and to shrink, and no other pattern disturbs the
/// measurement.
fn window(luma: &Plane, part: f64) -> (f64, f64) {
    let (width, height) = (luma.width(), luma.height());
    let clear = |x: usize, y: usize| {
        let here = luma.at(x, y);
        let texture = here
            .abs_diff(luma.at((x + 1).min(width - 1), y))
            .max(here.abs_diff(luma.at(x, (y + 1).min(height - 1))));
        let middle = 1.0 - (f64::from(here) - 127.5).abs() / 127.5;
        middle / (1.0 + f64::from(texture) / 8.0)
    };
    let places = (0..WINDOWS * WINDOWS).map(|i| {
        let at = |i: usize| (1.0 - part).max(0.0) * i as f64 / (WINDOWS - 1) as f64;
        (at(i % WINDOWS), at(i / WINDOWS))
    });
    let clarity = |&(x, y): &(f64, f64)| -> f64 {
        let range = |from: f64, side: usize| {
            (from * side as f64) as usize..(((from + part) * side as f64).ceil() as usize).min(side)
        };
        range(y, height).map(|y| range(x, width).map(|x| clear(x, y)).sum::<f64>()).sum()
    };
    let rated = places.map(|place| (clarity(&place), place));
    rated.max_by(|a, b| a.0.total_cmp(&b.0)).map_or((0.0, 0.0), |(_, place)| place)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn screens_are_looked_for_in_even_middle_tones() {
        let noise = |x: usize, y: usize| ((x * 7919 + y * 104_729) % 251) as u8;
        // Dark on the left, busy above, even and middle at the lower right.
        let luma = Plane::from_fn(100, 80, |x, y| match (x < 40, y < 40) {
            (true, _) => 4,
            (_, true) => noise(x, y),
            _ => 128,
        });
        let (x, y) = window(&luma, 0.4);
        assert!((x - 0.6).abs() < 0.16 && (y - 0.6).abs() < 0.16, "{x} {y}");
        // A part with full size has only one position.
        assert_eq!(window(&luma, 1.0), (0.0, 0.0));
    }
}
