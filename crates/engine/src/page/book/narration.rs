//! The texts of a book: title, captions with day, place and time of day, page numbers and the last words.

use super::phrases::Phrases;
use crate::framing::{PhotoMeta, Subject};
use crate::page::Document;
use crate::page::words::model::{TextItem, TextKind};
use crate::plan::book::{Outline, Role};
use crate::plan::moments::{Moment, date};
use std::collections::HashMap;

/// Maximum number of captions of a page.
const MOST_CAPTIONS: usize = 2;
/// A shorter pause in seconds gets no caption.
const PAUSE: i64 = 3 * 3600;
/// Maximum span in days for counting days. Captions of longer albums show dates.
const COUNTED: i64 = 10;
/// Height of an em in page widths: of page numbers, of captions that begin a chapter, and of others.
const NUMBER: f64 = 0.017;
const HEADING: f64 = 0.03;
const CAPTION: f64 = 0.021;
/// Maximum height of an em of a title, and of the text below it, in page widths.
const TITLE: f64 = 0.15;
const SUBTITLE: f64 = 0.042;
/// Width of titles in page widths, width of a capital letter in ems, and height of a line in ems.
const WIDTH: f64 = 0.88;
const LETTER: f64 = 0.5;
const LINE: f64 = 1.1;
/// Distance of a title from the edge of the page, in page widths.
const EDGE: f64 = 0.05;
/// Cost of a title that is not in the middle of the page, as a share of a face.
const BESIDE: f64 = 0.02;

/// The time and place of each photo of an album, in its order.
pub(super) struct Told<'a> {
    /// When each photo was taken.
    pub(super) moments: Vec<Option<Moment>>,
    /// The place of each photo; empty if it is unknown.
    pub(super) places: Vec<&'a str>,
}

impl<'a> Told<'a> {
    pub(super) fn new(photos: &[PhotoMeta], places: &'a HashMap<String, String>) -> Self {
        let moments = photos.iter().map(|photo| photo.taken.as_deref().and_then(Moment::parse)).collect();
        let place = |photo: &PhotoMeta| places.get(&photo.id).map_or("", |place| place.trim());
        let mut places: Vec<&str> = photos.iter().map(place).collect();
        // One photo from somewhere else on the way is not a change of place.
        for i in 1..places.len().saturating_sub(1) {
            if places[i - 1] == places[i + 1] && !places[i - 1].is_empty() {
                places[i] = places[i - 1];
            }
        }
        Self { moments, places }
    }

    /// First and last day.
    fn days(&self) -> Option<(i64, i64)> {
        let days = || self.moments.iter().flatten().map(|moment| moment.day());
        Some((days().min()?, days().max()?))
    }

