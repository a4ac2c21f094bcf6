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
    if width.min(height) < SHORTEST { Err(Error::SmallPicture { width, height, least: SHORTEST }) } else { Ok(()) }
}

/// # Errors
/// `blank-picture`, `plain-photo`.
pub(super) fn check_look(features: &Features) -> Result<()> {
    if is_blank(features) {
        return Err(Error::BlankPicture);
    }
    if photo_score(features) > 0.0 {
        return Err(Error::PlainPhoto);
    }
    Ok(())
}

/// Hardly anything but one colour.
fn is_blank(features: &Features) -> bool {
    let most = features.palette.first().map_or(1.0, |colour| colour.share);
    let texture: f32 = features.texture.iter().sum();
    most > 0.985 || texture < 0.6
}

/// Above 0 a picture is taken for a photo as a camera made it.
pub(super) fn photo_score(_features: &Features) -> f32 {
    -1.0
}
