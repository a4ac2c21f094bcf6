//! The command line: batch rendering, goldens and debugging with the same code as the page.
//!
//! Progress and errors are printed to standard error, results to standard output. Exit codes: 0 done, 1 bad
//! input, 2 wrong usage (from the argument parser).

#![deny(clippy::print_stdout, clippy::print_stderr, reason = "a closed pipe makes them panic")]

mod album;
mod animating;
mod boards;
mod books;
mod cli_error;
mod config;
mod destination;
mod detectors;
mod documents;
mod drawing;
mod films;
mod format;
mod imitator;
mod inventor;
mod own_pages;
mod paper;
mod photos;
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
use inkpanel::{PageOptions, survived};
use inkpanel_engine::document::shots::FRAMES;
use inkpanel_engine::framing::Subject;
use inkpanel_engine::kinds::clearer;
use inkpanel_engine::layout::{self, PageSettings, Template};
use inkpanel_engine::native::{self, QUALITY};
use inkpanel_engine::page::words::given::GivenFonts;
use inkpanel_engine::page::{Document, catalogue};
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode_fit};
use inkpanel_engine::raster::resize::Region;
use inkpanel_engine::select::DUPLICATE_THRESHOLD;
use inkpanel_engine::style::faces::FaceBox;
use inkpanel_engine::style::part::subject_in;
use inkpanel_engine::style::{Style, stylize};
use inkpanel_engine::{Error, style};
use serde_json::{Value, json};
use std::collections::HashMap;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use album::told;
use cli_error::CliError;
use destination::{Output, print_lines};
use format::Format;
use paper::Paper;
use photos::Photos;

