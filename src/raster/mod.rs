//! Pixels: containers, decoding, resampling and colour. Lies under every stage and knows none of them.

mod axis;
pub mod color;
pub mod decode;
mod exif;
mod icc;
pub mod image;
mod jpeg;
pub mod orient;
pub mod plane;
pub mod resize;
mod samples;
mod separable;

pub use image::Image;
pub use plane::Plane;
