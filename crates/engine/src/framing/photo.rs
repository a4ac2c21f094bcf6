//! Input and output types of framing.

use std::borrow::Cow;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::crop::Crop;
use super::energy::EnergyMap;
use super::facts::Facts;
use crate::raster::Matte;

/// The label of a face among the subjects.
pub const FACE: &str = "face";
/// The label of lettering among the subjects.
pub const LETTERING: &str = "lettering";
/// Label of a subject without a detected object: only its mask is known.
pub const FIGURE: &str = "figure";

/// Facts about a photo, measured once at import. All positions are fractions of the oriented photo.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
#[allow(clippy::struct_excessive_bools, reason = "independent facts")]
pub struct PhotoMeta {
    /// Unique name within the album.
    pub id: String,
    /// Width of the oriented original, in pixels.
    pub width: u32,
    /// Height of the oriented original, in pixels.
    pub height: u32,
    /// The 64-bit fingerprint; 16 hexadecimal digits in JSON.
    #[serde(with = "hexadecimal")]
    #[cfg_attr(test, ts(type = "string"))]
    pub fingerprint: u64,
    /// Sharpness by the default metric; comparable within an album only.
    pub sharpness: f32,
    /// Energy map of the photo.
    #[cfg_attr(test, ts(type = "EnergyMap"))]
    pub energy: EnergyMap,
    /// Capture time, `YYYY:MM:DD HH:MM:SS`, if the file contains it.
    #[serde(default)]
    pub taken: Option<String>,
    /// Lettering, and the faces and objects found in it once detection has run.
    #[serde(default)]
    pub subjects: Vec<Subject>,
    /// The focus point that the user set.
    #[serde(default)]
    pub focus: Option<Focus>,
    /// Tones, texture and colour. `None` if the photo was never measured, as in old projects.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(type = "string", optional))]
    pub facts: Option<Facts>,
    /// Subject mask, after detection.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "mask")]
    #[cfg_attr(test, ts(type = "string", optional))]
    pub mask: Option<Matte>,
    /// Whether the user starred it: it gets a large panel.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub starred: bool,
    /// Whether it is a frame of a video.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub frame: bool,
    /// Whether the photo is missing, and its measurements belong to a placeholder.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub absent: bool,
    /// Whether text items on the page belong to it. They move together. Valid for one plan only.
    #[serde(skip)]
    #[cfg_attr(test, ts(skip))]
    pub spoken: bool,
}

impl PhotoMeta {
    /// A photo with known size in pixels and no other measurements.
    #[must_use]
    pub fn unmeasured(id: &str, width: u32, height: u32) -> Self {
        Self {
            id: id.to_owned(),
            width,
            height,
            fingerprint: 0,
            sharpness: 1.0,
            energy: EnergyMap::flat(),
            taken: None,
            subjects: Vec::new(),
            focus: None,
            facts: None,
            mask: None,
            starred: false,
            frame: false,
            absent: false,
            spoken: false,
        }
    }

    /// Openness of the most shut eyes. `None` if no eyes are known.
    #[must_use]
    pub fn openness(&self) -> Option<f64> {
        let known = self.subjects.iter().filter_map(|subject| subject.expression);
        known.map(|expression| expression.openness()).min_by(f64::total_cmp)
    }

    /// Stores the subjects of the detectors. The lettering from the import stays.
    pub fn find(&mut self, found: impl IntoIterator<Item = Subject>) {
        self.subjects.retain(|subject| subject.label == LETTERING);
        self.subjects.splice(0..0, found);
    }

