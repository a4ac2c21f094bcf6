//! Manual crops: the photo of a panel is moved, zoomed and fitted. A crop never leaves the photo.

use super::{Crop, FACE, PhotoMeta};

/// Minimum part of a photo's side that a crop shows.
const LEAST: f64 = 0.06;
/// Size of the crop around a fitted subject, relative to the subject.
const ROOM: f64 = 1.35;

impl Crop {
    /// Moves the photo by `(x, y)`, in widths and heights of the panel.
    #[must_use]
    pub fn panned(self, (x, y): (f64, f64)) -> Self {
        Self { x: self.x - x * self.width, y: self.y - y * self.height, ..self }.inside()
    }

    /// Zooms by `factor`; values above 1 zoom in. `(u, v)` is the fixed point, in fractions of the panel.
    #[must_use]
    pub fn zoomed(self, factor: f64, (u, v): (f64, f64)) -> Self {
        let longest = self.width.max(self.height);
        let closest = (LEAST / longest).min(1.0);
        let scale = (1.0 / factor).max(closest).min(1.0 / longest);
        let (width, height) = (self.width * scale, self.height * scale);
        let (x, y) = (self.x + u * (self.width - width), self.y + v * (self.height - height));
        Self { x, y, width, height }.inside()
    }

    /// Returns the crop that shows the subject of a photo large, for a panel of this aspect ratio: all faces,
    /// or without faces the detection with the highest score. `None` without a subject.
    #[must_use]
    pub fn fitted(photo: &PhotoMeta, aspect: f64) -> Option<Self> {
        let mut shown: Vec<_> = photo.subjects.iter().filter(|subject| subject.label == FACE).collect();
        if shown.is_empty() {
            // The first of several with the highest score.
            shown.extend(photo.subjects.iter().reduce(|a, b| if b.score > a.score { b } else { a }));
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
        let (wide, high) = (f64::from(photo.width), f64::from(photo.height));
        let needed = ((right - left) * wide * ROOM).max((bottom - top) * high * ROOM * aspect);
        let least = LEAST * wide.max(high * aspect);
        let side = needed.max(least).min(wide).min(high * aspect);
        let (width, height) = (side / wide, side / aspect / high);
        Some(
            Self { x: (left + right - width) / 2.0, y: (top + bottom - height) / 2.0, width, height }
                .inside(),
        )
    }

    /// The crop moved inside the photo.
    fn inside(self) -> Self {
        let (width, height) = (self.width.min(1.0), self.height.min(1.0));
        let place = |at: f64, side: f64| at.max(0.0).min(1.0 - side);
        Self { x: place(self.x, width), y: place(self.y, height), width, height }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Subject;
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_moved_crop_stays_inside_the_photo_and_keeps_its_shape(
            (width, height, u, v) in (0.06..1.0, 0.06..1.0, 0.0..1.0, 0.0..1.0),
            (x, y, factor) in (-3.0..3.0, -3.0..3.0, 0.01..50.0),
        ) {
            let crop = Crop { x: u * (1.0 - width), y: v * (1.0 - height), width, height };
            let near = crop.panned((x, y)).zoomed(factor, (0.5, 0.5));
            prop_assert!(near.x >= 0.0 && near.y >= 0.0 && near.width > 0.0 && near.height > 0.0);
            prop_assert!(near.x + near.width <= 1.0 + 1e-9 && near.y + near.height <= 1.0 + 1e-9);
            prop_assert!((near.width / near.height - width / height).abs() < 1e-6 * width / height);
        }
    }

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-9
    }

    #[test]
    fn the_photo_follows_the_pointer_and_a_zoom_keeps_its_fixed_point() {
        let crop = Crop { x: 0.3, y: 0.3, width: 0.4, height: 0.2 };
        let moved = crop.panned((0.5, -0.5));
        assert!(close(moved.x, 0.1) && close(moved.y, 0.4) && close(moved.width, 0.4));
        let near = crop.zoomed(2.0, (0.25, 0.75));
        assert!(close(near.width, 0.2));
        assert!(close(near.x + 0.25 * near.width, crop.x + 0.25 * crop.width));
        assert!(close(near.y + 0.75 * near.height, crop.y + 0.75 * crop.height));
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
        let crop = Crop::fitted(&photo(vec![dog.clone(), face]), 0.8).unwrap();
        assert!(close(crop.width * 3000.0 / (crop.height * 2000.0), 0.8));
        assert!(crop.x <= 0.6 && crop.x + crop.width >= 0.7 && crop.width < 0.4);
        let thing = Crop::fitted(&photo(vec![dog]), 0.8).unwrap();
        assert!(thing.x <= 0.1 && thing.x + thing.width >= 0.4);
        assert_eq!(Crop::fitted(&photo(Vec::new()), 1.0), None);
    }
}
