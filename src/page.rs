//! Planned pages. They are drawn when the caller requests their pixels or a file.

use crate::failure::Failure;
use crate::note::Note;
use crate::photo::{Photo, id};
use crate::pixels::Pixels;
use inkpanel_engine::framing::Subject;
use inkpanel_engine::native::{self, QUALITY};
use inkpanel_engine::page::Document;
use inkpanel_engine::page::pdf::{self as book, Leaf, Options};
use inkpanel_engine::page::words::given::GivenFonts;
use rayon::prelude::*;
use std::collections::HashMap;
use std::sync::Arc;

/// Data that the pages of an album share.
pub(crate) struct Book {
    pub(crate) photos: Arc<[Photo]>,
    /// Detected subjects by photo id.
    pub(crate) subjects: HashMap<String, Vec<Subject>>,
    /// Fonts for characters that the bundled fonts lack.
    pub(crate) fonts: GivenFonts,
    /// Warnings.
    pub(crate) notes: Vec<Note>,
}

/// A storyboard page that is planned. Each image or file is drawn from its photos, which are read again at
/// full size.
#[derive(Clone)]
pub struct Page {
    book: Arc<Book>,
    document: Document,
}

impl Page {
    pub(crate) fn new(book: Arc<Book>, document: Document) -> Self {
        Self { book, document }
    }

    /// Width in pixels.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.document.page.width
    }

    /// Height in pixels.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.document.page.height
    }

    /// Resolution in pixels per inch.
    #[must_use]
    pub fn dpi(&self) -> u32 {
        self.document.page.dpi
    }

    /// How many panels it has.
    #[must_use]
    pub fn panels(&self) -> usize {
        self.document.panels.len()
    }

    /// Warnings: skipped photos, and the reason. All pages of an album have the same notes.
    #[must_use]
    pub fn notes(&self) -> &[Note] {
        &self.book.notes
    }

    /// The page as JSON: layout, style, crops, text and settings. Photo names replace ids.
    #[must_use]
    pub fn plan(&self) -> String {
        let photos = self.book.photos.iter().enumerate();
        let names: HashMap<String, &str> = photos.map(|(place, photo)| (id(place), photo.name())).collect();
        let name_of = |id: &str| names.get(id).map_or(id, |name| *name).to_owned();
        with_names(&self.document, &name_of).to_json()
    }

    /// Draws it.
    ///
    /// # Errors
    /// The errors of a photo that is no longer readable.
    pub fn pixels(&self) -> Result<Pixels, Failure> {
        let sheet = native::sheet(&self.document, &self.shown()?, &self.book.fonts)?;
        let (width, height, dpi) = (sheet.width(), sheet.height(), self.document.page.dpi);
        Ok(Pixels { width, height, rgb: sheet.into_rgb(), dpi })
    }

    /// Returns the page as a PNG file.
    ///
    /// # Errors
    /// As [`Self::pixels`]; `encode`.
    pub fn png(&self) -> Result<Vec<u8>, Failure> {
        self.pixels()?.png()
    }

    /// Returns the page as a JPEG file. `quality` is from 1 to 100.
    ///
    /// # Errors
    /// As [`Self::pixels`]; `invalid-argument`; `encode`.
    pub fn jpeg(&self, quality: u8) -> Result<Vec<u8>, Failure> {
        self.pixels()?.jpeg(quality)
    }

    /// Returns a PDF file of only this page, like [`pdf`].
    ///
    /// # Errors
    /// As [`pdf`].
    pub fn pdf(&self) -> Result<Vec<u8>, Failure> {
        pdf(&[self], "", "en")
    }

    /// The photos that it shows at their full size, read side by side.
    fn shown(&self) -> Result<native::Photos, Failure> {
        let wanted = native::photos_of(&self.document)?;
        let photos = &self.book.photos;
        let places: Vec<usize> = (0..photos.len()).filter(|place| wanted.contains(&id(*place))).collect();
        places.into_par_iter().map(|place| Ok((id(place), photos[place].full()?.into()))).collect()
    }

    fn leaf(&self) -> Result<Leaf, Failure> {
        let subjects = |id: &str| self.book.subjects.get(id).map_or(&[][..], Vec::as_slice);
        let alts = native::alts(&self.document, &subjects);
        Ok(native::leaf(&self.document, &self.shown()?, alts, (None, QUALITY))?)
    }
}

/// A page whose photos have names instead of ids.
#[must_use]
pub fn with_names(page: &Document, name: &dyn Fn(&str) -> String) -> Document {
    let mut page = page.clone();
    for panel in &mut page.panels {
        panel.photo = panel.photo.as_deref().map(name);
    }
    page.order = page.order.iter().map(|id| name(id)).collect();
    page
}

/// Returns one PDF file of several pages. Panels are images with alternative text; lines and text are
/// vectors. `language` is the language of the text, such as `en`.
///
/// # Errors
/// `invalid-argument` without pages; the errors of a photo that is no longer readable; `encode`.
pub fn pdf(pages: &[&Page], title: &str, language: &str) -> Result<Vec<u8>, Failure> {
    if pages.is_empty() {
        return Err(Failure::argument("pages", "there is no page"));
    }
    let leaves = pages.iter().map(|page| page.leaf()).collect::<Result<Vec<_>, _>>()?;
    // The pages of several albums may need the fonts of all of them.
    let fonts = GivenFonts::joined(pages.iter().map(|page| &page.book.fonts));
    let letters = fonts.letters(pages.iter().flat_map(|page| &page.document.words))?;
    let options = Options { title: title.to_owned(), language: language.to_owned(), ..Options::default() };
    Ok(book::write(&leaves, &options, &letters)?)
}
