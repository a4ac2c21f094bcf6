//! Saved projects and pages on the command line, drawn like exports of the app.

use crate::args::How;
use crate::destination::Output;
use crate::drawing;
use crate::format::Format;
use crate::input::told;
use crate::masks::Masks;
use crate::run::Run;
use crate::{CliError, boards, plans, reading, strips};
use inkpanel::survived;
use inkpanel_engine::document::listing::shot_list;
use inkpanel_engine::document::saved::Saved;
use inkpanel_engine::document::sheets::photos_on;
use inkpanel_engine::framing::Subject;
use inkpanel_engine::page::Document;
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// File name extension of projects.
const EXTENSION: &str = "inkpanel";

/// Reads a project file, or a PNG with its project.
///
/// Returns `None` if the file is neither. Then it is a photo.
pub(crate) fn open(run: &Run, input: &Path) -> Option<Result<Saved, CliError>> {
    let named = is_project(input);
    let complain = |error: CliError| Err(error.at(told(input)));
    let bytes = match run.read(input) {
        Ok(bytes) => bytes,
        // Unreadable photos are reported where photos are read.
        Err(error) => return named.then(|| complain(error)),
    };
    match survived(|| Ok(Saved::read(bytes)?)) {
        Ok(Some(saved)) => Some(Ok(saved)),
        Ok(None) => named.then(|| complain(CliError::new("unknown-format", "not an Inkpanel project"))),
        Err(reason) => Some(complain(reason)),
    }
}

/// The options of `render` that apply to a saved project.
pub(crate) struct Asked<'a> {
    pub(crate) run: &'a Run,
    /// Page number, from 1.
    pub(crate) page: Option<u32>,
    /// Frames on the sheets of a board, which are drawn instead of pages.
    pub(crate) board: Option<u32>,
    /// Options of the output.
    pub(crate) how: &'a How,
}

/// Draws the present page, or the page with this number, from 1. Books and comics have all pages by default.
/// `board`: frames on the sheets of a board, which are drawn in their place.
///
/// Returns the files.
pub(crate) fn draw(
    saved: Saved,
    input: &Path,
    asked: &Asked<'_>,
    output: &Output,
) -> Result<Vec<PathBuf>, CliError> {
    drawn(saved, asked, output).map_err(|error| error.at(told(input)))
}

/// Returns whether a file name is the name of a project.
pub(crate) fn is_project(file: &Path) -> bool {
    file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(EXTENSION))
}

fn drawn(mut saved: Saved, asked: &Asked<'_>, output: &Output) -> Result<Vec<PathBuf>, CliError> {
    let &Asked { run, page: number, board, how } = asked;
    let (kind, printing) = (Format::of(&output.named)?, &how.printing);
    if let Format::Shots(kind) = kind {
        output.write(shot_list(saved.project()).written(kind).as_bytes())?;
        return Ok(vec![output.path.clone()]);
    }
    strips::check(how.strip, kind)?;
    let known = known(&saved);
    let stem = output.named.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    // A name with a number placeholder requests one picture per page.
    let each = how.strip || number.is_none() && plans::has_number(&output.named);
    let logo = board.map_or(Ok(None), |_| boards::logo(run, &saved))?;
    let wanted = match board {
        Some(_) if matches!(kind, Format::Comic(_)) => {
            return Err("--board needs an output file .pdf or .png".into());
        }
        Some(frames) => boards::sheets(&mut saved, frames, (&stem, &known), logo.as_ref())?,
        None => wanted(&saved, number, each || printing.binds() || matches!(kind, Format::Comic(_)))?,
    };
    let drawn_logo = |id: &str| logo.as_ref().filter(|_| id == boards::LOGO);
    let files = files(&mut saved, &wanted, &|id| drawn_logo(id).is_none())?;
    let photos = |id: &str| {
        if let Some(logo) = drawn_logo(id) {
            return Ok(Some(logo.clone()));
        }
        photo(run, &saved, &files, id)
    };
    let found = |id: &str| known.get(id).map_or(&[][..], Vec::as_slice);
    let fonts = printing.fonts(run)?;
    let masks = masks(run, &saved);
    let means = printing.means(&photos, &fonts, &masks);
    drawing::tell_missing(run, &wanted, &fonts)?;
    if how.strict {
        // Damage is reported before anything is written. Errors are reported again when the photo is drawn.
        for id in files.keys() {
            drop(photos(id));
        }
    }
    run.report.check_strict(how.strict)?;
    // Projects have no capture times.
    let wanted = if how.strip { strips::pages(&wanted, &means, &|_| None, &found)? } else { wanted };
    match kind {
        Format::Comic(comic) => {
            let named = saved.project().history.present.name.trim();
            let title = if named.is_empty() { &*stem } else { named };
            let told = reading::Telling { title, language: printing.language() };
            reading::write((comic, told), &wanted, &found, &means, output)
        }
        Format::Pdf => drawing::write_book(&wanted, &means, output, (printing, &found)),
        _ if each || wanted.len() > 1 => plans::draw_all(
            &wanted,
            &means,
            output,
            &plans::Files {
                skips: how.skip_existing,
                finish: &|_, file| Ok(file),
                printed: (printing, &found),
            },
        ),
        _ => {
            output.write(&drawing::draw(&wanted[0], &means, &output.named)?)?;
            Ok(vec![output.path.clone()])
        }
    }
}

