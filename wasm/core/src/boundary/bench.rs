//! Benchmark functions: repeat blocks or a complete style on loaded planes, without decoding and copies
//! between JavaScript and wasm.

use super::style_of;
use inkpanel_engine::error::Result;
use inkpanel_engine::framing::{EnergyMap, Facts, lettering};
use inkpanel_engine::page::import::SMALL_SIDE;
use inkpanel_engine::page::{Document, Scene, mask};
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::resize::{Region, fit, resample_image};
use inkpanel_engine::style::painters::Painters;
use inkpanel_engine::style::{Context, Style, chain, stylize};
use std::sync::Arc;
use wasm_bindgen::prelude::*;

/// Measures a photo for framing, reduced to the working size.
#[wasm_bindgen(js_name = benchFacts)]
pub fn bench_facts(width: usize, height: usize, rgba: &[u8]) -> Result<usize> {
    let image = Image::from_rgba(width, height, rgba, [255; 3])?;
    let (wide, high) = fit(width, height, SMALL_SIDE);
    let small = resample_image(&image, Region::whole(width, height), wide, high);
    let energy = EnergyMap::of(&small);
    Ok(energy.values().len() + Facts::of(&small).spread().0 as usize + lettering(&small).len())
}

/// One style, one image, and the scratch memory of a worker.
#[wasm_bindgen]
pub struct Bench {
    style: Style,
    /// Blocks of the background that were run beforehand.
    done: usize,
    picture: Image,
    next: Option<Image>,
    context: Context<'static>,
}

#[wasm_bindgen]
impl Bench {
    /// Takes a style file and RGBA pixels, and runs the first `done` blocks of the background. Throws the
    /// errors of a style or a size.
    #[wasm_bindgen(constructor)]
    pub fn new(style: &str, done: usize, width: usize, height: usize, rgba: &[u8]) -> Result<Bench> {
        let style = style_of(style)?;
        let done = done.min(style.background.len());
        let picture = Image::from_rgba(width, height, rgba, [255; 3])?;
        let mut context = Context::for_image(&picture);
        let picture = chain::run_until(&style.background, done, picture, &mut context)?;
        Ok(Bench { style, done, picture, next: None, context })
    }

    /// Sets the model of the block Painter. Throws `invalid-painters`.
    pub fn know_painters(&mut self, onnx: &[u8]) -> Result<()> {
        let painters = Painters::new(onnx)?;
        self.context.show_painters(Some(Arc::new(painters)));
        Ok(())
    }

    /// Copies the image for the next [`Bench::run`], which changes it in place.
    pub fn prepare(&mut self) {
        self.next = Some(self.picture.clone());
    }

    /// Runs the other blocks of the background once on the copy. Does nothing without a copy.
    pub fn run(&mut self) -> Result<()> {
        let Some(picture) = self.next.take() else { return Ok(()) };
        let steps = &self.style.background[self.done..];
        chain::run_owned(steps, picture, &mut self.context).map(drop)
    }

    /// Runs the whole style once, both layers and its own copies.
    pub fn run_style(&mut self) -> Result<()> {
        stylize(&self.picture, &self.style, &mut self.context).map(drop)
    }
}

/// A page whose masks and borders are drawn again and again.
#[wasm_bindgen]
pub struct BenchPage {
    scene: Scene,
}

#[wasm_bindgen]
impl BenchPage {
    /// Takes a document and the width of its page in pixels. Throws the errors of a document.
    #[wasm_bindgen(constructor)]
    pub fn new(document: &str, width: usize) -> Result<BenchPage> {
        Ok(BenchPage { scene: Scene::new(&Document::parse(document)?, width)? })
    }

    /// Draws the inside, the border and the outline of every panel, like
    /// [`render_panel`](inkpanel_engine::page::compose). Returns the number of pixels.
    #[must_use]
    pub fn draw_masks(&self) -> usize {
        let Scene { corner_radius, border, ref panels, .. } = self.scene;
        let drawn = panels.iter().map(|panel| {
            let mut pixels = mask::inside(&panel.shape, corner_radius, panel.area).len();
            for line in [2.0 * panel.halo, border].into_iter().filter(|&width| width >= 0.05) {
                pixels += mask::border(&panel.shape, corner_radius, line, panel.area).len();
            }
            pixels
        });
        drawn.sum()
    }
}
