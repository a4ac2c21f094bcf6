//! `inkpanel render`: pages of photos, saved projects and planned pages.

use super::segment;
use super::with_layout;
use crate::args::{Chosen, How};
use crate::destination::{Output, print_json};
use crate::format::Format;
use crate::input::{self, decode_file, told};
use crate::masks::Masks;
use crate::photos::Photos;
use crate::run::{self, Run};
use crate::{CliError, documents, drawing, plans, projects, reading, reopening, strips};
use clap::builder::PossibleValuesParser;
use inkpanel_engine::document::shots::FRAMES;
use inkpanel_engine::layout;
use inkpanel_engine::page::words::given::GivenFonts;
use serde_json::json;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

pub(crate) const HELP: &str = "\
Examples:
  inkpanel render -o page.png photos/*.jpg
  inkpanel render --style noir --layout grid-6 --seed 7 -o page.png photos/
  inkpanel render --pages 4 -o album.pdf photos/
  inkpanel render album.inkpanel --page 2 -o page.webp

Exit codes:
  0  Success. Skipped files are listed on standard error.
  1  Bad input, or a warning with --strict. The reason is on standard error, and no file is written.
  2  Wrong usage: an option, its value, or a settings file.";

#[derive(clap::Args)]
pub(crate) struct Render {
    #[command(flatten)]
    pub(crate) planned: Planned,
    #[command(flatten)]
    pub(crate) how: How,
    /// Page number, from 1 (saved projects only). [default: the page edited last]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) page: Option<u32>,
    /// Draw storyboard sheets with this many frames each, instead of pages (saved projects only).
    #[arg(long, value_name = "FRAMES", value_parser = board_frames)]
    pub(crate) board: Option<u32>,
    /// Draw a planned page from a file that --save-document wrote. Its photos are read from FILES or from the folder of the
    /// file.
    #[arg(long, value_name = "FILE")]
    pub(crate) document: Option<PathBuf>,
    /// Output file, or - for standard output.
    ///
    /// A page: .png, .jpg, .webp or .pdf. A comic: .html, .epub or .cbz. A project with the original photos: .inkpanel. The shot
    /// list of a saved project: .csv, .edl, .otio or .xml.
    #[arg(short, long, required_unless_present_any = ["json", "save_document"])]
    pub(crate) output: Option<PathBuf>,
    /// Photos or folders, or one saved project.
    ///
    /// Photos are ordered by capture date if all have one. A saved project is an .inkpanel file, a ZIP or CBZ file of pages, or a
    /// page PNG that contains its project and photos. - is standard input.
    pub(crate) files: Vec<PathBuf>,
}

/// Options of the planner. A saved page is already planned.
#[derive(clap::Args, Default, PartialEq)]
#[command(next_help_heading = "Planning (photos only)")]
#[allow(clippy::struct_excessive_bools, reason = "each is a separate option")]
pub(crate) struct Planned {
    #[command(flatten)]
    pub(crate) album: Chosen,
    /// Layout id (see `inkpanel layouts`) or layout file.
    #[arg(long, value_name = "ID|FILE")]
    pub(crate) layout: Option<String>,
    /// Use only layouts of this family. Can be repeated.
    #[arg(long, value_name = "FAMILY", value_parser = layout_families(), conflicts_with = "layout")]
    pub(crate) layout_family: Vec<String>,
    /// Number of panels. [default: 5 or 6, depending on the layout]
    #[arg(long)]
    pub(crate) panels: Option<usize>,
    /// Let a subject break the panel border if there is enough room (needs subject.onnx).
    #[arg(long)]
    pub(crate) figures: bool,
    /// Let panels share one image.
    #[arg(long)]
    pub(crate) merge: bool,
    /// Captions, balloons and sound effects: a JSON array of text items.
    #[arg(long, value_name = "FILE")]
    pub(crate) words: Option<PathBuf>,
    /// Edits of the planned pages: a JSON array such as [{"type": "swap-panels", "panel": 0, "with": 2}].
    #[arg(long, value_name = "FILE")]
    pub(crate) edits: Option<PathBuf>,
    /// Number of pages, for a PDF file, a comic or a file name such as page-%02d.png. Pages begin where the time or the scene
    /// changes. [default: 1]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub(crate) pages: Option<u32>,
}

/// Returns the families of built-in layouts. The families of custom and generated layouts are not available
/// for a random choice.
fn layout_families() -> PossibleValuesParser {
    let has_layouts = |family: &&str| layout::catalogue().iter().any(|template| template.family() == *family);
    layout::FAMILIES.into_iter().filter(has_layouts).collect::<Vec<_>>().into()
}

pub(crate) fn render(run: &Run, render: &Render) -> Result<(), CliError> {
    let Render { planned, how, page, board, document, output, files } = render;
    let output = output.as_deref().map(|path| Output::new(path, how.format.as_deref())).transpose()?;
    if let Some(output) = &output {
        how.printing.check(Format::of(&output.named)?)?;
    }
    if planned.album.json && output.as_ref().is_some_and(|output| run::is_standard(&output.path)) {
        return Err("--json and the page cannot both go to standard output".into());
    }
    if let Some(output) = output.as_ref().filter(|output| how.skip_existing && is_made(output, planned)) {
        let event = json!({ "event": "skipped", "file": output.path.display().to_string() });
        run.report.step(&event, Some(format!("{}: exists already, skipped", output.path.display())));
        return Ok(());
    }
    let given = files;
    let files = input::files(run, given)?;
    if let Some(document) = document {
        planned_already(planned, document)?;
        if how.strip {
            return Err("--strip needs photos or a saved project".into());
        }
        return documents::draw(run, document, &files, output.as_ref().ok_or(NO_OUTPUT)?, how);
    }
    if let [file] = &files[..]
        && let Some(saved) = reopening::open(run, file)
    {
        planned_already(planned, file)?;
        let output = output.as_ref().ok_or(NO_OUTPUT)?;
        return run.report.done(&reopening::draw(
            saved?,
            file,
            &reopening::Asked { run, page: *page, board: *board, how },
            output,
        )?);
    }
    if let Some(project) = files.iter().find(|file| reopening::is_project(file)) {
        return Err(format!("{}: a project cannot be combined with other files", project.display()).into());
    }
    if let Some(output) =
        output.as_ref().filter(|output| matches!(Format::of(&output.named), Ok(Format::Shots(_))))
    {
        return Err(format!("{}: a shot list needs a saved project", output.path.display()).into());
    }
    if board.is_some() {
        return Err("--board needs a saved project".into());
    }
    if page.is_some() {
        return Err("--page needs a saved project".into());
    }
    let name = projects::called(given, output_name(output.as_ref()));
    plan_page(run, planned, how, output.as_ref(), &Input { files: &files, name: &name })
}

/// Returns whether all output files exist already. Then no photo is read.
fn is_made(output: &Output, planned: &Planned) -> bool {
    let one = matches!(Format::of(&output.named), Ok(Format::Pdf | Format::Comic(_) | Format::Project));
    match planned.pages {
        Some(pages) if !one => plans::all_exist(output, pages as usize),
        _ => output.exists(),
    }
}

/// Frames that fit on a sheet.
fn board_frames(text: &str) -> Result<u32, String> {
    let known = text.parse().ok().filter(|count| FRAMES.contains(count));
    known.ok_or_else(|| format!("must be one of {}", FRAMES.map(|count| count.to_string()).join(", ")))
}

/// The file that a project is called after.
fn output_name(output: Option<&Output>) -> &Path {
    output.map_or(Path::new(""), |output| &output.path)
}

pub(crate) const NO_OUTPUT: &str = "--output is missing: name the output file";

/// Rejects options for planning if the input is a saved page.
fn planned_already(planned: &Planned, file: &Path) -> Result<(), CliError> {
    if *planned == Planned::default() {
        return Ok(());
    }
    Err(format!("{}: a saved page takes only --output, --page and the print options", told(file)).into())
}

/// The photos of an album, and its name.
struct Input<'a> {
    files: &'a [PathBuf],
    name: &'a str,
}

fn plan_page(
    run: &Run,
    render: &Planned,
    how: &How,
    output: Option<&Output>,
    input: &Input<'_>,
) -> Result<(), CliError> {
    let is_pdf = output.is_some_and(|output| matches!(Format::of(&output.named), Ok(Format::Pdf)));
    let mut options = render.album.options(run, render.album.paper.settings(is_pdf)?)?;
    options = options.merge(render.merge).figures(render.figures).layout_families(&render.layout_family);
    if let Some(layout) = &render.layout {
        options = with_layout(run, options, layout)?;
    }
    if let Some(panels) = render.panels {
        options = options.panels(panels);
    }
    if let Some(file) = &render.edits {
        let complain = |error: CliError| error.at(file.display());
        let json = run.text(file).map_err(complain)?;
        options = options.edits(&json).map_err(|error| complain(error.into()))?;
    }
    let fonts = how.printing.fonts(run)?;
    let mut photos = Photos::read(run, input.files.to_vec())?;
    let looked = render.album.prepare(&mut photos);
    if render.figures {
        segment::add_masks(&mut photos, render.album.models.as_deref())?;
    }
    let chosen = photos.choose(&options);
    let used: Vec<String> = chosen.iter().map(|photo| photo.id.clone()).collect();
    let pages = photos.album.plan(&options, chosen.clone(), render.pages.map(|pages| pages as usize))?;
    if let Some(wanted) = render.pages.filter(|wanted| *wanted as usize != pages.len()) {
        run.report.note(None, &format!("{} pages instead of {wanted}", pages.len()));
    }
    plans::tell_differences(&pages, render.panels, &used, &photos);
    let documents = pages.iter().map(|page| page.document.clone()).collect();
    let edited = photos.album.edit(&options, documents, &chosen);
    let (mut drawn, unchanged) = match &render.edits {
        Some(file) => edited.map_err(|error| CliError::from(error).at(file.display()))?,
        None => edited?,
    };
    for message in unchanged {
        run.report.note(None, &message);
    }
    if let (Some(file), Some(first)) = (&render.words, drawn.first_mut()) {
        drawing::add_words(first, file, &photos, &fonts)?;
    }
    drawing::tell_missing(run, &drawn, &fonts)?;
    run.report.check_strict(how.strict)?;
    let album =
        projects::Album { name: input.name.to_owned(), pages: &drawn, photos: &photos, used: &used, looked };
    let written = write_album(
        &album,
        &fonts,
        output,
        &Writing { how, several: render.pages.is_some(), chosen: &render.album },
    )?;
    if render.album.json {
        print_json(&plans::told(&drawn, &pages, &photos)?)?;
    }
    run.report.done(&written)
}

/// How the pages of an album are written.
pub(crate) struct Writing<'a> {
    pub(crate) how: &'a How,
    pub(crate) chosen: &'a Chosen,
    /// Whether there is one file per page.
    pub(crate) several: bool,
}

/// Draws and writes the pages of an album, and the plan if it is to be saved.
///
/// Returns the files.
pub(crate) fn write_album(
    album: &projects::Album<'_>,
    fonts: &GivenFonts,
    output: Option<&Output>,
    writing: &Writing<'_>,
) -> Result<Vec<PathBuf>, CliError> {
    let Writing { how, chosen, several } = *writing;
    let photos = album.photos;
    let paths: HashMap<&str, &Path> =
        photos.iter().map(|(path, photo)| (photo.meta.id.as_str(), path)).collect();
    let full = |id: &str| paths.get(id).map(|path| decode_file(photos.run, path)).transpose();
    let masks =
        photos.iter().filter_map(|(_, photo)| Some((photo.meta.id.clone(), photo.meta.mask.clone()?)));
    let masks =
        Masks::new(photos.run, masks.collect(), chosen.models.as_deref()).detecting(!chosen.no_detect);
    let means = how.printing.means(&full, fonts, &masks);
    let mut written = match output {
        Some(output) => write_pages(album, &means, output, writing)?,
        None => Vec::new(),
    };
    if let Some(file) = &how.save_document {
        documents::save(album.pages, &paths, several, file)?;
        written.push(file.clone());
    }
    Ok(written)
}

/// Writes the pages of an album.
///
/// Returns the files.
fn write_pages(
    album: &projects::Album<'_>,
    means: &drawing::Means<'_>,
    output: &Output,
    writing: &Writing<'_>,
) -> Result<Vec<PathBuf>, CliError> {
    let Writing { how, several, .. } = *writing;
    let kind = Format::of(&output.named)?;
    if kind == Format::Project {
        output.write(&album.packed()?)?;
        return Ok(vec![output.path.clone()]);
    }
    strips::check(how.strip, kind)?;
    if how.embed != "none" && (how.strip || kind != Format::Png) {
        return Err("--embed: only a PNG carries its project".into());
    }
    let finish = |page: usize, file: Vec<u8>| match how.embed.as_str() {
        "none" => Ok(file),
        what => album.inside(&file, page, what == "photos"),
    };
    let subjects = |id: &str| {
        let photo = album.photos.find(id);
        photo.map_or(&[][..], |(_, photo)| &photo.meta.subjects)
    };
    if let Format::Comic(comic) = kind {
        let told = reading::Telling { title: &album.name, language: how.printing.language() };
        return reading::write((comic, told), album.pages, &subjects, means, output);
    }
    if several || how.strip || kind == Format::Pdf {
        let files =
            plans::Files { skips: how.skip_existing, finish: &finish, printed: (&how.printing, &subjects) };
        if how.strip {
            let taken = |id: &str| album.photos.find(id).and_then(|(_, photo)| photo.meta.taken.clone());
            let pages = strips::pages(album.pages, means, &taken, &subjects)?;
            return plans::draw_all(&pages, means, output, &files);
        }
        return plans::draw_all(album.pages, means, output, &files);
    }
    output.write(&finish(0, drawing::draw(&album.pages[0], means, &output.named)?)?)?;
    Ok(vec![output.path.clone()])
}
