//! Animatics on the command line: the frames of a saved project's shots as numbered PNG files. What a frame shows is told by
//! `output::animatic`; here it is drawn and written.

use crate::boards::{self, STYLE, ShotPhoto};
use crate::destination::Output;
use crate::segments::Masks;
use crate::{Complaint, album, read_style, reopening, survived, telling};
use inkpanel::Error;
use inkpanel::document::saved::Saved;
use inkpanel::framing::Crop;
use inkpanel::native;
use inkpanel::output::animatic::{Animatic, Clip, Picture, Request, SIDES, SIZES, Shown};
use inkpanel::output::board::PictureOf;
use inkpanel::page::compose::{Sheet, mix};
use inkpanel::page::words::draw;
use inkpanel::page::words::given::GivenFonts;
use inkpanel::page::{Document, Patch, png};
use inkpanel::raster::Image;
use inkpanel::raster::decode::{Limits, decode};
use inkpanel::raster::resize::{Region, resample_image};
use rayon::prelude::*;
use serde_json::{Value, json};
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// Dots an inch that the frames say they have, as screens do.
const DPI: u32 = 96;

/// What `inkpanel animate` is told.
#[derive(clap::Args)]
#[allow(clippy::struct_excessive_bools, reason = "each is an option of its own")]
pub(crate) struct Animate {
    /// The saved project (.inkpanel, or a PNG of a page that carries its project and photos).
    project: PathBuf,
    /// Folder of the frames, frame-00001.png and so on; it is made where it is not there.
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Size of the frames: 1080p, 720p, square, upright, or such as 960x540, in pixels.
    #[arg(long, value_name = "NAME|WxH", default_value = "1080p", value_parser = size)]
    size: [u32; 2],
    /// Frames a second; those of the project's board unless told.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=60))]
    fps: Option<u32>,
    /// How long a shot is that says nothing.
    #[arg(long, value_name = "SECONDS", default_value = "2", value_parser = seconds::<3600>)]
    seconds: f64,
    /// Let each shot go over into the next within so many seconds; 0 cuts.
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = seconds::<10>)]
    dissolve: f64,
    /// Let the camera stand still: each shot is one picture.
    #[arg(long)]
    still: bool,
    /// Write below each shot what is said, else what happens.
    #[arg(long)]
    captions: bool,
    /// Id of a designed style, or a style file; that of the project's page unless told.
    #[arg(long, value_name = "ID|FILE")]
    style: Option<String>,
    /// A TrueType or OpenType font for letters of captions that the program's own lack; may be said again.
    #[arg(long, value_name = "FILE")]
    font: Vec<PathBuf>,
    /// Leave frames that are there as they are, so that work that was stopped goes on.
    #[arg(long)]
    skip_existing: bool,
    /// Tell the shots and their frames as JSON, and the progress on standard error as a line of JSON for each step.
    #[arg(long)]
    json: bool,
}

/// Writes the frames.
///
/// # Errors
/// A sentence; frames that were written by then stay.
pub(crate) fn animate(asked: &Animate) -> Result<(), Complaint> {
    if asked.json {
        telling::as_json();
    }
    let saved = reopening::open(&asked.project)
        .ok_or_else(|| format!("{}: this is no project of Inkpanel", album::told(&asked.project)))??;
    let complain = |reason: String| format!("{}: {reason}", album::told(&asked.project));
    let mut fonts = GivenFonts::default();
    for path in &asked.font {
        let complain = |reason: String| format!("{}: {reason}", path.display());
        fonts.add(album::read(path).map_err(complain)?).map_err(|reason| complain(reason.to_owned()))?;
    }
    let masks = reopening::masks(&saved);
    let (plan, photos) = planned(saved, asked).map_err(complain)?;
    std::fs::create_dir_all(&asked.output).map_err(|error| format!("{}: {error}", asked.output.display()))?;
    let captions = captions(&plan, &fonts)?;
    let (folder, skips) = (&*asked.output, asked.skip_existing);
    Reel { plan: &plan, photos: &photos, masks, captions, folder, skips }.write()?;
    let beyond = frame_file(&asked.output, plan.frames);
    if beyond.exists() {
        let why =
            format!("is of a longer animatic that was written here before; this one ends at {}", plan.frames);
        telling::note(Some(&beyond.display().to_string()), &why);
    }
    tell(&plan, asked)
}

