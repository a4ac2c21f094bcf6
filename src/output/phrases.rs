//! What a comic's reader says itself: the names of its buttons and of what is on the page. A language is a file of `languages/`.

use crate::error::Result;
use serde::Deserialize;

use super::comic::wrong;

/// The files of `languages/`.
const LANGUAGES: [(&str, &str); 6] = [
    ("en", include_str!("languages/en.json")),
    ("de", include_str!("languages/de.json")),
    ("es", include_str!("languages/es.json")),
    ("fr", include_str!("languages/fr.json")),
    ("ja", include_str!("languages/ja.json")),
    ("pt", include_str!("languages/pt.json")),
];

/// The words of a language. `{page}`, `{panel}` and `{panels}` stand for numbers.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Phrases {
    /// The way of reading that goes from panel to panel.
    pub panels: String,
    /// The one that shows whole pages.
    pub pages: String,
    /// The one that shows all that is said and seen as text.
    pub text: String,
    /// Whether pictures that move do so.
    pub motion: String,
    /// What the three are called together.
    pub view: String,
    /// Back by a panel or a page.
    pub previous: String,
    /// On by a panel or a page.
    pub next: String,
    /// The name of a page.
    pub page: String,
    /// A page and what is on it.
    pub page_holds: String,
    /// The same of a page with one panel.
    pub page_holds_one: String,
    /// The name of a panel.
    pub panel: String,
    /// The same where its page is known.
    pub panel_short: String,
    /// What a panel shows of which no more is known.
    pub photo: String,
    /// What a panel without a photo shows.
    pub empty: String,
    /// What narration is called.
    pub caption: String,
    /// What somebody says.
    pub balloon: String,
    /// A sound.
    pub effect: String,
    /// The table of contents of an EPUB book.
    pub contents: String,
    /// How the comic can be used, for those who choose it by that.
    pub summary: String,
}

impl Phrases {
    /// The words of a language, a BCP 47 tag such as `pt-BR`; English where there are none.
    ///
    /// # Errors
    /// `invalid-document` where the file of a language is broken, which a test knows.
    pub fn of(language: &str) -> Result<Self> {
        let wanted = language.split('-').next().unwrap_or_default();
        let found = LANGUAGES.iter().find(|(code, _)| code.eq_ignore_ascii_case(wanted));
        let (code, json) = found.unwrap_or(&LANGUAGES[0]);
        serde_json::from_str(json).map_err(|error| wrong(code, error.to_string()))
    }

    /// What a page is called and holds.
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

    /// The name of a panel of a page that is known.
    #[must_use]
    pub fn panel_alone(&self, panel: usize) -> String {
        self.panel_short.replace("{panel}", &(panel + 1).to_string())
    }

    /// What a word is called.
    #[must_use]
    pub fn word(&self, kind: super::telling::WordKind) -> &str {
        use super::telling::WordKind;
        match kind {
            WordKind::Caption => &self.caption,
            WordKind::Balloon => &self.balloon,
            WordKind::Effect => &self.effect,
        }
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
