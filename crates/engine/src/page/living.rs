//! Animated panels: a few seconds of the video around a frame, in the style of the panel, as a loop.
//!
//! A style draws each frame independently, so its lines and dots flicker if the video changes slightly. Still
//! areas are therefore drawn once. A recursive, motion-adaptive filter (like temporal noise reduction in
//! video coders) holds the source blocks that hardly change, and holds their drawing as well. Between still
//! and moving areas the mix is gradual. A still source gives a still loop.

use super::compose::{mix, render_panel};
use super::patch::Patch;
use super::scene::Scene;
use crate::error::{Error, Result};
use crate::raster::{Image, Plane};
use crate::style::Context;
use std::ops::Range;

/// Side of the blocks that move or do not, in pixels of the source.
const BLOCK: usize = 8;
/// Maximum mean difference of a still block, of 255. It covers coding noise: 2.6 at most for VP9 and H.264 as
/// cameras and the web use them.
const STILL: f64 = 4.0;
/// For noisy videos: the quantile of block differences that counts as grain, and the factor for still blocks.
const GRAIN: (f64, f64) = (0.1, 1.5);
/// Ratio to the noise floor above which a block counts as fully moving. Blocks below it move in part.
const MOVES: f64 = 2.25;
/// Criteria of a cut: the mean difference of two frames, of 255, and its ratio to the usual difference.
const CUT: (f64, f64) = (22.0, 3.5);
/// Minimum number of frames in a loop.
const LEAST: usize = 6;
/// Number of pictures in the dissolve from the end to the beginning: as a fraction, and at most.
const FADE: (usize, usize) = (5, 8);

/// Draws the frames of a panel as a loop. Returns no frames in three cases: cuts leave no time for motion,
/// the panel has no photo, or the style needs a subject mask, which exists for only one frame.
///
/// `frames` are video frames at equal intervals and of equal size. The frame with the index `still` is the
/// photo of the panel, or the frame closest to it.
///
/// # Errors
/// `invalid-document` for an index that the page does not have; `buffer-size` for frames of different sizes; `cancelled`.
pub fn living(
    scene: &Scene,
    index: usize,
    (frames, still): (&[Image], usize),
    context: &mut Context<'_>,
) -> Result<Vec<Patch>> {
    let panel = scene.picture(index)?;
    let (width, height) = frames.first().map_or((1, 1), |frame| (frame.width(), frame.height()));
    if let Some(other) = frames.iter().find(|frame| (frame.width(), frame.height()) != (width, height)) {
        let (expected, actual) = (width * height, other.width() * other.height());
        return Err(Error::BufferSize { width, height, expected, actual });
    }
    if panel.photo.is_none() || scene.style.has_parts() {
        return Ok(Vec::new());
    }
    let sources: Vec<Vec<u8>> = frames.iter().map(Image::to_rgb).collect();
    let shot = shot_around(still, &differences(&sources));
    if shot.len() < LEAST {
        return Ok(Vec::new());
    }
    let still = stillness(&sources[shot.clone()], width);
    let mut steady = Steady { width, height, rgb: Vec::new(), still };
    let mut patches: Vec<Patch> = Vec::with_capacity(shot.len());
    context.begin_frames();
    let drawn = sources[shot].iter().try_for_each(|source| {
        let moved = steady.follow(source);
        // Without motion the drawing does not change.
        let patch = match (&moved, patches.last()) {
            (None, Some(before)) => Patch { area: before.area, rgba: before.rgba.clone() },
            _ => render_panel(scene, index, Some(&steady.picture()?), context)?,
        };
        context.next_frame();
        patches.push(match (moved, patches.last()) {
            (Some(moved), Some(before)) => {
                let (b, crop, area) = (panel.image_bounds, panel.crop, patch.area);
                // Position of a patch pixel in the source, in blocks.
                let across = |x: usize| {
                    let part = ((area.x + x as i64) as f64 + 0.5 - b.x) / b.width;
                    (crop.x + part * crop.width) * width as f64 / BLOCK as f64
                };
                let down = |y: usize| {
                    let part = ((area.y + y as i64) as f64 + 0.5 - b.y) / b.height;
                    (crop.y + part * crop.height) * height as f64 / BLOCK as f64
                };
                let share = Spread::new(&moved, area.width, across, down);
                held(before, patch, &share)
            }
            _ => patch,
        });
        Ok(())
    });
    context.end_frames();
    drawn.map(|()| looped(patches))
}

/// The drawing where something moved, the one before elsewhere.
fn held(before: &Patch, mut patch: Patch, share: &Spread<'_, impl Fn(usize) -> f64>) -> Patch {
    let row = 4 * patch.area.width;
    for (y, (to, from)) in patch.rgba.chunks_exact_mut(row).zip(before.rgba.chunks_exact(row)).enumerate() {
        let shares = share.row(y);
        for ((to, from), share) in to.chunks_exact_mut(4).zip(from.chunks_exact(4)).zip(shares) {
            mix(&mut to[..3], &from[..3], 256 - share);
        }
    }
    patch
}

