//! Shared code of single-shot detectors: anchors (a fixed grid of boxes), decoding of the model's offsets and
//! classes, and non-maximum suppression.

use super::FacePoints;

/// An anchor box of the grid, in sides of the model's square input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Anchor {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) width: f64,
    pub(super) height: f64,
}

/// A box with its score: left, top, right, bottom.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Candidate {
    pub(super) corners: [f64; 4],
    pub(super) score: f64,
    pub(super) points: Option<FacePoints>,
}

impl Candidate {
    /// The area that two boxes share over the area that either covers.
    fn overlap(&self, other: &Self) -> f64 {
        let shared = self.shared(other);
        let either = area(self.corners) + area(other.corners) - shared;
        if either > 0.0 { shared / either } else { 0.0 }
    }

    /// The area that two boxes share over the area of the smaller one.
    fn containment(&self, other: &Self) -> f64 {
        let smaller = area(self.corners).min(area(other.corners));
        if smaller > 0.0 { self.shared(other) / smaller } else { 0.0 }
    }

    fn shared(&self, other: &Self) -> f64 {
        let (a, b) = (self.corners, other.corners);
        let length = |axis: usize| (a[axis + 2].min(b[axis + 2]) - a[axis].max(b[axis])).max(0.0);
        length(0) * length(1)
    }
}

fn area([left, top, right, bottom]: [f64; 4]) -> f64 {
    (right - left).max(0.0) * (bottom - top).max(0.0)
}

/// Left, top, right and bottom of a box that is given by its centre.
pub(super) fn corners(x: f64, y: f64, width: f64, height: f64) -> [f64; 4] {
    [x - width / 2.0, y - height / 2.0, x + width / 2.0, y + height / 2.0]
}

/// The anchors of SSD-MobileNet on a square of 300 pixels: six grids, with three boxes per cell on the finest
/// and six on the others. There are 1917, in the order of the model's outputs (Liu et al., "Single Shot
/// `MultiBox` Detector", with the scales of TensorFlow's object detection).
pub(super) fn mobilenet_anchors() -> Vec<Anchor> {
    const GRIDS: [usize; 6] = [19, 10, 5, 3, 2, 1];
    let scale = |grid: usize| 0.2 + 0.75 * grid as f64 / 5.0;
    let mut anchors = Vec::new();
    for (level, &cells) in GRIDS.iter().enumerate() {
        let shapes: Vec<(f64, f64)> = if level == 0 {
            vec![(0.1, 1.0), (0.2, 2.0), (0.2, 0.5)]
        } else {
            let size = scale(level);
            let next = if level + 1 < GRIDS.len() { scale(level + 1) } else { 1.0 };
            let ratios = [1.0, 2.0, 0.5, 3.0, 1.0 / 3.0];
            ratios.into_iter().map(|ratio| (size, ratio)).chain([((size * next).sqrt(), 1.0)]).collect()
        };
        for row in 0..cells {
            for column in 0..cells {
                let centre = |cell: usize| (cell as f64 + 0.5) / cells as f64;
                anchors.extend(shapes.iter().map(|&(size, ratio)| Anchor {
                    x: centre(column),
                    y: centre(row),
                    width: size * ratio.sqrt(),
                    height: size / ratio.sqrt(),
                }));
            }
        }
    }
    anchors
}

/// Decodes a box from an anchor and four outputs of the model: shift down and across in tenths of the anchor,
/// logarithms of height and width in fifths.
pub(super) fn decode(anchor: &Anchor, [down, across, height, width]: [f32; 4]) -> [f64; 4] {
    let shift = |by: f32, length: f64| f64::from(by) / 10.0 * length;
    let grown = |by: f32, length: f64| (f64::from(by) / 5.0).exp() * length;
    corners(
        anchor.x + shift(across, anchor.width),
        anchor.y + shift(down, anchor.height),
        grown(width, anchor.width),
        grown(height, anchor.height),
    )
}

/// A logit as a probability.
pub(super) fn sigmoid(logit: f32) -> f64 {
    1.0 / (1.0 + (-f64::from(logit)).exp())
}

/// Keeps the surest of boxes that overlap by more than `limit` (intersection over union), the surest first.
pub(super) fn suppress(candidates: Vec<Candidate>, limit: f64) -> Vec<Candidate> {
    suppress_by(candidates, |a, b| a.overlap(b) > limit)
}

/// Like [`suppress`], and also removes a box that lies mostly inside a more certain one. It merges boxes of
/// several crops of a photo. A crop may show only a part of an object.
pub(super) fn suppress_parts(candidates: Vec<Candidate>, limit: f64) -> Vec<Candidate> {
    suppress_by(candidates, |a, b| a.overlap(b) > limit || a.containment(b) > 0.6)
}

fn suppress_by(
    mut candidates: Vec<Candidate>,
    same: impl Fn(&Candidate, &Candidate) -> bool,
) -> Vec<Candidate> {
    candidates.sort_by(|a, b| b.score.total_cmp(&a.score));
    let mut kept: Vec<Candidate> = Vec::new();
    for candidate in candidates {
        if !kept.iter().any(|other| same(other, &candidate)) {
            kept.push(candidate);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    fn candidate(corners: [f64; 4], score: f64) -> Candidate {
        Candidate { corners, score, points: None }
    }

    #[test]
    fn there_are_as_many_anchors_as_the_net_has_answers() {
        let anchors = mobilenet_anchors();
        assert_eq!(anchors.len(), 1917);
        assert_eq!(anchors[0], Anchor { x: 0.5 / 19.0, y: 0.5 / 19.0, width: 0.1, height: 0.1 });
        let last = anchors[1916];
        assert!((last.width - 0.95f64.sqrt()).abs() < 1e-12 && (last.x - 0.5).abs() < 1e-12);
        // The second grid begins after 19 * 19 * 3 boxes, with scale .35.
        assert!((anchors[1083].width - 0.35).abs() < 1e-12 && (anchors[1083].x - 0.05).abs() < 1e-12);
    }

    #[test]
    fn a_box_is_moved_and_grown_by_its_numbers() {
        let anchor = Anchor { x: 0.5, y: 0.5, width: 0.2, height: 0.4 };
        let [left, top, right, bottom] = decode(&anchor, [1.0, -5.0, 0.0, 5.0 * 2f32.ln()]);
        let expected = [0.4 - 0.2, 0.54 - 0.2, 0.4 + 0.2, 0.54 + 0.2];
        for (found, wanted) in [left, top, right, bottom].iter().zip(expected) {
            assert!((found - wanted).abs() < 1e-6, "{found} {wanted}");
        }
    }

    #[test]
    fn of_boxes_that_overlap_the_surest_stays() {
        let boxes = vec![
            candidate([0.0, 0.0, 1.0, 1.0], 0.6),
            candidate([0.1, 0.0, 1.1, 1.0], 0.9),
            candidate([0.8, 0.0, 1.8, 1.0], 0.5),
        ];
        let kept = suppress(boxes, 0.5);
        assert_eq!(kept.iter().map(|c| c.score).collect::<Vec<_>>(), [0.9, 0.5]);
    }

    #[test]
    fn a_part_of_a_surer_box_goes() {
        let boxes = vec![candidate([0.0, 0.0, 1.0, 1.0], 0.9), candidate([0.1, 0.1, 0.3, 0.4], 0.8)];
        assert_eq!(suppress(boxes.clone(), 0.3).len(), 2);
        assert_eq!(suppress_parts(boxes, 0.3).len(), 1);
    }
}
