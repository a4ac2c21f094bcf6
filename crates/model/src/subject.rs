//! Detected faces and objects of a photo.

use serde::{Deserialize, Serialize};

/// The label of a face among the subjects.
pub const FACE: &str = "face";
/// The label of lettering among the subjects.
pub const LETTERING: &str = "lettering";
/// Label of a subject without a detected object: only its mask is known.
pub const FIGURE: &str = "figure";

/// Six points of a face, in fractions of the photo from the left and from the top.
///
/// Their order: right eye, left eye, tip of the nose, middle of the mouth, right ear, left ear. The right eye is the
/// person's right eye.
pub type FacePoints = [[f64; 2]; 6];

/// Eyes and mouth of a face, as ratios of distances in the face.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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

/// Position of the mouth in a face without points, as a share of the height of its box.
const MOUTH: f64 = 0.78;
/// Distance of the nose from the middle of the ears, in widths of the box: the minimum of a face that looks to the
/// side, and the distance in a profile.
const TURNED: [f64; 2] = [0.1, 0.4];

/// A detected face or object.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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
    #[cfg_attr(feature = "typescript", ts(type = "ReadonlyArray<[number, number]>", optional))]
    pub points: Option<FacePoints>,
    /// Eyes and mouth of a face. `None` for objects and small faces, and without the landmark model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
    pub expression: Option<Expression>,
    /// Light of a face, compared with its photo: 0 in the shade of a bright photo, 1 in light. `None` for objects, and for faces
    /// of old projects.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "typescript", ts(optional))]
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
