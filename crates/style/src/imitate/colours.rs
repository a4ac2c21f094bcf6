//! The colours of a picture, and how far apart people see two.

use crate::blocks::flatten::{CELLS, cells, distance, histogram, means};
use crate::order::sort_by;
use crate::raster::Image;
use serde::{Deserialize, Serialize};

/// Colours of a palette, at most: as many as Flat Areas takes over.
pub(super) const MOST: usize = 8;

/// Colours nearer than this (Delta E 2000) are one.
const SAME: f32 = 5.0;

/// A colour of a palette.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Colour {
    /// sRGB.
    pub rgb: [u8; 3],
    /// Share of the picture's pixels, 0 to 1.
    pub share: f32,
}

/// Returns the colours of a picture by k-means in Oklab, the most common first. Similar colours are joined.
pub(super) fn palette(image: &Image) -> Vec<Colour> {
    let counts = histogram(image);
    let colours = means(&counts, cells(), MOST);
    let points: Vec<[f32; 3]> = colours.iter().map(|&colour| oklab(colour)).collect();
    let mut pixels = vec![0u32; colours.len()];
    for (cell, &count) in counts.pixels.iter().enumerate().filter(|&(_, &count)| count > 0) {
        let mut best = (0, f32::INFINITY);
        for (i, &point) in points.iter().enumerate() {
            let apart = distance(point, cells()[cell]);
            if apart < best.1 {
                best = (i, apart);
            }
        }
        pixels[best.0] += count;
    }
    let total: u32 = pixels.iter().sum();
    let shares = pixels.iter().map(|&count| count as f32 / total.max(1) as f32);
    let mut palette: Vec<Colour> =
        colours.into_iter().zip(shares).map(|(rgb, share)| Colour { rgb, share }).collect();
    sort_by(&mut palette, |a, b| b.share.total_cmp(&a.share));
    let mut joined: Vec<Colour> = Vec::with_capacity(palette.len());
    for colour in palette {
        match joined.iter_mut().find(|known| delta_e(known.rgb, colour.rgb) < SAME) {
            Some(known) => known.share += colour.share,
            None => joined.push(colour),
        }
    }
    joined
}

/// How far two palettes are from each other, in Delta E 2000: the mean distance of each colour of one to the nearest of
/// the other, by their shares, both ways.
#[must_use]
pub fn palette_distance(a: &[Colour], b: &[Colour]) -> f32 {
    let one_way = |from: &[Colour], to: &[Colour]| {
        let nearest = |colour: &Colour| {
            to.iter().map(|other| delta_e(colour.rgb, other.rgb)).fold(f32::INFINITY, f32::min).min(100.0)
        };
        let (sum, total) = from.iter().fold((0.0, 0.0), |(sum, total), colour| {
            (sum + colour.share * nearest(colour), total + colour.share)
        });
        sum / total.max(1e-6f32)
    };
    0.5 * (one_way(a, b) + one_way(b, a))
}

/// Minimum result of [`hues`] for a picture in several hues.
pub(super) const SEVERAL: f32 = 0.035;

/// Returns how far the colours of a palette are from colours of one hue, in Oklab: their standard deviation across the line in the
/// plane of hues along which they differ most. It is nearly 0 for one ink on paper.
pub(super) fn hues(palette: &[Colour]) -> f32 {
    let points = || palette.iter().map(|colour| (colour.share, oklab(colour.rgb)));
    let total = points().map(|(share, _)| share).sum::<f32>().max(1e-6);
    let mean = |of: &dyn Fn([f32; 3]) -> f32| points().map(|(share, at)| share * of(at)).sum::<f32>() / total;
    let (a, b) = (mean(&|at| at[1]), mean(&|at| at[2]));
    let aa = mean(&|at| (at[1] - a).powi(2));
    let bb = mean(&|at| (at[2] - b).powi(2));
    let ab = mean(&|at| (at[1] - a) * (at[2] - b));
    // The smaller eigenvalue of the covariance.
    (f32::midpoint(aa, bb) - ((aa - bb) / 2.0).hypot(ab)).max(0.0).sqrt()
}

/// Returns the number of 8 x 8 x 8 colour cells that hold 80 per cent of a picture, divided by the maximum
/// for a photo of this size.
pub(super) fn variety(image: &Image) -> f32 {
    let mut counts = histogram(image).pixels;
    sort_by(&mut counts, |a, b| b.cmp(a));
    let total: u32 = counts.iter().sum();
    let mut sum = 0;
    let needed = counts.iter().take_while(|&&count| {
        sum += count;
        sum - count < total / 5 * 4
    });
    needed.count() as f32 / CELLS.pow(2) as f32
}

pub(super) fn oklab(rgb: [u8; 3]) -> [f32; 3] {
    crate::blocks::flatten::oklab(rgb.map(f32::from))
}

