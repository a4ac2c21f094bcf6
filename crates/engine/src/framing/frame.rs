//! The crop of one photo for one panel.

use super::Crop;
use super::candidates::{Area, Search, View, all};
use super::score::Judge;
use super::target::Target;
use super::{FACE, PhotoMeta};

/// Crops of one photo that differ; a photo used still more often starts again.
const VARIANTS: u32 = 8;

/// Height of the face as a fraction of a close crop, and its distance from the centre in crop widths.
const CLOSE: [f64; 3] = [0.46, 0.38, 0.32];
const BESIDE: [f64; 3] = [0.0, -0.14, 0.14];
/// [`BESIDE`] for a face that looks to the right: the crop leaves room there. Mirrored for one that looks to the left.
const AHEAD: [f64; 3] = [0.14, 0.0, -0.14];
/// Maximum width of a close crop as a fraction of the widest crop: for a single face, and for a face of a group.
const CLOSER: [f64; 2] = [0.5, 0.72];
/// Minimum height of a face that gets a close crop, as a fraction of the tallest face.
const MAIN: f64 = 0.6;
/// Maximum enlargement of a close crop. A style draws a soft face without features.
const MOST_ENLARGED: f64 = 1.5;

/// The crop of `photo` that suits the panel best. It lies inside the photo and has the aspect ratio of the panel, in pixels of the photo.
///
/// `variant` 0 is the best crop. 1, 2, ... are the next best crops that differ from earlier ones, for a photo
/// that is used again. They prefer a close crop of a face, other subjects, then another place or a closer crop. Without subjects and
/// focus, the crop follows the energy of the photo. Uniform bars at the edges of the photo stay outside. If possible, the edges and hidden parts of the panel cut no faces and no heads. The focus is always inside.
#[must_use]
pub fn frame(photo: &PhotoMeta, target: &Target, variant: u32) -> Crop {
    if let Some((picture, part)) = photo.trimmed() {
        return frame(&picture, target, variant).of(&part);
    }
    let close = if variant > 0 { closeup(photo, target, variant as usize - 1) } else { None };
    if let Some(close) = close {
        return close;
    }
    let search = if variant > 0 { Search::Closer } else { Search::Full };
    let view = View::new(photo, target);
    let mut judge = Judge::new(photo, &view);
    let candidates = judge.admitted(all(&view, search), variant == 0);
    let mut shown: Vec<Crop> = Vec::new();
    for _ in 0..=variant % VARIANTS {
        let best = candidates
            .iter()
            .map(|crop| (judge.score(crop, &shown), crop))
            .max_by(|a, b| a.0.total_cmp(&b.0))
            .map_or_else(|| view.widest(0.5, 0.5), |(_, crop)| *crop);
        judge.remember(&best);
        shown.push(best);
    }
    shown.last().copied().unwrap_or_else(|| view.widest(0.5, 0.5))
}

/// Returns a close crop of a face: of the largest face for `turn` 0, of the next face for 1.
///
/// The crop keeps the head and cuts no other face. Returns `None` if the photo has no such face, if no crop is
/// closer than the whole photo, or if the user set a focus point.
#[must_use]
pub fn closeup(photo: &PhotoMeta, target: &Target, turn: usize) -> Option<Crop> {
    if let Some((picture, part)) = photo.trimmed() {
        return Some(closeup(&picture, target, turn)?.of(&part));
    }
    let view = View::new(photo, target);
    if view.focus.is_some() {
        return None;
    }
    let faces: Vec<(Area, Area)> = view.faces().zip(view.heads()).collect();
    let gazes = view.subjects.iter().filter(|(_, subject)| subject.label == FACE).map(|(_, s)| s.gaze());
    let gazes: Vec<f64> = gazes.map(|gaze| if target.round { 0.0 } else { gaze }).collect();
    let tallest = faces.iter().map(|(face, _)| face.height).fold(0.0, f64::max);
    let main = |(face, _): &(Area, Area)| face.height >= MAIN * tallest;
    let closer = CLOSER[usize::from(faces.iter().filter(|face| main(face)).count() > 1)];
    let widest = view.widest(0.5, 0.5).width * view.width;
    let width = if target.width.is_finite() { target.width } else { 0.0 };
    let of = |(&(face, head), &gaze): (&(Area, Area), &f64)| {
        let beside = match gaze {
            0.0 => BESIDE,
            gaze => AHEAD.map(|off| off * gaze.signum()),
        };
        let (x, y) = (face.x + face.width / 2.0, face.y + face.height / 2.0);
        let crops = CLOSE.iter().flat_map(|part| beside.map(|off| (face.height / part * target.aspect, off)));
        crops
            .filter(|(across, _)| *across <= closer * widest && width <= MOST_ENLARGED * across)
            .map(|(across, off)| {
                view.about((x + off * across, y), across, if target.round { 0.5 } else { 0.44 })
            })
            .find(|crop| {
                let area = view.area(crop);
                let shown = area.shared(head) > 0.0 && !view.cuts(area, head);
                shown && faces.iter().all(|(other, _)| !view.cuts(area, *other))
            })
    };
    faces.iter().zip(&gazes).filter(|(face, _)| main(face)).filter_map(of).nth(turn)
}

