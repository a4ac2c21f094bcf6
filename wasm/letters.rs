//! wasm bindings of glyphs, shared by the `words` and `exports` modules: the fonts and the traced glyphs. The
//! app loads the fonts once, as a separate file for both.
//!
//! Errors are like in the `words` module.

use inkpanel_engine::error::Result;
use inkpanel_engine::page::words::Letters;
use inkpanel_engine::page::words::learning::Drawing;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(start)]
fn start() {
    console_error_panic_hook::set_once();
}

/// The glyphs for the page.
#[wasm_bindgen]
pub struct Lettering {
    letters: Letters,
}

#[wasm_bindgen]
impl Lettering {
    /// Unpacks the fonts: the table that `crates/engine/pack.rs` makes of them.
    ///
    /// # Errors
    /// `damaged` if the table is not complete and valid.
    #[wasm_bindgen(constructor)]
    pub fn new(table: &[u8]) -> Result<Lettering> {
        Letters::parse(table).map(|letters| Self { letters })
    }

    /// Adds a run of text to all fonts as one glyph; see `page::words::learning`. Returns whether it is one
    /// now.
    #[allow(clippy::too_many_arguments, reason = "plain numbers of a picture")]
    pub fn learn(
        &mut self,
        run: &str,
        leftward: bool,
        width: usize,
        ink: &[u8],
        em: f64,
        baseline: f64,
        left: f64,
        advance: f64,
    ) -> bool {
        self.letters.learn(run, leftward, Drawing { width, ink, em, baseline, left, advance })
    }

    /// Returns the characters of a text without a glyph in the font with this id, each once.
    #[must_use]
    pub fn missing(&self, text: &str, font: &str) -> String {
        self.letters.font(font).map(|font| self.letters.missing(text, font)).into_iter().flatten().collect()
    }
}

impl Lettering {
    pub(crate) fn letters(&self) -> &Letters {
        &self.letters
    }
}