/// Turn photos into stylised comic pages and storyboards.
#[derive(Parser)]
#[command(version, about, after_help = EXIT_CODES)]
struct Cli {
    /// Model for the block Painter: an ONNX file of at most 4 MB. [default: painters.onnx of Inkpanel]
    #[arg(long, global = true, value_name = "FILE")]
    painters: Option<PathBuf>,
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
    Score(ScoreArgs),
    /// Apply a style to one photo.
    #[command(after_help = "Example:\n  inkpanel stylize --style noir photo.jpg -o noir.png")]
    Stylize(StylizeArgs),
    /// Report which photos are worth a panel, and why.
    #[command(after_help = "Example:\n  inkpanel select photos/ --json")]
    Select(SelectArgs),
    /// Detect faces and objects.
    Detect(DetectArgs),
    /// Write a mask per photo that is white on the subject.
    Segment(SegmentArgs),
    /// Generate random styles. Equal seeds give equal styles.
    #[command(after_help = "Example:\n  inkpanel generate --seed 7 --count 20 --json photo.jpg")]
    Generate(GenerateArgs),
    /// Find styles that make a photo look like a given picture.
    #[command(after_help = "Example:\n  inkpanel imitate poster.jpg photo.jpg --json")]
    Imitate(ImitateArgs),
    /// Detect the shots of a video and pick a frame for each (needs ffmpeg).
    #[command(after_help = "Example:\n  inkpanel shots clip.mp4 --frames 12 --json")]
    Shots(ShotsArgs),
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

/// Arguments of `inkpanel score`.
#[derive(clap::Args)]
struct ScoreArgs {
    /// Plan file, as printed by `render --json`.
    pub(crate) plan: PathBuf,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
    /// Folder that contains faces.onnx and objects.onnx. [default: next to the program, or www/models]
    #[arg(long, value_name = "DIR")]
    pub(crate) models: Option<PathBuf>,
    /// Skip face and object detection.
    #[arg(long)]
    pub(crate) no_detect: bool,
}

/// Arguments of `inkpanel stylize`.
#[derive(clap::Args)]
struct StylizeArgs {
    /// Style id (see `inkpanel styles`) or style file.
    #[arg(long, value_name = "ID|FILE")]
    pub(crate) style: String,
    /// Photo file, or - for standard input.
    pub(crate) input: PathBuf,
    /// Output file (.png, .jpg or .webp), or - for standard output.
    #[arg(short, long)]
    pub(crate) output: PathBuf,
    /// File format, regardless of the file name.
    #[arg(long, value_name = "KIND", value_parser = ["png", "jpg", "webp"])]
    pub(crate) format: Option<String>,
    /// Skip detection of the subject and of faces.
    #[arg(long)]
    pub(crate) no_detect: bool,
}

/// Arguments of `inkpanel select`.
#[derive(clap::Args)]
struct SelectArgs {
    /// Photos, or folders with photos.
    #[arg(required = true)]
    pub(crate) files: Vec<PathBuf>,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
    /// Maximum fingerprint distance of near-duplicates.
    #[arg(long, alias = "threshold", value_name = "BITS", default_value_t = DUPLICATE_THRESHOLD)]
    #[arg(value_parser = clap::value_parser!(u32).range(0..=64))]
    pub(crate) duplicate_threshold: u32,
}

/// Arguments of `inkpanel detect`.
#[derive(clap::Args)]
struct DetectArgs {
    /// Photos, or folders with photos.
    #[arg(required = true)]
    pub(crate) files: Vec<PathBuf>,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
    /// Folder that contains faces.onnx and objects.onnx. [default: next to the program, or www/models]
    #[arg(long, value_name = "DIR")]
    pub(crate) models: Option<PathBuf>,
}

/// Arguments of `inkpanel segment`.
#[derive(clap::Args)]
struct SegmentArgs {
    /// Photos, or folders with photos.
    #[arg(required = true)]
    pub(crate) files: Vec<PathBuf>,
    /// Folder for the masks, one NAME.png per photo.
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
    /// Folder that contains subject.onnx. [default: next to the program, or www/models]
    #[arg(long, value_name = "DIR")]
    pub(crate) models: Option<PathBuf>,
}

/// Arguments of `inkpanel generate`.
#[derive(clap::Args)]
struct GenerateArgs {
    /// Random seed of the first style. Each further style adds 1.
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u32,
    /// Number of styles.
    #[arg(long, default_value_t = 8, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub(crate) count: u32,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
    /// Folder that contains aesthetics.onnx. [default: next to the program, or www/models]
    #[arg(long, value_name = "DIR")]
    pub(crate) models: Option<PathBuf>,
    /// Photo to score each style on, from 0 to 1.
    pub(crate) photo: Option<PathBuf>,
}

/// Arguments of `inkpanel imitate`.
#[derive(clap::Args)]
struct ImitateArgs {
    /// Picture to imitate: a comic page, a print or a painting.
    pub(crate) picture: PathBuf,
    /// Photo to stylise.
    pub(crate) photo: PathBuf,
    /// Print JSON: an array of style files, best first, each with a score from 0 to 1.
    #[arg(long)]
    pub(crate) json: bool,
    /// Accept a picture that is blank or looks like a plain photo.
    #[arg(long)]
    pub(crate) anyway: bool,
    /// Random seed of the search.
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u32,
}

/// Arguments of `inkpanel shots`.
#[derive(clap::Args)]
struct ShotsArgs {
    /// Video file.
    pub(crate) film: PathBuf,
    /// Number of frames. [default: depends on the number of shots]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub(crate) frames: Option<u32>,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
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
    #[allow(dead_code, reason = "`wants_json` reads it, also if other arguments are wrong")]
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
    #[arg(long, value_name = "FAMILY", value_parser = PossibleValuesParser::new(inkpanel_engine::style::catalogue::FAMILIES), conflicts_with = "style")]
    style_family: Vec<String>,
    /// Random seed. [default: 1]
    #[arg(long)]
    seed: Option<u32>,
    // Not `default_value_t`, because options of a plan that equal their defaults count as not given.
    #[arg(long, alias = "alike", value_name = "BITS", help = format!("Maximum fingerprint distance of near-duplicates, of which only the best is used [default: {DUPLICATE_THRESHOLD}]"))]
    #[arg(value_parser = clap::value_parser!(u32).range(0..=64))]
    duplicate_threshold: Option<u32>,
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

impl Chosen {
    /// The options of pages with these settings.
    fn options(&self, page: PageSettings) -> Result<PageOptions, CliError> {
        let mut options = PageOptions::new().settings(page).style_families(&self.style_family);
        options = options.keep_all(self.keep_all).as_given(self.as_given);
        if let Some(style) = &self.style {
            options = options.style(&inkpanel::Style::new(read_style(style)?));
        }
        if let Some(seed) = self.seed {
            options = options.seed(seed);
        }
        if let Some(bits) = self.duplicate_threshold {
            options = options.duplicate_threshold(bits);
        }
        Ok(options)
    }
}

/// Returns the families of built-in layouts. The families of custom and generated layouts are not available
/// for a random choice.
fn layout_families() -> PossibleValuesParser {
    let has_layouts = |family: &&str| layout::catalogue().iter().any(|template| template.family() == *family);
    layout::FAMILIES.into_iter().filter(has_layouts).collect::<Vec<_>>().into()
}

/// Exit code for wrong usage.
const USAGE: u8 = 2;

fn main() -> ExitCode {
    let arguments: Vec<OsString> = std::env::args_os().collect();
    if wants_json(&arguments) {
        telling::as_json();
    }
    let (arguments, listed) = match config::expanded::<Cli>(arguments) {
        Ok(expanded) => expanded,
        Err(error) => return failed(&error, USAGE),
    };
    if wants_json(&arguments) {
        telling::as_json();
    }
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(error) => return wrong_usage(&error),
    };
    native::read_painters_with(detectors::load_painters);
    if let Some(Err(error)) = cli.painters.as_deref().map(detectors::use_painters) {
        return failed(&error, 1);
    }
    let done = match cli.command {
        Command::Render(mut render) => {
            if render.files.is_empty() {
                render.files = listed;
            }
            if render.files.is_empty() && render.document.is_none() {
                let why = "no photos and no saved project given";
                return wrong_usage(&Cli::command().error(ErrorKind::MissingRequiredArgument, why));
            }
            render_page(&render)
        }
        Command::Book(mut book) => {
            if book.files.is_empty() {
                book.files = listed;
            }
            books::make(&book)
        }
        Command::Score(score) => plans::score(&score),
        Command::Stylize(stylize) => stylize_photo(&stylize),
        Command::Select(select) => select_photos(&select),
        Command::Detect(detect) => detect_photos(&detect),
        Command::Segment(segment) => segments::segment(&segment),
        Command::Generate(generate) => {
            inventor::invent(&generate).and_then(|styles| list(&styles, generate.json))
        }
        Command::Imitate(imitate) => {
            imitator::imitate(&imitate).and_then(|styles| list(&styles, imitate.json))
        }
        Command::Animate(animate) => animating::animate(&animate),
        Command::Shots(shots) => shots_of(&shots),
        Command::Blocks(listing) => list(&catalogue::blocks(), listing.json),
        Command::Layouts(listing) => list(&catalogue::layouts(), listing.json),
        Command::Styles(listing) => list(&catalogue::styles(), listing.json),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => failed(&error, 1),
    }
}

/// Reports an error.
fn failed(error: &CliError, code: u8) -> ExitCode {
    telling::failure(error);
    ExitCode::from(code)
}

/// Reports an error of the argument parser, or prints the requested help.
fn wrong_usage(error: &clap::Error) -> ExitCode {
    if !(telling::is_json() && error.use_stderr()) {
        error.exit();
    }
    let text = error.render().to_string();
    let lines: Vec<&str> = text.lines().map(str::trim).take_while(|line| !line.is_empty()).collect();
    let message = lines.join(" ");
    failed(&message.strip_prefix("error: ").unwrap_or(&message).into(), USAGE)
}

/// Whether the arguments ask for progress as JSON. Errors of the arguments follow the format as well.
fn wants_json(arguments: &[OsString]) -> bool {
    let options = || arguments.iter().take_while(|argument| *argument != "--");
    options().any(|argument| argument == "--progress=json")
        || options().zip(options().skip(1)).any(|(option, form)| option == "--progress" && form == "json")
}

fn render_page(render: &Render) -> Result<(), CliError> {
    let Render { planned, how, page, board, document, output, files } = render;
    let output = output.as_deref().map(|path| Output::new(path, how.format.as_deref())).transpose()?;
    if let Some(output) = &output {
        how.printing.check(Format::of(&output.named)?)?;
    }
    if planned.album.json && output.as_ref().is_some_and(|output| album::is_standard(&output.path)) {
        return Err("--json and the page cannot both go to standard output".into());
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
        return done(&reopening::draw(saved?, file, render, output)?);
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
    plan_page(planned, how, output.as_ref(), &Input { files: &files, name: &name })
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

const NO_OUTPUT: &str = "--output is missing: name the output file";

/// Rejects options for planning if the input is a saved page.
fn planned_already(planned: &Planned, file: &Path) -> Result<(), CliError> {
    if *planned == Planned::default() {
        return Ok(());
    }
    Err(format!("{}: a saved page takes only --output, --page and the print options", told(file)).into())
}

/// Reports the end of the run.
#[allow(clippy::unnecessary_wraps, reason = "callers return it as their result")]
fn done(files: &[PathBuf]) -> Result<(), CliError> {
    let files: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
    telling::step(&json!({ "event": "done", "files": files }), None);
    Ok(())
}

/// With `--strict`, a warning is an error.
fn check_strict(how: &How) -> Result<(), CliError> {
    let notes = telling::notes();
    if !how.strict || notes == 0 {
        return Ok(());
    }
    let warnings = if notes == 1 { "1 warning".to_owned() } else { format!("{notes} warnings") };
    Err(CliError::new("warnings", format!("--strict: {warnings}, so nothing is written")))
}

/// The photos of an album, and its name.
struct Input<'a> {
    files: &'a [PathBuf],
    name: &'a str,
}

fn plan_page(
    render: &Planned,
    how: &How,
    output: Option<&Output>,
    input: &Input<'_>,
) -> Result<(), CliError> {
    let is_pdf = output.is_some_and(|output| matches!(Format::of(&output.named), Ok(Format::Pdf)));
    let mut options = render.album.options(render.album.paper.settings(is_pdf)?)?;
    options = options.merge(render.merge).figures(render.figures).layout_families(&render.layout_family);
    if let Some(layout) = &render.layout {
        options = with_layout(options, layout)?;
    }
    if let Some(panels) = render.panels {
        options = options.panels(panels);
    }
    let fonts = how.printing.fonts()?;
    let mut photos = Photos::read(input.files.to_vec())?;
    let looked = photos.prepare(&render.album);
    if render.figures {
        segments::add_masks(&mut photos, render.album.models.as_deref())?;
    }
    let chosen = photos.choose(&options);
    let used: Vec<String> = chosen.iter().map(|photo| photo.id.clone()).collect();
    let mut pages = photos.album.plan(&options, chosen, render.pages.map(|pages| pages as usize))?;
    if let (Some(file), Some(first)) = (&render.words, pages.first_mut()) {
        drawing::add_words(&mut first.document, file, &photos, &fonts)?;
    }
    if let Some(wanted) = render.pages.filter(|wanted| *wanted as usize != pages.len()) {
        telling::note(None, &format!("{} pages instead of {wanted}", pages.len()));
    }
    plans::tell_differences(&pages, render.panels, &used, &photos);
    let drawn: Vec<Document> = pages.iter().map(|page| page.document.clone()).collect();
    drawing::tell_missing(&drawn, &fonts)?;
    check_strict(how)?;
    let album =
        projects::Album { name: input.name.to_owned(), pages: &drawn, photos: &photos, used: &used, looked };
    let written = write_album(
        &album,
        &fonts,
        output,
        &Writing { how, several: render.pages.is_some(), chosen: &render.album },
    )?;
    if render.album.json {
        print(&plans::told(&pages, &photos)?)?;
    }
    done(&written)
}

/// How the pages of an album are written.
struct Writing<'a> {
    how: &'a How,
    chosen: &'a Chosen,
    /// Whether there is one file per page.
    several: bool,
}

/// Draws and writes the pages of an album, and the plan if it is to be saved.
///
/// Returns the files.
fn write_album(
    album: &projects::Album<'_>,
    fonts: &GivenFonts,
    output: Option<&Output>,
    writing: &Writing<'_>,
) -> Result<Vec<PathBuf>, CliError> {
    let Writing { how, chosen, several } = *writing;
    let photos = album.photos;
    let paths: HashMap<&str, &Path> =
        photos.iter().map(|(path, photo)| (photo.meta.id.as_str(), path)).collect();
    let full = |id: &str| paths.get(id).map(|path| decode_file(path)).transpose();
    let masks =
        photos.iter().filter_map(|(_, photo)| Some((photo.meta.id.clone(), photo.meta.mask.clone()?)));
    let masks = segments::Masks::new(masks.collect(), chosen.models.as_deref()).detecting(!chosen.no_detect);
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

/// Writes a photo in a style. Unless detection is off, the style protects the faces, and knows the subject if
/// it needs it.
fn stylize_photo(asked: &StylizeArgs) -> Result<(), CliError> {
    let detects = !asked.no_detect;
    let output = Output::new(&asked.output, asked.format.as_deref())?;
    let kind = Format::of(&output.named)?;
    if matches!(kind, Format::Pdf | Format::Project | Format::Comic(_) | Format::Shots(_)) {
        return Err(format!("{}: stylize writes .png, .jpg or .webp", output.path.display()).into());
    }
    let style = read_style(&asked.style)?;
    let image = decode_file(&asked.input)?;
    let mut context = native::context_for(&style, &image);
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
    let drawn = stylize(&image, &style, &mut context)?;
    let size = (drawn.width(), drawn.height());
    output.write(&drawing::encoded(kind, size, &drawn.to_rgb(), (96, QUALITY))?)
}

/// The faces of a photo in its pixels, or its animals if it has no faces. None without the models, which is printed.
fn faces_in(photo: &Image) -> Result<Vec<FaceBox>, CliError> {
    let detectors = match detectors::load(None) {
        Ok(detectors) => detectors,
        Err(complaint) => {
            telling::note(None, &format!("{complaint}; the style protects no face"));
            return Ok(Vec::new());
        }
    };
    let found = detectors.detect(photo)?;
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

fn select_photos(asked: &SelectArgs) -> Result<(), CliError> {
    let photos = Photos::read(album::files(&asked.files)?)?;
    if photos.album.imported().is_empty() {
        return Err(Error::NoPhotos.into());
    }
    let options = PageOptions::new().duplicate_threshold(asked.duplicate_threshold);
    let verdicts = photos.album.choose(&options).verdicts;
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
    if asked.json {
        return print(&Value::Array(rows));
    }
    print_lines(photos.iter().zip(&verdicts).map(|((path, _), verdict)| {
        let mark = if verdict.kept { "keep" } else { "skip" };
        format!("{mark}  {}  {}", path.display(), verdict.why)
    }))
}

fn detect_photos(asked: &DetectArgs) -> Result<(), CliError> {
    let detectors = detectors::load(asked.models.as_deref())?;
    let photos = Photos::read(album::files(&asked.files)?)?;
    if photos.album.imported().is_empty() {
        return Err(Error::NoPhotos.into());
    }
    let found = detectors::run(&detectors, &photos);
    let rows = photos.iter().zip(&found).map(|((path, photo), found)| {
        json!({ "file": path.display().to_string(), "boxes": detectors::boxes(photo, found) })
    });
    if asked.json {
        return print(&Value::Array(rows.collect()));
    }
    print_lines(photos.iter().zip(&found).map(|((path, _), found)| {
        let words: Vec<String> =
            found.iter().map(|d| format!("{} {:.0} %", d.label, d.score * 100.0)).collect();
        format!("{}  {}", path.display(), words.join(", "))
    }))
}

fn shots_of(asked: &ShotsArgs) -> Result<(), CliError> {
    let shots = films::shots(&asked.film, asked.frames.map(|frames| frames as usize))?;
    if asked.json {
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
fn print(value: &Value) -> Result<(), CliError> {
    list(value, true)
}

/// Prints a catalogue.
fn list(catalogue: &impl serde::Serialize, as_json: bool) -> Result<(), CliError> {
    // Converted to text first: a JSON value stores the numbers of layouts as f64, which prints other digits
    // than the app uses.
    let text = serde_json::to_string(catalogue).map_err(CliError::fault)?;
    if as_json {
        return print_lines([text]);
    }
    let catalogue: Value = serde_json::from_str(&text).map_err(CliError::fault)?;
    print_lines(catalogue.as_array().into_iter().flatten().map(|item| {
        let field = |key: &str| item[key].as_str().unwrap_or_default();
        let label = if field("name").is_empty() { field("label") } else { field("name") };
        format!("{:<24}{label}", field("id"))
    }))
}

fn decode_file(path: &Path) -> Result<Image, CliError> {
    decode_file_fit(path, usize::MAX)
}

fn decode_file_fit(path: &Path, longest: usize) -> Result<Image, CliError> {
    let complain = |error: CliError| error.at(told(path));
    let bytes = album::read(path).map_err(complain)?;
    let decode = || {
        let decoded = decode_fit(&bytes, &Limits::default(), longest);
        Ok(decoded.map_err(|error| clearer(error, name(path), &bytes))?)
    };
    let decoded = survived(decode).map_err(complain)?;
    telling::damage(&told(path), decoded.damage);
    Ok(decoded.image)
}

fn read_style(id_or_file: &str) -> Result<Style, CliError> {
    if !Path::new(id_or_file).is_file() {
        return Ok(style::catalogue::find(id_or_file)?.clone());
    }
    let json = album::text(Path::new(id_or_file)).map_err(|error| error.at(id_or_file))?;
    Ok(Style::parse(id_or_file, &json)?)
}

/// Sets a layout by its id or file.
fn with_layout(options: PageOptions, id_or_file: &str) -> Result<PageOptions, CliError> {
    if !Path::new(id_or_file).is_file() {
        return Ok(options.layout(id_or_file)?);
    }
    let json = album::text(Path::new(id_or_file)).map_err(|error| error.at(id_or_file))?;
    // Checked first, so that errors have the name of the file.
    Template::parse(id_or_file, &json)?;
    Ok(options.layout_from_json(&json)?)
}

fn name(path: &Path) -> &str {
    path.file_name().and_then(|name| name.to_str()).unwrap_or("?")
}

#[cfg(test)]
mod tests {
    use super::*;
    use rayon::prelude::*;

    #[test]
    fn a_panic_is_the_error_of_one_file() {
        let files = [0, 1, 2];
        let read: Vec<_> = files
            .par_iter()
            .map(|&file| survived::<_, CliError>(|| if file == 1 { panic!("a fault") } else { Ok(file) }))
            .collect();
        assert_eq!((read[0].as_ref(), read[2].as_ref()), (Ok(&0), Ok(&2)));
        let error = read[1].as_ref().unwrap_err();
        assert_eq!(error.code(), "fault");
        assert!(error.to_string().contains("please report it"));
    }
}
