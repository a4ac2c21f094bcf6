//! The panels of a page in a PDF file: paper, images clipped to their shapes, borders. The origin is the
//! upper left corner, the unit a pixel of the page.

use super::color::Colours;
use super::tags::{Tags, artifact, end};
use super::{Leaf, Picture, short};
use crate::error::Result;
use crate::layout::Point;
use crate::page::compose::EMPTY;
use crate::page::mask;
use crate::page::scene::{self, ScenePanel};
use pdf_writer::{Content, Name, Ref};

/// Minimum width of a drawn border, like on the page of pixels.
const THINNEST: f64 = 0.05;

/// A page in its place.
pub(super) struct Ground<'a> {
    pub(super) leaf: &'a Leaf,
    /// Its number, from 0.
    pub(super) number: usize,
    /// Pixels that are drawn beyond each of its sides: left, top, right, bottom.
    pub(super) room: [f64; 4],
    pub(super) colours: &'a Colours,
}

pub(super) fn draw(
    content: &mut Content,
    ground: &Ground,
    tags: &mut Tags,
    next: &mut impl FnMut() -> Ref,
) -> Result<()> {
    let Leaf { document, pictures, alts } = ground.leaf;
    let page = &document.page;
    let size = scene::size(document, page.width as usize)?;
    let [left, top, right, bottom] = ground.room;
    let (x, y) = (short(-left), short(-top));
    let (width, height) = (short(size.0 as f64 + left + right), short(size.1 as f64 + top + bottom));
    if page.bleed > 0.0 {
        content.rect(x, y, width, height).clip_nonzero().end_path();
    }
    artifact(content);
    ground.colours.fill(content, page.paper_rgb());
    content.rect(x, y, width, height).fill_nonzero();
    end(content);
    for (i, panel) in scene::panels(document, &*document.template()?, size)?.iter().enumerate() {
        if pictures.iter().any(|picture| picture.index == i) {
            let alt = alts.get(i).filter(|alt| !alt.is_empty()).cloned();
            let alt = alt.unwrap_or_else(|| format!("Panel {}", i + 1));
            // A logo is read with the head of the page.
            let rank = if panel.plain { -1 } else { i as i64 };
            tags.figure(content, (ground.number, rank), &alt, next());
        } else {
            artifact(content);
        }
        draw_panel(content, ground, i, panel);
        end(content);
    }
    // Breakouts are above all panels. Their alternative text is on their panel.
    let figures = document.panels.len()..document.first_front();
    for picture in pictures.iter().filter(|picture| figures.contains(&picture.index)) {
        draw_alone(content, ground, picture);
    }
    Ok(())
}

/// Draws the subject of a panel in front of the effects behind it, if it exists. `front` is its index among
/// the foregrounds.
pub(super) fn draw_front(content: &mut Content, ground: &Ground, front: usize) {
    let index = ground.leaf.document.first_front() + front;
    if let Some(picture) = ground.leaf.pictures.iter().find(|picture| picture.index == index) {
        draw_alone(content, ground, picture);
    }
}

/// An image with a separate mask.
fn draw_alone(content: &mut Content, ground: &Ground, picture: &Picture) {
    artifact(content);
    content.save_state();
    place(content, ground, picture);
    content.restore_state();
    end(content);
}

fn draw_panel(content: &mut Content, ground: &Ground, index: usize, panel: &ScenePanel) {
    let page = &ground.leaf.document.page;
    let width = f64::from(page.width);
    let (border, radius) = (page.border * width, page.corner_radius * width);
    let line = |by: f64| mask::outline(&panel.shape, radius, by);
    if panel.halo >= THINNEST {
        ground.colours.fill(content, page.paper_rgb());
        path(content, &line(panel.halo));
        content.fill_nonzero();
    }
    if let Some(picture) = ground.leaf.pictures.iter().find(|picture| picture.index == index) {
        content.save_state();
        path(content, &line(0.0));
        content.clip_nonzero().end_path();
        place(content, ground, picture);
        content.restore_state();
    } else {
        ground.colours.fill(content, EMPTY);
        path(content, &line(0.0));
        content.fill_nonzero();
    }
    if border >= THINNEST && !panel.plain {
        ground.colours.fill(content, page.border_rgb());
        path(content, &line(border / 2.0));
        path(content, &line(-border / 2.0));
        content.fill_even_odd();
    }
}

/// Shows a picture in its place.
fn place(content: &mut Content, ground: &Ground, picture: &Picture) {
    // Pictures stand upright on their lower edge.
    let area = picture.area;
    let (w, h) = (area.width as f32, area.height as f32);
    content.transform([w, 0.0, 0.0, -h, area.x as f32, area.y as f32 + h]);
    content.x_object(Name(picture.name(ground.number).as_bytes()));
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
