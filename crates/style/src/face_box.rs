//! Boxes of faces and their pixels.

use crate::raster::Image;

/// Distances from the centre of a face at which its mask starts to fall and reaches 0, in half sides of its
/// box.
pub(super) const MASK: (f64, f64) = (0.9, 1.5);

/// A face in pixels of the image that shows it, parts of it perhaps beyond the border.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FaceBox {
    /// Left edge.
    pub x: f64,
    /// Top edge.
    pub y: f64,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
}

/// Calls `f` with each pixel of a face's ellipse and its share of it, 0 to 1.
pub(super) fn each_pixel(face: &FaceBox, width: usize, height: usize, mut f: impl FnMut(usize, usize, f32)) {
    let (rx, ry) = (face.width / 2.0, face.height / 2.0);
    let (cx, cy) = (face.x + rx, face.y + ry);
    let span = |centre: f64, radius: f64, side: usize| {
        let clamp = |at: f64| at.clamp(0.0, side as f64) as usize;
        clamp((centre - MASK.1 * radius).floor())..clamp((centre + MASK.1 * radius).ceil())
    };
    for y in span(cy, ry, height) {
        for x in span(cx, rx, width) {
            let (dx, dy) = ((x as f64 + 0.5 - cx) / rx, (y as f64 + 0.5 - cy) / ry);
            // Not `hypot`, which wasm computes in software.
            let t = ((MASK.1 - (dx * dx + dy * dy).sqrt()) / (MASK.1 - MASK.0)).clamp(0.0, 1.0);
            if t > 0.0 {
                f(x, y, (t * t * (3.0 - 2.0 * t)) as f32);
            }
        }
    }
}

/// The red, green and blue of a pixel of an image with colours.
pub(super) fn rgb_at(image: &Image, x: usize, y: usize) -> [f32; 3] {
    [0, 1, 2].map(|i| f32::from(image.planes()[i].at(x, y)))
}

/// Luma of a colour.
pub(super) fn luma([r, g, b]: [f32; 3]) -> f32 {
    0.299 * r + 0.587 * g + 0.114 * b
}
