//! Input and output types of framing.

use std::borrow::Cow;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

#[cfg(feature = "detect")]
use super::Expression;
use super::energy::EnergyMap;
use super::facts::Facts;
use super::{Crop, FACE, FIGURE, LETTERING, Subject};
use crate::raster::Matte;

/// Largest distance of a person without a head from the top of the photo, and the least height of the person.
const HEADLESS: (f64, f64) = (0.05, 0.4);

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

/// A detection as the subject of a photo.
#[cfg(feature = "detect")]
#[must_use]
pub fn subject_of(found: crate::detect::Detection) -> Subject {
    let crate::detect::Detection { label, score, x, y, width, height, points, expression, light } = found;
    let expression = expression.map(|found| {
        let crate::detect::Expression { right_eye, left_eye, mouth, smile } = found;
        Expression { right_eye, left_eye, mouth, smile }
    });
    Subject { x, y, width, height, label, score, points, expression, light }
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
