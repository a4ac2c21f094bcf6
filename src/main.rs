//! The command line: batch rendering, goldens and debugging with the same code as the page.
//!
//! Progress and complaints go to standard error, results to standard output. Exit codes: 0 done, 1 bad input,
//! 2 wrong usage (from the argument parser).

mod detectors;
mod drawing;
mod inventor;
mod plans;
mod reopening;

use clap::{Parser, Subcommand};
use inkpanel::layout::{PageSettings, Template};
use inkpanel::page::import::{Imported, import};
use inkpanel::page::request::Request;
use inkpanel::page::{catalogue, png};
use inkpanel::raster::Image;
use inkpanel::raster::decode::{Limits, decode_fit};
use inkpanel::select::{self, Measures};
use inkpanel::style::{Context, Style, stylize};
use inkpanel::{Error, style};
use rayon::prelude::*;
use serde_json::{Value, json};
use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Photos in, stylised storyboard pages out.
#[derive(Parser)]
#[command(version, about)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Make a storyboard page of photos, or draw a saved one.
    Render(Box<Render>),
    /// Judge the pages of a plan as `render --json` prints it: the score and its terms.
    Score {
        /// The plan.
        plan: PathBuf,
        /// Answer as JSON.
        #[arg(long)]
        json: bool,
        /// Folder of faces.onnx and objects.onnx.
        #[arg(long, value_name = "DIR")]
        models: Option<PathBuf>,
        /// Do not look for faces and objects.
        #[arg(long)]
        no_detect: bool,
    },
    /// Draw one photo in a style.
    Stylize {
        /// Id of a designed style, or a style file.
        #[arg(long, value_name = "ID|FILE")]
        style: String,
        /// The photo.
        input: PathBuf,
        /// Where the PNG goes.
        #[arg(short, long)]
        output: PathBuf,
    },
    /// Say which photos are worth a panel, and why.
    Select {
        /// The photos.
        #[arg(required = true)]
        files: Vec<PathBuf>,
        /// Answer as JSON.
        #[arg(long)]
        json: bool,
        /// Largest distance of two fingerprints that count as the same picture.
        #[arg(long, default_value_t = 10, value_parser = clap::value_parser!(u32).range(0..=64))]
        threshold: u32,
    },
    /// Find faces and objects.
    Detect {
        /// The photos.
        #[arg(required = true)]
        files: Vec<PathBuf>,
        /// Answer as JSON.
        #[arg(long)]
        json: bool,
        /// Folder of faces.onnx and objects.onnx.
        #[arg(long, value_name = "DIR")]
        models: Option<PathBuf>,
    },
    /// Invent styles: chains of blocks at random, the same for the same seed.
    Generate {
        /// Seed of the first; the others have the seeds that follow.
        #[arg(long, default_value_t = 1)]
        seed: u32,
        /// How many.
        #[arg(long, default_value_t = 8, value_parser = clap::value_parser!(u32).range(1..=10_000))]
        count: u32,
        /// Answer as JSON.
        #[arg(long)]
        json: bool,
        /// Folder of aesthetics.onnx.
        #[arg(long, value_name = "DIR")]
        models: Option<PathBuf>,
        /// A photo to draw them on; each style then has a score from 0 to 1.
        photo: Option<PathBuf>,
    },
    /// List the filter blocks.
    Blocks(Listing),
    /// List the page templates.
    Layouts(Listing),
    /// List the designed styles.
    Styles(Listing),
}

#[derive(clap::Args)]
struct Listing {
    /// Answer as JSON.
    #[arg(long)]
    json: bool,
}

#[derive(clap::Args)]
struct Render {
    #[command(flatten)]
    planned: Planned,
    /// Of a saved project: which of its pages, from 1; the one that was edited last unless told.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    page: Option<u32>,
    /// Where the page goes: a file that ends in .png, .jpg or .pdf.
    #[arg(short, long, required_unless_present = "json")]
    output: Option<PathBuf>,
    /// The photos, in their order where they do not say when they were taken; or one saved project (.inkpanel), or one
    /// PNG of a page with its project and photos.
    #[arg(required = true)]
    files: Vec<PathBuf>,
}

