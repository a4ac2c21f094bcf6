//! Fixed-layout EPUB, after EPUB 3.3 and EPUB Region-Based Navigation 1.0. Each page is one image, with the
//! content and text of each panel over it. Readers with guided view zoom from panel to panel.
//!
//! No clock is used: the date of the book is the start of the ZIP epoch, and its identifier is a hash of its
//! content.

use super::comic::{Comic, File, Piece};
use super::markup::{escaped, short, with_readings};
use super::phrases::Phrases;
use super::telling::{ToldPage, ToldPanel, WordKind, tell, within};
use crate::error::Result;
use crate::layout::Bounds;
use crate::page::words::Letters;
use std::fmt::Write as _;

/// Content of the file `mimetype`, stored without compression.
pub const MEDIA_TYPE: &str = "application/epub+zip";
/// The first day that a ZIP file can name.
const MADE: &str = "1980-01-01T00:00:00Z";
const STYLE: &str = include_str!("epub.css");
const XML: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

/// The files of the book in order. `mimetype` is the first and must be stored uncompressed.
///
/// # Errors
/// As [`tell`].
pub fn write(comic: &Comic, letters: &Letters) -> Result<Vec<File>> {
    let phrases = Phrases::of(&comic.language)?;
    let pages = tell(comic, letters, &phrases)?;
    let book = Book { comic, phrases: &phrases, pages: &pages };
    let mut files = vec![
        File::text("mimetype", MEDIA_TYPE.to_owned()),
        File::text("META-INF/container.xml", container()),
    ];
    let texts: Vec<String> = (0..pages.len()).map(|page| book.page(page)).collect();
    files.push(File::text("EPUB/package.opf", book.package(&texts)));
    files.push(File::text("EPUB/nav.xhtml", book.navigation()));
    files.push(File::text("EPUB/regions.xhtml", book.regions()));
    files.push(File::text("EPUB/style.css", STYLE.to_owned()));
    for (page, text) in texts.into_iter().enumerate() {
        files.push(File::text(format!("EPUB/{}.xhtml", comic.page_name(page)), text));
    }
    for page in 0..pages.len() {
        files.push(File { name: format!("EPUB/{}", book.picture(page)), content: Piece::Picture(page) });
    }
    Ok(files)
}

struct Book<'b> {
    comic: &'b Comic,
    phrases: &'b Phrases,
    pages: &'b [ToldPage],
}

fn container() -> String {
    format!(
        "{XML}<container version=\"1.0\" xmlns=\"urn:oasis:names:tc:opendocument:xmlns:container\">\n\
         <rootfiles><rootfile full-path=\"EPUB/package.opf\" \
         media-type=\"application/oebps-package+xml\"/></rootfiles>\n</container>\n"
    )
}

