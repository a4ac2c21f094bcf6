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
pub use onnx::{MAX_BYTES, MAX_PAINTERS};

use crate::error::Result;
use crate::raster::Image;
use network::Network;

/// Largest reference of a model, in bytes.
const MAX_REFERENCE: usize = 200;

/// Whether a text is the reference of a user's model in a style: 16 hexadecimal digits that identify its content, a
/// space, and the name of its file.
#[must_use]
pub fn is_reference(text: &str) -> bool {
    let digit = |byte: u8| byte.is_ascii_digit() || (b'a'..=b'f').contains(&byte);
    text.len() <= MAX_REFERENCE
        && text.split_once(' ').is_some_and(|(hash, name)| {
            hash.len() == 16
                && hash.bytes().all(digit)
                && !name.is_empty()
                && !name.contains(char::is_control)
        })
}

/// A model of painters.
#[derive(Debug)]
pub struct Painters(Network);

impl Painters {
    /// Reads an ONNX file, which is untrusted input.
    ///
    /// # Errors
    /// `damaged-painters`, `large-painters`, `slow-painters` or `invalid-painters`, with the reason.
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
