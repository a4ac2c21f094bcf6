//! The subject mask of a photo: a small plane from a model or the user, and its text form in projects.

use std::sync::{Arc, OnceLock};

use serde::{Deserialize, Serialize};

use super::Plane;
use super::resize::{Region, fit, resample};

/// Pixels along the longer side.
pub const LONGEST: usize = 320;
/// Number of stored levels. Masks are refined by the edges of the photo later.
const LEVELS: u8 = 16;
/// From one to the next.
const STEP: u8 = 255 / (LEVELS - 1);
/// Maximum length of the text of a mask, in bytes. Noise, with different values in neighbouring pixels,
/// exceeds it.
pub const MOST_TEXT: usize = 65_536;
/// From here on a pixel counts as the subject.
const WITHIN: u8 = 128;
/// Minimum share of the photo that a subject covers.
const LEAST_COVERAGE: f64 = 0.01;
/// The least sure border of a subject that anything is made by: below it are crowds, landscapes and mist.
pub const LEAST_CONFIDENCE: f64 = 0.35;
/// A share of a border between these is unsure.
const UNSURE: std::ops::Range<u8> = 26..230;

/// The subject mask of a photo: 0 outside, 255 inside, at most 320 pixels per side, for the whole oriented
/// photo.
///
/// Text form: `320x213:a97bcp20...`. Each pixel is a letter, row by row, from `a` (0) to `p` (255). A number
/// after a letter is its repeat count. At most 64 KiB are read.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Matte(Arc<Kept>);

/// The text and cached properties, which drawing and planning use repeatedly.
#[derive(Debug)]
struct Kept {
    text: Box<str>,
    facts: OnceLock<MatteFacts>,
}

impl PartialEq for Matte {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0) || self.text() == other.text()
    }
}

impl Eq for Matte {}

/// Properties of a subject mask. Places and lengths are in fractions of the photo.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MatteFacts {
    /// The share of the photo that it covers.
    pub coverage: f64,
    /// Left, top, width and height of the bounding box; all 0 without a subject.
    pub bounds: [f64; 4],
    /// Confidence of its border, 0 to 1: 1 for the sharpest possible border.
    pub confidence: f64,
}

impl MatteFacts {
    /// Whether the mask is unusable: it covers almost nothing, or its border is uncertain.
    #[must_use]
    pub fn is_vague(&self) -> bool {
        self.coverage < LEAST_COVERAGE || self.confidence < LEAST_CONFIDENCE
    }
}

impl Matte {
    /// Reduces shares of any size, for a photo of a size.
    #[must_use]
    pub fn new(shares: &Plane, (width, height): (usize, usize)) -> Self {
        let (width, height) = fit(width.max(1), height.max(1), LONGEST);
        let mut plane = resample(shares, Region::whole(shares.width(), shares.height()), width, height);
        plane.samples_mut().iter_mut().for_each(|share| *share = level(*share) * STEP);
        Self::of(write(&plane))
    }

    fn of(text: String) -> Self {
        Self(Arc::new(Kept { text: text.into(), facts: OnceLock::new() }))
    }

    /// The shares.
    #[must_use]
    pub fn plane(&self) -> Plane {
        // It was read once.
        read(self.text()).unwrap_or_else(|| Plane::filled(1, 1, 0))
    }

    /// Returns which pixels are at least half subject, row by row, and the number of pixels per row.
    #[must_use]
    pub fn within(&self) -> (Vec<bool>, usize) {
        let plane = self.plane();
        (plane.samples().iter().map(|share| *share >= WITHIN).collect(), plane.width())
    }

    /// As text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.0.text
    }

    /// Properties of the mask.
    #[must_use]
    pub fn facts(&self) -> MatteFacts {
        *self.0.facts.get_or_init(|| facts_of(&self.plane()))
    }
}

fn facts_of(plane: &Plane) -> MatteFacts {
    let (width, height) = (plane.width(), plane.height());
    let (mut left, mut top, mut right, mut bottom) = (width, height, 0, 0);
    let mut sum = 0u64;
    for y in 0..height {
        for (x, &share) in plane.row(y).iter().enumerate() {
            sum += u64::from(share);
            if share >= WITHIN {
                (left, top) = (left.min(x), top.min(y));
                (right, bottom) = (right.max(x + 1), bottom.max(y + 1));
            }
        }
    }
    let coverage = sum as f64 / (255 * width * height) as f64;
    if right <= left {
        return MatteFacts { coverage, bounds: [0.0; 4], confidence: 0.0 };
    }
    let share = |at: usize, of: usize| at as f64 / of as f64;
    MatteFacts {
        coverage,
        bounds: [
            share(left, width),
            share(top, height),
            share(right - left, width),
            share(bottom - top, height),
        ],
        confidence: confidence(plane, |_, _| true),
    }
}

/// Confidence of the border of a plane, 0 to 1, from the pixels that count: 1 for the sharpest possible
/// border.
#[must_use]
pub fn confidence(shares: &Plane, counts: impl Fn(usize, usize) -> bool) -> f64 {
    let (width, height) = (shares.width(), shares.height());
    let (mut rim, mut unsure) = (0u64, 0u64);
    for y in 0..height {
        for (x, share) in shares.row(y).iter().enumerate() {
            let (doubted, within) = (UNSURE.contains(share), *share >= WITHIN);
            if !(doubted || within) || !counts(x, y) {
                continue;
            }
            unsure += u64::from(doubted);
            let beside = |dx: usize, dy: usize| shares.at(dx.min(width - 1), dy.min(height - 1)) < WITHIN;
            let at_rim = within
                && (beside(x + 1, y)
                    || beside(x, y + 1)
                    || beside(x.saturating_sub(1), y)
                    || beside(x, y.saturating_sub(1)));
            rim += u64::from(at_rim);
        }
    }
    // The sharpest possible border has about two uncertain pixels for each border pixel.
    let width_of_doubt = unsure as f64 / rim.max(1) as f64;
    (1.0 - (width_of_doubt - 2.0) / 10.0).clamp(0.0, 1.0)
}