impl Book<'_> {
    fn picture(&self, page: usize) -> String {
        format!("pictures/{}.{}", self.comic.page_name(page), self.comic.picture.ending())
    }

    /// A document in XHTML.
    fn document(&self, title: &str, head: &str, body: &str) -> String {
        let language = escaped(&self.comic.language);
        format!(
            "{XML}<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" \
             xmlns:epub=\"http://www.idpf.org/2007/ops\" lang=\"{language}\" xml:lang=\"{language}\">\n\
             <head>\n<meta charset=\"utf-8\"/>\n<title>{}</title>\n{head}</head>\n<body>\n{body}</body>\n</html>\n",
            escaped(title)
        )
    }

    fn page(&self, number: usize) -> String {
        let ToldPage { width, height, panels } = &self.pages[number];
        let name = self.phrases.page_name(number);
        let mut body = format!(
            "<main>\n<h1 class=\"unseen\"><span epub:type=\"pagebreak\" role=\"doc-pagebreak\" id=\"break\" \
             title=\"{}\"></span>{}</h1>\n<img src=\"{}\" width=\"{width}\" height=\"{height}\" alt=\"{}\"/>\n",
            number + 1,
            escaped(&name),
            self.picture(number),
            escaped(&self.phrases.page_with(number, panels.len())),
        );
        for (at, panel) in panels.iter().enumerate() {
            self.panel(&mut body, &self.pages[number], at, panel);
        }
        body.push_str("</main>\n");
        let head = format!(
            "<meta name=\"viewport\" content=\"width={width}, height={height}\"/>\n\
             <link rel=\"stylesheet\" type=\"text/css\" href=\"style.css\"/>\n"
        );
        let title = format!("{} – {name}", self.comic.title);
        self.document(&title, &head, &body)
    }

    fn panel(&self, body: &mut String, page: &ToldPage, at: usize, panel: &ToldPanel) {
        let bounds = panel.view(page);
        let place = |Bounds { x, y, width, height }: Bounds| {
            let [x, y, width, height] = [x, y, width, height].map(short);
            format!("left:{x}px;top:{y}px;width:{width}px;height:{height}px")
        };
        let _ = write!(
            body,
            "<section class=\"panel\" id=\"panel-{}\" aria-label=\"{}\" style=\"{}\">\n\
             <p class=\"unseen\">{}</p>\n",
            at + 1,
            escaped(&self.phrases.panel_alone(at)),
            place(bounds),
            escaped(&panel.shows),
        );
        for word in &panel.words {
            let inside = within(word.bounds, page);
            let inside = Bounds { x: inside.x - bounds.x, y: inside.y - bounds.y, ..inside };
            let _ = writeln!(
                body,
                "<p class=\"word\" dir=\"auto\" style=\"{};font-size:{}px\">{}</p>",
                place(inside),
                short(word.size.max(1.0)),
                with_readings(&word.pieces)
            );
        }
        body.push_str("</section>\n");
    }

    fn navigation(&self) -> String {
        let (contents, pages) = (escaped(&self.phrases.contents), escaped(&self.phrases.pages));
        let mut body = format!(
            "<nav epub:type=\"toc\" role=\"doc-toc\" aria-labelledby=\"contents\" id=\"toc\">\n\
             <h1 id=\"contents\">{contents}</h1>\n<ol>\n"
        );
        let mut list = String::new();
        for number in 0..self.pages.len() {
            let file = self.comic.page_name(number);
            let name = escaped(&self.phrases.page_name(number));
            let _ = writeln!(body, "<li><a href=\"{file}.xhtml\">{name}</a></li>");
            let _ = writeln!(list, "<li><a href=\"{file}.xhtml#break\">{}</a></li>", number + 1);
        }
        let _ = write!(
            body,
            "</ol>\n</nav>\n<nav epub:type=\"page-list\" role=\"doc-pagelist\" aria-labelledby=\"pages\" hidden=\"hidden\">\n\
             <h2 id=\"pages\">{pages}</h2>\n<ol>\n{list}</ol>\n</nav>\n"
        );
        self.document(&self.comic.title, "", &body)
    }

    /// Region-based navigation: rectangles of the panels in fractions of the page. Their content is included.
    fn regions(&self) -> String {
        let mut body = "<nav epub:type=\"region-based\" id=\"regions\">\n<ol>\n".to_owned();
        for (number, page) in self.pages.iter().enumerate() {
            let file = self.comic.page_name(number);
            let link = |bounds: Bounds| {
                let Bounds { x, y, width, height } = within(bounds, page);
                let (across, down) = (100.0 / f64::from(page.width), 100.0 / f64::from(page.height));
                let [x, y] = [(x, across), (y, down)].map(|(at, by)| short((at * by).min(100.0)));
                let [width, height] =
                    [(width, across), (height, down)].map(|(at, by)| short((at * by).clamp(0.01, 100.0)));
                format!("<a href=\"{file}.xhtml#xywh=percent:{x},{y},{width},{height}\"></a>")
            };
            for panel in &page.panels {
                let _ = write!(body, "<li epub:type=\"panel\">{}", link(panel.view(page)));
                if !panel.words.is_empty() {
                    body.push_str("\n<ol>\n");
                    for word in &panel.words {
                        let kind = match word.kind {
                            WordKind::Balloon => "balloon",
                            WordKind::Caption => "text-area",
                            WordKind::Effect => "sound-area",
                        };
                        let _ = writeln!(body, "<li epub:type=\"{kind}\">{}</li>", link(word.bounds));
                    }
                    body.push_str("</ol>\n");
                }
                body.push_str("</li>\n");
            }
        }
        body.push_str("</ol>\n</nav>\n");
        self.document(&self.comic.title, "", &body)
    }

    fn package(&self, texts: &[String]) -> String {
        let Self { comic, phrases, pages } = self;
        let (title, language) = (escaped(&comic.title), escaped(&comic.language));
        let identifier = identifier(comic, texts);
        let mut out = format!(
            "{XML}<package xmlns=\"http://www.idpf.org/2007/opf\" version=\"3.0\" unique-identifier=\"id\" \
             xml:lang=\"{language}\">\n<metadata xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n\
             <dc:identifier id=\"id\">{identifier}</dc:identifier>\n<dc:title>{title}</dc:title>\n\
             <dc:language>{language}</dc:language>\n<meta property=\"dcterms:modified\">{MADE}</meta>\n\
             <meta property=\"rendition:layout\">pre-paginated</meta>\n\
             <meta property=\"rendition:orientation\">auto</meta>\n\
             <meta property=\"rendition:spread\">auto</meta>\n"
        );
        for (property, value) in access(pages, phrases) {
            let _ = writeln!(out, "<meta property=\"schema:{property}\">{}</meta>", escaped(value));
        }
        out.push_str(
            "<meta property=\"pageBreakSource\">none</meta>\n</metadata>\n<manifest>\n\
             <item id=\"nav\" href=\"nav.xhtml\" media-type=\"application/xhtml+xml\" properties=\"nav\"/>\n\
             <item id=\"regions\" href=\"regions.xhtml\" media-type=\"application/xhtml+xml\" \
             properties=\"data-nav\"/>\n<item id=\"style\" href=\"style.css\" media-type=\"text/css\"/>\n",
        );
        let mut spine = String::new();
        for (number, page) in pages.iter().enumerate() {
            let name = comic.page_name(number);
            let cover = if number == 0 { " properties=\"cover-image\"" } else { "" };
            let (picture, kind) = (self.picture(number), comic.picture.media_type());
            let _ = write!(
                out,
                "<item id=\"{name}\" href=\"{name}.xhtml\" media-type=\"application/xhtml+xml\"/>\n\
                 <item id=\"picture-{name}\" href=\"{picture}\" media-type=\"{kind}\"{cover}/>\n"
            );
            // Two adjacent wide pages would be small.
            let alone = if page.width > page.height { " properties=\"rendition:spread-none\"" } else { "" };
            let _ = writeln!(spine, "<itemref idref=\"{name}\"{alone}/>");
        }
        let direction = if comic.is_rtl() { " page-progression-direction=\"rtl\"" } else { "" };
        let _ = write!(out, "</manifest>\n<spine{direction}>\n{spine}</spine>\n</package>\n");
        out
    }
}

