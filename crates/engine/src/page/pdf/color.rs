//! Colours in a PDF file: unchanged, or as the plate of one ink.

use super::share;
use crate::page::plates::Separation;
use pdf_writer::Content;

/// Conversion of colours.
pub(super) enum Colours {
    /// Unchanged. Grays use the gray colour space, so that presses print them without coloured inks.
    Own,
    /// One ink, and the paper, which is not printed.
    Plate { separation: Box<Separation>, ink: usize, paper: [u8; 3] },
}

impl Colours {
    /// The gray value of a colour on a plate, or if its channels are equal. `None` for other colours.
    fn gray(&self, rgb: [u8; 3]) -> Option<u8> {
        match self {
            Self::Own => (rgb[0] == rgb[1] && rgb[1] == rgb[2]).then_some(rgb[0]),
            Self::Plate { paper, .. } if rgb == *paper => Some(255),
            Self::Plate { separation, ink, .. } => Some(255 - separation.cover(rgb, *ink)),
        }
    }

    /// Sets the fill colour.
    pub(super) fn fill(&self, content: &mut Content, rgb: [u8; 3]) {
        if let Some(gray) = self.gray(rgb) {
            content.set_fill_gray(share([gray; 3])[0]);
        } else {
            let [r, g, b] = share(rgb);
            content.set_fill_rgb(r, g, b);
        }
    }

    /// The colour of lines drawn next.
    pub(super) fn stroke(&self, content: &mut Content, rgb: [u8; 3]) {
        if let Some(gray) = self.gray(rgb) {
            content.set_stroke_gray(share([gray; 3])[0]);
        } else {
            let [r, g, b] = share(rgb);
            content.set_stroke_rgb(r, g, b);
        }
    }

    /// The colour of marks, which are on every plate.
    #[expect(clippy::unused_self, reason = "black is black on all of them")]
    pub(super) fn register(&self, content: &mut Content) {
        content.set_stroke_gray(0.0);
    }
}