/// The nearest step.
fn level(share: u8) -> u8 {
    ((u16::from(share) * u16::from(LEVELS - 1) + 127) / 255) as u8
}

fn write(plane: &Plane) -> String {
    let mut text = [plane.width(), plane.height()].map(|side| side.to_string()).join("x");
    text.push(':');
    let mut rest = plane.samples();
    while let Some(&first) = rest.first() {
        let count = rest.iter().take_while(|share| **share == first).count();
        text.push(char::from(b'a' + level(first)));
        if count > 1 {
            text.push_str(&count.to_string());
        }
        rest = &rest[count..];
    }
    text
}

impl From<Matte> for String {
    fn from(matte: Matte) -> Self {
        matte.text().to_owned()
    }
}

impl TryFrom<String> for Matte {
    type Error = &'static str;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        let wrong = "is not a valid mask";
        if read(&text).is_some() { Ok(Self::of(text)) } else { Err(wrong) }
    }
}

fn read(text: &str) -> Option<Plane> {
    if text.len() > MOST_TEXT {
        return None;
    }
    let (sides, runs) = text.split_once(':')?;
    let (width, height) = sides.split_once('x')?;
    let side = |text: &str| text.parse().ok().filter(|side| (1..=LONGEST).contains(side));
    let (width, height): (usize, usize) = (side(width)?, side(height)?);
    let mut samples = Vec::with_capacity(width * height);
    let mut rest = runs.as_bytes();
    while let [letter @ b'a'..=b'p', after @ ..] = rest {
        let digits = after.iter().take_while(|digit| digit.is_ascii_digit()).count();
        let mut count = 0;
        for digit in after.get(..digits.min(6))? {
            count = 10 * count + usize::from(digit - b'0');
        }
        let count = if digits == 0 { 1 } else { count };
        if digits > 6 || count == 0 || count > width * height - samples.len() {
            return None;
        }
        samples.resize(samples.len() + count, (letter - b'a') * STEP);
        rest = &after[digits..];
    }
    if !rest.is_empty() {
        return None;
    }
    Plane::from_samples(width, height, samples).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn disc(width: usize, height: usize) -> Matte {
        let shares = Plane::from_fn(width, height, |x, y| {
            let far = (x as f64 - width as f64 * 0.5).hypot(y as f64 - height as f64 * 0.4);
            ((height as f64 * 0.25 - far + 0.5).clamp(0.0, 1.0) * 255.0) as u8
        });
        Matte::new(&shares, (width, height))
    }

    #[test]
    fn text_and_back_is_the_same() {
        for matte in [disc(320, 213), disc(640, 480), disc(1, 1), disc(1, 900)] {
            let text = String::from(matte.clone());
            assert_eq!(Matte::try_from(text.clone()), Ok(matte), "{text}");
            assert!(text.len() < 4000, "{}", text.len());
        }
    }

    #[test]
    fn broken_text_is_refused() {
        for text in [
            "",
            "2x2",
            "2x2:",
            "2x2:a3",
            "2x2:a5",
            "2x2:a0a4",
            "2x2:q4",
            "0x2:a",
            "321x1:a321",
            "2x2:a4!",
            "2x2:a4a",
            "2x2:a99999999999999999999",
            "-1x2:a2",
            "2x2:4a",
        ] {
            assert!(Matte::try_from(text.to_owned()).is_err(), "{text}");
        }
        assert!(Matte::try_from("2x2:ap2h".to_owned()).is_ok());
    }

    #[test]
    fn a_disc_is_where_it_is() {
        let facts = disc(320, 200).facts();
        let area = std::f64::consts::PI * 50.0 * 50.0 / (320.0 * 200.0);
        assert!((facts.coverage - area).abs() < 0.01, "{facts:?}");
        let expected = [110.0 / 320.0, 30.0 / 200.0, 100.0 / 320.0, 0.5];
        assert!(facts.bounds.iter().zip(expected).all(|(a, b)| (a - b).abs() < 0.02), "{facts:?}");
        assert!(facts.confidence > 0.95, "{facts:?}");
        let blurred = Matte::new(&Plane::from_fn(320, 200, |x, _| (x * 255 / 319) as u8), (320, 200));
        assert!(blurred.facts().confidence < 0.1, "{:?}", blurred.facts());
        assert!(blurred.facts().is_vague() && !facts.is_vague());
        let nothing = Matte::new(&Plane::filled(320, 200, 0), (320, 200)).facts();
        assert!(nothing.is_vague());
        assert_eq!((nothing.coverage, nothing.bounds), (0.0, [0.0; 4]));
    }

    #[test]
    fn a_border_is_as_sure_as_where_it_is_looked_at() {
        // A block that ends within a pixel on the left, and within a third of the plane on the right.
        let shares = Plane::from_fn(300, 60, |x, _| if x < 60 { 0 } else { (3 * (300 - x)).min(255) as u8 });
        assert!(confidence(&shares, |x, _| x < 150) > 0.95);
        assert!(confidence(&shares, |x, _| x >= 150) < 0.05);
        assert!(confidence(&shares, |_, _| false) > 0.95, "what nobody looks at is not in doubt");
    }
}
