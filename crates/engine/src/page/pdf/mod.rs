//! PDF export. Borders, balloons and text are vectors. Only the content of panels is pixels, one JPEG image
//! per panel.
//!
//! | module | for |
//! |---|---|
//! | [`picture`] | the picture of a panel, as the file holds it |
//! | [`options`] | options of a file, apart from its pages |
//! | [`impose`] | imposition: order of pages on sheets that are folded or cut |
//! | `sheet` | a side of a sheet, with its measures |
//! | `drawing` | the panels of a page |
//! | `lettering` | the text of a page |
//! | `marks` | where a sheet is cut and folded |
//! | `color` | colours, or the plate of one ink |
//! | `fonts` | the subset fonts of the text |
//! | `tags` | reading order of the text, and alternative texts of the pictures |
//! | `about` | title, language and colour space |
//!
//! The geometry is the same as for pixels, from the same functions.

mod about;
mod color;
mod drawing;
mod fonts;
pub mod impose;
mod lettering;
mod marks;
pub mod options;
pub mod picture;
mod sheet;
mod tags;

use super::document::Document;
use super::plates::Separation;
use super::words::Letters;
use super::words::layout::{Laid, lay_all};
use crate::error::{Error, Result};
use about::About;
use color::Colours;
use fonts::Fonts;
pub use impose::Imposition;
use miniz_oxide::deflate::compress_to_vec_zlib;
pub use options::Options;
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Ref};
pub use picture::Picture;
use sheet::Sheet;
use tags::Tags;

/// A page with the images of its panels.
pub struct Leaf {
    /// The page.
    pub document: Document,
    /// Images of its panels. A panel without an image is empty.
    pub pictures: Vec<Picture>,
    /// Alternative texts of the panels, in their order. Missing ones become the number of the panel.
    pub alts: Vec<String>,
}

/// Writes pages at their print size, with the given imposition.
///
/// # Errors
/// `invalid-document` for panels that do not fit the layout, invalid text items, or a plate of an ink that
/// the page's style does not use; `unknown-layout`, `invalid-layout`, and style errors for plates.
pub fn write(leaves: &[Leaf], options: &Options, letters: &Letters) -> Result<Vec<u8>> {
    let mut last = Ref::new(1);
    let mut next = || last.bump();
    let mut pdf = Pdf::with_settings(pdf_writer::Settings { pretty: false });
    let (catalog, tree, info) = (next(), next(), next());
    let about = About::new(options, &mut next);
    let rtl = leaves.first().is_some_and(|leaf| leaf.document.page.rtl);
    about.write(&mut pdf, (catalog, tree), info, (options, rtl));
    let sides = impose::sides(options.imposition, leaves.len());
    let ids: Vec<Ref> = sides.iter().map(|_| next()).collect();
    pdf.pages(tree).kids(ids.iter().copied()).count(ids.len() as i32);

    let words = leaves.iter().map(|leaf| lay_all(&leaf.document, letters)).collect::<Result<Vec<_>>>()?;
    let fonts = Fonts::of(&words, letters, &mut next);
    fonts.write(&mut pdf, &mut next);
    let mut book = Book { leaves, words: &words, options, letters, fonts: &fonts, tags: Tags::default() };
    for (side, id) in sides.iter().zip(ids) {
        let sheet = Sheet::new(side, leaves, options);
        book.write(&mut pdf, &sheet, (id, tree), &mut next)?;
    }
    book.tags.write(&mut pdf, about.structure, leaves.len(), &mut next);
    Ok(pdf.finish())
}

/// Shared resources of all sheets.
struct Book<'a> {
    leaves: &'a [Leaf],
    words: &'a [Vec<Laid>],
    options: &'a Options,
    letters: &'a Letters,
    fonts: &'a Fonts<'a>,
    tags: Tags,
}