/// The plan of a project's animatic, and the photos of its shots.
fn planned(mut saved: Saved, asked: &Animate) -> Result<(Animatic, Vec<ShotPhoto>), Complaint> {
    let found = reopening::known(&saved);
    let photos = boards::shown(&mut saved)?;
    let aspect = f64::from(asked.size[0]) / f64::from(asked.size[1]);
    let pictures = boards::framed(&photos, aspect, &found)?;
    let picture = |PictureOf { photo, crop, faces }: PictureOf| {
        let told = |error: serde_json::Error| error.to_string();
        let subjects = found.get(&photo).cloned().unwrap_or_default();
        Ok(Picture {
            photo,
            crop: serde_json::from_value(crop).map_err(told)?,
            faces: serde_json::from_value(faces).map_err(told)?,
            subjects,
        })
    };
    let pictures = pictures.into_iter().map(picture).collect::<Result<_, Complaint>>()?;
    let project = saved.project();
    let page = project.history.present.page.as_ref();
    let style = match &asked.style {
        Some(style) => read_style(style)?.to_value(),
        None => page.map_or_else(|| json!(STYLE), |page| page.style.clone()),
    };
    let request = Request {
        list: project.shot_list(),
        pictures,
        size: asked.size,
        fps: asked.fps.unwrap_or(0),
        seconds: asked.seconds,
        dissolve: asked.dissolve,
        moves: !asked.still,
        captions: asked.captions,
        living: 0,
        style,
    };
    Ok((request.planned().map_err(|error| error.to_string())?, photos))
}

/// The captions of the clips, where they have one, in their places of a frame.
fn captions(plan: &Animatic, fonts: &GivenFonts) -> Result<Vec<Option<Patch>>, Complaint> {
    let told = |error: Error| error.to_string();
    let words = || plan.clips.iter().map(|clip| &clip.caption["words"][0]).filter(|word| word.is_object());
    let letters = fonts.letters(words()).map_err(told)?;
    let [width, height] = plan.size.map(|side| side as usize);
    let caption = |clip: &Clip| {
        if clip.caption.is_null() {
            return Ok(None);
        }
        let document = Document::parse(&clip.caption.to_string()).map_err(told)?;
        let mut patch = draw::render(&document, 0, width, &letters).map_err(told)?;
        let foot = (Animatic::FOOT * height as f64).round() as i64;
        patch.area.x = (width as i64 - patch.area.width as i64) / 2;
        patch.area.y = (height as i64 - foot - patch.area.height as i64).max(0);
        Ok(Some(patch))
    };
    plan.clips.iter().map(caption).collect()
}

/// What frames are made of.
struct Reel<'a> {
    plan: &'a Animatic,
    photos: &'a [ShotPhoto],
    masks: Masks,
    captions: Vec<Option<Patch>>,
    folder: &'a Path,
    skips: bool,
}

