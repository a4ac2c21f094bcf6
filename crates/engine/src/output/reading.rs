//! How a page is read in time: the stops of the camera and the text items that appear.

use crate::framing::Crop;
use crate::page::Document;
use serde::Serialize;
use std::f64::consts::PI;

/// Reduction of the dimming during a camera move, so that its target is visible.
const LIFTED: f64 = 0.7;

/// How a page is read.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Reading {
    /// The outline of each panel: corners, in fractions of the page's width and height.
    pub panels: Vec<Vec<(f64, f64)>>,
    /// The page with its text items, which are drawn one by one over its image. Null without text.
    pub words: Option<Document>,
    /// Its text items in order of appearance.
    pub said: Vec<Said>,
    /// Stops of the camera, in order. The first and the last stop show the whole page.
    pub stops: Vec<Stop>,
    /// Number of frames in which a text item appears.
    pub(super) fade: u32,
}

/// A text item that appears.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Said {
    /// Index of the text item on the page.
    pub word: usize,
    /// The panel that it is read with.
    pub panel: usize,
    /// The first frame in which it is seen.
    pub from: u32,
}

/// A stop of the camera.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Stop {
    /// The current panel; `None` for the whole page.
    pub panel: Option<usize>,
    /// The first frame in which the camera is there.
    pub from: u32,
    /// Index after the last frame.
    pub to: u32,
    /// View at `from`, in fractions of the page image. It may extend beyond the page.
    pub first: Crop,
    /// View at the end.
    pub last: Crop,
}

/// How far a page is read in a frame.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Told {
    /// Number of visible text items, in order of appearance. A fraction for an item that is appearing.
    pub words: f64,
    /// The panel that is read.
    pub panel: Option<usize>,
    /// Darkness of all other panels, 0 to 1.
    pub veil: f64,
}

impl Reading {
    /// View of the camera in a frame, in fractions of the page image.
    #[must_use]
    pub fn view(&self, frame: u32) -> Crop {
        match self.place(frame) {
            Place::At(stop) => {
                // Slow enough for constant speed. With easing, the camera would seem to stop between two
                // moves.
                between(&stop.first, &stop.last, part(frame, stop.from, stop.to - 1))
            }
            Place::Between(from, to) => {
                between(&from.last, &to.first, eased(part(frame, from.to - 1, to.from)))
            }
        }
    }

    /// How far the page is read in a frame.
    #[must_use]
    pub fn told(&self, frame: u32) -> Told {
        let there = self.said.partition_point(|said| said.from + self.fade <= frame + 1);
        let coming = self.said.get(there).filter(|said| said.from <= frame);
        let share = coming.map_or(0.0, |said| f64::from(frame - said.from + 1) / f64::from(self.fade));
        let words = there as f64 + share;
        let (panel, veil) = match self.place(frame) {
            Place::At(stop) => (stop.panel, if stop.panel.is_some() { 1.0 } else { 0.0 }),
            Place::Between(from, to) => {
                let t = part(frame, from.to - 1, to.from);
                let (before, behind) = (from.panel, to.panel);
                let veil = match (before, behind) {
                    (Some(_), Some(_)) => 1.0 - LIFTED * (PI * t).sin(),
                    (None, _) => t,
                    (_, None) => 1.0 - t,
                };
                (if t < 0.5 { before.or(behind) } else { behind.or(before) }, veil)
            }
        };
        Told { words, panel, veil }
    }

    fn place(&self, frame: u32) -> Place<'_> {
        let next = self.stops.partition_point(|stop| stop.to <= frame).min(self.stops.len() - 1);
        let stop = &self.stops[next];
        match next.checked_sub(1) {
            Some(before) if frame < stop.from => Place::Between(&self.stops[before], stop),
            _ => Place::At(stop),
        }
    }
}

/// Position of the camera.
enum Place<'a> {
    At(&'a Stop),
    Between(&'a Stop, &'a Stop),
}

/// The part of the way from one frame to another, 0 to 1.
fn part(frame: u32, from: u32, to: u32) -> f64 {
    (f64::from(frame.saturating_sub(from)) / f64::from(to.saturating_sub(from).max(1))).min(1.0)
}

/// A part of a way, 0 to 1, that sets out and arrives slowly: a cubic curve.
pub(super) fn eased(t: f64) -> f64 {
    t * t * (3.0 - 2.0 * t)
}

/// The view at a part of the way from one to another, 0 to 1.
pub(super) fn between(first: &Crop, last: &Crop, part: f64) -> Crop {
    if first == last {
        return *first;
    }
    let along = |a: f64, b: f64| a + (b - a) * part;
    Crop {
        x: along(first.x, last.x),
        y: along(first.y, last.y),
        width: along(first.width, last.width),
        height: along(first.height, last.height),
    }
}
