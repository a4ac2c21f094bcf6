//! Flow Lines: contours like manual drawings, in long strokes.
//!
//! ```text
//! D = tone G(sigma) + (1 - tone) 200 + p (G(sigma) - G(1.6 sigma))
//! S = averages of D along the tangent of edges, by a Gaussian of `length`
//! ink = 1 + tanh(phi min(0, S - epsilon))
//! ```
//!
//! A difference of Gaussians finds lines. The average along the tangent joins their pieces and drops texture
//! without a direction, such as grass. Remaining pieces shorter than `shortest` are removed completely.
//!
//! Sources: Kang, Lee and Chui, "Coherent line drawing", 2007; Winnemöller et al., "`XDoG`", 2012 (the
//! threshold, and the smoothing along the flow after it); Kyprianidis and Döllner, 2008 (the field, see
//! [`crate::tangents`]).

use super::{Block, Channels, Kernel};
use crate::context::Context;
use crate::error::Result;
use crate::params::{Args, FaceLimit, Gaps, Unit, number};
use crate::raster::Plane;
use crate::raster::sets::Sets;
use crate::simd::fine::Fine;
use crate::simd::gaussian::blur;
use crate::simd::oriented::Wide;
use crate::tangents::Tangents;

pub(super) static BLOCK: Block = Block {
    id: "flow_lines",
    label: "Flow Lines",
    plain: "Ink lines",
    help: "Draws contours in long, clean strokes that follow shapes; specks of grass and hair fall away.",
    input: Channels::Any,
    output: Channels::Luma,
    params: &[
        number("sigma", "Line width", "Scale of the lines.", (1.4, 0.3, 10.0, 0.1), Unit::Pixels)
            .for_face(FaceLimit::Line(1.0 / 60.0))
            .correcting(Gaps { lines: 0.2, width: 0.9, ..Gaps::NONE }),
        number("p", "Strength", "How strongly lines stand out.", (30.0, 0.0, 100.0, 0.5), Unit::None)
            .correcting(Gaps { lines: 0.7, ..Gaps::NONE }),
        number(
            "length",
            "Stroke length",
            "How far strokes are extended.",
            (6.0, 0.0, 24.0, 0.5),
            Unit::Pixels,
        ),
        number(
            "tone",
            "Solid blacks",
            "0 draws only contours, 100 fills dark areas.",
            (0.0, 0.0, 100.0, 1.0),
            Unit::Percent,
        ),
        number(
            "epsilon",
            "Threshold",
            "Everything brighter becomes white paper.",
            (180.0, 0.0, 255.0, 1.0),
            Unit::Grey,
        )
        .correcting(Gaps { lines: 0.3, tone: -0.5, ..Gaps::NONE }),
        number("phi", "Hardness", "How hard the edge of a line is.", (0.03, 0.005, 0.3, 0.001), Unit::None),
        number(
            "shortest",
            "Shortest piece",
            "Pieces shorter than this are left out.",
            (14.0, 0.0, 80.0, 1.0),
            Unit::Pixels,
        )
        .for_face(FaceLimit::Length(1.0 / 8.0))
        .correcting(Gaps { lines: -0.5, ..Gaps::NONE }),
    ],
    kernel: Kernel::Luma(run),
    ..Block::PLAIN
};

/// The tone of a place without an edge where blacks are not filled.
const PAPER: f32 = 200.0;

/// The field is smoothed over this many pixels, and over more for wide lines.
const FIELD: (f32, f32) = (5.0, 2.0);

/// Bounds of D, in grey steps: limits the effect of one strong edge on its neighbours along the line.
const BOUNDS: (i32, i32) = (-512, 767);

/// From this tone down a pixel belongs to a line.
const LINE: u8 = 208;

