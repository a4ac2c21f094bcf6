//! Vertical strips for webtoon readers: the panels of all pages below each other, as pages of at most
//! [`WIDTH`] x [`HEIGHT`] pixels.
//!
//! Each panel becomes a block with its text. The strip is cut between the blocks, never through a block. Large
//! webtoon platforms ask for these sizes.

use crate::error::{Error, Result};
use crate::framing::Subject;
use crate::layout::{Bounds, PageSettings, resolve};
use crate::page::document::PanelContent;
use crate::page::words::Letters;
use crate::page::words::layout::measured;
use crate::page::words::model::{Tail, TextItem};
use crate::page::words::place::{Known, settle};
use crate::page::{Document, LayoutRef};
use crate::plan::moments::Moment;
use serde::Deserialize;
use serde_json::{Value, json};
use std::collections::HashMap;

/// Size of a picture of the strip in pixels: its width, and its maximum height.
pub const WIDTH: u32 = 800;
/// See [`WIDTH`].
pub const HEIGHT: u32 = 1280;
/// Distance of two panels in pixels.
pub const GAP: u32 = 250;
/// Distance of two panels in pixels if time passes between them.
pub const PAUSE: u32 = 1000;
/// Minimum time in seconds that counts as a change, on one day.
const HOURS: i64 = 3 * 3600;
/// Minimum height of a page in pixels.
const LEAST: u32 = 64;
/// Side of the panel of a page without panels, in parts of the page.
const SPECK: f64 = 1e-4;
/// Maximum size of text that grows with its panel, in widths of the strip.
const TEXT: f64 = 0.05;

/// A request of the app for a strip.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "StripRequest"))]
pub struct Request {
    /// The pages in order.
    pub pages: Vec<Document>,
    /// The photos of the pages by id.
    pub photos: HashMap<String, StripPhoto>,
}

/// A photo of a strip.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct StripPhoto {
    /// Capture time, `YYYY:MM:DD HH:MM:SS`.
    pub taken: Option<String>,
    /// Faces and objects, which text avoids.
    pub subjects: Vec<Subject>,
}

impl Request {
    /// Reads a request, and returns the pages of the strip.
    ///
    /// # Errors
    /// `invalid-document` for an invalid request; errors of [`strip`].
    pub fn made(json: &str, letters: &Letters) -> Result<Vec<Document>> {
        let wrong = |error: serde_json::Error| Error::InvalidDocument {
            location: "strip".into(),
            reason: error.to_string(),
        };
        let Self { pages, photos } = serde_json::from_str(json).map_err(wrong)?;
        pages.iter().try_for_each(|page| page.page.validate())?;
        let taken = |id: &str| photos.get(id).and_then(|photo| photo.taken.clone());
        let known = |id: &str| photos.get(id).map_or(&[][..], |photo| &photo.subjects[..]).into();
        strip(&pages, taken, known, letters)
    }
}

/// A panel of the strip.
struct Block {
    /// A page with this panel, [`WIDTH`] pixels wide.
    page: Document,
    /// Distance to the previous block in pixels.
    gap: u32,
}

/// A picture of the strip.
#[derive(Debug)]
struct Slice {
    /// Height in pixels.
    height: u32,
    /// Blocks by index, each with its distance from the top in pixels. A slice of a gap has no blocks.
    blocks: Vec<(usize, u32)>,
}

/// Returns the strip of some pages, as pages. `taken` returns the capture time of a photo, `known` its subjects.
///
/// Panels keep their crops. Their text moves with them, and automatic text is placed again. Page numbers are left out.
///
/// # Errors
/// Layout errors; `invalid-document` for an invalid text item.
pub fn strip<'s>(
    pages: &[Document],
    taken: impl Fn(&str) -> Option<String>,
    known: impl Fn(&str) -> Known<'s>,
    letters: &Letters,
) -> Result<Vec<Document>> {
    let blocks = blocks(pages, taken, known, letters)?;
    let places = blocks.iter().enumerate().map(|(i, block)| {
        let other = |before: &Block| {
            before.page.style != block.page.style || before.page.page.paper != block.page.page.paper
        };
        let fresh = i > 0 && other(&blocks[i - 1]);
        (block.gap, block.page.page.height, fresh)
    });
    let slices = slices(&places.collect::<Vec<_>>());
    let mut last = 0;
    let page = |slice: &Slice| {
        last = slice.blocks.last().map_or(last, |(block, _)| *block);
        joined(&blocks, slice, last)
    };
    Ok(slices.iter().map(page).collect())
}

