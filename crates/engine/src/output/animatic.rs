//! Animatics: the shots of an album in sequence, with durations, cuts or dissolves, and slow camera moves.
//! The plan is plain data. [`Animatic::at`] returns the content of a frame. A shot is drawn once, as a page
//! of one panel, and the camera moves over that image. Its lines do not move, and a shot without a camera
//! move is equal in every frame.

use super::reading::{Reading, Told, between, eased};
use super::shots::ShotList;
use crate::error::{Error, Result};
use crate::framing::{Crop, FACE, Subject};
use crate::layout::PageSettings;
use crate::page::document::PanelContent;
use crate::page::words::{TextItem, TextKind};
use crate::page::{Document, LayoutRef, StyleRef};
use serde::{Deserialize, Serialize};
use serde_json::json;

/// Sides of a frame in pixels, from the smallest to the largest.
pub const SIDES: [u32; 2] = [64, 3840];
/// Frame sizes by common name.
pub const SIZES: [(&str, [u32; 2]); 4] =
    [("1080p", [1920, 1080]), ("720p", [1280, 720]), ("square", [1080, 1080]), ("upright", [1080, 1920])];
/// Frames of an animatic at most: four hours of thirty a second.
pub const MOST_FRAMES: u64 = 4 * 3600 * 30;
/// Default duration of a shot in seconds.
const USUAL_SECONDS: f64 = 2.0;
/// Zoom of a camera move per second, and minimum size of its narrow end, as shares of the wide end.
const CLOSER: f64 = 0.035;
const NARROWEST: f64 = 0.84;
/// A thing that was found with less confidence leads no camera.
const SURE: f64 = 0.5;
/// The width of captions, in widths of the frame.
const CAPTION: f64 = 0.86;
/// Text height, in shorter sides of the frame.
const LETTERS: f64 = 0.045;

/// Request of an animatic.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "AnimaticRequest", optional_fields))]
pub struct Request {
    /// The shots, and their frame rate.
    pub list: ShotList,
    /// The image of each shot.
    pub pictures: Vec<Picture>,
    /// Width and height of the frames in pixels, 64 to 3840. Rounded to even numbers, as encoders require.
    pub size: [u32; 2],
    /// Frames per second, 1 to 60. Default: the rate of the list.
    pub fps: u32,
    /// Default duration of a shot in seconds. Default: 2.
    pub seconds: f64,
    /// Duration of a dissolve in seconds; 0 for hard cuts.
    pub dissolve: f64,
    /// Whether the camera moves.
    pub moves: bool,
    /// Whether dialogue, or else captions or action, is shown as a caption.
    pub captions: bool,
    /// Frames per second of animated panels from videos; 0 for stills.
    pub living: u32,
    /// The style: an id, or a complete style.
    #[cfg_attr(test, ts(as = "Option<crate::page::document::StyleChoice>"))]
    pub style: StyleRef,
}

/// The image of a shot.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "AnimaticPicture"))]
pub struct Picture {
    /// Id of the photo.
    pub photo: String,
    /// The crop, with the aspect ratio of the frames.
    pub crop: Crop,
    /// Faces of the photo, which the style protects.
    #[serde(default)]
    pub faces: Vec<Crop>,
    /// Detected subjects. The camera prefers faces, then people and animals, then things.
    #[serde(default)]
    pub subjects: Vec<Subject>,
}

/// Shots in their times.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Animatic {
    /// Frames of a counted second.
    pub fps: u32,
    /// Frames per second of real time. Lower than the frame rate for NTSC (23.976 instead of 24).
    pub rate: f64,
    /// Width and height of the frames in pixels.
    pub size: [u32; 2],
    /// How many frames there are.
    pub frames: u32,
    /// Frames per second of animated panels, 0 without any.
    pub living: u32,
    /// The shots, or the pages, without gaps between them.
    pub clips: Vec<Clip>,
}

