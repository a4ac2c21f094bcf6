//! Edge Tangent Flow: averages each pixel along the edge that runs through it, as a brush follows a shape.
//!
//! The operator is learned: its filters were fitted to Kang's edge tangent field with a Gaussian line integral of
//! sigma along it (`cargo xtask train etf`, see `crates/style/src/banks/README.md`). Colour images are guided by their luma.
//!
//! Sources: Kang, Lee and Chui, "Flow-based image abstraction", 2009; [`crate::blade`].

use super::{Block, Channels, Kernel};
use crate::blade::Trained;
use crate::params::{FaceLimit, Unit, number};

pub(super) static BLOCK: Block = Block {
    id: "etf",
    label: "Edge Tangent Flow",
    plain: "Brush strokes",
    help: "Smooths along edges and never across them, like strokes of a brush.",
    input: Channels::Any,
    output: Channels::Any,
    params: &[number(
        "sigma",
        "Stroke length",
        "Standard deviation of the smoothing along edges.",
        (3.0, 0.5, 12.0, 0.1),
        Unit::Pixels,
    )
    .for_face(FaceLimit::Line(1.0 / 28.0))],
    kernel: Kernel::Image(|args, image, context| BANK.run(args.pixels(0), image, context)),
    ..Block::PLAIN
};

static BANK: Trained = Trained::new("etf", include_bytes!("../banks/etf.blade"));
