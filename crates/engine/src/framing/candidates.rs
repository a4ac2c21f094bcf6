//! Candidate crops of a photo: the whole photo, areas of high energy, and the areas around its subjects.
//!
//! The expansions of a box follow the framing of "Graphic Narrative with Interactive Stylization Design"
//! (Garcia-Dorado et al.). They grow by a fixed amount, by 10 % or 50 %, or to the whole photo, independently
//! in width and height. Each is then brought to the panel's exact aspect.

use std::borrow::Cow;

use super::Crop;
use super::target::Target;
use super::{FACE, PhotoMeta, Subject};
use crate::layout::Bounds;
use crate::order::sort_by;

/// Vertical position of a face's centre in a crop.
const EYE_LINE: f64 = 0.42;
/// Vertical position of a face's centre in a medium shot.
const HIGH: f64 = 0.28;
/// Heights of the tallest face in heights of a medium shot.
const FACE_SHARES: [f64; 4] = [0.2, 0.26, 0.15, 0.11];
/// The paper's 40 pixels, as a fraction of the photo's longer side.
const FIXED_EXPANSION: f64 = 0.04;
/// Maximum number of subjects; the largest ones count.
const MOST_SUBJECTS: usize = 12;
/// Faces that no crop may cut; a class or a wedding has more than crops are drawn round.
const MOST_FACES: usize = 40;
/// The part of each side of a head that a crop may trim.
const TRIMMED: f64 = 0.04;
/// Zoom steps of the rule without detection, as parts of the widest crop.
const STEPS: [f64; 3] = [1.0, 0.8, 0.6];
/// Places across and down that the rule without detection tries at each step.
const PLACES: u32 = 7;
/// Zoom factors for a photo that is used again.
const CLOSER_STEPS: [f64; 2] = [0.5, 0.4];

/// Share of the crop that a face in full profile is away from the middle, to leave room where it looks.
pub(super) const ROOM: f64 = 0.14;

/// A rectangle in pixels of the photo.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Area {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) width: f64,
    pub(super) height: f64,
}

impl Area {
    fn union(self, other: Self) -> Self {
        let (x, y) = (self.x.min(other.x), self.y.min(other.y));
        let right = (self.x + self.width).max(other.x + other.width);
        let bottom = (self.y + self.height).max(other.y + other.height);
        Self { x, y, width: right - x, height: bottom - y }
    }

    /// The rectangle without a part of its width on the left and right, and of its height at the top and bottom.
    pub(super) fn inset(self, part: f64) -> Self {
        let (x, y) = (self.x + part * self.width, self.y + part * self.height);
        let left = 1.0 - 2.0 * part;
        Self { x, y, width: left * self.width, height: left * self.height }
    }

    /// The area that two rectangles share.
    pub(super) fn shared(self, other: Self) -> f64 {
        overlap((self.x, self.width), (other.x, other.width))
            * overlap((self.y, self.height), (other.y, other.height))
    }

    /// The width that two rectangles share, as a part of the narrower one.
    pub(super) fn across(self, other: Self) -> f64 {
        overlap((self.x, self.width), (other.x, other.width)) / self.width.min(other.width)
    }
}

/// The length that two ranges share, each a start and a length.
fn overlap((a, a_length): (f64, f64), (b, b_length): (f64, f64)) -> f64 {
    ((a + a_length).min(b + b_length) - a.max(b)).max(0.0)
}

/// A photo seen through a panel: everything in pixels of the photo.
pub(super) struct View<'a> {
    pub(super) width: f64,
    pub(super) height: f64,
    pub(super) target: &'a Target,
    /// The largest subjects, faces first.
    pub(super) subjects: Vec<(Area, Cow<'a, Subject>)>,
    /// The same boxes with their surroundings, see [`Subject::grown`].
    pub(super) grown: Vec<Area>,
    /// People whose head the photo cuts. They are not subjects.
    pub(super) headless: Vec<Area>,
    pub(super) focus: Option<(f64, f64)>,
    aspect: f64,
}

