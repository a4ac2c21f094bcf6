//! SIMD row kernels. Only this folder depends on the number of pixels per instruction.
//!
//! Everything here is integer arithmetic, or floats without a rounding that could differ, so wasm, x86 and ARM
//! give the same bytes. The lane types come from
//! the `wide` crate: one source for simd128, SSE and NEON.
//!
//! | module | for |
//! |---|---|
//! | [`point`] | operations on a pixel's own three channels, sixteen pixels at a time |
//! | [`table`] | 256-entry tables, run as compares where a table has few steps |
//! | [`tones`] | percentiles, by counting |
//! | [`mix`] | weighted sums of rows, for resampling |
//! | [`lanes`] | moves between lane widths |
//! | [`flow`] | rows of the dual solver of Total Variation Flow |
//! | [`screen`] | the choice of a pattern for each tone |
//! | [`dots`] | the dots of a printing screen, and separation of colours into inks |
//! | [`edge`] | gradient magnitudes |
//! | [`volume`] | rows of cells over x and tone: gathered, blurred, read between |
//! | [`fine`] | planes of 1/64 grey steps, in which blurs keep their precision |
//! | [`convolve`] | convolutions with many channels |
//! | [`fir`] | symmetric convolutions of rows and columns of fine planes |
//! | [`gaussian`] | Gaussian smoothing at a cost that does not grow with sigma |
//! | [`blade`] | 7 x 7 filters that change from place to place |
//! | [`dct`] | the inverse transform of JPEG, at full size or reduced |
//! | [`ycc`] | the colours of JPEG as red, green and blue |
//! | [`fft`] | the steps of a Fourier transform |
//! | [`oriented`] | averages and choices at places that turn with a field of directions |

pub mod blade;
pub mod convolve;
#[cfg(feature = "decode")]
pub mod dct;
pub mod dots;
pub mod double;
pub mod edge;
#[cfg(feature = "decode")]
pub mod fft;
pub mod fine;
pub mod fir;
pub mod flow;
pub mod gaussian;
pub mod lanes;
pub mod mix;
pub mod oriented;
pub mod point;
pub mod screen;
pub mod table;
pub mod tones;
pub mod volume;
#[cfg(feature = "decode")]
pub mod ycc;
