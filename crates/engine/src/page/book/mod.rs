//! A book of an album: a cover, chapters by day with captions, page numbers, and an end page. Its pages are ordinary pages.
//!
//! [`plan::book`](crate::plan::book) decides which photos are on which page. This module plans each page as a shuffle does, and
//! adds the text.

pub mod naming;
mod narration;
mod phrases;

use super::fill::faces_of;
use super::request::{Avoid, Request};
use super::shuffle::{Planned, planned};
use super::words::TextItem;
use super::{Document, LayoutRef, StyleRef};
use crate::error::{Error, Result};
use crate::framing::{FACE, PhotoMeta, Subject, Target, closeup};
use crate::layout;
use crate::plan::book::{Leaf, Outline, Role, Wanted, outline};
use crate::plan::composer::gallery;
use crate::plan::moments::Moment;
use crate::plan::{Shelf, slots};
use narration::Told;
pub use phrases::Dates;
use phrases::Phrases;
use serde::Deserialize;
use std::collections::HashMap;

/// Layouts of the cover and of full pages, of other pages with one photo, and of the end page.
const WHOLE: &str = "splash-bleed";
const SINGLE: &str = "splash";
const CAST: &str = "circle-row-3";
/// Number of pages behind the cover whose largest panel does not repeat its photo.
const BESIDE_COVER: usize = 2;
/// Number of recent layouts that a page does not repeat.
const RECENT: usize = 3;
/// Minimum height of a face for the end page, in photo heights, and its minimum score.
const CAST_FACE: f64 = 0.09;
const CAST_SCORE: f64 = 0.7;
/// Minimum number of pages of a book.
pub const MIN_PAGES: usize = 3;

/// How the styles of a book are chosen.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "BookStyles"))]
pub enum Styles {
    /// All pages have one style.
    #[default]
    One,
    /// Each chapter has its own style.
    Chapters,
}

/// Options of a book.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(rename_all = "camelCase", default)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "BookWish", optional_fields))]
pub struct Wish {
    /// The title. Default: the places or the days of the photos.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub title: String,
    /// Language of the text, such as `en` or `pt-BR`.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub language: String,
    /// The places of photos by id.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub places: HashMap<String, String>,
    /// Dates in the format of the user. Default: in the format of the language.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub dates: Dates,
    /// Number of pages with cover and end page, from [`MIN_PAGES`]. Default: as many as the photos need.
    pub pages: Option<usize>,
    /// How styles are chosen.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub styles: Styles,
}

/// A page of a book.
#[derive(Debug, Clone, PartialEq)]
pub struct BookPage {
    /// Its purpose.
    pub role: Role,
    /// Index of its chapter.
    pub chapter: usize,
    /// The page with its text. Automatic text still needs a place.
    pub planned: Planned,
}

/// A book that is made page by page.
#[derive(Debug, Clone)]
pub struct Book {
    request: Request,
    wish: Wish,
    shelf: Shelf,
    outline: Outline,
    phrases: Phrases,
    title: (String, String),
    captions: Vec<Vec<(usize, String, bool)>>,
    made: Vec<Option<Planned>>,
    /// The style of each chapter, or of the book.
    styles: HashMap<usize, StyleRef>,
}

impl Book {
    /// Plans the pages of a book. `request` has the photos, the page settings, and the style if it is given. `shelf` has a
    /// place for each photo. `most`: maximum number of pages.
    ///
    /// # Errors
    /// `no-photos`; `invalid-document` for page settings out of range or fewer than [`MIN_PAGES`] pages.
    pub fn new(mut request: Request, wish: Wish, shelf: &Shelf, most: usize) -> Result<Self> {
        if request.photos.is_empty() {
            return Err(Error::NoPhotos);
        }
        request.page.validate()?;
        if wish.pages.is_some_and(|pages| pages < MIN_PAGES) {
            let reason = format!("must be at least {MIN_PAGES}");
            return Err(Error::InvalidDocument { location: "pages".into(), reason });
        }
        let order = in_time(&request, &wish.places);
        let shelf = shelf.some(&order);
        request.photos = order.iter().map(|&photo| request.photos[photo].clone()).collect();
        let phrases = Phrases::of(&wish.language)?.with(wish.dates.clone());
        let told = Told::new(&request.photos, &wish.places);
        let title = told.title(&wish.title, &phrases);
        let aspect = request.page.aspect();
        let counts: Vec<usize> =
            layout::good_for(aspect).iter().map(|template| template.panels().len()).collect();
        let whole = layout::resolve(layout::find(WHOLE)?, aspect, &request.page);
        let whole = slots(&whole, request.page.looked_at()).swap_remove(0);
        let wanted = Wanted {
            places: &told.places,
            pages: wish.pages,
            most,
            counts: &counts,
            whole: &whole,
            apart: wish.styles == Styles::Chapters,
            uncropped: request.page.whole_photos.then_some(aspect),
        };
        let outline = outline(&gallery(&request.photos, &shelf), &wanted);
        let captions = told.captions(&outline, &title.0, &phrases);
        drop(told);
        let made = vec![None; outline.leaves.len()];
        Ok(Self { request, wish, shelf, outline, phrases, title, captions, made, styles: HashMap::new() })
    }