/// The page of a slice. `like`: the block whose style and paper it has.
fn joined(blocks: &[Block], slice: &Slice, like: usize) -> Document {
    let height = f64::from(slice.height);
    let (mut polygons, mut panels, mut words) = (Vec::new(), Vec::new(), Vec::new());
    for &(index, y) in &slice.blocks {
        let Block { page, .. } = &blocks[index];
        let own = f64::from(page.page.height);
        let inside = |corner: &Value| {
            let at = |i: usize| corner[i].as_f64().unwrap_or_default();
            json!([at(0), ((f64::from(y) + at(1) * own) / height).min(1.0)])
        };
        let corners =
            page.layout.custom().and_then(|file| file.json()["polygons"][0].as_array()).into_iter().flatten();
        polygons.push(corners.map(inside).collect::<Vec<_>>());
        for word in &page.words {
            let mut word = word.clone();
            word.panel = Some(panels.len());
            // Names are unique on a page only.
            for name in [&mut word.id, &mut word.joined, &mut word.linked].into_iter().flatten() {
                *name = format!("{index}-{name}");
            }
            words.push(word);
        }
        panels.extend(page.panels.iter().cloned());
    }
    if polygons.is_empty() {
        // A layout has a panel. This one is too small to be seen.
        polygons.push(
            [[0.0, 0.0], [SPECK, 0.0], [SPECK, SPECK], [0.0, SPECK]].map(|corner| json!(corner)).to_vec(),
        );
        panels.push(PanelContent::default());
    }
    let page = &blocks[like].page;
    let border = if slice.blocks.is_empty() { 0.0 } else { page.page.border };
    Document {
        layout: layout(f64::from(WIDTH) / height, &json!(polygons)),
        order: panels.iter().filter_map(|panel| panel.photo.clone()).collect(),
        panels,
        words,
        page: PageSettings { height: slice.height, border, ..page.page.clone() },
        ..page.clone()
    }
}

fn layout(aspect: f64, polygons: &Value) -> LayoutRef {
    LayoutRef::from_file(json!({
        "id": "whole-strip", "name": "Strip", "family": "generated", "aspect": aspect.clamp(0.1, 10.0), "polygons": polygons,
    }))
}

/// Returns the panels of pages as blocks, in reading order.
fn blocks<'s>(
    pages: &[Document],
    taken: impl Fn(&str) -> Option<String>,
    known: impl Fn(&str) -> Known<'s>,
    letters: &Letters,
) -> Result<Vec<Block>> {
    let mut blocks: Vec<Block> = Vec::new();
    let mut last: Option<Moment> = None;
    for page in pages {
        let panels = resolve(&*page.template()?, page.page.aspect(), &page.page);
        for panel in page.reading_order() {
            let group: Vec<usize> = page.merge_of(panel).map_or_else(|| vec![panel], <[usize]>::to_vec);
            let bounds = group.iter().filter_map(|&i| panels.get(i)).map(|panel| panel.bounds);
            let Some(bounds) = bounds.reduce(Bounds::union).filter(|_| group[0] == panel) else { continue };
            let Some(photo) = page.panels.get(panel).and_then(|panel| panel.photo.clone()) else { continue };
            let words = words_of(page, &group, bounds, &|i| panels.get(i).map(|panel| panel.bounds));
            let made = block(page, panel, bounds, words, &known, letters)?;
            let moment = taken(&photo).as_deref().and_then(Moment::parse);
            let gap = match (last, moment) {
                _ if blocks.is_empty() => 0,
                (Some(last), Some(now)) if passes(last, now) => PAUSE,
                _ => GAP,
            };
            last = moment.or(last);
            blocks.push(Block { page: made, gap });
        }
    }
    Ok(blocks)
}

fn passes(last: Moment, now: Moment) -> bool {
    last.day() != now.day() || (now.seconds - last.seconds).abs() >= HOURS
}

/// Cuts a strip of blocks, each with its gap and its height in pixels, and whether it begins a picture. Heights are at
/// most [`HEIGHT`].
fn slices(blocks: &[(u32, u32, bool)]) -> Vec<Slice> {
    let mut end = 0;
    let places: Vec<(u32, u32, bool)> = blocks
        .iter()
        .map(|&(gap, height, fresh)| {
            let start = end + gap;
            end = start + height;
            (start, end, fresh)
        })
        .collect();
    let (mut slices, mut top) = (Vec::new(), 0);
    while top < end {
        let limit = top.saturating_add(HEIGHT).min(end);
        let cut =
            |&&(from, to, fresh): &&(u32, u32, bool)| from > top && from < limit && (fresh || limit < to);
        let mut bottom = places.iter().find(cut).map_or(limit, |(from, ..)| *from);
        // The rest of a gap must be high enough for a page. Gaps are much higher.
        let next = places.iter().map(|(from, ..)| *from).find(|from| *from > bottom);
        if next.is_some_and(|from| from - bottom < LEAST) && !places.iter().any(|(from, ..)| *from == bottom)
        {
            bottom -= LEAST;
        }
        let inside = |(i, &(from, ..)): (usize, &(u32, u32, bool))| {
            (from >= top && from < bottom).then(|| (i, from - top))
        };
        slices.push(Slice {
            height: bottom - top,
            blocks: places.iter().enumerate().filter_map(inside).collect(),
        });
        top = bottom;
    }
    slices
}

