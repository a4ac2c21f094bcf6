//! The panels of a page in a PDF file: paper, pictures inside of their shapes, borders. The origin is the upper left
//! corner, the unit a pixel of the page.

use super::{Picture, share, short};
use crate::error::Result;
use crate::layout::Point;
use crate::page::compose::EMPTY;
use crate::page::document::Document;
use crate::page::mask;
use crate::page::scene;
use pdf_writer::{Content, Name};

/// What is thinner is not drawn, as on the page of pixels.
const THINNEST: f64 = 0.05;

pub(super) fn draw(content: &mut Content, document: &Document, pictures: &[Picture]) -> Result<()> {
    let page = &document.page;
    let size = scene::size(document, page.width as usize)?;
    let width = f64::from(page.width);
    let (border, radius) = (page.border * width, page.corner_radius * width);
    color(content, page.paper_rgb());
    content.rect(0.0, 0.0, size.0 as f32, size.1 as f32).fill_nonzero();
    for (i, panel) in scene::panels(document, &*document.template()?, size)?.iter().enumerate() {
        let line = |by: f64| mask::outline(&panel.shape, radius, by);
        if panel.halo >= THINNEST {
            color(content, page.paper_rgb());
            path(content, &line(panel.halo));
            content.fill_nonzero();
        }
        if let Some(picture) = pictures.iter().find(|picture| picture.index == i) {
            content.save_state();
            path(content, &line(0.0));
            content.clip_nonzero().end_path();
            // Pictures stand upright on their lower edge.
            let area = picture.area;
            let (w, h) = (area.width as f32, area.height as f32);
            content.transform([w, 0.0, 0.0, -h, area.x as f32, area.y as f32 + h]);
            content.x_object(Name(picture.name().as_bytes())).restore_state();
        } else {
            color(content, EMPTY);
            path(content, &line(0.0));
            content.fill_nonzero();
        }
        if border >= THINNEST {
            color(content, page.border_rgb());
            path(content, &line(border / 2.0));
            path(content, &line(-border / 2.0));
            content.fill_even_odd();
        }
    }
    Ok(())
}

/// The colour of what is filled next.
pub(super) fn color(content: &mut Content, rgb: [u8; 3]) {
    let [r, g, b] = share(rgb);
    content.set_fill_rgb(r, g, b);
}

/// Adds a closed line to the path.
pub(super) fn path(content: &mut Content, points: &[Point]) {
    for (i, point) in points.iter().enumerate() {
        let (x, y) = (short(point.x), short(point.y));
        if i == 0 {
            content.move_to(x, y);
        } else {
            content.line_to(x, y);
        }
    }
    content.close_path();
}
