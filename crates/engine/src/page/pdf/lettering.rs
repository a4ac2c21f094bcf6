//! Lettering in a PDF file: balloons as vectors, text as text for search and copy. Arched text has bent
//! glyphs, which PDF text cannot have. They are drawn as vectors, with invisible straight text above.

use super::color::Colours;
use super::drawing::{Ground, path};
use super::fonts::{Face, Fonts};
use super::short;
use super::tags::{Tags, artifact, end};
use crate::error::Result;
use crate::layout::{Bounds, Point};
use crate::page::document::Document;
use crate::page::words::Letters;
use crate::page::words::draw::{Bend, LEAN, Lines, Row, lines, rows};
use crate::page::words::layout::{self, Laid};
use crate::page::words::model::Kind;
use crate::page::words::wording::read;
use pdf_writer::types::{LineCapStyle, LineJoinStyle, TextRenderingMode};
use pdf_writer::{Content, Name, Ref, Str, TextStr};

/// Weight of a step to the right in reading order, in steps down. If two items are at about the same height, the left one comes first.
const ASIDE: f64 = 0.35;

/// Reading order of text items: the panel before the item, and the rank among the items of that panel. An
/// item on the page belongs to the panel under it, or comes before or after all panels.
///
/// # Errors
/// `unknown-layout`, `invalid-layout`.
pub(super) fn ranks(document: &Document, words: &[Laid]) -> Result<Vec<(i64, f64)>> {
    if words.is_empty() {
        return Ok(Vec::new());
    }
    let panels = layout::Ground::new(document)?.panels;
    let holds = |bounds: &Bounds, at: Point| {
        (bounds.x..=bounds.x + bounds.width).contains(&at.x)
            && (bounds.y..=bounds.y + bounds.height).contains(&at.y)
    };
    let rank = |laid: &Laid| {
        let at = laid.middle;
        let under = || panels.iter().rposition(|panel| holds(&panel.bounds, at));
        let panel = laid.word.panel.filter(|panel| *panel < panels.len()).or_else(under);
        let panel = panel.map_or_else(
            || {
                // A logo is in the list of text items of a header.
                let mut shown = panels.iter().zip(&document.panels).filter(|(_, content)| !content.plain);
                let above = shown.all(|(panel, _)| at.y < panel.bounds.y + panel.bounds.height / 2.0);
                if above { -1 } else { panels.len() as i64 }
            },
            |panel| panel as i64,
        );
        (panel, at.y + ASIDE * at.x)
    };
    Ok(words.iter().map(rank).collect())
}

/// The text items of a page.
pub(super) struct Lettering<'a> {
    pub(super) ground: &'a Ground<'a>,
    pub(super) letters: &'a Letters,
    pub(super) fonts: &'a Fonts<'a>,
    /// When they are read, see [`ranks`].
    pub(super) ranks: Vec<(i64, f64)>,
}

