//! A document resolved to pixels of one size: the input of the renderer.

use super::bleed;
use super::document::Document;
use super::rect::PixelRect;
use crate::error::{Error, Result};
use crate::framing::Crop;
use crate::layout::{self, Bounds, COARSE, Point, ResolvedPanel, ResolvedShape, Template};
use crate::raster::Matte;
use crate::style::Style;
use crate::style::context::scale_of;
use std::borrow::Cow;

/// Longest page side that is rendered, in pixels: A3 at 600 dpi and a tall strip fit.
pub(super) const MAX_SIDE: f64 = 20_000.0;

/// The default crop of a panel.
const WHOLE: Crop = Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };

/// A page at one size.
pub struct Scene {
    /// Width of the page in pixels.
    pub width: usize,
    /// Height of the page in pixels.
    pub height: usize,
    /// Panels in paint order. Panels with a breakout follow a second time, with only the subject.
    pub panels: Vec<ScenePanel>,
    /// Panels whose subject is drawn separately, in front of an effect; see [`Document::fronts`]. They are
    /// numbered on from `panels`.
    pub fronts: Vec<ScenePanel>,
    /// The style of all panels.
    pub style: Cow<'static, Style>,
    /// Scale of spatial parameters, from the page's average panel. Lines are equally wide on all panels, and
    /// proportional in thumbnail, preview and print.
    pub scale: f32,
    /// Colour of the paper.
    pub paper: [u8; 3],
    /// Colour of the borders.
    pub border_color: [u8; 3],
    /// Width of the borders in pixels.
    pub border: f64,
    /// Radius of rounded corners in pixels.
    pub corner_radius: f64,
    /// Photo pixels per page pixel below which a photo is upscaled with edge enhancement; 0 for never.
    pub enlarge_below: f64,
    /// Whether the photos get one white point.
    pub balanced: bool,
    /// Whether borders are drawn on panels. A PDF file draws them as vectors.
    pub bordered: bool,
}

/// The content of a panel image.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Shows {
    /// The panel, clipped to its shape.
    Panel,
    /// Its breakout.
    Figure,
    /// Its subject, before an effect.
    Front,
}

/// One image of a panel, in pixels.
#[derive(Clone)]
pub struct ScenePanel {
    /// Which panel of the document it belongs to.
    pub number: usize,
    /// The drawn part.
    pub shows: Shows,
    /// Its shape in page pixels.
    pub shape: ResolvedShape,
    /// Bounds of the shown image: of the panel, or of its merged group.
    pub image_bounds: Bounds,
    /// Width in pixels of the paper-coloured outline.
    pub halo: f64,
    /// Pixels that its image and border touch.
    pub area: PixelRect,
    /// Id of the photo; `None` for an empty panel.
    pub photo: Option<String>,
    /// The crop that fills `image_bounds`. It extends past the photo if the page has bleed and the photo
    /// ends.
    pub crop: Crop,
    /// Faces of the photo, in fractions of its sides.
    pub faces: Vec<Crop>,
    /// Subject mask of the photo, if it is known and the style or a foreground needs it.
    pub subject: Option<Matte>,
    /// The subject for a panel breakout, and the areas that it must not cover.
    pub figure: Option<(Matte, Around)>,
    /// Whether a gray photo gets a warm tone.
    pub toned: bool,
    /// Whether the photo has no style and no border.
    pub plain: bool,
}

/// Areas that a subject must not cover, in pixels of the page.
#[derive(Clone)]
pub struct Around {
    /// The area inside the page margin.
    pub room: Bounds,
    /// Faces that other panels show.
    pub faces: Vec<Bounds>,
    /// Width of the panels' borders.
    pub border: f64,
    /// Whether another panel may cover this one. Then the whole subject is drawn again above it.
    pub covered: bool,
}

impl Scene {
    /// Resolves a document at a page width in pixels.
    ///
    /// # Errors
    /// `unknown-layout`, `unknown-style` and their `invalid-` kin; `invalid-document` when the page would be
    /// larger than 20,000 pixels or the panels do not fit the layout.
    pub fn new(document: &Document, width: usize) -> Result<Self> {
        let page = &document.page;
        let template = document.template()?;
        let (width, height) = size(document, width)?;
        let mut panels = panels(document, &template, (width, height))?;
        let figures = figures(document, &mut panels, (width, height));
        panels.extend(figures);
        let fronts = fronts(document, &panels);
        // A picture without a style does not affect how the others are drawn.
        let plain = document.panels.iter().filter(|panel| panel.plain).count();
        let base = template.base_count().saturating_sub(plain).max(1);
        Ok(Self {
            width,
            height,
            panels,
            fronts,
            style: document.style()?,
            scale: scale_of((width * height) as f64 / base as f64),
            paper: page.paper_rgb(),
            border_color: page.border_rgb(),
            border: page.border * width as f64,
            corner_radius: page.corner_radius * width as f64,
            enlarge_below: if page.enlarge {
                let dpi = f64::from(page.dpi) * width as f64 / f64::from(page.width.max(1));
                (COARSE / dpi).min(1.0)
            } else {
                0.0
            },
            balanced: document.balanced,
            bordered: true,
        })
    }
}