impl<'a> View<'a> {
    pub(super) fn new(photo: &'a PhotoMeta, target: &'a Target) -> Self {
        let (width, height) = (f64::from(photo.width.max(1)), f64::from(photo.height.max(1)));
        let aspect = if target.aspect.is_finite() { target.aspect.clamp(1e-3, 1e3) } else { 1.0 };
        let inside = |low: f64, length: f64| {
            let (from, to) = (low.clamp(0.0, 1.0), (low + length).clamp(0.0, 1.0));
            (from, to - from)
        };
        let area = |s: &Subject| {
            let ((x, w), (y, h)) = (inside(s.x, s.width), inside(s.y, s.height));
            Area { x: x * width, y: y * height, width: w * width, height: h * height }
        };
        let headless = photo.subjects.iter().filter(|s| photo.is_headless(s)).map(area).collect();
        let mut subjects: Vec<(Area, Cow<Subject>)> = photo
            .marked()
            .filter(|s| !photo.is_headless(s))
            .filter(|s| [s.x, s.y, s.width, s.height, s.score].iter().all(|v| v.is_finite()))
            .map(|s| (area(&s), s))
            .filter(|(area, _)| area.width > 0.0 && area.height > 0.0)
            .collect();
        let rank = |(area, s): &(Area, Cow<Subject>)| {
            let size = area.width * area.height * s.score.clamp(0.0, 1.0);
            if s.label == FACE { size + width * height } else { size }
        };
        sort_by(&mut subjects, |a, b| rank(b).total_cmp(&rank(a)));
        let faces = subjects.iter().filter(|(_, subject)| subject.label == FACE).count();
        subjects.truncate(MOST_SUBJECTS.max(faces.min(MOST_FACES)));
        let grown = subjects.iter().map(|(_, subject)| area(&subject.grown())).collect();
        let focus = photo.focus.filter(|f| f.x.is_finite() && f.y.is_finite());
        let focus = focus.map(|f| (f.x.clamp(0.0, 1.0) * width, f.y.clamp(0.0, 1.0) * height));
        Self { width, height, target, subjects, grown, headless, focus, aspect }
    }

    /// The widest crop, at that place along the side on which it can move (0 left or top, 1 right or bottom).
    pub(super) fn widest(&self, across: f64, down: f64) -> Crop {
        let width = self.widest_width();
        let (x, y) = ((self.width - width) * across, (self.height - width / self.aspect) * down);
        self.crop(x, y, width)
    }

    /// The crop in pixels.
    pub(super) fn area(&self, crop: &Crop) -> Area {
        Area {
            x: crop.x * self.width,
            y: crop.y * self.height,
            width: crop.width * self.width,
            height: crop.height * self.height,
        }
    }

    /// The faces among the subjects.
    pub(super) fn faces(&self) -> impl Iterator<Item = Area> + '_ {
        self.subjects.iter().filter(|(_, s)| s.label == FACE).map(|(area, _)| *area)
    }

    /// The largest faces that look to the side, and their [`Subject::gaze`].
    fn gazes(&self) -> impl Iterator<Item = (Area, f64)> + '_ {
        let faces = self.subjects.iter().take(MOST_SUBJECTS).map(|(area, s)| (*area, s.gaze()));
        faces.filter(|(_, gaze)| *gaze != 0.0)
    }

    /// The heads of the faces among the subjects, in the same order.
    pub(super) fn heads(&self) -> impl Iterator<Item = Area> + '_ {
        let faces = self.subjects.iter().zip(&self.grown).filter(|((_, s), _)| s.label == FACE);
        faces.map(|(_, grown)| *grown)
    }

    /// Most of each head. A crop may trim the rest if no crop shows the complete heads.
    pub(super) fn most_of_heads(&self) -> Vec<Area> {
        self.heads().map(|head| head.inset(TRIMMED)).collect()
    }

    /// A rectangle of the photo in parts of a crop.
    pub(super) fn within(crop: Area, inner: Area) -> Bounds {
        Bounds {
            x: (inner.x - crop.x) / crop.width,
            y: (inner.y - crop.y) / crop.height,
            width: inner.width / crop.width,
            height: inner.height / crop.height,
        }
    }

    /// True when the panel shows a part of the face only; a face outside altogether is not cut.
    pub(super) fn cuts(&self, crop: Area, face: Area) -> bool {
        if self.target.round {
            let (near, far) = reach(crop, face);
            if near < 1.0 && far > 1.0 {
                return true;
            }
        }
        if !self.target.region.is_plain() {
            return self.target.region.cuts(Self::within(crop, face));
        }
        if self.target.round {
            return false;
        }
        let shared = crop.shared(face);
        shared > 0.0 && shared < face.width * face.height * (1.0 - 1e-9)
    }

    fn widest_width(&self) -> f64 {
        self.width.min(self.height * self.aspect)
    }

    /// A crop of that width moved inside the photo.
    fn crop(&self, x: f64, y: f64, width: f64) -> Crop {
        let width = width.min(self.widest_width());
        let fraction = (width / self.width, width / self.aspect / self.height);
        // The sum of place and size is at most 1 also after rounding.
        let place = |at: f64, side: f64, fraction: f64| (at / side).min(1.0 - fraction).max(0.0);
        let (across, down) = (fraction.0.min(1.0), fraction.1.min(1.0));
        Crop { x: place(x, self.width, across), y: place(y, self.height, down), width: across, height: down }
    }

    /// A crop with this width around a point, which is at `level` of its height.
    pub(super) fn about(&self, at: (f64, f64), width: f64, level: f64) -> Crop {
        let width = width.min(self.widest_width());
        self.crop(at.0 - width / 2.0, at.1 - width / self.aspect * level, width)
    }
}