/// What a page is planned by. A saved one is planned already.
#[derive(clap::Args, Default, PartialEq)]
struct Planned {
    /// Id of a page template, or a layout file.
    #[arg(long, value_name = "ID|FILE")]
    layout: Option<String>,
    /// Id of a designed style, or a style file.
    #[arg(long, value_name = "ID|FILE")]
    style: Option<String>,
    /// Seed of what is left to chance; 1 unless told.
    #[arg(long)]
    seed: Option<u32>,
    /// Width of the page in pixels, 2480 unless told; the height follows from A4 upright.
    #[arg(long, value_name = "PX", value_parser = clap::value_parser!(u32).range(64..=9800))]
    width: Option<u32>,
    /// Number of panels.
    #[arg(long)]
    panels: Option<usize>,
    /// Let two panels share one image.
    #[arg(long)]
    merge: bool,
    /// Do not look for faces and objects: crops follow the contrast alone.
    #[arg(long)]
    no_detect: bool,
    /// Folder of faces.onnx and objects.onnx.
    #[arg(long, value_name = "DIR")]
    models: Option<PathBuf>,
    /// Captions, balloons and sound effects: a JSON array of words, as the page keeps them.
    #[arg(long, value_name = "FILE")]
    words: Option<PathBuf>,
    /// Make a storyboard of so many pages, cut where time or scene changes: a PDF file, or files such as page-%02d.png.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pages: Option<u32>,
    /// Print the plan: layout, photos, crops, style, score and its terms.
    #[arg(long)]
    json: bool,
    /// Name of a photo that gets the large panel; may be said again.
    #[arg(long, value_name = "FILE")]
    star: Vec<PathBuf>,
}

/// A sentence about what went wrong, for people.
type Complaint = String;

fn main() -> ExitCode {
    let done = match Cli::parse().command {
        Command::Render(render) => render_page(&render),
        Command::Score { plan, json, models, no_detect } => {
            plans::score(&plan, json, !no_detect, models.as_deref())
        }
        Command::Stylize { style, input, output } => stylize_photo(&style, &input, &output),
        Command::Select { files, json, threshold } => select_photos(&files, json, threshold),
        Command::Detect { files, json, models } => detect_photos(&files, json, models.as_deref()),
        Command::Generate { seed, count, json, models, photo } => {
            inventor::invent(seed, count, photo.as_deref(), models.as_deref())
                .and_then(|styles| list(&styles, json))
        }
        Command::Blocks(listing) => list(&catalogue::blocks(), listing.json),
        Command::Layouts(listing) => list(&catalogue::layouts(), listing.json),
        Command::Styles(listing) => list(&catalogue::styles(), listing.json),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(complaint) => {
            eprintln!("inkpanel: {complaint}");
            ExitCode::from(1)
        }
    }
}

fn render_page(render: &Render) -> Result<(), Complaint> {
    let Render { planned, page, output, files } = render;
    if let Some(output) = output {
        drawing::Kind::of(output)?;
    }
    if let [file] = &files[..]
        && let Some(saved) = reopening::open(file)
    {
        if *planned != Planned::default() {
            return Err(format!(
                "{}: it is planned already, so --output and --page are all that it takes",
                file.display()
            ));
        }
        let output = output.as_deref().ok_or("say by --output where the page goes")?;
        return reopening::draw(saved?, file, *page, output);
    }
    if let Some(project) = files.iter().find(|file| reopening::is_project(file)) {
        return Err(format!("{}: a project is drawn alone", project.display()));
    }
    if page.is_some() {
        return Err("--page is of a saved project, and there is none".into());
    }
    plan_page(planned, output.as_deref(), files)
}

