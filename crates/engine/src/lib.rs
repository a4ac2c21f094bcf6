//! # The stages of Inkpanel
//!
//! This crate contains everything between pixels and files: it selects photos, plans pages, draws them, and applies edits. **Its API
//! changes between versions without notice.** The crate [`inkpanel`](https://docs.rs/inkpanel) has the stable API.
//!
//! The modules are in the order of the data flow. A module never imports a later one. Each stage has an example that runs,
//! `examples/stage_raster.rs` and so on to `stage_page.rs`.
//!
//! | module | stage |
//! |---|---|
//! | [`raster`] | pixels: planar u8 images, decoding, resampling (crate `inkpanel-image`) |
//! | [`simd`] | row kernels on SIMD lanes (crate `inkpanel-image`) |
//! | [`kinds`] | the kinds of files, by their names and first bytes |
//! | [`select`] | fingerprints, near-duplicate groups and their sharpest photo; shots of videos |
//! | [`hearing`] | detection of music and of sounds that can become sound effects |
//! | [`places`] | names of places by location |
//! | `detect` | faces, objects, aesthetic scores and subject masks (feature `detect`, crate `inkpanel-detect`) |
//! | [`layout`] | page templates: split trees, polygons, gutters, merges (crate `inkpanel-model`) |
//! | [`framing`] | the crop of a photo that fits a panel |
//! | [`style`] | chains of filter blocks in two layers (crate `inkpanel-style`) |
//! | [`plan`] | choice of layout and photos, scored by the visible content |
//! | [`page`] | panels, borders and paper composed into one page; PNG, JPEG, PDF |
//! | [`output`] | digital comics: HTML with a reader, EPUB, comic archives |
//! | [`document`] | edits of the project, which has pages, photos, styles and layouts (crate `inkpanel-model`) |
//! | `native` | rendering on all cores |
//! | [`json`] | the JSON parser with limits (crate `inkpanel-model`) |
//! | `texts` | text files in any encoding (feature `texts`) |
//!
//! Images and styles are compiled for speed, this crate for size. Every spatial parameter of a style is in pixels of a 1920 x 1080
//! image, and scaled to the size of the render.
//!
//! # Features
//!
//! | feature | for |
//! |---|---|
//! | `detect` | models that detect faces and objects |
//! | `webp` | WebP, read and written |
//! | `rare` | photos as WebP, TIFF and GIF, and with the colours of scanners and presses |
//! | `heic` | photos of phones as HEIC |
//! | `files` | saved projects and page PNGs |
//! | `texts` | text files in any encoding |

pub mod document;
pub mod framing;
pub mod hearing;
pub mod kinds;
#[cfg(not(target_arch = "wasm32"))]
pub mod native;
pub mod output;
pub mod page;
pub mod places;
pub mod plan;
pub mod select;
#[cfg(feature = "texts")]
pub mod texts;
#[cfg(test)]
mod typescript;

#[cfg(feature = "detect")]
pub use inkpanel_detect as detect;
use inkpanel_image::order;
pub use inkpanel_image::{
    error::{self, Error, Result},
    raster, simd,
};
pub use inkpanel_model::{json, layout};
pub use inkpanel_style as style;