/// A page with one panel.
fn block<'s>(
    page: &Document,
    panel: usize,
    bounds: Bounds,
    words: Vec<TextItem>,
    known: &impl Fn(&str) -> Known<'s>,
    letters: &Letters,
) -> Result<Document> {
    let (width, most) = (f64::from(WIDTH), f64::from(HEIGHT));
    let high = width / bounds.aspect();
    let height = high.clamp(f64::from(LEAST), most).round();
    // Parts of the block that the panel fills.
    let (across, down) = ((height / high).min(1.0), (high / height).min(1.0));
    let (left, top) = ((1.0 - across) / 2.0, (1.0 - down) / 2.0);
    let corners = [[left, top], [left + across, top], [left + across, top + down], [left, top + down]];
    let content = page.panels[panel].clone();
    let mut made = Document {
        layout: layout(width / height, &json!([corners])),
        order: content.photo.iter().cloned().collect(),
        panels: vec![PanelContent { figure: None, ..content }],
        merges: Vec::new(),
        page: PageSettings {
            width: WIDTH,
            height: height as u32,
            gutter: 0.0,
            margin: 0.0,
            for_screens: true,
            bleed: 0.0,
            ..page.page.clone()
        },
        words,
        ..page.clone()
    };
    settle(&mut made, known, letters)?;
    keep_inside(&mut made, letters)?;
    Ok(made)
}

/// Moves text that extends past the block into it, so that no cut goes through it.
fn keep_inside(page: &mut Document, letters: &Letters) -> Result<()> {
    let panels = resolve(&*page.template()?, page.page.aspect(), &page.page);
    let Some(frame) = panels.first().map(|panel| panel.bounds) else { return Ok(()) };
    let height = 1.0 / page.page.aspect();
    for (i, area) in measured(page, letters)?.iter().enumerate() {
        let inside = |at: f64, length: f64, most: f64| at.clamp(0.0, (most - length).max(0.0)) - at;
        let (x, y) = (inside(area.x, area.width, 1.0), inside(area.y, area.height, height));
        let word = &mut page.words[i];
        for (at, by, side) in [(&mut word.x, x, frame.width), (&mut word.y, y, frame.height)] {
            if let Some(at) = at.as_mut().filter(|_| by.abs() > 1e-9) {
                *at += by / side;
            }
        }
    }
    Ok(())
}

/// The text items of a panel or a merged group, for a block whose panel has these bounds on the page.
fn words_of(
    page: &Document,
    group: &[usize],
    bounds: Bounds,
    panel: &impl Fn(usize) -> Option<Bounds>,
) -> Vec<TextItem> {
    let height = 1.0 / page.page.aspect();
    let whole = Bounds { x: 0.0, y: 0.0, width: 1.0, height };
    let grown = 1.0 / bounds.width.clamp(0.05, 1.0);
    let mut words = Vec::new();
    for word in page.words.iter().filter(|word| !word.number) {
        let own = word.panel;
        let Some(frame) = own.map_or(Some(whole), panel) else { continue };
        let on_page = |x: f64, y: f64| (frame.x + x * frame.width, frame.y + y * frame.height);
        let place = word.x.zip(word.y).map(|(x, y)| on_page(x, y));
        let here = match own {
            Some(own) => group.contains(&own),
            // Text of the page belongs to the panel below it.
            None => holder(page, place.unwrap_or((0.5, height / 2.0)), panel)
                .is_some_and(|holder| group.contains(&holder)),
        };
        if !here {
            continue;
        }
        let mut word = word.clone();
        let part = |(x, y): (f64, f64)| ((x - bounds.x) / bounds.width, (y - bounds.y) / bounds.height);
        if let Some((x, y)) = place.map(part) {
            (word.x, word.y) = (Some(x), Some(y));
        }
        word.tail = word.tail.map(|tail| {
            let (x, y) = part(on_page(tail.x, tail.y));
            Tail { x, y }
        });
        word.size = word.size.map(|size| (size * grown).min(TEXT.max(size)));
        word.width = word.width.map(|width| (width * grown).min(1.0));
        word.panel = Some(0);
        word.room = None;
        words.push(word);
    }
    words
}