/// Accessibility metadata of schema.org.
fn access<'p>(pages: &[ToldPage], phrases: &'p Phrases) -> Vec<(&'static str, &'p str)> {
    let all = pages.iter().flat_map(|page| &page.panels);
    let mut access = vec![
        ("accessMode", "visual"),
        ("accessMode", "textual"),
        ("accessModeSufficient", "visual,textual"),
        ("accessModeSufficient", "visual"),
        ("accessibilityFeature", "alternativeText"),
        ("accessibilityFeature", "structuralNavigation"),
        ("accessibilityFeature", "tableOfContents"),
        ("accessibilityFeature", "pageNavigation"),
        ("accessibilityFeature", "pageBreakMarkers"),
        ("accessibilityFeature", "readingOrder"),
        ("accessibilityHazard", "none"),
        ("accessibilitySummary", phrases.summary.as_str()),
    ];
    // If the content of every panel is known, the descriptions replace the picture.
    if all.into_iter().all(|panel| panel.known) {
        access.insert(3, ("accessModeSufficient", "textual"));
    }
    access
}

/// A stable identifier of the book: a UUID of version 8, whose bits are free to use (RFC 9562).
fn identifier(comic: &Comic, texts: &[String]) -> String {
    let mut hash = FNV_OFFSET;
    let parts = [&comic.title, &comic.language].into_iter().chain(texts);
    for byte in parts.flat_map(|text| text.bytes().chain([0])) {
        hash = (hash ^ u128::from(byte)).wrapping_mul(FNV_PRIME);
    }
    let hash = (hash & !(0xf << 76) & !(0x3 << 62)) | (0x8 << 76) | (0x2 << 62);
    let digits = format!("{hash:032x}");
    format!(
        "urn:uuid:{}-{}-{}-{}-{}",
        &digits[..8],
        &digits[8..12],
        &digits[12..16],
        &digits[16..20],
        &digits[20..]
    )
}

/// Offset basis of FNV-1a with 128 bits.
const FNV_OFFSET: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
const FNV_PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;
