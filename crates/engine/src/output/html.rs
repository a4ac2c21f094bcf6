//! One HTML file with a comic and its reader. Images are data URLs. Every panel is a region with its content
//! and text, in reading order. Its Content-Security-Policy blocks all network requests and allows only its
//! script, its style and embedded images. Without JavaScript it is a long page of images and text.

use super::comic::{Comic, Piece};
use super::markup::{escaped, points, short, with_readings};
use super::phrases::Phrases;
use super::telling::{ToldPage, ToldPanel, ToldWord, WordKind, tell};
use crate::error::Result;
use crate::layout::Bounds;
use crate::page::words::Letters;
use std::fmt::Write as _;

const STYLE: &str = include_str!("reader/reader.css");
const SCRIPT: &str = include_str!("reader/reader.js");

// `STYLE_HASH` and `SCRIPT_HASH`: the SHA-256 of both in base64, as a Content-Security-Policy names them.
include!(concat!(env!("OUT_DIR"), "/reader.rs"));

/// Size of the hole in the dimmed layer relative to the text item, so that the hole includes its outline.
const AROUND: f64 = 1.06;

/// Returns the file as pieces, in order. An image piece is replaced by its data URL.
///
/// # Errors
/// As [`tell`].
pub fn write(comic: &Comic, letters: &Letters) -> Result<Vec<Piece>> {
    let phrases = Phrases::of(&comic.language)?;
    let pages = tell(comic, letters, &phrases)?;
    let mut pieces = Vec::new();
    let mut text = head(comic);
    let mut moving = pages.len();
    for (number, page) in pages.iter().enumerate() {
        let name = phrases.page_name(number);
        let ToldPage { width, height, panels } = page;
        let alt = escaped(&phrases.page_with(number, panels.len()));
        let id = number + 1;
        let _ = write!(
            text,
            "<section class=\"page\" id=\"page-{id}\" aria-label=\"{name}\" data-size=\"{width} {height}\">\n\
             <h2>{name}</h2>\n<div class=\"frame\"><div class=\"sheet\">\n\
             <img width=\"{width}\" height=\"{height}\" alt=\"{alt}\" decoding=\"async\" src=\"",
            name = escaped(&name),
        );
        pieces.push(Piece::Text(std::mem::take(&mut text)));
        pieces.push(Piece::Picture(number));
        text.push_str("\">\n");
        open_shapes(&mut text, page);
        for place in &comic.pages[number].moving {
            let [x, y, wide, high] = [
                place.x * f64::from(*width),
                place.y * f64::from(*height),
                place.width * f64::from(*width),
                place.height * f64::from(*height),
            ]
            .map(short);
            let _ = write!(
                text,
                "<image class=\"moving\" x=\"{x}\" y=\"{y}\" width=\"{wide}\" height=\"{high}\" \
                 preserveAspectRatio=\"none\" href=\""
            );
            pieces.push(Piece::Text(std::mem::take(&mut text)));
            pieces.push(Piece::Picture(moving));
            text.push_str("\"/>\n");
            moving += 1;
        }
        shapes(&mut text, page, id);
        text.push_str("</div></div>\n<ol class=\"panels\">\n");
        for (at, panel) in panels.iter().enumerate() {
            told(&mut text, (number, at), panel, page, &phrases);
        }
        text.push_str("</ol>\n</section>\n");
    }
    foot(&mut text, &phrases, moving > pages.len());
    pieces.push(Piece::Text(text));
    Ok(pieces)
}

fn head(comic: &Comic) -> String {
    let (language, title) = (escaped(&comic.language), escaped(&comic.title));
    let rtl = if comic.is_rtl() { " data-rtl=\"true\"" } else { "" };
    format!(
        "<!doctype html>\n<html lang=\"{language}\"{rtl}>\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; \
         style-src 'sha256-{STYLE_HASH}'; script-src 'sha256-{SCRIPT_HASH}'; base-uri 'none'; form-action 'none'\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1, viewport-fit=cover\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<meta name=\"generator\" content=\"Inkpanel\">\n\
         <title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n\
         <header><h1 dir=\"auto\">{title}</h1></header>\n<main id=\"comic\">\n"
    )
}

/// `moves`: there are animated panels, so the reader needs a stop button.
fn foot(text: &mut String, phrases: &Phrases, moves: bool) {
    let say = |phrase: &str| escaped(phrase);
    let motion = if moves {
        let motion = say(&phrases.motion);
        format!("<button type=\"button\" id=\"motion\" aria-pressed=\"true\">{motion}</button>\n")
    } else {
        String::new()
    };
    let _ = write!(
        text,
        "</main>\n<footer class=\"bar\">\n\
         <div class=\"views\" role=\"group\" aria-label=\"{view}\">\n\
         <button type=\"button\" data-view=\"panels\" aria-pressed=\"false\">{panels}</button>\n\
         <button type=\"button\" data-view=\"pages\" aria-pressed=\"false\">{pages}</button>\n\
         <button type=\"button\" data-view=\"text\" aria-pressed=\"false\">{words}</button>\n</div>\n{motion}\
         <span id=\"place\" aria-hidden=\"true\"></span>\n\
         <div class=\"steps\">\n\
         <button type=\"button\" id=\"previous\" aria-label=\"{previous}\">{BACK}</button>\n\
         <button type=\"button\" id=\"next\" aria-label=\"{next}\">{ON}</button>\n</div>\n\
         <div id=\"progress\" aria-hidden=\"true\"></div>\n\
         <p id=\"says\" class=\"unseen\" role=\"status\"></p>\n</footer>\n\
         <script type=\"module\">{SCRIPT}</script>\n</body>\n</html>\n",
        view = say(&phrases.view),
        panels = say(&phrases.panels),
        pages = say(&phrases.pages),
        words = say(&phrases.text),
        previous = say(&phrases.previous),
        next = say(&phrases.next),
    );
}

