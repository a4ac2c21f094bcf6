//! Books of the command line: an album with a cover, chapters, captions, page numbers and an end page.

use crate::destination::Output;
use crate::drawing::Kind;
use crate::{
    Chosen, Complaint, How, NO_OUTPUT, add_subjects, album, check_strict, done, drawing, import_all, name,
    plans, print, projects, star, style_value, telling, used_photos, write_album,
};
use clap::ValueEnum;
use inkpanel::document::limits::MOST_SHEETS;
use inkpanel::framing::PhotoMeta;
use inkpanel::page::Document;
use inkpanel::page::book::{self, BookPage, Wish, naming};
use inkpanel::page::import::Imported;
use inkpanel::page::request::{Families, Request};
use inkpanel::page::words::given::GivenFonts;
use inkpanel::page::words::place::{self, Known};
use inkpanel::plan::Shelf;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Examples of the help.
pub(crate) const HELP: &str = "\
Examples:
  inkpanel book photos/ -o book.pdf
  inkpanel book photos/ --styles chapters -o book.epub

Exit codes:
  0  Success. Skipped files are listed on standard error.
  1  Bad input, or a warning with --strict. The reason is on standard error, and no file is written.
  2  Wrong usage: an option, its value, or a settings file.";

/// How the styles of a book are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Styles {
    /// One style for all pages.
    One,
    /// Another style for each day.
    Chapters,
}

/// Options of `book`.
#[derive(clap::Args)]
pub(crate) struct Book {
    #[command(flatten)]
    chosen: Chosen,
    /// Title on the cover. [default: the name of the folder, or the places or days of the photos]
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    /// One style for the whole book, or another one for each day.
    #[arg(long, value_name = "HOW", value_enum, default_value = "one")]
    styles: Styles,
    /// Number of pages with cover and end page, from 3. [default: as many as the photos need]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(book::MIN_PAGES as i64..=MOST_SHEETS as i64))]
    pages: Option<u32>,
    #[command(flatten)]
    how: How,
    /// Output file, or - for standard output.
    ///
    /// A book: .pdf, .html, .epub or .cbz. Pictures: a name with a number, such as page-%02d.png. A project with the original
    /// photos: .inkpanel.
    #[arg(short, long, required_unless_present_any = ["json", "save_document"])]
    output: Option<PathBuf>,
    /// Photos or folders. Names of folders within one folder are places.
    pub(crate) files: Vec<PathBuf>,
}

/// Makes a book.
///
/// # Errors
/// A sentence for bad input.
pub(crate) fn make(made: &Book) -> Result<(), Complaint> {
    let Book { chosen, how, files: given, .. } = made;
    if how.progress == "json" {
        telling::as_json();
    }
    let output = made.output.as_deref().map(|path| Output::new(path, how.format.as_deref())).transpose()?;
    if let Some(output) = &output {
        how.printing.check(Kind::of(&output.named)?)?;
        if chosen.json && album::is_standard(&output.path) {
            return Err("--json and the book cannot both go to standard output".into());
        }
        if how.skip_existing && output.exists() {
            let event = json!({ "event": "skipped", "file": output.path.display().to_string() });
            telling::step(&event, Some(format!("{}: exists already, skipped", output.path.display())));
            return Ok(());
        }
        if matches!(Kind::of(&output.named), Ok(Kind::Shots(_))) {
            return Err(format!("{}: a shot list needs a saved project", output.path.display()));
        }
    } else if !chosen.json && how.save_document.is_none() {
        return Err(NO_OUTPUT.into());
    }
    if given.is_empty() {
        return Err("say which photos, or which folder".into());
    }
    let style = chosen.style.as_deref().map(style_value).transpose()?;
    let is_pdf = output.as_ref().is_some_and(|output| matches!(Kind::of(&output.named), Ok(Kind::Pdf)));
    let mut page = chosen.paper.settings(is_pdf)?;
    page.rtl |= is_rtl(how.printing.language());
    let fonts = how.printing.fonts()?;
    let mut photos = import_all(&album::files(given)?);
    let looked = !chosen.no_detect && add_subjects(&mut photos, chosen.models.as_deref());
    star(&mut photos, &chosen.star);
    let request = Request {
        seed: chosen.seed.unwrap_or(1),
        photos: used_photos(chosen, &photos),
        page,
        style,
        ordered: chosen.as_given.then_some(true),
        figures: Some(false),
        within: Families { layouts: Vec::new(), styles: chosen.style_family.clone() },
        ..Request::default()
    };
    let wish = Wish {
        title: made.title.clone().unwrap_or_else(|| title(given)),
        language: how.printing.language().to_owned(),
        places: places(given, &photos),
        pages: made.pages.map(|pages| pages as usize),
        styles: match made.styles {
            Styles::One => book::Styles::One,
            Styles::Chapters => book::Styles::Chapters,
        },
    };
    let used: Vec<String> = request.photos.iter().map(|photo| photo.id.clone()).collect();
    let (pages, title) = planned(request, wish, &photos, &fonts)?;
    if let Some(wanted) = made.pages.filter(|wanted| *wanted as usize != pages.len()) {
        telling::note(None, &format!("there are {} pages, not {wanted}", pages.len()));
    }
    let drawn: Vec<Document> = pages.iter().map(|page| page.planned.document.clone()).collect();
    drawing::tell_missing(&drawn, &fonts)?;
    check_strict(how)?;
    let album = projects::Album {
        name: title,
        pages: &drawn,
        photos: &photos,
        used: used.iter().map(String::as_str).collect(),
        looked,
    };
    let written = write_album(&album, &fonts, output.as_ref(), (how, true, chosen))?;
    if chosen.json {
        print(&told(&album.name, &pages, &photos)?)?;
    }
    done(&written)
}