/// Blends the end into the beginning, so that the loop has no seam.
fn looped(mut patches: Vec<Patch>) -> Vec<Patch> {
    let fade = (patches.len() / FADE.0).min(FADE.1);
    let tail = patches.split_off(patches.len() - fade);
    for (i, (begins, ends)) in patches.iter_mut().zip(&tail).enumerate() {
        let share = 256 * (fade - i) / (fade + 1);
        for (begins, ends) in begins.rgba.chunks_exact_mut(4).zip(ends.rgba.chunks_exact(4)) {
            mix(&mut begins[..3], &ends[..3], share as u32);
        }
    }
    patches
}

/// The mean difference of each picture from the one before, of 255.
fn differences(sources: &[Vec<u8>]) -> Vec<f64> {
    // A sparse sample of pixels is enough to detect a cut.
    const STEP: usize = 3 * 17;
    let apart = |pair: &[Vec<u8>]| {
        let pairs = pair[0].iter().zip(&pair[1]).step_by(STEP);
        let (sum, count) =
            pairs.fold((0_u64, 0_u64), |(sum, count), (&a, &b)| (sum + u64::from(a.abs_diff(b)), count + 1));
        sum as f64 / count.max(1) as f64
    };
    sources.windows(2).map(apart).collect()
}

/// Returns the range of frames around `still` without a cut. `differences` has one entry fewer than there are
/// frames.
fn shot_around(still: usize, differences: &[f64]) -> Range<usize> {
    let mut sorted = differences.to_vec();
    sorted.sort_by(f64::total_cmp);
    let usual = sorted.get(sorted.len().saturating_sub(1) / 2).copied().unwrap_or(0.0);
    let is_cut = |i: &usize| differences[*i] > CUT.0.max(CUT.1 * usual);
    let still = still.min(differences.len());
    let from = (0..still).rev().find(is_cut).map_or(0, |cut| cut + 1);
    let to = (still..differences.len()).find(is_cut).unwrap_or(differences.len());
    from..to + 1
}

/// A source that holds blocks with small changes.
struct Steady {
    width: usize,
    height: usize,
    /// Interleaved RGB; empty before the first picture.
    rgb: Vec<u8>,
    /// Maximum mean difference of a block without motion, of 255.
    still: f64,
}

impl Steady {
    fn picture(&self) -> Result<Image> {
        Image::from_interleaved_rgb(self.width, self.height, &self.rgb)
    }

    /// Copies the moving parts of a frame. Returns the motion of each block, of 255. `None` for the first
    /// frame or without motion.
    fn follow(&mut self, next: &[u8]) -> Option<Plane> {
        if self.rgb.is_empty() {
            self.rgb = next.to_vec();
            return None;
        }
        let moved = grown(&self.moved(next));
        if moved.samples().iter().all(|&share| share == 0) {
            return None;
        }
        let place = |pixel: usize| (pixel as f64 + 0.5) / BLOCK as f64;
        let share = Spread::new(&moved, self.width, place, place);
        let row = 3 * self.width;
        for (y, (held, next)) in self.rgb.chunks_exact_mut(row).zip(next.chunks_exact(row)).enumerate() {
            for ((held, next), share) in held.chunks_exact_mut(3).zip(next.chunks_exact(3)).zip(share.row(y))
            {
                mix(held, next, share);
            }
        }
        Some(moved)
    }

    /// Returns the motion of each block, 0 to 255.
    fn moved(&self, next: &[u8]) -> Plane {
        let blocks = |side: usize| side.div_ceil(BLOCK);
        let apart = block_differences(&self.rgb, next, self.width);
        let share =
            |mean: f64| (255.0 * (mean / self.still - 1.0) / (MOVES - 1.0)).round().clamp(0.0, 255.0) as u8;
        let across = blocks(self.width);
        Plane::from_fn(across, blocks(self.height), |x, y| share(apart[y * across + x]))
    }
}

/// The mean difference of each block of two pictures, row by row.
fn block_differences(a: &[u8], b: &[u8], width: usize) -> Vec<f64> {
    let (row, across) = (3 * width, width.div_ceil(BLOCK));
    let mut sums = vec![(0_u32, 0_u32); across * (a.len() / row).div_ceil(BLOCK)];
    for (y, (a, b)) in a.chunks_exact(row).zip(b.chunks_exact(row)).enumerate() {
        let sums = &mut sums[y / BLOCK * across..][..across];
        for ((sum, count), (a, b)) in sums.iter_mut().zip(a.chunks(3 * BLOCK).zip(b.chunks(3 * BLOCK))) {
            *sum += a.iter().zip(b).map(|(&a, &b)| u32::from(a.abs_diff(b))).sum::<u32>();
            *count += a.len() as u32;
        }
    }
    sums.into_iter().map(|(sum, count)| f64::from(sum) / f64::from(count.max(1))).collect()
}

