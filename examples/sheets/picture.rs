//! A picture on a sheet.

use inkpanel_engine::raster::Image;
use tiny_skia::{Pixmap, PremultipliedColorU8};

/// Draws a picture on the sheet, clipped at its edges.
pub(crate) fn paste(sheet: &mut Pixmap, image: &Image, left: u32, top: u32) {
    let across = sheet.width();
    for (i, pixel) in image.to_rgba().chunks_exact(4).enumerate() {
        let (x, y) = (left + (i % image.width()) as u32, top + (i / image.width()) as u32);
        let color = PremultipliedColorU8::from_rgba(pixel[0], pixel[1], pixel[2], 255);
        if let (Some(color), Some(target)) = (color, sheet.pixels_mut().get_mut((y * across + x) as usize)) {
            *target = color;
        }
    }
}