/// The pages of a book with their text in its place, and the title.
fn planned(
    request: Request,
    wish: Wish,
    photos: &[(PathBuf, Imported)],
    fonts: &GivenFonts,
) -> Result<(Vec<BookPage>, String), Complaint> {
    let complain = |error: inkpanel::Error| error.to_string();
    let shelf = Shelf::new(request.photos.len());
    let mut book = book::Book::new(request, wish, &shelf, MOST_SHEETS).map_err(complain)?;
    let (title, of) = (book.title().to_owned(), book.len());
    while book.step().map_err(complain)? {
        telling::step(&json!({ "event": "planned", "done": book.done(), "of": of }), None);
    }
    let known = |id: &str| {
        let photo = photos.iter().find(|(_, photo)| photo.meta.id == id);
        photo.map(|(_, photo)| Known::from(&photo.meta)).unwrap_or_default()
    };
    let mut pages = book.pages();
    for page in &mut pages {
        let document = &mut page.planned.document;
        let letters = fonts.letters(&document.words).map_err(complain)?;
        place::settle(document, known, &letters).map_err(complain)?;
    }
    Ok((pages, title))
}

/// Returns the plan as JSON, as `render` does, with the title of the book, and the purpose and chapter of
/// each page.
fn told(title: &str, pages: &[BookPage], photos: &[(PathBuf, Imported)]) -> Result<Value, Complaint> {
    let page = |page: &BookPage| {
        let mut told = plans::told_page(&page.planned, photos)?;
        told["role"] = json!(page.role.name());
        told["chapter"] = json!(page.chapter + 1);
        let texts = page.planned.document.words.iter().filter(|word| !word.number);
        told["texts"] = texts.map(|word| word.text.as_str()).collect();
        Ok::<_, Complaint>(told)
    };
    let pages = pages.iter().map(page).collect::<Result<Vec<_>, _>>()?;
    Ok(json!({ "title": title, "pages": pages }))
}

/// Whether a language is written from right to left.
fn is_rtl(language: &str) -> bool {
    let code = language.split('-').next().unwrap_or_default().to_lowercase();
    ["ar", "dv", "fa", "he", "ps", "sd", "ug", "ur", "yi"].contains(&code.as_str())
}

/// The name of the only folder, if it says something.
fn title(given: &[PathBuf]) -> String {
    let [folder] = given else { return String::new() };
    let folder = folder.is_dir().then(|| std::fs::canonicalize(folder).ok()).flatten();
    folder.as_deref().map(|folder| naming::said_by(name(folder)).to_owned()).unwrap_or_default()
}

/// Places by the folders of photos, which lie within the folders that were given.
fn places(given: &[PathBuf], photos: &[(PathBuf, Imported)]) -> std::collections::HashMap<String, String> {
    let inside = |path: &Path| {
        let parent = path.parent()?;
        (!given.iter().any(|folder| folder == parent)).then(|| name(parent).to_owned())
    };
    let folders: Vec<(&PhotoMeta, String)> =
        photos.iter().map(|(path, photo)| (&photo.meta, inside(path).unwrap_or_default())).collect();
    naming::places(folders.iter().map(|(photo, folder)| (photo.id.as_str(), folder.as_str())))
}
