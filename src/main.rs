//! The command line: batch rendering, goldens and debugging with the same code as the page.
//!
//! Progress and errors are printed to standard error, results to standard output. Exit codes: 0 done, 1 bad
//! input, 2 wrong usage (from the argument parser).

#![deny(clippy::print_stdout, clippy::print_stderr, reason = "a closed pipe makes them panic")]

mod album;
mod animating;
mod boards;
mod books;
mod config;
mod destination;
mod detectors;
mod documents;
mod drawing;
mod films;
mod imitator;
mod inventor;
mod own_pages;
mod paper;
mod plans;
mod projects;
mod reading;
mod reopening;
mod segments;
mod strips;
mod telling;

use clap::builder::PossibleValuesParser;
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};
use inkpanel::document::shots::FRAMES;
use inkpanel::framing::{PhotoMeta, Subject};
use inkpanel::kinds::clearer;
use inkpanel::layout::{self, Template};
use inkpanel::native::QUALITY;
use inkpanel::page::import::{Imported, import};
use inkpanel::page::request::{Families, Request};
use inkpanel::page::storyboard::{self, Choice};
use inkpanel::page::words::given::GivenFonts;
use inkpanel::page::{Document, catalogue};
use inkpanel::raster::Image;
use inkpanel::raster::decode::{Limits, decode_fit};
use inkpanel::raster::resize::Region;
use inkpanel::select::{self, Measures};
use inkpanel::style::faces::FaceBox;
use inkpanel::style::part::subject_in;
use inkpanel::style::{Context, Style, stylize};
use inkpanel::{Error, style};
use rayon::prelude::*;
use serde_json::{Value, json};
use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicUsize, Ordering};

use album::told;
use destination::{Output, print_lines};
use drawing::Kind;
use paper::Paper;

/// Turn photos into stylised comic pages and storyboards.
#[derive(Parser)]
#[command(version, about, after_help = EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

const EXIT_CODES: &str = "\
Exit codes:
  0  Success. Skipped files are listed on standard error.
  1  Bad input, or a warning with --strict. The reason is on standard error, and no file is written.
  2  Wrong usage: an option, its value, or a settings file.";

