//! Patches: panels as straight-alpha pixels, and the drawing that they are cut out of.

use super::rect::PixelRect;
use crate::raster::resize::Region;
use crate::raster::{Image, Plane};

/// A rectangle of straight-alpha RGBA pixels at a place of the page.
#[derive(Clone)]
pub struct Patch {
    /// Pixels of the page that it covers.
    pub area: PixelRect,
    /// `4 * width * height` bytes.
    pub rgba: Vec<u8>,
}

impl Patch {
    /// A single transparent pixel.
    pub(super) fn nothing(at: PixelRect) -> Self {
        Self { area: PixelRect { width: 1, height: 1, ..at }, rgba: vec![0; 4] }
    }

    /// Reduces the opacity where another patch covers it. `rgba` are the pixels of `area` on the same page.
    /// The result equals a drawing with the other patch on top, if the page below shows the same pixels.
    pub fn stand_behind(&mut self, area: PixelRect, rgba: &[u8]) {
        let own = self.area;
        let end = |start: i64, length: usize| start + length as i64;
        let (left, top) = (own.x.max(area.x), own.y.max(area.y));
        let right = end(own.x, own.width).min(end(area.x, area.width));
        let bottom = end(own.y, own.height).min(end(area.y, area.height));
        for y in top..bottom {
            for x in left..right {
                let at =
                    |rect: PixelRect| ((y - rect.y) as usize * rect.width + (x - rect.x) as usize) * 4 + 3;
                let covered = rgba.get(at(area)).map_or(0, |alpha| u32::from(*alpha));
                let alpha = &mut self.rgba[at(own)];
                *alpha = ((u32::from(*alpha) * (255 - covered) + 127) / 255) as u8;
            }
        }
    }
}

/// Source of the images of a panel: its stylised photo, extended as far as its subject needs.
pub(super) struct Drawing {
    /// The unstyled photo.
    pub(super) shown: Shown,
    /// In the style.
    pub(super) image: Image,
    /// Width and height of the whole photo.
    pub(super) photo: (usize, usize),
}

/// The part of a photo that a panel shows.
pub(super) struct Shown {
    /// At the page's size.
    pub(super) image: Image,
    /// Its subject mask, if it is known and requested.
    pub(super) subject: Option<Plane>,
    /// Its place on the photo,
    pub(super) region: Region,
    /// and on the page.
    pub(super) at: PixelRect,
}

/// Copies the pixels that `area` and the image share.
pub(super) fn fill_image(rgba: &mut [u8], area: PixelRect, image: &Image, at: PixelRect) {
    let left = area.x.max(at.x);
    let right = (area.x + area.width as i64).min(at.x + at.width as i64);
    let top = area.y.max(at.y);
    let bottom = (area.y + area.height as i64).min(at.y + at.height as i64);
    if right <= left {
        return;
    }
    let count = (right - left) as usize;
    let last = image.planes().len() - 1;
    for y in top..bottom {
        let start = (left - at.x) as usize;
        let [r, g, b] =
            [0, 1, 2].map(|i| &image.planes()[i.min(last)].row((y - at.y) as usize)[start..start + count]);
        let offset = ((y - area.y) as usize * area.width + (left - area.x) as usize) * 4;
        let pixels = rgba[offset..offset + count * 4].chunks_exact_mut(4);
        for (pixel, ((&r, &g), &b)) in pixels.zip(r.iter().zip(g).zip(b)) {
            (pixel[0], pixel[1], pixel[2]) = (r, g, b);
        }
    }
}

/// Lays a colour under straight-alpha pixels.
pub(super) fn lay_under(rgba: &mut [u8], coverage: &[u8], color: [u8; 3]) {
    for (pixel, &coverage) in rgba.chunks_exact_mut(4).zip(coverage).filter(|(_, c)| **c > 0) {
        let own = u32::from(pixel[3]) * 255;
        let added = u32::from(coverage) * (255 - u32::from(pixel[3]));
        let alpha = (own + added).max(1);
        for (channel, color) in pixel.iter_mut().zip(color) {
            *channel = ((u32::from(*channel) * own + u32::from(color) * added + alpha / 2) / alpha) as u8;
        }
        pixel[3] = ((alpha + 127) / 255) as u8;
    }
}

/// Lays a colour over straight-alpha pixels.
pub(super) fn lay_over(rgba: &mut [u8], line: &[u8], color: [u8; 3]) {
    for (pixel, &line) in rgba.chunks_exact_mut(4).zip(line).filter(|(_, line)| **line > 0) {
        let (line, below) = (u32::from(line), u32::from(pixel[3]));
        let kept = below * (255 - line);
        let alpha = line * 255 + kept;
        for (channel, color) in pixel.iter_mut().zip(color) {
            let sum = u32::from(color) * line * 255 + u32::from(*channel) * kept;
            *channel = ((sum + alpha / 2) / alpha) as u8;
        }
        pixel[3] = ((alpha + 127) / 255) as u8;
    }
}