/// Arrows of the buttons.
const BACK: &str = "<svg viewBox=\"0 0 24 24\" aria-hidden=\"true\"><path d=\"M15 5l-7 7 7 7\"/></svg>";
const ON: &str = "<svg viewBox=\"0 0 24 24\" aria-hidden=\"true\"><path d=\"M9 5l7 7-7 7\"/></svg>";

/// Opens the layer of a page for animated pictures and shapes.
fn open_shapes(text: &mut String, ToldPage { width, height, .. }: &ToldPage) {
    let _ = writeln!(
        text,
        "<svg viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" aria-hidden=\"true\" \
         focusable=\"false\">"
    );
}

/// The mask that dims the page. Its holes are the current panel and its text.
fn shapes(text: &mut String, page: &ToldPage, id: usize) {
    let ToldPage { width, height, panels } = page;
    let _ = writeln!(
        text,
        "<mask id=\"mask-{id}\"><rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\
         <g class=\"hole\"></g></mask>\
         <rect class=\"veil\" width=\"{width}\" height=\"{height}\" mask=\"url(#mask-{id})\"/>"
    );
    for (at, panel) in panels.iter().enumerate() {
        let corners = points(&panel.outline, &short);
        let _ = write!(text, "<g class=\"shape\" data-panel=\"{at}\"><polygon points=\"{corners}\"/>");
        for word in &panel.words {
            word_shape(text, word);
        }
        text.push_str("</g>\n");
    }
    text.push_str("</svg>\n");
}

fn word_shape(text: &mut String, ToldWord { kind, bounds, .. }: &ToldWord) {
    let Bounds { x, y, width, height } = *bounds;
    let (x, y) = (x + width / 2.0, y + height / 2.0);
    let (a, b) = (width / 2.0 * AROUND, height / 2.0 * AROUND);
    let [x, y, a, b] = match kind {
        WordKind::Balloon => [x, y, a, b],
        _ => [x - a, y - b, 2.0 * a, 2.0 * b],
    }
    .map(short);
    let _ = match kind {
        WordKind::Balloon => write!(text, "<ellipse cx=\"{x}\" cy=\"{y}\" rx=\"{a}\" ry=\"{b}\"/>"),
        _ => write!(text, "<rect x=\"{x}\" y=\"{y}\" width=\"{a}\" height=\"{b}\"/>"),
    };
}

/// A panel as text.
fn told(text: &mut String, (page, at): (usize, usize), panel: &ToldPanel, on: &ToldPage, phrases: &Phrases) {
    let Bounds { x, y, width, height } = panel.view(on);
    let [x, y, width, height] = [x, y, width, height].map(short);
    let name = phrases.panel_name(page, at);
    let shows = escaped(&panel.shows);
    let _ = write!(
        text,
        "<li><section class=\"panel\" id=\"page-{}-panel-{}\" aria-label=\"{}: {shows}\" \
         data-box=\"{x} {y} {width} {height}\">\n<h3 aria-hidden=\"true\">{}</h3>\n<p class=\"shows\">{shows}</p>\n",
        page + 1,
        at + 1,
        escaped(&name),
        escaped(&phrases.panel_alone(at)),
    );
    for word in &panel.words {
        let kind = match word.kind {
            WordKind::Caption => "caption",
            WordKind::Balloon => "balloon",
            WordKind::Effect => "effect",
        };
        let _ = writeln!(
            text,
            "<p class=\"word {kind}\"><span class=\"kind\">{}</span> <span class=\"said\" dir=\"auto\">{}</span></p>",
            escaped(phrases.word(word.kind)),
            with_readings(&word.pieces),
        );
    }
    text.push_str("</section></li>\n");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reader_ends_neither_its_script_nor_its_style() {
        assert!(!SCRIPT.contains("</script") && !SCRIPT.contains("<!--") && !STYLE.contains("</"));
        // Browsers normalise line ends before hashing, so other line ends would not match.
        assert!(!SCRIPT.contains('\r') && !STYLE.contains('\r'));
    }

    #[test]
    fn the_reader_asks_nobody() {
        for address in ["http:", "https:", "//cdn", "import(", "import ", "fetch(", "url("] {
            assert!(!SCRIPT.contains(address) && !STYLE.contains(address), "{address}");
        }
    }
}
