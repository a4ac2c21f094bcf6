//! Albums: the imported photos of a project.

use super::failure::Failure;
#[cfg(feature = "detect")]
use super::failure::survived;
#[cfg(feature = "detect")]
use super::nets::Nets;
use super::options::{BookOptions, PageOptions};
use super::page::{Book, Page};
use super::photo::Photo;
use super::places::PlaceNames;
use crate::document::limits::MOST_SHEETS;
use crate::framing::{PhotoMeta, Subject};
use crate::page::book::{Styles, Wish, naming};
use crate::page::import::Imported;
use crate::page::request::Request;
use crate::page::storyboard;
use crate::page::words::given::{GivenFonts, missing};
use crate::page::words::place;
use crate::page::{self, Document};
use crate::plan::Shelf;
use rayon::prelude::*;
use std::collections::HashMap;
use std::ffi::OsStr;
use std::path::Path;
use std::sync::Arc;

/// Photos that were read and measured. It can make any number of pages.
pub struct Album {
    photos: Arc<[Photo]>,
    /// Readable photos, with their places in the input list.
    read: Vec<(usize, Imported)>,
    fonts: GivenFonts,
    notes: Vec<String>,
    /// The names of the places where photos were taken, by id.
    located: Vec<(String, String)>,
}

/// Returns the page's id of the photo at a place in the list. The command line uses the same ids.
pub(super) fn id(place: usize) -> String {
    format!("photo-{place}")
}

impl Album {
    /// Reads photos in parallel, in the order of the story.
    ///
    /// # Errors
    /// Returns the error of the first photo that cannot be read: `not-found`, `unreadable`, `unknown-format`,
    /// `damaged`, `unsupported`, `too-large`.
    pub fn read(photos: Vec<Photo>) -> Result<Self, Failure> {
        let (album, broken) = Self::read_side_by_side(photos);
        broken.into_iter().next().map_or(Ok(album), Err)
    }

    /// Like [`Self::read`], but skips photos that cannot be read. [`Self::notes`] lists them with the reason.
    #[must_use]
    pub fn read_skipping_broken(photos: Vec<Photo>) -> Self {
        let (mut album, broken) = Self::read_side_by_side(photos);
        album.notes.extend(broken.into_iter().map(|failure| format!("{failure}; left out")));
        album
    }

    fn read_side_by_side(photos: Vec<Photo>) -> (Self, Vec<Failure>) {
        let (mut read, mut broken) = (Vec::new(), Vec::new());
        let all = photos.par_iter().enumerate().map(|(place, photo)| photo.imported(&id(place)));
        for (place, imported) in all.collect::<Vec<_>>().into_iter().enumerate() {
            match imported {
                Ok(imported) => read.push((place, imported)),
                Err(failure) => broken.push(failure),
            }
        }
        let damage = |(place, photo): &(usize, Imported)| {
            Some(format!("{}: {}", photos[*place].name(), photo.damage?))
        };
        let (fonts, notes) = (GivenFonts::default(), read.iter().filter_map(damage).collect());
        (Self { photos: photos.into(), read, fonts, notes, located: Vec::new() }, broken)
    }

    /// Warnings as sentences: damaged or skipped photos, and the reason.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Adds a TrueType or OpenType font for characters that the bundled fonts lack.
    ///
    /// # Errors
    /// `invalid-argument` if the file is not a font, is damaged or too large, or if there are more than
    /// sixteen fonts.
    pub fn add_font(&mut self, file: Vec<u8>) -> Result<(), Failure> {
        self.fonts.add(file).map_err(|reason| Failure::argument("fonts", reason))
    }

    /// Asks for a large panel for a photo, by its place in the list that was given, from 0.
    ///
    /// # Errors
    /// `invalid-argument` if the album has no readable photo at this place.
    pub fn star(&mut self, place: usize) -> Result<(), Failure> {
        let starred = self.read.iter_mut().find(|(own, _)| *own == place);
        let (_, photo) =
            starred.ok_or_else(|| Failure::argument("star", "names a photo that does not exist"))?;
        photo.meta.starred = true;
        Ok(())
    }

    /// Looks for faces and objects in all photos, so that no crop cuts them. A failure in one photo is added
    /// to the notes and counts as no result.
    #[cfg(feature = "detect")]
    pub fn detect(&mut self, nets: &Nets) {
        let look = |(_, photo): &(usize, Imported)| survived(|| nets.look(photo));
        let found: Vec<Result<_, Failure>> = self.read.par_iter().map(look).collect();
        for ((place, photo), found) in self.read.iter_mut().zip(found) {
            match found {
                Ok(found) => photo.meta.find(found),
                Err(failure) => self.notes.push(format!("{}: {failure}", self.photos[*place].name())),
            }
        }
    }

    /// Names the places of photos by the GPS data of their files, for the captions of books. Only the names are kept.
    pub fn locate(&mut self, names: &PlaceNames) {
        let named = |(place, _): &(usize, Imported)| Some((id(*place), self.photos[*place].place(&names.0)?));
        self.located = self.read.par_iter().filter_map(named).collect();
    }

