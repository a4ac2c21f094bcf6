//! wasm bindings of the mask editor, loaded when the user corrects a mask. The module stores the edited mask
//! and draws it over its photo.

// Every function that returns a Result throws as the module's documentation says.
#![allow(clippy::missing_errors_doc)]
// The macro for enums compares JavaScript numbers with its values.
#![allow(clippy::float_cmp)]

use inkpanel_engine::error::Result;
use inkpanel_engine::raster::retouch::{Mending, Session, View};
use inkpanel_engine::raster::{Image, Matte};
use wasm_bindgen::prelude::*;

#[wasm_bindgen(start)]
fn start() {
    console_error_panic_hook::set_once();
}

/// A correction of the whole mask.
#[wasm_bindgen]
#[derive(Clone, Copy)]
pub enum Mend {
    /// Grows the mask.
    Grow,
    /// Shrinks the mask.
    Shrink,
    /// Softens the border, while the mask has a visible border.
    Feather,
    /// Inverts the mask.
    Invert,
    /// All that was found, or all of the photo.
    Everything,
    /// Empties the mask.
    Nothing,
    /// The detected mask.
    Found,
    /// The next subject, if the mask has several.
    NextFigure,
}

/// The mask of a photo while it is corrected.
#[wasm_bindgen]
pub struct Retouch {
    session: Session,
    view: View,
}

#[wasm_bindgen]
impl Retouch {
    /// `planes` are the photo's red, green and blue samples, one plane after the other. `own` is the
    /// corrected mask and `found` the detected mask, both as text. Invalid text is ignored.
    #[wasm_bindgen(constructor)]
    pub fn new(
        width: usize,
        height: usize,
        planes: &[u8],
        own: Option<String>,
        found: Option<String>,
    ) -> Result<Retouch> {
        let photo = Image::from_rgb_planes(width, height, planes)?;
        let [own, found] = [own, found].map(|text| text.and_then(|text| Matte::try_from(text).ok()));
        let session = Session::new((width, height), own.as_ref(), found.as_ref());
        Ok(Self { session, view: View::new(&photo) })
    }

    /// Width of the view in pixels.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> usize {
        self.view.size().0
    }

    /// Its height.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> usize {
        self.view.size().1
    }

    /// The view as RGBA. `fine` uses the edges of the photo.
    #[must_use]
    pub fn draw(&mut self, fine: bool) -> Vec<u8> {
        self.view.draw(self.session.mask(), fine).to_vec()
    }

    /// Paints along a path of x and y in parts of the photo, one after the other; the radius is in photo widths.
    pub fn paint(&mut self, path: &[f32], radius: f32, adds: bool) {
        let path: Vec<[f32; 2]> = path.chunks_exact(2).map(|at| [at[0], at[1]]).collect();
        self.session.paint(&path, radius, adds);
    }

    /// Ends a stroke; whether anything changed.
    pub fn end(&mut self) -> bool {
        self.session.end()
    }

    /// Discards the current stroke.
    pub fn abandon(&mut self) {
        self.session.abandon();
    }

    /// Applies a correction to the whole mask. Returns whether anything changed.
    pub fn mend(&mut self, how: Mend) -> bool {
        self.session.mend(match how {
            Mend::Grow => Mending::Grow,
            Mend::Shrink => Mending::Shrink,
            Mend::Feather => Mending::Feather,
            Mend::Invert => Mending::Invert,
            Mend::Everything => Mending::Everything,
            Mend::Nothing => Mending::Nothing,
            Mend::Found => Mending::Found,
            Mend::NextFigure => Mending::NextFigure,
        })
    }

    /// Selects only the subject at a point, in fractions of the photo. Returns whether anything changed.
    pub fn choose(&mut self, x: f32, y: f32) -> bool {
        self.session.mend(Mending::FigureAt([x, y]))
    }

    /// One step back; whether there was one.
    pub fn undo(&mut self) -> bool {
        self.session.undo()
    }

    /// Redoes one step. Returns whether there was one.
    pub fn redo(&mut self) -> bool {
        self.session.redo()
    }

    /// Whether undo is possible.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn undoable(&self) -> bool {
        self.session.can().0
    }

    /// Whether redo is possible.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn redoable(&self) -> bool {
        self.session.can().1
    }

    /// Whether the mask is the detected mask.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn found(&self) -> bool {
        self.session.is_found()
    }

    /// The part of the photo that is its subject, 0 to 1.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn coverage(&self) -> f64 {
        self.session.coverage()
    }

    /// The masks after each step up to the current one, as text. Empty text means the detected mask.
    #[must_use]
    pub fn steps(&self) -> Vec<String> {
        self.session
            .steps()
            .into_iter()
            .map(|mask| mask.map_or_else(String::new, |mask| mask.text().to_owned()))
            .collect()
    }
}