    /// Number of pages.
    #[must_use]
    pub fn len(&self) -> usize {
        self.outline.leaves.len()
    }

    /// Whether the book has no pages.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of pages that are planned.
    #[must_use]
    pub fn done(&self) -> usize {
        self.made.iter().flatten().count()
    }

    /// The title.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title.0
    }

    /// Plans the next page. Returns whether there are more.
    ///
    /// # Errors
    /// Errors of [`planned`].
    pub fn step(&mut self) -> Result<bool> {
        // The largest page chooses the style. The cover follows.
        let next = (0..self.len()).filter(|&at| self.made[at].is_none());
        if let Some(at) = next.max_by_key(|&at| (self.outline.leaves[at].photos.len(), usize::MAX - at)) {
            let page = self.page(at)?;
            self.made[at] = Some(page);
        }
        Ok(self.done() < self.len())
    }

    /// The pages that are planned, in order.
    #[must_use]
    pub fn pages(self) -> Vec<BookPage> {
        let leaves = self.outline.leaves.into_iter();
        leaves
            .zip(self.made)
            .filter_map(|(Leaf { role, chapter, .. }, planned)| {
                Some(BookPage { role, chapter, planned: planned? })
            })
            .collect()
    }

    fn page(&mut self, at: usize) -> Result<Planned> {
        let leaf = &self.outline.leaves[at];
        let chapter = if self.wish.styles == Styles::Chapters { leaf.chapter } else { 0 };
        let mut photos: Vec<PhotoMeta> =
            leaf.photos.iter().map(|&photo| self.request.photos[photo].clone()).collect();
        let cast = if leaf.role == Role::End { self.cast(leaf.photos[0]) } else { Vec::new() };
        let layout = match leaf.role {
            Role::Cover | Role::Full => Some(WHOLE),
            Role::End if !cast.is_empty() => Some(CAST),
            Role::End => Some(SINGLE),
            Role::Page if photos.len() == 1 => Some(SINGLE),
            Role::Page => None,
        };
        let shown = self.made.iter().take(at).flatten().rev().take(RECENT);
        let next = self.made.iter().skip(at + 1).take(RECENT).flatten();
        let near = shown.chain(next).filter_map(|page| page.document.layout.built_in()).map(str::to_owned);
        // Photos may be anywhere on a page that tells one moment only.
        let several = self.captions[at].iter().any(|(photo, ..)| *photo != leaf.photos[0]);
        let given = self.request.style.clone().filter(|_| chapter == 0);
        // The cover counts as the page before, so that another photo leads if there is one of nearly equal strength. Next to the
        // cover, another photo always leads.
        let cover = self.request.photos[self.outline.leaves[0].photos[0]].id.clone();
        let beside = at <= BESIDE_COVER && !photos.iter().any(|photo| photo.starred);
        if leaf.role == Role::Page && beside && photos.iter().any(|photo| photo.id == cover) {
            let shelf = self.shelf.some(&leaf.photos);
            let album = gallery(&photos, &shelf);
            let others = (0..photos.len()).filter(|&i| photos[i].id != cover);
            let lead = others.max_by(|&a, &b| album.lead(a).total_cmp(&album.lead(b)));
            drop(album);
            if let Some(lead) = lead {
                photos[lead].starred = true;
            }
        }
        let request = Request {
            seed: self.request.seed.wrapping_add(at as u32),
            panels: Some(photos.len()),
            layout: layout.map(LayoutRef::from),
            style: self.styles.get(&chapter).cloned().or(given),
            merge: Some(false),
            ordered: self.request.ordered.or(Some(several)),
            avoid: Avoid { layouts: near.collect(), styles: self.known_styles() },
            recent: if leaf.role == Role::Page { vec![vec![cover]] } else { Vec::new() },
            photos,
            ..self.request.clone()
        };
        let mut page = planned(&request, &self.shelf.some(&leaf.photos))?;
        self.styles.entry(chapter).or_insert_with(|| page.document.style.clone());
        self.add_cast(&mut page.document, &cast);
        page.document.words = self.words(at, &page.document);
        Ok(page)
    }

    /// Ids of the styles of chapters.
    fn known_styles(&self) -> Vec<String> {
        self.styles.values().filter_map(|style| style.id().map(str::to_owned)).collect()
    }

    fn words(&self, at: usize, page: &Document) -> Vec<TextItem> {
        let (leaf, language) = (&self.outline.leaves[at], self.wish.language.as_str());
        let photo = &self.request.photos[leaf.photos[0]];
        let told = self.captions[at].iter();
        let mut words: Vec<TextItem> = told
            .filter_map(|(photo, text, begins)| {
                let own = (*photo != leaf.photos[0]).then(|| self.request.photos[*photo].id.as_str());
                narration::caption(page, own, (text, *begins), language)
            })
            .collect();
        match leaf.role {
            Role::Cover => {
                words.extend(narration::title(
                    page,
                    photo,
                    (&self.title.0, &self.title.1),
                    (language, false),
                ));
            }
            Role::End => {
                let low = page.panels.len() > 1;
                words.extend(narration::title(page, photo, (&self.phrases.end, ""), (language, low)));
            }
            Role::Full | Role::Page => {}
        }
        if leaf.role != Role::Cover {
            words.push(narration::number(page, at + 1));
        }
        words
    }

    /// Photos with a clear face for the end page: three, or none. They come from different parts of the album.
    fn cast(&self, closing: usize) -> Vec<usize> {
        let suits = layout::find(CAST).is_ok_and(|layout| layout.good_for(self.request.page.aspect()));
        let photos = &self.request.photos;
        let target = Target { round: true, ..Target::of_aspect(1.0) };
        // The rate of the face that a close crop shows. Shut eyes and turned heads lower it.
        let face = |photo: &PhotoMeta| {
            let crop = closeup(photo, &target, 0)?;
            let within = |face: &Subject| {
                let part = |at: f64, from: f64, length: f64| (0.0..1.0).contains(&((at - from) / length));
                part(face.x + face.width / 2.0, crop.x, crop.width)
                    && part(face.y + face.height / 2.0, crop.y, crop.height)
            };
            let clear = |face: &&Subject| {
                face.label == FACE && face.score >= CAST_SCORE && face.height >= CAST_FACE && within(face)
            };
            let rate = |face: &Subject| face.height * face.score * face.clearness();
            photo.subjects.iter().filter(clear).map(rate).max_by(f64::total_cmp)
        };
        // A photo that has its own page needs no other place.
        let alone: Vec<usize> = self
            .outline
            .leaves
            .iter()
            .filter(|leaf| leaf.photos.len() == 1)
            .map(|leaf| leaf.photos[0])
            .collect();
        let rate = |i: usize| face(&photos[i]).map(|rate| if alone.contains(&i) { 0.5 * rate } else { rate });
        let shown: Vec<usize> = self.outline.leaves.iter().flat_map(|leaf| leaf.photos.clone()).collect();
        let parts = 3;
        let mut cast = Vec::new();
        for part in 0..parts {
            let (from, to) = (part * photos.len() / parts, (part + 1) * photos.len() / parts);
            let rated = (from..to)
                .filter(|&i| i != closing && shown.contains(&i))
                .filter_map(|i| Some((i, rate(i)?)));
            let clear = rated.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i);
            cast.extend(clear);
        }
        if suits && cast.len() == parts { cast } else { Vec::new() }
    }

    /// Puts close crops of the cast onto the last panels of the end page.
    fn add_cast(&self, page: &mut Document, cast: &[usize]) {
        let Ok(template) = page.template() else { return };
        let panels = layout::resolve(&template, page.page.aspect(), &page.page);
        let first = page.panels.len().saturating_sub(cast.len());
        for ((panel, &photo), resolved) in page.panels[first..].iter_mut().zip(cast).zip(&panels[first..]) {
            let photo = &self.request.photos[photo];
            let target = Target { round: true, ..Target::of_aspect(resolved.bounds.aspect()) };
            panel.photo = Some(photo.id.clone());
            panel.crop = closeup(photo, &target, 0);
            panel.faces = faces_of(photo);
            panel.edited = true;
        }
        if !cast.is_empty() {
            page.order = page.panels.iter().filter_map(|panel| panel.photo.clone()).collect();
        }
    }
}