    /// The places in their order, each once.
    fn different_places(&self) -> Vec<&'a str> {
        let mut different: Vec<&str> = Vec::new();
        for place in self.places.iter().filter(|place| !place.is_empty()) {
            if !different.contains(place) {
                different.push(place);
            }
        }
        different
    }

    /// The title, and the line below it, which may be empty. `given`: the title that the user chose.
    pub(super) fn title(&self, given: &str, phrases: &Phrases) -> (String, String) {
        // The days and places of a few photos do not describe the book.
        let most = |known: usize| 3 * known >= 2 * self.moments.len();
        let days = self.days().filter(|_| most(self.moments.iter().flatten().count()));
        let dates = days.map(|(from, to)| phrases.dates(from, to)).unwrap_or_default();
        let known = most(self.places.iter().filter(|place| !place.is_empty()).count());
        let places = if known { phrases.places(&self.different_places()) } else { String::new() };
        let title =
            [given.trim(), &places, &dates, &phrases.untitled].into_iter().find(|text| !text.is_empty());
        let title = title.unwrap_or_default().to_owned();
        let below = if title == dates { String::new() } else { dates };
        (title, below)
    }

    /// The caption of each photo that has one, by page, and whether it begins a chapter.
    pub(super) fn captions(
        &self,
        outline: &Outline,
        title: &str,
        phrases: &Phrases,
    ) -> Vec<Vec<(usize, String, bool)>> {
        let days = self.days();
        let several = days.is_some_and(|(from, to)| from != to);
        let counted = days.is_some_and(|(from, to)| to - from < COUNTED);
        // The first caption of each year has it, if there are several.
        let mut year = days.and_then(|(from, to)| (date(from).0 == date(to).0).then(|| date(from).0));
        let known = self.different_places();
        // A book about one place has it in its title.
        let titled = known.len() == 1 && title.to_lowercase().contains(&known[0].to_lowercase());
        let mut place = if titled { known[0] } else { "" };
        let (mut chapter, mut last) = (None, None::<Moment>);
        let mut pages = Vec::new();
        for leaf in &outline.leaves {
            let mut told = Vec::new();
            for &photo in leaf.photos.iter().filter(|_| matches!(leaf.role, Role::Page | Role::Full)) {
                let begins = chapter != Some(outline.chapters[photo]);
                let (moment, here) = (self.moments[photo], self.places[photo]);
                let mut parts: Vec<String> = Vec::new();
                if let (true, true, Some(moment), Some((first, _))) = (begins, several, moment, days) {
                    let nth = phrases.nth_day(moment.day() - first).filter(|_| counted);
                    let own = date(moment.day()).0;
                    let with_year = year.replace(own) != Some(own);
                    // No line ends between a day and its month.
                    let dated = || phrases.day(moment.day(), with_year).replacen(' ', "\u{a0}", 1);
                    parts.push(nth.map_or_else(dated, str::to_owned));
                }
                if !here.is_empty() && here != place {
                    parts.push(here.to_owned());
                }
                if let (true, Some(before), Some(now)) = (parts.is_empty() && !begins, last, moment) {
                    let (was, is) = (phrases.part(before.hour()), phrases.part(now.hour()));
                    if now.seconds - before.seconds >= PAUSE && was != is && before.day() == now.day() {
                        parts.push(is.to_owned());
                    }
                }
                if !parts.is_empty() && (begins || told.len() < MOST_CAPTIONS) {
                    told.push((photo, phrases.sentences(&parts), begins));
                }
                chapter = Some(outline.chapters[photo]);
                place = if here.is_empty() { place } else { here };
                last = moment.or(last);
            }
            pages.push(told);
        }
        pages
    }
}

/// A caption on the panel that shows a photo, or on the first panel without one.
pub(super) fn caption(
    page: &Document,
    photo: Option<&str>,
    (text, begins): (&str, bool),
    language: &str,
) -> Option<TextItem> {
    let panel = match photo {
        Some(photo) => page.panels.iter().position(|panel| panel.photo.as_deref() == Some(photo))?,
        None => *page.reading_order().first()?,
    };
    let photo = page.panels.get(panel)?.photo.as_deref()?;
    Some(TextItem {
        panel: Some(panel),
        photo: Some(photo.to_owned()),
        auto: Some(true),
        language: in_language(language),
        size: Some(if begins { HEADING } else { CAPTION }),
        ..of_book(text)
    })
}

/// A caption of a book.
fn of_book(text: &str) -> TextItem {
    let item = TextItem::new(TextKind::Caption, text);
    TextItem { made: true, book: true, ..item }
}

fn in_language(language: &str) -> Option<String> {
    (!language.is_empty()).then(|| language.to_owned())
}

/// The number of a page, from 1, at its lower edge.
pub(super) fn number(page: &Document, number: usize) -> TextItem {
    let aspect = page.page.aspect();
    let middle = (page.page.margin / 2.0).max(NUMBER * 0.7);
    TextItem {
        x: Some(0.5),
        y: Some(1.0 - middle * aspect),
        size: Some(NUMBER),
        boxless: true,
        auto: Some(false),
        number: true,
        ..of_book(&number.to_string())
    }
}