/// A shot in its time, or a page that is read.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "AnimaticClip"))]
pub struct Clip {
    /// Id of its photo; empty for a page.
    pub photo: String,
    /// The number of the shot, or of the page.
    pub number: String,
    /// Its first frame.
    pub start: u32,
    /// How long it is, in frames.
    pub frames: u32,
    /// First frame, including the dissolve from the shot before.
    pub from: u32,
    /// Index after the last frame, including the dissolve to the next shot.
    pub to: u32,
    /// View of the camera at `from`, in fractions of the image. Equal to `last` without a camera move.
    pub first: Crop,
    /// View of the camera at the end.
    pub last: Crop,
    /// The image as a page of one panel, large enough for the closest view.
    pub picture: Document,
    /// An empty page of the frame size with only the caption, if the shot has one. The caption is centred,
    /// its lower edge [`Animatic::FOOT`] above the lower edge of the frame.
    pub caption: Option<Document>,
    /// Reading order of a page, panel by panel; `None` for a shot.
    pub reading: Option<Reading>,
}

/// A clip as one frame shows it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shown {
    /// Which clip.
    pub clip: usize,
    /// The part of the image that fills the frame.
    pub view: Crop,
    /// Opacity over the clip below, 0 to 1.
    pub share: f64,
}

impl Request {
    /// Reads a request.
    ///
    /// # Errors
    /// Returns `invalid-document` if the JSON is not a valid request.
    pub fn parse(json: &str) -> Result<Self> {
        let request: Self =
            serde_json::from_str(json).map_err(|error| invalid("animatic", &error.to_string()))?;
        if request.list.fps > 60 {
            return Err(invalid("shots", "must have at most 60 frames per second"));
        }
        Ok(request)
    }

    /// The shots in their times.
    ///
    /// # Errors
    /// `invalid-document` without shots, for a wrong number of images, or for sizes, rates and durations out
    /// of range.
    pub fn planned(&self) -> Result<Animatic> {
        let (size, fps) = self.checked()?;
        let lengths = self.lengths(fps)?;
        let most = (self.dissolve.clamp(0.0, 10.0) * f64::from(fps)).round() as u32;
        // In a dissolve, each shot has at least one frame without the other shot.
        let dissolves: Vec<u32> = lengths.windows(2).map(|pair| most.min(pair[0].min(pair[1]) - 1)).collect();
        let dissolve = |cut: Option<usize>| cut.and_then(|cut| dissolves.get(cut)).copied().unwrap_or(0);
        let mut start = 0;
        let mut clips = Vec::with_capacity(lengths.len());
        for (i, ((shot, picture), &frames)) in
            self.list.shots.iter().zip(&self.pictures).zip(&lengths).enumerate()
        {
            let into = dissolve(i.checked_sub(1));
            let out_of = dissolve(Some(i));
            let (from, to) = (start - into / 2, start + frames + out_of.div_ceil(2));
            let seconds = f64::from(to - from) / f64::from(fps);
            let (first, last) =
                if self.moves { journey(picture, seconds, i) } else { [picture.crop; 2].into() };
            let seen = around(&first, &last);
            let texts = [&shot.dialogue, &shot.caption, &shot.action];
            let caption = texts.into_iter().find(|text| !text.trim().is_empty()).unwrap_or(&shot.action);
            clips.push(Clip {
                photo: picture.photo.clone(),
                number: shot.number.clone(),
                start,
                frames,
                from,
                to,
                first: within(&first, &seen),
                last: within(&last, &seen),
                picture: self.page(picture, &seen, &first, &last, size)?,
                caption: self.captions.then(|| caption_page(caption.trim(), size)).flatten(),
                reading: None,
            });
            start += frames;
        }
        let rate = if self.fps == 0 { self.list.rate().exact() } else { f64::from(fps) };
        Ok(Animatic { fps, rate, size, frames: start, living: self.living.min(fps), clips })
    }

    /// Size and rate.
    fn checked(&self) -> Result<([u32; 2], u32)> {
        if self.list.shots.is_empty() {
            return Err(invalid("shots", "must not be empty"));
        }
        if self.pictures.len() != self.list.shots.len() {
            return Err(invalid("pictures", "must have one entry per shot"));
        }
        let fps = match (self.fps, self.list.fps) {
            (0, 0) => 24,
            (0, fps) | (fps, _) => fps,
        };
        framed(self.size, fps)
    }

