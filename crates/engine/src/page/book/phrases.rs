//! Texts of a book in the languages of the app: days, dates and times of day. A language is a file of `languages/`.

use crate::error::Result;
use crate::page::language::texts_in;
use crate::plan::moments::date;
use serde::Deserialize;
use std::collections::HashMap;

/// The files of `languages/`.
const LANGUAGES: [(&str, &str); 6] = [
    ("en", include_str!("languages/en.json")),
    ("de", include_str!("languages/de.json")),
    ("es", include_str!("languages/es.json")),
    ("fr", include_str!("languages/fr.json")),
    ("ja", include_str!("languages/ja.json")),
    ("pt", include_str!("languages/pt.json")),
];

/// Last hour of each time of day, from the morning on. The night is the rest.
const PARTS: [i64; 4] = [10, 13, 17, 21];

/// Dates in the format of the user. The texts of the language replace missing ones.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "BookDates", optional_fields))]
pub struct Dates {
    /// The days of the book, for its cover.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub span: String,
    /// Dates for captions, by day such as `2026-06-09`.
    #[cfg_attr(test, ts(as = "Option<_>", optional))]
    pub days: HashMap<String, String>,
}

/// The texts of a language. Words in braces are placeholders.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Phrases {
    /// The first ten days.
    days: Vec<String>,
    /// The twelve months.
    months: Vec<String>,
    /// Morning, noon, afternoon, evening and night.
    parts: Vec<String>,
    /// A date without its year.
    short: String,
    /// A date.
    date: String,
    /// Days of one month.
    month: String,
    /// Dates of one year.
    year: String,
    /// Two dates of different years.
    span: String,
    /// Two places.
    two: String,
    /// More than two places.
    more: String,
    /// Title of a book without dates and places.
    pub(super) untitled: String,
    /// Text of the last page.
    pub(super) end: String,
    /// Sign between two sentences, and after the last.
    stop: String,
    /// Dates that the caller formatted.
    #[serde(skip)]
    written: Dates,
}

impl Phrases {
    /// Texts of a language, a BCP 47 tag such as `pt-BR`. English if the language is not available.
    pub(super) fn of(language: &str) -> Result<Self> {
        texts_in(language, &LANGUAGES)
    }

    /// Returns the texts with dates in the format of the user.
    pub(super) fn with(self, written: Dates) -> Self {
        Self { written, ..self }
    }

    /// Returns the words for a day of a trip, from 0; `None` beyond the tenth.
    pub(super) fn nth_day(&self, day: i64) -> Option<&str> {
        usize::try_from(day).ok().and_then(|day| self.days.get(day)).map(String::as_str)
    }

    /// The time of day of an hour.
    pub(super) fn part(&self, hour: i64) -> &str {
        let at = match hour {
            0..4 => PARTS.len(),
            _ => PARTS.iter().position(|last| hour <= *last).unwrap_or(PARTS.len()),
        };
        self.parts.get(at).map_or("", String::as_str)
    }

    /// A date for a caption. `with_year`: whether it has its year. Dates of the caller replace it.
    pub(super) fn day(&self, day: i64, with_year: bool) -> String {
        let (year, month, date) = date(day);
        let written = self.written.days.get(&format!("{year:04}-{month:02}-{date:02}"));
        let form = if with_year { &self.date } else { &self.short };
        written.cloned().unwrap_or_else(|| self.filled(form, day))
    }

    /// The days of an album.
    pub(super) fn dates(&self, from: i64, to: i64) -> String {
        if !self.written.span.is_empty() {
            return self.written.span.clone();
        }
        let ((first, month, _), (last, until, _)) = (date(from), date(to));
        if from == to {
            return self.filled(&self.date, from);
        }
        if (first, month) == (last, until) {
            let text = self.month.replace("{from}", &date(from).2.to_string());
            return self.filled(&text.replace("{to}", &date(to).2.to_string()), to);
        }
        let (pattern, form) =
            if first == last { (&self.year, &self.short) } else { (&self.span, &self.date) };
        let text = pattern.replace("{from}", &self.filled(form, from));
        self.filled(&text.replace("{to}", &self.filled(form, to)), to)
    }

    fn filled(&self, pattern: &str, day: i64) -> String {
        let (year, month, day) = date(day);
        let month = self.months.get(month as usize - 1).map_or("", String::as_str);
        pattern
            .replace("{day}", &day.to_string())
            .replace("{month}", month)
            .replace("{year}", &year.to_string())
    }

    /// The places of an album; empty without any.
    pub(super) fn places(&self, places: &[&str]) -> String {
        match places {
            [] => String::new(),
            [one] => (*one).to_owned(),
            [a, b] => self.two.replace("{a}", a).replace("{b}", b),
            [a, ..] => self.more.replace("{a}", a),
        }
    }

    /// Sentences of a caption.
    pub(super) fn sentences(&self, parts: &[String]) -> String {
        let mut text = parts.join(&self.stop);
        if !text.is_empty() && !text.ends_with(['.', '。', '!', '?']) {
            text.push_str(self.stop.trim_end());
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_language_has_all_texts() {
        for (code, _) in LANGUAGES {
            let phrases = Phrases::of(code).unwrap();
            assert_eq!(
                (phrases.days.len(), phrases.months.len(), phrases.parts.len()),
                (10, 12, 5),
                "{code}"
            );
            for (from, to) in [(20_000, 20_000), (20_000, 20_002), (20_000, 20_040), (20_000, 20_400)] {
                let told = phrases.dates(from, to);
                assert!(!told.contains(['{', '}']), "{told}");
            }
        }
        assert_eq!(Phrases::of("xx").unwrap(), Phrases::of("en-GB").unwrap());
    }

    #[test]
    fn dates_are_written_as_people_do() {
        let told = |language: &str, from, to| Phrases::of(language).unwrap().dates(from, to);
        // 20 613 days after 1970 began is 9 June 2026.
        assert_eq!(told("en", 20_613, 20_613), "9 June 2026");
        assert_eq!(told("en", 20_613, 20_615), "9–11 June 2026");
        assert_eq!(told("de", 20_613, 20_643), "9. Juni – 9. Juli 2026");
        assert_eq!(told("fr", 20_613, 20_978), "9 juin 2026 – 9 juin 2027");
        assert_eq!(told("ja", 20_613, 20_615), "2026年6月9日〜11日");
        let days = HashMap::from([("2026-06-09".into(), "June 9".into())]);
        let dates = Dates { span: "June 9 – 11, 2026".into(), days };
        let written = Phrases::of("en").unwrap().with(dates);
        assert_eq!(written.dates(20_613, 20_615), "June 9 – 11, 2026");
        assert_eq!([20_613, 20_614].map(|day| written.day(day, false)), ["June 9", "10 June"]);
        assert_eq!([20_613, 20_614].map(|day| written.day(day, true)), ["June 9", "10 June 2026"]);
        let english = Phrases::of("en").unwrap();
        assert_eq!(
            [4, 10, 11, 14, 21, 22, 2].map(|hour| english.part(hour)),
            [
                "In the morning",
                "In the morning",
                "At noon",
                "In the afternoon",
                "In the evening",
                "At night",
                "At night",
            ]
        );
        assert_eq!(english.sentences(&["Second day".into(), "Sintra".into()]), "Second day. Sintra.");
        assert_eq!(english.places(&["Lisbon", "Sintra"]), "Lisbon and Sintra");
    }
}
