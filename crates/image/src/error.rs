//! The one error type. Every variant has a stable `code()` for programs and a sentence for people.

/// Shorthand for results of this crate.
pub type Result<T> = std::result::Result<T, Error>;

/// Errors caused by user input.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// The bytes are not an image of a format that we read.
    #[error("this is not an image that Inkpanel can read (JPEG, PNG, WebP, GIF, BMP or TIFF)")]
    UnknownFormat,
    /// The file is not an image, or an image of an unsupported kind. The text contains advice for the user.
    #[error("{0}")]
    OtherKind(String),
    /// A colour profile of a scanner or press, in a build without the `rare` feature.
    #[error("this build cannot convert the colour profile of this photo")]
    RareColours,
    /// The file starts like an image but cannot be decoded.
    #[error("the {format} file is damaged or truncated: {reason}")]
    Damaged {
        /// Name of the format.
        format: &'static str,
        /// The message of the decoder.
        reason: String,
    },
    /// Less than half of the picture can be decoded.
    #[error("only {percent} % of this {format} can be decoded; the file is damaged or incomplete")]
    MostlyDamaged {
        /// Common name of the format.
        format: &'static str,
        /// Share of the image that can be decoded.
        percent: u8,
    },
    /// A valid file in an unsupported variant of the format.
    #[error("this kind of {format} file cannot be read: {reason}")]
    Unsupported {
        /// Name of the format.
        format: &'static str,
        /// Message of the decoder.
        reason: String,
    },
    /// The header announces more pixels, a longer side or more memory than the limits allow.
    #[error("the image is too large: {width} x {height} pixels, the limit is {limit}")]
    TooLarge {
        /// Announced width in pixels.
        width: u64,
        /// Announced height in pixels.
        height: u64,
        /// The exceeded limit, as text.
        limit: String,
    },
    /// The size of a pixel buffer does not match its width and height.
    #[error("{width} x {height} pixels need {expected} bytes, got {actual}")]
    BufferSize {
        /// Width in pixels.
        width: usize,
        /// Height in pixels.
        height: usize,
        /// Bytes needed.
        expected: usize,
        /// Bytes given.
        actual: usize,
    },
    /// A style file breaks its schema.
    #[error("style {file}: {location}: {reason}")]
    InvalidStyle {
        /// File name or id of the style.
        file: String,
        /// Location: `background[2] (gaussian), sigma`.
        location: String,
        /// The problem and the expected value.
        reason: String,
    },
    /// A layout file breaks its schema.
    #[error("layout {file}: {location}: {reason}")]
    InvalidLayout {
        /// File name or id of the layout.
        file: String,
        /// Path of the field: `tree.rows[1].weight`.
        location: String,
        /// The problem and the expected value.
        reason: String,
    },
    /// A document or request from the page breaks its schema.
    #[error("{location}: {reason}")]
    InvalidDocument {
        /// Path of the field.
        location: String,
        /// The problem and the expected value.
        reason: String,
    },
    /// A saved project breaks its schema.
    #[error("{location}: {reason}")]
    DamagedProject {
        /// Path of the field.
        location: String,
        /// The problem.
        reason: String,
    },
    /// A saved project has a version that this program does not support.
    #[error("{location}: {reason}")]
    NewerProject {
        /// Path of the field.
        location: String,
        /// The version of the file and the latest known version.
        reason: String,
    },
    /// A saved project has more of something than a project may.
    #[error("{location}: {reason}")]
    TooLargeProject {
        /// Path of the field.
        location: String,
        /// The count and its limit.
        reason: String,
    },
    /// A trained filter bank breaks its format.
    #[error("filter bank {name}: {reason}")]
    InvalidBank {
        /// Name of the bank.
        name: String,
        /// The problem and the expected value.
        reason: String,
    },
    /// No style of this id.
    #[error("there is no style called \"{0}\"")]
    UnknownStyle(String),
    /// No layout of this id.
    #[error("there is no layout called \"{0}\"")]
    UnknownLayout(String),
    /// A page refers to a photo whose pixels are not loaded.
    #[error("the photo \"{0}\" is not loaded")]
    MissingPhoto(String),
    /// A page was requested without photos.
    #[error("there is no usable photo")]
    NoPhotos,
    /// A picture for a style search has too few pixels.
    #[error("the picture is too small: {width} x {height} pixels, each side needs at least {least}")]
    SmallPicture {
        /// Width in pixels.
        width: usize,
        /// Height in pixels.
        height: usize,
        /// Minimum number of pixels per side.
        least: usize,
    },
    /// A picture for a style search is almost blank.
    #[error("the picture is blank, so it has no style")]
    BlankPicture,
    /// A picture for a style search is a plain photo.
    #[error("the picture looks like a plain photo; choose a drawing, a print or a painting")]
    PlainPhoto,
    /// The caller cancelled the work.
    #[error("cancelled")]
    Cancelled,
    /// A model is damaged, unexpected, or failed.
    #[error("the detector failed: {0}")]
    Detector(String),
    /// A file with painters is truncated, or of another kind.
    #[error("this is not a model of painters: {0}")]
    DamagedPainters(String),
    /// A file with painters is too large.
    #[error("this model of painters is too large: {0}")]
    LargePainters(String),
    /// A network with painters has too many layers, channels or multiplications.
    #[error("this model of painters would take too long: {0}")]
    SlowPainters(String),
    /// A network has other operators than painters.
    #[error("this is not a model of painters: {0}")]
    InvalidPainters(String),
    /// A page could not be encoded.
    #[error("the page could not be encoded: {0}")]
    Encode(String),
}

impl Error {
    /// Stable, machine-readable name of the error.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::UnknownFormat | Self::OtherKind(_) => "unknown-format",
            Self::RareColours => "rare-colours",
            Self::Damaged { .. } | Self::MostlyDamaged { .. } => "damaged",
            Self::Unsupported { .. } => "unsupported",
            Self::TooLarge { .. } => "too-large",
            Self::BufferSize { .. } => "buffer-size",
            Self::InvalidStyle { .. } => "invalid-style",
            Self::InvalidLayout { .. } => "invalid-layout",
            Self::InvalidDocument { .. } => "invalid-document",
            Self::DamagedProject { .. } => "damaged-project",
            Self::NewerProject { .. } => "newer-project",
            Self::TooLargeProject { .. } => "too-large-project",
            Self::InvalidBank { .. } => "invalid-bank",
            Self::UnknownStyle(_) => "unknown-style",
            Self::UnknownLayout(_) => "unknown-layout",
            Self::MissingPhoto(_) => "missing-photo",
            Self::NoPhotos => "no-photos",
            Self::SmallPicture { .. } => "small-picture",
            Self::BlankPicture => "blank-picture",
            Self::PlainPhoto => "plain-photo",
            Self::Cancelled => "cancelled",
            Self::Detector(_) => "detector",
            Self::DamagedPainters(_) => "damaged-painters",
            Self::LargePainters(_) => "large-painters",
            Self::SlowPainters(_) => "slow-painters",
            Self::InvalidPainters(_) => "invalid-painters",
            Self::Encode(_) => "encode",
        }
    }

    #[cfg(feature = "decode")]
    /// A damaged file of the given format, with the message of the decoder.
    pub fn damaged(format: &'static str, reason: impl std::fmt::Display) -> Self {
        Self::Damaged { format, reason: reason.to_string() }
    }
}
