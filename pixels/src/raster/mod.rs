//! Pixels: containers, decoding, resampling and colour. This is the lowest layer, independent of all others.

#[cfg(feature = "rare")]
pub mod animation;
mod axis;
pub mod balance;
#[cfg(feature = "heic")]
mod cicp;
pub mod color;
#[cfg(feature = "pages")]
pub mod decode;
#[cfg(feature = "pages")]
pub mod enlarge;
#[cfg(feature = "pages")]
mod exif;
#[cfg(feature = "rare")]
mod gif;
pub mod guided;
#[cfg(feature = "pages")]
pub mod heif;
#[cfg(feature = "pages")]
mod icc;
pub mod image;
#[cfg(feature = "pages")]
mod jpeg;
#[cfg(feature = "pages")]
pub mod location;
pub mod matte;
#[cfg(feature = "pages")]
pub mod orient;
pub mod plane;
#[cfg(feature = "pages")]
mod png;
pub mod resize;
pub mod retouch;
#[cfg(feature = "pages")]
mod samples;
mod separable;
pub mod sets;
#[cfg(feature = "rare")]
mod tiff;

pub use image::Image;
pub use matte::Matte;
pub use plane::Plane;