/// A large text and a smaller one below it, at the upper or the lower edge of the page, wherever they hide least of the
/// subjects of the first panel. A single line may be beside the middle. `low`: the lower edge is taken.
pub(super) fn title(
    page: &Document,
    photo: &PhotoMeta,
    (text, below): (&str, &str),
    (language, low): (&str, bool),
) -> Vec<TextItem> {
    let aspect = page.page.aspect();
    let (size, lines) = fitted(text);
    let smaller = if below.is_empty() { 0.0 } else { SUBTITLE };
    let high = (lines as f64 * size + smaller) * LINE;
    let band = (high + EDGE) * aspect;
    let own = if lines == 1 && below.is_empty() { (1.1 * size * wide(text)).min(WIDTH) } else { WIDTH };
    let side = EDGE + own / 2.0;
    let starts = [EDGE * aspect, 1.0 - (high + EDGE) * aspect];
    let mut spot = (f64::INFINITY, 0.5, starts[0]);
    for &start in &starts[..if low { 1 } else { 2 }] {
        let from = if start < 0.5 { 0.0 } else { 1.0 - band };
        for x in [0.5, side, 1.0 - side] {
            let hidden = covered(page, photo, (x - own / 2.0, x + own / 2.0), (from, from + band));
            // The middle is the usual place.
            let hidden = if (x - 0.5).abs() > 1e-9 { 1.5 * hidden + BESIDE } else { hidden };
            if hidden < spot.0 {
                spot = (hidden, x, start);
            }
        }
    }
    let (_, x, start) = spot;
    let word = |text: &str, y: f64, size: f64, font: &str| TextItem {
        x: Some(x),
        y: Some(y),
        width: Some(own),
        size: Some(size),
        font: Some(font.to_owned()),
        boxless: true,
        auto: Some(false),
        language: in_language(language),
        ..of_book(text)
    };
    let middle = start + lines as f64 * size * LINE / 2.0 * aspect;
    let mut words = vec![word(text, middle, size, "bangers")];
    if !below.is_empty() {
        let y = start + (lines as f64 * size * LINE + smaller * LINE * 0.6) * aspect;
        words.push(word(below, y, SUBTITLE, "comic-neue-bold"));
    }
    words
}

/// The width of a line in ems.
fn wide(text: &str) -> f64 {
    text.chars().map(|c| if c > '\u{2e80}' { 1.0 } else { LETTER }).sum()
}

/// The height of an em that a title gets, and its number of lines.
fn fitted(text: &str) -> (f64, usize) {
    let longest = text.split_whitespace().map(wide).fold(LETTER, f64::max);
    let whole = wide(text).max(LETTER);
    let sized = |lines: usize| {
        // Words do not part, so lines are not equally full.
        let slack = if lines > 1 { 0.8 } else { 1.0 };
        (WIDTH * 0.94 * lines as f64 * slack / whole).min(WIDTH * 0.94 / longest).min(TITLE)
    };
    // More lines only if they make the title clearly larger.
    (2..=3)
        .map(|lines| (sized(lines), lines))
        .fold((sized(1), 1), |best, next| if next.0 > 1.35 * best.0 { next } else { best })
}

