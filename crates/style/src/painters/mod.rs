//! Painters: styles that a small network learned from paintings.
//!
//! The network is a chain of convolutions. All painters share its weights. A painter is a scale and an offset for
//! each channel of each layer, so two painters can be mixed (conditional instance normalisation).
//!
//! Convolutions run in 16-bit integers, and normalisation in single precision with exact operations only. All
//! platforms therefore give the same pixels. `tests/oracles/painters.py` compares them with ONNX Runtime.
//!
//! Source: Dumoulin, Shlens and Kudlur, "A Learned Representation for Artistic Style", 2017.

mod network;
mod onnx;
mod protobuf;

pub use network::{Choice, Norms};
pub use onnx::MAX_BYTES;

use crate::error::Result;
use crate::raster::Image;
use network::Network;

/// A model of painters.
#[derive(Debug)]
pub struct Painters(Network);

impl Painters {
    /// Reads an ONNX file, which is untrusted input.
    ///
    /// # Errors
    /// `invalid-painters` with the reason.
    pub fn new(onnx: &[u8]) -> Result<Self> {
        Ok(Self(Network::new(onnx::read(onnx)?)))
    }

    /// Number of painters, at least 1.
    #[must_use]
    pub fn count(&self) -> usize {
        self.0.painters()
    }

    /// Paints a colour image. Width and height must be multiples of 4 and at least 16. `norms` are known
    /// statistics, for a part of a measured image or for a later frame; `None` measures this image. Calls `check` between
    /// rows. Returns the picture and its statistics.
    ///
    /// # Errors
    /// The errors of `check`.
    pub fn paint(
        &self,
        image: &Image,
        choice: Choice,
        norms: Option<&Norms>,
        check: &dyn Fn() -> Result<()>,
    ) -> Result<(Image, Norms)> {
        self.0.run(image, choice, norms, check)
    }
}
