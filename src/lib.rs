//! # Inkpanel
//!
//! Photos in, a stylised storyboard page out. The modules stand in the order that a photo travels; a stage
//! never imports a later one.
//!
//! | module | stage |
//! |---|---|
//! | [`raster`] | pixels: planar u8 images, decoding, resampling (under everything) |
//! | [`simd`] | row kernels on lanes (under `style`) |
//! | [`select`] | fingerprints, near-duplicate groups, the sharpest of each; the shots of films |
//! | [`hearing`] | sounds of films that words may stand for, and where music runs |
//! | `detect` | faces and objects, by two nets (feature `detect`) |
//! | [`layout`] | page templates: split trees, polygons, gutters, merges |
//! | [`framing`] | the crop of a photo that fits a panel |
//! | [`style`] | chains of filter blocks in two layers |
//! | [`plan`] | which layout, which photo in which panel, judged by what is seen |
//! | [`page`] | panels, borders and paper composed into one page; PNG, JPEG, PDF |
//! | [`output`] | pages as comics that are read: HTML with a reader in it, EPUB, comic archives |
//! | [`document`] | the project that a person edits and saves: its pages, photos, styles and layouts |
//! | `native` | pages drawn by all cores of a machine (feature `cli`) |
//!
//! `error`, `raster`, `simd` and `style` are a crate of their own, `inkpanel-pixels`: what runs over pixels is compiled for
//! speed, the rest of the core to be small.
//!
//! Under everything beside `raster`: [`error`], and [`json`], which reads JSON of strangers.
//!
//! On top, without algorithms of their own: `wasm`, `wasm_detect`, `wasm_decoders`, `wasm_films`, `wasm_imitation`, `wasm_brush`, `wasm_words`, and `wasm_files` with `wasm_comics` (the
//! web boundary, in eight modules; `wasm_letters` is in two of them) and `main.rs` (the command line).
//!
//! Each stage has an example that runs: `examples/stage_raster.rs` and so on to `stage_page.rs`. Through some of them:
//!
//! ```
//! use inkpanel::framing::PhotoMeta;
//! use inkpanel::layout::{self, PageSettings};
//! use inkpanel::plan::{Order, assign, slots};
//! use inkpanel::raster::{Image, Plane};
//! use inkpanel::style::{Context, catalogue, stylize};
//!
//! // An image, where usually `raster::decode` gives one.
//! let plane = |i: usize| Plane::from_fn(60, 40, |x, y| ((3 + i) * x + (5 - i) * y) as u8);
//! let image = Image::from_rgb([plane(0), plane(1), plane(2)])?;
//!
//! // The same image in a style.
//! let style = catalogue::find("comic")?;
//! let drawn = stylize(&image, style, &mut Context::for_image(&image))?;
//! assert_eq!((drawn.width(), drawn.height()), (60, 40));
//!
//! // The panels of a page, and what each shows of three photos.
//! let page = PageSettings::default();
//! let panels = layout::resolve(layout::find("cinema-3")?, page.aspect(), &page);
//! let photos: Vec<_> = ["a", "b", "c"].map(|id| PhotoMeta::unmeasured(id, 1600, 1200)).into();
//! let shown = assign(&photos, &slots(&panels, f64::from(page.width)), Order::Kept, 7);
//! assert_eq!(shown.len(), panels.len());
//! # Ok::<(), inkpanel::Error>(())
//! ```
//!
//! Invariants: no global state, no clock, no randomness but from a seed that the caller gives; every
//! spatial parameter of a style is in pixels of a 1920 x 1080 image and scaled to the render at hand.

#[cfg(feature = "detect")]
pub mod detect;
#[cfg(feature = "pages")]
pub mod document;
#[cfg(feature = "pages")]
pub mod framing;
#[cfg(feature = "pages")]
pub mod hearing;
#[cfg(feature = "pages")]
pub mod json;
#[cfg(feature = "pages")]
pub mod layout;
#[cfg(feature = "cli")]
pub mod native;
#[cfg(feature = "pages")]
pub mod output;
#[cfg(feature = "pages")]
pub mod page;
#[cfg(feature = "pages")]
pub mod plan;
#[cfg(feature = "pages")]
pub mod select;

#[cfg(all(test, feature = "cli"))]
mod typescript;

#[cfg(all(
    target_arch = "wasm32",
    feature = "pages",
    not(any(
        feature = "detect",
        feature = "words",
        feature = "exports",
        feature = "decoders",
        feature = "films",
        feature = "imitation",
        feature = "brush"
    ))
))]
pub mod wasm;
#[cfg(all(target_arch = "wasm32", feature = "exports"))]
pub mod wasm_boards;
#[cfg(all(target_arch = "wasm32", feature = "brush"))]
pub mod wasm_brush;
#[cfg(all(target_arch = "wasm32", feature = "exports"))]
pub mod wasm_comics;
#[cfg(all(target_arch = "wasm32", feature = "decoders"))]
pub mod wasm_decoders;
#[cfg(all(target_arch = "wasm32", feature = "detect"))]
pub mod wasm_detect;
#[cfg(all(target_arch = "wasm32", any(feature = "pages", feature = "detect")))]
mod wasm_error;
#[cfg(all(target_arch = "wasm32", feature = "exports"))]
pub mod wasm_files;
#[cfg(all(target_arch = "wasm32", feature = "films"))]
pub mod wasm_films;
#[cfg(all(target_arch = "wasm32", feature = "imitation"))]
pub mod wasm_imitation;
#[cfg(all(target_arch = "wasm32", any(feature = "words", feature = "exports")))]
pub mod wasm_letters;
#[cfg(all(target_arch = "wasm32", feature = "words"))]
pub mod wasm_words;

pub use error::{Error, Result};
#[cfg(feature = "pages")]
use inkpanel_pixels::order;
#[cfg(feature = "pages")]
pub use inkpanel_pixels::style;
pub use inkpanel_pixels::{error, raster, simd};
