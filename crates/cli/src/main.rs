//! The command line: batch rendering, goldens and debugging with the same code as the page.
//!
//! Progress and errors are printed to standard error, results to standard output. Exit codes: 0 done, 1 bad
//! input, 2 wrong usage (from the argument parser).

#![deny(clippy::print_stdout, clippy::print_stderr, reason = "a closed pipe makes them panic")]

mod args;
mod boards;
mod cli_error;
mod commands;
mod config_file;
mod destination;
mod detectors;
mod documents;
mod drawing;
mod format;
mod input;
mod language;
mod masks;
mod own_pages;
mod paper;
mod photos;
mod plans;
mod projects;
mod reading;
mod reopening;
mod report;
mod run;
mod strips;

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};
use inkpanel_engine::page::catalogue;
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::ExitCode;

use cli_error::CliError;
use commands::{animate, book, detect, generate, imitate, render, segment, select, shots, stylize};
use destination::list;
use report::Report;
use run::Run;

/// Turn photos into stylised comic pages and storyboards.
#[derive(Parser)]
#[command(name = "inkpanel", version, about, after_help = EXIT_CODES)]
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

#[derive(Subcommand)]
enum Command {
    /// Make a comic page or several from photos, or draw a saved page.
    #[command(after_help = render::HELP)]
    Render(Box<render::Render>),
    /// Make a book from photos: a cover, chapters by day with captions, page numbers and an end page.
    #[command(after_help = book::HELP)]
    Book(Box<book::Book>),
    /// Score the pages of a plan that `render --json` printed.
    #[command(
        after_help = "Example:\n  inkpanel render --json photos/ > plan.json && inkpanel score plan.json"
    )]
    Score(plans::ScoreArgs),
    /// Apply a style to one photo.
    #[command(after_help = "Example:\n  inkpanel stylize --style noir photo.jpg -o noir.png")]
    Stylize(stylize::StylizeArgs),
    /// Report which photos are worth a panel, and why.
    #[command(after_help = "Example:\n  inkpanel select photos/ --json")]
    Select(select::SelectArgs),
    /// Detect faces and objects.
    Detect(detect::DetectArgs),
    /// Write a mask per photo that is white on the subject.
    Segment(segment::SegmentArgs),
    /// Generate random styles. Equal seeds give equal styles.
    #[command(after_help = "Example:\n  inkpanel generate --seed 7 --count 20 --json photo.jpg")]
    Generate(generate::GenerateArgs),
    /// Find styles that make a photo look like a given picture.
    #[command(after_help = "Example:\n  inkpanel imitate poster.jpg photo.jpg --json")]
    Imitate(imitate::ImitateArgs),
    /// Detect the shots of a video and pick a frame for each (needs ffmpeg).
    #[command(after_help = "Example:\n  inkpanel shots clip.mp4 --frames 12 --json")]
    Shots(shots::ShotsArgs),
    /// Write the animatic of a saved project as numbered PNG frames.
    #[command(after_help = EXIT_CODES)]
    Animate(Box<animate::Animate>),
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

/// Exit code for wrong usage.
const USAGE: u8 = 2;

fn main() -> ExitCode {
    let arguments: Vec<OsString> = std::env::args_os().collect();
    let mut report = Report::new(wants_json(&arguments));
    let (arguments, listed) = match config_file::expanded::<Cli>(arguments) {
        Ok(expanded) => expanded,
        Err(error) => return failed(&report, &error, USAGE),
    };
    // The settings may ask for JSON as well.
    report.json = wants_json(&arguments);
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(error) => return wrong_usage(&report, &error),
    };
    report.json |= matches!(&cli.command, Command::Animate(animate) if animate.json);
    let mut run = Run::new(report);
    if let Err(error) = detectors::set_painters(&mut run, cli.painters.as_deref()) {
        return failed(&run.report, &error, 1);
    }
    let run = &run;
    let done = match cli.command {
        Command::Render(mut render) => {
            if render.files.is_empty() {
                render.files = listed;
            }
            if render.files.is_empty() && render.document.is_none() {
                let why = "no photos and no saved project given";
                return wrong_usage(
                    &run.report,
                    &Cli::command().error(ErrorKind::MissingRequiredArgument, why),
                );
            }
            render::render(run, &render)
        }
        Command::Book(mut book) => {
            if book.files.is_empty() {
                book.files = listed;
            }
            book::make(run, &book)
        }
        Command::Score(score) => plans::score(run, &score),
        Command::Stylize(stylize) => stylize::stylize_photo(run, &stylize),
        Command::Select(select) => select::select_photos(run, &select),
        Command::Detect(detect) => detect::detect_photos(run, &detect),
        Command::Segment(segment) => segment::segment(run, &segment),
        Command::Generate(generate) => {
            generate::invent(run, &generate).and_then(|styles| list(&styles, generate.json))
        }
        Command::Imitate(imitate) => {
            imitate::imitate(run, &imitate).and_then(|styles| list(&styles, imitate.json))
        }
        Command::Animate(animate) => animate::animate(run, &animate),
        Command::Shots(shots) => shots::shots_of(run, &shots),
        Command::Blocks(listing) => list(&catalogue::blocks(), listing.json),
        Command::Layouts(listing) => list(&catalogue::layouts(), listing.json),
        Command::Styles(listing) => list(&catalogue::styles(), listing.json),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => failed(&run.report, &error, 1),
    }
}

/// Reports an error.
fn failed(report: &Report, error: &CliError, code: u8) -> ExitCode {
    report.failure(error);
    ExitCode::from(code)
}

/// Reports an error of the argument parser, or prints the requested help.
fn wrong_usage(report: &Report, error: &clap::Error) -> ExitCode {
    if !(report.json && error.use_stderr()) {
        error.exit();
    }
    let text = error.render().to_string();
    let lines: Vec<&str> = text.lines().map(str::trim).take_while(|line| !line.is_empty()).collect();
    let message = lines.join(" ");
    failed(report, &message.strip_prefix("error: ").unwrap_or(&message).into(), USAGE)
}

/// Whether the arguments ask for progress as JSON. Errors of the arguments follow the format as well.
fn wants_json(arguments: &[OsString]) -> bool {
    let options = || arguments.iter().take_while(|argument| *argument != "--");
    options().any(|argument| argument == "--progress=json")
        || options().zip(options().skip(1)).any(|(option, form)| option == "--progress" && form == "json")
}

#[cfg(test)]
mod tests {
    use super::*;
    use inkpanel::survived;
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
