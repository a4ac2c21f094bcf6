//! # Inkpanel
//!
//! Inkpanel turns photos into stylised comic pages: it selects photos, chooses a layout, crops, applies a
//! style and adds lettering.
//!
//! ```
//! use inkpanel::{Album, PageOptions, Photo, Style};
//!
//! // Photos are files, the bytes of files, or pixels.
//! let gradient = |i: u8| (0..90 * 60).flat_map(|at| [(at % 90) as u8, (at / 90) as u8, 60 * i]).collect::<Vec<_>>();
//! let photos = (1..=3).map(|i| Photo::from_rgb(format!("photo {i}"), 90, 60, &gradient(i)));
//! let album = Album::read(photos.collect::<Result<_, _>>()?)?;
//!
//! // A page of them: what is not said is left to the photos and to chance, which begins at the seed.
//! let options = PageOptions::new().size("square", None, Some(320))?.style(&Style::designed("comic")?).seed(7);
//! let page = album.page(&options)?;
//! let png = page.png()?;
//! assert!(png.starts_with(b"\x89PNG"));
//! # Ok::<(), inkpanel::Failure>(())
//! ```
//!
//! | to | there is |
//! |---|---|
//! | read photos | [`Photo`], and an [`Album`] of photos that were read |
//! | detect faces and objects, so that no crop cuts them | [`Nets`](https://docs.rs/inkpanel/latest/inkpanel/struct.Nets.html) and `Album::detect` (feature `detect`) |
//! | plan pages | [`PageOptions`], [`layouts`], [`Style`] |
//! | draw pages | [`Page`], [`Pixels`], [`pdf`] |
//! | draw any picture in a style | [`Style::draw`] |
//! | find the reason of an error | [`Failure`] |
//! | read warnings | [`Note`] |
//!
//! The same photos and options make the same pixels, on every machine and in the browser. The crate has no
//! global state, no clock, and no randomness except from the caller's seed. Work uses all cores, or the
//! number of threads in `RAYON_NUM_THREADS`.
//!
//! # Features
//!
//! No feature is on by default.
//!
//! | feature | for |
//! |---|---|
//! | `detect` | models that detect faces and objects |
//! | `rare` | photos as WebP, TIFF and GIF, and with the colours of scanners and presses |
//! | `heic` | photos of phones as HEIC |
//! | `files` | saved projects |
//! | `texts` | text files in any encoding |
//! | `cli` | the command line `inkpanel`: `cargo install inkpanel --features cli` |
//! | `internals` | the processing stages; their API changes between versions without notice |
//!
//! # The stages
//!
//! With `internals`, the modules are public, in the order of the data flow. A module never imports a later
//! one. Each has an example that runs, `examples/stage_raster.rs` and so on to `stage_page.rs`.
//!
//! | module | stage |
//! |---|---|
//! | `raster` | pixels: planar u8 images, decoding, resampling (under everything) |
//! | `simd` | row kernels on lanes (under `style`) |
//! | `kinds` | the kinds of files, by their names and first bytes |
//! | `select` | fingerprints, near-duplicate groups and their sharpest photo; shots of videos |
//! | `hearing` | detection of music and of sounds that can become sound effects |
//! | `places` | names of places by location |
//! | `detect` | faces, objects, aesthetic scores and subject masks (feature `detect`) |
//! | `layout` | page templates: split trees, polygons, gutters, merges |
//! | `framing` | the crop of a photo that fits a panel |
//! | `style` | chains of filter blocks in two layers |
//! | `plan` | choice of layout and photos, scored by the visible content |
//! | `page` | panels, borders and paper composed into one page; PNG, JPEG, PDF |
//! | `output` | digital comics: HTML with a reader, EPUB, comic archives |
//! | `document` | the project: pages, photos, styles and layouts, with edits and undo |
//! | `native` | rendering on all cores |
//!
//! `error`, `raster` and `simd` are in the crate `inkpanel-image`, and `style` is the crate `inkpanel-style`. Both
//! are compiled for speed, the rest for size. `detect` is the crate `inkpanel-detect`, which depends on tract.
//!
//! Above them, without algorithms, are `facade` (the public API) and `main.rs` (the command line). The crates
//! of `wasm/` bind the stages to JavaScript. Every spatial parameter of a style is in pixels of a 1920 x
//! 1080 image, and scaled to the size of the render.

// Without public stages, many items are unused.
#![cfg_attr(
    not(feature = "internals"),
    allow(dead_code, unused_imports, unreachable_pub, clippy::struct_field_names)
)]

#[cfg(not(feature = "internals"))]
mod document;
#[cfg(feature = "internals")]
pub mod document;
#[cfg(not(feature = "internals"))]
mod framing;
#[cfg(feature = "internals")]
pub mod framing;
#[cfg(not(feature = "internals"))]
mod hearing;
#[cfg(feature = "internals")]
pub mod hearing;
#[cfg(not(feature = "internals"))]
mod json;
#[cfg(feature = "internals")]
pub mod json;
#[cfg(not(feature = "internals"))]
mod kinds;
#[cfg(feature = "internals")]
pub mod kinds;
#[cfg(not(feature = "internals"))]
mod layout;
#[cfg(feature = "internals")]
pub mod layout;
#[cfg(not(feature = "internals"))]
mod output;
#[cfg(feature = "internals")]
pub mod output;
#[cfg(not(feature = "internals"))]
mod page;
#[cfg(feature = "internals")]
pub mod page;
#[cfg(not(feature = "internals"))]
mod places;
#[cfg(feature = "internals")]
pub mod places;
#[cfg(not(feature = "internals"))]
mod plan;
#[cfg(feature = "internals")]
pub mod plan;
#[cfg(not(feature = "internals"))]
mod select;
#[cfg(feature = "internals")]
pub mod select;

#[cfg(all(feature = "texts", not(feature = "internals")))]
mod texts;
#[cfg(all(feature = "texts", feature = "internals"))]
pub mod texts;

#[cfg(not(target_arch = "wasm32"))]
mod facade;
#[cfg(all(not(target_arch = "wasm32"), not(feature = "internals")))]
mod native;
#[cfg(all(not(target_arch = "wasm32"), feature = "internals"))]
pub mod native;

#[cfg(all(test, feature = "cli"))]
mod typescript;

#[cfg(not(target_arch = "wasm32"))]
pub use facade::*;
#[cfg(all(feature = "detect", not(feature = "internals")))]
use inkpanel_detect as detect;
#[cfg(all(feature = "detect", feature = "internals"))]
pub use inkpanel_detect as detect;
use inkpanel_image::order;
#[cfg(not(feature = "internals"))]
use inkpanel_image::{error, raster, simd};
#[cfg(feature = "internals")]
pub use inkpanel_image::{
    error::{self, Error, Result},
    raster, simd,
};
#[cfg(not(feature = "internals"))]
use inkpanel_style as style;
#[cfg(feature = "internals")]
pub use inkpanel_style as style;