    /// How many frames each shot has. At another rate than the list's, the end times are rounded, so that the
    /// total duration stays the same.
    fn lengths(&self, fps: u32) -> Result<Vec<u32>> {
        let rate = u64::from(if self.list.fps == 0 { 24 } else { self.list.fps });
        let seconds = if self.seconds > 0.0 { self.seconds.min(3600.0) } else { USUAL_SECONDS };
        let usual = ((seconds * rate as f64).round() as u64).max(1);
        let (mut counted, mut end) = (0_u64, 0_u64);
        let mut lengths = Vec::with_capacity(self.list.shots.len());
        for shot in &self.list.shots {
            counted += shot.frames.map_or(usual, u64::from).max(1);
            let next = ((2 * counted * u64::from(fps) + rate) / (2 * rate)).max(end + 1);
            if next > MOST_FRAMES {
                return Err(invalid("shots", "must last at most four hours"));
            }
            lengths.push((next - end) as u32);
            end = next;
        }
        Ok(lengths)
    }

    /// The part of a photo that a shot shows, as a page of one panel.
    fn page(
        &self,
        picture: &Picture,
        seen: &Crop,
        first: &Crop,
        last: &Crop,
        size: [u32; 2],
    ) -> Result<Document> {
        let side = |seen: f64, a: f64, b: f64, pixels: u32| {
            (seen / a.min(b).max(1e-6) * f64::from(pixels)).round().clamp(f64::from(pixels), 8000.0) as u32
        };
        let width = side(seen.width, first.width, last.width, size[0]);
        let height = side(seen.height, first.height, last.height, size[1]);
        let panel = PanelContent {
            photo: Some(picture.photo.clone()),
            crop: Some(inside(seen)),
            faces: picture.faces.clone(),
            ..PanelContent::default()
        };
        let page = Document::new(full([width, height]), self.style.clone(), plain([width, height]));
        Document { order: vec![picture.photo.clone()], panels: vec![panel], ..page }.validated()
    }
}

impl Animatic {
    /// How far above the lower edge a caption ends, in heights of the frame.
    pub const FOOT: f64 = 0.05;
    /// Numbers of a frame in [`Animatic::table`].
    pub const COLUMNS: usize = 15;

    /// Content of a frame: one clip, or two in a dissolve with the new clip on top. `None` after the end.
    #[must_use]
    pub fn at(&self, frame: u32) -> Option<(Shown, Option<Shown>)> {
        if frame >= self.frames {
            return None;
        }
        let own = self.clips.partition_point(|clip| clip.start + clip.frames <= frame);
        let before = own.checked_sub(1).filter(|&i| frame < self.clips[i].to);
        let behind = (own + 1 < self.clips.len()).then_some(own + 1).filter(|&i| frame >= self.clips[i].from);
        let (under, over) = match (before, behind) {
            (Some(before), _) => (before, Some(own)),
            (None, behind) => (own, behind),
        };
        let shown = |clip: usize, share: f64| Shown { clip, view: self.clips[clip].view(frame), share };
        let over = over.map(|over| {
            let (from, to) = (self.clips[over].from, self.clips[under].to);
            shown(over, f64::from(frame - from + 1) / f64::from(to - from + 1))
        });
        Some((shown(under, 1.0), over))
    }

    /// Reading progress of the page in a frame. In a dissolve it is the page below. Shots have no progress.
    #[must_use]
    pub fn told(&self, frame: u32) -> Told {
        let shown = self.at(frame).and_then(|(under, _)| self.clips[under.clip].reading.as_ref());
        shown.map_or_else(Told::default, |reading| reading.told(frame))
    }

    /// Index of the current frame of animated panels, counted from the start of the video.
    #[must_use]
    pub fn beat(&self, frame: u32) -> u32 {
        (u64::from(frame) * u64::from(self.living) / u64::from(self.fps.max(1))) as u32
    }

