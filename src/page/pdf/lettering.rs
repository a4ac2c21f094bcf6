//! The words of a page in a PDF file: balloons as lines, letters as text that can be found and copied. The letters of
//! a bent line are bent themselves, which text cannot be: they are drawn as lines, with unseen text straight across them.

use super::drawing::{color, path};
use super::fonts::{Face, Fonts};
use super::{share, short};
use crate::layout::Point;
use crate::page::words::Letters;
use crate::page::words::draw::{Bend, Lines, Row, lines, rows};
use crate::page::words::layout::Laid;
use crate::page::words::model::Kind;
use pdf_writer::types::{LineCapStyle, LineJoinStyle, TextRenderingMode};
use pdf_writer::{Content, Name, Str, TextStr};

/// Draws a word on a page of `width` pixels.
pub(super) fn draw(content: &mut Content, laid: &Laid, width: f64, letters: &Letters, fonts: &Fonts) {
    let Lines { body, text, half, dash } = lines(laid, width, letters);
    content.save_state();
    content.set_line_join(LineJoinStyle::RoundJoin).set_line_cap(LineCapStyle::RoundCap);
    content.set_line_width(short(2.0 * half));
    if laid.word.kind == Kind::Effect {
        stroke(content, &text, laid.word.fill);
    } else {
        fill(content, &body, laid.word.fill);
        if let Some((on, off)) = dash {
            content.set_dash_pattern([short(on), short(off)], 0.0);
        }
        stroke(content, &body, laid.word.color);
    }
    let bend = Bend::new(laid, width);
    let size = laid.setting.size * width;
    if bend.is_arc() {
        fill(content, &text, laid.word.color);
    }
    color(content, laid.word.color);
    content.begin_text();
    if bend.is_arc() {
        content.set_text_rendering_mode(TextRenderingMode::Invisible);
    }
    for row in rows(laid, width, letters) {
        let Some(face) = fonts.face(row.font.id()) else { continue };
        content.set_font(Name(face.name().as_bytes()), 1.0);
        // Programs that look for words take a line that is not level for many: they are told what it says.
        let level = laid.word.kind != Kind::Effect;
        if !level {
            let says: String = row.letters.iter().map(|(letter, _)| letter).collect();
            let mut mark = content.begin_marked_content_with_properties(Name(b"Span"));
            mark.properties().actual_text(TextStr(&says));
        }
        show(content, &row, face, &bend.straightened(), size);
        if !level {
            content.end_marked_content();
        }
    }
    content.end_text();
    content.restore_state();
}

fn fill(content: &mut Content, shapes: &[Vec<Point>], with: [u8; 3]) {
    if shapes.is_empty() {
        return;
    }
    color(content, with);
    for points in shapes {
        path(content, points);
    }
    content.fill_nonzero();
}

fn stroke(content: &mut Content, shapes: &[Vec<Point>], with: [u8; 3]) {
    if shapes.is_empty() {
        return;
    }
    let [r, g, b] = share(with);
    content.set_stroke_rgb(r, g, b);
    for points in shapes {
        path(content, points);
    }
    content.stroke();
}

/// A line of text with the distances that its letters have on the page.
fn show(content: &mut Content, row: &Row, face: &Face, bend: &Bend, size: f64) {
    let Some(&(_, start)) = row.letters.first() else { return };
    stand(content, bend, (start, row.baseline), size);
    let mut showing = content.show_positioned();
    let mut items = showing.items();
    for (at, &(letter, pen)) in row.letters.iter().enumerate() {
        items.show(Str(&face.code(letter)));
        if let Some(&(_, next)) = row.letters.get(at + 1) {
            // What the pen goes further, or less far, than the letter is wide.
            let off = (row.font.step(letter) - (next - pen) / size) * 1000.0;
            if off.abs() >= 0.5 {
                items.adjust(off.round() as f32);
            }
        }
    }
}

/// Puts the pen at a place of the word, along the line that the word has there. Text stands upwards, the page downwards.
fn stand(content: &mut Content, bend: &Bend, (x, y): (f64, f64), size: f64) {
    let from = bend.moved(x, y);
    let to = bend.moved(x + 0.01 * size, y);
    let (dx, dy) = (to.x - from.x, to.y - from.y);
    let length = dx.hypot(dy).max(1e-9);
    let (cos, sin) = (dx / length, dy / length);
    let exact = |value: f64| ((value * 1e4).round() / 1e4) as f32;
    let [a, b] = [cos * size, sin * size].map(exact);
    content.set_text_matrix([a, b, b, -a, short(from.x), short(from.y)]);
}
