//! Pictures that have no look of their own.

use super::features::Features;
use crate::error::{Error, Result};
use crate::raster::Image;

/// Shortest side of a picture, in pixels.
const SHORTEST: usize = 64;

/// # Errors
/// `small-picture`.
pub(super) fn check_size(picture: &Image) -> Result<()> {
    let (width, height) = (picture.width(), picture.height());
    if width.min(height) < SHORTEST {
        Err(Error::SmallPicture { width, height, least: SHORTEST })
    } else {
        Ok(())
    }
}

/// # Errors
/// `blank-picture`, `plain-photo`.
pub(super) fn check_look(features: &Features) -> Result<()> {
    if is_blank(features) {
        Err(Error::BlankPicture)
    } else if is_photo(features) {
        Err(Error::PlainPhoto)
    } else {
        Ok(())
    }
}

/// Hardly anything but one colour.
fn is_blank(features: &Features) -> bool {
    let most = features.palette.first().map_or(1.0, |colour| colour.share);
    let texture: f32 = features.texture.iter().sum();
    most > 0.985 || texture < 0.6
}

/// Whether a picture has what pictures of cameras have and next to no print, drawing or painting has: many colours, or many
/// grays, colours of one lightness that differ, no few levels, hardly a line, as many light ones as dark ones, slopes of light
/// rather than areas with hard edges, and nothing that repeats.
/// Bounds are between 16 photos and 116 designed styles on them; paint without lines is the nearest to a photo. Of 50 photos
/// none has more than .023 of its pixels at edges where more than .84 of its slopes are flat, nor more than .76 of these flat where
/// .07 are at edges.
fn is_photo(features: &Features) -> bool {
    let Features { dark, light, screen, tones, .. } = features;
    let drawn = dark.density > 0.075 || dark.density > 3.0 * light.density + 0.004 || features.steps > 0.45;
    let cut_out = features.terraced > 0.85 && features.edges > 0.07;
    let printed = screen.pitch > 0.0;
    let solid = tones[0] + tones[tones.len() - 1];
    let gray = features.chroma < 0.004;
    let varied = if gray { solid < 0.3 } else { features.variety > 0.1 && features.free > 0.017 };
    varied && !drawn && !cut_out && !printed
}
