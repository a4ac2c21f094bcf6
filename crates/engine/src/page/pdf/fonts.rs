//! Embedded fonts of a PDF file: subsets with the used glyphs, and their Unicode text for search and copy.

use super::packed;
use crate::page::words::Letters;
use crate::page::words::draw::rows;
use crate::page::words::layout::Laid;
use crate::page::words::letters::Font;
use crate::page::words::truetype::subset;
use pdf_writer::types::{CidFontType, FontFlags, SystemInfo, UnicodeCmap};
use pdf_writer::{Dict, Filter, Finish, Name, Pdf, Rect, Ref, Str};
use std::collections::BTreeSet;

const IDENTITY: SystemInfo<'static> =
    SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"Identity"), supplement: 0 };
/// Thousandths of an em, in which PDF has lengths of fonts.
const PARTS: f64 = 1000.0;

/// All fonts of a file.
pub(super) struct Fonts<'a>(Vec<Face<'a>>);

/// A font with its used characters, in ascending order. The code of a character is its index plus one.
pub(super) struct Face<'a> {
    font: &'a Font,
    /// The glyph table, for the text of glyphs.
    words: &'a Letters,
    letters: Vec<char>,
    id: Ref,
    place: usize,
}

impl<'a> Fonts<'a> {
    /// Returns the fonts that the text of pages needs.
    pub(super) fn of(pages: &[Vec<Laid>], letters: &'a Letters, next: &mut impl FnMut() -> Ref) -> Self {
        let mut faces: Vec<(&'a Font, BTreeSet<char>)> = Vec::new();
        for row in pages.iter().flatten().flat_map(|laid| rows(laid, 1.0, letters)) {
            let known = faces.iter().position(|(font, _)| font.id() == row.font.id());
            let at = known.unwrap_or_else(|| {
                faces.push((row.font, BTreeSet::new()));
                faces.len() - 1
            });
            faces[at].1.extend(row.letters.iter().map(|(letter, _)| letter));
        }
        let face = |(place, (font, used)): (usize, (&'a Font, BTreeSet<char>))| Face {
            font,
            words: letters,
            letters: used.into_iter().collect(),
            id: next(),
            place,
        };
        Self(faces.into_iter().enumerate().map(face).collect())
    }

    pub(super) fn face(&self, id: &str) -> Option<&Face<'a>> {
        self.0.iter().find(|face| face.font.id() == id)
    }

    /// Writes the names of the fonts for a page.
    pub(super) fn name(&self, names: &mut Dict) {
        for face in &self.0 {
            names.pair(Name(face.name().as_bytes()), face.id);
        }
    }

    pub(super) fn write(&self, pdf: &mut Pdf, next: &mut impl FnMut() -> Ref) {
        self.0.iter().for_each(|face| face.write(pdf, next));
    }
}

impl Face<'_> {
    pub(super) fn name(&self) -> String {
        format!("F{}", self.place)
    }

    /// Returns the code of a character in this font.
    pub(super) fn code(&self, letter: char) -> [u8; 2] {
        let place = self.letters.binary_search(&letter).map_or(0, |at| at as u16 + 1);
        place.to_be_bytes()
    }

    fn write(&self, pdf: &mut Pdf, next: &mut impl FnMut() -> Ref) {
        let [cid, descriptor, file, unicode] = [next(), next(), next(), next()];
        let full = self.full_name();
        let base = Name(full.as_bytes());
        let mut font = pdf.type0_font(self.id);
        font.base_font(base).encoding_predefined(Name(b"Identity-H"));
        font.descendant_font(cid).to_unicode(unicode);
        font.finish();
        let mut font = pdf.cid_font(cid);
        font.subtype(CidFontType::Type2).base_font(base).system_info(IDENTITY).font_descriptor(descriptor);
        font.cid_to_gid_map_predefined(Name(b"Identity")).default_width(0.0);
        let steps = self.letters.iter().map(|&letter| (self.font.step(letter) * PARTS).round() as f32);
        font.widths().consecutive(1, steps);
        font.finish();
        let parts = |ems: f64| (ems * PARTS).round() as f32;
        let (ascent, descent) = (parts(self.font.ascent), -parts(self.font.descent));
        let mut about = pdf.font_descriptor(descriptor);
        about.name(base).flags(FontFlags::SYMBOLIC).bbox(Rect::new(-200.0, descent, 1600.0, ascent));
        about.italic_angle(0.0).ascent(ascent).descent(descent).cap_height(parts(self.font.capitals));
        about.stem_v(90.0).font_file2(file);
        about.finish();
        let bytes = subset(self.font, &self.letters);
        let small = packed(&bytes);
        let mut stream = pdf.stream(file, &small);
        stream.pair(Name(b"Length1"), bytes.len() as i32);
        stream.filter(Filter::FlateDecode);
        stream.finish();
        let mut map = UnicodeCmap::<u16>::new(Name(b"Inkpanel"), IDENTITY);
        for (at, &letter) in self.letters.iter().enumerate() {
            map.pair_with_multiple(at as u16 + 1, self.words.seen_text_of(letter).chars());
        }
        pdf.cmap(unicode, &packed(&map.finish())).filter(Filter::FlateDecode);
    }

    /// Returns the name with the prefix of a subset font: six capitals that depend on its characters.
    fn full_name(&self) -> String {
        let mut sum =
            self.letters.iter().fold(17u32, |sum, &letter| sum.wrapping_mul(31) ^ u32::from(letter));
        let mut mark = String::new();
        for _ in 0..6 {
            mark.push(char::from(b'A' + (sum % 26) as u8));
            sum /= 26;
        }
        format!("{mark}+{}", self.font.id())
    }
}