impl Scene {
    /// Sets the subject masks of photos by id, if the style has a part for only the subject or background, or
    /// an effect is behind a subject.
    pub fn show_subjects(&mut self, subject: &dyn Fn(&str) -> Option<Matte>) {
        let panels: &mut [ScenePanel] = if self.style.has_parts() { &mut self.panels } else { &mut [] };
        for panel in panels.iter_mut().chain(&mut self.fronts).filter(|panel| !panel.plain) {
            panel.subject = panel.photo.as_deref().and_then(subject);
        }
    }

    /// Image indices of each panel: the panel, its breakout, its foreground.
    #[must_use]
    pub fn by_panel(&self) -> Vec<Vec<usize>> {
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for (index, picture) in self.panels.iter().chain(&self.fronts).enumerate() {
            match groups.get_mut(picture.number) {
                Some(group) => group.push(index),
                None => groups.push(vec![index]),
            }
        }
        groups
    }

    /// A panel, breakout or foreground by its index.
    ///
    /// # Errors
    /// `invalid-document` for a number that the page does not have.
    pub fn picture(&self, index: usize) -> Result<&ScenePanel> {
        let picture = self.panels.get(index).or_else(|| self.fronts.get(index - self.panels.len()));
        picture.ok_or_else(|| invalid(&format!("panels[{index}]"), "there is no such panel".into()))
    }
}

/// Width and height in pixels of a page at a width.
///
/// # Errors
/// `invalid-document` when it would be larger than 20,000 pixels.
pub(super) fn size(document: &Document, width: usize) -> Result<(usize, usize)> {
    let page = &document.page;
    let height = (width as f64 * f64::from(page.height) / f64::from(page.width)).round().max(1.0);
    if width == 0 || width as f64 > MAX_SIDE || height > MAX_SIDE {
        return Err(invalid("page", format!("cannot be rendered at {width} x {height} pixels")));
    }
    Ok((width, height as usize))
}

/// The panels of a page of a size in pixels, in paint order.
///
/// # Errors
/// `invalid-document` when the document's panels do not fit the layout.
pub(super) fn panels(
    document: &Document,
    template: &Template,
    (width, height): (usize, usize),
) -> Result<Vec<ScenePanel>> {
    let page = &document.page;
    let pixels = width as f64;
    let resolved = layout::resolve(template, pixels / height as f64, page);
    if resolved.len() != document.panels.len() {
        let (has, wants) = (document.panels.len(), resolved.len());
        return Err(invalid("panels", format!("has {has} entries, the layout has {wants} panels")));
    }
    let bounds: Vec<Bounds> = resolved.iter().map(|panel| scaled_bounds(panel.bounds, pixels)).collect();
    let further = further_shapes(document, &resolved, (pixels, height as f64));
    // Including the bleed, if any.
    let reached: Vec<Bounds> = further
        .iter()
        .zip(&bounds)
        .map(|(shape, own)| match shape {
            Some(ResolvedShape::Polygon(points)) => Bounds::of(points),
            _ => *own,
        })
        .collect();
    let panel = |((i, panel), further): ((usize, ResolvedPanel), Option<ResolvedShape>)| {
        let content = &document.panels[i];
        let leader = document.merge_of(i).and_then(|group| group.first().copied()).unwrap_or(i);
        let halo = panel.halo * pixels;
        let image = |bounds: &[Bounds]| document.merge_of(i).map_or(bounds[i], |group| union(group, bounds));
        let (image_bounds, shown) = (image(&reached), image(&bounds));
        let crop = document.panels[leader].crop.or(content.crop).unwrap_or(WHOLE);
        ScenePanel {
            number: i,
            shows: Shows::Panel,
            shape: further.unwrap_or_else(|| scaled_shape(panel.shape, pixels)),
            image_bounds,
            halo,
            area: PixelRect::around(reached[i], halo.max(page.border * pixels / 2.0) + 1.0),
            photo: document.panels[leader].photo.clone(),
            crop: if image_bounds == shown { crop } else { bleed::widened(crop, shown, image_bounds) },
            faces: document.panels[leader].faces.clone(),
            subject: None,
            figure: None,
            toned: document.panels[leader].toned,
            plain: document.panels[leader].plain,
        }
    };
    Ok(resolved.into_iter().enumerate().zip(further).map(panel).collect())
}

