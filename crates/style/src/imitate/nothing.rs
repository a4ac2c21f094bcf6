//! Detection of pictures without a distinct style: blank pictures and plain photos.

use super::features::{AREA, Features, reduced};
use crate::error::{Error, Result};
use crate::raster::Image;
use crate::simd::point::luma_plane;
use std::ops::Range;

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
pub(super) fn check_look(picture: &Image, features: &Features) -> Result<()> {
    if is_blank(features) {
        Err(Error::BlankPicture)
    } else if is_photo(features) && !is_page(picture) {
        Err(Error::PlainPhoto)
    } else {
        Ok(())
    }
}

/// Returns whether the picture has almost only one colour.
fn is_blank(features: &Features) -> bool {
    let most = features.palette.first().map_or(1.0, |colour| colour.share);
    let texture: f32 = features.texture.iter().sum();
    most > 0.985 || texture < 0.6
}

/// Returns whether a picture has a margin like a page: at three of its sides at least, a strip has one tone, and these tones are
/// equal. At the fourth side, a panel may bleed.
fn is_page(picture: &Image) -> bool {
    /// The width of a strip, as a part of the picture.
    const STRIP: f64 = 0.01;
    /// Maximum difference of equal tones, in grey steps, and minimum part of a strip with one tone.
    const EQUAL: u8 = 6;
    const MOST: f64 = 0.97;
    let luma = luma_plane(&reduced(picture, AREA));
    let (width, height) = (luma.width(), luma.height());
    let part = |side: usize| ((side as f64 * STRIP).ceil() as usize).max(1);
    let (across, down) = (part(width), part(height));
    let strips = [
        (0..width, 0..down),
        (0..width, height - down..height),
        (0..across, 0..height),
        (width - across..width, 0..height),
    ];
    let tone = |(columns, rows): (Range<usize>, Range<usize>)| {
        let mut tones: Vec<u8> = rows.flat_map(|y| luma.row(y)[columns.clone()].to_vec()).collect();
        tones.sort_unstable();
        let middle = tones[tones.len() / 2];
        let equal = tones.iter().filter(|tone| tone.abs_diff(middle) <= EQUAL).count();
        (equal as f64 >= MOST * tones.len() as f64).then_some(middle)
    };
    let mut tones: Vec<u8> = strips.into_iter().filter_map(tone).collect();
    tones.sort_unstable();
    tones.windows(3).any(|three| three[2] - three[0] <= EQUAL)
}

/// Returns whether a picture has the features of a photo, which prints, drawings and paintings rarely have. A
/// photo has many colours or many grays, colours of equal lightness that differ, and many tones. It has few
/// lines, as many light lines as dark ones, gradients rather than areas with hard edges, and no repeating
/// pattern.
/// The limits separate 16 photos from 116 built-in styles of them. Paint without lines is nearest to a photo.
/// In none of 50 photos, more than 0.023 of the pixels are at edges while more than 0.84 of the slopes are
/// flat. In none, more than 0.76 of the slopes are flat while 0.07 of the pixels are at edges.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Plane;

    #[test]
    fn a_page_has_a_margin_at_three_sides() {
        let drawn = |margin: [usize; 4]| {
            let [left, top, right, bottom] = margin;
            let inside = move |x: usize, y: usize| {
                (left..300 - right).contains(&x) && (top..400 - bottom).contains(&y)
            };
            let tone = move |x: usize, y: usize| (60 + x / 4 + y / 5 + x * y % 9) as u8;
            Image::from_luma(Plane::from_fn(
                300,
                400,
                move |x, y| if inside(x, y) { tone(x, y) } else { 250 },
            ))
        };
        assert!(is_page(&drawn([12; 4])) && is_page(&drawn([12, 12, 12, 0])));
        assert!(!is_page(&drawn([0; 4])) && !is_page(&drawn([12, 0, 12, 0])));
        // Letterboxes are two strips.
        assert!(!is_page(&drawn([0, 30, 0, 30])));
    }
}