/// Distances of the nearest point of a box and of its rounded-off corners from the centre of a round
/// crop, in its radii. Heads are round, so their corners may stick out a little.
pub(super) fn reach(crop: Area, inner: Area) -> (f64, f64) {
    let radius = crop.width.min(crop.height) / 2.0;
    let (cx, cy) = (crop.x + crop.width / 2.0, crop.y + crop.height / 2.0);
    let near_x = cx.clamp(inner.x, inner.x + inner.width) - cx;
    let near_y = cy.clamp(inner.y, inner.y + inner.height) - cy;
    let (ix, iy) = (inner.x + inner.width / 2.0, inner.y + inner.height / 2.0);
    let far = (ix - cx).hypot(iy - cy) + inner.width.max(inner.height) * 0.55;
    (near_x.hypot(near_y) / radius, far / radius)
}

/// How far to look.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Search {
    /// All crops worth a look.
    Full,
    /// Closer ones too, for a photo that is used before.
    Closer,
    /// A few.
    Quick,
}

/// Crops worth a look.
pub(super) fn all(view: &View, search: Search) -> Vec<Crop> {
    let quick = search == Search::Quick;
    let closer = if search == Search::Closer { &CLOSER_STEPS[..] } else { &[] };
    let steps = if quick { &STEPS[..2] } else { &STEPS[..] };
    let steps: Vec<f64> = steps.iter().chain(closer).map(|step| step * view.widest_width()).collect();
    let places = if quick { 5 } else { PLACES };
    let mut crops = Vec::new();
    for &width in &steps {
        let (right, bottom) = (view.width - width, view.height - width / view.aspect);
        // Without space to move, all positions are equal.
        let count = |room: f64, side: f64| if room > 1e-9 * side { places } else { 1 };
        let (across, down) = (count(right, view.width), count(bottom, view.height));
        let part =
            |place: u32, count: u32| if count > 1 { f64::from(place) / f64::from(count - 1) } else { 0.5 };
        for y in 0..down {
            for x in 0..across {
                crops.push(view.crop(right * part(x, across), bottom * part(y, down), width));
            }
        }
        if let Some(at) = view.focus {
            crops.push(view.about(at, width, 0.5));
        }
    }
    let faces: Vec<Area> = view.faces().collect();
    let heads: Vec<Area> = view.heads().collect();
    closer_to_faces(view, &faces, quick, &mut crops);
    let boxes = boxes(view, &faces, if quick { 3 } else { MOST_SUBJECTS });
    for &subject in &boxes {
        let face = faces.contains(&subject);
        expansions(view, subject, face, quick, &mut crops);
        // Wide, with the subject in a prominent position.
        let centre = (subject.x + subject.width / 2.0, subject.y + subject.height / 2.0);
        let level = if face && !view.target.round { EYE_LINE } else { 0.5 };
        crops.extend(steps.iter().map(|&width| view.about(centre, width, level)));
    }
    if !view.target.round {
        for (face, gaze) in view.gazes() {
            let (x, y) = (face.x + face.width / 2.0, face.y + face.height / 2.0);
            crops
                .extend(steps.iter().map(|&width| view.about((x + ROOM * gaze * width, y), width, EYE_LINE)));
        }
    }
    if !view.target.region.is_plain() {
        let grown = boxes.iter().chain(heads.iter().take(MOST_SUBJECTS)).copied();
        let focus = view.focus.map(|(x, y)| Area { x, y, width: 0.0, height: 0.0 });
        for subject in grown.chain(focus) {
            into_core(view, subject, &steps, &mut crops);
        }
    }
    if !faces.is_empty() && !view.target.round {
        let most = if quick { places as usize } else { crops.len() };
        let settle = |crops: &mut Vec<Crop>, whole: &[Area]| {
            let settled: Vec<Crop> =
                crops.iter().take(most).filter_map(|crop| settled(view, crop, whole)).collect();
            crops.extend(settled);
        };
        let kept = |crops: &[Crop], whole: &[Area]| crops.iter().any(|crop| keeps(view, crop, whole));
        settle(&mut crops, &faces);
        settle(&mut crops, &heads);
        for whole in [&faces, &heads] {
            if !kept(&crops, whole) {
                crops.extend(tight(view, whole));
            }
        }
        if !quick && !kept(&crops, &heads) {
            let trimmed = view.most_of_heads();
            settle(&mut crops, &trimmed);
            if !kept(&crops, &trimmed) {
                crops.extend(tight(view, &trimmed));
            }
        }
    }
    crops.dedup();
    crops
}

