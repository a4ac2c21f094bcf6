//! Classifies the look of a picture, and detects whether two pictures of one photo look the same. The
//! generator of styles sorts its results into families, and drops results that look identical. The thresholds
//! were chosen for this project.

use crate::raster::Image;
use crate::raster::resize::{Region, resample_image};
use crate::simd::point::luma_plane;
use crate::simd::table::histogram;

/// Columns and rows of a signature.
const GRID: (usize, usize) = (12, 9);
/// Minimum share of nearly black and nearly white pixels in a drawing.
const LINE: f64 = 0.72;
/// How far from black and from white still counts, in grey steps.
const NEAR: usize = 48;
/// Mean distance of the largest to the smallest channel, in grey steps, below which a picture is gray.
const COLOURLESS: f64 = 9.0;
/// Limit for drawings, whose ink may have a tint.
const INK: f64 = 26.0;
/// Minimum share of pixels that equal their right and lower neighbours in a picture with flat colours.
const FLAT: f64 = 0.5;
/// Maximum difference of pixels that count as equal, in grey levels.
const EQUAL: u8 = 2;

/// A family of look.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Look {
    /// Black on white or white on black.
    Line,
    /// Without colour, with tones between.
    Gray,
    /// Areas of one colour.
    Flat,
    /// Everything else.
    Wild,
}

impl Look {
    /// Its name for programs.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::Line => "line",
            Self::Gray => "gray",
            Self::Flat => "flat",
            Self::Wild => "wild",
        }
    }
}

/// The family of a stylised picture; a thumbnail is enough.
#[must_use]
pub fn look(picture: &Image) -> Look {
    let luma = luma_plane(picture);
    let pixels = luma.samples().len().max(1) as f64;
    let counts = histogram(luma.samples());
    let ends: u32 = counts[..NEAR].iter().chain(&counts[256 - NEAR..]).sum();
    let colour = colour(picture);
    if f64::from(ends) / pixels >= LINE && colour < INK {
        return Look::Line;
    }
    if colour < COLOURLESS {
        return Look::Gray;
    }
    let (width, height) = (luma.width(), luma.height());
    let same = |x: usize, y: usize| {
        let at = luma.at(x, y);
        at.abs_diff(luma.at((x + 1).min(width - 1), y)) <= EQUAL
            && at.abs_diff(luma.at(x, (y + 1).min(height - 1))) <= EQUAL
    };
    let flat = (0..height).map(|y| (0..width).filter(|&x| same(x, y)).count()).sum::<usize>();
    if flat as f64 / pixels >= FLAT { Look::Flat } else { Look::Wild }
}

/// Returns mean colour and roughness over a grid of 12 x 9 cells, 4 bytes per cell. If the signatures of two
/// pictures of one photo differ by a few levels on average, they look the same.
#[must_use]
pub fn signature(picture: &Image) -> Vec<u8> {
    let (columns, rows) = GRID;
    let whole = Region::whole(picture.width(), picture.height());
    let colours = resample_image(picture, whole, columns, rows).to_rgb();
    let luma = luma_plane(picture);
    let (width, height) = (luma.width(), luma.height());
    let mut rough = vec![(0_u32, 0_u32); columns * rows];
    // First pixel of each column of cells, and the end of the last one. Starts at 1, because the first pixel
    // of a row has no left neighbour.
    let edges: Vec<usize> = (0..=columns).map(|column| (column * width).div_ceil(columns).max(1)).collect();
    for y in 0..height {
        let row = luma.row(y);
        for (cell, edge) in rough[y * rows / height * columns..].iter_mut().zip(edges.windows(2)) {
            let pairs = row[edge[0] - 1..edge[1] - 1].iter().zip(&row[edge[0]..edge[1]]);
            cell.0 += pairs.map(|(a, b)| u32::from(a.abs_diff(*b))).sum::<u32>();
            cell.1 += (edge[1] - edge[0]) as u32;
        }
    }
    colours
        .chunks_exact(3)
        .zip(rough)
        .flat_map(|(rgb, (sum, count))| [rgb[0], rgb[1], rgb[2], (4 * sum / count.max(1)).min(255) as u8])
        .collect()
}

/// Mean distance of the largest to the smallest channel.
fn colour(picture: &Image) -> f64 {
    let [r, g, b] = picture.planes() else { return 0.0 };
    let pixels = r.samples().iter().zip(g.samples()).zip(b.samples());
    let sum: u64 = pixels.map(|((&r, &g), &b)| u64::from(r.max(g).max(b) - r.min(g).min(b))).sum();
    sum as f64 / r.samples().len().max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Plane;

    fn rgb(make: impl Fn(usize, usize, usize) -> u8) -> Image {
        Image::from_rgb([0, 1, 2].map(|c| Plane::from_fn(64, 48, |x, y| make(c, x, y)))).unwrap()
    }

    #[test]
    fn each_family_is_told() {
        let lines = Image::from_luma(Plane::from_fn(64, 48, |x, y| if (x + y) % 9 == 0 { 0 } else { 250 }));
        let ramp = Image::from_luma(Plane::from_fn(64, 48, |x, _| (60 + 2 * x) as u8));
        let areas = rgb(|c, x, y| (60 + 40 * (x / 16) + 30 * c * (y / 24)).min(200) as u8);
        let noise =
            rgb(|c, x, y| 60 + ((x * 7919 + y * 104_729 + c * 31_337).wrapping_mul(x + 3) % 130) as u8);
        assert_eq!(
            [&lines, &ramp, &areas, &noise].map(look),
            [Look::Line, Look::Gray, Look::Flat, Look::Wild]
        );
    }

    #[test]
    fn a_signature_tells_colour_and_texture_apart() {
        let plain = rgb(|c, _, _| [200, 120, 60][c]);
        let tinted = rgb(|c, _, _| [60, 120, 200][c]);
        let striped = rgb(|c, x, _| [200, 120, 60][c] - 20 + 40 * (x % 2) as u8);
        let far = |a: &Image, b: &Image| {
            let pairs = signature(a).into_iter().zip(signature(b));
            pairs.map(|(a, b)| u32::from(a.abs_diff(b))).sum::<u32>() / 432
        };
        assert_eq!(signature(&plain).len(), 432);
        assert_eq!(far(&plain, &plain), 0);
        assert!(far(&plain, &tinted) > 40 && far(&plain, &striped) > 20);
    }
}
