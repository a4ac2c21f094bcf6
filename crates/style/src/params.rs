//! Parameters of a block. Controls, the JSON check, styles from a picture and the documentation all use these
//! descriptors.

use super::texture::Texture;
use std::sync::Arc;

/// One parameter of a block.
#[derive(Debug)]
pub struct Param {
    /// Key in a style file.
    pub id: &'static str,
    /// Name of the control.
    pub label: &'static str,
    /// One line for people.
    pub help: &'static str,
    /// Type, default and range.
    pub kind: Kind,
    /// Limit that keeps faces recognisable.
    pub face: Option<FaceLimit>,
    /// How a style from a picture adapts it. `None`: at random only.
    pub gaps: Option<Gaps>,
    /// Whether the search for a style from a picture does not change it at random, for example because it selects a kind.
    pub is_fixed: bool,
    /// How a repeating structure depends on it.
    pub repeat: Option<Repeat>,
    /// Largest value in a style file, if it is above the range. Only models of the user need such values.
    pub most: Option<f32>,
}

/// Maximum of a length on a face. The shares are for a face that is one pixel high, in pixels of a style.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FaceLimit {
    /// Distance or scale of the cells of a screen. It can become small.
    Cell {
        /// Maximum.
        share: f32,
        /// Minimum for any face.
        least: f32,
    },
    /// Scale of lines.
    Line(f32),
    /// Any other length.
    Length(f32),
}

/// Exponents of the factors that correct a style with too few lines, too thin lines, too dark tones and too little texture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gaps {
    /// For the number of lines.
    pub lines: f32,
    /// For their width.
    pub width: f32,
    /// For the tones.
    pub tone: f32,
    /// For texture.
    pub texture: f32,
}

impl Gaps {
    /// No correction.
    pub const NONE: Self = Self { lines: 0.0, width: 0.0, tone: 0.0, texture: 0.0 };
}

/// The part that a parameter has in a repeating structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Repeat {
    /// Distance of the dots or lines of a screen. Values below [`MIN_PITCH`] turn the screen off.
    Pitch,
    /// Size of another structure.
    Size,
}

/// Minimum distance of the dots or lines of a screen, in pixels of a style.
pub const MIN_PITCH: f32 = 3.0;

/// Minimum number of cells of a screen across the height of a face.
pub const FACE_CELLS: f32 = 14.0;

/// Type, default and range of a parameter. At run time every value is an f32: a flag is 0 or 1, a choice its position,
/// a colour the number of its six hexadecimal digits, which an f32 holds exactly.
#[derive(Debug)]
pub enum Kind {
    /// A number of `min..=max`.
    Number {
        /// The default if a style file has no value.
        default: f32,
        /// Smallest value.
        min: f32,
        /// Largest value.
        max: f32,
        /// Step of the slider.
        step: f32,
        /// Unit; pixels scale with the size of the render.
        unit: Unit,
    },
    /// A whole number of `min..=max`.
    Integer {
        /// The default if a style file has no value.
        default: i32,
        /// Smallest value.
        min: i32,
        /// Largest value.
        max: i32,
    },
    /// True or false.
    Flag {
        /// The default if a style file has no value.
        default: bool,
    },
    /// One of some names; the first is the default.
    Choice {
        /// The names.
        names: &'static [&'static str],
    },
    /// A picture of the user as a data URL; an empty text means no picture. It is stored next to the numbers
    /// ([`Step::texture`](super::file::Step)).
    Texture,
    /// A model of painters of the user, as `HASH NAME`; an empty text means the built-in model. It is stored next to
    /// the numbers ([`Step::model`](super::file::Step)).
    Model,
    /// A colour; in style files it is `#rrggbb`.
    Colour {
        /// The default if a style file has no value.
        default: [u8; 3],
    },
}

/// Unit of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// A plain number.
    None,
    /// Pixels of a 1920 x 1080 image, scaled by sqrt(w h / (1920 * 1080)).
    Pixels,
    /// Per cent.
    Percent,
    /// Degrees of an angle.
    Degrees,
    /// Grey steps of 0..=255.
    Grey,
}

impl Unit {
    /// Unit sign after the number.
    #[must_use]
    pub fn sign(self) -> &'static str {
        match self {
            Self::None | Self::Grey => "",
            Self::Pixels => "px",
            Self::Percent => "%",
            Self::Degrees => "°",
        }
    }
}

impl Kind {
    /// The default as an f32.
    #[must_use]
    pub fn default(&self) -> f32 {
        match *self {
            Self::Number { default, .. } => default,
            Self::Integer { default, .. } => default as f32,
            Self::Flag { default } => f32::from(u8::from(default)),
            Self::Choice { .. } | Self::Texture | Self::Model => 0.0,
            Self::Colour { default } => colour_value(default),
        }
    }

    /// Smallest and largest value as f32.
    #[must_use]
    pub fn range(&self) -> (f32, f32) {
        match *self {
            Self::Number { min, max, .. } => (min, max),
            Self::Integer { min, max, .. } => (min as f32, max as f32),
            Self::Flag { .. } => (0.0, 1.0),
            Self::Choice { names } => (0.0, names.len().saturating_sub(1) as f32),
            Self::Texture | Self::Model => (0.0, 0.0),
            Self::Colour { .. } => (0.0, colour_value([255; 3])),
        }
    }
}

impl Param {
    /// Sets the limit on faces.
    #[must_use]
    pub const fn for_face(self, limit: FaceLimit) -> Self {
        Self { face: Some(limit), ..self }
    }

