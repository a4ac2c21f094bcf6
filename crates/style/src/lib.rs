//! # Styles of Inkpanel
//!
//! A style is two layers, and a layer is a chain of filter blocks. This crate is compiled for speed.
//!
//! | module | for |
//! |---|---|
//! | [`part`] | layers and blocks that apply only to the subject or the background of a photo |
//! | [`params`] | parameter descriptors: kind, default, range, step, unit |
//! | [`point_op`] | operations on single pixels |
//! | [`blocks`] | the registry, with one file per block |
//! | [`blade`] | operators learned from photos, as banks of small filters |
//! | [`painters`] | a small network that learned from paintings |
//! | [`faces`] | protection of faces |
//! | [`mod@file`] | the style file: parsing with exact error places, writing |
//! | [`chain`] | a layer compiled into passes and run |
//! | [`tangents`] | the direction of edges everywhere, and averages along it |
//! | [`context`] | scale, scratch memory and cancellation that a run gives to its blocks |
//! | [`catalogue`] | the designed styles that ship in `styles/` |
//! | [`texture`] | custom texture for Pattern Filling |
//! | [`grain`] | noise of a given size, the same everywhere |
//! | [`stages`] | a chain that keeps the picture after every block, for the designer |
//! | [`procedural`] | styles invented from a seed |
//! | [`breeding`] | new styles from two others |
//! | [`imitate`] | styles that look like a picture |
//! | [`look`] | family of a look, and whether two pictures look the same |
//! | [`aesthetic`] | the light score that sorts them |

pub mod aesthetic;
pub mod blade;
pub mod blocks;
pub mod breeding;
pub mod catalogue;
pub mod chain;
pub mod context;
mod face_box;
pub mod faces;
pub mod file;
pub mod grain;
pub mod imitate;
pub mod look;
pub mod painters;
pub mod params;
pub mod part;
pub mod point_op;
pub mod procedural;
mod shadows;
mod skin;
pub mod stages;
pub mod tangents;
pub mod texture;

pub use context::Context;
pub use file::Style;

use inkpanel_image::error::Result;
use inkpanel_image::raster::Image;
use inkpanel_image::simd::point::luma_plane;
// Modules of this crate name the layer below as `crate::raster`, as modules of the engine do.
use inkpanel_image::{error, order, raster, simd};

/// Runs a style on an image: the background layer, and the foreground layer laid over it as ink.
///
/// The result has the size of `image`. It is luma if nothing in it has colour. The style protects the faces
/// that the context knows, unless it turns protection off. If the context knows the subject, layers and
/// blocks for one part apply only there.
///
/// # Errors
/// `cancelled` if the caller cancels.
#[inline(never)]
pub fn stylize(image: &Image, style: &Style, context: &mut Context<'_>) -> Result<Image> {
    let drawn = cared(image, style, context);
    // The next image has another.
    context.show_subject(None);
    drawn
}

fn cared(image: &Image, style: &Style, context: &mut Context<'_>) -> Result<Image> {
    let faces = context.shown_faces(style.faces);
    let care = if faces.is_empty() { None } else { faces::Care::of(&faces, &luma_plane(image)) };
    let Some(care) = care else {
        return layered(style, (image, image), context, None);
    };
    let style = care.scaled(style, context.scale());
    let lifted = shadows::lifted(image, &faces);
    let (colours, lines) = lifted.as_ref().map_or((image, image), |(colours, lines)| (colours, lines));
    let (lit, lines) = (care.lit(colours), care.lit_for_lines(lines));
    let mut drawn = layered(&style, (&lit, &lines), context, Some(&care))?;
    care.mend(&lit, &mut drawn, !style.keeps_colours(), context.scale());
    care.deepen(&lit, &mut drawn, !style.keeps_colours(), context.scale());
    Ok(drawn)
}

/// The layers of a style, each on its own light of the photo.
fn layered(
    style: &Style,
    (image, lines): (&Image, &Image),
    context: &mut Context<'_>,
    care: Option<&faces::Care<'_>>,
) -> Result<Image> {
    let mut run = |steps: &[file::Step], image: &Image, holds: bool| match care {
        Some(care) => care.run(steps, image, holds, context),
        None => chain::run(steps, image, context),
    };
    let mut background = run(&style.background, image, true)?;
    let lines = match &style.foreground {
        Some(foreground) => {
            let mut drawn = run(foreground, lines, false)?;
            // Without colours of the photo, only lines show a face.
            if let Some(care) = care.filter(|_| style.keeps_colours()) {
                care.clean(lines, &mut drawn);
            }
            Some(drawn)
        }
        None => None,
    };
    if let Some(part) = style.parts.background {
        background = part::mixed(image.clone(), background, part, context);
    }
    let Some(mut lines) = lines else { return Ok(background) };
    context.check_cancelled()?;
    if let Some(part) = style.parts.foreground {
        lines = part::lines_in(&lines, part, context);
    }
    Ok(chain::lay_ink(background, &lines, style.ink))
}
