//! Light of faces: how well a face is lit, compared with the other things in its photo.
//!
//! ```text
//! bright = P95(face) / P95(photo)
//! relief = P95(face) / P50(face)
//! light  = bright * clamp(relief / 1.35, 1, 1.3), from 0.36 (unlit) to 0.56 (lit)
//! ```
//!
//! Luma of faces depends on the colour of skin, so it does not show how a face is lit. Two facts are used instead.
//! Diffuse reflection multiplies all tones of a face by the reflectance of its skin. So the ratio of two tones of a face
//! shows only the light. Oily layers of any skin reflect the same part of light like a mirror, about 4 %. So dark skin in
//! light has a larger ratio of highlights to middle tones than pale skin, and a face in the shade has a small ratio.
//! The ratio of luma is a power of the ratio of light, so gamma does not matter.
//!
//! Source of both facts: Igarashi, Nishino and Nayar, "The Appearance of Human Skin: A Survey", 2007, and Weyrich et al.,
//! "Analysis of Human Faces using a Measurement-Based Skin Reflectance Model", 2006. The limits were chosen by looking at 251
//! faces of all skin colours, sorted by this measure.

use super::Detection;
use inkpanel_image::raster::Image;
use inkpanel_image::simd::tones::Tones;

/// Percentiles of luma that count as highlights and as middle tones.
const HIGHLIGHTS: f32 = 95.0;
const MIDDLE: f32 = 50.0;
/// Ratio of highlights to middle tones of pale skin in usual light, and the largest credit for a larger ratio.
const RELIEF: f64 = 1.35;
const MOST_CREDIT: f64 = 1.3;
/// Highlights of an unlit and of a lit face, relative to the highlights of the photo.
const UNLIT: f64 = 0.36;
const LIT: f64 = 0.56;
/// Pixels along each side of a face that are looked at, at most.
const SAMPLES: usize = 96;

/// Adds their light to faces.
pub(super) fn add(photo: &Image, faces: &mut [Detection]) {
    if faces.is_empty() {
        return;
    }
    let brightest = percentiles(&lumas(photo, [0.0, 0.0, 1.0, 1.0], false), [HIGHLIGHTS]);
    let Some([brightest]) = brightest else { return };
    for face in faces {
        let samples = lumas(photo, [face.x, face.y, face.width, face.height], true);
        face.light = percentiles(&samples, [HIGHLIGHTS, MIDDLE]).map(|[high, middle]| {
            let relief = high / middle.max(1.0);
            let bright = high / brightest.max(1.0) * (relief / RELIEF).clamp(1.0, MOST_CREDIT);
            let light = ((bright - UNLIT) / (LIT - UNLIT)).clamp(0.0, 1.0);
            // Two digits are enough, and keep projects small.
            (light * 100.0).round() / 100.0
        });
    }
}

/// The luma of pixels of a box, or of the ellipse in it. The box is in fractions of the photo.
fn lumas(photo: &Image, [x, y, width, height]: [f64; 4], round: bool) -> Vec<u8> {
    let mut samples = Vec::new();
    let sides = (photo.width() as f64, photo.height() as f64);
    let span = |from: f64, length: f64, side: f64| {
        let (first, last) = ((from * side).max(0.0), ((from + length) * side).min(side));
        (first as usize, last.ceil() as usize, ((last - first) as usize).div_ceil(SAMPLES).max(1))
    };
    let (left, right, across) = span(x, width, sides.0);
    let (top, bottom, down) = span(y, height, sides.1);
    for row in (top..bottom).step_by(down) {
        for column in (left..right).step_by(across) {
            let off = |at: usize, side: f64, from: f64, length: f64| {
                ((at as f64 + 0.5) / side - from) / length.max(f64::MIN_POSITIVE) * 2.0 - 1.0
            };
            let (dx, dy) = (off(column, sides.0, x, width), off(row, sides.1, y, height));
            if !round || dx * dx + dy * dy <= 1.0 {
                samples.push(luma(photo, column, row));
            }
        }
    }
    samples
}

