//! Faces that a crop cuts, and whether another one would not.

use inkpanel_engine::framing::{Crop, PhotoMeta, Subject};

/// Returns the number of faces that a crop cuts, for a panel of this aspect ratio; 0 if no crop is better.
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
    let whole = |crop: &Crop| faces.iter().any(|face| part(crop, face) > 1.0 - 1e-6);
    crops(photo, aspect, 9, 41).any(|crop| cuts(&crop, faces) == 0 && whole(&crop))
}

/// Returns crops of this aspect ratio in several sizes. They start with the largest crop and shrink by
/// twelfths of it, each at `places` x `places` positions.
pub(crate) fn crops(
    photo: &PhotoMeta,
    aspect: f64,
    sizes: usize,
    places: usize,
) -> impl Iterator<Item = Crop> {
    let (own, widest) = (photo.aspect(), (aspect / photo.aspect()).min(1.0));
    (0..sizes).flat_map(move |size| {
        let width = widest * (1.0 - size as f64 / 12.0);
        let height = width * own / aspect;
        let place = move |i: usize, side: f64| (1.0 - side) * i as f64 / (places - 1) as f64;
        (0..places * places).map(move |at| Crop {
            x: place(at % places, width),
            y: place(at / places, height),
            width,
            height,
        })
    })
}
