//! Styles: by name, from files, and applied to an image.

use crate::failure::Failure;
use crate::pixels::Pixels;
use inkpanel_engine::native;
use inkpanel_engine::style::params::Kind;
use inkpanel_engine::style::{self, blocks, catalogue};
use serde_json::Value;

/// The layers of a style, as style files name them.
const LAYERS: [&str; 2] = ["background", "foreground"];
/// Name of the seed parameter of blocks.
const SEED: &str = "seed";

/// A style: a chain of filter blocks for the background, and an optional chain for the lines.
#[derive(Debug, Clone)]
pub struct Style(style::Style);

impl Style {
    /// The designed style of an id, such as `comic`.
    ///
    /// # Errors
    /// `unknown-style`.
    pub fn designed(id: &str) -> Result<Self, Failure> {
        Ok(Self(catalogue::find(id)?.clone()))
    }

    /// Ids and names of all designed styles.
    pub fn all() -> impl Iterator<Item = (&'static str, &'static str)> {
        catalogue::catalogue().iter().map(|style| (style.id.as_str(), style.name.as_str()))
    }

    /// The style of a style file, as the page saves them.
    ///
    /// # Errors
    /// `invalid-style`, with place and reason.
    pub fn from_json(json: &str) -> Result<Self, Failure> {
        let value: Value =
            serde_json::from_str(json).map_err(|error| Failure::argument("style", &error.to_string()))?;
        Ok(Self(style::Style::from_value("style", &value)?))
    }

    /// The style file.
    #[must_use]
    pub fn to_json(&self) -> String {
        self.0.to_value().to_string()
    }

    /// The style with a seed in all blocks that leave something to chance.
    ///
    /// # Errors
    /// Only if the build is broken.
    pub fn seeded(&self, seed: u32) -> Result<Self, Failure> {
        let mut value = self.0.to_value();
        for layer in LAYERS {
            for entry in value.get_mut(layer).and_then(Value::as_array_mut).into_iter().flatten() {
                let block = blocks::ALL.iter().find(|block| entry["block"] == block.id);
                if let Some(most) = block.and_then(|block| most_seed(block)) {
                    entry[SEED] = (seed % (most + 1)).into();
                }
            }
        }
        Ok(Self(style::Style::from_value("style", &value)?))
    }

    /// Draws an image in the style, in the same size. Widths of lines and the like are as on a panel of that
    /// size.
    ///
    /// # Errors
    /// `buffer-size` if the number of bytes does not match the size.
    pub fn draw(&self, picture: &Pixels) -> Result<Pixels, Failure> {
        let image = picture.image()?;
        let drawn = style::stylize(&image, &self.0, &mut native::context_for(&self.0, &image))?;
        Ok(Pixels { width: drawn.width(), height: drawn.height(), rgb: drawn.to_rgb(), dpi: picture.dpi })
    }

    /// A style of the engine.
    #[doc(hidden)]
    #[must_use]
    pub fn new(style: style::Style) -> Self {
        Self(style)
    }

    /// As the engine has it.
    #[doc(hidden)]
    #[must_use]
    pub fn chain(&self) -> &style::Style {
        &self.0
    }
}

/// The largest seed of a block; `None` if it has no seed.
fn most_seed(block: &blocks::Block) -> Option<u32> {
    match block.params.iter().find(|param| param.id == SEED)?.kind {
        Kind::Integer { max, .. } => u32::try_from(max).ok(),
        _ => None,
    }
}