const RENDER_HELP: &str = "\
Examples:
  inkpanel render -o page.png photos/*.jpg
  inkpanel render --style noir --layout grid-6 --seed 7 -o page.png photos/
  inkpanel render --pages 4 -o album.pdf photos/
  inkpanel render album.inkpanel --page 2 -o page.webp

Exit codes:
  0  Success. Skipped files are listed on standard error.
  1  Bad input, or a warning with --strict. The reason is on standard error, and no file is written.
  2  Wrong usage: an option, its value, or a settings file.";

#[derive(Subcommand)]
enum Command {
    /// Make a comic page or several from photos, or draw a saved page.
    #[command(after_help = RENDER_HELP)]
    Render(Box<Render>),
    /// Make a book from photos: a cover, chapters by day with captions, page numbers and an end page.
    #[command(after_help = books::HELP)]
    Book(Box<books::Book>),
    /// Score the pages of a plan that `render --json` printed.
    #[command(
        after_help = "Example:\n  inkpanel render --json photos/ > plan.json && inkpanel score plan.json"
    )]
    Score {
        /// Plan file, as printed by `render --json`.
        plan: PathBuf,
        /// Print JSON.
        #[arg(long)]
        json: bool,
        /// Folder that contains faces.onnx and objects.onnx. [default: next to the program, or www/models]
        #[arg(long, value_name = "DIR")]
        models: Option<PathBuf>,
        /// Skip face and object detection.
        #[arg(long)]
        no_detect: bool,
    },
    /// Apply a style to one photo.
    #[command(after_help = "Example:\n  inkpanel stylize --style noir photo.jpg -o noir.png")]
    Stylize {
        /// Style id (see `inkpanel styles`) or style file.
        #[arg(long, value_name = "ID|FILE")]
        style: String,
        /// Photo file, or - for standard input.
        input: PathBuf,
        /// Output file (.png, .jpg or .webp), or - for standard output.
        #[arg(short, long)]
        output: PathBuf,
        /// File format, regardless of the file name.
        #[arg(long, value_name = "KIND", value_parser = ["png", "jpg", "webp"])]
        format: Option<String>,
        /// Skip detection of the subject and of faces.
        #[arg(long)]
        no_detect: bool,
    },
    /// Report which photos are worth a panel, and why.
    #[command(after_help = "Example:\n  inkpanel select photos/ --json")]
    Select {
        /// Photos, or folders with photos.
        #[arg(required = true)]
        files: Vec<PathBuf>,
        /// Print JSON.
        #[arg(long)]
        json: bool,
        /// Maximum distance of two fingerprints, in bits, at which photos count as near-duplicates.
        #[arg(long, default_value_t = 10, value_parser = clap::value_parser!(u32).range(0..=64))]
        threshold: u32,
    },
    /// Detect faces and objects.
    Detect {
        /// Photos, or folders with photos.
        #[arg(required = true)]
        files: Vec<PathBuf>,
        /// Print JSON.
        #[arg(long)]
        json: bool,
        /// Folder that contains faces.onnx and objects.onnx. [default: next to the program, or www/models]
        #[arg(long, value_name = "DIR")]
        models: Option<PathBuf>,
    },
    /// Write a mask per photo that is white on the subject.
    Segment {
        /// Photos, or folders with photos.
        #[arg(required = true)]
        files: Vec<PathBuf>,
        /// Folder for the masks, one NAME.png per photo.
        #[arg(short, long, value_name = "DIR")]
        output: PathBuf,
        /// Print JSON.
        #[arg(long)]
        json: bool,
        /// Folder that contains subject.onnx. [default: next to the program, or www/models]
        #[arg(long, value_name = "DIR")]
        models: Option<PathBuf>,
    },
    /// Generate random styles. Equal seeds give equal styles.
    #[command(after_help = "Example:\n  inkpanel generate --seed 7 --count 20 --json photo.jpg")]
    Generate {
        /// Random seed of the first style. Each further style adds 1.
        #[arg(long, default_value_t = 1)]
        seed: u32,
        /// Number of styles.
        #[arg(long, default_value_t = 8, value_parser = clap::value_parser!(u32).range(1..=10_000))]
        count: u32,
        /// Print JSON.
        #[arg(long)]
        json: bool,
        /// Folder that contains aesthetics.onnx. [default: next to the program, or www/models]
        #[arg(long, value_name = "DIR")]
        models: Option<PathBuf>,
        /// Photo to score each style on, from 0 to 1.
        photo: Option<PathBuf>,
    },
    /// Find styles that make a photo look like a given picture.
    #[command(after_help = "Example:\n  inkpanel imitate poster.jpg photo.jpg --json")]
    Imitate {
        /// Picture to imitate: a comic page, a print or a painting.
        picture: PathBuf,
        /// Photo to stylise.
        photo: PathBuf,
        /// Print JSON: an array of style files, best first, each with a score from 0 to 1.
        #[arg(long)]
        json: bool,
        /// Accept a picture that is blank or looks like a plain photo.
        #[arg(long)]
        anyway: bool,
        /// Random seed of the search.
        #[arg(long, default_value_t = 1)]
        seed: u32,
    },
    /// Detect the shots of a video and pick a frame for each (needs ffmpeg).
    #[command(after_help = "Example:\n  inkpanel shots clip.mp4 --frames 12 --json")]
    Shots {
        /// Video file.
        film: PathBuf,
        /// Number of frames. [default: depends on the number of shots]
        #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
        frames: Option<u32>,
        /// Print JSON.
        #[arg(long)]
        json: bool,
    },
    /// Write the animatic of a saved project as numbered PNG frames.
    #[command(after_help = EXIT_CODES)]
    Animate(Box<animating::Animate>),
    /// List the filter blocks.
    Blocks(Listing),
    /// List the layouts.
    Layouts(Listing),
    /// List the built-in styles.
    Styles(Listing),
}

#[derive(clap::Args)]
struct Listing {
    /// Print JSON.
    #[arg(long)]
    json: bool,
}

#[derive(clap::Args)]
struct Render {
    #[command(flatten)]
    planned: Planned,
    #[command(flatten)]
    how: How,
    /// Page number, from 1 (saved projects only). [default: the page edited last]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    page: Option<u32>,
    /// Draw storyboard sheets with this many frames each, instead of pages (saved projects only).
    #[arg(long, value_name = "FRAMES", value_parser = board_frames)]
    board: Option<u32>,
    /// Draw a planned page from a file that --save-document wrote. Its photos are read from FILES or from the folder of the
    /// file.
    #[arg(long, value_name = "FILE")]
    document: Option<PathBuf>,
    /// Output file, or - for standard output.
    ///
    /// A page: .png, .jpg, .webp or .pdf. A comic: .html, .epub or .cbz. A project with the original photos: .inkpanel. The shot
    /// list of a saved project: .csv, .edl, .otio or .xml.
    #[arg(short, long, required_unless_present_any = ["json", "save_document"])]
    output: Option<PathBuf>,
    /// Photos or folders, or one saved project.
    ///
    /// Photos are ordered by capture date if all have one. A saved project is an .inkpanel file, a ZIP or CBZ file of pages, or a
    /// page PNG that contains its project and photos. - is standard input.
    files: Vec<PathBuf>,
}

/// Options of every output.
#[derive(clap::Args)]
#[command(next_help_heading = "Output")]
struct How {
    #[command(flatten)]
    printing: drawing::Printing,
    /// Read settings from a JSON or TOML file.
    ///
    /// Keys are the names of options; "files" lists the photos. Paths are relative to the file. Options on the command line take
    /// precedence.
    #[arg(long, value_name = "FILE")]
    #[allow(dead_code, reason = "its settings are options by now")]
    config: Option<PathBuf>,
    /// File format, regardless of the file name.
    #[arg(long, value_name = "KIND", value_parser = ["png", "jpg", "webp", "pdf", "inkpanel"])]
    format: Option<String>,
    /// Treat warnings, such as a skipped photo, as errors and write nothing.
    #[arg(long)]
    strict: bool,
    /// Skip existing output files, to resume a run.
    #[arg(long)]
    skip_existing: bool,
    /// Format of the progress on standard error: text, or one JSON object per line.
    #[arg(long, value_name = "FORM", value_parser = ["text", "json"], default_value = "text")]
    progress: String,
    /// Project data to store in a PNG: none, the pages, or the pages and the original photos.
    #[arg(long, value_name = "WHAT", value_parser = ["none", "project", "photos"], default_value = "none")]
    embed: String,
    /// Write the panels below each other as pictures of 800 x 1280 pixels, for webtoon readers (pictures only).
    #[arg(long)]
    strip: bool,
    /// Also write the planned page as JSON, for --document. Several pages become an array.
    #[arg(long, value_name = "FILE")]
    save_document: Option<PathBuf>,
}

/// Options of the planner. A saved page is already planned.
#[derive(clap::Args, Default, PartialEq)]
#[command(next_help_heading = "Planning (photos only)")]
#[allow(clippy::struct_excessive_bools, reason = "each is a separate option")]
struct Planned {
    #[command(flatten)]
    album: Chosen,
    /// Layout id (see `inkpanel layouts`) or layout file.
    #[arg(long, value_name = "ID|FILE")]
    layout: Option<String>,
    /// Use only layouts of this family. Can be repeated.
    #[arg(long, value_name = "FAMILY", value_parser = layout_families(), conflicts_with = "layout")]
    layout_family: Vec<String>,
    /// Number of panels. [default: 5 or 6, depending on the layout]
    #[arg(long)]
    panels: Option<usize>,
    /// Let a subject break the panel border if there is enough room (needs subject.onnx).
    #[arg(long)]
    figures: bool,
    /// Let panels share one image.
    #[arg(long)]
    merge: bool,
    /// Captions, balloons and sound effects: a JSON array of text items.
    #[arg(long, value_name = "FILE")]
    words: Option<PathBuf>,
    /// Number of pages, for a PDF file, a comic or a file name such as page-%02d.png. Pages begin where the time or the scene
    /// changes. [default: 1]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pages: Option<u32>,
}

/// Options of pages and books: the paper, the photos and the style.
#[derive(clap::Args, Default, PartialEq)]
#[command(next_help_heading = "Planning (photos only)")]
#[allow(clippy::struct_excessive_bools, reason = "each is a separate option")]
struct Chosen {
    #[command(flatten)]
    paper: Paper,
    /// Style id (see `inkpanel styles`) or style file.
    #[arg(long, value_name = "ID|FILE")]
    style: Option<String>,
    /// Use only styles of this family. Can be repeated.
    #[arg(long, value_name = "FAMILY", value_parser = PossibleValuesParser::new(inkpanel::style::catalogue::FAMILIES), conflicts_with = "style")]
    style_family: Vec<String>,
    /// Random seed. [default: 1]
    #[arg(long)]
    seed: Option<u32>,
    /// Maximum fingerprint distance of near-duplicates. Only the best of them is used. [default: 10]
    #[arg(long, value_name = "BITS", value_parser = clap::value_parser!(u32).range(0..=64))]
    alike: Option<u32>,
    /// Use all photos, including near-duplicates and blurred ones.
    #[arg(long)]
    keep_all: bool,
    /// Keep the order of the command line instead of the order of capture.
    #[arg(long)]
    as_given: bool,
    /// Skip face and object detection. Crops then follow contrast.
    #[arg(long)]
    no_detect: bool,
    /// Folder that contains faces.onnx and objects.onnx. [default: next to the program, or www/models]
    #[arg(long, value_name = "DIR")]
    models: Option<PathBuf>,
    /// Print the plan as JSON: layout, style, panels, crops and score.
    #[arg(long)]
    json: bool,
    /// Photo for the largest panel, by file name or path. Can be repeated.
    #[arg(long, value_name = "FILE")]
    star: Vec<PathBuf>,
}

/// Returns the families of built-in layouts. The families of custom and generated layouts are not available
/// for a random choice.
fn layout_families() -> PossibleValuesParser {
    let has_layouts = |family: &&str| layout::catalogue().iter().any(|template| template.family() == *family);
    layout::FAMILIES.into_iter().filter(has_layouts).collect::<Vec<_>>().into()
}

/// A sentence about what went wrong, for people.
type Complaint = String;

fn main() -> ExitCode {
    let (arguments, listed) = match config::expanded::<Cli>(std::env::args_os().collect()) {
        Ok(expanded) => expanded,
        Err(complaint) => {
            telling::failure(&complaint);
            return ExitCode::from(2);
        }
    };
    let done = match Cli::parse_from(arguments).command {
        Command::Render(mut render) => {
            if render.files.is_empty() {
                render.files = listed;
            }
            render_page(&render)
        }
        Command::Book(mut book) => {
            if book.files.is_empty() {
                book.files = listed;
            }
            books::make(&book)
        }
        Command::Score { plan, json, models, no_detect } => {
            plans::score(&plan, json, !no_detect, models.as_deref())
        }
        Command::Stylize { style, input, output, format, no_detect } => {
            stylize_photo(&style, (&input, !no_detect), &output, format.as_deref())
        }
        Command::Select { files, json, threshold } => select_photos(&files, json, threshold),
        Command::Detect { files, json, models } => detect_photos(&files, json, models.as_deref()),
        Command::Segment { files, output, json, models } => {
            segments::segment(&files, &output, models.as_deref(), json)
        }
        Command::Generate { seed, count, json, models, photo } => {
            inventor::invent(seed, count, photo.as_deref(), models.as_deref())
                .and_then(|styles| list(&styles, json))
        }
        Command::Imitate { picture, photo, json, anyway, seed } => {
            imitator::imitate(&picture, &photo, seed, anyway).and_then(|styles| list(&styles, json))
        }
        Command::Animate(animate) => animating::animate(&animate),
        Command::Shots { film, frames, json } => shots_of(&film, frames, json),
        Command::Blocks(listing) => list(&catalogue::blocks(), listing.json),
        Command::Layouts(listing) => list(&catalogue::layouts(), listing.json),
        Command::Styles(listing) => list(&catalogue::styles(), listing.json),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(complaint) => {
            telling::failure(&complaint);
            ExitCode::from(1)
        }
    }
}

fn render_page(render: &Render) -> Result<(), Complaint> {
    let Render { planned, how, page, board, document, output, files } = render;
    if how.progress == "json" {
        telling::as_json();
    }
    let output = output.as_deref().map(|path| Output::new(path, how.format.as_deref())).transpose()?;
    if let Some(output) = &output {
        how.printing.check(Kind::of(&output.named)?)?;
    }
    if planned.album.json && output.as_ref().is_some_and(|output| album::is_standard(&output.path)) {
        return Err("--json and the page cannot both go to standard output".into());
    }
    if files.is_empty() && document.is_none() {
        Cli::command()
            .error(ErrorKind::MissingRequiredArgument, "no photos and no saved project given")
            .exit();
    }
    if let Some(output) = output.as_ref().filter(|output| how.skip_existing && is_made(output, planned)) {
        let event = json!({ "event": "skipped", "file": output.path.display().to_string() });
        telling::step(&event, Some(format!("{}: exists already, skipped", output.path.display())));
        return Ok(());
    }
    let given = files;
    let files = album::files(given)?;
    if let Some(document) = document {
        planned_already(planned, document)?;
        if how.strip {
            return Err("--strip needs photos or a saved project".into());
        }
        return documents::draw(document, &files, output.as_ref().ok_or(NO_OUTPUT)?, how);
    }
    if let [file] = &files[..]
        && let Some(saved) = reopening::open(file)
    {
        planned_already(planned, file)?;
        let output = output.as_ref().ok_or(NO_OUTPUT)?;
        return done(&reopening::draw(saved?, file, (*page, *board), (output, how))?);
    }
    if let Some(project) = files.iter().find(|file| reopening::is_project(file)) {
        return Err(format!("{}: a project cannot be combined with other files", project.display()));
    }
    if let Some(output) =
        output.as_ref().filter(|output| matches!(Kind::of(&output.named), Ok(Kind::Shots(_))))
    {
        return Err(format!("{}: a shot list needs a saved project", output.path.display()));
    }
    if board.is_some() {
        return Err("--board needs a saved project".into());
    }
    if page.is_some() {
        return Err("--page needs a saved project".into());
    }
    plan_page(planned, how, output.as_ref(), (&files, &projects::called(given, output_name(output.as_ref()))))
}

/// Returns whether all output files exist already. Then no photo is read.
fn is_made(output: &Output, planned: &Planned) -> bool {
    let one = matches!(Kind::of(&output.named), Ok(Kind::Pdf | Kind::Comic(_) | Kind::Project));
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

const NO_OUTPUT: &str = "--output is missing: name the output file";

/// Rejects options for planning if the input is a saved page.
fn planned_already(planned: &Planned, file: &Path) -> Result<(), Complaint> {
    if *planned == Planned::default() {
        return Ok(());
    }
    Err(format!("{}: a saved page takes only --output, --page and the print options", told(file)))
}

/// Reports the end of the run.
#[allow(clippy::unnecessary_wraps, reason = "callers return it as their result")]
fn done(files: &[PathBuf]) -> Result<(), Complaint> {
    let files: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
    telling::step(&json!({ "event": "done", "files": files }), None);
    Ok(())
}

/// With `--strict`, a warning is an error.
fn check_strict(how: &How) -> Result<(), Complaint> {
    let notes = telling::notes();
    if !how.strict || notes == 0 {
        return Ok(());
    }
    Err(match notes {
        1 => "--strict: 1 warning, so nothing is written".into(),
        many => format!("--strict: {many} warnings, so nothing is written"),
    })
}

fn plan_page(
    render: &Planned,
    how: &How,
    output: Option<&Output>,
    (files, album_name): (&[PathBuf], &str),
) -> Result<(), Complaint> {
    let layout = render.layout.as_deref().map(layout_value).transpose()?;
    let style = render.album.style.as_deref().map(style_value).transpose()?;
    let is_pdf = output.is_some_and(|output| matches!(Kind::of(&output.named), Ok(Kind::Pdf)));
    let page = render.album.paper.settings(is_pdf)?;
    let fonts = how.printing.fonts()?;
    let mut photos = import_all(files);
    let looked = !render.album.no_detect && add_subjects(&mut photos, render.album.models.as_deref());
    star(&mut photos, &render.album.star);
    if render.figures {
        segments::add_masks(&mut photos, render.album.models.as_deref())?;
    }
    let used = used_photos(&render.album, &photos);
    let request = Request {
        seed: render.album.seed.unwrap_or(1),
        photos: used,
        page,
        layout,
        style,
        panels: render.panels,
        merge: Some(render.merge),
        figures: Some(render.figures),
        ordered: render.album.as_given.then_some(true),
        within: Families { layouts: render.layout_family.clone(), styles: render.album.style_family.clone() },
        ..Request::default()
    };
    let mut pages = storyboard::pages(&request, render.pages.map(|pages| pages as usize))
        .map_err(|error| error.to_string())?;
    if let (Some(file), Some(first)) = (&render.words, pages.first_mut()) {
        drawing::add_words(&mut first.document, file, &photos, &fonts)?;
    }
    if let Some(wanted) = render.pages.filter(|wanted| *wanted as usize != pages.len()) {
        telling::note(None, &format!("{} pages instead of {wanted}", pages.len()));
    }
    plans::tell_differences(&pages, render.panels, &request.photos, &photos);
    let drawn: Vec<Document> = pages.iter().map(|page| page.document.clone()).collect();
    drawing::tell_missing(&drawn, &fonts)?;
    check_strict(how)?;
    let album = projects::Album {
        name: album_name.to_owned(),
        pages: &drawn,
        photos: &photos,
        used: request.photos.iter().map(|photo| photo.id.as_str()).collect(),
        looked,
    };
    let written = write_album(&album, &fonts, output, (how, render.pages.is_some(), &render.album))?;
    if render.album.json {
        print(&plans::told(&pages, &photos)?)?;
    }
    done(&written)
}

/// Draws and writes the pages of an album, and the plan if it is to be saved. `several`: one file per page.
///
/// Returns the files.
fn write_album(
    album: &projects::Album<'_>,
    fonts: &GivenFonts,
    output: Option<&Output>,
    (how, several, chosen): (&How, bool, &Chosen),
) -> Result<Vec<PathBuf>, Complaint> {
    let photos = album.photos;
    let paths: HashMap<&str, &Path> =
        photos.iter().map(|(path, photo)| (photo.meta.id.as_str(), path.as_path())).collect();
    let full = |id: &str| paths.get(id).map(|path| decode_file(path)).transpose();
    let masks =
        photos.iter().filter_map(|(_, photo)| Some((photo.meta.id.clone(), photo.meta.mask.clone()?)));
    let masks = segments::Masks::new(masks.collect(), chosen.models.as_deref()).detecting(!chosen.no_detect);
    let means = how.printing.means(&full, fonts, &masks);
    let mut written = match output {
        Some(output) => write_pages(album, &means, output, (how, several))?,
        None => Vec::new(),
    };
    if let Some(file) = &how.save_document {
        documents::save(album.pages, &paths, several, file)?;
        written.push(file.clone());
    }
    Ok(written)
}

/// Writes the pages of an album: one file per page if there are `several`, otherwise one file.
///
/// Returns the files.
fn write_pages(
    album: &projects::Album<'_>,
    means: &drawing::Means<'_>,
    output: &Output,
    (how, several): (&How, bool),
) -> Result<Vec<PathBuf>, Complaint> {
    let kind = Kind::of(&output.named)?;
    if kind == Kind::Project {
        output.write(&album.packed()?)?;
        return Ok(vec![output.path.clone()]);
    }
    strips::check(how.strip, kind)?;
    if how.embed != "none" && (how.strip || kind != Kind::Png) {
        return Err("--embed: only a PNG carries its project".into());
    }
    let finish = |page: usize, file: Vec<u8>| match how.embed.as_str() {
        "none" => Ok(file),
        what => album.inside(&file, page, what == "photos"),
    };
    let subjects = |id: &str| {
        let photo = album.photos.iter().find(|(_, photo)| photo.meta.id == id);
        photo.map_or(&[][..], |(_, photo)| &photo.meta.subjects)
    };
    if let Kind::Comic(comic) = kind {
        let told = reading::Telling { title: &album.name, language: how.printing.language() };
        return reading::write((comic, told), album.pages, &subjects, means, output);
    }
    if several || how.strip || kind == Kind::Pdf {
        let printed: drawing::Printed<'_> = (&how.printing, &subjects);
        if how.strip {
            let taken = |id: &str| {
                let photo = album.photos.iter().find(|(_, photo)| photo.meta.id == id);
                photo.and_then(|(_, photo)| photo.meta.taken.clone())
            };
            let pages = strips::pages(album.pages, means, &taken, &subjects)?;
            return plans::draw_all(&pages, means, output, (how.skip_existing, &finish, printed));
        }
        return plans::draw_all(album.pages, means, output, (how.skip_existing, &finish, printed));
    }
    output.write(&finish(0, drawing::draw(&album.pages[0], means, &output.named)?)?)?;
    Ok(vec![output.path.clone()])
}

/// Marks the starred photos, and warns about names that match no photo.
fn star(photos: &mut [(PathBuf, Imported)], names: &[PathBuf]) {
    for (path, photo) in photos.iter_mut() {
        photo.meta.starred = names.iter().any(|name| is_named(path, name));
    }
    for name in names.iter().filter(|name| !photos.iter().any(|(path, _)| is_named(path, name))) {
        telling::note(Some(&name.display().to_string()), "--star: no photo has this name");
    }
}

/// Returns whether a path matches a name, completely or by its last parts.
fn is_named(path: &Path, name: &Path) -> bool {
    path.ends_with(name.strip_prefix(".").unwrap_or(name))
}

/// Returns the photos for the pages, in order. Similar and blurred photos are reported and left out.
fn used_photos(render: &Chosen, photos: &[(PathBuf, Imported)]) -> Vec<PhotoMeta> {
    /// Maximum number of photos that are reported one by one.
    const FEW: usize = 10;
    let names: Vec<&str> = photos.iter().map(|(path, _)| name(path)).collect();
    let imported: Vec<&Imported> = photos.iter().map(|(_, photo)| photo).collect();
    let choice = Choice { alike: render.alike, keep_all: render.keep_all, as_given: render.as_given };
    let (used, verdicts) = storyboard::chosen(&names, &imported, choice);
    let left: Vec<(&str, &str)> = names
        .iter()
        .zip(&verdicts)
        .filter(|(_, verdict)| !verdict.kept)
        .map(|(name, verdict)| (*name, verdict.why.as_str()))
        .collect();
    if left.len() > FEW {
        let names: Vec<&str> = left.iter().map(|(name, _)| *name).collect();
        let (count, some) = (left.len(), plans::some(&names));
        telling::note(
            None,
            &format!("{count} photos are left out; `inkpanel select` lists the reasons: {some}"),
        );
    } else {
        for (name, why) in &left {
            telling::note(Some(name), &format!("left out: {why}"));
        }
    }
    used
}

/// Writes a photo in a style. If it `detects`, the style protects the faces, and knows the subject if it
/// needs it.
fn stylize_photo(
    style: &str,
    (input, detects): (&Path, bool),
    output: &Path,
    format: Option<&str>,
) -> Result<(), Complaint> {
    let output = Output::new(output, format)?;
    let kind = Kind::of(&output.named)?;
    if matches!(kind, Kind::Pdf | Kind::Project | Kind::Comic(_) | Kind::Shots(_)) {
        return Err(format!("{}: stylize writes .png, .jpg or .webp", output.path.display()));
    }
    let style = read_style(style)?;
    let image = decode_file(input)?;
    let mut context = Context::for_image(&image);
    if detects && style.faces {
        context.show_faces(faces_in(&image)?);
    }
    if let Some(matte) = segments::Masks::default().detecting(detects).asked_by(&style, "", &image) {
        let size = (image.width(), image.height());
        context.show_subject(subject_in(
            &matte,
            Region::whole(size.0, size.1),
            size,
            (&image, context.scale()),
        ));
    }
    let drawn = stylize(&image, &style, &mut context).map_err(|error| error.to_string())?;
    let size = (drawn.width(), drawn.height());
    output.write(&drawing::encoded(kind, size, &drawn.to_rgb(), (96, QUALITY))?)
}

/// The faces of a photo in its pixels, or its animals if it has no faces. None without the models, which is printed.
fn faces_in(photo: &Image) -> Result<Vec<FaceBox>, Complaint> {
    let detectors = match detectors::load(None) {
        Ok(detectors) => detectors,
        Err(complaint) => {
            telling::note(None, &format!("{complaint}; the style protects no face"));
            return Ok(Vec::new());
        }
    };
    let found = detectors.detect(photo).map_err(|error| error.to_string())?;
    let mut found: Vec<Subject> = found.into_iter().map(Into::into).collect();
    found.sort_by(|a, b| b.height.total_cmp(&a.height));
    let (across, down) = (photo.width() as f64, photo.height() as f64);
    let face = |subject: &Subject| FaceBox {
        x: subject.x * across,
        y: subject.y * down,
        width: subject.width * across,
        height: subject.height * down,
    };
    Ok(Subject::protected(&found).map(face).collect())
}

fn select_photos(files: &[PathBuf], as_json: bool, threshold: u32) -> Result<(), Complaint> {
    let photos = import_all(&album::files(files)?);
    if photos.is_empty() {
        return Err(Error::NoPhotos.to_string());
    }
    let names: Vec<&str> = photos.iter().map(|(path, _)| name(path)).collect();
    let measures: Vec<Measures> = photos.iter().map(|(_, photo)| photo.measures.clone()).collect();
    let settings = select::Settings { threshold, ..select::Settings::default() };
    let verdicts = select::choose(&names, &measures, &settings);
    let rows: Vec<Value> = photos
        .iter()
        .zip(&verdicts)
        .map(|((path, photo), verdict)| {
            json!({
                "file": path.display().to_string(),
                "fingerprint": format!("{:016x}", photo.measures.fingerprint),
                "sharpness": photo.measures.gradient,
                "group": verdict.group,
                "kept": verdict.kept,
                "why": verdict.why,
            })
        })
        .collect();
    if as_json {
        return print(&Value::Array(rows));
    }
    print_lines(photos.iter().zip(&verdicts).map(|((path, _), verdict)| {
        let mark = if verdict.kept { "keep" } else { "skip" };
        format!("{mark}  {}  {}", path.display(), verdict.why)
    }))
}

fn detect_photos(files: &[PathBuf], as_json: bool, models: Option<&Path>) -> Result<(), Complaint> {
    let detectors = detectors::load(models)?;
    let photos = import_all(&album::files(files)?);
    if photos.is_empty() {
        return Err(Error::NoPhotos.to_string());
    }
    let found = detectors::run(&detectors, &photos);
    let rows = photos.iter().zip(&found).map(|((path, photo), found)| {
        json!({ "file": path.display().to_string(), "boxes": detectors::boxes(photo, found) })
    });
    if as_json {
        return print(&Value::Array(rows.collect()));
    }
    print_lines(photos.iter().zip(&found).map(|((path, _), found)| {
        let words: Vec<String> =
            found.iter().map(|d| format!("{} {:.0} %", d.label, d.score * 100.0)).collect();
        format!("{}  {}", path.display(), words.join(", "))
    }))
}

/// Adds the detected faces and subjects to the photos. Without the models, crops follow contrast, and a
/// warning is printed once.
///
/// Returns whether the models were available.
fn add_subjects(photos: &mut [(PathBuf, Imported)], models: Option<&Path>) -> bool {
    let detectors = match detectors::load(models) {
        Ok(detectors) => detectors,
        Err(complaint) => {
            telling::note(None, &format!("{complaint}; photos are cropped by contrast"));
            return false;
        }
    };
    let found = detectors::run(&detectors, photos);
    for ((_, photo), found) in photos.iter_mut().zip(found) {
        photo.meta.find(found.into_iter().map(Into::into));
    }
    true
}

fn shots_of(film: &Path, frames: Option<u32>, as_json: bool) -> Result<(), Complaint> {
    let shots = films::shots(film, frames.map(|frames| frames as usize))?;
    if as_json {
        return print(&shots);
    }
    print_lines(shots.as_array().into_iter().flatten().map(|shot| {
        let frames: Vec<String> =
            shot["frames"].as_array().into_iter().flatten().map(Value::to_string).collect();
        let kind = shot["kind"].as_str().unwrap_or_default();
        format!("{}\t{}\t{}\t{kind}\t{}", shot["shot"], shot["start"], shot["end"], frames.join(" "))
    }))
}

/// Prints JSON.
fn print(value: &Value) -> Result<(), Complaint> {
    list(value, true)
}

/// Prints a catalogue.
fn list(catalogue: &impl serde::Serialize, as_json: bool) -> Result<(), Complaint> {
    // Converted to text first: a JSON value stores the numbers of layouts as f64, which prints other digits
    // than the app uses.
    let text = serde_json::to_string(catalogue).map_err(|error| error.to_string())?;
    if as_json {
        return print_lines([text]);
    }
    let catalogue: Value = serde_json::from_str(&text).map_err(|error| error.to_string())?;
    print_lines(catalogue.as_array().into_iter().flatten().map(|item| {
        let field = |key: &str| item[key].as_str().unwrap_or_default();
        let label = if field("name").is_empty() { field("label") } else { field("name") };
        format!("{:<24}{label}", field("id"))
    }))
}

/// Reads files in parallel. Files that cannot be read are reported and left out.
fn import_all(files: &[PathBuf]) -> Vec<(PathBuf, Imported)> {
    let limits = Limits::default();
    let count = AtomicUsize::new(0);
    let read: Vec<Result<Imported, Complaint>> = files
        .par_iter()
        .enumerate()
        .map(|(i, path)| {
            let photo = album::read(path).and_then(|bytes| {
                survived(|| {
                    import(&format!("photo-{i}"), &bytes, &limits)
                        .map_err(|error| clearer(error, name(path), &bytes))
                })
            });
            let done = count.fetch_add(1, Ordering::Relaxed) + 1;
            let event = json!({ "event": "photo", "file": told(path), "done": done, "of": files.len() });
            telling::step(&event, None);
            photo
        })
        .collect();
    let mut photos = Vec::new();
    for (path, photo) in files.iter().zip(read) {
        match photo {
            Ok(photo) => {
                telling::damage(&told(path), photo.damage);
                photos.push((path.clone(), photo));
            }
            Err(complaint) => telling::note(Some(&told(path)), &format!("{complaint}; left out")),
        }
    }
    photos
}

/// Runs `work` on one file. If it panics, because of a bug here or in a decoder, the panic becomes the error
/// of this file. The panic message is already on standard error.
fn survived<T>(work: impl FnOnce() -> inkpanel::Result<T>) -> Result<T, Complaint> {
    // Nothing reads the state that a panic may leave incomplete.
    match catch_unwind(AssertUnwindSafe(work)) {
        Ok(done) => done.map_err(|error| error.to_string()),
        Err(_) => Err("internal error while reading this file; please report it".to_owned()),
    }
}

fn decode_file(path: &Path) -> Result<Image, Complaint> {
    decode_file_fit(path, usize::MAX)
}

fn decode_file_fit(path: &Path, longest: usize) -> Result<Image, Complaint> {
    let complain = |reason: String| format!("{}: {reason}", told(path));
    let bytes = album::read(path).map_err(complain)?;
    let decode = || {
        decode_fit(&bytes, &Limits::default(), longest).map_err(|error| clearer(error, name(path), &bytes))
    };
    let decoded = survived(decode).map_err(complain)?;
    telling::damage(&told(path), decoded.damage);
    Ok(decoded.image)
}

fn read_style(id_or_file: &str) -> Result<Style, Complaint> {
    if !Path::new(id_or_file).is_file() {
        return style::catalogue::find(id_or_file).cloned().map_err(|error| error.to_string());
    }
    let json = album::text(Path::new(id_or_file)).map_err(|error| format!("{id_or_file}: {error}"))?;
    Style::parse(id_or_file, &json).map_err(|error| error.to_string())
}

fn style_value(id_or_file: &str) -> Result<Value, Complaint> {
    read_style(id_or_file).map(|style| style.to_value())
}

fn layout_value(id_or_file: &str) -> Result<Value, Complaint> {
    if !Path::new(id_or_file).is_file() {
        return Ok(Value::String(id_or_file.to_owned()));
    }
    let json = album::text(Path::new(id_or_file)).map_err(|error| format!("{id_or_file}: {error}"))?;
    Template::parse(id_or_file, &json).map_err(|error| error.to_string())?;
    serde_json::from_str(&json).map_err(|error| format!("{id_or_file}: {error}"))
}

fn name(path: &Path) -> &str {
    path.file_name().and_then(|name| name.to_str()).unwrap_or("?")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_the_error_of_one_file() {
        let files = [0, 1, 2];
        let read: Vec<_> = files
            .par_iter()
            .map(|&file| survived(|| if file == 1 { panic!("a fault") } else { Ok(file) }))
            .collect();
        assert_eq!((read[0].as_ref(), read[2].as_ref()), (Ok(&0), Ok(&2)));
        assert!(read[1].as_ref().unwrap_err().contains("please report it"));
        assert_eq!(survived::<()>(|| Err(Error::NoPhotos)), Err(Error::NoPhotos.to_string()));
    }
}
