//! The image of a panel for a PDF file.

use crate::error::{Error, Result};
use crate::page::document::Document;
use crate::page::jpeg;
use crate::page::plates::Separation;
use crate::page::rect::PixelRect;
use crate::page::scene;
use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::{Filter, Pdf, Ref};

/// An image with its position.
pub struct Picture {
    /// Index of the panel. Indices from the number of panels are breakouts, then foregrounds.
    pub index: usize,
    /// Covered pixels of the page. The panel clips the image to its shape.
    pub area: PixelRect,
    /// The file.
    pub jpeg: Vec<u8>,
    /// Opacity of each pixel of a breakout or foreground: packed bytes, row by row.
    pub alpha: Option<Vec<u8>>,
}

/// Makes the image of a panel from its patch, rendered without border at the page's full width. The patch has
/// colours for its whole rectangle, including areas outside the panel's shape. `plate` selects an ink.
/// Without it the image keeps its colours, and a gray image stays gray.
///
/// # Errors
/// `invalid-document` for a panel that the page does not have; `buffer-size` when the patch does not hold the pixels of
/// its area; `encode`.
pub fn cut(
    document: &Document,
    (index, area, rgba): (usize, PixelRect, &[u8]),
    quality: u8,
    plate: Option<(&Separation, usize)>,
) -> Result<Picture> {
    let expected = area.width.saturating_mul(area.height).saturating_mul(4);
    if rgba.len() != expected {
        let (width, height) = (area.width, area.height);
        return Err(Error::BufferSize { width, height, expected, actual: rgba.len() });
    }
    let size = scene::size(document, document.page.width as usize)?;
    let panels = scene::panels(document, &*document.template()?, size)?;
    if index >= document.first_front() + document.fronts().len() {
        let reason = "there is no such panel".into();
        return Err(Error::InvalidDocument { location: format!("panels[{index}]"), reason });
    }
    let image = match panels.get(index) {
        Some(panel) => PixelRect::around(panel.image_bounds, 0.0),
        None => seen(area, rgba),
    };
    let (left, top) = (area.x.max(image.x), area.y.max(image.y));
    let right = (area.x + area.width as i64).min(image.x + image.width as i64);
    let bottom = (area.y + area.height as i64).min(image.y + image.height as i64);
    let (width, height) = ((right - left).max(1) as usize, (bottom - top).max(1) as usize);
    let row = |y: usize| {
        let from = ((top - area.y) as usize + y) * area.width + (left - area.x) as usize;
        rgba.get(from * 4..(from + width) * 4).unwrap_or(&[])
    };
    let visible = (0..height).map(row).collect::<Vec<_>>().concat();
    let alpha = (index >= panels.len()).then(|| {
        let shares: Vec<u8> = visible.chunks_exact(4).map(|pixel| pixel[3]).collect();
        compress_to_vec_zlib(&shares, 6)
    });
    let colours = || visible.chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2]]);
    let gray = || colours().all(|[r, g, b]| r == g && g == b);
    let samples: Vec<u8> = match plate {
        Some((separation, ink)) => colours().map(|rgb| 255 - separation.cover(rgb, ink)).collect(),
        None if gray() => colours().map(|[gray, ..]| gray).collect(),
        None => visible,
    };
    let jpeg = jpeg::encode_part(width, height, &samples, document.page.dpi, quality)?;
    Ok(Picture { index, area: PixelRect { x: left, y: top, width, height }, jpeg, alpha })
}

/// The visible part of a patch.
fn seen(area: PixelRect, rgba: &[u8]) -> PixelRect {
    let (mut left, mut top, mut right, mut bottom) = (area.width, area.height, 0, 0);
    for (i, _) in rgba.chunks_exact(4).enumerate().filter(|(_, pixel)| pixel[3] > 0) {
        let (x, y) = (i % area.width, i / area.width);
        (left, top) = (left.min(x), top.min(y));
        (right, bottom) = (right.max(x + 1), bottom.max(y + 1));
    }
    let (left, top) = (left.min(right), top.min(bottom));
    PixelRect {
        x: area.x + left as i64,
        y: area.y + top as i64,
        width: (right - left).max(1),
        height: (bottom - top).max(1),
    }
}

impl Picture {
    /// The name on sheets with pages of other numbers.
    pub(super) fn name(&self, leaf: usize) -> String {
        format!("L{leaf}P{}", self.index)
    }

    /// `mask` is what its alpha is called.
    pub(super) fn write(&self, pdf: &mut Pdf, id: Ref, mask: Ref) {
        let (width, height) = (self.area.width as i32, self.area.height as i32);
        if let Some(alpha) = &self.alpha {
            let mut image = pdf.image_xobject(mask, alpha);
            image.filter(Filter::FlateDecode);
            image.width(width).height(height).bits_per_component(8);
            image.color_space().device_gray();
        }
        let mut image = pdf.image_xobject(id, &self.jpeg);
        image.filter(Filter::DctDecode);
        image.width(width).height(height).bits_per_component(8);
        if self.alpha.is_some() {
            image.s_mask(mask);
        }
        if is_gray(&self.jpeg) {
            image.color_space().device_gray();
        } else {
            image.color_space().device_rgb();
        }
    }
}

/// Returns whether the header of a JPEG file has one channel. Source: ITU-T T.81, section B.2.2.
fn is_gray(jpeg: &[u8]) -> bool {
    let mut at = 2;
    while let Some(&[0xff, marker, high, low]) = jpeg.get(at..at + 4) {
        if matches!(marker, 0xc0..=0xc2) {
            return jpeg.get(at + 9) == Some(&1);
        }
        at += 2 + usize::from(u16::from_be_bytes([high, low]));
    }
    false
}
