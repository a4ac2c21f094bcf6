//! The channels of a decoded photo.

/// Channels of a pixel.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Channels {
    Grey,
    Rgb,
    /// Amounts of ink: 0 is bare paper.
    Cmyk,
}

impl Channels {
    /// Returns the number of samples per pixel.
    pub(super) fn count(self) -> usize {
        match self {
            Self::Grey => 1,
            Self::Rgb => 3,
            Self::Cmyk => 4,
        }
    }
}
