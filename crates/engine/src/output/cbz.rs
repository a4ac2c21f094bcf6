//! A comic archive: one image per page, `ComicInfo.xml` (version 2.0) for comic libraries, and `comic.acbf`
//! (ACBF 1.1) for readers with guided view and text.

use super::comic::{Comic, File, Piece};
use super::markup::{escaped, points};
use super::phrases::Phrases;
use super::telling::{ToldPage, ToldWord, WordKind, tell};
use crate::error::Result;
use crate::layout::Bounds;
use crate::page::words::Letters;
use std::fmt::Write as _;

const XML: &str = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n";

/// Returns the files of the archive: first the pages, in reading order.
///
/// # Errors
/// As [`tell`].
pub fn write(comic: &Comic, letters: &Letters) -> Result<Vec<File>> {
    let phrases = Phrases::of(&comic.language)?;
    let pages = tell(comic, letters, &phrases)?;
    let mut files: Vec<File> = (0..pages.len())
        .map(|page| File { name: picture(comic, page), content: Piece::Picture(page) })
        .collect();
    files.push(File::text("ComicInfo.xml", info(comic, &pages)));
    files.push(File::text("comic.acbf", acbf(comic, &pages, &phrases)));
    Ok(files)
}

fn picture(comic: &Comic, page: usize) -> String {
    format!("{}.{}", comic.page_name(page), comic.picture.ending())
}

/// Returns whether a page is a double page: it is landscape, and others are portrait.
fn is_double(page: &ToldPage, pages: &[ToldPage]) -> bool {
    page.width > page.height && pages.iter().any(|page| page.width <= page.height)
}

fn info(comic: &Comic, pages: &[ToldPage]) -> String {
    let mut out = format!(
        "{XML}<ComicInfo xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns:xsd=\"http://www.w3.org/2001/XMLSchema\">\n  <Title>{}</Title>\n  <PageCount>{}</PageCount>\n  \
         <LanguageISO>{}</LanguageISO>\n  <Manga>{}</Manga>\n  <Pages>\n",
        escaped(&comic.title),
        pages.len(),
        escaped(&comic.language),
        if comic.is_rtl() { "YesAndRightToLeft" } else { "No" },
    );
    for (number, page) in pages.iter().enumerate() {
        let kind = if number == 0 { "FrontCover" } else { "Story" };
        let _ = writeln!(
            out,
            "    <Page Image=\"{number}\" Type=\"{kind}\" DoublePage=\"{}\" ImageWidth=\"{}\" ImageHeight=\"{}\" />",
            is_double(page, pages),
            page.width,
            page.height
        );
    }
    out.push_str("  </Pages>\n</ComicInfo>\n");
    out
}

/// Writes a coordinate as whole pixels, as readers require.
fn whole(value: f64) -> String {
    format!("{}", value.round() as i64)
}

fn acbf(comic: &Comic, pages: &[ToldPage], phrases: &Phrases) -> String {
    let (title, language) = (escaped(&comic.title), escaped(&comic.language));
    let cover = picture(comic, 0);
    // An element of version 1.2. Readers of version 1.1 ignore it.
    let direction = if comic.is_rtl() { "<reading-direction>RTL</reading-direction>\n" } else { "" };
    let mut out = format!(
        "{XML}<ACBF xmlns=\"http://www.fictionbook-lib.org/xml/acbf/1.1\">\n<meta-data>\n<book-info>\n\
         <author><nickname>Inkpanel</nickname></author>\n<book-title lang=\"{language}\">{title}</book-title>\n\
         <genre>other</genre>\n<annotation lang=\"{language}\"><p>{title}</p></annotation>\n\
         <coverpage><image href=\"{cover}\"/></coverpage>\n\
         <languages><text-layer lang=\"{language}\" show=\"false\"/></languages>\n{direction}</book-info>\n\
         <publish-info><publisher>Inkpanel</publisher><publish-date value=\"1980-01-01\">1980</publish-date>\
         </publish-info>\n<document-info><author><nickname>Inkpanel</nickname></author>\
         <creation-date value=\"1980-01-01\">1980</creation-date></document-info>\n</meta-data>\n<body>\n"
    );
    for (number, page) in pages.iter().enumerate() {
        let paper = comic.pages[number].document.page.paper_rgb();
        let [r, g, b] = paper;
        let _ = write!(
            out,
            "<page bgcolor=\"#{r:02x}{g:02x}{b:02x}\">\n<title lang=\"{language}\">{}</title>\n\
             <image href=\"{}\"/>\n<text-layer lang=\"{language}\">\n",
            escaped(&phrases.page_name(number)),
            picture(comic, number),
        );
        for word in page.panels.iter().flat_map(|panel| &panel.words) {
            area(&mut out, word);
        }
        out.push_str("</text-layer>\n");
        for panel in &page.panels {
            let _ = writeln!(out, "<frame points=\"{}\"/>", points(&panel.outline, &whole));
        }
        out.push_str("</page>\n");
    }
    out.push_str("</body>\n</ACBF>\n");
    out
}

fn area(out: &mut String, ToldWord { kind, text, bounds, .. }: &ToldWord) {
    let Bounds { x, y, width, height } = *bounds;
    let corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)];
    // `sound` is in an unpublished version, so sound effects are signs.
    let kind = match kind {
        WordKind::Caption => "commentary",
        WordKind::Balloon => "speech",
        WordKind::Effect => "sign",
    };
    let _ = writeln!(
        out,
        "<text-area points=\"{}\" type=\"{kind}\"><p>{}</p></text-area>",
        points(&corners, &whole),
        escaped(text)
    );
}