/// Returns the indices of the photos in time order. Photos without a date follow the dated photos of their place, or come last.
/// On request, the given order is preserved.
fn in_time(request: &Request, places: &HashMap<String, String>) -> Vec<usize> {
    let mut order: Vec<usize> = (0..request.photos.len()).collect();
    if request.ordered == Some(true) {
        return order;
    }
    let place = |i: usize| {
        places.get(&request.photos[i].id).map(|place| place.trim()).filter(|place| !place.is_empty())
    };
    let taken = |i: usize| Some(Moment::parse(request.photos[i].taken.as_deref()?)?.seconds);
    let mut last: HashMap<&str, i64> = HashMap::new();
    for (place, moment) in order.iter().filter_map(|&i| Some((place(i)?, taken(i)?))) {
        last.entry(place).and_modify(|last| *last = moment.max(*last)).or_insert(moment);
    }
    let behind = |i: usize| last.get(place(i)?).copied();
    order.sort_by_key(|&i| (taken(i).or_else(|| behind(i)).unwrap_or(i64::MAX), taken(i).is_none()));
    order
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::planning::seen_on;
    use crate::layout::PageSettings;
    use inkpanel_model::sheets::renumber;
    use std::collections::HashSet;

    fn photo(i: usize) -> PhotoMeta {
        let face = Subject {
            x: 0.4,
            y: 0.2,
            width: 0.15,
            height: 0.2,
            label: FACE.into(),
            score: 0.9,
            points: None,
            expression: None,
            light: None,
        };
        PhotoMeta {
            fingerprint: (i as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15),
            taken: Some(format!("2026:06:{:02} {:02}:{:02}:00", 9 + i / 10, 9 + i % 10, i)),
            subjects: if i.is_multiple_of(4) { vec![face] } else { Vec::new() },
            starred: i == 17,
            ..PhotoMeta::unmeasured(&format!("p{i:02}"), 3000, if i.is_multiple_of(3) { 4200 } else { 2000 })
        }
    }

    fn request(count: usize) -> Request {
        Request {
            seed: 3,
            photos: (0..count).map(photo).collect(),
            page: PageSettings::default(),
            ..Request::default()
        }
    }

    fn made(request: Request, wish: Wish) -> Vec<BookPage> {
        let shelf = Shelf::new(request.photos.len());
        let mut book = Book::new(request, wish, &shelf, 1000).unwrap();
        while book.step().unwrap() {}
        book.pages()
    }

    fn texts(page: &BookPage) -> Vec<&str> {
        page.planned.document.words.iter().map(|word| word.text.as_str()).collect()
    }

    #[test]
    fn a_book_has_a_cover_chapters_numbers_and_an_end() {
        let places = HashMap::from([("p10".to_owned(), "Sintra".to_owned())]);
        let pages = made(request(40), Wish { title: "Portugal".into(), places, ..Wish::default() });
        assert!((8..=10).contains(&pages.len()), "{}", pages.len());
        assert_eq!(texts(&pages[0]), ["Portugal", "9–12 June 2026"]);
        assert_eq!(pages[1].role, Role::Page);
        assert_eq!(texts(&pages[1])[0], "First day.");
        assert!(pages.iter().any(|page| texts(page).contains(&"Second day. Sintra.")));
        assert!(texts(pages.last().unwrap()).starts_with(&["The end"]));
        for (i, page) in pages.iter().enumerate().skip(1) {
            assert!(texts(page).contains(&(i + 1).to_string().as_str()));
            assert_eq!(page.planned.document.style, pages[0].planned.document.style);
        }
        // Every photo is on one page, except the photo of the cover and close crops of faces.
        let mut shown: Vec<&str> = Vec::new();
        for page in &pages[1..] {
            let whole = page.planned.document.panels.iter().filter(|panel| !panel.edited);
            shown.extend(whole.filter_map(|panel| panel.photo.as_deref()));
        }
        assert_eq!((shown.len(), shown.iter().collect::<HashSet<_>>().len()), (40, 40));
        let cast = pages.last().unwrap().planned.document.panels.iter().filter(|panel| panel.edited).count();
        assert_eq!(cast, 3);
        for pair in pages[1..].windows(2) {
            let [a, b] = [0, 1].map(|i| &pair[i].planned.document.layout);
            assert!(a != b || a.built_in() == Some(SINGLE), "{a:?}");
        }
    }

    #[test]
    fn the_photo_of_the_cover_neither_follows_it_nor_leads_a_page() {
        // The faces of photos 0, 4, 8 and so on are equal.
        let mut led = 0;
        for seed in 0..6 {
            let mut request = Request { seed, ..request(20) };
            request.photos[17].starred = false;
            let pages = made(request, Wish::default());
            let cover = pages[0].planned.document.panels[0].photo.clone();
            assert_ne!(cover.as_deref(), Some("p00"));
            let leads = |page: &&BookPage| {
                page.role == Role::Page && seen_on(&page.planned.document).first() == cover.as_ref()
            };
            led += pages[1..].iter().filter(leads).count();
        }
        assert!(led <= 1, "{led} of 6");
    }

    #[test]
    fn another_photo_leads_the_page_next_to_the_cover() {
        for seed in 0..6 {
            let mut request = Request { seed, ..request(12) };
            let face = request.photos[4].subjects.clone();
            for (i, photo) in request.photos.iter_mut().enumerate() {
                photo.subjects = if i == 2 { face.clone() } else { Vec::new() };
            }
            let pages = made(request, Wish::default());
            let shown = |page: &BookPage| seen_on(&page.planned.document);
            assert_eq!(shown(&pages[0]), ["p02"]);
            assert!(shown(&pages[1])[1..].contains(&"p02".to_owned()), "{:?}", shown(&pages[1]));
        }
    }

    #[test]
    fn photos_without_a_date_follow_their_place() {
        let mut request = request(4);
        request.photos[0].taken = None;
        request.photos[1].taken = None;
        let places = HashMap::from([("p01", "Sintra"), ("p02", "Sintra"), ("p03", "Évora")]);
        let places = places.into_iter().map(|(id, place)| (id.to_owned(), place.to_owned())).collect();
        assert_eq!(in_time(&request, &places), [2, 1, 3, 0]);
        assert_eq!(in_time(&request, &HashMap::new()), [2, 3, 0, 1]);
        request.ordered = Some(true);
        assert_eq!(in_time(&request, &places), [0, 1, 2, 3]);
    }

    #[test]
    fn each_chapter_may_have_its_own_style() {
        let pages = made(request(40), Wish { styles: Styles::Chapters, ..Wish::default() });
        let of = |chapter: usize| -> HashSet<String> {
            let own = pages.iter().filter(|page| page.chapter == chapter);
            own.map(|page| serde_json::to_string(&page.planned.document.style).unwrap()).collect()
        };
        assert!((0..4).all(|chapter| of(chapter).len() == 1));
        assert_eq!((0..4).flat_map(of).collect::<HashSet<_>>().len(), 4);
    }

    #[test]
    fn the_same_wish_gives_the_same_book() {
        let pages = || made(request(25), Wish::default());
        assert_eq!(pages(), pages());
    }

    #[test]
    fn small_books_and_bad_wishes() {
        for count in 1..8 {
            let pages = made(request(count), Wish::default());
            let shown: HashSet<&str> = pages[1..]
                .iter()
                .flat_map(|page| {
                    page.planned.document.panels.iter().filter_map(|panel| panel.photo.as_deref())
                })
                .collect();
            assert_eq!(shown.len(), count);
        }
        let new = |count, pages| {
            let wish = Wish { pages, ..Wish::default() };
            Book::new(request(count), wish, &Shelf::new(count), 1000).map(|book| book.len())
        };
        assert_eq!(new(0, None).unwrap_err().code(), "no-photos");
        assert_eq!(new(9, Some(2)).unwrap_err().code(), "invalid-document");
        assert_eq!(new(40, Some(6)).unwrap(), 6);
    }

    #[test]
    fn numbers_follow_their_pages() {
        let mut page = made(request(12), Wish::default()).swap_remove(1).planned.document;
        assert!(renumber(&mut page, 7) && !renumber(&mut page, 7));
        assert!(page.words.iter().any(|word| word.text == "7"));
    }
}