    /// Subjects for cropping: the detected ones, and the subject of the mask if no person or animal was
    /// detected.
    pub fn marked(&self) -> impl Iterator<Item = Cow<'_, Subject>> {
        self.subjects.iter().map(Cow::Borrowed).chain(self.figure().map(Cow::Owned))
    }

    /// Whether the photo cuts the head of a person. The box starts at the top of the photo and has no face, and the photo has a
    /// face elsewhere.
    #[must_use]
    pub fn is_headless(&self, person: &Subject) -> bool {
        let mut faces = self.subjects.iter().filter(|subject| subject.label == FACE).peekable();
        person.label == "person"
            && person.y <= HEADLESS.0
            && person.height >= HEADLESS.1
            && faces.peek().is_some()
            && !faces.any(|face| person.surrounds(face))
    }

    /// The box of the mask, for a photo without faces, people and animals. `None` if the mask confidence is
    /// too low, or the subject is too large for a crop.
    fn figure(&self) -> Option<Subject> {
        if self.subjects.iter().any(Subject::is_alive) {
            return None;
        }
        let facts = self.mask.as_ref()?.facts();
        let [x, y, width, height] = facts.bounds;
        let label = FIGURE.to_owned();
        let figure = Subject {
            x,
            y,
            width,
            height,
            label,
            score: facts.confidence,
            points: None,
            expression: None,
            light: None,
        };
        (!facts.is_vague() && !figure.is_scenery()).then_some(figure)
    }

    /// The photo without the uniform bars at its edges, in whole pixels.
    #[must_use]
    pub fn picture(&self) -> Crop {
        let bars = self.facts.as_ref().map_or([0; 4], |facts| facts.bars);
        let span = |before: u8, after: u8, side: u32| {
            let side = f64::from(side.max(1));
            let pixels = |bar: u8| (f64::from(bar) / 255.0 * side).ceil();
            let (from, to) = (pixels(before), side - pixels(after));
            if to - from >= 1.0 { (from / side, (to - from) / side) } else { (0.0, 1.0) }
        };
        let ((x, width), (y, height)) =
            (span(bars[0], bars[2], self.width), span(bars[1], bars[3], self.height));
        Crop { x, y, width, height }
    }

    /// The photo cut to [`Self::picture`], and this part. `None` without bars.
    pub(super) fn trimmed(&self) -> Option<(Self, Crop)> {
        let part = self.picture();
        if part.width >= 1.0 && part.height >= 1.0 {
            return None;
        }
        let within = |s: Cow<Subject>| Subject {
            x: (s.x - part.x) / part.width,
            y: (s.y - part.y) / part.height,
            width: s.width / part.width,
            height: s.height / part.height,
            ..s.into_owned()
        };
        let focus = self.focus.map(|focus| Focus {
            x: ((focus.x - part.x) / part.width).clamp(0.0, 1.0),
            y: ((focus.y - part.y) / part.height).clamp(0.0, 1.0),
        });
        let side = |part: f64, side: u32| (part * f64::from(side.max(1))).round().max(1.0) as u32;
        let picture = Self {
            width: side(part.width, self.width),
            height: side(part.height, self.height),
            energy: self.energy.part(&part),
            subjects: self.marked().map(within).collect(),
            focus,
            ..Self::unmeasured(&self.id, 1, 1)
        };
        Some((picture, part))
    }

    /// Width over height; sides of 0 count as 1.
    #[must_use]
    pub fn aspect(&self) -> f64 {
        f64::from(self.width.max(1)) / f64::from(self.height.max(1))
    }
}

/// An invalid mask counts as missing.
fn mask<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Matte>, D::Error> {
    let text = Option::<String>::deserialize(deserializer)?;
    Ok(text.and_then(|text| Matte::try_from(text).ok()))
}

/// Six points of a face, in fractions of the photo from the left and from the top.
///
/// Their order: right eye, left eye, tip of the nose, middle of the mouth, right ear, left ear. The right eye is the
/// person's right eye.
pub type FacePoints = [[f64; 2]; 6];

/// Eyes and mouth of a face, as ratios of distances in the face.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Expression {
    /// Distance of the lids of the person's right eye, in widths of the eye: about 0.2 if shut, and 0.3 if open.
    pub right_eye: f64,
    /// The left eye.
    pub left_eye: f64,
    /// Distance of the lips, in widths of the mouth: 0 if closed. In a video frame with a subtitle, the change of the distance.
    pub mouth: f64,
    /// Height of the corners of the mouth above its middle, in widths of the mouth. It is negative in a sad face.
    pub smile: f64,
}

/// Maximum openness of eyes that are shut for certain. Shut eyes have up to 0.24, and narrow open ones have 0.2.
const SHUT: f64 = 0.2;

/// Openness of eyes that are open for certain.
const OPEN: f64 = 0.3;

/// Maximum absolute value of a ratio.
const MAX_RATIO: f64 = 100.0;

impl Expression {
    /// Whether all ratios are possible.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        let Self { right_eye, left_eye, mouth, smile } = *self;
        [right_eye, left_eye, mouth, smile].iter().all(|ratio| ratio.abs() <= MAX_RATIO)
    }

    /// Openness of the eyes: the mean of both, because the points of a single eye are less certain.
    #[must_use]
    pub fn openness(&self) -> f64 {
        f64::midpoint(self.right_eye, self.left_eye)
    }
}

