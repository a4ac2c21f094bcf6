//! The shots of a film, for the command line. Videos are decoded by two programs of `ffmpeg`, if it is
//! installed, through a pipe.

use crate::destination::{print_json, print_lines};
use std::ffi::OsString;
use std::io::{self, Read};
use std::path::Path;
use std::process::{Command, Stdio};

use inkpanel_engine::output::shots::timecode::StartTimecode;
use inkpanel_engine::select::look::{Look, Samples};
use inkpanel_engine::select::shots::{Film, Shot};
use inkpanel_engine::select::stills::{self, Still, Wish};
use serde_json::{Value, json};

use crate::CliError;
use crate::run::Run;
use std::path::PathBuf;

/// Frames are asked for in this width at most, in pixels.
const ACROSS: usize = 640;
/// A film of more frames is looked at less often.
const MOST_LOOKS: f64 = 20_000.0;
/// Tolerance in seconds between the last frame of a complete video and the duration in its header.
const SLACK: f64 = 0.5;
/// Maximum length of the messages of ffmpeg that are read, in bytes.
const MOST_MESSAGES: u64 = 1 << 16;

/// The shots of a video, with their times and the times of representative frames: `count` frames, or an
/// automatic number.
///
/// # Errors
/// A sentence, if ffmpeg is missing or cannot read the file.
pub(crate) fn shots(run: &Run, film: &Path, count: Option<usize>) -> Result<Value, CliError> {
    let about = About::of(film)?;
    let (seen, is_damaged) = look_at(film, &about)?;
    // The header of a truncated film still says how long it was.
    let end = seen.times().last().copied().unwrap_or_default() + 1.0 / about.rate;
    if let Some(whole) = about.film.filter(|whole| is_damaged && end < whole - SLACK) {
        let why = format!("the video is truncated: its frames end at {end:.2} s of {whole:.2} s");
        run.report.note(Some(&film.display().to_string()), &why);
    }
    let shots = seen.shots(end);
    let chosen = stills::choose(&seen, &shots, &Wish { count, ..Wish::default() });
    Ok(shots.iter().enumerate().map(|(i, shot)| told(i, shot, &chosen, &about)).collect())
}

fn told(number: usize, shot: &Shot, chosen: &[Still], about: &About) -> Value {
    let round = |seconds: f64| (seconds * 1000.0).round() / 1000.0;
    let frames: Vec<f64> =
        chosen.iter().filter(|still| still.shot == number).map(|still| round(still.time)).collect();
    let kind = if shot.usable.is_empty() {
        "empty"
    } else if shot.title {
        "title"
    } else {
        "picture"
    };
    let mut told = json!({ "shot": number + 1, "start": round(shot.start), "end": round(shot.end), "kind": kind, "frames": frames });
    if let Some(start) = about.timecode {
        told["timecode"] = start.at(shot.start, about.frame_rate).into();
    }
    told
}

/// Properties of a video.
struct About {
    width: usize,
    height: usize,
    /// Frames per second.
    frame_rate: f64,
    /// Frames a second that are looked at.
    rate: f64,
    /// The timecode of its first picture.
    timecode: Option<StartTimecode>,
    /// Duration of its video stream by its header, in seconds; `None` if the header does not say.
    film: Option<f64>,
}

/// The argument that names a file. Without the protocol ffmpeg takes a colon for a protocol, and a dash for an option.
fn named(film: &Path) -> OsString {
    let mut name = OsString::from("file:");
    name.push(film);
    name
}

/// The last message of ffmpeg, which says why it stopped, without the name of the file.
fn reason(messages: &[u8], film: &Path) -> String {
    let text = String::from_utf8_lossy(messages);
    let line = text.lines().last().unwrap_or_default();
    line.replace(&format!("file:{}: ", film.display()), "").trim().to_owned()
}

