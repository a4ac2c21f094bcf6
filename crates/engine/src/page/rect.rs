//! Rectangles of whole pixels of the page.

use crate::layout::Bounds;

/// Whole pixels of the page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PixelRect {
    /// Left edge; negative if a border extends past the page edge.
    pub x: i64,
    /// Top edge.
    pub y: i64,
    /// Width in pixels, at least 1.
    pub width: usize,
    /// Height in pixels, at least 1.
    pub height: usize,
}

impl PixelRect {
    /// Returns the smallest rectangle of whole pixels around bounds in page pixels, with a margin on all
    /// sides.
    #[must_use]
    pub fn around(Bounds { x, y, width, height }: Bounds, room: f64) -> Self {
        // Rounding errors must not add a pixel.
        const SLACK: f64 = 1e-6;
        let (left, top) = ((x - room + SLACK).floor() as i64, (y - room + SLACK).floor() as i64);
        let (right, bottom) =
            ((x + width + room - SLACK).ceil() as i64, (y + height + room - SLACK).ceil() as i64);
        Self {
            x: left,
            y: top,
            width: (right - left).max(1) as usize,
            height: (bottom - top).max(1) as usize,
        }
    }
}