fn plan_page(render: &Planned, output: Option<&Path>, files: &[PathBuf]) -> Result<(), Complaint> {
    let layout = render.layout.as_deref().map(layout_value).transpose()?;
    let style = render.style.as_deref().map(style_value).transpose()?;
    let mut photos = import_all(files);
    if !render.no_detect {
        add_subjects(&mut photos, render.models.as_deref());
    }
    for (path, photo) in &mut photos {
        photo.meta.starred = render.star.contains(path);
    }
    let measures: Vec<Measures> = photos.iter().map(|(_, photo)| photo.measures.clone()).collect();
    let names: Vec<&str> = photos.iter().map(|(path, _)| name(path)).collect();
    let verdicts = select::choose(&names, &measures, &select::Settings::default());
    let mut used: Vec<_> =
        photos.iter().zip(&verdicts).filter(|(_, v)| v.kept).map(|(p, _)| &p.1.meta).collect();
    if used.iter().all(|meta| meta.taken.is_some()) {
        used.sort_by(|a, b| a.taken.cmp(&b.taken));
    }
    let page = plans::page_of_width(render.width.unwrap_or(PageSettings::default().width));
    let request = Request {
        seed: render.seed.unwrap_or(1),
        photos: used.into_iter().cloned().collect(),
        page,
        layout,
        style,
        panels: render.panels,
        merge: Some(render.merge),
        ..Request::default()
    };
    let mut pages = plans::pages(&request, render.pages.map(|pages| pages as usize))?;
    if let (Some(file), Some(first)) = (&render.words, pages.first_mut()) {
        drawing::add_words(&mut first.document, file, &photos)?;
    }
    let paths: HashMap<&str, &Path> =
        photos.iter().map(|(path, photo)| (photo.meta.id.as_str(), path.as_path())).collect();
    let full = |id: &str| paths.get(id).map(|path| decode_file(path)).transpose();
    match output {
        Some(output) if render.pages.is_some() => plans::draw_all(&pages, &full, output)?,
        Some(output) => write(output, &drawing::draw(&pages[0].document, &full, output)?)?,
        None => {}
    }
    if render.json {
        print(&plans::told(&pages, &photos)?)?;
    }
    Ok(())
}

fn stylize_photo(style: &str, input: &Path, output: &Path) -> Result<(), Complaint> {
    let style = read_style(style)?;
    let image = decode_file(input)?;
    let mut context = Context::for_image(&image);
    let drawn = stylize(&image, &style, &mut context).map_err(|error| error.to_string())?;
    let png = png::encode_rgb(drawn.width(), drawn.height(), &drawn.to_rgb(), 96)
        .map_err(|error| error.to_string())?;
    write(output, &png)
}

fn select_photos(files: &[PathBuf], as_json: bool, threshold: u32) -> Result<(), Complaint> {
    let photos = import_all(files);
    if photos.is_empty() {
        return Err(Error::NoPhotos.to_string());
    }
    let names: Vec<&str> = photos.iter().map(|(path, _)| name(path)).collect();
    let measures: Vec<Measures> = photos.iter().map(|(_, photo)| photo.measures.clone()).collect();
    let settings = select::Settings { threshold };
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
        println!("{}", Value::Array(rows));
    } else {
        for ((path, _), verdict) in photos.iter().zip(&verdicts) {
            let mark = if verdict.kept { "keep" } else { "skip" };
            println!("{mark}  {}  {}", path.display(), verdict.why);
        }
    }
    Ok(())
}

fn detect_photos(files: &[PathBuf], as_json: bool, models: Option<&Path>) -> Result<(), Complaint> {
    let detectors = detectors::load(models)?;
    let photos = import_all(files);
    if photos.is_empty() {
        return Err(Error::NoPhotos.to_string());
    }
    let found = detectors::run(&detectors, &photos);
    let rows = photos.iter().zip(&found).map(|((path, photo), found)| {
        json!({ "file": path.display().to_string(), "boxes": detectors::boxes(photo, found) })
    });
    if as_json {
        println!("{}", Value::Array(rows.collect()));
        return Ok(());
    }
    for ((path, _), found) in photos.iter().zip(&found) {
        let words: Vec<String> =
            found.iter().map(|d| format!("{} {:.0} %", d.label, d.score * 100.0)).collect();
        println!("{}  {}", path.display(), words.join(", "));
    }
    Ok(())
}

/// Tells framing what is in the photos; without the nets it goes by contrast, which is said once.
fn add_subjects(photos: &mut [(PathBuf, Imported)], models: Option<&Path>) {
    let detectors = match detectors::load(models) {
        Ok(detectors) => detectors,
        Err(complaint) => return eprintln!("inkpanel: {complaint}; cropping by contrast alone"),
    };
    let found = detectors::run(&detectors, photos);
    for ((_, photo), found) in photos.iter_mut().zip(found) {
        photo.meta.find(found.into_iter().map(Into::into));
    }
}

