//! Light in dark hair, clothes and fur, so that inking does not fill them with black.
//!
//! Only dark areas with detail get light: a black background and a silhouette stay black. The amount depends on the
//! part of the bodies in the picture that would be one black area.

use super::face_box::{FaceBox, each_pixel};
use crate::raster::guided::softened;
use crate::raster::{Image, Plane};
use crate::simd::point::luma_plane;

/// A body below and beside a face, in sizes of the face: to each side, above and below.
const BODY: (f64, f64, f64) = (1.1, 0.6, 3.0);
/// Height of a face as a part of the picture. The box of a larger face counts as the whole body.
const LARGE: f64 = 0.62;
/// Local luma below which an area is dark, and above which it is not.
const DARK: (f32, f32) = (34.0, 84.0);
/// Minimum difference of a pixel from its surroundings, in grey levels, and its maximum luma. Such pixels are detail.
const ACTIVE: (u8, u8) = (3, 110);
/// Part of such pixels in an area without detail, such as the surroundings of an edge, and in one with detail.
const DETAIL: (f32, f32) = (0.28, 0.55);
/// Dark parts of the bodies: the largest one that gets no light, and the smallest one that gets all light.
const SHARE: (f32, f32) = (0.05, 0.22);
/// How near the tones of dark areas come to their square roots, for colours and for lines.
const CURVE: (f32, f32) = (0.55, 0.8);
/// Largest factor of a colour. More light is added as gray, because colours of dark areas are noise.
const MOST: f32 = 1.4;
/// Radius of an area, and of detail, in parts of the longer side.
const RADIUS: (f32, f32) = (0.014, 0.004);

/// A photo with light in its dark parts, for the colours and for the lines of a style. `None` if it needs no light.
pub(super) fn lifted(photo: &Image, faces: &[FaceBox]) -> Option<(Image, Image)> {
    let luma = luma_plane(photo);
    let longest = luma.width().max(luma.height()) as f32;
    let radius = |part: f32| ((part * longest).round() as usize).max(1);
    let mean = |plane: &Plane, part: f32| softened(&softened(plane, radius(part)), radius(part));
    let base = mean(&luma, RADIUS.0);
    let fine = mean(&luma, RADIUS.1);
    let active = Plane::from_fn(luma.width(), luma.height(), |x, y| {
        let tone = luma.at(x, y);
        if tone <= ACTIVE.1 && tone.abs_diff(fine.at(x, y)) >= ACTIVE.0 { 255 } else { 0 }
    });
    let detail = mean(&active, RADIUS.0);
    let dark = |x: usize, y: usize| {
        let there = 1.0 - step(DARK, f32::from(base.at(x, y)));
        there * step(DETAIL, f32::from(detail.at(x, y)) / 255.0)
    };
    let all = step(SHARE, share(faces, (luma.width(), luma.height()), &dark));
    if all <= 0.0 {
        return None;
    }
    let shares = Plane::from_fn(luma.width(), luma.height(), |x, y| (255.0 * all * dark(x, y)).round() as u8);
    // The colours of faces get their own light, see `Care::lit`. Both together would make dark skin pale.
    let mut outside = shares.clone();
    for face in faces {
        each_pixel(face, luma.width(), luma.height(), |x, y, inside| {
            let share = &mut outside.row_mut(y)[x];
            *share = (f32::from(*share) * (1.0 - inside)).round() as u8;
        });
    }
    let lit = |shares: &Plane, part: f32| {
        // Products and square roots are rounded identically on all platforms.
        let curve: [f32; 256] = std::array::from_fn(|v| {
            let tone = v as f32 / 255.0;
            255.0 * (tone + part * (tone.sqrt() - tone))
        });
        let mut lit = photo.clone();
        for (i, (&share, &y)) in shares.samples().iter().zip(luma.samples()).enumerate() {
            if share == 0 {
                continue;
            }
            let before = f32::from(y).max(1.0);
            let after = before + f32::from(share) / 255.0 * (curve[usize::from(y)] - before).max(0.0);
            let factor = (after / before).min(MOST);
            let rest = after - factor * before;
            for plane in lit.planes_mut() {
                let sample = &mut plane.samples_mut()[i];
                *sample = (f32::from(*sample) * factor + rest).round().clamp(0.0, 255.0) as u8;
            }
        }
        lit
    };
    Some((lit(&outside, CURVE.0), lit(&shares, CURVE.1)))
}

/// The mean darkness of the bodies in the picture.
fn share(faces: &[FaceBox], (width, height): (usize, usize), dark: &impl Fn(usize, usize) -> f32) -> f32 {
    let mut most = 0.0_f32;
    for face in faces {
        let large = face.height > LARGE * height as f64;
        let (side, above, below) = if large { (0.0, 0.0, 0.0) } else { BODY };
        let span = |from: f64, to: f64, limit: usize| {
            let at = |place: f64| place.clamp(0.0, limit as f64) as usize;
            at(from)..at(to)
        };
        let across = span(face.x - side * face.width, face.x + (1.0 + side) * face.width, width);
        let down = span(face.y - above * face.height, face.y + (1.0 + below) * face.height, height);
        // Every third pixel is enough.
        let (mut sum, mut count) = (0.0, 0_u32);
        for y in down.step_by(3) {
            for x in across.clone().step_by(3) {
                sum += dark(x, y);
                count += 1;
            }
        }
        most = most.max(sum / count.max(1) as f32);
    }
    most
}

/// From 0 at the first value to 1 at the second, smoothly.
pub(super) fn step((from, to): (f32, f32), value: f32) -> f32 {
    let t = ((value - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FACE: FaceBox = FaceBox { x: 130.0, y: 40.0, width: 40.0, height: 50.0 };

    /// A person in dark clothes on a bright wall, with folds of `depth` grey levels.
    fn photo(depth: u8) -> Image {
        let tone = |x: usize, y: usize| match (x, y) {
            (100..200, 90..240) => 14 + if (x / 4 + y / 6).is_multiple_of(2) { depth } else { 0 },
            (130..170, 40..90) => 150,
            _ => 200,
        };
        Image::from_rgb([0, 1, 2].map(|_| Plane::from_fn(300, 240, tone))).unwrap()
    }

    #[test]
    fn folds_of_dark_clothes_get_light_and_black_stays_black() {
        let (lit, lines) = lifted(&photo(20), &[FACE]).unwrap();
        let at = |image: &Image, x, y| i32::from(luma_plane(image).at(x, y));
        // The difference between two folds, and the light of the brighter one.
        let depth = |image: &Image| (at(image, 149, 160) - at(image, 153, 160)).abs();
        assert!(depth(&lit) > 25 && depth(&photo(20)) == 20, "{}", depth(&lit));
        let bright = |image: &Image| at(image, 149, 160).max(at(image, 153, 160));
        assert!(bright(&lit) > 60 && bright(&lines) > bright(&lit), "{}", bright(&lit));
        assert_eq!(at(&lit, 20, 20), 200, "the wall does not change");
        assert!(lifted(&photo(0), &[FACE]).is_none(), "no detail, no light");
    }

    #[test]
    fn shadows_away_from_people_stay() {
        assert!(lifted(&photo(20), &[FaceBox { x: 5.0, width: 20.0, height: 25.0, ..FACE }]).is_none());
    }
}
