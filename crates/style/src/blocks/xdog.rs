//! `XDoG`: S = (1 + p) G(sigma) - p G(1.6 sigma), clipped: sharpens toward ink at edges of the scale sigma.
//!
//! Both Gaussians are made from the image itself: at a border, one made from the other would repeat an edge that
//! is already blurred. They stay in 1/64 grey steps, because p multiplies their error. A colour image takes the new
//! luma and keeps its colours.
//!
//! Source: Winnemöller et al., "`XDoG`: an `eXtended` difference-of-Gaussians compendium", 2012.

use super::{Block, Channels, Kernel};
use crate::context::Context;
use crate::params::{FaceLimit, Gaps, Unit, number};
use crate::raster::Plane;
use crate::simd::fine::{FRACTION, Fine};
use crate::simd::gaussian::blur;

pub(super) static BLOCK: Block = Block {
    id: "xdog",
    label: "XDoG",
    plain: "Pen lines",
    help: "Finds lines like a pen would draw them; put Soft Threshold behind it.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[
        number("sigma", "Line width", "Scale of the lines.", (1.5, 0.3, 20.0, 0.1), Unit::Pixels)
            .for_face(FaceLimit::Line(1.0 / 50.0))
            .correcting(Gaps { lines: 0.2, width: 0.9, ..Gaps::NONE }),
        number("p", "Strength", "How strongly lines stand out.", (20.0, 0.0, 100.0, 0.5), Unit::None)
            .correcting(Gaps { lines: 0.7, ..Gaps::NONE }),
    ],
    kernel: Kernel::Luma(|args, plane, context| Ok(run(args.pixels(0), args.number(1), plane, context))),
    ..Block::PLAIN
};

fn run(sigma: f32, p: f32, mut plane: Plane, context: &mut Context<'_>) -> Plane {
    // Thumbnails scale sigma below what a pixel grid can show: keep the thinnest line that it can.
    let sigma = sigma.max(0.3);
    let buffers = &mut context.blurs;
    let mut image = buffers.take(plane.width(), plane.height());
    image.widen(&plane);
    let narrow = blur(&image, sigma, buffers);
    let wide = blur(&image, 1.6 * sigma, buffers);
    for y in 0..plane.height() {
        combine(&narrow, &wide, y, p, plane.row_mut(y));
    }
    for fine in [image, narrow, wide] {
        buffers.give(fine);
    }
    plane
}

/// One row of G + p (G - G'), rounded and clipped. p in Q8: 100 * 256 * 16320 fits an i32.
fn combine(narrow: &Fine, wide: &Fine, y: usize, p: f32, out: &mut [u8]) {
    const BITS: u32 = FRACTION + 8;
    let p = (p * 256.0).round() as i32;
    let rows = narrow.row_clamped(y as isize).iter().zip(wide.row_clamped(y as isize));
    for (out, (&narrow, &wide)) in out.iter_mut().zip(rows) {
        let (narrow, wide) = (i32::from(narrow), i32::from(wide));
        let sum = (narrow << 8) + p * (narrow - wide);
        *out = ((sum + (1 << (BITS - 1))) >> BITS).clamp(0, 255) as u8;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flat_areas_keep_their_tone_and_edges_overshoot() {
        let plane = Plane::from_fn(64, 40, |x, _| if x < 32 { 60 } else { 180 });
        let out = run(2.0, 20.0, plane, &mut Context::default());
        assert_eq!((out.at(2, 20), out.at(61, 20)), (60, 180));
        assert_eq!((out.at(28, 20), out.at(35, 20)), (0, 255));
    }
}
