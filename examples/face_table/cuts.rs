//! Faces that a crop cuts, and whether another one would not.

use inkpanel::framing::{Crop, PhotoMeta, Subject};

/// The faces that a crop for a panel of that aspect cuts, none if that is the best there is.
pub(crate) fn avoidable(photo: &PhotoMeta, crop: &Crop, aspect: f64, faces: &[&Subject]) -> usize {
    let cut = cuts(crop, faces);
    if cut > 0 && possible(photo, aspect, faces) { cut } else { 0 }
}

/// The part of a face that a crop shows, 0..1.
fn part(crop: &Crop, face: &Subject) -> f64 {
    let shared = |a: f64, al: f64, b: f64, bl: f64| ((a + al).min(b + bl) - a.max(b)).max(0.0);
    shared(crop.x, crop.width, face.x, face.width) * shared(crop.y, crop.height, face.y, face.height)
        / (face.width * face.height)
}

/// How many faces a crop shows a part of.
pub(crate) fn cuts(crop: &Crop, faces: &[&Subject]) -> usize {
    faces.iter().filter(|face| (1e-6..1.0 - 1e-6).contains(&part(crop, face))).count()
}

/// Whether some crop of that aspect, from the widest to a third of it, holds a face and cuts none.
fn possible(photo: &PhotoMeta, aspect: f64, faces: &[&Subject]) -> bool {
    let widest = (aspect / photo.aspect()).min(1.0);
    (0..9).any(|step| {
        let width = widest * (1.0 - f64::from(step) / 12.0);
        let height = width * photo.aspect() / aspect;
        (0..41 * 41).any(|at| {
            let place = |i: i32, side: f64| (1.0 - side) * f64::from(i) / 40.0;
            let crop = Crop { x: place(at % 41, width), y: place(at / 41, height), width, height };
            cuts(&crop, faces) == 0 && faces.iter().any(|face| part(&crop, face) > 1.0 - 1e-6)
        })
    })
}