    /// All frames as numbers for the renderer, [`Animatic::COLUMNS`] for each frame:
    ///
    /// - the clip below and its view (x, y, width, height), the clip above it (-1 if missing), its view and its
    ///   opacity, see [`Animatic::at`];
    /// - for a page below: the number of visible text items, the current panel (-1 if missing) and the darkness
    ///   of the other panels, see [`Animatic::told`];
    /// - [`Animatic::beat`].
    #[must_use]
    pub fn table(&self) -> Vec<f32> {
        let view = |view: Crop| [view.x, view.y, view.width, view.height];
        let mut table = Vec::with_capacity(self.frames as usize * Self::COLUMNS);
        for frame in 0..self.frames {
            let Some((under, over)) = self.at(frame) else { break };
            let (clip, above, share) =
                over.map_or((-1.0, [0.0; 4], 0.0), |over| (over.clip as f64, view(over.view), over.share));
            let Told { words, panel, veil } = self.told(frame);
            let panel = panel.map_or(-1.0, |panel| panel as f64);
            let more = [share, words, panel, veil, f64::from(self.beat(frame))];
            let row = [&[under.clip as f64][..], &view(under.view), &[clip], &above, &more].concat();
            table.extend(row.into_iter().map(|value| value as f32));
        }
        table
    }
}

impl Clip {
    /// View of the camera in a frame, with ease-in and ease-out as a cubic curve.
    #[must_use]
    pub fn view(&self, frame: u32) -> Crop {
        if let Some(reading) = &self.reading {
            return reading.view(frame);
        }
        let t = f64::from(frame.saturating_sub(self.from)) / f64::from((self.to - self.from).max(2) - 1);
        between(&self.first, &self.last, eased(t))
    }
}

/// Returns size and rate of frames, with the size rounded to even numbers, as encoders require.
pub(super) fn framed(size: [u32; 2], fps: u32) -> Result<([u32; 2], u32)> {
    let [least, most] = SIDES;
    if !size.iter().all(|side| (least..=most).contains(side)) {
        return Err(invalid("size", &format!("must be from {least} to {most} pixels per side")));
    }
    if !(1..=60).contains(&fps) {
        return Err(invalid("fps", "must be from 1 to 60 frames per second"));
    }
    Ok((size.map(|side| side & !1), fps))
}

/// Start and end of the camera move. With subjects the camera zooms in or out and keeps them visible. Without
/// subjects it pans along the longer side. The index of the shot decides the direction.
fn journey(picture: &Picture, seconds: f64, index: usize) -> (Crop, Crop) {
    let wide = picture.crop;
    let narrow = (1.0 - CLOSER * seconds).clamp(NARROWEST, 1.0);
    let kept = kept(&picture.subjects, &wide);
    let (first, last) = if let Some(kept) = kept {
        // As narrow as holds them.
        let part = narrow.max(kept.width / wide.width).max(kept.height / wide.height).min(1.0);
        (wide, placed(&wide, part, &kept))
    } else {
        let across = wide.width > wide.height * 0.8;
        let end = |far: bool| {
            let at = if far { 1.0 } else { 0.0 };
            let (x, y) = if across { (at, 0.5) } else { (0.5, at) };
            Crop {
                x: wide.x + (1.0 - narrow) * wide.width * x,
                y: wide.y + (1.0 - narrow) * wide.height * y,
                width: wide.width * narrow,
                height: wide.height * narrow,
            }
        };
        (end(false), end(true))
    };
    if index.is_multiple_of(2) { (first, last) } else { (last, first) }
}

