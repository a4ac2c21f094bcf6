//! A style from a picture: chains of blocks are looked for that give a person's own photo the look of a picture (a comic
//! page, a print, a painting). What comes out is a style like any other, which can be read and designed on.
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
//! | `apart` | how far one look is from another |
//! | `search` | what is tried, and what is proposed |
//! | `nothing` | pictures that have no look of their own |

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
pub use search::{Ask, Effort, Search};
pub use spectrum::Screen;

use super::context::{Context, scale_of};
use super::look::signature;
use super::{Style, stylize};
use crate::error::Result;
use crate::raster::Image;
use crate::raster::resize::{Region, resample_image};
use features::FINE;
use serde::{Deserialize, Serialize};

/// Reads the look of a picture.
///
/// # Errors
/// `small-picture`, `blank-picture` or `plain-photo` where there is nothing to imitate.
pub fn read(picture: &Image) -> Result<Features> {
    let features = read_any(picture)?;
    nothing::check_look(&features)?;
    Ok(features)
}

/// The same of whatever somebody insists on: a painting may be told from a photo by people alone.
///
/// # Errors
/// `small-picture`.
pub fn read_any(picture: &Image) -> Result<Features> {
    nothing::check_size(picture)?;
    Ok(Features::of(picture))
}

/// What came of a style.
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
    /// The photo for a trial; all that are asked for at once see it alike.
    #[must_use]
    pub fn of(photo: &Image, ask: &Ask) -> Self {
        if ask.close {
            return Self { image: middle(photo, ask.area), scale: scale_of(FINE as f64), close: true };
        }
        let image = features::reduced(photo, ask.area);
        let scale = scale_of(image.width() as f64 * image.height() as f64);
        Self { image, scale, close: false }
    }
}

/// Draws a photo in a style and reads its look.
///
/// # Errors
/// `cancelled` when the context says so.
pub fn attempt(seen: &Seen, style: &Style, context: &mut Context<'_>) -> Result<Trial> {
    context.set_scale(seen.scale);
    let drawn = stylize(&seen.image, style, context)?;
    let mut features = Features::at_size(&drawn);
    if seen.close {
        features.screen = spectrum::screen(&crate::simd::point::luma_plane(&drawn), seen.scale);
    }
    Ok(Trial { features, signature: signature(&drawn) })
}

/// The middle of the photo as it is in a large picture of it.
fn middle(photo: &Image, area: usize) -> Image {
    let (width, height) = (photo.width() as f64, photo.height() as f64);
    let part = (area as f64 / FINE as f64).sqrt();
    let factor = (FINE as f64 / (width * height)).sqrt();
    let region = Region {
        x: 0.5 * width * (1.0 - part),
        y: 0.5 * height * (1.0 - part),
        width: width * part,
        height: height * part,
    };
    let side = |length: f64| ((length * part * factor).round() as usize).max(1);
    resample_image(photo, region, side(width), side(height))
}