/// Prints JSON; a reader that has gone away is no failure.
fn print(value: &Value) -> Result<(), Complaint> {
    list(value, true)
}

/// Prints a catalogue; a reader that has gone away is no failure.
fn list(catalogue: &impl serde::Serialize, as_json: bool) -> Result<(), Complaint> {
    // As text first: a value of JSON would make other numbers of those of layouts than the page is told.
    let text = serde_json::to_string(catalogue).map_err(|error| error.to_string())?;
    let catalogue: Value = serde_json::from_str(&text).map_err(|error| error.to_string())?;
    let mut out = std::io::stdout().lock();
    let print = |out: &mut dyn std::io::Write| -> std::io::Result<()> {
        if as_json {
            return writeln!(out, "{text}");
        }
        for item in catalogue.as_array().into_iter().flatten() {
            let field = |key: &str| item[key].as_str().unwrap_or_default();
            let label = if field("name").is_empty() { field("label") } else { field("name") };
            writeln!(out, "{:<24}{label}", field("id"))?;
        }
        Ok(())
    };
    match print(&mut out) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(error.to_string()),
        _ => Ok(()),
    }
}

/// Reads files side by side; names those that cannot be read and goes on without them.
fn import_all(files: &[PathBuf]) -> Vec<(PathBuf, Imported)> {
    let limits = Limits::default();
    let read: Vec<Result<Imported, Complaint>> = files
        .par_iter()
        .enumerate()
        .map(|(i, path)| {
            let bytes = std::fs::read(path).map_err(|error| error.to_string())?;
            survived(|| import(&format!("photo-{i}"), &bytes, &limits))
        })
        .collect();
    let mut photos = Vec::new();
    for (path, photo) in files.iter().zip(read) {
        match photo {
            Ok(photo) => photos.push((path.clone(), photo)),
            Err(complaint) => eprintln!("inkpanel: {}: {complaint}; left out", path.display()),
        }
    }
    photos
}

/// What `work` on one file gives. Where it panics, which is a fault of ours or of a decoder, that is the error of this file
/// and no other; the sentence of the panic is on standard error by then.
fn survived<T>(work: impl FnOnce() -> inkpanel::Result<T>) -> Result<T, Complaint> {
    // Nothing that the work may have left half done is looked at again.
    match catch_unwind(AssertUnwindSafe(work)) {
        Ok(done) => done.map_err(|error| error.to_string()),
        Err(_) => Err("reading it failed by a fault of Inkpanel, please report it".to_owned()),
    }
}

fn decode_file(path: &Path) -> Result<Image, Complaint> {
    decode_file_fit(path, usize::MAX)
}

fn decode_file_fit(path: &Path, longest: usize) -> Result<Image, Complaint> {
    let complain = |reason: String| format!("{}: {reason}", path.display());
    let bytes = std::fs::read(path).map_err(|error| complain(error.to_string()))?;
    survived(|| decode_fit(&bytes, &Limits::default(), longest))
        .map(|decoded| decoded.image)
        .map_err(complain)
}

fn read_style(id_or_file: &str) -> Result<Style, Complaint> {
    if !Path::new(id_or_file).is_file() {
        return style::catalogue::find(id_or_file).cloned().map_err(|error| error.to_string());
    }
    let json = std::fs::read_to_string(id_or_file).map_err(|error| format!("{id_or_file}: {error}"))?;
    Style::parse(id_or_file, &json).map_err(|error| error.to_string())
}

fn style_value(id_or_file: &str) -> Result<Value, Complaint> {
    read_style(id_or_file).map(|style| style.to_value())
}

fn layout_value(id_or_file: &str) -> Result<Value, Complaint> {
    if !Path::new(id_or_file).is_file() {
        return Ok(Value::String(id_or_file.to_owned()));
    }
    let json = std::fs::read_to_string(id_or_file).map_err(|error| format!("{id_or_file}: {error}"))?;
    Template::parse(id_or_file, &json).map_err(|error| error.to_string())?;
    serde_json::from_str(&json).map_err(|error| format!("{id_or_file}: {error}"))
}

fn name(path: &Path) -> &str {
    path.file_name().and_then(|name| name.to_str()).unwrap_or("?")
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), Complaint> {
    std::fs::write(path, bytes).map_err(|error| format!("{}: {error}", path.display()))
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
