//! Crops of a photo for panels of other aspect ratios, and for its subject.

use super::{Crop, FACE, PhotoMeta};
use inkpanel_model::crop::LEAST_SIDE;

/// Size of the crop around a fitted subject, relative to the subject.
const ROOM: f64 = 1.35;

impl PhotoMeta {
    /// Returns the crop that shows the subject large, for a panel of this aspect ratio: all faces,
    /// or without faces the detection with the highest score. `None` without a subject.
    #[must_use]
    pub fn subject_crop(&self, aspect: f64) -> Option<Crop> {
        let mut shown: Vec<_> = self.subjects.iter().filter(|subject| subject.label == FACE).collect();
        if shown.is_empty() {
            // The first of several with the highest score.
            shown.extend(self.subjects.iter().reduce(|a, b| if b.score > a.score { b } else { a }));
        }
        let first = shown.first()?;
        let bounds = shown.iter().fold(
            (first.x, first.y, first.x + first.width, first.y + first.height),
            |(left, top, right, bottom), one| {
                (
                    left.min(one.x),
                    top.min(one.y),
                    right.max(one.x + one.width),
                    bottom.max(one.y + one.height),
                )
            },
        );
        let (left, top, right, bottom) = bounds;
        let (wide, high) = (f64::from(self.width), f64::from(self.height));
        let needed = ((right - left) * wide * ROOM).max((bottom - top) * high * ROOM * aspect);
        let least = LEAST_SIDE * wide.max(high * aspect);
        let side = needed.max(least).min(wide).min(high * aspect);
        let (width, height) = (side / wide, side / aspect / high);
        Some(
            Crop { x: (left + right - width) / 2.0, y: (top + bottom - height) / 2.0, width, height }
                .inside(),
        )
    }

    /// The crop with the same centre and area, limited by the photo, for a panel with this aspect ratio (width
    /// over height). Unchanged if the aspect ratio is equal.
    #[must_use]
    pub fn refitted(&self, crop: &Crop, aspect: f64) -> Crop {
        let sides = (f64::from(self.width.max(1)), f64::from(self.height.max(1)));
        let (width, height) = (crop.width * sides.0, crop.height * sides.1);
        if (width / height / aspect - 1.0).abs() < 1e-6 {
            return *crop;
        }
        let wanted = (width * height * aspect).sqrt();
        // A crop without the bars of the photo stays without them.
        let picture = self.picture();
        let all = Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };
        let limits = if picture.holds(crop) { picture } else { all };
        let width = wanted.min(limits.width * sides.0).min(limits.height * sides.1 * aspect);
        let (width, height) = ((width / sides.0).min(1.0), (width / aspect / sides.1).min(1.0));
        let place = |middle: f64, length: f64, (from, side): (f64, f64)| {
            (middle - length / 2.0).min(from + side - length).max(from)
        };
        let (x, y) = (crop.x + crop.width / 2.0, crop.y + crop.height / 2.0);
        let (x, y) = (place(x, width, (limits.x, limits.width)), place(y, height, (limits.y, limits.height)));
        Crop { x, y, width, height }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Subject;
    use super::*;

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-9
    }

    #[test]
    fn faces_are_fitted_before_things_with_the_aspect_ratio_of_the_panel() {
        let subject = |label: &str, score, (x, y, width, height)| Subject {
            x,
            y,
            width,
            height,
            label: label.into(),
            score,
            points: None,
            expression: None,
            light: None,
        };
        let face = subject(FACE, 0.6, (0.6, 0.2, 0.1, 0.2));
        let dog = subject("dog", 0.9, (0.1, 0.5, 0.3, 0.3));
        let photo = |subjects| PhotoMeta { subjects, ..PhotoMeta::unmeasured("a", 3000, 2000) };
        let crop = photo(vec![dog.clone(), face]).subject_crop(0.8).unwrap();
        assert!(close(crop.width * 3000.0 / (crop.height * 2000.0), 0.8));
        assert!(crop.x <= 0.6 && crop.x + crop.width >= 0.7 && crop.width < 0.4);
        let thing = photo(vec![dog]).subject_crop(0.8).unwrap();
        assert!(thing.x <= 0.1 && thing.x + thing.width >= 0.4);
        assert_eq!(photo(Vec::new()).subject_crop(1.0), None);
    }
}