impl Reel<'_> {
    /// Writes all frames, those of one shot side by side. Pictures are drawn when a frame needs them, and forgotten behind it.
    fn write(&self) -> Result<(), Complaint> {
        let mut pictures: HashMap<usize, Image> = HashMap::new();
        for (i, clip) in self.plan.clips.iter().enumerate() {
            let frames = clip.start..clip.start + clip.frames;
            let there = |frame: &u32| self.skips && self.output(*frame).exists();
            let wanted: Vec<u32> = frames.filter(|frame| !there(frame)).collect();
            pictures.retain(|&clip, _| clip + 1 >= i);
            let shown = |frame: &u32| self.plan.at(*frame).into_iter().flat_map(|(a, b)| [Some(a), b]);
            for Shown { clip, .. } in wanted.iter().flat_map(shown).flatten() {
                if let Entry::Vacant(place) = pictures.entry(clip) {
                    place.insert(self.picture(clip)?);
                }
            }
            // Frames that are the same picture are made once.
            let still = OnceLock::new();
            wanted.par_iter().try_for_each(|&frame| self.frame(frame, &pictures, &still))?;
            let skipped = clip.frames as usize - wanted.len();
            let event = json!({
                "event": "shot", "shot": clip.number, "done": i + 1, "of": self.plan.clips.len(),
                "frames": clip.start + clip.frames, "of_frames": self.plan.frames, "skipped": skipped,
            });
            let more = if skipped > 0 { format!(", {skipped} of them there") } else { String::new() };
            let sentence = format!(
                "{} of {}: shot {}, frames {} to {}{more}",
                i + 1,
                self.plan.clips.len(),
                clip.number,
                clip.start + 1,
                clip.start + clip.frames
            );
            telling::step(&event, Some(sentence));
        }
        Ok(())
    }

    fn output(&self, frame: u32) -> Output {
        let path = frame_file(self.folder, frame);
        Output { named: path.clone(), path }
    }

    /// The picture of a clip in its style, from the photo at its full size.
    fn picture(&self, clip: usize) -> Result<Image, Complaint> {
        let told = |error: Error| error.to_string();
        let document = Document::parse(&self.plan.clips[clip].picture.to_string()).map_err(told)?;
        let ShotPhoto { id, name, file } = &self.photos[clip];
        let photo = survived(|| decode(file, &Limits::default()))
            .map_err(|reason| format!("the photo {name}: {reason}"))?;
        let subject = self.masks.asked_by(&*document.style().map_err(told)?, id, &photo.image);
        let photos = HashMap::from([(id.clone(), native::Photo { image: photo.image, subject })]);
        let sheet = native::sheet(&document, &photos, &GivenFonts::default()).map_err(told)?;
        Image::from_interleaved_rgb(sheet.width(), sheet.height(), sheet.rgb()).map_err(told)
    }

    fn frame(
        &self,
        frame: u32,
        pictures: &HashMap<usize, Image>,
        still: &OnceLock<Vec<u8>>,
    ) -> Result<(), Complaint> {
        let Some((under, over)) = self.plan.at(frame) else { return Ok(()) };
        let clip = &self.plan.clips[under.clip];
        let plain = over.is_none() && clip.first == clip.last;
        if let Some(file) = still.get().filter(|_| plain) {
            return self.output(frame).write(file);
        }
        let mut rgb = self.layer(&under, pictures)?;
        if let Some(over) = over {
            let share = (over.share * 256.0).round().clamp(0.0, 256.0) as u32;
            mix(&mut rgb, &self.layer(&over, pictures)?, share);
        }
        let [width, height] = self.plan.size.map(|side| side as usize);
        let file = png::encode_rgb(width, height, &rgb, DPI).map_err(|error| error.to_string())?;
        self.output(frame).write(&file)?;
        if plain {
            // Another frame may have been as fast: it has the same.
            let _ = still.set(file);
        }
        Ok(())
    }

    /// A clip as it is seen, with its caption.
    fn layer(&self, shown: &Shown, pictures: &HashMap<usize, Image>) -> Result<Vec<u8>, Complaint> {
        let picture = pictures.get(&shown.clip).ok_or("a picture is missing by a fault of Inkpanel")?;
        let [width, height] = self.plan.size.map(|side| side as usize);
        let rgb = seen(picture, &shown.view, (width, height));
        let Some(patch) = &self.captions[shown.clip] else { return Ok(rgb) };
        let mut sheet = Sheet::of(width, height, rgb);
        sheet.lay(patch.area, &patch.rgba).map_err(|error| error.to_string())?;
        Ok(sheet.into_rgb())
    }
}

/// The part of a picture that fills a frame. Where that is the picture itself, it is that to the last bit.
fn seen(picture: &Image, view: &Crop, (width, height): (usize, usize)) -> Vec<u8> {
    let (wide, high) = (picture.width() as f64, picture.height() as f64);
    let region =
        Region { x: view.x * wide, y: view.y * high, width: view.width * wide, height: view.height * high };
    let whole = Region::whole(width, height);
    if (picture.width(), picture.height()) == (width, height) && region == whole {
        return picture.to_rgb();
    }
    resample_image(picture, region, width, height).to_rgb()
}

/// What was made: as JSON, else how ffmpeg makes a film of it.
fn tell(plan: &Animatic, asked: &Animate) -> Result<(), Complaint> {
    let pattern = asked.output.join("frame-%05d.png").display().to_string();
    if !asked.json {
        println!("{pattern}  {} frames, {} a second", plan.frames, (plan.rate * 1000.0).round() / 1000.0);
        return Ok(());
    }
    let shots: Vec<Value> = plan
        .clips
        .iter()
        .map(|clip| {
            json!({
                "shot": clip.number, "first": clip.start + 1, "frames": clip.frames,
                "from": clip.first, "to": clip.last,
            })
        })
        .collect();
    crate::print(&json!({
        "frames": plan.frames, "fps": plan.fps, "rate": plan.rate, "width": plan.size[0], "height": plan.size[1],
        "files": pattern, "shots": shots,
    }))
}

/// The file of a frame, which is counted from 0 and named from 1.
fn frame_file(folder: &Path, frame: u32) -> PathBuf {
    folder.join(format!("frame-{:05}.png", frame + 1))
}

fn size(text: &str) -> Result<[u32; 2], Complaint> {
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
                "a size is one of {}, or such as 960x540, {least} to {most} pixels a side",
                names.join(", ")
            ))
        }
    }
}

fn seconds<const MOST: u32>(text: &str) -> Result<f64, Complaint> {
    let told = text.trim_end_matches('s').parse::<f64>().ok();
    told.filter(|told| (0.0..=f64::from(MOST)).contains(told))
        .ok_or_else(|| format!("it is a number of seconds from 0 to {MOST}"))
}