/// How much of the subjects of the first panel lies in a part of the page, faces with hair most.
fn covered(page: &Document, photo: &PhotoMeta, across: (f64, f64), down: (f64, f64)) -> f64 {
    let Some(crop) = page.panels.first().and_then(|panel| panel.crop) else { return 0.0 };
    let shared = |(from, length): (f64, f64), (low, high): (f64, f64)| {
        ((from + length).min(high) - from.max(low)).max(0.0) / length.max(1e-6)
    };
    let part = |subject: &Subject| {
        let x = ((subject.x - crop.x) / crop.width, subject.width / crop.width);
        let y = ((subject.y - crop.y) / crop.height, subject.height / crop.height);
        let weight = if subject.label == crate::framing::FACE { 4.0 } else { 1.0 };
        let alive = if subject.is_alive() { 1.0 } else { 0.3 };
        shared(x, across) * shared(y, down) * weight * alive * (subject.width * subject.height).sqrt()
    };
    photo.marked().map(|subject| part(&subject.grown())).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::framing::{Crop, FACE};
    use crate::page::request::Request;
    use crate::page::shuffle::plan;
    use crate::plan::book::Leaf;

    fn photos(taken: &[&str]) -> Vec<PhotoMeta> {
        let photo = |(i, taken): (usize, &&str)| PhotoMeta {
            taken: (!taken.is_empty()).then(|| format!("2026:{taken}:00")),
            ..PhotoMeta::unmeasured(&format!("p{i}"), 3000, 2000)
        };
        taken.iter().enumerate().map(photo).collect()
    }

    fn told(taken: &[&str], places: &[&str], chapters: &[usize], title: &str) -> Vec<String> {
        let photos = photos(taken);
        let places =
            places.iter().enumerate().map(|(i, place)| (format!("p{i}"), (*place).to_owned())).collect();
        let page = Leaf { role: Role::Page, chapter: 0, photos: (0..photos.len()).collect() };
        let outline = Outline { leaves: vec![page], chapters: chapters.to_vec() };
        let phrases = Phrases::of("en").unwrap();
        let told = Told::new(&photos, &places).captions(&outline, title, &phrases);
        told.into_iter().flatten().map(|(photo, text, _)| format!("{photo} {text}")).collect()
    }

    #[test]
    fn a_day_begins_with_its_number_and_its_place() {
        let taken = ["06:09 10:00", "06:09 11:00", "06:10 09:00"];
        assert_eq!(
            told(&taken, &["Lisbon", "Lisbon", "Sintra"], &[0, 0, 1], "Portugal"),
            ["0 First day. Lisbon.", "2 Second day. Sintra.",]
        );
        // A place is left out if it is unknown or in the title.
        assert_eq!(told(&taken, &["", "", ""], &[0, 0, 1], ""), ["0 First day.", "2 Second day."]);
        assert_eq!(
            told(&taken, &["Rome", "Rome", "Rome"], &[0, 0, 1], "Rome 2026"),
            ["0 First day.", "2 Second day.",]
        );
    }

    #[test]
    fn one_photo_from_elsewhere_is_not_a_change_of_place() {
        let taken = ["06:09 10:00", "06:09 10:10", "06:09 10:20", "06:09 10:30", "06:09 10:40"];
        assert_eq!(
            told(&taken, &["Lisbon", "Algés", "Lisbon", "Sintra", "Sintra"], &[0; 5], ""),
            ["0 Lisbon.", "3 Sintra."]
        );
    }

    #[test]
    fn a_pause_tells_the_time_of_day_and_a_long_album_its_dates() {
        assert_eq!(
            told(&["06:09 09:00", "06:09 12:30", "06:09 20:10"], &[], &[0, 0, 0], "Trip"),
            ["1 At noon.", "2 In the evening.",]
        );
        assert_eq!(
            told(&["03:09 09:00", "06:10 12:30"], &[], &[0, 1], ""),
            ["0 9\u{a0}March.", "1 10\u{a0}June."]
        );
        assert!(told(&["", ""], &[], &[0, 0], "").is_empty());
    }

    #[test]
    fn the_first_date_of_each_year_has_it() {
        let taken = |year: i32, day: &str| PhotoMeta {
            taken: Some(format!("{year}:{day} 10:00:00")),
            ..PhotoMeta::unmeasured(&format!("p{year}"), 3000, 2000)
        };
        let photos = [taken(2023, "11:02"), taken(2024, "04:11"), taken(2024, "05:01")];
        let page = Leaf { role: Role::Page, chapter: 0, photos: vec![0, 1, 2] };
        let outline = Outline { leaves: vec![page], chapters: vec![0, 1, 2] };
        let places = HashMap::new();
        let told = Told::new(&photos, &places).captions(&outline, "", &Phrases::of("en").unwrap());
        let texts: Vec<&str> = told[0].iter().map(|(_, text, _)| text.as_str()).collect();
        assert_eq!(texts, ["2\u{a0}November 2023.", "11\u{a0}April 2024.", "1\u{a0}May."]);
    }

    #[test]
    fn a_title_is_the_users_or_of_places_or_of_days() {
        let title = |given: &str, places: &[(&str, &str)]| {
            let places = places.iter().map(|(id, place)| ((*id).to_owned(), (*place).to_owned())).collect();
            let photos = photos(&["06:09 10:00", "06:10 11:00"]);
            Told::new(&photos, &places).title(given, &Phrases::of("en").unwrap())
        };
        let days = "9–10 June 2026".to_owned();
        assert_eq!(title("Holiday", &[]), ("Holiday".into(), days.clone()));
        assert_eq!(
            title(" ", &[("p0", "Lisbon"), ("p1", "Sintra")]),
            ("Lisbon and Sintra".into(), days.clone())
        );
        assert_eq!(title("", &[]), (days, String::new()));
        let nothing = Told { moments: vec![None], places: vec![""] };
        assert_eq!(nothing.title("", &Phrases::of("de").unwrap()).0, "Unsere Fotos");
        let few = Told { moments: vec![Moment::parse("2026:06:09 10:00:00"), None], places: vec!["", ""] };
        assert_eq!(few.title("", &Phrases::of("de").unwrap()).0, "Unsere Fotos");
        let one = Told { moments: vec![None; 3], places: vec!["Lisbon", "", ""] };
        assert_eq!(one.title("", &Phrases::of("de").unwrap()).0, "Unsere Fotos");
    }

    /// A photo with a face in a box of `[x, y, width, height]`, and a page that shows all of it.
    fn portrait([x, y, width, height]: [f64; 4]) -> (PhotoMeta, Document) {
        let mut photo = PhotoMeta::unmeasured("p0", 2000, 3000);
        let label = FACE.to_owned();
        let (points, expression, light) = (None, None, None);
        photo.find([Subject { label, score: 0.9, x, y, width, height, points, expression, light }]);
        let request =
            Request { layout: Some("splash".into()), photos: vec![photo.clone()], ..Request::default() };
        let mut page = plan(&request).unwrap();
        page.panels[0].crop = Some(Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 });
        (photo, page)
    }

    #[test]
    fn hair_above_a_face_counts_as_covered() {
        let (photo, page) = portrait([0.4, 0.3, 0.15, 0.2]);
        let hidden = |across, high| covered(&page, &photo, across, (0.0, high));
        assert!(hidden((0.0, 1.0), 0.25) > 0.05, "the band ends between hair and face");
        assert!(hidden((0.0, 1.0), 0.15) < 1e-9 && hidden((0.7, 1.0), 0.25) < 1e-9);
    }

    #[test]
    fn a_line_moves_aside_from_a_head_at_the_edge_of_the_page() {
        let at = |x: f64| {
            let (photo, page) = portrait([x, 0.1, 0.25, 0.2]);
            title(&page, &photo, ("The end", ""), ("en", true))[0].x.unwrap()
        };
        assert!(at(0.7) < 0.4 && at(0.05) > 0.6);
        assert!((at(0.375) - 0.5).abs() < 1e-9);
    }

    #[test]
    fn titles_fill_their_width_and_long_words_stay_whole() {
        let (short, one) = fitted("Rome");
        let (long, more) = fitted("A very long weekend on the islands of the north");
        assert!((short - TITLE).abs() < 1e-9 && one == 1 && more > 1 && long < short && long > 0.05);
        assert!(fitted("Donaudampfschifffahrtsgesellschaft").0 * LETTER * 34.0 <= WIDTH);
    }
}
