//! Pixels: containers, decoding, resampling and colour. This is the lowest layer, independent of all others.

#[cfg(feature = "rare")]
pub mod animation;
mod axis;
pub mod balance;
#[cfg(feature = "decode")]
mod channels;
#[cfg(feature = "heic")]
mod cicp;
pub mod color;
#[cfg(feature = "decode")]
pub mod decode;
#[cfg(feature = "decode")]
pub mod enlarge;
#[cfg(feature = "decode")]
mod exif;
pub mod fill_light;
#[cfg(feature = "rare")]
mod gif;
pub mod grain;
pub mod guided;
#[cfg(feature = "decode")]
pub mod header;
#[cfg(feature = "decode")]
pub mod heif;
#[cfg(feature = "decode")]
mod icc;
pub mod image;
#[cfg(feature = "decode")]
mod jpeg;
#[cfg(feature = "decode")]
mod limits;
#[cfg(feature = "decode")]
pub mod location;
pub mod matte;
#[cfg(feature = "decode")]
pub mod orient;
pub mod plane;
#[cfg(feature = "decode")]
mod png;
pub mod resize;
pub mod retouch;
#[cfg(feature = "decode")]
mod samples;
mod separable;
pub mod sets;
#[cfg(feature = "rare")]
mod tiff;

pub use image::Image;
pub use matte::Matte;
pub use plane::Plane;