fn run(args: Args<'_>, mut plane: Plane, context: &mut Context<'_>) -> Result<Plane> {
    // Thumbnails scale sigma below what a pixel grid can show: keep the thinnest line that it can.
    let sigma = args.pixels(0).max(0.3);
    let (p, tone) = (args.number(1), args.number(3) / 100.0);
    let length = args.pixels(2);
    let (width, height) = (plane.width(), plane.height());
    let field = Tangents::of(&plane, (FIELD.0 * context.scale()).max(FIELD.1 * sigma).max(2.0));
    context.check_cancelled()?;
    let buffers = &mut context.blurs;
    let mut image = buffers.take(width, height);
    image.widen(&plane);
    let (narrow, wide) = (blur(&image, sigma, buffers), blur(&image, 1.6 * sigma, buffers));
    let margin = (3.0 * length).ceil() as usize + 8;
    let mut lines = Wide::new(width, height, margin);
    for y in 0..height {
        difference(&narrow, &wide, y, (p, tone), lines.row_mut(y));
    }
    for fine in [image, narrow, wide] {
        buffers.give(fine);
    }
    lines.pad();
    context.check_cancelled()?;
    let mut spare = Wide::new(width, height, margin);
    field.smooth_along(&mut lines, &mut spare, length);
    let table = tones(args.number(4), args.number(5));
    for y in 0..height {
        for (out, &sample) in plane.row_mut(y).iter_mut().zip(lines.row(y)) {
            *out =
                table[((i32::from(sample) >> 3) - (BOUNDS.0 << 2)).clamp(0, table.len() as i32 - 1) as usize];
        }
    }
    context.check_cancelled()?;
    drop_short(&mut plane, args.pixels(6));
    Ok(plane)
}

/// One row of D in 1/32 grey steps. p in Q10: 100 * 1024 * 16320 and the added terms fit an i32.
fn difference(narrow: &Fine, wide: &Fine, y: usize, (p, tone): (f32, f32), out: &mut [i16]) {
    let (p, tone) = ((p * 1024.0).round() as i32, (tone * 1024.0).round() as i32);
    let paper = (1024 - tone) * (PAPER * 64.0) as i32;
    let rows = narrow.row_clamped(y as isize).iter().zip(wide.row_clamped(y as isize));
    for (out, (&narrow, &wide)) in out.iter_mut().zip(rows) {
        let (narrow, wide) = (i32::from(narrow), i32::from(wide));
        let sum = tone * narrow + paper + p * (narrow - wide);
        *out = (sum >> 11).clamp(BOUNDS.0 << 5, BOUNDS.1 << 5) as i16;
    }
}

/// The tone of each quarter of a grey step from the least bound on.
fn tones(epsilon: f32, phi: f32) -> Vec<u8> {
    let (epsilon, phi) = (f64::from(epsilon), f64::from(phi));
    (BOUNDS.0 * 4..=BOUNDS.1 * 4)
        .map(|quarter| {
            let below = (f64::from(quarter) / 4.0 - epsilon).min(0.0);
            (255.0 * (1.0 + (phi * below).tanh())).round() as u8
        })
        .collect()
}

/// Turns lines white that are shorter than `shortest` pixels, both ways, together with their soft borders.
/// Lines are separated on half the resolution.
fn drop_short(plane: &mut Plane, shortest: f32) {
    // Twice two pixels: less would be no length on half the resolution.
    if shortest < 4.0 {
        return;
    }
    let (width, height) = (plane.width().div_ceil(2), plane.height().div_ceil(2));
    let kept = long_pieces(plane, (width, height), (shortest / 2.0) as usize);
    let mut near = vec![false; width + 2];
    for y in 0..plane.height() {
        if y % 2 == 0 {
            near.fill(false);
            let middle = y / 2;
            for row in middle.saturating_sub(1)..=(middle + 1).min(height - 1) {
                for (near, &kept) in near[1..].iter_mut().zip(&kept[row * width..(row + 1) * width]) {
                    *near |= kept;
                }
            }
        }
        for (x, tone) in plane.row_mut(y).iter_mut().enumerate() {
            let at = x / 2;
            if !(near[at] || near[at + 1] || near[at + 2]) {
                *tone = 255;
            }
        }
    }
}

