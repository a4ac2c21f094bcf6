//! Total Variation Flow: `u_t` = div(grad u / |grad u|) for a time t: flattens texture and keeps edges sharp.
//!
//! One implicit step of the flow is the minimum of |grad u| + |u - f|^2 / (2 t), solved in its dual:
//!
//! ```text
//! p <- (p + (tau / t) grad u) / max(1, |p + (tau / t) grad u|)
//! u  = f + t div p
//! ```
//!
//! with forward differences for grad, backward for div, reflecting borders and tau = 1/8, sped up by
//! Nesterov's extrapolation, which diverges from larger steps. An iteration carries information one pixel far, so
//! the plane is cut into tiles with a rim of as many pixels: their fields stay in cache, and no seam can be seen
//! because none is there.
//!
//! Sources: Chambolle, "An algorithm for total variation minimization and applications", 2004; Beck and
//! Teboulle, "Fast gradient-based algorithms for constrained total variation image denoising", 2009.

use super::{Block, Channels, Kernel};
use crate::error::Result;
use crate::raster::Plane;
use crate::style::context::Context;
use crate::style::params::{Unit, number};

pub(super) static BLOCK: Block = Block {
    id: "tvf",
    label: "Total Variation Flow",
    help: "Melts texture into flat areas with crisp edges, like cut paper.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[number(
        "time",
        "Time",
        "How long the flow runs: longer is flatter.",
        (15.0, 0.0, 100.0, 1.0),
        Unit::Pixels,
    )],
    kernel: Kernel::Planes(|args, plane, context| {
        // A shape's tone flows away at a rate of 1 / its size, so time scales like a length.
        let time = args.pixels(0);
        if time < 0.05 { Ok(plane) } else { flow_in_tiles(&plane, time, iterations(time), context) }
    }),
};

/// Iterations after which the result is within the error that `tests/oracles` allows (measured).
fn iterations(time: f32) -> usize {
    (4.0 + time * 0.2).min(24.0) as usize
}

/// Sides of a tile without its rim: four fields of floats of it fit a second-level cache.
const TILE: (usize, usize) = (256, 96);

fn flow_in_tiles(plane: &Plane, time: f32, iterations: usize, context: &mut Context<'_>) -> Result<Plane> {
    let (width, height) = (plane.width(), plane.height());
    let rim = iterations + 1;
    let mut out = context.take_plane(width, height);
    for top in (0..height).step_by(TILE.1) {
        for left in (0..width).step_by(TILE.0) {
            let (x0, y0) = (left.saturating_sub(rim), top.saturating_sub(rim));
            let (x1, y1) = ((left + TILE.0 + rim).min(width), (top + TILE.1 + rim).min(height));
            let mut tile = context.take_plane(x1 - x0, y1 - y0);
            for y in y0..y1 {
                tile.row_mut(y - y0).copy_from_slice(&plane.row(y)[x0..x1]);
            }
            let tile = flow(tile, time, iterations, context)?;
            let (right, bottom) = ((left + TILE.0).min(width), (top + TILE.1).min(height));
            for y in top..bottom {
                out.row_mut(y)[left..right].copy_from_slice(&tile.row(y - y0)[left - x0..right - x0]);
            }
            context.give_plane(tile);
        }
    }
    Ok(out)
}

fn flow(mut plane: Plane, time: f32, iterations: usize, context: &mut Context<'_>) -> Result<Plane> {
    let (width, height) = (plane.width(), plane.height());
    let count = width * height;
    // The dual field (x and y parts) and its extrapolation.
    let mut field = [0; 4].map(|_| context.take_floats(count));
    for part in &mut field {
        part.fill(0.0);
    }
    let mut rows = [0; 2].map(|_| context.take_floats(width));
    let mut momentum = 1.0f32;
    for _ in 0..iterations {
        context.check_cancelled()?;
        let next = f32::midpoint(1.0, (1.0 + 4.0 * momentum * momentum).sqrt());
        let push = (momentum - 1.0) / next;
        momentum = next;
        iterate(&plane, time, push, &mut field, &mut rows);
    }
    let [px, py, ..] = &field;
    for y in 0..height {
        primal(&plane, y, time, (px, py), &mut rows[0]);
        for (out, &u) in plane.row_mut(y).iter_mut().zip(&rows[0]) {
            *out = (u + 0.5).clamp(0.0, 255.0) as u8;
        }
    }
    for part in field.into_iter().chain(rows) {
        context.give_floats(part);
    }
    Ok(plane)
}

