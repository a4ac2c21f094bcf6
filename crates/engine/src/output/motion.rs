//! Motion comics: each page is shown completely, then panel by panel, then completely again. The camera moves
//! from panel to panel in reading order, and the other panels are dimmed. Text appears item by item, at
//! reading speed. The result is an [`Animatic`] whose clips are pages, so both use one renderer.

use super::animatic::{Animatic, Clip, MOST_FRAMES, framed, invalid};
use super::phrases::Phrases;
use super::reading::{Reading, Said, Stop};
use super::telling::{self, ToldPage, ToldPanel, ToldWord};
use crate::error::Result;
use crate::framing::Crop;
use crate::layout::Bounds;
use crate::page::Document;
use crate::page::words::Letters;
use serde::Deserialize;

/// Default frames per second.
pub const FPS: u32 = 24;
/// Default duration of a panel without text, in seconds.
const USUAL_SECONDS: f64 = 2.0;
/// And at most.
pub const MOST_SECONDS: f64 = 60.0;
/// Maximum duration of a dissolve between pages, in seconds.
pub const MOST_DISSOLVE: f64 = 1.0;
/// Duration of the whole page, before and after its panels.
const WHOLE: (f64, f64) = (1.2, 0.9);
/// How long the camera is on its way from one panel to the next.
const WAY: f64 = 0.7;
/// Duration of a panel before its first text item appears, and after the last one was read.
const BREATH: (f64, f64) = (0.3, 0.5);
/// Reading time of a text item in seconds: base, and per character. About 180 words per minute.
const READ: (f64, f64) = (0.5, 0.055);
/// Seconds in which a text item appears.
const FADE: f64 = 0.2;
/// Margin around the visible area, relative to a panel and to the whole page.
const ROOM: (f64, f64) = (0.07, 0.05);
/// Zoom of the camera while it rests on a panel: per second, and at most.
const CLOSER: (f64, f64) = (0.01, 0.04);
/// Pixels that the picture of a page has at most, and a side of it.
const MOST_PIXELS: f64 = 16e6;
const MOST_SIDE: f64 = 8000.0;

/// Request of a motion comic.
#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "MotionRequest"))]
pub struct Request {
    /// The pages in their order.
    pub pages: Vec<Document>,
    /// Width and height of the frames in pixels, 64 to 3840. Rounded to even numbers, as encoders require.
    pub size: [u32; 2],
    /// Frames per second, 1 to 60.
    pub fps: u32,
    /// Minimum duration of a panel in seconds; 0 for the default of two.
    pub seconds: f64,
    /// Duration of a dissolve between two pages in seconds; 0 for hard cuts.
    pub dissolve: f64,
    /// Whether the camera moves. If not, it jumps.
    pub moves: bool,
    /// Frames per second of animated panels from videos; 0 for stills.
    pub living: u32,
}

impl Request {
    /// Reads a request.
    ///
    /// # Errors
    /// Returns `invalid-document` if the JSON is not a valid request.
    pub fn parse(json: &str) -> Result<Self> {
        serde_json::from_str(json).map_err(|error| invalid("motion", &error.to_string()))
    }

    /// Plans the pages with their times.
    ///
    /// # Errors
    /// `invalid-document` without pages, for sizes and rates out of range, and for more than four hours;
    /// errors of layouts and text.
    pub fn planned(&self, letters: &Letters) -> Result<Animatic> {
        if self.pages.is_empty() {
            return Err(invalid("pages", "must not be empty"));
        }
        let (size, fps) = framed(self.size, self.fps)?;
        // The language does not matter, because only the reading order is used.
        let phrases = Phrases::of("en")?;
        let pace = Pace { fps: f64::from(fps), seconds: self.seconds, moves: self.moves };
        let dissolve =
            if self.pages.len() > 1 { pace.frames(self.dissolve.clamp(0.0, MOST_DISSOLVE)) } else { 0 };
        let last = self.pages.len() - 1;
        let mut clips = Vec::with_capacity(self.pages.len());
        let mut start = 0;
        for (i, document) in self.pages.iter().enumerate() {
            let page = telling::told(document, &[], letters, &phrases)?;
            let into = if i > 0 { dissolve } else { 0 };
            let out_of = if i < last { dissolve } else { 0 };
            let mut reading = pace.reading(&page, size, (start, into, out_of));
            let end = reading.stops.last().map_or(start + 1, |stop| stop.to);
            if u64::from(end) > MOST_FRAMES {
                return Err(invalid("pages", "must last at most four hours"));
            }
            if !document.words.is_empty() {
                reading.words = Some(document.clone());
            }
            let whole = reading.stops.first().map_or(WHOLE_PAGE, |stop| stop.first);
            clips.push(Clip {
                photo: String::new(),
                number: (i + 1).to_string(),
                start,
                frames: end - start,
                from: start - into / 2,
                to: end + out_of.div_ceil(2),
                first: whole,
                last: whole,
                picture: picture(document, &reading, size),
                caption: None,
                reading: Some(reading),
            });
            start = end;
        }
        Ok(Animatic { fps, rate: f64::from(fps), size, frames: start, living: self.living.min(fps), clips })
    }
}

