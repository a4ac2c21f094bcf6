//! Albums: the imported photos of a project.

use crate::failure::Failure;
#[cfg(feature = "detect")]
use crate::failure::survived;
#[cfg(feature = "detect")]
use crate::nets::Nets;
use crate::note::Note;
use crate::options::{BookOptions, PageOptions};
use crate::page::{Book, Page};
use crate::photo::{Photo, id};
use crate::places::PlaceNames;
use inkpanel_engine::document::limits::MOST_SHEETS;
use inkpanel_engine::document::page_edits;
use inkpanel_engine::framing::{PhotoMeta, Subject};
use inkpanel_engine::page::Document;
use inkpanel_engine::page::book::{self, BookPage, Styles, Wish, naming};
use inkpanel_engine::page::import::Imported;
use inkpanel_engine::page::request::Request;
use inkpanel_engine::page::shuffle::Planned;
use inkpanel_engine::page::storyboard;
use inkpanel_engine::page::words::given::{GivenFonts, missing};
use inkpanel_engine::page::words::place::{self, Known};
use inkpanel_engine::plan::Shelf;
use inkpanel_engine::select::Verdict;
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
    notes: Vec<Note>,
    /// The names of the places where photos were taken, by id.
    located: Vec<(String, String)>,
}

/// The photos of pages, in order, and a verdict on each readable photo.
pub struct Selection {
    /// The photos of pages.
    pub used: Vec<PhotoMeta>,
    /// The verdicts, in the order of the album.
    pub verdicts: Vec<Verdict>,
}

/// A planned book.
pub struct BookPlan {
    /// The title on the cover.
    pub title: String,
    /// The pages with their text.
    pub pages: Vec<BookPage>,
}

impl Album {
    /// Reads photos in parallel, in the order of the story.
    ///
    /// # Errors
    /// Returns the error of the first photo that cannot be read: `not-found`, `unreadable`, `unknown-format`,
    /// `damaged`, `unsupported`, `too-large`.
    pub fn read(photos: Vec<Photo>) -> Result<Self, Failure> {
        let (album, broken) = Self::read_side_by_side(photos, &|_| {});
        broken.into_iter().next().map_or(Ok(album), Err)
    }

    /// Like [`Self::read`], but skips photos that cannot be read. [`Self::notes`] lists them with the reason.
    #[must_use]
    pub fn read_skipping_broken(photos: Vec<Photo>) -> Self {
        Self::read_side_by_side(photos, &|_| {}).0
    }

    /// Like [`Self::read_skipping_broken`]. Calls `done` after each photo.
    #[doc(hidden)]
    pub fn read_reporting(photos: Vec<Photo>, done: &(dyn Fn(&Photo) + Sync)) -> Self {
        Self::read_side_by_side(photos, done).0
    }

    fn read_side_by_side(photos: Vec<Photo>, done: &(dyn Fn(&Photo) + Sync)) -> (Self, Vec<Failure>) {
        let (mut read, mut broken, mut notes) = (Vec::new(), Vec::new(), Vec::new());
        let import = |(place, photo): (usize, &Photo)| {
            let imported = photo.imported(&id(place));
            done(photo);
            imported
        };
        let all: Vec<_> = photos.par_iter().enumerate().map(import).collect();
        for (place, imported) in all.into_iter().enumerate() {
            let name = photos[place].name();
            match imported {
                Ok(imported) => {
                    notes.extend(imported.damage.map(|damage| Note::of(name, damage)));
                    read.push((place, imported));
                }
                Err(failure) => {
                    notes.push(Note::of(name, format_args!("{}; left out", failure.reason())));
                    broken.push(failure);
                }
            }
        }
        let (fonts, located) = (GivenFonts::default(), Vec::new());
        (Self { photos: photos.into(), read, fonts, notes, located }, broken)
    }

