//! Crops around faces, for arbitrary photos: `frame` finds a crop without cut faces if a search over very
//! many crops finds one.

use inkpanel_engine::framing::{Crop, FACE, PhotoMeta, Subject, Target, frame};
use proptest::prelude::*;

fn photo(width: u32, height: u32, subjects: Vec<Subject>) -> PhotoMeta {
    PhotoMeta { subjects, ..PhotoMeta::unmeasured("photo", width, height) }
}

/// Returns whether a crop contains a complete box, and whether it cuts it.
fn holds_and_cuts(crop: &Crop, face: &Subject) -> (bool, bool) {
    let shared = |a: f64, al: f64, b: f64, bl: f64| ((a + al).min(b + bl) - a.max(b)).max(0.0);
    let inside = shared(crop.x, crop.width, face.x, face.width)
        * shared(crop.y, crop.height, face.y, face.height)
        / (face.width * face.height);
    (inside > 1.0 - 1e-6, inside > 1e-6 && inside < 1.0 - 1e-6)
}

/// No face cut, and one at least held.
fn keeps(crop: &Crop, faces: &[Subject]) -> bool {
    let all: Vec<_> = faces.iter().map(|face| holds_and_cuts(crop, face)).collect();
    all.iter().any(|(held, _)| *held) && !all.iter().any(|(_, cut)| *cut)
}

/// A keeping crop among some thousands of that aspect, from the widest to a third of it.
fn keeping_crop(width: f64, height: f64, aspect: f64, faces: &[Subject]) -> Option<Crop> {
    let widest = width.min(height * aspect);
    (0..9).find_map(|step| {
        let part = 1.0 - f64::from(step) / 12.0;
        let size = (widest * part / width, widest * part / aspect / height);
        (0..=20 * 20 + 40).find_map(|at| {
            let place = |i: i32, side: f64| (1.0 - side) * f64::from(i) / 20.0;
            let (x, y) = (place(at % 21, size.0), place(at / 21, size.1));
            let crop = Crop { x, y, width: size.0, height: size.1 };
            keeps(&crop, faces).then_some(crop)
        })
    })
}

fn face() -> impl Strategy<Value = (f64, f64, f64)> {
    (0.0f64..1.0, 0.0f64..1.0, 0.03f64..0.3)
}

/// Two faces, but only one fits, with hardly any space: a case that the property below once found.
#[test]
fn a_face_is_kept_beside_another_that_has_to_stay_out() {
    let face = |x: f64, y: f64, width: f64, height: f64| Subject {
        x,
        y,
        width,
        height,
        label: FACE.into(),
        score: 0.9,
        points: None,
        expression: None,
        light: None,
    };
    let faces = vec![
        face(0.387_132_861_728, 0.490_073_316_136, 0.232_241_151_354, 0.344_182_113_196),
        face(0.680_867_314_020, 0.201_909_296_686, 0.234_211_387_480, 0.347_102_009_301),
    ];
    let aspect = 2.221_483_812_156;
    assert!(keeping_crop(4735.0, 3834.0, aspect, &faces).is_some());
    let crop = frame(&photo(4735, 3834, faces.clone()), &Target::of_aspect(aspect), 0);
    assert!(keeps(&crop, &faces), "{crop:?}");
}

proptest! {
    #[test]
    fn no_face_is_cut_where_a_crop_keeps_them(
        width in 600u32..5000,
        height in 600u32..5000,
        aspect in 0.4f64..2.5,
        places in prop::collection::vec(face(), 1..5),
    ) {
        let (w, h) = (f64::from(width), f64::from(height));
        let faces: Vec<Subject> = places
            .into_iter()
            .map(|(x, y, size)| {
                let (fw, fh) = (size * w.min(h) / w, size * w.min(h) * 1.2 / h);
                let (x, y) = (x * (1.0 - fw), y * (1.0 - fh).max(0.0));
                Subject { x, y, width: fw, height: fh.min(1.0), label: FACE.into(), score: 0.9, points: None, expression: None, light: None }
            })
            .collect();
        if let Some(possible) = keeping_crop(w, h, aspect, &faces) {
            let crop = frame(&photo(width, height, faces.clone()), &Target::of_aspect(aspect), 0);
            prop_assert!(keeps(&crop, &faces), "{:?} although {:?} is possible; {:?}", crop, possible, faces);
        }
    }

    #[test]
    fn nothing_is_enlarged_more_than_twice_where_that_can_be(
        width in 300u32..5000,
        height in 300u32..5000,
        aspect in 0.4f64..2.5,
        panel in 50.0f64..2000.0,
        variant in 0u32..4,
    ) {
        let (w, h) = (f64::from(width), f64::from(height));
        let target = Target { width: panel, ..Target::of_aspect(aspect) };
        let crop = frame(&photo(width, height, Vec::new()), &target, variant);
        let (taken, widest) = (crop.width * w, w.min(h * aspect));
        prop_assert!(panel / taken <= 2.0 + 1e-9 || panel / widest > 2.0, "{} of {} for {}", taken, widest, panel);
    }
}