/// Returns the visible part of the box that must stay in view.
fn kept(subjects: &[Subject], crop: &Crop) -> Option<Crop> {
    let sure = |subject: &&Subject| subject.score >= SURE && !subject.is_scenery();
    let classes: [&dyn Fn(&&Subject) -> bool; 3] =
        [&|subject| subject.label == FACE, &|subject| subject.is_alive() && sure(subject), &sure];
    classes.iter().find_map(|class| {
        let shown = subjects.iter().filter(class).filter_map(|subject| {
            let grown = subject.grown();
            let (left, top) = (grown.x.max(crop.x), grown.y.max(crop.y));
            let right = (grown.x + grown.width).min(crop.x + crop.width);
            let bottom = (grown.y + grown.height).min(crop.y + crop.height);
            (right > left && bottom > top).then_some(Crop {
                x: left,
                y: top,
                width: right - left,
                height: bottom - top,
            })
        });
        shown.reduce(|all, one| around(&all, &one))
    })
}

/// A part of a crop, of its aspect, about the middle of a box that it can hold.
fn placed(wide: &Crop, part: f64, kept: &Crop) -> Crop {
    let (width, height) = (wide.width * part, wide.height * part);
    let along = |kept: (f64, f64), wide: (f64, f64), length: f64| {
        (kept.0 + kept.1 / 2.0 - length / 2.0).clamp(wide.0, (wide.0 + wide.1 - length).max(wide.0))
    };
    Crop {
        x: along((kept.x, kept.width), (wide.x, wide.width), width),
        y: along((kept.y, kept.height), (wide.y, wide.height), height),
        width,
        height,
    }
}

/// The smallest box about two.
fn around(a: &Crop, b: &Crop) -> Crop {
    let (x, y) = (a.x.min(b.x), a.y.min(b.y));
    let right = (a.x + a.width).max(b.x + b.width);
    let bottom = (a.y + a.height).max(b.y + b.height);
    Crop { x, y, width: right - x, height: bottom - y }
}

/// A view in fractions of the visible area.
fn within(view: &Crop, seen: &Crop) -> Crop {
    let (x, y) = ((view.x - seen.x) / seen.width, (view.y - seen.y) / seen.height);
    let (width, height) = (view.width / seen.width, view.height / seen.height);
    inside(&Crop { x, y, width, height })
}

/// The crop, limited to the photo after rounding.
fn inside(crop: &Crop) -> Crop {
    let (width, height) = (crop.width.clamp(0.0, 1.0), crop.height.clamp(0.0, 1.0));
    Crop { x: crop.x.clamp(0.0, 1.0 - width), y: crop.y.clamp(0.0, 1.0 - height), width, height }
}

/// A layout of one panel that is the page.
fn full([width, height]: [u32; 2]) -> LayoutRef {
    let aspect = f64::from(width) / f64::from(height);
    let polygons = [[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]];
    LayoutRef::from_file(json!({
        "id": "frame", "name": "Frame", "family": "board", "aspect": aspect, "polygons": polygons,
    }))
}

fn plain([width, height]: [u32; 2]) -> PageSettings {
    PageSettings {
        width,
        height,
        dpi: 96,
        gutter: 0.0,
        margin: 0.0,
        border: 0.0,
        paper: "#000000".into(),
        border_color: "#000000".into(),
        ..PageSettings::default()
    }
}

/// Returns an empty page with a caption, or nothing without a text.
fn caption_page(text: &str, [width, height]: [u32; 2]) -> Option<Document> {
    if text.is_empty() {
        return None;
    }
    let short: String = text.chars().take(280).collect();
    let size = LETTERS * f64::from(width.min(height)) / f64::from(width);
    let word = TextItem {
        x: Some(0.5),
        y: Some(0.7),
        auto: Some(false),
        capitals: Some(false),
        font: Some("comic-neue-bold".into()),
        color: Some("#111111".into()),
        fill: Some("#ffffff".into()),
        size: Some(size),
        room: Some((CAPTION, 0.4 * f64::from(height) / f64::from(width))),
        ..TextItem::new(TextKind::Caption, short)
    };
    let page = Document::new(full([width, height]), "storyboard".into(), plain([width, height]));
    let panels = vec![PanelContent::default()];
    Document { panels, words: vec![word], ..page }.validated().ok()
}

pub(super) fn invalid(location: &str, reason: &str) -> Error {
    Error::InvalidDocument { location: location.into(), reason: reason.into() }
}
