//! Pages as plain data on the command line: written with the names of their photos, and drawn again.

use crate::args::How;
use crate::destination::{Output, write};
use crate::format::Format;
use crate::input::{decode_file, name};
use crate::masks::Masks;
use crate::run::Run;
use crate::{CliError, drawing, plans, reading};
use inkpanel::with_names;
use inkpanel_engine::document::sheets::photos_on;
use inkpanel_engine::page::Document;
use serde_json::Value;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Bytes of a file of pages.
const MOST: u64 = 64 << 20;
/// Pages in it.
const MOST_PAGES: usize = 1_000;

/// Writes pages as JSON: one page as an object, `several` as a list. File names of photos replace ids. If two
/// photos have the same name, their folders are included.
///
/// # Errors
/// A sentence with the name of the file.
pub(crate) fn save(
    pages: &[Document],
    paths: &HashMap<&str, &Path>,
    several: bool,
    file: &Path,
) -> Result<(), CliError> {
    let named = |id: &str| -> String {
        let Some(path) = paths.get(id) else { return id.to_owned() };
        let alone = paths.values().filter(|other| name(other) == name(path)).count() == 1;
        if alone { name(path).to_owned() } else { path.display().to_string() }
    };
    let texts: Vec<String> = pages.iter().map(|page| with_names(page, &named).to_json()).collect();
    let text = if several { format!("[{}]", texts.join(",\n")) } else { texts.concat() };
    write(file, format!("{text}\n").as_bytes())
}

/// Draws the pages of a file.
///
/// # Errors
/// A sentence, if the file is not a page, or a photo is neither in `files` nor next to the file.
pub(crate) fn draw(
    run: &Run,
    file: &Path,
    files: &[PathBuf],
    output: &Output,
    how: &How,
) -> Result<(), CliError> {
    let complain = |error: CliError| error.at(file.display());
    let pages = read(run, file).map_err(complain)?;
    let shown: Vec<&Document> = pages.iter().collect();
    let mut paths: HashMap<String, PathBuf> = HashMap::new();
    for photo in photos_on(&shown) {
        let path = found(photo, file, files).ok_or_else(|| {
            let why = format!("the photo {photo} is neither in its folder nor among the given photos");
            complain(CliError::new("missing-photo", why))
        })?;
        paths.insert(photo.to_owned(), path);
    }
    let full = |id: &str| paths.get(id).map(|path| decode_file(run, path)).transpose();
    let fonts = how.printing.fonts(run)?;
    let masks = Masks::new(run, HashMap::new(), None);
    let means = how.printing.means(&full, &fonts, &masks);
    drawing::tell_missing(run, &pages, &fonts)?;
    if how.strict {
        // Damage is reported before anything is written. Errors are reported again when the photo is drawn.
        for path in paths.values() {
            drop(decode_file(run, path));
        }
    }
    run.report.check_strict(how.strict)?;
    if let Format::Comic(kind) = Format::of(&output.named)? {
        let title = output.named.file_stem().map(|stem| stem.to_string_lossy()).unwrap_or_default();
        let told = reading::Telling { title: &title, language: how.printing.language() };
        return run.report.done(&reading::write((kind, told), &pages, &|_| &[], &means, output)?);
    }
    if let [page] = &pages[..]
        && Format::of(&output.named)? != Format::Pdf
    {
        output.write(&drawing::draw(page, &means, &output.named)?)?;
        return run.report.done(std::slice::from_ref(&output.path));
    }
    let files = plans::Files {
        skips: how.skip_existing,
        finish: &|_, file| Ok(file),
        printed: (&how.printing, &|_| &[]),
    };
    run.report.done(&plans::draw_all(&pages, &means, output, &files)?)
}

fn read(run: &Run, file: &Path) -> Result<Vec<Document>, CliError> {
    let text = run.text(file)?;
    if text.len() as u64 > MOST {
        return Err(CliError::new("too-large", format!("is larger than {} MB", MOST >> 20)));
    }
    let value: Value = serde_json::from_str(&text).map_err(CliError::not_json)?;
    let values = match value {
        Value::Array(values) => values,
        value => vec![value],
    };
    if values.is_empty() || values.len() > MOST_PAGES {
        return Err(CliError::new("invalid-document", format!("must have from 1 to {MOST_PAGES} pages")));
    }
    values.iter().map(|value| Ok(Document::parse(&value.to_string())?)).collect()
}

/// Returns the file of a photo: a given file with this name, or a file in a folder next to the page.
fn found(photo: &str, page: &Path, files: &[PathBuf]) -> Option<PathBuf> {
    let wanted = Path::new(photo);
    let given =
        files.iter().find(|file| *file == wanted).or_else(|| files.iter().find(|file| name(file) == photo));
    let beside = page.parent().unwrap_or(Path::new("")).join(wanted);
    given.cloned().or_else(|| beside.is_file().then_some(beside))
}