fn luma(photo: &Image, x: usize, y: usize) -> u8 {
    let at = |channel: usize| u32::from(photo.planes()[channel].at(x, y));
    if photo.is_luma() {
        return at(0) as u8;
    }
    ((299 * at(0) + 587 * at(1) + 114 * at(2) + 500) / 1000) as u8
}

/// `None` without samples.
fn percentiles<const N: usize>(samples: &[u8], percents: [f32; N]) -> Option<[f64; N]> {
    if samples.is_empty() {
        return None;
    }
    let tones = Tones::new(samples);
    Some(percents.map(|percent| f64::from(tones.percentile(percent))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use inkpanel_image::raster::Plane;

    const SIDE: usize = 240;
    /// Reflectances of skin, from very dark to very pale.
    const SKIN: [f64; 4] = [0.05, 0.12, 0.3, 0.55];
    const FACE: [f64; 4] = [0.3, 0.25, 0.4, 0.5];

    /// A head in front of a bright sky. `lamp`: light from the side and above, `shade`: light from everywhere.
    fn portrait(skin: f64, lamp: f64, shade: f64) -> Image {
        let plane = Plane::from_fn(SIDE, SIDE, |x, y| {
            let at =
                |at: usize, from: f64, length: f64| ((at as f64 / SIDE as f64 - from) / length) * 2.0 - 1.0;
            let (dx, dy) = (at(x, FACE[0], FACE[2]), at(y, FACE[1], FACE[3]));
            let depth = 1.0 - dx * dx - dy * dy;
            let light = if depth <= 0.0 {
                0.85
            } else {
                // A sphere in Lambert's law, and the mirror of the lamp on it.
                let across = (0.45 * -dx + 0.45 * -dy + 0.77 * depth.sqrt()).max(0.0);
                let features =
                    if (dx.abs() - 0.4).abs() < 0.12 && (dy + 0.2).abs() < 0.06 { 0.2 } else { 1.0 };
                features * skin * (lamp * across + shade) + 0.25 * lamp * across.powi(12)
            };
            (255.0 * light.clamp(0.0, 1.0).powf(1.0 / 2.2)).round() as u8
        });
        Image::from_luma(plane)
    }

    fn light(photo: &Image) -> f64 {
        let [x, y, width, height] = FACE;
        let mut faces = [Detection {
            label: "face".into(),
            score: 0.9,
            x,
            y,
            width,
            height,
            points: None,
            expression: None,
            light: None,
        }];
        add(photo, &mut faces);
        faces[0].light.unwrap()
    }

    #[test]
    fn skin_of_any_colour_is_lit_in_light_and_unlit_in_the_shade() {
        for skin in SKIN {
            let (lit, shade) = (light(&portrait(skin, 1.0, 0.15)), light(&portrait(skin, 0.0, 0.12)));
            assert!(lit > 0.75, "{skin}: {lit}");
            assert!(shade < 0.3, "{skin}: {shade}");
        }
    }

    #[test]
    fn a_darker_exposure_of_the_whole_photo_changes_nothing() {
        let photo = portrait(0.3, 0.25, 0.05);
        let darker = Image::from_luma(Plane::from_fn(SIDE, SIDE, |x, y| photo.planes()[0].at(x, y) / 2));
        assert!((light(&photo) - light(&darker)).abs() < 0.05, "{} {}", light(&photo), light(&darker));
    }

    #[test]
    fn a_face_outside_of_the_photo_has_no_light() {
        let [x, y, width, height] = [1.2, 0.1, 0.1, 0.1];
        let samples = lumas(&portrait(0.3, 1.0, 0.1), [x, y, width, height], true);
        assert_eq!(percentiles(&samples, [MIDDLE]), None);
    }
}