    /// One page of the photos.
    ///
    /// # Errors
    /// As [`Self::pages`].
    pub fn page(&self, options: &PageOptions) -> Result<Page, Failure> {
        let first = self.planned(options, None)?.into_iter().next();
        first.ok_or_else(|| Failure::from(crate::error::Error::NoPhotos))
    }

    /// Splits the album into at most `most` pages of one style, at changes of time or scene.
    ///
    /// # Errors
    /// `no-photos`; `invalid-argument` if `most` is outside 1 to 1000; `invalid-document` for a setting out
    /// of range or an invalid text item.
    pub fn pages(&self, options: &PageOptions, most: usize) -> Result<Vec<Page>, Failure> {
        self.planned(options, Some(most))
    }

    /// Makes a book: a cover, chapters by day with captions, page numbers and an end page. Names of the folders of photos are
    /// places, and [`Self::locate`] finds others. The number of panels, the layout and the text items of `options` do not apply.
    ///
    /// # Errors
    /// As [`Self::pages`].
    pub fn book(&self, options: &PageOptions, book: &BookOptions) -> Result<Vec<Page>, Failure> {
        PageOptions::check(book.pages)?;
        let (used, notes) = self.chosen(options);
        let folder = |place: usize| {
            let folder = Path::new(self.photos[place].name()).parent().and_then(Path::file_name);
            folder.and_then(OsStr::to_str).unwrap_or_default()
        };
        let ids: Vec<(String, &str)> =
            self.read.iter().map(|(place, _)| (id(*place), folder(*place))).collect();
        let mut places = naming::places(ids.iter().map(|(id, folder)| (id.as_str(), *folder)));
        naming::add_located(&mut places, self.located.iter().cloned());
        let wish = Wish {
            title: book.title.clone(),
            language: book.language.clone(),
            places,
            pages: book.pages,
            styles: if book.by_chapter { Styles::Chapters } else { Styles::One },
        };
        let ordered = options.choice.as_given.then_some(true);
        let shelf = Shelf::new(used.len());
        let request = Request {
            photos: used,
            ordered,
            panels: None,
            layout: None,
            figures: Some(false),
            ..options.request()
        };
        let mut made = page::book::Book::new(request, wish, &shelf, MOST_SHEETS)?;
        while made.step()? {}
        let mut documents: Vec<_> = made.pages().into_iter().map(|page| page.planned.document).collect();
        let subjects = self.subjects();
        for document in &mut documents {
            let of = |id: &str| subjects.get(id).map_or(&[][..], Vec::as_slice).into();
            let letters = self.fonts.letters(&document.words)?;
            place::settle(document, of, &letters)?;
        }
        Ok(self.bound(documents, subjects, notes))
    }

    /// The photos of pages, and the notes about photos that are left out.
    fn chosen(&self, options: &PageOptions) -> (Vec<PhotoMeta>, Vec<String>) {
        let names: Vec<&str> = self.read.iter().map(|(place, _)| self.photos[*place].name()).collect();
        let imported: Vec<&Imported> = self.read.iter().map(|(_, imported)| imported).collect();
        let (used, verdicts) = storyboard::chosen(&names, &imported, options.choice);
        let mut notes = self.notes.clone();
        let left = names.iter().zip(&verdicts).filter(|(_, verdict)| !verdict.kept);
        notes.extend(left.map(|(name, verdict)| format!("{name}: left out: {}", verdict.why)));
        (used, notes)
    }

    /// Detected subjects by photo id.
    fn subjects(&self) -> HashMap<String, Vec<Subject>> {
        self.read.iter().map(|(place, photo)| (id(*place), photo.meta.subjects.clone())).collect()
    }

    fn bound(
        &self,
        documents: Vec<Document>,
        subjects: HashMap<String, Vec<Subject>>,
        notes: Vec<String>,
    ) -> Vec<Page> {
        let fonts = self.fonts.clone();
        let book = Arc::new(Book { photos: self.photos.clone(), subjects, fonts, notes });
        documents.into_iter().map(|document| Page::new(book.clone(), document)).collect()
    }

    fn planned(&self, options: &PageOptions, most: Option<usize>) -> Result<Vec<Page>, Failure> {
        PageOptions::check(most)?;
        let (used, mut notes) = self.chosen(options);
        let ordered = options.choice.as_given.then_some(true);
        let request = Request { photos: used, ordered, ..options.request() };
        let pages = storyboard::pages(&request, most)?;
        let mut documents: Vec<_> = pages.into_iter().map(|page| page.document).collect();
        let subjects = self.subjects();
        if let (Some(first), false) = (documents.first_mut(), options.words.is_empty()) {
            let of = |id: &str| subjects.get(id).map_or(&[][..], Vec::as_slice).into();
            let letters = self.fonts.letters(&options.words)?;
            place::add(first, options.words.clone(), of, &letters)?;
            let missing = missing(&letters, &options.words);
            if !missing.is_empty() {
                let told = missing.join(" ");
                notes.push(format!("no font has these characters, so they appear as question marks: {told}"));
            }
        }
        Ok(self.bound(documents, subjects, notes))
    }
}