    /// Warnings: damaged or skipped photos, and the reason.
    #[must_use]
    pub fn notes(&self) -> &[Note] {
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
                Err(failure) => self.notes.push(Note::of(self.photos[*place].name(), failure)),
            }
        }
    }

    /// Names the places of photos by the GPS data of their files, for the captions of books. Only the names are stored.
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
        first.ok_or_else(|| Failure::from(inkpanel_engine::error::Error::NoPhotos))
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
    /// places, and [`Self::locate`] finds others. The number of panels, the layout, the text items and the edits of `options` do not
    /// apply.
    ///
    /// # Errors
    /// As [`Self::pages`].
    pub fn book(&self, options: &PageOptions, book: &BookOptions) -> Result<Vec<Page>, Failure> {
        PageOptions::check(book.pages)?;
        let selection = self.choose(options);
        let notes = self.notes_with(&selection);
        let plan = self.plan_book(options, book, selection.used, &mut |_, _| {})?;
        Ok(self.bound(plan.pages.into_iter().map(|page| page.planned.document), notes))
    }

    fn planned(&self, options: &PageOptions, most: Option<usize>) -> Result<Vec<Page>, Failure> {
        PageOptions::check(most)?;
        let selection = self.choose(options);
        let mut notes = self.notes_with(&selection);
        let pages = self.plan(options, selection.used.clone(), most)?;
        let documents = pages.into_iter().map(|page| page.document).collect();
        let (mut documents, unchanged) = self.edit(options, documents, &selection.used)?;
        notes.extend(unchanged.into_iter().map(Note::new));
        if let (Some(first), false) = (documents.first_mut(), options.words.is_empty()) {
            let letters = self.fonts.letters(&options.words)?;
            place::add(first, options.words.clone(), |id| self.known(id), &letters)?;
            let missing = missing(&letters, &options.words);
            if !missing.is_empty() {
                let told = missing.join(" ");
                let note = format!("no font has these characters, so they appear as question marks: {told}");
                notes.push(Note::new(note));
            }
        }
        Ok(self.bound(documents, notes))
    }

    fn notes_with(&self, selection: &Selection) -> Vec<Note> {
        let judged = self.read.iter().zip(&selection.verdicts).filter(|(_, verdict)| !verdict.kept);
        let note = |((place, _), verdict): (&(usize, _), &Verdict)| {
            Note::of(self.photos[*place].name(), format_args!("left out: {}", verdict.reason))
        };
        self.notes.iter().cloned().chain(judged.map(note)).collect()
    }

    fn bound(&self, documents: impl IntoIterator<Item = Document>, notes: Vec<Note>) -> Vec<Page> {
        let subjects: HashMap<String, Vec<Subject>> =
            self.read.iter().map(|(place, photo)| (id(*place), photo.meta.subjects.clone())).collect();
        let fonts = self.fonts.clone();
        let book = Arc::new(Book { photos: self.photos.clone(), subjects, fonts, notes });
        documents.into_iter().map(|document| Page::new(book.clone(), document)).collect()
    }

    fn known(&self, id: &str) -> Known<'_> {
        let photo = self.read.iter().find(|(_, photo)| photo.meta.id == id);
        photo.map(|(_, photo)| Known::from(&photo.meta)).unwrap_or_default()
    }
}

/// The steps of [`Album::pages`] and [`Album::book`], which the command line reports one by one.
#[doc(hidden)]
impl Album {
    /// Readable photos, with their places in the input list.
    #[must_use]
    pub fn imported(&self) -> &[(usize, Imported)] {
        &self.read
    }

    /// Like [`Self::imported`], to add masks of subjects.
    pub fn imported_mut(&mut self) -> &mut [(usize, Imported)] {
        &mut self.read
    }

    /// Sets the fonts for characters that the bundled fonts lack.
    pub fn set_fonts(&mut self, fonts: GivenFonts) {
        self.fonts = fonts;
    }

