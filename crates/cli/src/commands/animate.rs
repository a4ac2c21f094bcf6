//! Renders videos of saved projects on the command line as numbered PNG files: the shots of a storyboard in
//! order, or animated pages. `output::animatic` and `output::motion` plan the frames; this module draws and
//! writes them.

mod drawn;
mod pages;
mod reel;
mod shots;

use crate::destination::print_lines;
use crate::run::Run;
use crate::{CliError, drawing, input, reopening};
use drawn::Drawn;
use inkpanel_engine::document::saved::Saved;
use inkpanel_engine::output::animatic::{Animatic, SIDES, SIZES};
use pages::Pages;
use reel::{Reel, Step, frame_file};
use serde_json::{Value, json};
use shots::Shots;
use std::path::PathBuf;

/// Arguments of `inkpanel animate`.
#[derive(clap::Args)]
#[allow(clippy::struct_excessive_bools, reason = "each is a separate option")]
pub(crate) struct Animate {
    /// Saved project: an .inkpanel file, or a page PNG that contains its project and photos.
    project: PathBuf,
    /// Folder for the frames frame-00001.png and so on. It is created if missing.
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Animate the pages panel by panel, instead of the shots of the storyboard.
    #[arg(long)]
    pages: bool,
    /// Frame size: 1080p, 720p, square, upright, or pixels such as 960x540.
    #[arg(long, value_name = "NAME|WxH", default_value = "1080p", value_parser = size)]
    size: [u32; 2],
    /// Frames per second. [default: the storyboard's rate, or 24 with --pages]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=60))]
    fps: Option<u32>,
    /// Duration of a shot without one, in seconds. With --pages: minimum time per panel, at most 60.
    #[arg(long, value_name = "SECONDS", default_value = "2", value_parser = seconds::<3600>)]
    seconds: f64,
    /// Duration of the dissolve between shots, in seconds; 0 for cuts. With --pages: between pages, at most 1.
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = seconds::<10>)]
    dissolve: f64,
    /// Disable camera movement.
    #[arg(long)]
    still: bool,
    /// Add the dialogue or the action below each shot (shots only).
    #[arg(long)]
    captions: bool,
    /// Style id or style file (shots only). [default: the style of the project's page]
    #[arg(long, value_name = "ID|FILE")]
    style: Option<String>,
    /// Fallback font file (TrueType or OpenType) for missing characters. Can be repeated.
    #[arg(long, value_name = "FILE")]
    font: Vec<PathBuf>,
    /// Skip existing frames, to resume a run.
    #[arg(long)]
    skip_existing: bool,
    /// Print the shots or pages and their frames as JSON. Progress on standard error is one JSON object per line.
    #[arg(long)]
    pub(crate) json: bool,
}

/// Writes the frames.
///
/// # Errors
/// A sentence. Frames written before remain.
pub(crate) fn animate(run: &Run, asked: &Animate) -> Result<(), CliError> {
    if asked.pages {
        pages::check(asked)?;
    }
    let saved = reopening::open(run, &asked.project).ok_or_else(|| {
        CliError::new("unknown-format", "not an Inkpanel project").at(input::told(&asked.project))
    })??;
    let complain = |error: CliError| error.at(input::told(&asked.project));
    let fonts = drawing::fonts(run, &asked.font)?;
    if asked.pages {
        let pages = Pages::of(run, saved, asked, fonts).map_err(complain)?;
        return film(
            run,
            &pages.plan,
            (&pages.steps(), &|clip| pages.drawn(clip)),
            ("pages", pages.told()),
            asked,
        );
    }
    let shots = Shots::of(run, saved, asked, &fonts).map_err(complain)?;
    film(run, &shots.plan, (&shots.steps(), &|clip| shots.drawn(clip)), ("shots", shots.told()), asked)
}

/// Writes the frames of a plan, and reports the result.
fn film(
    run: &Run,
    plan: &Animatic,
    (steps, draw): (&[Step], &(dyn Fn(usize) -> Result<Drawn, CliError> + Sync)),
    told: (&str, Value),
    asked: &Animate,
) -> Result<(), CliError> {
    std::fs::create_dir_all(&asked.output).map_err(|error| CliError::writing(&asked.output, &error))?;
    Reel { run, plan, draw, folder: &asked.output, skips: asked.skip_existing }.write(steps)?;
    let beyond = frame_file(&asked.output, plan.frames);
    if beyond.exists() {
        let why = format!("belongs to a longer animatic in this folder; the new one ends at {}", plan.frames);
        run.report.note(Some(&beyond.display().to_string()), &why);
    }
    tell(plan, told, asked)
}

/// Prints the result as JSON, or the ffmpeg command for a video.
fn tell(plan: &Animatic, (of, told): (&str, Value), asked: &Animate) -> Result<(), CliError> {
    let pattern = asked.output.join("frame-%05d.png").display().to_string();
    if !asked.json {
        let rate = (plan.rate * 1000.0).round() / 1000.0;
        return print_lines([format!("{pattern}  {} frames, {rate} per second", plan.frames)]);
    }
    crate::destination::print_json(&json!({
        "frames": plan.frames, "fps": plan.fps, "rate": plan.rate, "width": plan.size[0], "height": plan.size[1],
        "files": pattern, of: told,
    }))
}

/// Returns whether a photo is a video frame.
fn is_of_film(saved: &Saved, photo: &str) -> bool {
    saved.photo(photo).is_some_and(|photo| photo.video.is_some() && photo.time.is_some())
}

/// Warns about panels that show video frames. They move in videos of the app, which decodes the videos of a
/// project, but not here. `called`: the noun for one of them, and for several.
fn tell_still(run: &Run, count: usize, called: (&str, &str)) {
    match count {
        0 => {}
        1 => run.report.note(None, &format!("1 {} is a video frame; here it does not move", called.0)),
        _ => run.report.note(None, &format!("{count} {} are video frames; here they do not move", called.1)),
    }
}

fn size(text: &str) -> Result<[u32; 2], String> {
    if let Some((_, size)) = SIZES.iter().find(|(name, _)| *name == text) {
        return Ok(*size);
    }
    let sides: Option<Vec<u32>> = text.split('x').map(|side| side.parse().ok()).collect();
    let [least, most] = SIDES;
    match sides.as_deref() {
        Some(&[width, height]) if [width, height].iter().all(|side| (least..=most).contains(side)) => {
            Ok([width, height])
        }
        _ => {
            let names: Vec<&str> = SIZES.iter().map(|(name, _)| *name).collect();
            Err(format!(
                "expected one of {}, or WIDTHxHEIGHT such as 960x540, each {least} to {most} pixels",
                names.join(", ")
            ))
        }
    }
}

fn seconds<const MOST: u32>(text: &str) -> Result<f64, String> {
    let told = text.trim_end_matches('s').parse::<f64>().ok();
    told.filter(|told| (0.0..=f64::from(MOST)).contains(told))
        .ok_or_else(|| format!("it is a number of seconds from 0 to {MOST}"))
}