/// The part of a person, from the top, that contains the head.
pub const PERSON_HEAD: f64 = 0.24;

/// Largest distance of a person without a head from the top of the photo, and the least height of the person.
const HEADLESS: (f64, f64) = (0.05, 0.4);

/// Position of the mouth in a face without points, as a share of the height of its box.
const MOUTH: f64 = 0.78;
/// Distance of the nose from the middle of the ears, in widths of the box: the minimum of a face that looks to the
/// side, and the distance in a profile.
const TURNED: [f64; 2] = [0.1, 0.4];

/// A detected face or object.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Subject {
    /// Left edge, 0..1.
    pub x: f64,
    /// Top edge, 0..1.
    pub y: f64,
    /// Width, 0..1.
    pub width: f64,
    /// Height, 0..1.
    pub height: f64,
    /// [`FACE`] or the name of an object.
    pub label: String,
    /// The detector's confidence, 0..1.
    pub score: f64,
    /// Points of a face. `None` for objects, and for faces of old projects.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(type = "ReadonlyArray<[number, number]>", optional))]
    pub points: Option<FacePoints>,
    /// Eyes and mouth of a face. `None` for objects and small faces, and without the landmark model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub expression: Option<Expression>,
    /// Light of a face, compared with its photo: 0 in the shade of a bright photo, 1 in light. `None` for objects, and for faces
    /// of old projects.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub light: Option<f64>,
}

/// The part of its value that a face in the shade of a bright photo loses.
const UNLIT: f64 = 0.4;
/// Labels of animals.
const ANIMALS: [&str; 10] =
    ["bird", "cat", "dog", "horse", "sheep", "cow", "elephant", "bear", "zebra", "giraffe"];

impl Subject {
    /// Whether the subject is a thing that fills most of the photo, such as a table or a bench. Such things
    /// are scenery, so a crop may cut them.
    #[must_use]
    pub fn is_scenery(&self) -> bool {
        !self.is_alive() && (self.width * self.height > 0.5 || self.width > 0.9 || self.height > 0.9)
    }

    /// Whether the subject is a face, a person or an animal.
    #[must_use]
    pub fn is_alive(&self) -> bool {
        self.label == FACE || self.label == "person" || self.is_animal()
    }

    /// Whether it is an animal.
    #[must_use]
    pub fn is_animal(&self) -> bool {
        ANIMALS.contains(&self.label.as_str())
    }

    /// The middle of the mouth, in fractions of the photo. Without points, an estimate from the box.
    #[must_use]
    pub fn mouth(&self) -> [f64; 2] {
        let estimate = [self.x + self.width / 2.0, self.y + MOUTH * self.height];
        self.points.map_or(estimate, |[_, _, _, mouth, ..]| mouth)
    }

    /// Direction of the gaze, from -1 (left in the photo) to 1 (right). 0 if the face looks at the camera, or without
    /// points.
    #[must_use]
    pub fn gaze(&self) -> f64 {
        let Some([_, _, nose, _, right, left]) = self.points else { return 0.0 };
        let turned = (nose[0] - f64::midpoint(right[0], left[0])) / self.width.max(1e-9);
        let [least, most] = TURNED;
        if turned.abs() < least { 0.0 } else { (turned / most).clamp(-1.0, 1.0) }
    }

    /// Whether it is a face with shut eyes. `false` if the eyes are unknown.
    #[must_use]
    pub fn is_shut(&self) -> bool {
        self.expression.is_some_and(|expression| expression.openness() < SHUT)
    }

    /// How clearly a face is seen, 0 to 1: less with shut eyes, if it looks to the side, and in the shade.
    #[must_use]
    pub fn clearness(&self) -> f64 {
        let eyes = self.expression.map_or(1.0, |expression| (expression.openness() / OPEN).clamp(0.2, 1.0));
        eyes * (1.0 - 0.8 * self.gaze().abs()) * self.lit()
    }

    /// The value of a face by its light: 1 in light, and 0.6 in the shade of a bright photo.
    #[must_use]
    pub fn lit(&self) -> f64 {
        1.0 - UNLIT * (1.0 - self.light.unwrap_or(1.0))
    }