/// Returns a crop in a tenth of the time of [`frame`], and the part of the photo's energy that it holds. The
/// crop is nearly as good, and good enough to choose photos.
#[must_use]
pub fn sketch(photo: &PhotoMeta, target: &Target) -> (Crop, f64) {
    if let Some((picture, part)) = photo.trimmed() {
        let (crop, energy) = sketch(&picture, target);
        return (crop.of(&part), energy);
    }
    let view = View::new(photo, target);
    let judge = Judge::new(photo, &view);
    let candidates = judge.admitted(all(&view, Search::Quick), true);
    let rated = candidates.iter().map(|crop| (judge.score(crop, &[]), crop));
    let best = rated.max_by(|a, b| a.0.total_cmp(&b.0));
    let crop = best.map_or_else(|| view.widest(0.5, 0.5), |(_, crop)| *crop);
    (crop, judge.energy(&crop))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::framing::{FIGURE, Focus, Subject};
    use crate::raster::{Matte, Plane};

    fn photo(width: u32, height: u32, subjects: Vec<Subject>) -> PhotoMeta {
        PhotoMeta { subjects, ..PhotoMeta::unmeasured("photo", width, height) }
    }

    fn subject(label: &str, x: f64, y: f64, width: f64, height: f64) -> Subject {
        Subject {
            x,
            y,
            width,
            height,
            label: label.into(),
            score: 0.9,
            points: None,
            expression: None,
            light: None,
        }
    }

    fn keeps(crop: &Crop, s: &Subject) -> bool {
        let inside = |a: f64, al: f64, b: f64, bl: f64| a <= b + 1e-9 && b + bl <= a + al + 1e-9;
        inside(crop.x, crop.width, s.x, s.width) && inside(crop.y, crop.height, s.y, s.height)
    }

    #[test]
    fn a_flat_photo_is_cropped_about_its_centre_and_not_zoomed() {
        let crop = frame(&photo(4000, 3000, Vec::new()), &Target::of_aspect(1.0), 0);
        assert!((crop.height - 1.0).abs() < 1e-12, "{crop:?}");
        assert!((crop.x + crop.width / 2.0 - 0.5).abs() < 1e-9, "{crop:?}");
    }

    #[test]
    fn a_face_at_the_edge_is_kept_whole() {
        for x in [0.0, 0.2, 0.45, 0.86] {
            let face = subject(FACE, x, 0.1, 0.14, 0.2);
            let crop = frame(&photo(4000, 3000, vec![face.clone()]), &Target::of_aspect(0.4), 0);
            assert!(keeps(&crop, &face), "{crop:?} cuts the face at {x}");
        }
    }

    /// A photo with a disc as its mask, centred at a horizontal position.
    fn masked(across: f64, subjects: Vec<Subject>) -> PhotoMeta {
        let shares = Plane::from_fn(320, 240, |x, y| {
            let far = (x as f64 - 320.0 * across).hypot(y as f64 - 120.0);
            ((36.5 - far).clamp(0.0, 1.0) * 255.0) as u8
        });
        PhotoMeta { mask: Some(Matte::new(&shares, (320, 240))), ..photo(4000, 3000, subjects) }
    }

    #[test]
    fn what_only_the_mask_shows_is_kept_whole() {
        for across in [0.15, 0.5, 0.85] {
            let figure = subject(FIGURE, across - 0.11, 0.36, 0.22, 0.28);
            let crop = frame(&masked(across, Vec::new()), &Target::of_aspect(0.4), 0);
            assert!(keeps(&crop, &figure), "{crop:?} cuts the figure at {across}");
        }
    }

    #[test]
    fn a_mask_leaves_the_crop_to_faces_and_counts_for_nothing_where_it_is_vague() {
        let face = subject(FACE, 0.1, 0.1, 0.14, 0.2);
        let target = Target::of_aspect(0.4);
        let without = frame(&photo(4000, 3000, vec![face.clone()]), &target, 0);
        assert_eq!(frame(&masked(0.85, vec![face]), &target, 0), without);
        let haze = Plane::from_fn(320, 240, |x, _| (x * 255 / 319) as u8);
        let mask = Some(Matte::new(&haze, (320, 240)));
        let hazy = PhotoMeta { mask, ..photo(4000, 3000, Vec::new()) };
        assert_eq!(frame(&hazy, &target, 0), frame(&photo(4000, 3000, Vec::new()), &target, 0));
    }

    #[test]
    fn bars_of_the_photo_stay_outside() {
        let facts = |bars: &str| serde_json::from_str(&format!("\"{}{bars}\"", "10".repeat(25))).unwrap();
        let face = subject(FACE, 0.4, 0.3, 0.1, 0.15);
        let photo = photo(1000, 800, vec![face.clone()]);
        let barred = PhotoMeta { facts: Some(facts("40003300")), ..photo };
        for aspect in [0.5, 1.0, 2.0] {
            for crop in [
                frame(&barred, &Target::of_aspect(aspect), 0),
                frame(&barred, &Target::of_aspect(aspect), 2),
                sketch(&barred, &Target::of_aspect(aspect)).0,
                barred.refitted(&frame(&barred, &Target::of_aspect(1.3 * aspect), 0), aspect),
            ] {
                assert!(crop.x >= 0.251 && crop.x + crop.width <= 0.8, "{aspect} {crop:?}");
                let own = crop.width * 1000.0 / (crop.height * 800.0);
                assert!((own / aspect - 1.0).abs() < 1e-6, "{aspect} {crop:?}");
            }
        }
        assert!(keeps(&frame(&barred, &Target::of_aspect(1.0), 0), &face));
        // An edited crop may show a bar.
        let everything = Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };
        assert!(barred.refitted(&everything, 1.2).x < 0.2);
    }

    #[test]
    fn a_crop_is_narrower_rather_than_without_the_head_of_an_animal() {
        for (x, y) in [(0.02, 0.0), (0.55, 0.35), (0.3, 0.0)] {
            let dog = subject("dog", x, y, 0.3, 0.62);
            for aspect in [0.6, 1.0, 2.2] {
                let crop = frame(&photo(3000, 2000, vec![dog.clone()]), &Target::of_aspect(aspect), 0);
                let head = Subject { height: 0.4 * dog.height, ..dog.clone() };
                assert!(keeps(&crop, &head), "{aspect} {crop:?} cuts the head of {dog:?}");
            }
        }
    }

    #[test]
    fn a_small_figure_is_shown_from_near_and_its_head_is_complete() {
        let face = subject(FACE, 0.44, 0.3, 0.035, 0.06);
        let person = subject("person", 0.4, 0.27, 0.12, 0.6);
        let area = |crop: Crop| crop.width * crop.height;
        for aspect in [0.5, 0.7, 1.0, 1.5] {
            let target = Target::of_aspect(aspect);
            let near = frame(&photo(4000, 3000, vec![face.clone(), person.clone()]), &target, 0);
            let widest = (0.75 * aspect).min(1.0 / (0.75 * aspect));
            assert!(area(near) < 0.8 * widest, "{aspect} {near:?}");
            assert!(keeps(&near, &face), "{aspect} {near:?}");
            // A face without a person can be a false detection.
            let unsure = Subject { score: 0.6, ..face.clone() };
            let far = frame(&photo(4000, 3000, vec![unsure]), &target, 0);
            assert!(area(far) >= 0.8 * widest, "{aspect} {far:?}");
        }
    }

    #[test]
    fn a_panel_that_is_too_low_for_a_head_shows_most_of_it() {
        let face = subject(FACE, 0.4, 0.14, 0.16, 0.206);
        let head = face.grown();
        let crop = frame(&photo(1000, 1000, vec![face]), &Target::of_aspect(3.2), 0);
        let shown = (crop.y + crop.height).min(head.y + head.height) - crop.y.max(head.y);
        assert!(head.height > crop.height && shown >= 0.92 * head.height, "{crop:?} of {head:?}");
    }

    #[test]
    fn a_crop_avoids_a_person_whose_head_the_photo_cuts() {
        // A speaker behind a lectern, and a singer. The photo ends at the neck of the speaker.
        let speaker = Subject { score: 0.49, ..subject("person", 0.194, 0.037, 0.343, 0.9) };
        let singer = [subject(FACE, 0.565, 0.3, 0.113, 0.17), subject("person", 0.458, 0.169, 0.391, 0.831)];
        let all = photo(3600, 2400, vec![singer[0].clone(), singer[1].clone(), speaker.clone()]);
        for aspect in [0.6, 0.8, 1.0, 1.2] {
            let crop = frame(&all, &Target::of_aspect(aspect), 0);
            let shown = (speaker.x + speaker.width - crop.x.max(speaker.x)).max(0.0) / speaker.width;
            assert!(keeps(&crop, &singer[0]) && shown < 0.4, "{aspect} {shown} {crop:?}");
        }
    }

    #[test]
    fn a_narrow_panel_does_not_cut_a_person_lengthwise() {
        // A person in the middle of a tall photo, with a bright scene on one side.
        let subjects = vec![subject(FACE, 0.48, 0.19, 0.1, 0.08), subject("person", 0.28, 0.14, 0.47, 0.82)];
        let values = "0a0a0a0a0a0aff".repeat(7);
        let energy = format!(r#"{{"columns":7,"rows":7,"values":"{values}"}}"#);
        let energy = serde_json::from_str(&energy).unwrap();
        let photo = PhotoMeta { energy, ..photo(2000, 2500, subjects) };
        for aspect in [0.4, 0.54, 0.7] {
            let crop = frame(&photo, &Target::of_aspect(aspect), 0);
            let (left, right) = (crop.x.max(0.28), (crop.x + crop.width).min(0.75));
            assert!(right - left >= 0.85 * crop.width.min(0.47), "{aspect} {crop:?}");
            let across = (0.53 - crop.x) / crop.width;
            assert!((across - 0.5).abs() < 0.2, "{aspect} {across} {crop:?}");
        }
    }

    #[test]
    fn a_group_is_kept_together_when_it_fits() {
        let faces = [0.1, 0.4, 0.7].map(|x| subject(FACE, x, 0.3, 0.1, 0.15));
        let crop = frame(&photo(4000, 3000, faces.to_vec()), &Target::of_aspect(1.4), 0);
        assert!(faces.iter().all(|face| keeps(&crop, face)), "{crop:?}");
    }

    #[test]
    fn the_outer_people_of_a_group_keep_their_shoulders() {
        let faces = [0.2, 0.32, 0.44, 0.56, 0.68].map(|x| subject(FACE, x, 0.3, 0.06, 0.11));
        for aspect in [1.1, 1.3, 1.6] {
            let crop = frame(&photo(4000, 3000, faces.to_vec()), &Target::of_aspect(aspect), 0);
            let beside = [0.2 - crop.x, crop.x + crop.width - 0.74];
            assert!(beside.iter().all(|room| *room >= 0.8 * 0.06), "{aspect}: {beside:?} {crop:?}");
        }
        // A photo that ends beside a face has no more room.
        let faces = [0.01, 0.2, 0.4].map(|x| subject(FACE, x, 0.3, 0.08, 0.14));
        let crop = frame(&photo(4000, 3000, faces.to_vec()), &Target::of_aspect(1.0), 0);
        assert!(faces.iter().all(|face| keeps(&crop, face)), "{crop:?}");
    }

    #[test]
    fn a_class_photo_has_no_cut_heads() {
        // Three rows of eight, the back rows smaller.
        let heads: Vec<Subject> = (0..24)
            .map(|i| {
                let (column, row) = (f64::from(i % 8), f64::from(i / 8));
                let size = 0.04 + 0.01 * row;
                subject(FACE, 0.06 + 0.11 * column + 0.02 * row, 0.2 + 0.17 * row, size, size * 1.3)
            })
            .collect();
        for aspect in [0.4, 0.7, 1.0, 1.6, 2.5] {
            let crop = frame(&photo(4000, 3000, heads.clone()), &Target::of_aspect(aspect), 0);
            let cut = |face: &Subject| {
                let shared = |a: f64, al: f64, b: f64, bl: f64| ((a + al).min(b + bl) - a.max(b)).max(0.0);
                let part = shared(crop.x, crop.width, face.x, face.width)
                    * shared(crop.y, crop.height, face.y, face.height)
                    / (face.width * face.height);
                (1e-6..1.0 - 1e-6).contains(&part)
            };
            assert!(!heads.iter().any(cut), "{aspect}: {crop:?}");
        }
    }

    #[test]
    fn a_speck_does_not_become_the_picture() {
        let sheep = Subject { score: 0.6, ..subject("sheep", 0.48, 0.65, 0.04, 0.04) };
        let crop = frame(&photo(1600, 1200, vec![sheep]), &Target::of_aspect(1.0), 0);
        assert!(crop.height > 0.8, "{crop:?}");
    }

    #[test]
    fn the_second_use_shows_another_subject() {
        let subjects = vec![subject("cat", 0.05, 0.4, 0.2, 0.3), subject("dog", 0.7, 0.35, 0.25, 0.4)];
        let photo = photo(4000, 3000, subjects);
        let target = Target::of_aspect(0.7);
        let (first, second) = (frame(&photo, &target, 0), frame(&photo, &target, 1));
        assert!(first.overlap(&second) < 0.2, "{first:?} {second:?}");
    }

    #[test]
    fn the_second_use_of_a_group_shows_a_face_from_near() {
        let faces = [0.1, 0.4, 0.7].map(|x| subject(FACE, x, 0.3, 0.1, 0.15));
        let photo = photo(4000, 3000, faces.to_vec());
        let target = Target::of_aspect(1.2);
        let close: Vec<Crop> = (1..4).map(|variant| frame(&photo, &target, variant)).collect();
        for crop in &close {
            let whole = faces.iter().filter(|face| keeps(crop, face)).count();
            assert_eq!(whole, 1, "{crop:?}");
            assert!(crop.height < 0.5 && (0.3..0.5).contains(&(0.15 / crop.height)), "{crop:?}");
        }
        assert!(close[0].overlap(&close[1]) < 0.5);
        // A portrait has no closer look that keeps the head.
        let portrait = PhotoMeta { subjects: vec![subject(FACE, 0.3, 0.2, 0.4, 0.5)], ..photo };
        assert_eq!(closeup(&portrait, &target, 0), None);
        let small = Target { width: 4000.0, ..target };
        assert_eq!(closeup(&PhotoMeta { subjects: faces.to_vec(), ..portrait }, &small, 0), None);
    }

    #[test]
    fn the_focus_is_inside_and_near_the_centre() {
        let mut photo = photo(4000, 3000, Vec::new());
        photo.focus = Some(Focus { x: 0.8, y: 0.3 });
        let crop = frame(&photo, &Target::of_aspect(0.5), 0);
        let centre = crop.x + crop.width / 2.0;
        assert!((centre - 0.8).abs() < 0.1, "{crop:?}");
    }

    /// A face that looks to the right for a `side` of 1, and to the left for -1.
    fn looking(side: f64, x: f64, y: f64, width: f64, height: f64) -> Subject {
        let at = |across: f64, down: f64| [x + width * (0.5 + side * across), y + height * down];
        let points = [at(0.2, 0.3), at(0.4, 0.3), at(0.45, 0.5), at(0.35, 0.75), at(-0.1, 0.4), at(0.0, 0.4)];
        Subject { points: Some(points), ..subject(FACE, x, y, width, height) }
    }

    #[test]
    fn a_crop_leaves_room_where_a_face_looks() {
        let place = |face: Subject, variant: u32| {
            let middle = face.x + face.width / 2.0;
            let crop = frame(&photo(4000, 3000, vec![face]), &Target::of_aspect(0.7), variant);
            (middle - crop.x) / crop.width
        };
        for variant in [0, 1] {
            let [ahead, right, left] = [0.0, 1.0, -1.0].map(|side| {
                let face = looking(side, 0.45, 0.3, 0.1, 0.16);
                assert!((face.gaze() - side).abs() < 1e-9, "{side}: {}", face.gaze());
                place(face, variant)
            });
            assert!(right < 0.42 && left > 0.58, "{variant}: {right} {left}");
            assert!((0.4..0.6).contains(&ahead), "{variant}: {ahead}");
            // Faces of old projects have no points.
            let unknown = place(subject(FACE, 0.45, 0.3, 0.1, 0.16), variant);
            assert!((unknown - ahead).abs() < 1e-9, "{variant}: {unknown} {ahead}");
        }
        let round = Target { round: true, ..Target::of_aspect(1.0) };
        let crop = frame(&photo(4000, 3000, vec![looking(1.0, 0.3, 0.35, 0.1, 0.15)]), &round, 0);
        assert!((crop.x + crop.width / 2.0 - 0.35).abs() < 0.01, "{crop:?}");
    }

    #[test]
    fn a_circle_centres_its_subject() {
        let face = subject(FACE, 0.3, 0.35, 0.1, 0.15);
        let target = Target { round: true, ..Target::of_aspect(1.0) };
        let crop = frame(&photo(4000, 3000, vec![face]), &target, 0);
        assert!((crop.x + crop.width / 2.0 - 0.35).abs() < 0.01, "{crop:?}");
        assert!((crop.y + crop.height / 2.0 - 0.425).abs() < 0.03, "{crop:?}");
    }

    fn any_subject() -> impl Strategy<Value = Subject> {
        let label = prop_oneof![Just(FACE), Just("person"), Just("car")];
        (0.0..0.98, 0.0..0.98, 0.01..0.6, 0.01..0.6, label).prop_map(
            |(x, y, w, h, label): (f64, f64, f64, f64, _)| {
                subject(label, x, y, w.min(1.0 - x), h.min(1.0 - y))
            },
        )
    }

    proptest! {
        #[test]
        fn crops_lie_inside_and_have_the_exact_aspect(
            width in prop_oneof![Just(1u32), 1u32..10_000],
            height in prop_oneof![Just(1u32), Just(10_000), 1u32..10_000],
            aspect in 0.05f64..20.0,
            panel in 0.0f64..4000.0,
            round: bool,
            variant in 0u32..10,
            subjects in prop::collection::vec(any_subject(), 0..6),
            focus in prop::option::of((0.0f64..=1.0, 0.0f64..=1.0)),
        ) {
            let mut photo = photo(width, height, subjects);
            photo.focus = focus.map(|(x, y)| Focus { x, y });
            let aspect = if round { 1.0 } else { aspect };
            let target = Target { width: panel, round, ..Target::of_aspect(aspect) };
            let crop = frame(&photo, &target, variant);
            prop_assert_eq!(crop, frame(&photo, &target, variant));
            prop_assert!(crop.x >= 0.0 && crop.y >= 0.0 && crop.width > 0.0 && crop.height > 0.0);
            prop_assert!(crop.x + crop.width <= 1.0 && crop.y + crop.height <= 1.0, "{:?}", crop);
            let shown = (crop.width * f64::from(width)) / (crop.height * f64::from(height));
            prop_assert!((shown / target.aspect - 1.0).abs() < 1e-9, "{} for {}", shown, target.aspect);
            if let Some((x, y)) = focus {
                prop_assert!(x >= crop.x - 1e-9 && x <= crop.x + crop.width + 1e-9);
                prop_assert!(y >= crop.y - 1e-9 && y <= crop.y + crop.height + 1e-9);
            }
        }

        #[test]
        fn one_face_is_never_cut_when_it_fits(
            width in 200u32..6000,
            height in 200u32..6000,
            aspect in 0.3f64..3.5,
            x in 0.0f64..1.0,
            y in 0.0f64..1.0,
            size in 0.02f64..0.5,
        ) {
            let (w, h) = (f64::from(width), f64::from(height));
            let side = size * w.min(h);
            let (fw, fh) = (side / w, (side * 1.2).min(h) / h);
            let face = subject(FACE, x * (1.0 - fw), y * (1.0 - fh), fw, fh);
            let photo = photo(width, height, vec![face.clone()]);
            let crop = frame(&photo, &Target::of_aspect(aspect), 0);
            let fits = fw * w <= w.min(h * aspect) && fh * h <= h.min(w / aspect);
            prop_assert!(!fits || keeps(&crop, &face), "{:?} cuts {:?}", crop, face);
        }
    }
}