/// Runs of dark pixels of a row, joined with touching runs in the row above.
struct Run {
    start: usize,
    end: usize,
    row: usize,
    piece: u32,
}

/// Mask, on half the resolution, of line pieces that reach at least `shortest` pixels across or down.
fn long_pieces(plane: &Plane, (width, height): (usize, usize), shortest: usize) -> Vec<bool> {
    let mut runs: Vec<Run> = Vec::new();
    let mut pieces = Sets::default();
    let mut above = 0..0;
    for y in 0..height {
        let begin = runs.len();
        let (upper, lower) = (plane.row(2 * y), plane.row((2 * y + 1).min(plane.height() - 1)));
        let dark = |x: usize| {
            let right = (2 * x + 1).min(upper.len() - 1);
            upper[2 * x].min(upper[right]).min(lower[2 * x]).min(lower[right]) < LINE
        };
        let mut x = 0;
        let mut next = above.start;
        while x < width {
            if !dark(x) {
                x += 1;
                continue;
            }
            let start = x;
            while x < width && dark(x) {
                x += 1;
            }
            let piece = pieces.add();
            // Diagonal neighbours belong together.
            while next < above.end && runs[next].end < start {
                next += 1;
            }
            let mut touching = next;
            while touching < above.end && runs[touching].start <= x {
                pieces.join(runs[touching].piece, piece);
                touching += 1;
            }
            runs.push(Run { start, end: x, row: y, piece });
        }
        above = begin..runs.len();
    }
    // Left, right, top and bottom of each piece.
    let mut bounds = vec![[usize::MAX, 0, usize::MAX, 0]; pieces.len()];
    for run in &runs {
        let own = &mut bounds[pieces.root(run.piece) as usize];
        *own = [own[0].min(run.start), own[1].max(run.end), own[2].min(run.row), own[3].max(run.row + 1)];
    }
    let mut kept = vec![false; width * height];
    for run in &runs {
        let [left, right, top, bottom] = bounds[pieces.root(run.piece) as usize];
        if (right - left).max(bottom - top) >= shortest {
            kept[run.row * width + run.start..run.row * width + run.end].fill(true);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::tried;

    #[test]
    fn short_pieces_go_whole_and_long_ones_stay_as_they_were() {
        let mut plane = Plane::from_fn(120, 60, |x, y| {
            let long = (20..23).contains(&y) && (5..100).contains(&x);
            let diagonal = x.abs_diff(y + 30) < 2 && y > 30;
            let speck = (40..46).contains(&y) && (10..16).contains(&x);
            if long || diagonal || speck { 10 } else { 255 }
        });
        // A soft border is removed with its piece.
        plane.samples_mut()[46 * 120 + 12] = 230;
        let before = plane.clone();
        drop_short(&mut plane, 20.0);
        for y in 0..60 {
            for x in 0..120 {
                let near_speck = (38..49).contains(&y) && (8..19).contains(&x);
                let expected = if near_speck { 255 } else { before.at(x, y) };
                assert_eq!(plane.at(x, y), expected, "{x}, {y}");
            }
        }
    }

    #[test]
    fn a_broken_line_is_joined_and_noise_is_not_drawn() {
        let mut random = oorandom::Rand32::new(4);
        let plane = Plane::from_fn(200, 120, |x, y| {
            let dashed = (58..61).contains(&y) && x % 12 < 9;
            if dashed { 60 } else { (190 + random.rand_range(0..30)) as u8 }
        });
        let out = tried(&BLOCK, &[], |args, context| run(args, plane, context));
        let dark = |x: usize| (55..64).any(|y| out.at(x, y) < 128);
        assert!((20..180).all(dark));
        assert!((0..200).all(|x| (0..40).all(|y| out.at(x, y) > 200)));
    }
}