    /// Sets the adaptation of styles from a picture.
    #[must_use]
    pub const fn correcting(self, gaps: Gaps) -> Self {
        Self { gaps: Some(gaps), ..self }
    }

    /// Marks a parameter that the search for a style from a picture does not change at random.
    #[must_use]
    pub const fn fixed(self) -> Self {
        Self { is_fixed: true, ..self }
    }

    /// Accepts values above the range in style files.
    #[must_use]
    pub const fn up_to(self, most: f32) -> Self {
        Self { most: Some(most), ..self }
    }

    /// Marks the size of a repeating structure.
    #[must_use]
    pub const fn repeating(self, repeat: Repeat) -> Self {
        Self { repeat: Some(repeat), ..self }
    }

    /// Marks the distance of the dots or lines of a screen.
    #[must_use]
    pub const fn pitch(self) -> Self {
        let limit = FaceLimit::Cell { share: 1.0 / FACE_CELLS, least: MIN_PITCH };
        self.for_face(limit).fixed().repeating(Repeat::Pitch)
    }

    /// Returns the nearest value in range that the control can show. Numbers are rounded to a tenth of the
    /// slider's step.
    #[must_use]
    pub fn rounded(&self, value: f32) -> f32 {
        let (min, max) = self.kind.range();
        let value = match self.kind {
            // In f64, so that 0.91 is the nearest f32 to 0.91.
            Kind::Number { step, .. } => {
                let tenth = (f64::from(step) * 1e4).round() / 1e5;
                ((f64::from(value) / tenth).round() * tenth) as f32
            }
            _ => value.round(),
        };
        value.clamp(min, max)
    }
}

/// A parameter of any type.
#[must_use]
pub const fn param(id: &'static str, label: &'static str, help: &'static str, kind: Kind) -> Param {
    Param { id, label, help, kind, face: None, gaps: None, is_fixed: false, repeat: None, most: None }
}

/// A number parameter; the shorthand in which the blocks declare theirs.
#[must_use]
pub const fn number(
    id: &'static str,
    label: &'static str,
    help: &'static str,
    (default, min, max, step): (f32, f32, f32, f32),
    unit: Unit,
) -> Param {
    param(id, label, help, Kind::Number { default, min, max, step, unit })
}

/// A whole-number parameter.
#[must_use]
pub const fn integer(
    id: &'static str,
    label: &'static str,
    help: &'static str,
    (default, min, max): (i32, i32, i32),
) -> Param {
    param(id, label, help, Kind::Integer { default, min, max })
}

/// A choice between processing every channel and processing luma. The first is the default.
#[must_use]
pub const fn channels(names: &'static [&'static str]) -> Param {
    let help = "Only brightness, which preserves the colours, or each of red, green and blue.";
    param("channels", "Works on", help, Kind::Choice { names })
}

/// A colour parameter.
#[must_use]
pub const fn colour(id: &'static str, label: &'static str, help: &'static str, default: [u8; 3]) -> Param {
    param(id, label, help, Kind::Colour { default })
}

/// A colour as the value of a parameter.
#[must_use]
pub fn colour_value([r, g, b]: [u8; 3]) -> f32 {
    u32::from_be_bytes([0, r, g, b]) as f32
}

/// The colour of a value.
#[must_use]
pub fn colour_of(value: f32) -> [u8; 3] {
    let [_, r, g, b] = (value as u32).to_be_bytes();
    [r, g, b]
}

/// The input of a block: its values in the order of its descriptor, its texture, and the scale of the render.
#[derive(Debug, Clone, Copy)]
pub struct Args<'a> {
    values: &'a [f32],
    texture: Option<&'a Arc<Texture>>,
    model: Option<&'a str>,
    scale: f32,
}

impl<'a> Args<'a> {
    /// `values` in the order of the descriptor; `scale` = sqrt(w h / (1920 * 1080)) of the render.
    #[must_use]
    pub fn new(values: &'a [f32], scale: f32) -> Self {
        Self { values, texture: None, model: None, scale }
    }

    /// Sets the custom texture.
    #[must_use]
    pub fn with_texture(self, texture: Option<&'a Arc<Texture>>) -> Self {
        Self { texture, ..self }
    }

    /// Sets the reference of the custom model.
    #[must_use]
    pub fn with_model(self, model: Option<&'a str>) -> Self {
        Self { model, ..self }
    }

    /// A custom texture.
    #[must_use]
    pub fn texture(&self) -> Option<&'a Arc<Texture>> {
        self.texture
    }

    /// A model of the user.
    #[must_use]
    pub fn model(&self) -> Option<&'a str> {
        self.model
    }

    /// The stored value of parameter `i`.
    #[must_use]
    pub fn number(&self, i: usize) -> f32 {
        self.values[i]
    }

    /// Parameter `i`, in pixels of this render.
    #[must_use]
    pub fn pixels(&self, i: usize) -> f32 {
        self.values[i] * self.scale
    }

    /// Parameter `i` as true or false.
    #[must_use]
    pub fn flag(&self, i: usize) -> bool {
        self.values[i] != 0.0
    }

    /// Parameter `i` as a colour.
    #[must_use]
    pub fn colour(&self, i: usize) -> [u8; 3] {
        colour_of(self.values[i])
    }

    /// Parameter `i` as a position in its names.
    #[must_use]
    pub fn choice(&self, i: usize) -> usize {
        self.values[i] as usize
    }
}