impl Book<'_> {
    /// Writes one side of a sheet, with the pictures on it.
    fn write(
        &mut self,
        pdf: &mut Pdf,
        sheet: &Sheet,
        (id, tree): (Ref, Ref),
        next: &mut impl FnMut() -> Ref,
    ) -> Result<()> {
        self.tags.begin(id);
        let key = self.tags.key();
        let mut content = Content::new();
        for cell in &sheet.cells {
            let leaf = &self.leaves[cell.leaf];
            let colours = colours_of(&leaf.document, self.options)?;
            let ground = drawing::Ground { leaf, number: cell.leaf, room: cell.room, colours: &colours };
            content.save_state();
            content.transform(sheet.matrix_of(cell));
            drawing::draw(&mut content, &ground, &mut self.tags, next)?;
            let lettering = lettering::Lettering {
                ground: &ground,
                letters: self.letters,
                fonts: self.fonts,
                ranks: lettering::ranks(&leaf.document, &self.words[cell.leaf])?,
            };
            let fronts = leaf.document.fronts();
            let words = || self.words[cell.leaf].iter().zip(&lettering.ranks);
            let behind = |laid: &Laid| laid.word.front(&fronts);
            for front in 0..fronts.len() {
                for (laid, rank) in words().filter(|(laid, _)| behind(laid) == Some(front)) {
                    lettering.draw(&mut content, laid, *rank, (&mut self.tags, next()));
                }
                drawing::draw_front(&mut content, &ground, front);
            }
            for (laid, rank) in words().filter(|(laid, _)| behind(laid).is_none()) {
                lettering.draw(&mut content, laid, *rank, (&mut self.tags, next()));
            }
            content.restore_state();
        }
        if self.options.marks {
            tags::artifact(&mut content);
            marks::draw(&mut content, sheet, self.options.imposition, &Colours::Own);
            tags::end(&mut content);
        }
        let pictures: Vec<(&Picture, usize, Ref)> = sheet
            .cells
            .iter()
            .flat_map(|cell| self.leaves[cell.leaf].pictures.iter().map(|picture| (picture, cell.leaf)))
            .map(|(picture, leaf)| (picture, leaf, next()))
            .collect();
        let drawn = next();
        let mut page = pdf.page(id);
        page.media_box(sheet.media_box()).parent(tree);
        if sheet.bleed > 0.0 {
            page.bleed_box(sheet.inner_box(sheet.bleed));
        }
        page.trim_box(sheet.inner_box(0.0));
        if sheet.unit > 1.0 {
            page.user_unit(sheet.unit as f32);
        }
        page.struct_parents(key).contents(drawn);
        let mut resources = page.resources();
        let mut named = resources.x_objects();
        for (picture, leaf, image) in &pictures {
            named.pair(Name(picture.name(*leaf).as_bytes()), *image);
        }
        named.finish();
        self.fonts.name(&mut resources.fonts());
        resources.finish();
        page.finish();
        for (picture, _, image) in pictures {
            let mask = if picture.alpha.is_some() { next() } else { image };
            picture.write(pdf, image, mask);
        }
        pdf.stream(drawn, &packed(&content.finish())).filter(Filter::FlateDecode);
        Ok(())
    }
}

/// Colour conversion of a page.
fn colours_of(document: &Document, options: &Options) -> Result<Colours> {
    let Some(ink) = options.plate else { return Ok(Colours::Own) };
    if ink >= options.inks.len() {
        let reason = "prints no plate of that number".into();
        return Err(Error::InvalidDocument { location: "style".into(), reason });
    }
    let separation = Box::new(Separation::new(&options.inks));
    Ok(Colours::Plate { separation, ink, paper: document.page.paper_rgb() })
}

fn packed(bytes: &[u8]) -> Vec<u8> {
    compress_to_vec_zlib(bytes, 6)
}

/// A length or a place with the two digits that can be seen.
fn short(value: f64) -> f32 {
    ((value * 100.0).round() / 100.0) as f32
}

/// A channel as PDF has it.
fn share([r, g, b]: [u8; 3]) -> [f32; 3] {
    [r, g, b].map(|channel| (f32::from(channel) / 255.0 * 1000.0).round() / 1000.0)
}
