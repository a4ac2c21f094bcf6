//! A layer compiled into passes and run.
//!
//! Consecutive point operations become one pass over tiles that fit the cache, and consecutive tables become
//! one table. Blocks that read neighbouring pixels run between these passes. U and V are computed only if a
//! later To Color needs them.

use super::blocks::{Channels, Kernel};
use super::context::Context;
use super::file::Step;
use super::part::{self, Part, widened};
use super::point_op::PointOp;
use crate::error::Result;
use crate::raster::resize::{Region, resample};
use crate::raster::{Image, Plane};
use crate::simd::point::{self, luma_plane};
use crate::simd::tones::Tones;

/// Pixels of a tile: three channels of it and a scratch row stay in a 32 KB cache.
const TILE: usize = 4096;

/// Neutral U and V.
const NEUTRAL: u8 = 128;

/// Runs one layer on a photo. The result has the photo's size.
///
/// # Errors
/// `cancelled` if the context is cancelled.
#[inline(never)]
pub fn run(steps: &[Step], photo: &Image, context: &mut Context<'_>) -> Result<Image> {
    let image = run_owned(steps, copy(photo, context)?, context)?;
    if (image.width(), image.height()) == (photo.width(), photo.height()) {
        return Ok(image);
    }
    let whole = Region::whole(image.width(), image.height());
    Ok(crate::raster::resize::resample_image(&image, whole, photo.width(), photo.height()))
}

/// Runs a layer on an image that may be changed in place, gray or in colour. The result keeps the size
/// from the blocks.
///
/// # Errors
/// `cancelled` if the context is cancelled.
pub fn run_owned(steps: &[Step], image: Image, context: &mut Context<'_>) -> Result<Image> {
    run_until(steps, steps.len(), image, context)
}

/// Runs the blocks before `end`, with U and V if a later block needs them.
///
/// # Errors
/// `cancelled` if the context is cancelled.
pub fn run_until(steps: &[Step], end: usize, mut image: Image, context: &mut Context<'_>) -> Result<Image> {
    let active = |steps: &[Step]| steps.iter().filter(|step| !step.bypass).count();
    let end = active(&steps[..end.min(steps.len())]);
    let steps: Vec<&Step> = steps.iter().filter(|step| !step.bypass).collect();
    let mut i = 0;
    let mut next_start = None;
    while i < end {
        context.check_cancelled()?;
        let mut ops = Vec::new();
        while let Some(op) = steps[..end].get(i).and_then(|step| point_op(step, context.scale())) {
            push_fused(&mut ops, op);
            i += 1;
        }
        if !ops.is_empty() {
            let chroma_wanted = steps[i..].iter().any(|step| step.block.restores_color);
            image = run_points(&ops, image, chroma_wanted, context)?;
        }
        if let Some(step) = steps[..end].get(i) {
            let start = std::mem::take(&mut next_start);
            i += 1;
            if i < end && is_second_half(&steps[..=i]) {
                next_start = Some(image.clone());
            }
            let chroma_wanted = steps[i..].iter().any(|step| step.block.restores_color);
            image = run_block(step, chroma_wanted, start, image, context)?;
        }
    }
    Ok(image)
}

/// Whether the last of `steps`, which are active, is the second half of a pair: two blocks of one kind in a row, one for
/// each part of the picture. Both start from the picture before the first one, so that a measurement or a painting of
/// this picture is made once.
pub(crate) fn is_second_half(steps: &[&Step]) -> bool {
    let are_halves = |pair: &&[&Step]| {
        let [a, b] = [pair[0], pair[1]];
        a.block.id == b.block.id && a.part.is_some() && b.part.is_some() && a.part != b.part
    };
    // A third block in this row starts the next pair.
    steps.windows(2).rev().take_while(are_halves).count() % 2 == 1
}

/// Runs the last of `steps`. If it is a point operation, it runs in one pass with the blocks before it in
/// `steps`, all of the same kind. `chroma_wanted` stores U and V for a later To Color. `start`: the picture before the
/// first half, if the block is a second half. The result has the size that the block returned.
///
/// # Errors
/// `cancelled` if the context is cancelled.
pub(crate) fn run_last(
    steps: &[Step],
    chroma_wanted: bool,
    start: Option<Image>,
    image: Image,
    context: &mut Context<'_>,
) -> Result<Image> {
    let mut ops = Vec::new();
    for op in steps.iter().filter(|step| !step.bypass).filter_map(|step| point_op(step, context.scale())) {
        push_fused(&mut ops, op);
    }
    match steps.last() {
        _ if !ops.is_empty() => run_points(&ops, image, chroma_wanted, context),
        Some(step) => run_block(step, chroma_wanted, start, image, context),
        None => Ok(image),
    }
}