impl Lettering<'_> {
    /// Draws a text item.
    pub(super) fn draw(
        &self,
        content: &mut Content,
        laid: &Laid,
        rank: (i64, f64),
        (tags, id): (&mut Tags, Ref),
    ) {
        let width = f64::from(self.ground.leaf.document.page.width);
        let colours = self.ground.colours;
        let Lines { body, united, text, heavy, ringed, half, dash } = lines(laid, width, self.letters);
        content.save_state();
        artifact(content);
        content.set_line_join(LineJoinStyle::RoundJoin).set_line_cap(LineCapStyle::RoundCap);
        content.set_line_width(short(if united { 4.0 } else { 2.0 } * half));
        if ringed {
            if half > 0.0 {
                stroke(content, &text, (colours, laid.fill));
            }
        } else if united {
            if let Some((on, off)) = dash {
                content.set_dash_pattern([short(on), short(off)], 0.0);
            }
            stroke(content, &body, (colours, laid.color));
            fill(content, &body, (colours, laid.fill));
        } else {
            fill(content, &body, (colours, laid.fill));
            if let Some((on, off)) = dash {
                content.set_dash_pattern([short(on), short(off)], 0.0);
            }
            stroke(content, &body, (colours, laid.color));
        }
        end(content);
        tags.paragraph(content, (self.ground.number, rank), &read(&laid.word), id);
        let bend = Bend::new(laid, width);
        if !heavy.0.is_empty() {
            content.set_dash_pattern([], 0.0).set_line_width(short(2.0 * heavy.1));
            stroke(content, &heavy.0, (colours, laid.color));
        }
        if bend.is_arc() {
            fill(content, &text, (colours, laid.color));
        }
        colours.fill(content, laid.color);
        self.text(content, laid, width, &bend);
        end(content);
        content.restore_state();
    }

    /// Draws the characters as text.
    fn text(&self, content: &mut Content, laid: &Laid, width: f64, bend: &Bend) {
        let size = laid.setting.size * width;
        content.begin_text();
        if bend.is_arc() {
            content.set_text_rendering_mode(TextRenderingMode::Invisible);
        }
        for row in rows(laid, width, self.letters) {
            let Some(face) = self.fonts.face(row.font.id()) else { continue };
            content.set_font(Name(face.name().as_bytes()), 1.0);
            // Search functions split text on arched lines, so its text is stored separately. They do not turn that text
            // around, so text from right to left is not.
            let leftward = row.letters.iter().any(|&(letter, _)| self.letters.is_leftward(letter));
            let level = laid.word.kind() != Kind::Effect || leftward;
            if !level {
                let says: String =
                    row.letters.iter().map(|&(letter, _)| self.letters.text_of(letter)).collect();
                let mut mark = content.begin_marked_content_with_properties(Name(b"Span"));
                mark.properties().actual_text(TextStr(&says));
            }
            show(content, &row, face, &bend.straightened(), size * row.scale);
            if !level {
                content.end_marked_content();
            }
        }
        content.end_text();
    }
}

fn fill(content: &mut Content, shapes: &[Vec<Point>], (colours, with): (&Colours, [u8; 3])) {
    if shapes.is_empty() {
        return;
    }
    colours.fill(content, with);
    for points in shapes {
        path(content, points);
    }
    content.fill_nonzero();
}

fn stroke(content: &mut Content, shapes: &[Vec<Point>], (colours, with): (&Colours, [u8; 3])) {
    if shapes.is_empty() {
        return;
    }
    colours.stroke(content, with);
    for points in shapes {
        path(content, points);
    }
    content.stroke();
}

/// Draws a line of text with the glyph distances of the page.
fn show(content: &mut Content, row: &Row, face: &Face, bend: &Bend, size: f64) {
    let Some(&(_, start)) = row.letters.first() else { return };
    stand(content, bend, (row, start), size);
    let mut showing = content.show_positioned();
    let mut items = showing.items();
    for (at, &(letter, pen)) in row.letters.iter().enumerate() {
        items.show(Str(&face.code(letter)));
        if let Some(&(_, next)) = row.letters.get(at + 1) {
            // Difference between the pen position and the glyph advance.
            let off = (row.font.step(letter) - (next - pen) / size) * 1000.0;
            if off.abs() >= 0.5 {
                items.adjust(off.round() as f32);
            }
        }
    }
}

/// Moves the pen to the start of a row, along the baseline of the item, with the slant of its glyphs. Text
/// stands upwards, the page downwards.
fn stand(content: &mut Content, bend: &Bend, (row, start): (&Row, f64), size: f64) {
    let lean = if row.strong { LEAN } else { 0.0 };
    let place = |along: f64, up: f64| {
        let (x, y) = row.at(start + along * size, up * size);
        bend.moved(x, y)
    };
    let from = place(0.0, 0.0);
    let side = |along: f64, up: f64| {
        let to = place(along, up);
        ((to.x - from.x) * 100.0, (to.y - from.y) * 100.0)
    };
    let (along, up) = (side(0.01, 0.0), side(0.01 * lean, 0.01));
    let exact = |value: f64| ((value * 1e4).round() / 1e4) as f32;
    let [a, b, c, d] = [along.0, along.1, up.0, up.1].map(exact);
    content.set_text_matrix([a, b, c, d, short(from.x), short(from.y)]);
}
