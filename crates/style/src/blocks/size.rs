//! Size: scales the image. The following blocks run at the new size, and the layer returns to the size of the
//! panel at its end. Smaller makes what follows coarser and faster, larger makes it finer.

use super::{Block, Channels, Kernel};
use crate::params::{Unit, number};
use crate::raster::resize::{Region, resample};

pub(super) static BLOCK: Block = Block {
    id: "size",
    label: "Size",
    plain: "Coarse or fine",
    help: "Changes the working size of all later blocks: small is coarse, large is fine.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[number(
        "percent",
        "Size",
        "Relative to the previous size.",
        (100.0, 10.0, 300.0, 5.0),
        Unit::Percent,
    )],
    kernel: Kernel::Planes(|args, plane, context| {
        let (width, height) = target(plane.width(), plane.height(), f64::from(args.number(0)) / 100.0);
        if (width, height) == (plane.width(), plane.height()) {
            return Ok(plane);
        }
        let sized = resample(&plane, Region::whole(plane.width(), plane.height()), width, height);
        context.give_plane(plane);
        Ok(sized)
    }),
    ..Block::PLAIN
};

/// No block makes an image of more pixels than this larger still: a picture of 1920 x 1080 may become twice as large.
const MAX_PIXELS: f64 = 3840.0 * 2160.0;

fn target(width: usize, height: usize, factor: f64) -> (usize, usize) {
    let pixels = width as f64 * height as f64;
    let most = (MAX_PIXELS / pixels).sqrt().max(1.0);
    let factor = factor.min(most);
    let side = |side: usize| ((side as f64 * factor).round() as usize).max(1);
    (side(width), side(height))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn enlarging_stops_at_the_cap_and_nothing_vanishes() {
        assert_eq!(target(400, 300, 0.5), (200, 150));
        assert_eq!(target(3, 1, 0.1), (1, 1));
        let (width, height) = target(1920, 1080, 3.0);
        assert!((width * height) as f64 <= 8.3e6 && width > 1920);
        assert_eq!(target(1920, 1080, 2.0), (3840, 2160));
        assert_eq!(target(4000, 3000, 3.0), (4000, 3000));
    }
}