const WHOLE_PAGE: Crop = Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };

/// How fast pages are read.
struct Pace {
    fps: f64,
    seconds: f64,
    moves: bool,
}

impl Pace {
    fn frames(&self, seconds: f64) -> u32 {
        (seconds * self.fps).round().max(0.0) as u32
    }

    /// A page from frame `start` on; it shares frames with the page before and with the next one.
    fn reading(&self, page: &ToldPage, size: [u32; 2], (start, into, out_of): (u32, u32, u32)) -> Reading {
        let sheet = Bounds { x: 0.0, y: 0.0, width: f64::from(page.width), height: f64::from(page.height) };
        let whole = view(sheet, ROOM.1, page, size);
        let way = if self.moves { self.frames(WAY).max(1) } else { 0 };
        let stays = |panel: Option<usize>, from: u32, to: u32, first: Crop, last: Crop| Stop {
            panel,
            from,
            to: to.max(from + 1),
            first,
            last,
        };
        let mut stops =
            vec![stays(None, start, start + self.frames(WHOLE.0) + into.div_ceil(2), whole, whole)];
        let mut said = Vec::new();
        let mut at = stops[0].to;
        for (i, panel) in page.panels.iter().enumerate() {
            let from = at + way;
            let (spoken, seconds) = self.spoken(panel, i, from);
            said.extend(spoken);
            let first = view(panel.view(page), ROOM.0, page, size);
            let narrow = 1.0 - (CLOSER.0 * seconds).min(CLOSER.1);
            let last = if self.moves { nearer(&first, narrow) } else { first };
            let stop = stays(Some(i), from, from + self.frames(seconds), first, last);
            at = stop.to;
            stops.push(stop);
        }
        let from = at + way;
        stops.push(stays(None, from, from + self.frames(WHOLE.1) + out_of / 2, whole, whole));
        let (wide, high) = (f64::from(page.width), f64::from(page.height));
        let outline = |panel: &ToldPanel| panel.outline.iter().map(|(x, y)| (x / wide, y / high)).collect();
        Reading {
            panels: page.panels.iter().map(outline).collect(),
            words: None,
            said,
            stops,
            fade: self.frames(FADE).max(1),
        }
    }

    /// Returns the text items of a panel that is visible from a frame on, and their total duration in
    /// seconds. Each item appears after the previous one was read.
    fn spoken(&self, panel: &ToldPanel, number: usize, from: u32) -> (Vec<Said>, f64) {
        let mut seconds = BREATH.0;
        let mut said = Vec::with_capacity(panel.words.len());
        for ToldWord { text, place, .. } in &panel.words {
            said.push(Said { word: *place, panel: number, from: from + self.frames(seconds) });
            seconds += READ.0 + READ.1 * text.chars().count() as f64;
        }
        let least = if self.seconds > 0.0 { self.seconds.min(MOST_SECONDS) } else { USUAL_SECONDS };
        (said, if panel.words.is_empty() { least } else { least.max(seconds + BREATH.1) })
    }
}

/// View in which a part of a page fills the frame with a margin, in fractions of the page. It has the aspect ratio of the frame, and is inside the page if the page is large enough.
fn view(seen: Bounds, room: f64, page: &ToldPage, size: [u32; 2]) -> Crop {
    let aspect = f64::from(size[0]) / f64::from(size[1]);
    let (wide, high) = (f64::from(page.width), f64::from(page.height));
    let width = (seen.width * (1.0 + room)).max(seen.height * (1.0 + room) * aspect);
    let height = width / aspect;
    let along = |from: f64, length: f64, view: f64, page: f64| {
        let middle = from + length / 2.0 - view / 2.0;
        if view >= page { (page - view) / 2.0 } else { middle.clamp(0.0, page - view) }
    };
    Crop {
        x: along(seen.x, seen.width, width, wide) / wide,
        y: along(seen.y, seen.height, height, high) / high,
        width: width / wide,
        height: height / high,
    }
}

/// A part of a view about its middle.
fn nearer(view: &Crop, part: f64) -> Crop {
    let (width, height) = (view.width * part, view.height * part);
    Crop { x: view.x + (view.width - width) / 2.0, y: view.y + (view.height - height) / 2.0, width, height }
}

