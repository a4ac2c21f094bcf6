//! Skin of people beyond their faces, so that arms, hands and necks keep natural colours too.
//!
//! A pixel is skin if it lies near a face and has a similar ratio of chroma to luma, which hardly depends on light. Gray walls
//! and snow are no skin, even next to a pale face.
//! The limits were chosen by visual comparison.

use std::ops::Range;

use super::face_box::{FaceBox, luma, rgb_at};
use crate::raster::Image;

/// Reach of a body around a face, in sides of the face: to each side, above and below.
const REACH: [f64; 3] = [3.0, 1.0, 8.0];
/// Part of the reach in which the share of skin falls to 0. A wall of the same colour then shows no edge.
const FADE: f64 = 0.4;
/// Difference of the ratio of chroma to luma from the face: at most the first for skin, at least the second for other things.
const LIKE: (f32, f32) = (0.07, 0.15);
/// The part of a face's ratio that a pixel has in the same direction: at most the first for things without colour, at least the
/// second for skin.
const COLOURED: (f32, f32) = (0.3, 0.6);
/// Least ratio of a face with a colour. Masked faces and gray photos have less.
const LEAST: f32 = 0.05;
/// Luma below which a pixel has no reliable colour, in grey levels.
const DARK: f32 = 36.0;
/// Added to luma, so that the ratios of dark pixels stay small.
const FLOOR: f32 = 24.0;
/// Part of the sides of a face in which its colour is measured: cheeks and nose.
const CHEEKS: f64 = 0.5;

/// A range of columns or rows, and the distances from its ends at which it is complete.
struct Reach {
    start: f64,
    end: f64,
    fade: [f64; 2],
}

impl Reach {
    /// The pixels of a side that it covers.
    fn pixels(&self, side: usize) -> Range<usize> {
        let at = |place: f64| place.clamp(0.0, side as f64) as usize;
        at(self.start.floor())..at(self.end.ceil())
    }

    /// How far a pixel belongs to it, 0 to 1.
    fn share(&self, at: usize) -> f32 {
        let at = at as f64 + 0.5;
        let inside = ((at - self.start) / self.fade[0]).min((self.end - at) / self.fade[1]);
        inside.clamp(0.0, 1.0) as f32
    }
}

/// The skin of the people in a photo.
pub(super) struct Skin {
    people: Vec<Person>,
    /// Sides of the photo.
    size: (usize, usize),
}

struct Person {
    /// Columns and rows that the body may cover.
    columns: Reach,
    rows: Reach,
    /// Ratio of chroma to luma of the face.
    tint: [f32; 2],
}

impl Skin {
    /// Measures the colours of faces. A dark or gray face has no reliable colour.
    pub(super) fn of(photo: &Image, faces: &[&FaceBox]) -> Self {
        let people = faces.iter().filter_map(|face| Person::of(photo, face)).collect();
        Self { people, size: (photo.width(), photo.height()) }
    }

    /// The columns and rows that contain all bodies.
    pub(super) fn bounds(&self) -> (Range<usize>, Range<usize>) {
        let range = |of: fn(&Person) -> &Reach, side: usize| {
            let ranges = || self.people.iter().map(|person| of(person).pixels(side));
            let start = ranges().map(|range| range.start).min().unwrap_or(0);
            start..ranges().map(|range| range.end).max().unwrap_or(start)
        };
        (range(|person| &person.columns, self.size.0), range(|person| &person.rows, self.size.1))
    }

    /// How far a pixel is skin, 0 to 1.
    pub(super) fn share(&self, x: usize, y: usize, rgb: [f32; 3]) -> f32 {
        let luma = luma(rgb);
        if luma < DARK {
            return 0.0;
        }
        let [u, v] = tint(rgb, luma);
        let share = |person: &Person| {
            let (du, dv) = (u - person.tint[0], v - person.tint[1]);
            let like = ((LIKE.1 - length([du, dv])) / (LIKE.1 - LIKE.0)).clamp(0.0, 1.0);
            let own = length(person.tint);
            let along = (u * person.tint[0] + v * person.tint[1]) / (own * own);
            let coloured = ((along - COLOURED.0) / (COLOURED.1 - COLOURED.0)).clamp(0.0, 1.0);
            like * coloured * person.columns.share(x).min(person.rows.share(y))
        };
        self.people.iter().map(share).fold(0.0, f32::max)
    }
}

