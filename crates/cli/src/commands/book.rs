//! Books of the command line: an album with a cover, chapters, captions, page numbers and an end page.

use super::render::{NO_OUTPUT, Writing, write_album};
use crate::args::{Chosen, How};
use crate::destination::{Output, print_json};
use crate::format::Format;
use crate::input::{self, name};
use crate::photos::Photos;
use crate::run::{self, Run};
use crate::{CliError, detectors, drawing, plans, projects};
use clap::ValueEnum;
use inkpanel::{BookOptions, BookPlan};
use inkpanel_engine::document::limits::MOST_SHEETS;
use inkpanel_engine::page::Document;
use inkpanel_engine::page::book::{self, BookPage, naming};
use inkpanel_engine::raster::location::{Location, location};
use rayon::prelude::*;
use serde_json::{Value, json};
use std::collections::HashMap;
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
    /// Leave out the places of the photos, which come from folder names and from GPS data.
    #[arg(long)]
    no_places: bool,
    #[command(flatten)]
    how: How,
    /// Output file, or - for standard output.
    ///
    /// A book: .pdf, .html, .epub or .cbz. Pictures: a name with a number, such as page-%02d.png. A project with the original
    /// photos: .inkpanel.
    #[arg(short, long, required_unless_present_any = ["json", "save_document"])]
    output: Option<PathBuf>,
    /// Photos or folders. Names of several folders, or of folders within one folder, are places.
    pub(crate) files: Vec<PathBuf>,
}

/// Makes a book.
///
/// # Errors
/// A sentence for bad input.
pub(crate) fn make(run: &Run, made: &Book) -> Result<(), CliError> {
    let Book { chosen, how, files: given, .. } = made;
    let output = made.output.as_deref().map(|path| Output::new(path, how.format.as_deref())).transpose()?;
    if let Some(output) = &output {
        how.printing.check(Format::of(&output.named)?)?;
        if chosen.json && run::is_standard(&output.path) {
            return Err("--json and the book cannot both go to standard output".into());
        }
        if how.skip_existing && output.exists() {
            let event = json!({ "event": "skipped", "file": output.path.display().to_string() });
            run.report.step(&event, Some(format!("{}: exists already, skipped", output.path.display())));
            return Ok(());
        }
        if matches!(Format::of(&output.named), Ok(Format::Shots(_))) {
            return Err(format!("{}: a shot list needs a saved project", output.path.display()).into());
        }
    } else if !chosen.json && how.save_document.is_none() {
        return Err(NO_OUTPUT.into());
    }
    if given.is_empty() {
        return Err("say which photos, or which folder".into());
    }
    let is_pdf = output.as_ref().is_some_and(|output| matches!(Format::of(&output.named), Ok(Format::Pdf)));
    let mut page = chosen.paper.settings(is_pdf)?;
    page.rtl |= is_rtl(how.printing.language());
    let options = chosen.options(run, page)?;
    let fonts = how.printing.fonts(run)?;
    let mut photos = Photos::read(run, input::files(run, given)?)?;
    photos.album.set_fonts(fonts.clone());
    let looked = chosen.prepare(&mut photos);
    let used = photos.choose(&options);
    let ids: Vec<String> = used.iter().map(|photo| photo.id.clone()).collect();
    let mut book = BookOptions::new()
        .title(&made.title.clone().unwrap_or_else(|| title(given)))
        .language(how.printing.language())
        .style_by_chapter(made.styles == Styles::Chapters)
        .places(if made.no_places {
            HashMap::new()
        } else {
            places(given, &photos, chosen.models.as_deref())
        });
    if let Some(pages) = made.pages {
        book = book.pages(pages as usize);
    }
    let progress = &mut |done: usize, of: usize| {
        run.report.step(&json!({ "event": "planned", "done": done, "of": of }), None);
    };
    let BookPlan { title, pages } = photos.album.plan_book(&options, &book, used, progress)?;
    if let Some(wanted) = made.pages.filter(|wanted| *wanted as usize != pages.len()) {
        run.report.note(None, &format!("there are {} pages, not {wanted}", pages.len()));
    }
    let drawn: Vec<Document> = pages.iter().map(|page| page.planned.document.clone()).collect();
    drawing::tell_missing(run, &drawn, &fonts)?;
    run.report.check_strict(how.strict)?;
    let album = projects::Album { name: title, pages: &drawn, photos: &photos, used: &ids, looked };
    let written = write_album(&album, &fonts, output.as_ref(), &Writing { how, several: true, chosen })?;
    if chosen.json {
        print_json(&told(&album.name, &pages, &photos)?)?;
    }
    run.report.done(&written)
}

/// Returns the plan as JSON, as `render` does, with the title of the book, and the purpose and chapter of
/// each page.
fn told(title: &str, pages: &[BookPage], photos: &Photos<'_>) -> Result<Value, CliError> {
    let page = |page: &BookPage| {
        let mut told = plans::told_page(&page.planned.document, Some(&page.planned.score), photos)?;
        told["role"] = json!(page.role.name());
        told["chapter"] = json!(page.chapter + 1);
        let texts = page.planned.document.words.iter().filter(|word| !word.number);
        told["texts"] = texts.map(|word| word.text.as_str()).collect();
        Ok::<_, CliError>(told)
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

/// Places by the names of folders, without the only given one. Other photos have the places of their GPS data.
fn places(given: &[PathBuf], photos: &Photos<'_>, models: Option<&Path>) -> HashMap<String, String> {
    let inside = |path: &Path| {
        let parent = path.parent()?;
        (given != [parent]).then(|| name(parent).to_owned())
    };
    let folders: Vec<(&str, String)> = photos
        .iter()
        .map(|(path, photo)| (photo.meta.id.as_str(), inside(path).unwrap_or_default()))
        .collect();
    let mut places = naming::places(folders.iter().map(|(photo, folder)| (*photo, folder.as_str())));
    let unknown: Vec<(&Path, &str)> = photos
        .iter()
        .map(|(path, photo)| (path, photo.meta.id.as_str()))
        .filter(|(_, id)| places.get(*id).is_none_or(String::is_empty))
        .collect();
    let located: Vec<(String, Location)> = unknown
        .into_par_iter()
        .filter_map(|(path, id)| Some((id.to_owned(), location(&std::fs::read(path).ok()?)?)))
        .collect();
    if located.is_empty() {
        return places;
    }
    match detectors::load_places(models) {
        Ok(table) => naming::add_located(
            &mut places,
            located.into_iter().filter_map(|(id, at)| Some((id, table.name(at)?.to_owned()))),
        ),
        Err(reason) => {
            photos.run.report.note(None, &format!("{reason}; captions have no places of GPS data"));
        }
    }
    places
}