/// CIELAB (D65) of an sRGB colour.
fn lab(rgb: [u8; 3]) -> [f32; 3] {
    let [r, g, b] = rgb.map(|tone| {
        let tone = f32::from(tone) / 255.0;
        if tone <= 0.040_45 { tone / 12.92 } else { ((tone + 0.055) / 1.055).powf(2.4) }
    });
    let f = |t: f32| if t > 0.008_856 { t.cbrt() } else { 7.787 * t + 16.0 / 116.0 };
    let x = f((0.412_456 * r + 0.357_576 * g + 0.180_437 * b) / 0.950_47);
    let y = f(0.212_673 * r + 0.715_152 * g + 0.072_175 * b);
    let z = f((0.019_334 * r + 0.119_192 * g + 0.950_304 * b) / 1.088_83);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// CIEDE2000 of two sRGB colours.
///
/// Source: Sharma, Wu and Dalal, "The CIEDE2000 color-difference formula", 2005.
#[must_use]
pub fn delta_e(a: [u8; 3], b: [u8; 3]) -> f32 {
    between(lab(a), lab(b))
}

fn between([l1, a1, b1]: [f32; 3], [l2, a2, b2]: [f32; 3]) -> f32 {
    let seventh = |c: f32| (c.powi(7) / (c.powi(7) + 25f32.powi(7))).sqrt();
    let mean_chroma = f32::midpoint(a1.hypot(b1), a2.hypot(b2));
    let stretch = 1.0 + 0.5 * (1.0 - seventh(mean_chroma));
    let (a1, a2) = (a1 * stretch, a2 * stretch);
    let (c1, c2) = (a1.hypot(b1), a2.hypot(b2));
    let hue =
        |a: f32, b: f32| if a == 0.0 && b == 0.0 { 0.0 } else { b.atan2(a).to_degrees().rem_euclid(360.0) };
    let (h1, h2) = (hue(a1, b1), hue(a2, b2));
    let turn = if c1 * c2 == 0.0 { 0.0 } else { (h2 - h1 + 180.0).rem_euclid(360.0) - 180.0 };
    let (dl, dc) = (l2 - l1, c2 - c1);
    let dh = 2.0 * (c1 * c2).sqrt() * (turn / 2.0).to_radians().sin();
    let (lm, cm) = (f32::midpoint(l1, l2), f32::midpoint(c1, c2));
    let hm = if c1 * c2 == 0.0 {
        h1 + h2
    } else if (h1 - h2).abs() <= 180.0 {
        f32::midpoint(h1, h2)
    } else if h1 + h2 < 360.0 {
        f32::midpoint(h1, h2) + 180.0
    } else {
        f32::midpoint(h1, h2) - 180.0
    };
    let cos = |degrees: f32| degrees.to_radians().cos();
    let t = 1.0 - 0.17 * cos(hm - 30.0) + 0.24 * cos(2.0 * hm) + 0.32 * cos(3.0 * hm + 6.0)
        - 0.20 * cos(4.0 * hm - 63.0);
    let sl = 1.0 + 0.015 * (lm - 50.0).powi(2) / (20.0 + (lm - 50.0).powi(2)).sqrt();
    let (sc, sh) = (1.0 + 0.045 * cm, 1.0 + 0.015 * cm * t);
    let rotation = -2.0 * seventh(cm) * (60.0 * (-((hm - 275.0) / 25.0).powi(2)).exp()).to_radians().sin();
    let (l, c, h) = (dl / sl, dc / sc, dh / sh);
    (l * l + c * c + h * h + rotation * c * h).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Plane;

    /// Pairs of the authors' own table.
    #[test]
    fn delta_e_is_that_of_its_authors() {
        for (a, b, expected) in [
            ([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485], 2.0425),
            ([50.0, 3.1571, -77.2803], [50.0, 0.0, -82.7485], 2.8615),
            ([50.0, 2.5, 0.0], [61.0, -5.0, 29.0], 22.8977),
            ([50.0, 2.5, 0.0], [56.0, -27.0, -3.0], 31.9030),
            ([60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387], 1.2644),
            ([22.7233, 20.0904, -46.6940], [23.0331, 14.9730, -42.5619], 2.0373),
            ([2.0776, 0.0795, -1.1350], [0.9033, -0.0636, -0.5514], 0.9082),
        ] {
            assert!((between(a, b) - expected).abs() < 2e-3, "{a:?} {b:?}: {}", between(a, b));
        }
        assert!((delta_e([0; 3], [255; 3]) - 100.0).abs() < 0.1);
    }

    #[test]
    fn inks_of_one_hue_have_no_hues() {
        let palette = |colours: &[[u8; 3]]| {
            let share = 1.0 / colours.len() as f32;
            colours.iter().map(|&rgb| Colour { rgb, share }).collect::<Vec<_>>()
        };
        let one = hues(&palette(&[[250, 240, 220], [220, 170, 150], [190, 100, 80], [60, 40, 30]]));
        let many = hues(&palette(&[[250, 240, 220], [210, 60, 40], [60, 130, 50], [40, 80, 160]]));
        assert!(one < 0.012 && many > 0.04, "{one} {many}");
    }

    #[test]
    fn a_picture_of_two_colours_has_two() {
        let image = Image::from_rgb(
            [[20, 240], [30, 220], [90, 200]]
                .map(|pair: [u8; 2]| Plane::from_fn(60, 40, move |x, _| pair[usize::from(x >= 20)])),
        )
        .unwrap();
        let palette = palette(&image);
        assert_eq!(palette.len(), 2);
        assert_eq!((palette[0].rgb, palette[1].rgb), ([240, 220, 200], [20, 30, 90]));
        assert!((palette[0].share - 2.0 / 3.0).abs() < 1e-6);
        assert!(palette_distance(&palette, &palette) < 1e-3);
    }
}