/// Maximum mean difference of a block without motion, of 255. Even if the whole frame
/// moves, a tenth of it is smooth and shows only the grain.
fn stillness(sources: &[Vec<u8>], width: usize) -> f64 {
    let between = sources.windows(2).step_by(4).map(|pair| {
        let mut apart = block_differences(&pair[0], &pair[1], width);
        apart.sort_by(f64::total_cmp);
        apart[(apart.len() as f64 * GRAIN.0) as usize]
    });
    let mut grain: Vec<f64> = between.collect();
    grain.sort_by(f64::total_cmp);
    STILL.max(GRAIN.1 * grain.get(grain.len() / 2).copied().unwrap_or(0.0))
}

/// Extends motion to neighbouring blocks, because lines extend past the shapes that they outline.
fn grown(blocks: &Plane) -> Plane {
    let (width, height) = (blocks.width(), blocks.height());
    let near = |at: usize, side: usize| at.saturating_sub(1)..(at + 2).min(side);
    Plane::from_fn(width, height, |x, y| {
        let rows = near(y, height).flat_map(|y| blocks.row(y)[near(x, width)].iter().copied());
        rows.max().unwrap_or(0)
    })
}

/// Shares of blocks, spread over the pixels of a picture: bilinear between the middles of blocks.
struct Spread<'a, Down> {
    blocks: &'a Plane,
    /// For each column: the block to the left, the block to the right, and the weight of the right one, of
    /// 256.
    columns: Vec<(usize, usize, u32)>,
    down: Down,
}

impl<'a, Down: Fn(usize) -> f64> Spread<'a, Down> {
    /// `across` and `down` map pixels to blocks.
    fn new(blocks: &'a Plane, width: usize, across: impl Fn(usize) -> f64, down: Down) -> Self {
        let columns = (0..width).map(|x| between(across(x), blocks.width())).collect();
        Self { blocks, columns, down }
    }

    /// The shares of a row of pixels, 0 to 256.
    fn row(&self, y: usize) -> impl Iterator<Item = u32> {
        let (above, below, part) = between((self.down)(y), self.blocks.height());
        let (above, below) = (self.blocks.row(above), self.blocks.row(below));
        self.columns.iter().map(move |&(left, right, along)| {
            let across = |row: &[u8]| u32::from(row[left]) * (256 - along) + u32::from(row[right]) * along;
            let share = (across(above) * (256 - part) + across(below) * part) >> 16;
            // 255 is all of it.
            share + (share >> 7)
        })
    }
}

