//! A style in the designer. The picture after every block is stored, so that a change runs only the changed
//! block and later ones. The pixels equal the result of [`stylize`](super::stylize).

use super::blocks::Kernel;
use super::chain::{is_second_half, lay_ink, run_last};
use super::context::Context;
use super::file::{Step, Style};
use super::part;
use crate::error::Result;
use crate::raster::resize::{Region, resample_image};
use crate::raster::{Image, Plane};

/// One of the two layers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layer {
    /// The colour layer.
    Background = 0,
    /// The line layer.
    Foreground = 1,
}

const LAYERS: [Layer; 2] = [Layer::Background, Layer::Foreground];

/// A photo and, per layer, the pictures after the blocks that were run.
pub struct Stages {
    photo: Image,
    subject: Option<Plane>,
    style: Option<Style>,
    lanes: [Vec<Stage>; 2],
}

/// The result of one block.
struct Stage {
    step: Step,
    /// Whether U and V were stored for a later To Color.
    chroma: bool,
    /// None for a block that is bypassed: the picture is the one before.
    picture: Option<Image>,
}

impl Stages {
    /// Returns stages without results. A gray photo becomes R, G, B, as every chain begins with colour.
    /// `subject` is the subject mask at the size of the photo, if it is known.
    #[must_use]
    pub fn new(photo: Image, subject: Option<Plane>) -> Self {
        let photo = match photo.planes() {
            // Three planes of one size always form an image. The fallback to the photo is never used.
            [y] => Image::from_rgb([y.clone(), y.clone(), y.clone()]).unwrap_or(photo),
            _ => photo,
        };
        Self { photo, subject, style: None, lanes: [Vec::new(), Vec::new()] }
    }

    /// Takes a style and forgets the pictures that it changes.
    pub fn set(&mut self, style: Style) {
        for layer in LAYERS {
            let steps = steps_of(&style, layer);
            let lane = &mut self.lanes[layer as usize];
            let same = lane.iter().enumerate().take_while(|(i, stage)| {
                steps.get(*i).is_some_and(|step| {
                    same_step(step, &stage.step) && (stage.chroma || !chroma_wanted(steps, *i))
                })
            });
            let same = same.count();
            lane.truncate(same);
        }
        self.style = Some(style);
    }

    /// Runs the first block without a picture and returns its position, or `None` if every block has one.
    ///
    /// # Errors
    /// `cancelled` if the caller cancels.
    pub fn advance(&mut self, context: &mut Context<'_>) -> Result<Option<(Layer, usize)>> {
        let Some(style) = &self.style else { return Ok(None) };
        for layer in LAYERS {
            let steps = steps_of(style, layer);
            let done = self.lanes[layer as usize].len();
            let Some(step) = steps.get(done) else { continue };
            context.check_cancelled()?;
            context.fit_scale(&self.photo);
            let chroma = chroma_wanted(steps, done);
            let picture = if step.bypass {
                None
            } else {
                // Point operations run as one pass, whose tables round once. So the same pass gives the same
                // pixels.
                let first = if is_point(step) { run_start(steps, done) } else { done };
                let before = self.before(layer, first).clone();
                let active: Vec<&Step> = steps[..=done].iter().filter(|step| !step.bypass).collect();
                let start = is_second_half(&active).then(|| {
                    let first_half = steps[..done].iter().rposition(|step| !step.bypass);
                    self.before(layer, first_half.unwrap_or(done)).clone()
                });
                context.show_subject(step.part.and_then(|_| self.subject.clone()));
                let picture = run_last(&steps[first..=done], chroma, start, before, context);
                context.show_subject(None);
                Some(picture?)
            };
            self.lanes[layer as usize].push(Stage { step: step.clone(), chroma, picture });
            return Ok(Some((layer, done)));
        }
        Ok(None)
    }

    /// The picture after block `index` of a layer; the one before it where that block is not run yet.
    #[must_use]
    pub fn picture(&self, layer: Layer, index: usize) -> &Image {
        self.before(layer, index + 1)
    }

    /// Both layers together, as large as the photo, from the blocks that were run.
    #[must_use]
    pub fn result(&self) -> Image {
        let whole = |layer: Layer| {
            let image = self.before(layer, usize::MAX);
            if (image.width(), image.height()) == (self.photo.width(), self.photo.height()) {
                return image.clone();
            }
            let region = Region::whole(image.width(), image.height());
            resample_image(image, region, self.photo.width(), self.photo.height())
        };
        let mut background = whole(Layer::Background);
        let Some(style) = &self.style else { return background };
        let mut context = Context::default();
        context.show_subject(self.subject.clone());
        if let Some(part) = style.parts.background {
            background = part::mixed(self.photo.clone(), background, part, &context);
        }
        if style.foreground.is_none() {
            return background;
        }
        let mut lines = whole(Layer::Foreground);
        if let Some(part) = style.parts.foreground {
            lines = part::lines_in(&lines, part, &context);
        }
        lay_ink(background, &lines, style.ink)
    }