/// The uppermost panel at a point of the page, or the nearest panel.
fn holder(page: &Document, (x, y): (f64, f64), panel: &impl Fn(usize) -> Option<Bounds>) -> Option<usize> {
    let far = |i: usize| {
        panel(i).map_or(f64::INFINITY, |Bounds { x: left, y: top, width, height }| {
            (x - x.clamp(left, left + width)).hypot(y - y.clamp(top, top + height))
        })
    };
    (0..page.panels.len()).rev().min_by(|&a, &b| far(a).total_cmp(&far(b)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn no_cut_goes_through_a_block(
            blocks in prop::collection::vec(
                (prop_oneof![Just(GAP), Just(PAUSE)], 64..=HEIGHT, prop::bool::weighted(0.1)), 1..40,
            ),
        ) {
            let mut blocks = blocks;
            blocks[0].0 = 0;
            let slices = slices(&blocks);
            let mut seen = Vec::new();
            let (mut top, mut end) = (0, 0);
            for slice in &slices {
                prop_assert!((LEAST..=HEIGHT).contains(&slice.height), "{:?}", slices);
                for &(block, y) in &slice.blocks {
                    prop_assert!(y + blocks[block].1 <= slice.height, "{:?}", slice);
                    prop_assert!(!blocks[block].2 || y == 0 || block == 0, "a style begins a picture: {:?}", slice);
                    prop_assert_eq!(top + y, end + blocks[block].0, "the gap is as wide as wanted");
                    end = top + y + blocks[block].1;
                    seen.push(block);
                }
                top += slice.height;
            }
            prop_assert_eq!(top, end);
            prop_assert_eq!(seen, (0..blocks.len()).collect::<Vec<_>>());
        }
    }

    fn page(photos: &[&str], words: &Value) -> Document {
        let panels: Vec<Value> = photos
            .iter()
            .map(|photo| json!({ "photo": photo, "crop": { "x": 0, "y": 0, "width": 1, "height": 1 }, "locked": false, "edited": false }))
            .collect();
        let page = json!({
            "version": 1, "seed": 1, "layout": "grid-4", "style": "comic", "order": photos, "panels": panels, "merges": [],
            "page": PageSettings::default(), "words": words,
        });
        Document::parse(&page.to_string()).unwrap()
    }

    #[test]
    fn panels_become_blocks_with_their_text() {
        let words = json!([
            { "kind": "caption", "text": "Second day. Sintra.", "panel": 1, "x": 0.2, "y": -0.05, "auto": false },
            { "kind": "balloon", "text": "Look!", "panel": 2, "auto": true },
            { "kind": "caption", "text": "7", "x": 0.5, "y": 0.98, "number": true },
        ]);
        let letters = Letters::bundled().unwrap();
        let taken = |photo: &str| {
            let time = match photo {
                "a" => "2026:06:09 10:00:00",
                "b" => "2026:06:09 10:20:00",
                "c" => "2026:06:09 14:00:00",
                _ => "2026:06:10 09:00:00",
            };
            Some(time.to_owned())
        };
        let pages = [page(&["a", "b", "c", "d"], &words)];
        let blocks = blocks(&pages, taken, |_| Known::default(), &letters).unwrap();
        assert_eq!(blocks.iter().map(|block| block.gap).collect::<Vec<_>>(), [0, GAP, PAUSE, PAUSE]);
        let texts: Vec<usize> = blocks.iter().map(|block| block.page.words.len()).collect();
        assert_eq!(texts, [0, 1, 1, 0]);
        for block in &blocks {
            assert_eq!(block.page.page.width, WIDTH);
            assert!(block.page.page.height <= HEIGHT);
            Document::parse(&block.page.to_json()).unwrap();
            let height = 1.0 / block.page.page.aspect();
            for area in measured(&block.page, &letters).unwrap() {
                assert!(area.y >= -1e-9 && area.y + area.height <= height + 1e-9, "{area:?}");
            }
        }
        let strip = strip(&pages, taken, |_| Known::default(), &letters).unwrap();
        assert_eq!(strip.iter().flat_map(|page| &page.order).collect::<Vec<_>>(), ["a", "b", "c", "d"]);
        assert_eq!(strip.iter().map(|page| page.words.len()).sum::<usize>(), 2);
        for page in &strip {
            let again = Document::parse(&page.to_json()).unwrap();
            assert_eq!(
                resolve(&again.template().unwrap(), again.page.aspect(), &again.page).len(),
                page.panels.len()
            );
            measured(page, &letters).unwrap();
        }
    }
}
