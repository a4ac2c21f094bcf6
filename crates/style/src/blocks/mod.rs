//! The registry of filter blocks. A new block is one file here and one line in [`ALL`]: controls, style
//! files, their check and the documentation follow from its descriptor. Random styles have a separate list of blocks.

mod brightness;
mod colorize;
mod detail;
mod dynamic_range;
mod engrave;
mod equalize;
mod etf;
pub(crate) mod flatten;
mod flow_lines;
mod gaussian;
mod halftone;
mod hue;
mod kuwahara;
mod luma_posterize;
pub mod painter;
mod paper;
mod pattern;
pub mod plates;
mod posterize;
mod saturation;
mod size;
mod sobel;
mod soft_threshold;
mod strokes;
mod to_color;
mod to_gray;
mod tvf;
mod xdog;

use super::context::Context;
use super::params::{Args, Param};
use super::part::Part;
use super::point_op::PointOp;
use crate::error::Result;
use crate::raster::{Image, Plane};
use crate::simd::tones::Tones;
use serde::Serialize;

/// All blocks, in their display order.
pub static ALL: &[&Block] = &[
    &to_gray::BLOCK,
    &to_color::BLOCK,
    &posterize::BLOCK,
    &luma_posterize::BLOCK,
    &brightness::BLOCK,
    &soft_threshold::BLOCK,
    &saturation::BLOCK,
    &hue::BLOCK,
    &colorize::BLOCK,
    &gaussian::BLOCK,
    &etf::BLOCK,
    &tvf::BLOCK,
    &detail::BLOCK,
    &sobel::BLOCK,
    &xdog::BLOCK,
    &flow_lines::BLOCK,
    &kuwahara::BLOCK,
    &painter::BLOCK,
    &engrave::BLOCK,
    &strokes::BLOCK,
    &flatten::BLOCK,
    &plates::BLOCK,
    &paper::BLOCK,
    &size::BLOCK,
    &pattern::BLOCK,
    &halftone::BLOCK,
    &equalize::BLOCK,
    &dynamic_range::BLOCK,
];

/// The block with this id.
#[must_use]
pub fn find(id: &str) -> Option<&'static Block> {
    ALL.iter().copied().find(|block| block.id == id)
}

/// A filter block: data and a function pointer.
#[derive(Debug)]
#[allow(clippy::struct_excessive_bools, reason = "independent properties")]
pub struct Block {
    /// Name in style files.
    pub id: &'static str,
    /// Name for people: the technical term.
    pub label: &'static str,
    /// Plain name, which the app shows before the label. Empty if the label is plain.
    pub plain: &'static str,
    /// Summary of its effect, in one line.
    pub help: &'static str,
    /// Its input channels.
    pub input: Channels,
    /// Its output channels.
    pub output: Channels,
    /// Its parameters, in the order of [`Args`].
    pub params: &'static [Param],
    /// How it runs.
    pub kernel: Kernel,
    /// Whether it lays a screen, strokes or paper over a picture. Its pattern must continue across a face.
    pub is_screen: bool,
    /// Whether it restores the colours that an earlier block took away.
    pub restores_color: bool,
    /// Whether a style from a picture replaces it by the colours of the picture.
    pub is_coloring: bool,
    /// Whether these values replace or remove the colours of the photo. Faces then have the colours of the style.
    pub recolors: fn(&[f32]) -> bool,
    /// Adapts the values for a face that is drawn again.
    pub adapt_to_face: fn(&mut [f32]),
    /// Whether large faces are drawn again as well, with the adapted values.
    pub adapts_to_large_faces: bool,
}

impl Block {
    /// Default values of the fields that only some blocks set. The other fields are placeholders.
    pub const PLAIN: Self = Self {
        id: "",
        label: "",
        plain: "",
        help: "",
        input: Channels::Any,
        output: Channels::Any,
        params: &[],
        kernel: Kernel::Image(|_, image, _| Ok(image)),
        is_screen: false,
        restores_color: false,
        is_coloring: false,
        recolors: |_| false,
        adapt_to_face: |_| {},
        adapts_to_large_faces: false,
    };

    /// Output channels for an input of `channels`. A block for a part of the picture leaves the other part
    /// unchanged. The result has colour if either part has colour.
    #[must_use]
    pub fn given(&self, channels: Channels, part: Option<Part>) -> Channels {
        match self.output {
            Channels::Any => channels,
            Channels::Luma if part.is_some() => channels,
            output => output,
        }
    }
}

/// Input and output channels of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub enum Channels {
    /// One luma plane.
    Luma,
    /// R, G and B.
    Color,
    /// Any channels. As an output: the same channels as the input.
    Any,
}

/// How a block runs, which decides what the chain can fuse it with.
#[derive(Debug, Clone, Copy)]
pub enum Kernel {
    /// Looks at one pixel only: joins its neighbours in the chain in one pass.
    Point(fn(Args<'_>) -> PointOp),
    /// A table made from percentiles of luma.
    Tones(fn(Args<'_>, &Tones<'_>) -> PointOp),
    /// Looks at neighbours, plane by plane.
    Planes(fn(Args<'_>, Plane, &mut Context<'_>) -> Result<Plane>),
    /// Looks at the luma of neighbours; a colour image keeps its colours and takes the new luma.
    Luma(fn(Args<'_>, Plane, &mut Context<'_>) -> Result<Plane>),
    /// Needs the whole image.
    Image(fn(Args<'_>, Image, &mut Context<'_>) -> Result<Image>),
}

/// Result of a block in a test, at the scale of a 1920 x 1080 picture. Parameters have their defaults, except
/// the ones in `change`, each by its index and value.
#[cfg(test)]
pub(crate) fn tried<T>(
    block: &Block,
    change: &[(usize, f32)],
    run: impl FnOnce(Args, &mut Context) -> Result<T>,
) -> T {
    let mut context = Context::default();
    context.set_scale(1.0);
    let mut values: Vec<f32> = block.params.iter().map(|param| param.kind.default()).collect();
    for &(i, value) in change {
        values[i] = value;
    }
    #[allow(clippy::unwrap_used, reason = "a test may panic")]
    run(Args::new(&values, 1.0), &mut context).unwrap()
}
