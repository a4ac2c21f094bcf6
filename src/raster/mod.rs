//! Pixels: containers, decoding, resampling and colour. Lies under every stage and knows none of them.

mod axis;
pub mod color;
pub mod decode;
mod exif;
mod gif;
mod icc;
pub mod image;
mod jpeg;
pub mod orient;
pub mod plane;
mod png;
pub mod resize;
mod samples;
mod separable;
mod tiff;

pub use image::Image;
pub use plane::Plane;