/// Medium shots: crops round the tallest face and round all main faces, in which the tallest face has a share of the height.
fn closer_to_faces(view: &View, faces: &[Area], quick: bool, crops: &mut Vec<Crop>) {
    let tallest = |faces: &[Area]| faces.iter().copied().max_by(|a, b| a.height.total_cmp(&b.height));
    let Some(first) = tallest(faces) else { return };
    let group = faces.iter().copied().filter(|face| face.height >= 0.5 * first.height).reduce(Area::union);
    let shares = if quick { &FACE_SHARES[..2] } else { &FACE_SHARES[..] };
    for share in shares {
        let height = first.height / share;
        for inner in [Some(first), group].into_iter().flatten() {
            let width = (height * view.aspect).max(inner.width * 1.3).max(inner.height * 1.3 * view.aspect);
            let centre = (inner.x + inner.width / 2.0, inner.y + inner.height / 2.0);
            for level in [EYE_LINE, HIGH] {
                crops.push(view.about(centre, width, if view.target.round { 0.5 } else { level }));
            }
        }
    }
}

/// Crops that show a box in the completely visible part of the panel.
fn into_core(view: &View, inner: Area, steps: &[f64], crops: &mut Vec<Crop>) {
    let core = view.target.region.core();
    let (cx, cy) = (inner.x + inner.width / 2.0, inner.y + inner.height / 2.0);
    let (mx, my) = (core.x + core.width / 2.0, core.y + core.height / 2.0);
    let least = (inner.width / core.width).max(inner.height / core.height * view.aspect);
    let fitting = [1.02, 1.2, 1.6, 2.4].map(|room| least * room);
    for &width in fitting.iter().chain(steps) {
        let width = width.min(view.widest_width());
        if width <= 0.0 {
            continue;
        }
        let height = width / view.aspect;
        crops.push(view.crop(cx - mx * width, cy - my * height, width));
        // The crop in the middle of the photo, moved as little as brings the box into the core.
        let (x, y) = ((view.width - width) / 2.0, (view.height - height) / 2.0);
        let moved = |at: f64, low: f64, side: f64, from: f64, length: f64| {
            let (most, least) = (from - low, from + length - low - side);
            if least <= most { at.clamp(least, most) } else { f64::midpoint(least, most) }
        };
        let x = moved(x, core.x * width, core.width * width, inner.x, inner.width);
        let y = moved(y, core.y * height, core.height * height, inner.y, inner.height);
        crops.push(view.crop(x, y, width));
    }
}

/// Boxes for crops: each subject, all faces, the largest fitting group of faces, all subjects.
fn boxes(view: &View, faces: &[Area], most: usize) -> Vec<Area> {
    let all: Vec<Area> = view.subjects.iter().map(|(area, _)| *area).collect();
    let mut boxes: Vec<Area> = all.iter().copied().take(most).collect();
    let (widest, highest) = (view.widest_width(), view.widest_width() / view.aspect);
    let groups = [faces.to_vec(), all];
    for group in groups.iter().filter(|group| group.len() > 1) {
        let whole = group.iter().copied().reduce(Area::union);
        let fitting = group.iter().copied().reduce(|kept, next| {
            let both = kept.union(next);
            if both.width <= widest && both.height <= highest { both } else { kept }
        });
        boxes.extend(whole);
        boxes.extend(fitting);
    }
    boxes
}

