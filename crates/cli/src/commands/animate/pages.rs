//! The pages of a project, read panel by panel.

use super::Animate;
use super::drawn::{Drawn, Page};
use super::reel::Step;
use crate::drawing::{self, Means};
use crate::masks::Masks;
use crate::run::Run;
use crate::{CliError, reopening};
use inkpanel_engine::document::saved::Saved;
use inkpanel_engine::native::{self, QUALITY};
use inkpanel_engine::output::animatic::{Animatic, Clip};
use inkpanel_engine::output::motion::{FPS, MOST_DISSOLVE, MOST_SECONDS, Request};
use inkpanel_engine::output::reading::{Reading, Said, Stop};
use inkpanel_engine::page::Document;
use inkpanel_engine::page::words::Letters;
use inkpanel_engine::page::words::given::GivenFonts;
use serde_json::{Value, json};
use std::collections::HashMap;

/// The timed pages of a project, and the resources to draw them.
pub(super) struct Pages<'r> {
    pub(super) plan: Animatic,
    saved: Saved,
    documents: Vec<Document>,
    files: HashMap<String, Vec<u8>>,
    masks: Masks<'r>,
    fonts: GivenFonts,
    letters: Letters,
}

/// Rejects options that do not apply to pages.
///
/// # Errors
/// A sentence with the option.
pub(super) fn check(asked: &Animate) -> Result<(), CliError> {
    let refused = [
        (asked.captions, "--captions cannot be combined with --pages".to_owned()),
        (asked.style.is_some(), "--style cannot be combined with --pages".to_owned()),
        (
            asked.seconds > MOST_SECONDS,
            format!("--seconds is at most {MOST_SECONDS} with --pages, the maximum time per panel"),
        ),
        (asked.dissolve > MOST_DISSOLVE, format!("--dissolve is at most {MOST_DISSOLVE} with --pages")),
    ];
    refused.into_iter().find(|(is, _)| *is).map_or(Ok(()), |(_, why)| Err(why.into()))
}

impl<'r> Pages<'r> {
    pub(super) fn of(
        run: &'r Run,
        mut saved: Saved,
        asked: &Animate,
        fonts: GivenFonts,
    ) -> Result<Self, CliError> {
        let pages: Vec<Document> = saved.pages().0.iter().map(|page| Document::clone(page)).collect();
        if pages.is_empty() {
            return Err("the project has no pages".into());
        }
        let files = reopening::files(&mut saved, &pages, &|_| true)?;
        let request = Request {
            pages: pages.clone(),
            size: asked.size,
            fps: asked.fps.unwrap_or(FPS),
            seconds: asked.seconds,
            dissolve: asked.dissolve,
            moves: !asked.still,
            living: 0,
        };
        let letters = fonts.letters(pages.iter().flat_map(|page| &page.words))?;
        let plan = request.planned(&letters)?;
        drawing::tell_missing(run, &pages, &fonts)?;
        super::tell_still(run, moving(&saved, &pages)?, ("panel", "panels"));
        let masks = reopening::masks(run, &saved);
        Ok(Self { plan, saved, documents: pages, files, masks, fonts, letters })
    }

    /// Returns each position where the camera rests, with the move to it.
    pub(super) fn steps(&self) -> Vec<Step> {
        let steps = |(page, clip): (usize, &Clip)| {
            let mut start = clip.start;
            let step = |stop: &Stop| {
                let frames = start..stop.to;
                start = stop.to;
                let (page, panel) = (page + 1, stop.panel.map(|panel| panel + 1));
                let called = panel.map_or("all of it".to_owned(), |panel| format!("panel {panel}"));
                let event = json!({ "event": "panel", "page": page, "panel": panel });
                Step { frames, called: format!("page {page}, {called}"), event }
            };
            stops(clip).iter().map(step).collect::<Vec<_>>()
        };
        self.plan.clips.iter().enumerate().flat_map(steps).collect()
    }

    /// Each page with its frames, camera stops and text times, as JSON for programs.
    pub(super) fn told(&self) -> Value {
        let stop = |stop: &Stop| {
            json!({
                "panel": stop.panel.map(|panel| panel + 1), "first": stop.from + 1, "frames": stop.to - stop.from,
                "from": stop.first, "to": stop.last,
            })
        };
        let word =
            |said: &Said| json!({ "word": said.word + 1, "panel": said.panel + 1, "first": said.from + 1 });
        let told = |(page, clip): (usize, &Clip)| {
            let said = clip.reading.as_ref().map_or(&[][..], |reading| &reading.said);
            json!({
                "page": page + 1, "first": clip.start + 1, "frames": clip.frames,
                "stops": stops(clip).iter().map(stop).collect::<Value>(),
                "words": said.iter().map(word).collect::<Value>(),
            })
        };
        self.plan.clips.iter().enumerate().map(told).collect()
    }

    /// Returns a page at the size of the video, from the full-size photos, with its text items separately.
    pub(super) fn drawn(&self, clip: usize) -> Result<Drawn, CliError> {
        let Clip { picture, reading: Some(reading), .. } = &self.plan.clips[clip] else {
            return Err(CliError::fault("a page is missing in the plan"));
        };
        let page = Document { words: self.documents[clip].words.clone(), ..picture.clone() };
        let run = self.masks.run;
        let photo = |id: &str| reopening::photo(run, &self.saved, &self.files, id);
        let (fonts, masks) = (&self.fonts, &self.masks);
        let means = Means { run, photos: &photo, fonts, masks, quality: QUALITY, enlarges: false };
        let photos = drawing::decoded(&page, &means)?;
        let (sheet, words) = native::layers(&page, &photos, &self.letters)?;
        let widest = reading.stops.iter().map(|stop| stop.first.width).fold(0.0, f64::max);
        let across = widest * sheet.width() as f64 / f64::from(self.plan.size[0]);
        let mut drawn = Page::new(&sheet, reading.panels.clone(), across);
        for (place, patch) in words {
            // Empty text items are not read.
            if let Some(turn) = reading.said.iter().position(|said| said.word == place) {
                drawn.add(&patch, (turn, reading.said[turn].panel));
            }
        }
        Ok(Drawn::Page(drawn))
    }
}

fn stops(clip: &Clip) -> &[Stop] {
    clip.reading.as_ref().map_or(&[], |Reading { stops, .. }| stops)
}

/// Number of panels that are animated in videos of the app: video frames without breakout, merge, or a style
/// with separate subjects.
fn moving(saved: &Saved, pages: &[Document]) -> Result<usize, CliError> {
    let mut count = 0;
    for page in pages {
        if page.style()?.has_parts() {
            continue;
        }
        let moves = |(i, photo): (usize, Option<&str>)| {
            let of_film = photo.is_some_and(|photo| super::is_of_film(saved, photo));
            of_film && page.panels[i].figure.is_none() && page.merge_of(i).is_none()
        };
        let photos = page.panels.iter().map(|panel| panel.photo.as_deref());
        count += photos.enumerate().filter(|panel| moves(*panel)).count();
    }
    Ok(count)
}
