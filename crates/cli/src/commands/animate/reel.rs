//! Renders and writes the frames of a plan, for shots and for pages.

use super::drawn::Drawn;
use crate::CliError;
use crate::destination::Output;
use crate::run::Run;
use inkpanel_engine::output::animatic::{Animatic, Shown};
use inkpanel_engine::output::reading::Told;
use inkpanel_engine::page::compose::mix;
use inkpanel_engine::page::png;
use rayon::prelude::*;
use serde_json::Value;
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Resolution in the frames' metadata, as for screens.
const DPI: u32 = 96;

/// Source and destination of frames.
pub(super) struct Reel<'a> {
    pub(super) run: &'a Run,
    pub(super) plan: &'a Animatic,
    /// Draws a clip.
    pub(super) draw: &'a (dyn Fn(usize) -> Result<Drawn, CliError> + Sync),
    pub(super) folder: &'a Path,
    /// Whether existing frames are skipped.
    pub(super) skips: bool,
}

/// Frames that are drawn in parallel and reported when done.
pub(super) struct Step {
    pub(super) frames: Range<u32>,
    /// Display name.
    pub(super) called: String,
    /// And for programs.
    pub(super) event: Value,
}

/// Content of a frame. Frames that show the same are made once.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Look {
    under: Shown,
    over: Option<Shown>,
    told: Told,
}

impl Reel<'_> {
    /// Writes all frames. Clips are rendered when a frame needs them, and released after it.
    pub(super) fn write(&self, steps: &[Step]) -> Result<(), CliError> {
        let mut drawn: HashMap<usize, Drawn> = HashMap::new();
        for (i, step) in steps.iter().enumerate() {
            let looks = self.looks(step.frames.clone());
            let earliest = looks.first().map_or(0, |(look, _)| look.under.clip);
            drawn.retain(|&clip, _| clip >= earliest);
            for Shown { clip, .. } in
                looks.iter().flat_map(|(look, _)| [Some(look.under), look.over]).flatten()
            {
                if let Entry::Vacant(place) = drawn.entry(clip) {
                    place.insert((self.draw)(clip)?);
                }
            }
            looks.par_iter().try_for_each(|(look, frames)| self.make(look, frames, &drawn))?;
            let made: usize = looks.iter().map(|(_, frames)| frames.len()).sum();
            self.tell((i + 1, steps.len()), step, step.frames.len() - made);
        }
        Ok(())
    }

    /// Distinct contents, each with its frames.
    fn looks(&self, frames: Range<u32>) -> Vec<(Look, Vec<u32>)> {
        let mut looks: Vec<(Look, Vec<u32>)> = Vec::new();
        for frame in frames.filter(|frame| !(self.skips && self.output(*frame).exists())) {
            let Some((under, over)) = self.plan.at(frame) else { continue };
            let look = Look { under, over, told: self.plan.told(frame) };
            match looks.last_mut() {
                Some((last, frames)) if *last == look => frames.push(frame),
                _ => looks.push((look, vec![frame])),
            }
        }
        looks
    }

    fn make(&self, look: &Look, frames: &[u32], drawn: &HashMap<usize, Drawn>) -> Result<(), CliError> {
        let size = self.plan.size.map(|side| side as usize);
        let seen = |shown: &Shown, told: &Told| {
            let clip = drawn.get(&shown.clip).ok_or_else(|| CliError::fault("a picture is missing"))?;
            clip.seen(&shown.view, told, size)
        };
        let mut rgb = seen(&look.under, &look.told)?;
        if let Some(over) = &look.over {
            let share = (over.share * 256.0).round().clamp(0.0, 256.0) as u32;
            // During the transition, the next page has no active panel.
            mix(&mut rgb, &seen(over, &Told::default())?, share);
        }
        let file = png::encode_rgb(size[0], size[1], &rgb, DPI)?;
        frames.par_iter().try_for_each(|&frame| self.output(frame).write(&file))
    }

    fn output(&self, frame: u32) -> Output {
        let path = frame_file(self.folder, frame);
        Output { named: path.clone(), path }
    }

    fn tell(&self, (done, of): (usize, usize), step: &Step, skipped: usize) {
        let Step { frames, called, event } = step;
        let mut event = event.clone();
        event["done"] = done.into();
        event["of"] = of.into();
        event["frames"] = frames.end.into();
        event["of_frames"] = self.plan.frames.into();
        event["skipped"] = skipped.into();
        let more = if skipped > 0 { format!(", {skipped} of them there") } else { String::new() };
        let (first, last) = (frames.start + 1, frames.end);
        let sentence = format!("{done} of {of}: {called}, frames {first} to {last}{more}");
        self.run.report.step(&event, Some(sentence));
    }
}

/// The file of a frame, which is counted from 0 and named from 1.
pub(super) fn frame_file(folder: &Path, frame: u32) -> PathBuf {
    folder.join(format!("frame-{:05}.png", frame + 1))
}