/// Renders the page without text, at the size that its narrowest view needs.
fn picture(document: &Document, reading: &Reading, size: [u32; 2]) -> Document {
    let narrowest = reading.stops.iter().map(|stop| stop.last.width).fold(1.0_f64, f64::min);
    let (wide, high) = (f64::from(document.page.width), f64::from(document.page.height));
    let most = (MOST_PIXELS / (wide * high)).sqrt().min(MOST_SIDE / wide.max(high));
    let scale = (f64::from(size[0]) / narrowest / wide).min(most);
    let mut page = Document { words: Vec::new(), ..document.clone() };
    page.page.width = (wide * scale).round() as u32;
    page.page.height = (high * scale).round() as u32;
    page
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::reading::Told;

    const SIZE: [u32; 2] = [320, 180];

    fn panel(x: f64, y: f64, width: f64, height: f64, words: &[&str]) -> ToldPanel {
        let bounds = Bounds { x, y, width, height };
        let word = |(place, text): (usize, &&str)| ToldWord {
            kind: telling::WordKind::Balloon,
            text: (*text).into(),
            pieces: vec![((*text).into(), None)],
            place,
            bounds: Bounds { x: x + 2.0, y: y + 2.0, width: 10.0, height: 10.0 },
            size: 4.0,
        };
        ToldPanel {
            outline: vec![(x, y), (x + width, y), (x + width, y + height), (x, y + height)],
            bounds,
            shows: "a photo".into(),
            known: false,
            words: words.iter().enumerate().map(word).collect(),
        }
    }

    fn page() -> ToldPage {
        ToldPage {
            width: 200,
            height: 300,
            panels: vec![
                panel(10.0, 10.0, 180.0, 130.0, &["Hello there", "And you?"]),
                panel(10.0, 150.0, 80.0, 140.0, &[]),
            ],
        }
    }

    fn read(moves: bool) -> Reading {
        Pace { fps: 24.0, seconds: 2.0, moves }.reading(&page(), SIZE, (100, 0, 0))
    }

    #[test]
    fn the_page_is_seen_whole_then_panel_by_panel_then_whole() {
        let reading = read(true);
        assert_eq!(
            reading.stops.iter().map(|stop| stop.panel).collect::<Vec<_>>(),
            [None, Some(0), Some(1), None]
        );
        assert_eq!(reading.stops[0].from, 100);
        for pair in reading.stops.windows(2) {
            assert_eq!(pair[1].from - pair[0].to, 17);
        }
        let [whole, .., end] = [0, 1, 2, 3].map(|i| reading.stops[i].first);
        assert_eq!(whole, end);
        assert!(whole.y < 0.0 && whole.height > 1.0 && whole.width > 1.0);
    }

    #[test]
    fn a_view_has_the_aspect_of_the_frame_and_holds_what_is_read() {
        let page = page();
        for (stop, panel) in read(true).stops[1..3].iter().zip(&page.panels) {
            for Crop { x, y, width, height } in [stop.first, stop.last] {
                let aspect = width * 200.0 / (height * 300.0);
                assert!((aspect - 320.0 / 180.0).abs() < 1e-9, "{aspect}");
                let Bounds { x: left, y: top, width: wide, height: high } = panel.bounds;
                assert!(x * 200.0 <= left && (x + width) * 200.0 >= left + wide);
                assert!(y * 300.0 <= top && (y + height) * 300.0 >= top + high);
            }
        }
    }

    #[test]
    fn words_appear_one_after_the_other_and_stay() {
        let reading = read(true);
        let stop = reading.stops[1];
        let [first, second] = [reading.said[0], reading.said[1]];
        assert!(stop.from < first.from && first.from < second.from && second.from < stop.to);
        let words = |frame: u32| reading.told(frame).words;
        let is = |frame: u32, count: f64| (words(frame) - count).abs() < 1e-9;
        assert!(is(first.from - 1, 0.0) && is(second.from - 1, 1.0) && is(stop.to, 2.0));
        assert!(words(first.from) > 0.0 && words(first.from) < 1.0);
        let frames = (100..reading.stops[3].to).map(words);
        assert!(frames.clone().zip(frames.skip(1)).all(|(a, b)| b >= a));
        // Half a second, then 11 and 8 characters.
        assert!(stop.to - stop.from >= 24 * 2);
    }

    #[test]
    fn only_the_panel_that_is_read_is_bright() {
        let reading = read(true);
        assert_eq!(reading.told(100), Told { words: 0.0, panel: None, veil: 0.0 });
        let [_, first, second, last] = [0, 1, 2, 3].map(|i| reading.stops[i]);
        assert_eq!((reading.told(first.from).panel, reading.told(first.from).veil), (Some(0), 1.0));
        let between = reading.told(first.to.midpoint(second.from));
        assert!(between.veil < 0.5, "{between:?}");
        assert_eq!((reading.told(last.from).panel, reading.told(last.from).veil), (None, 0.0));
    }

    #[test]
    fn the_camera_never_leaps_where_it_moves_and_never_glides_where_it_does_not() {
        let moving = read(true);
        for frame in 100..moving.stops[3].to - 1 {
            let (a, b) = (moving.view(frame), moving.view(frame + 1));
            assert!((a.x - b.x).abs() < 0.2 && (a.y - b.y).abs() < 0.2, "frame {frame}: {a:?} {b:?}");
        }
        let still = read(false);
        let views: Vec<Crop> = (100..still.stops[3].to).map(|frame| still.view(frame)).collect();
        let different = views.windows(2).filter(|pair| pair[0] != pair[1]).count();
        assert_eq!(different, 3);
    }
}