    fn before(&self, layer: Layer, index: usize) -> &Image {
        let lane = &self.lanes[layer as usize];
        let run = &lane[..index.min(lane.len())];
        run.iter().rev().find_map(|stage| stage.picture.as_ref()).unwrap_or(&self.photo)
    }
}

fn steps_of(style: &Style, layer: Layer) -> &[Step] {
    match layer {
        Layer::Background => &style.background,
        Layer::Foreground => style.foreground.as_deref().unwrap_or_default(),
    }
}

fn same_step(a: &Step, b: &Step) -> bool {
    let bits = |step: &Step| step.values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
    a.block.id == b.block.id
        && a.bypass == b.bypass
        && a.part == b.part
        && bits(a) == bits(b)
        && a.texture == b.texture
        && a.model == b.model
}

fn is_point(step: &Step) -> bool {
    step.part.is_none() && matches!(step.block.kernel, Kernel::Point(_))
}

/// Returns the start of the pass of point operations that ends at `index`.
fn run_start(steps: &[Step], index: usize) -> usize {
    let behind = steps[..index].iter().rev().take_while(|step| step.bypass || is_point(step));
    index - behind.count()
}

fn chroma_wanted(steps: &[Step], index: usize) -> bool {
    steps[index + 1..].iter().any(|step| !step.bypass && step.block.restores_color)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{catalogue, procedural, stylize};

    fn photo() -> Image {
        Image::from_rgb([3, 5, 7].map(|k| Plane::from_fn(64, 48, |x, y| ((x * k) ^ (y * 4)) as u8))).unwrap()
    }

    fn run(stages: &mut Stages, style: &Style) -> usize {
        let mut context = Context::default();
        stages.set(style.clone());
        std::iter::from_fn(|| stages.advance(&mut context).unwrap()).count()
    }

    fn parse(json: &str) -> Style {
        Style::parse("test.json", json).unwrap()
    }

    #[test]
    fn the_pixels_are_those_of_the_chain_that_runs_at_once() {
        let photo = photo();
        let invented = (0..60).map(procedural::invent);
        for style in catalogue::catalogue().iter().cloned().chain(invented) {
            let mut stages = Stages::new(photo.clone(), None);
            run(&mut stages, &style);
            let whole = stylize(&photo, &style, &mut Context::for_image(&photo)).unwrap();
            assert!(stages.result().to_rgba() == whole.to_rgba(), "{}", style.id);
        }
    }

    #[test]
    fn only_the_changed_block_and_those_behind_it_run_again() {
        let style = |levels: u32, sigma: f32| {
            parse(&format!(
                r#"{{"background":[{{"block":"gaussian"}},{{"block":"posterize","levels":{levels}}},{{"block":"saturation"}}],
                "foreground":[{{"block":"to_gray"}},{{"block":"xdog","sigma":{sigma}}}]}}"#
            ))
        };
        let mut stages = Stages::new(photo(), None);
        assert_eq!(run(&mut stages, &style(4, 1.0)), 5);
        assert_eq!(run(&mut stages, &style(4, 1.0)), 0);
        assert_eq!(run(&mut stages, &style(6, 1.0)), 2);
        assert_eq!(run(&mut stages, &style(6, 2.0)), 1);
        let photo = photo();
        let whole = stylize(&photo, &style(6, 2.0), &mut Context::for_image(&photo)).unwrap();
        assert!(stages.result().to_rgba() == whole.to_rgba());
    }

    #[test]
    fn a_to_color_that_is_added_gets_its_colours_back() {
        let gray = parse(r#"{"background":[{"block":"to_gray"},{"block":"luma_posterize"}]}"#);
        let both = r#"{"background":[{"block":"to_gray"},{"block":"luma_posterize"},{"block":"to_color"}]}"#;
        let mut stages = Stages::new(photo(), None);
        run(&mut stages, &gray);
        assert_eq!(run(&mut stages, &parse(both)), 3);
        assert!(!stages.result().is_luma());
        let whole = stylize(&photo(), &parse(both), &mut Context::for_image(&photo())).unwrap();
        assert!(stages.result().to_rgba() == whole.to_rgba());
    }

    #[test]
    fn a_bypassed_block_shows_the_picture_before_it() {
        let json = r#"{"background":[{"block":"posterize"},{"block":"sobel","bypass":true}]}"#;
        let mut stages = Stages::new(photo(), None);
        run(&mut stages, &parse(json));
        assert!(stages.picture(Layer::Background, 1) == stages.picture(Layer::Background, 0));
        assert!(stages.picture(Layer::Background, 0) != &photo());
    }
}