impl Person {
    fn of(photo: &Image, face: &FaceBox) -> Option<Self> {
        let range = |start: f64, end: f64, side: usize| {
            start.floor().clamp(0.0, side as f64) as usize..end.ceil().clamp(0.0, side as f64) as usize
        };
        let inner = |start: f64, length: f64, side: usize| {
            let edge = length * (1.0 - CHEEKS) / 2.0;
            range(start + edge, start + length - edge, side)
        };
        let (width, height) = (photo.width(), photo.height());
        let mut sums = [0.0_f32; 3];
        let mut count = 0.0_f32;
        for y in inner(face.y, face.height, height) {
            for x in inner(face.x, face.width, width) {
                for (sum, value) in sums.iter_mut().zip(rgb_at(photo, x, y)) {
                    *sum += value;
                }
                count += 1.0;
            }
        }
        let mean = sums.map(|sum| sum / count.max(1.0));
        let reach = |start: f64, side: f64, [before, after]: [f64; 2]| Reach {
            start: start - before * side,
            end: start + (1.0 + after) * side,
            fade: [before, after].map(|reach| (FADE * reach * side).max(1.0)),
        };
        let tint = tint(mean, luma(mean));
        (luma(mean) >= DARK && length(tint) >= LEAST).then(|| Self {
            columns: reach(face.x, face.width, [REACH[0]; 2]),
            rows: reach(face.y, face.height, [REACH[1], REACH[2] - 1.0]),
            tint,
        })
    }
}

/// Blue and red chroma over luma.
fn tint([r, _, b]: [f32; 3], luma: f32) -> [f32; 2] {
    [(b - luma) / (luma + FLOOR), (r - luma) / (luma + FLOOR)]
}

// Products and square roots are rounded identically on all platforms.
fn length([u, v]: [f32; 2]) -> f32 {
    (u * u + v * v).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Plane;

    #[test]
    fn arms_are_skin_in_light_and_in_shadow_and_clothes_are_not() {
        // A face, an arm in light, an arm in shadow, and a blue shirt.
        let colour = |x: usize, y: usize| match (x, y) {
            (80..120, 20..70) => [210, 160, 135],
            (40..60, _) => [228, 176, 150],
            (140..160, _) => [105, 80, 67],
            _ => [60, 90, 170],
        };
        let plane = |i: usize| Plane::from_fn(200, 200, |x, y| colour(x, y)[i]);
        let photo = Image::from_rgb([plane(0), plane(1), plane(2)]).unwrap();
        let face = FaceBox { x: 80.0, y: 20.0, width: 40.0, height: 50.0 };
        let skin = Skin::of(&photo, &[&face]);
        let share = |x: usize, y: usize| skin.share(x, y, rgb_at(&photo, x, y));
        assert!(share(50, 120) > 0.95 && share(150, 120) > 0.6, "{} {}", share(50, 120), share(150, 120));
        assert!(share(100, 120) < 0.01);
        let (columns, rows) = skin.bounds();
        assert_eq!((columns, rows), (0..200, 0..200));
        // The reach ends at x = 240 and fades over 48 pixels.
        let share = |x: usize| skin.share(x, 120, [210.0, 160.0, 135.0]);
        assert!(share(190) > 0.95 && (0.3..0.7).contains(&share(216)) && share(239) < 0.05);
        let far = FaceBox { x: 0.0, y: 0.0, width: 8.0, height: 8.0 };
        assert!(Skin::of(&photo, &[&far]).share(150, 120, [210.0, 160.0, 135.0]) < 0.01, "another person");
    }
    #[test]
    fn gray_walls_are_no_skin() {
        let [wall, snow] = [[200.0, 200.0, 202.0], [238.0, 240.0, 242.0]];
        let photo = |face: [u8; 3]| {
            let plane = |i: usize| Plane::from_fn(200, 200, |_, y| if y < 100 { face[i] } else { 200 });
            Image::from_rgb([plane(0), plane(1), plane(2)]).unwrap()
        };
        let face = FaceBox { x: 80.0, y: 20.0, width: 40.0, height: 50.0 };
        let pale = Skin::of(&photo([235, 212, 200]), &[&face]);
        assert!(pale.share(100, 120, wall) < 0.01 && pale.share(100, 120, snow) < 0.01);
        assert!(
            pale.share(100, 120, [225.0, 200.0, 187.0]) > 0.95
                && pale.share(100, 120, [150.0, 134.0, 126.0]) > 0.9
        );
        let gray = Skin::of(&photo([150, 150, 156]), &[&face]);
        assert!(gray.share(100, 120, wall) < 0.01, "a masked face");
        assert_eq!(gray.bounds(), (0..0, 0..0));
    }
}
