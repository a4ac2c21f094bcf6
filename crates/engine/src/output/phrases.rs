//! Interface texts of a comic's reader: the names of its buttons and of the content of a page. A language is
//! a file of `languages/`.

use crate::error::Result;
use crate::page::language::texts_in;
use serde::Deserialize;

/// The files of `languages/`.
const LANGUAGES: [(&str, &str); 6] = [
    ("en", include_str!("languages/en.json")),
    ("de", include_str!("languages/de.json")),
    ("es", include_str!("languages/es.json")),
    ("fr", include_str!("languages/fr.json")),
    ("ja", include_str!("languages/ja.json")),
    ("pt", include_str!("languages/pt.json")),
];

/// The texts of a language. `{page}`, `{panel}` and `{panels}` are placeholders for numbers.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Phrases {
    /// Button of the guided view, panel by panel.
    pub panels: String,
    /// Button for the view of whole pages.
    pub pages: String,
    /// Button that shows all content as text.
    pub text: String,
    /// Switch of animated panels.
    pub motion: String,
    /// Name of the group of three views.
    pub view: String,
    /// Button to the previous panel or page.
    pub previous: String,
    /// Button to the next panel or page.
    pub next: String,
    /// The name of a page.
    pub page: String,
    /// A page and its number of panels.
    pub page_holds: String,
    /// A page with one panel.
    pub page_holds_one: String,
    /// The name of a panel.
    pub panel: String,
    /// A panel without the page number.
    pub panel_short: String,
    /// A panel with unknown content.
    pub photo: String,
    /// A panel without a photo.
    pub empty: String,
    /// Name of a caption.
    pub caption: String,
    /// Name of a balloon.
    pub balloon: String,
    /// A sound.
    pub effect: String,
    /// The table of contents of an EPUB book.
    pub contents: String,
    /// Accessibility summary of the comic.
    pub summary: String,
}

impl Phrases {
    /// Texts of a language, a BCP 47 tag such as `pt-BR`. English if the language is not available.
    ///
    /// # Errors
    /// `invalid-document` if the file of a language is damaged. A test checks all files.
    pub fn of(language: &str) -> Result<Self> {
        texts_in(language, &LANGUAGES)
    }

    /// Name of a page with its number of panels.
    #[must_use]
    pub fn page_with(&self, page: usize, panels: usize) -> String {
        let phrase = if panels == 1 { &self.page_holds_one } else { &self.page_holds };
        phrase.replace("{page}", &(page + 1).to_string()).replace("{panels}", &panels.to_string())
    }

    /// The name of a page, counted from 0.
    #[must_use]
    pub fn page_name(&self, page: usize) -> String {
        self.page.replace("{page}", &(page + 1).to_string())
    }

    /// The name of a panel, both counted from 0.
    #[must_use]
    pub fn panel_name(&self, page: usize, panel: usize) -> String {
        self.panel.replace("{page}", &(page + 1).to_string()).replace("{panel}", &(panel + 1).to_string())
    }

    /// Returns the name of a panel with a known position.
    #[must_use]
    pub fn panel_alone(&self, panel: usize) -> String {
        self.panel_short.replace("{panel}", &(panel + 1).to_string())
    }
}

/// The languages that there are.
pub fn languages() -> impl Iterator<Item = &'static str> {
    LANGUAGES.iter().map(|(code, _)| *code)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_language_says_all_with_its_numbers() {
        let english = Phrases::of("en").unwrap();
        for code in languages() {
            let said = Phrases::of(code).unwrap();
            assert_eq!(said, Phrases::of(&format!("{code}-XX")).unwrap());
            assert!(code == "en" || said != english, "{code}");
            for (phrase, places) in [
                (&said.page, &["{page}"][..]),
                (&said.page_holds, &["{page}", "{panels}"]),
                (&said.page_holds_one, &["{page}"]),
                (&said.panel, &["{page}", "{panel}"]),
                (&said.panel_short, &["{panel}"]),
            ] {
                assert!(places.iter().all(|place| phrase.contains(place)), "{code}: {phrase}");
            }
        }
        assert_eq!(Phrases::of("tlh").unwrap(), english);
        assert_eq!(english.page_with(1, 1), "Page 2, one panel");
        assert_eq!(english.panel_name(0, 2), "Page 1, panel 3");
    }
}