/// The pages to draw: the one with this number. By default the present one, or all pages if `all` is set.
fn wanted(saved: &Saved, number: Option<u32>, all: bool) -> Result<Vec<Document>, CliError> {
    let (pages, present) = saved.pages();
    if all && number.is_none() && !pages.is_empty() {
        return Ok(pages.iter().map(|page| Document::clone(page)).collect());
    }
    let at = number.map_or(present, |number| number as usize - 1);
    let page = pages.get(at).ok_or_else(|| match pages.len() {
        0 => "the project has no pages".to_owned(),
        1 => format!("page {} does not exist: the project has 1 page", at + 1),
        count => format!("page {} does not exist: the project has {count} pages", at + 1),
    })?;
    Ok(vec![Document::clone(page)])
}

/// Subjects of the photos in the file, by id.
pub(crate) fn known(saved: &Saved) -> HashMap<String, Vec<Subject>> {
    saved
        .project()
        .photos
        .iter()
        .map(|photo| (photo.id.clone(), photo.subjects.clone().unwrap_or_default()))
        .collect()
}

/// Subject masks of the photos by id: corrected, or stored detections. Styles that need other masks run the
/// detector.
pub(crate) fn masks<'r>(run: &'r Run, saved: &Saved) -> Masks<'r> {
    let known = saved.project().masks();
    Masks::new(run, known.map(|(id, mask)| (id.to_owned(), mask.clone())).collect(), None)
}

/// A photo at full size by id; `None` if its file is missing.
///
/// # Errors
/// A sentence with its name if it cannot be read.
pub(crate) fn photo(
    run: &Run,
    saved: &Saved,
    files: &HashMap<String, Vec<u8>>,
    id: &str,
) -> Result<Option<Image>, CliError> {
    let Some(bytes) = files.get(id) else { return Ok(None) };
    let name = saved.photo(id).map_or(id, |photo| &photo.name);
    let decoded = survived(|| Ok(decode(bytes, &Limits::default())?))
        .map_err(|error: CliError| error.at(format_args!("the photo {name}")))?;
    run.report.damage(name, decoded.damage);
    Ok(Some(decoded.image))
}

/// The files of the photos that pages show, by their ids; `is_photo`: whether a picture is one.
///
/// # Errors
/// A sentence where some are not in the project.
pub(crate) fn files(
    saved: &mut Saved,
    pages: &[Document],
    is_photo: &dyn Fn(&str) -> bool,
) -> Result<HashMap<String, Vec<u8>>, CliError> {
    let pages: Vec<&Document> = pages.iter().collect();
    let mut shown: Vec<&str> = photos_on(&pages).into_iter().filter(|id| is_photo(id)).collect();
    shown.sort_unstable();
    let mut files = HashMap::new();
    for id in &shown {
        if let Some(file) = saved.photo_file(id)? {
            files.insert((*id).to_owned(), file);
        }
    }
    match (shown.len() - files.len(), shown.len()) {
        (0, _) => Ok(files),
        (1, 1) => Err(CliError::new("missing-photo", "its photo is not in it; save it again with the photo")),
        (missing, all) => {
            let why = format!("{missing} of its {all} photos are not in it; save it again with the photos");
            Err(CliError::new("missing-photo", why))
        }
    }
}