    /// Selects the photos of pages.
    #[must_use]
    pub fn choose(&self, options: &PageOptions) -> Selection {
        let file = |place: usize| {
            let name = self.photos[place].name();
            Path::new(name).file_name().and_then(OsStr::to_str).unwrap_or(name)
        };
        let names: Vec<&str> = self.read.iter().map(|(place, _)| file(*place)).collect();
        let imported: Vec<&Imported> = self.read.iter().map(|(_, imported)| imported).collect();
        let (used, verdicts) = storyboard::chosen(&names, &imported, options.choice);
        Selection { used, verdicts }
    }

    /// Applies the edits of the options to planned pages of selected photos.
    ///
    /// Returns the pages, and a sentence for each edit that changed nothing.
    ///
    /// # Errors
    /// As [`Self::pages`].
    pub fn edit(
        &self,
        options: &PageOptions,
        pages: Vec<Document>,
        used: &[PhotoMeta],
    ) -> Result<(Vec<Document>, Vec<String>), Failure> {
        if options.edits.is_empty() {
            return Ok((pages, Vec::new()));
        }
        let named = |name: &str| {
            let mut places =
                (0..self.photos.len()).filter(|place| Path::new(self.photos[*place].name()).ends_with(name));
            let place = places.next()?;
            places.next().is_none().then(|| id(place))
        };
        let edited = page_edits::apply(pages, used, &options.edits, &named)?;
        let told = |i: usize| format!("edits[{i}] changes nothing");
        Ok((edited.pages, edited.unchanged.into_iter().map(told).collect()))
    }

    /// Plans pages of selected photos: one page of all, or at most `most`.
    ///
    /// # Errors
    /// As [`Self::pages`].
    pub fn plan(
        &self,
        options: &PageOptions,
        used: Vec<PhotoMeta>,
        most: Option<usize>,
    ) -> Result<Vec<Planned>, Failure> {
        Ok(storyboard::pages(&Request { photos: used, ..options.request() }, most)?)
    }

    /// Plans a book of selected photos. Calls `progress` with the number of planned pages and of all pages.
    ///
    /// # Errors
    /// As [`Self::pages`].
    pub fn plan_book(
        &self,
        options: &PageOptions,
        book: &BookOptions,
        used: Vec<PhotoMeta>,
        progress: &mut dyn FnMut(usize, usize),
    ) -> Result<BookPlan, Failure> {
        let wish = Wish {
            title: book.title.clone(),
            language: book.language.clone(),
            places: book.places.clone().unwrap_or_else(|| self.folders()),
            pages: book.pages,
            styles: if book.by_chapter { Styles::Chapters } else { Styles::One },
            ..Wish::default()
        };
        let shelf = Shelf::new(used.len());
        let request =
            Request { photos: used, panels: None, layout: None, figures: Some(false), ..options.request() };
        let mut made = book::Book::new(request, wish, &shelf, MOST_SHEETS)?;
        let title = made.title().to_owned();
        while made.step()? {
            progress(made.done(), made.len());
        }
        let mut pages = made.pages();
        for page in &mut pages {
            let document = &mut page.planned.document;
            let letters = self.fonts.letters(&document.words)?;
            place::settle(document, |id| self.known(id), &letters)?;
        }
        Ok(BookPlan { title, pages })
    }

    /// Places by the folders of photos.
    fn folders(&self) -> HashMap<String, String> {
        let folder = |place: usize| {
            let folder = Path::new(self.photos[place].name()).parent().and_then(Path::file_name);
            folder.and_then(OsStr::to_str).unwrap_or_default()
        };
        let ids: Vec<(String, &str)> =
            self.read.iter().map(|(place, _)| (id(*place), folder(*place))).collect();
        let mut places = naming::places(ids.iter().map(|(id, folder)| (id.as_str(), *folder)));
        naming::add_located(&mut places, self.located.iter().cloned());
        places
    }
}
