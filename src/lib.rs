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
//! | `cli` | all of them, as the command line has them |
//!
//! # Crates
//!
//! The processing stages are separate crates without a stable API:
//! [`inkpanel-image`](https://docs.rs/inkpanel-image), [`inkpanel-style`](https://docs.rs/inkpanel-style),
//! [`inkpanel-detect`](https://docs.rs/inkpanel-detect), [`inkpanel-model`](https://docs.rs/inkpanel-model) and
//! [`inkpanel-engine`](https://docs.rs/inkpanel-engine). Items of this crate that take or return their types are hidden from this
//! documentation, and have no promise either. The command line is the crate `inkpanel-cli`.

mod album;
mod failure;
#[cfg(feature = "detect")]
mod nets;
mod note;
mod options;
mod page;
mod photo;
mod pixels;
mod places;
mod style;

pub use album::Album;
#[doc(hidden)]
pub use album::{BookPlan, Selection};
pub use failure::Failure;
#[doc(hidden)]
pub use failure::survived;
#[cfg(feature = "detect")]
pub use nets::Nets;
pub use note::Note;
pub use options::{BookOptions, PageOptions, layouts, page_settings};
#[doc(hidden)]
pub use page::with_names;
pub use page::{Page, pdf};
pub use photo::Photo;
pub use pixels::Pixels;
pub use places::PlaceNames;
pub use style::Style;
