//! Pixels of gray and colour images.

use crate::raster::Image;

/// The channels of a pixel; a grey one thrice.
pub(super) fn rgb(image: &Image, x: usize, y: usize) -> [u8; 3] {
    match image.planes() {
        [r, g, b] => [r.at(x, y), g.at(x, y), b.at(x, y)],
        planes => [planes.first().map_or(0, |plane| plane.at(x, y)); 3],
    }
}

/// The luma of a pixel, 0 to 255.
pub(super) fn luma(rgb: [u8; 3]) -> u32 {
    let [r, g, b] = rgb.map(u32::from);
    (r * 77 + g * 150 + b * 29) >> 8
}