/// The paper's sixteen expansions of a box, brought to the panel's aspect.
fn expansions(view: &View, inner: Area, face: bool, quick: bool, crops: &mut Vec<Crop>) {
    let fixed = FIXED_EXPANSION * view.width.max(view.height);
    // A crop draws the eye to the upper part; in a circle the centre is what one sees.
    let level = if face && !view.target.round { EYE_LINE } else { 0.5 };
    let centre = (inner.x + inner.width / 2.0, inner.y + inner.height / 2.0);
    if quick {
        for room in [1.15, 1.5, 2.2] {
            crops.push(view.about(centre, inner.width.max(inner.height * view.aspect) * room, level));
        }
        crops.push(view.about(centre, view.width, level));
        return;
    }
    for width in [inner.width + fixed, inner.width * 1.1, inner.width * 1.5, view.width] {
        for height in [inner.height + fixed, inner.height * 1.1, inner.height * 1.5, view.height] {
            crops.push(view.about(centre, width.max(height * view.aspect), level));
        }
    }
    if view.target.round {
        // A circle around the diagonal of a box contains the box.
        for room in [1.1, 1.6, 2.2] {
            crops.push(view.about(centre, inner.width.hypot(inner.height) * room, level));
        }
    }
}

/// Returns whether a crop shows a complete face and cuts none.
fn keeps(view: &View, crop: &Crop, faces: &[Area]) -> bool {
    let area = view.area(crop);
    let holds = |face: &Area| view.target.region.holds(View::within(area, *face));
    faces.iter().any(holds) && !faces.iter().any(|face| view.cuts(area, *face))
}

/// Returns crops as small as some of the faces allow, if all crops with more space cut a face. For any crop
/// that contains some faces and cuts none, the smallest crop around the same faces within it does so as well.
fn tight(view: &View, faces: &[Area]) -> Vec<Crop> {
    let few = if faces.len() > MOST_SUBJECTS { 2 } else { 6 };
    let first = &faces[..faces.len().min(few)];
    let groups = (1_u32..1 << first.len()).filter_map(|chosen| {
        let is_in = |&(i, _): &(usize, &Area)| chosen >> i & 1 == 1;
        first.iter().enumerate().filter(is_in).map(|(_, face)| *face).reduce(Area::union)
    });
    let groups = groups.chain(faces.iter().copied()).chain(faces.iter().copied().reduce(Area::union));
    let mut crops = Vec::new();
    for group in groups {
        let centre = (group.x + group.width / 2.0, group.y + group.height / 2.0);
        for room in [1.05, 1.0] {
            let crop = view.about(centre, group.width.max(group.height * view.aspect) * room, 0.5);
            crops.push(settled(view, &crop, faces).unwrap_or(crop));
        }
    }
    crops
}

/// The crop moved as little as possible so that it cuts no face; `None` when it cuts none, or in any case.
fn settled(view: &View, crop: &Crop, faces: &[Area]) -> Option<Crop> {
    let area = view.area(crop);
    let cuts = |area: Area| faces.iter().any(|face| view.cuts(area, *face));
    if !cuts(area) {
        return None;
    }
    let mut best: Option<(f64, Area)> = None;
    let across = stops(area.x, area.width, view.width, faces.iter().map(|f| (f.x, f.width)));
    for y in stops(area.y, area.height, view.height, faces.iter().map(|f| (f.y, f.height))) {
        for &x in &across {
            let way = (x - area.x).hypot(y - area.y);
            // The following ones are farther away.
            if best.is_some_and(|(least, _)| way >= least) {
                break;
            }
            let moved = Area { x, y, ..area };
            if !cuts(moved) {
                best = Some((way, moved));
            }
        }
    }
    best.map(|(_, moved)| view.crop(moved.x, moved.y, moved.width))
}

/// Returns positions of one side of a crop at which a face just becomes complete or just disappears, the
/// nearest first.
fn stops(at: f64, length: f64, limit: f64, faces: impl Iterator<Item = (f64, f64)>) -> Vec<f64> {
    let room = (limit - length).max(0.0);
    let mut places: Vec<f64> = faces
        .flat_map(move |(low, side)| {
            let air = side * 0.15;
            [low, low - air, low + side - length, low + side + air - length, low - length, low + side]
        })
        .chain([at])
        .map(move |place| place.clamp(0.0, room))
        .collect();
    sort_by(&mut places, |a, b| (a - at).abs().total_cmp(&(b - at).abs()));
    places.dedup();
    places
}