/// Lays the luma of `lines` over a background as the alpha of an ink. Both have one size.
#[must_use]
#[inline(never)]
pub fn lay_ink(background: Image, lines: &Image, ink: [u8; 3]) -> Image {
    let lines = luma_plane(lines);
    let gray_ink = ink[0] == ink[1] && ink[1] == ink[2];
    let mut background = if gray_ink { background } else { widened(background) };
    for (plane, ink) in background.planes_mut().iter_mut().zip(ink) {
        point::lay_ink(plane.samples_mut(), lines.samples(), ink);
    }
    background
}

fn copy(photo: &Image, context: &mut Context<'_>) -> Result<Image> {
    // A chain begins with colour, whatever the photo holds.
    let last = photo.planes().len() - 1;
    Image::from_rgb([0, 1, 2].map(|i| context.copy_plane(&photo.planes()[i.min(last)])))
}

fn point_op(step: &Step, scale: f32) -> Option<PointOp> {
    match step.block.kernel {
        // A block with a part is mixed with its input, so it cannot join a longer pass.
        Kernel::Point(op) if step.part.is_none() => Some(op(step.args(scale))),
        _ => None,
    }
}

fn push_fused(ops: &mut Vec<PointOp>, op: PointOp) {
    match (ops.last_mut(), &op) {
        (Some(PointOp::Table(last)), PointOp::Table(next))
        | (Some(PointOp::LumaTable(last)), PointOp::LumaTable(next)) => *last = last.then(next),
        _ => ops.push(op),
    }
}

/// Runs a block. A block with a part changes only that part. `start`: its input, if this is not `image`.
fn run_block(
    step: &Step,
    chroma_wanted: bool,
    start: Option<Image>,
    image: Image,
    context: &mut Context<'_>,
) -> Result<Image> {
    let Some(part) = step.part else { return run_everywhere(step, chroma_wanted, image, context) };
    if part == Part::Background && context.subject().is_none() && step.block.output == step.block.input {
        // The whole picture is the subject.
        return Ok(image);
    }
    let start = start.unwrap_or_else(|| image.clone());
    let after = run_everywhere(step, chroma_wanted, start, context)?;
    Ok(part::mixed(image, after, part, context))
}

// Called from several places: a copy in each would only make the module larger.
#[inline(never)]
fn run_everywhere(
    step: &Step,
    chroma_wanted: bool,
    image: Image,
    context: &mut Context<'_>,
) -> Result<Image> {
    let args = step.args(context.scale());
    match step.block.kernel {
        Kernel::Point(op) => run_points(&[op(args)], image, chroma_wanted, context),
        Kernel::Tones(make) => {
            let op = context.tones_or(|context| {
                let [r, g, b] = image.planes() else {
                    return make(args, &Tones::new(image.planes()[0].samples()));
                };
                let mut y = context.take_plane(image.width(), image.height());
                point::luma(r.samples(), g.samples(), b.samples(), y.samples_mut());
                let op = make(args, &Tones::new(y.samples()));
                context.give_plane(y);
                op
            });
            let chroma = image.chroma().is_some();
            run_points(&[op], image, chroma, context)
        }
        Kernel::Planes(kernel) => {
            let (planes, chroma) = image.into_parts();
            let planes: Result<Vec<Plane>> =
                planes.into_iter().map(|plane| kernel(args, plane, context)).collect();
            assemble(planes?, chroma)
        }
        Kernel::Luma(kernel) => run_on_luma(step.block.output, |y, c| kernel(args, y, c), image, context),
        Kernel::Image(kernel) => kernel(args, image, context),
    }
}