    /// The subjects that styles protect: faces, or animals in photos without faces.
    pub fn protected(subjects: &[Self]) -> impl Iterator<Item = &Self> {
        let faces = subjects.iter().any(|subject| subject.label == FACE);
        subjects.iter().filter(move |subject| if faces { subject.label == FACE } else { subject.is_animal() })
    }

    /// Whether the centre of the other box is inside this box.
    #[must_use]
    pub fn surrounds(&self, other: &Self) -> bool {
        let within = |at: f64, low: f64, side: f64| at >= low && at <= low + side;
        within(other.x + other.width / 2.0, self.x, self.width)
            && within(other.y + other.height / 2.0, self.y, self.height)
    }

    /// The box with its surroundings that detectors do not mark: hair and ears around a face, a small border
    /// around an animal. Inside the photo.
    #[must_use]
    pub fn grown(&self) -> Self {
        let (above, around) = match self.label.as_str() {
            FACE => (0.5, 0.15),
            animal if ANIMALS.contains(&animal) => (0.08, 0.08),
            _ => (0.0, 0.0),
        };
        let below = if self.label == FACE { 0.05 } else { above };
        let (left, top) = (self.x - around * self.width, self.y - above * self.height);
        let (right, bottom) = (self.x + self.width * (1.0 + around), self.y + self.height * (1.0 + below));
        let (x, y) = (left.max(self.x.min(0.0)), top.max(self.y.min(0.0)));
        let (width, height) =
            (right.min((self.x + self.width).max(1.0)) - x, bottom.min((self.y + self.height).max(1.0)) - y);
        Self { x, y, width, height, ..self.clone() }
    }
}

#[cfg(feature = "detect")]
impl From<crate::detect::Detection> for Subject {
    fn from(found: crate::detect::Detection) -> Self {
        let crate::detect::Detection { label, score, x, y, width, height, points, expression, light } = found;
        let expression = expression.map(|found| {
            let crate::detect::Expression { right_eye, left_eye, mouth, smile } = found;
            Expression { right_eye, left_eye, mouth, smile }
        });
        Self { x, y, width, height, label, score, points, expression, light }
    }
}

/// A point of a photo.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Focus {
    /// From the left, 0..1.
    pub x: f64,
    /// From the top, 0..1.
    pub y: f64,
}

impl Crop {
    /// A crop with the same centre and area, limited by the photo, for a panel with this aspect ratio (width
    /// over height). Unchanged if the aspect ratio is equal.
    #[must_use]
    pub fn refitted(&self, photo: &PhotoMeta, aspect: f64) -> Self {
        let sides = (f64::from(photo.width.max(1)), f64::from(photo.height.max(1)));
        let (width, height) = (self.width * sides.0, self.height * sides.1);
        if (width / height / aspect - 1.0).abs() < 1e-6 {
            return *self;
        }
        let wanted = (width * height * aspect).sqrt();
        // A crop without the bars of the photo stays without them.
        let picture = photo.picture();
        let all = Self { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };
        let limits = if picture.holds(self) { picture } else { all };
        let width = wanted.min(limits.width * sides.0).min(limits.height * sides.1 * aspect);
        let (width, height) = ((width / sides.0).min(1.0), (width / aspect / sides.1).min(1.0));
        let place = |middle: f64, length: f64, (from, side): (f64, f64)| {
            (middle - length / 2.0).min(from + side - length).max(from)
        };
        let (x, y) = (self.x + self.width / 2.0, self.y + self.height / 2.0);
        let (x, y) = (place(x, width, (limits.x, limits.width)), place(y, height, (limits.y, limits.height)));
        Self { x, y, width, height }
    }
}

mod hexadecimal {
    use super::{Deserialize, Deserializer, Serializer};
    use serde::de::Error as _;

    #[allow(
        clippy::trivially_copy_pass_by_ref,
        reason = "the signature that serde asks for, on 64-bit machines"
    )]
    pub(super) fn serialize<S: Serializer>(value: &u64, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&format_args!("{value:016x}"))
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<u64, D::Error> {
        let text = String::deserialize(deserializer)?;
        u64::from_str_radix(&text, 16)
            .ok()
            .filter(|_| text.len() == 16)
            .ok_or_else(|| D::Error::custom("a fingerprint must have 16 hexadecimal digits"))
    }
}