impl About {
    fn of(film: &Path) -> Result<Self, CliError> {
        let mut probe = Command::new("ffprobe");
        probe.args(["-v", "error", "-select_streams", "V:0", "-of", "json", "-show_entries"]);
        probe.arg("stream=width,height,avg_frame_rate,duration:stream_tags=timecode:format=duration");
        probe.arg(named(film)).stdin(Stdio::null());
        let answer = probe
            .output()
            .map_err(|_| CliError::new("no-ffmpeg", "videos need ffmpeg, which is not installed"))?;
        let name = film.display();
        let told: Value = serde_json::from_slice(&answer.stdout).unwrap_or_default();
        let stream = &told["streams"][0];
        let size = |field: &str| stream[field].as_u64().filter(|&size| size > 0 && size <= 16_384);
        let (Some(width), Some(height)) = (size("width"), size("height")) else {
            let why = reason(&answer.stderr, film);
            let why = if why.is_empty() { "it has no frames" } else { &why };
            return Err(CliError::new("unreadable", format!("{name}: ffmpeg cannot read this video: {why}")));
        };
        let seconds = |part: &Value| part["duration"].as_str().and_then(|text| text.parse::<f64>().ok());
        let whole = seconds(&told["format"]);
        let film = seconds(stream).or(whole);
        let duration = whole.unwrap_or(0.0);
        let rate = stream["avg_frame_rate"].as_str().and_then(|rate| {
            let (frames, seconds) = rate.split_once('/')?;
            Some(frames.parse::<f64>().ok()? / seconds.parse::<f64>().ok()?)
        });
        let frame_rate = rate.filter(|rate| rate.is_finite() && *rate > 0.0).unwrap_or(25.0);
        let timecode = stream["tags"]["timecode"].as_str();
        let timecode = timecode.and_then(|start| StartTimecode::parse(start, frame_rate.round() as u32));
        let rate = frame_rate.min(60.0);
        // Two even numbers, as half of them are chroma's.
        let across = (width as usize).min(ACROSS) / 2 * 2;
        let down = (height as usize * across / width as usize).max(2) / 2 * 2;
        let rate = if duration * rate > MOST_LOOKS { MOST_LOOKS / duration } else { rate };
        Ok(Self { width: across.max(2), height: down, frame_rate, rate, film, timecode })
    }
}

/// Looks at the frames of a film. Returns also whether ffmpeg complained of the file.
fn look_at(film: &Path, about: &About) -> Result<(Film, bool), CliError> {
    let mut ffmpeg = Command::new("ffmpeg");
    ffmpeg.args(["-v", "error", "-nostdin", "-noautorotate", "-i"]).arg(named(film));
    ffmpeg.args(["-map", "0:V:0", "-vf"]);
    // A video starts at its first picture, whatever the time of that picture in the file.
    let (rate, width, height) = (about.rate, about.width, about.height);
    ffmpeg.arg(format!("setpts=PTS-STARTPTS,fps={rate},scale={width}:{height}"));
    ffmpeg.args(["-pix_fmt", "yuv420p", "-f", "rawvideo", "-"]);
    ffmpeg.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let failed = |error: io::Error| CliError::new("no-ffmpeg", format!("ffmpeg: {error}"));
    let mut running = ffmpeg.spawn().map_err(failed)?;
    let mut out = running.stdout.take().ok_or_else(|| CliError::fault("ffmpeg has no output"))?;
    let mut said = running.stderr.take().ok_or_else(|| CliError::fault("ffmpeg has no output"))?;
    // Both pipes are read at once: ffmpeg stops while one of them is full.
    let messages = std::thread::spawn(move || {
        let mut messages = Vec::new();
        let _ = said.by_ref().take(MOST_MESSAGES).read_to_end(&mut messages);
        let _ = io::copy(&mut said, &mut io::sink());
        messages
    });
    let mut frame = vec![0; width * height * 3 / 2];
    let mut seen = Film::new();
    let mut number = 0;
    while out.read_exact(&mut frame).is_ok() {
        seen.add(f64::from(number) / about.rate, look(&frame, width, height)?);
        number += 1;
    }
    drop(out);
    running.wait().map_err(failed)?;
    let messages = messages.join().unwrap_or_default();
    if number == 0 {
        let why = format!("ffmpeg decoded no frames: {}", reason(&messages, film));
        return Err(CliError::new("unreadable", why).at(film.display()));
    }
    Ok((seen, !messages.is_empty()))
}

/// Looks at a frame in I420.
fn look(frame: &[u8], width: usize, height: usize) -> inkpanel_engine::Result<Look> {
    let (luma, chroma) = frame.split_at(width * height);
    let (blue, red) = chroma.split_at(chroma.len() / 2);
    let half = [width / 2, height / 2];
    let luma = Samples::new(luma, [width, 1], [width, height])?;
    let chroma = [Samples::new(blue, [half[0], 1], half)?, Samples::new(red, [half[0], 1], half)?];
    Ok(Look::of(&luma, [&chroma[0], &chroma[1]]))
}

/// Arguments of `inkpanel shots`.
#[derive(clap::Args)]
pub(crate) struct ShotsArgs {
    /// Video file.
    pub(crate) film: PathBuf,
    /// Number of frames. [default: depends on the number of shots]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub(crate) frames: Option<u32>,
    /// Print JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

pub(crate) fn shots_of(run: &Run, asked: &ShotsArgs) -> Result<(), CliError> {
    let shots = shots(run, &asked.film, asked.frames.map(|frames| frames as usize))?;
    if asked.json {
        return print_json(&shots);
    }
    print_lines(shots.as_array().into_iter().flatten().map(|shot| {
        let frames: Vec<String> =
            shot["frames"].as_array().into_iter().flatten().map(Value::to_string).collect();
        let kind = shot["kind"].as_str().unwrap_or_default();
        format!("{}\t{}\t{}\t{kind}\t{}", shot["shot"], shot["start"], shot["end"], frames.join(" "))
    }))
}