/// One step from the extrapolated field (parts 2 and 3) to the field (parts 0 and 1) and the next
/// extrapolation, row by row.
fn iterate(plane: &Plane, time: f32, push: f32, field: &mut [Vec<f32>; 4], rows: &mut [Vec<f32>; 2]) {
    let (width, height) = (plane.width(), plane.height());
    let rate = 0.125 / time;
    let [px, py, qx, qy] = field;
    let [here, below] = rows;
    primal(plane, 0, time, (qx, qy), here);
    for y in 0..height {
        if y + 1 < height {
            primal(plane, y + 1, time, (qx, qy), below);
        } else {
            below.copy_from_slice(here);
        }
        let row = y * width..(y + 1) * width;
        let old = (&mut px[row.clone()], &mut py[row.clone()]);
        ascend(here, below, (rate, push), old, (&mut qx[row.clone()], &mut qy[row]));
        std::mem::swap(here, below);
    }
}

/// u = f + t div p for row `y`.
fn primal(plane: &Plane, y: usize, time: f32, (px, py): (&[f32], &[f32]), out: &mut [f32]) {
    let width = plane.width();
    let f = &plane.row(y)[..width];
    let px = &px[y * width..][..width];
    let here = &py[y * width..][..width];
    let out = &mut out[..width];
    // p is 0 across the last row and column (Neumann borders), so plain differences do there, too.
    if y == 0 {
        for x in 0..width {
            out[x] = f32::from(f[x]) + time * (px[x] + here[x]);
        }
    } else {
        let above = &py[(y - 1) * width..][..width];
        for x in 0..width {
            out[x] = f32::from(f[x]) + time * (px[x] + (here[x] - above[x]));
        }
    }
    for x in 1..width {
        out[x] -= time * px[x - 1];
    }
}

/// One row of the dual step. `here` and `below` are rows of u.
fn ascend(
    here: &[f32],
    below: &[f32],
    (rate, push): (f32, f32),
    (px, py): (&mut [f32], &mut [f32]),
    (qx, qy): (&mut [f32], &mut [f32]),
) {
    let last = px.len() - 1;
    let step = |dx: f32, dy: f32, p: (&mut f32, &mut f32), q: (&mut f32, &mut f32)| {
        let (x, y) = (*q.0 + rate * dx, *q.1 + rate * dy);
        let shrink = 1.0 / (x * x + y * y).sqrt().max(1.0);
        let (x, y) = (x * shrink, y * shrink);
        (*q.0, *q.1) = (x + push * (x - *p.0), y + push * (y - *p.1));
        (*p.0, *p.1) = (x, y);
    };
    let (right, here_body, below_body) = (&here[1..=last], &here[..last], &below[..last]);
    let (px_body, py_body) = (&mut px[..last], &mut py[..last]);
    let (qx_body, qy_body) = (&mut qx[..last], &mut qy[..last]);
    for x in 0..last {
        let (dx, dy) = (right[x] - here_body[x], below_body[x] - here_body[x]);
        step(dx, dy, (&mut px_body[x], &mut py_body[x]), (&mut qx_body[x], &mut qy_body[x]));
    }
    let dy = below[last] - here[last];
    step(0.0, dy, (&mut px[last], &mut py[last]), (&mut qx[last], &mut qy[last]));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_leave_no_seam() {
        let mut random = oorandom::Rand32::new(5);
        let plane = Plane::from_fn(600, 230, |x, y| {
            ((x / 11 * 37 + y / 13 * 91) as u32 % 200 + random.rand_u32() % 40) as u8
        });
        let mut context = Context::default();
        let whole = flow(plane.clone(), 15.0, 7, &mut context).unwrap();
        let tiled = flow_in_tiles(&plane, 15.0, 7, &mut context).unwrap();
        assert_eq!(tiled, whole);
    }

    #[test]
    fn the_mean_stays_and_a_small_dot_melts_faster_than_a_large_one() {
        let dot = |radius: i32| {
            Plane::from_fn(64, 64, |x, y| {
                let (dx, dy) = (x as i32 - 32, y as i32 - 32);
                if dx * dx + dy * dy <= radius * radius { 200 } else { 50 }
            })
        };
        let mean = |plane: &Plane| {
            plane.samples().iter().map(|&v| f64::from(v)).sum::<f64>() / plane.samples().len() as f64
        };
        let mut context = Context::default();
        let before = dot(12);
        let after = flow(before.clone(), 15.0, 100, &mut context).unwrap();
        assert!((mean(&after) - mean(&before)).abs() < 0.5);
        let small = flow(dot(3), 15.0, 100, &mut context).unwrap();
        assert!(small.at(32, 32) < after.at(32, 32));
    }
}