/// Returns the centres of blocks on both sides of a position, and its distance from the first one, of 256.
fn between(place: f64, count: usize) -> (usize, usize, u32) {
    let at = (place - 0.5).clamp(0.0, (count - 1) as f64);
    let first = at.floor();
    (first as usize, (first as usize + 1).min(count - 1), (256.0 * (at - first)).round() as u32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::Document;
    use serde_json::json;

    const SIZE: (usize, usize) = (160, 96);

    /// A detailed wall, a square at `x`, and coding noise.
    fn frame(x: usize, noise: u32) -> Image {
        let mut rgb = Vec::with_capacity(3 * SIZE.0 * SIZE.1);
        for at in 0..SIZE.0 * SIZE.1 {
            let (px, py) = (at % SIZE.0, at / SIZE.0);
            let wall = 90 + 60 * ((px / 5 + py / 7) % 2);
            let square = (x..x + 24).contains(&px) && (30..60).contains(&py);
            let jitter =
                (at as u32).wrapping_mul(2_654_435_761).wrapping_add(noise.wrapping_mul(40_503)) >> 16;
            let value =
                if square { 240 } else { wall } as i32 + if noise == 0 { 0 } else { jitter as i32 % 3 - 1 };
            rgb.extend([value.clamp(0, 255) as u8; 3]);
        }
        Image::from_interleaved_rgb(SIZE.0, SIZE.1, &rgb).unwrap()
    }

    fn scene(style: &str) -> Scene {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let document = json!({
            "version": 1, "seed": 0, "style": style, "merges": [], "words": [], "order": ["a"],
            "panels": [{ "photo": "a", "crop": { "x": 0, "y": 0, "width": 1, "height": 1 } }],
            "layout": { "id": "one", "name": "One", "family": "board", "aspect": 160.0 / 96.0, "polygons": [square] },
            "page": {
                "width": 160, "height": 96, "dpi": 96, "gutter": 0, "margin": 0, "border": 0, "cornerRadius": 0,
                "paper": "#ffffff", "borderColor": "#000000",
            },
        });
        Scene::new(&Document::parse(&document.to_string()).unwrap(), 160).unwrap()
    }

    fn drawn(frames: &[Image]) -> Vec<Patch> {
        living(&scene("comic"), 0, (frames, frames.len() / 2), &mut Context::default()).unwrap()
    }

    fn apart(a: &Patch, b: &Patch, columns: Range<usize>) -> usize {
        let width = a.area.width;
        let pairs = a.rgba.chunks_exact(4).zip(b.rgba.chunks_exact(4)).enumerate();
        pairs.filter(|(at, (a, b))| columns.contains(&(at % width)) && a != b).count()
    }

    #[test]
    fn a_still_source_gives_a_loop_without_any_change_though_its_coder_is_noisy() {
        let frames: Vec<Image> = (0..20).map(|i| frame(40, i + 1)).collect();
        let drawn = drawn(&frames);
        assert_eq!(drawn.len(), 16);
        assert!(drawn.iter().all(|patch| patch.rgba == drawn[0].rgba));
    }

    #[test]
    fn what_moves_is_drawn_anew_and_all_else_stays() {
        let frames: Vec<Image> = (0..20).map(|i| frame(8 + 2 * i, i as u32 + 1)).collect();
        let drawn = drawn(&frames);
        let moving = drawn.windows(2).map(|pair| apart(&pair[0], &pair[1], 0..100)).sum::<usize>();
        let still = drawn.windows(2).map(|pair| apart(&pair[0], &pair[1], 110..160)).sum::<usize>();
        assert!(moving > 500, "{moving}");
        assert_eq!(still, 0);
    }

    #[test]
    fn grain_is_no_motion() {
        let grainy = |i: u32| {
            let rgb = frame(40, 0).to_rgb().into_iter().enumerate().map(|(at, value)| {
                let jitter =
                    (at as u32 / 3).wrapping_mul(2_654_435_761).wrapping_add(i.wrapping_mul(98_317_213))
                        >> 20;
                value.saturating_add((jitter % 25) as u8)
            });
            Image::from_interleaved_rgb(SIZE.0, SIZE.1, &rgb.collect::<Vec<u8>>()).unwrap()
        };
        let drawn = drawn(&(0..20).map(grainy).collect::<Vec<Image>>());
        assert!(drawn.iter().all(|patch| patch.rgba == drawn[0].rgba));
    }

    #[test]
    fn no_picture_of_another_shot_is_shown() {
        let other = |i: usize| {
            let rgb: Vec<u8> = (0..SIZE.0 * SIZE.1).flat_map(|at| [(at % 256) as u8, i as u8, 250]).collect();
            Image::from_interleaved_rgb(SIZE.0, SIZE.1, &rgb).unwrap()
        };
        let frames: Vec<Image> =
            (0..20).map(|i| if i < 5 { other(i) } else { frame(40, i as u32) }).collect();
        let drawn = drawn(&frames);
        assert_eq!(drawn.len(), 12);
        assert!(drawn.iter().all(|patch| patch.rgba == drawn[0].rgba));
        let cut: Vec<Image> = (0..20).map(|i| if i % 3 == 0 { other(i) } else { frame(40, 1) }).collect();
        assert!(living(&scene("comic"), 0, (&cut, 10), &mut Context::default()).unwrap().len() < 20);
        assert_eq!(shot_around(2, &[1.0, 90.0, 1.0, 90.0]), 2..4);
        assert_eq!(shot_around(9, &[1.0; 7]), 0..8);
    }

    #[test]
    fn the_loop_has_no_seam() {
        let frames: Vec<Image> = (0..25).map(|i| frame(8 + 4 * i, 0)).collect();
        let drawn = drawn(&frames);
        let steps: Vec<usize> =
            (0..drawn.len()).map(|i| apart(&drawn[i], &drawn[(i + 1) % drawn.len()], 0..160)).collect();
        // The seam changes more than a normal step, because the square returns, but not abruptly.
        assert!(steps.iter().all(|&step| step < 24 * 30 * 4), "{steps:?}");
    }

    #[test]
    fn frames_of_another_size_are_an_error_and_styles_of_parts_stay_still() {
        let mut frames: Vec<Image> = (0..10).map(|i| frame(2 * i, 0)).collect();
        let still = living(&scene("colour-on-ink"), 0, (&frames, 5), &mut Context::default()).unwrap();
        assert!(still.is_empty());
        assert!(living(&scene("comic"), 1, (&frames, 5), &mut Context::default()).is_err());
        frames[6] = Image::from_interleaved_rgb(2, 2, &[0; 12]).unwrap();
        assert!(living(&scene("comic"), 0, (&frames, 5), &mut Context::default()).is_err());
    }
}
