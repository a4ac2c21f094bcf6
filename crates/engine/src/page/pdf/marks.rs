//! Crop marks and fold marks of a sheet. They are outside of the trimmed area, except the cut of a mini-zine.

use super::color::Colours;
use super::impose::Imposition;
use super::sheet::{MARK, Sheet};
use super::short;
use pdf_writer::Content;

/// Width of the lines, in points: the thinnest that all printers print.
const LINE: f64 = 0.25;
/// Lengths in points of a dash and a gap of a fold line.
const FOLD: [f32; 2] = [3.0, 2.0];

/// Draws the marks of a sheet, in points from the upper left corner of the trimmed area.
pub(super) fn draw(content: &mut Content, sheet: &Sheet, how: Option<Imposition>, colours: &Colours) {
    content.save_state();
    content.transform(sheet.matrix());
    content.set_line_width(LINE as f32);
    colours.register(content);
    let (width, height) = sheet.size;
    for x in [0.0, width] {
        upright(content, sheet, x);
    }
    for y in [0.0, height] {
        level(content, sheet, y);
    }
    let (lines, cuts) = sheet.lines(how);
    if !cuts {
        content.set_dash_pattern(FOLD, 0.0);
    }
    for [from, to] in lines {
        if from.1 < to.1 {
            upright(content, sheet, from.0);
        } else {
            level(content, sheet, from.1);
        }
    }
    if how == Some(Imposition::Zine) {
        // From the first fold to the last, through the middle.
        line(content, (width / 4.0, height / 2.0), (width * 3.0 / 4.0, height / 2.0));
    }
    content.restore_state();
}

/// Marks above and below the sheet.
fn upright(content: &mut Content, sheet: &Sheet, x: f64) {
    let (near, far) = reach(sheet);
    line(content, (x, -far), (x, -near));
    line(content, (x, sheet.size.1 + near), (x, sheet.size.1 + far));
}

/// Marks to its left and right.
fn level(content: &mut Content, sheet: &Sheet, y: f64) {
    let (near, far) = reach(sheet);
    line(content, (-far, y), (-near, y));
    line(content, (sheet.size.0 + near, y), (sheet.size.0 + far, y));
}

fn reach(sheet: &Sheet) -> (f64, f64) {
    let near = sheet.bleed.max(MARK.0);
    (near, near + MARK.1)
}

fn line(content: &mut Content, from: (f64, f64), to: (f64, f64)) {
    content.move_to(short(from.0), short(from.1)).line_to(short(to.0), short(to.1)).stroke();
}