/// The panel breakouts in panel order. They are also stored in their panels. Merged panels cannot break out.
fn figures(document: &Document, panels: &mut [ScenePanel], size: (usize, usize)) -> Vec<ScenePanel> {
    let broken: Vec<usize> = (0..panels.len()).filter(|&i| document.breaks_frame(i)).collect();
    if broken.is_empty() {
        return Vec::new();
    }
    let around = around(document, panels, size);
    let figure = |i: usize| {
        let matte = document.panels[i].figure.clone()?;
        panels[i].figure = Some((matte, around[i].clone()));
        Some(ScenePanel { shows: Shows::Figure, ..panels[i].clone() })
    };
    broken.into_iter().filter_map(figure).collect()
}

/// Returns the areas that the subject of each panel must not cover. `size` is the page size in pixels.
pub(super) fn around(document: &Document, panels: &[ScenePanel], size: (usize, usize)) -> Vec<Around> {
    let (width, height) = (size.0 as f64, size.1 as f64);
    let margin = document.page.margin * width;
    let room = Bounds {
        x: margin,
        y: margin,
        width: (width - 2.0 * margin).max(0.0),
        height: (height - 2.0 * margin).max(0.0),
    };
    let faces: Vec<Vec<Bounds>> = panels.iter().map(shown_faces).collect();
    let others = |own: usize| {
        let others = faces.iter().enumerate().filter(|(other, _)| *other != own);
        others.flat_map(|(_, faces)| faces.iter().copied()).collect()
    };
    let border = document.page.border * width;
    let covered = |own: usize| panels[own + 1..].iter().any(|over| meet(over, &panels[own]));
    (0..panels.len()).map(|own| Around { room, faces: others(own), border, covered: covered(own) }).collect()
}

/// Returns whether the pictures of two panels overlap.
fn meet(one: &ScenePanel, other: &ScenePanel) -> bool {
    let (a, b) = (one.image_bounds, other.image_bounds);
    a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height
}

/// The faces that a panel shows, in pixels of the page.
fn shown_faces(panel: &ScenePanel) -> Vec<Bounds> {
    let (crop, bounds) = (panel.crop, panel.image_bounds);
    let place = |at: f64, start: f64, length: f64, from: f64, side: f64| from + (at - start) / length * side;
    let face = |face: &Crop| {
        let x = place(face.x, crop.x, crop.width, bounds.x, bounds.width);
        let y = place(face.y, crop.y, crop.height, bounds.y, bounds.height);
        let (width, height) =
            (face.width / crop.width * bounds.width, face.height / crop.height * bounds.height);
        Bounds { x, y, width, height }
    };
    let seen = |face: &Bounds| {
        let apart = |at: f64, length: f64, from: f64, side: f64| at + length <= from || at >= from + side;
        !apart(face.x, face.width, bounds.x, bounds.width)
            && !apart(face.y, face.height, bounds.y, bounds.height)
    };
    panel.faces.iter().map(face).filter(seen).collect()
}

/// The panels whose subjects are in front of an effect.
fn fronts(document: &Document, panels: &[ScenePanel]) -> Vec<ScenePanel> {
    let front = |i: usize| ScenePanel { shows: Shows::Front, ..panels[i].clone() };
    document.fronts().into_iter().map(front).collect()
}

/// Returns the shapes of panels that extend into the bleed.
fn further_shapes(
    document: &Document,
    panels: &[ResolvedPanel],
    (width, height): (f64, f64),
) -> Vec<Option<ResolvedShape>> {
    let by = document.page.bleed * width;
    let further = |panel: &ResolvedPanel| {
        (by > 0.0)
            .then(|| bleed::extended(&scaled_shape(panel.shape.clone(), width), (width, height), by))
            .flatten()
    };
    panels.iter().map(further).collect()
}

fn invalid(location: &str, reason: String) -> Error {
    Error::InvalidDocument { location: location.to_owned(), reason }
}

fn union(group: &[usize], bounds: &[Bounds]) -> Bounds {
    group.iter().filter_map(|&i| bounds.get(i).copied()).reduce(Bounds::union).unwrap_or(bounds[0])
}

fn scaled_bounds(bounds: Bounds, by: f64) -> Bounds {
    Bounds { x: bounds.x * by, y: bounds.y * by, width: bounds.width * by, height: bounds.height * by }
}

fn scaled_shape(shape: ResolvedShape, by: f64) -> ResolvedShape {
    let point = |p: Point| Point::new(p.x * by, p.y * by);
    match shape {
        ResolvedShape::Polygon(points) => ResolvedShape::Polygon(points.into_iter().map(point).collect()),
        ResolvedShape::Circle { center, radius } => {
            ResolvedShape::Circle { center: point(center), radius: radius * by }
        }
    }
}
