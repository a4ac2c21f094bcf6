//! Outlines of glyphs.

use crate::layout::Point;

/// A closed contour: its start, and segments with a control point if they are curves.
#[derive(Clone)]
pub(super) struct Contour {
    pub(super) start: Point,
    pub(super) segments: Vec<(Option<Point>, Point)>,
}

impl Contour {
    /// The contour with its curves as segments, which are off by at most `within`.
    pub(super) fn flattened(&self, within: f64) -> Vec<Point> {
        let mut points = vec![self.start];
        let mut from = self.start;
        for &(control, end) in &self.segments {
            let Some(control) = control else {
                points.push(end);
                from = end;
                continue;
            };
            // A quadratic curve is off its chords by an eighth of its second difference over their number squared.
            let bend = (from.x - 2.0 * control.x + end.x).hypot(from.y - 2.0 * control.y + end.y);
            let steps = (bend / (4.0 * within)).sqrt().ceil().clamp(1.0, 32.0);
            for i in 1..=steps as usize {
                let t = i as f64 / steps;
                let (a, b, c) = ((1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t);
                points.push(Point::new(
                    a * from.x + b * control.x + c * end.x,
                    a * from.y + b * control.y + c * end.y,
                ));
            }
            from = end;
        }
        points
    }
}