fn run_on_luma(
    output: Channels,
    kernel: impl Fn(Plane, &mut Context<'_>) -> Result<Plane>,
    image: Image,
    context: &mut Context<'_>,
) -> Result<Image> {
    if image.is_luma() {
        let (mut planes, chroma) = image.into_parts();
        let y = kernel(planes.remove(0), context)?;
        return assemble(vec![y], chroma);
    }
    let before = luma_plane(&image);
    let after = kernel(context.copy_plane(&before), context)?;
    if output == Channels::Luma {
        return Ok(Image::from_luma(after));
    }
    let mut image = image;
    for plane in image.planes_mut() {
        point::shift_luma(plane.samples_mut(), before.samples(), after.samples());
    }
    context.give_plane(before);
    context.give_plane(after);
    Ok(image)
}

fn assemble(mut planes: Vec<Plane>, chroma: Option<[Plane; 2]>) -> Result<Image> {
    if let Ok(planes) = <[Plane; 3]>::try_from(std::mem::take(&mut planes)).map_err(|rest| planes = rest) {
        return Image::from_rgb(planes);
    }
    let y = planes.swap_remove(0);
    Ok(match chroma {
        Some(chroma) => Image::from_luma_chroma(y, chroma),
        None => Image::from_luma(y),
    })
}

/// The current content of the three planes of a pass.
#[derive(Clone, Copy, PartialEq)]
enum State {
    Luma,
    LumaChroma,
    Color,
}

// Called from several places: a copy in each would only make the module larger.
#[inline(never)]
fn run_points(
    ops: &[PointOp],
    image: Image,
    chroma_wanted: bool,
    context: &mut Context<'_>,
) -> Result<Image> {
    let (width, height) = (image.width(), image.height());
    let (mut planes, chroma) = image.into_parts();
    let mut state = if planes.len() == 3 { State::Color } else { State::Luma };
    let to_color = ops.iter().any(|op| matches!(op, PointOp::ToColor));
    let colors = to_color || ops.iter().any(|op| matches!(op, PointOp::Tint(_)));
    if state == State::Luma {
        if let Some(chroma) = chroma.filter(|_| to_color || chroma_wanted) {
            planes.extend(chroma.map(|plane| sized(plane, width, height)));
            state = State::LumaChroma;
        } else if colors {
            planes.push(Plane::filled(width, height, NEUTRAL));
            planes.push(Plane::filled(width, height, NEUTRAL));
            state = State::LumaChroma;
        }
    }
    let keep_chroma = to_color || chroma_wanted;
    let mut end = state;
    let mut slices: Vec<&mut [u8]> = planes.iter_mut().map(Plane::samples_mut).collect();
    let mut nothing: [&mut [u8]; 2] = [&mut [], &mut []];
    let (first, rest) = slices.split_at_mut(1);
    let rest = if rest.is_empty() { &mut nothing[..] } else { rest };
    let mut start = 0;
    while start < width * height {
        let range = start..(start + TILE).min(width * height);
        let [b, c] = [0, 1].map(|i| range.start.min(rest[i].len())..range.end.min(rest[i].len()));
        let (second, third) = rest.split_at_mut(1);
        end = state;
        let tile = [&mut first[0][range.clone()], &mut second[0][b], &mut third[0][c]];
        run_tile(ops, tile, &mut end, keep_chroma);
        start = range.end;
    }
    drop(slices);
    if end == State::Color {
        return assemble(planes, None);
    }
    let mut spare: Vec<Plane> = planes.drain(1..).collect();
    let chroma = match (end, spare.len()) {
        (State::LumaChroma, 2) => spare.pop().and_then(|v| spare.pop().map(|u| [u, v])),
        _ => None,
    };
    for plane in spare {
        context.give_plane(plane);
    }
    assemble(planes, chroma)
}

/// Kept chroma at the size of the luma it returns to: a Size block may be between them.
fn sized(plane: Plane, width: usize, height: usize) -> Plane {
    if (plane.width(), plane.height()) == (width, height) {
        return plane;
    }
    resample(&plane, Region::whole(plane.width(), plane.height()), width, height)
}

fn run_tile(ops: &[PointOp], [a, b, c]: [&mut [u8]; 3], state: &mut State, keep_chroma: bool) {
    for op in ops {
        match (op, *state) {
            (PointOp::Table(table), State::Color) => {
                table.apply(a);
                table.apply(b);
                table.apply(c);
            }
            (PointOp::LumaTable(table), State::Color) => {
                let (mut before, mut after) = ([0; TILE], [0; TILE]);
                let (before, after) = (&mut before[..a.len()], &mut after[..a.len()]);
                point::luma(a, b, c, before);
                after.copy_from_slice(before);
                table.apply(after);
                for channel in [&mut *a, &mut *b, &mut *c] {
                    point::shift_luma(channel, before, after);
                }
            }
            (PointOp::Table(table) | PointOp::LumaTable(table), _) => table.apply(a),
            (PointOp::Color(op), State::Color) => point::map3(a, b, c, |r, g, b| op.apply(r, g, b)),
            (PointOp::ToGray, State::Color) => {
                point::to_gray(a, b, c, keep_chroma);
                *state = if keep_chroma { State::LumaChroma } else { State::Luma };
            }
            (PointOp::ToColor, State::LumaChroma) => {
                point::to_color(a, b, c);
                *state = State::Color;
            }
            (PointOp::Tint(shares), State::Luma | State::LumaChroma) => {
                point::tint(a, b, c, *shares);
                *state = State::Color;
            }
            // The channels already match. The check of the style file rejects other cases.
            (PointOp::Color(_) | PointOp::ToGray | PointOp::ToColor | PointOp::Tint(_), _) => {}
        }
    }
}
