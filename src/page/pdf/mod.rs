//! Pages as a PDF file: frames, balloons and letters stay lines and text at any size; only what is inside of the
//! panels is made of pixels, one JPEG a panel.
//!
//! | module | for |
//! |---|---|
//! | [`picture`] | the picture of a panel, as the file holds it |
//! | `drawing` | the panels of a page |
//! | `lettering` | the words of a page |
//! | `fonts` | the letters that the words need |
//!
//! All geometry is that of the page as pixels: the same functions say where it is.

mod drawing;
mod fonts;
mod lettering;
pub mod picture;

use super::document::Document;
use super::words::Letters;
use super::words::layout::lay_all;
use crate::error::Result;
use fonts::Fonts;
use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Rect, Ref, TextStr};
pub use picture::Picture;

/// A page with the pictures of its panels.
pub struct Leaf {
    /// The page.
    pub document: Document,
    /// Pictures of its panels; a panel without one is empty.
    pub pictures: Vec<Picture>,
}

/// Longest side that readers of PDF files take, in units.
const LONGEST: f64 = 14_400.0;
/// Units of 1/72 inch.
const INCH: f64 = 72.0;

/// Writes pages, each as large as its dots an inch make it.
///
/// # Errors
/// `invalid-document` for panels that do not fit the layout and for words that break their shape; `unknown-layout`,
/// `invalid-layout`.
pub fn write(leaves: &[Leaf], title: &str, letters: &Letters) -> Result<Vec<u8>> {
    let mut last = Ref::new(1);
    let mut next = || last.bump();
    let mut pdf = Pdf::with_settings(pdf_writer::Settings { pretty: false });
    let (catalog, tree) = (next(), next());
    let mut root = pdf.catalog(catalog);
    root.pages(tree).viewer_preferences().display_doc_title(true);
    root.finish();
    // No times, no names: who made it and when is nobody's business.
    pdf.document_info(next()).title(TextStr(title)).producer(TextStr("Inkpanel"));
    let ids: Vec<Ref> = leaves.iter().map(|_| next()).collect();
    pdf.pages(tree).kids(ids.iter().copied()).count(ids.len() as i32);

    let words = leaves.iter().map(|leaf| lay_all(&leaf.document, letters)).collect::<Result<Vec<_>>>()?;
    let fonts = Fonts::of(&words, letters, &mut next);
    fonts.write(&mut pdf, &mut next);
    for ((leaf, words), id) in leaves.iter().zip(&words).zip(ids) {
        let settings = &leaf.document.page;
        let (width, height) = (f64::from(settings.width), f64::from(settings.height));
        let points = INCH / f64::from(settings.dpi.max(1));
        let unit = (width.max(height) * points / LONGEST).ceil().max(1.0);
        let scale = points / unit;
        let mut content = Content::new();
        content.transform([scale, 0.0, 0.0, -scale, 0.0, height * scale].map(|value| value as f32));
        drawing::draw(&mut content, &leaf.document, &leaf.pictures)?;
        for laid in words {
            lettering::draw(&mut content, laid, width, letters, &fonts);
        }
        let images: Vec<Ref> = leaf.pictures.iter().map(|_| next()).collect();
        let drawn = next();
        let mut page = pdf.page(id);
        page.media_box(Rect::new(0.0, 0.0, (width * scale) as f32, (height * scale) as f32)).parent(tree);
        if unit > 1.0 {
            page.user_unit(unit as f32);
        }
        page.contents(drawn);
        let mut resources = page.resources();
        let mut named = resources.x_objects();
        for (picture, &image) in leaf.pictures.iter().zip(&images) {
            named.pair(Name(picture.name().as_bytes()), image);
        }
        named.finish();
        fonts.name(&mut resources.fonts());
        resources.finish();
        page.finish();
        for (picture, image) in leaf.pictures.iter().zip(images) {
            picture.write(&mut pdf, image);
        }
        pdf.stream(drawn, &packed(&content.finish())).filter(Filter::FlateDecode);
    }
    Ok(pdf.finish())
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
