//! Panels rendered to patches, patches laid on paper.
//!
//! A patch is a panel with its mask and its border as straight-alpha RGBA. All patches in order over the
//! paper colour give the page. The browser draws them on a canvas, [`Sheet`] does it for files.

use super::bleed;
use super::breaking::{self, Figure};
use super::mask;
use super::patch::{Drawing, Patch, Shown, fill_image, lay_over, lay_under};
use super::rect::PixelRect;
use super::scene::{Scene, ScenePanel, Shows};
use super::stepping;
use crate::error::{Error, Result};
use crate::framing::Crop;
use crate::layout::Bounds;
use crate::raster::Image;
use crate::raster::balance::{Balance, is_gray, toned};
use crate::raster::enlarge::enlarged;
use crate::raster::fill_light::FillLight;
use crate::raster::grain::without_grain;
use crate::raster::resize::{Region, resample_image};
use crate::style::faces::FaceBox;
use crate::style::part::subject_in;
use crate::style::{Context, stylize};

/// Renders one panel, breakout or foreground, like [`render_together`].
///
/// # Errors
/// `invalid-document` for an index that the page does not have; `cancelled`.
pub fn render_panel(
    scene: &Scene,
    index: usize,
    photo: Option<&Image>,
    context: &mut Context<'_>,
) -> Result<Patch> {
    Ok(render_together(scene, &[index], photo, context)?.swap_remove(0))
}

/// Renders the images of one panel: the panel, the breakout of its subject, its foreground. All are cut out
/// of one drawing of constant size, so their pixels are equal where they meet. `photo` is the photo of the
/// panel, at any resolution. Without it the panel is an empty frame.
///
/// # Errors
/// `invalid-document` for an index that the page does not have; `cancelled`.
pub fn render_together(
    scene: &Scene,
    pictures: &[usize],
    photo: Option<&Image>,
    context: &mut Context<'_>,
) -> Result<Vec<Patch>> {
    let pictures = pictures.iter().map(|index| scene.picture(*index)).collect::<Result<Vec<_>>>()?;
    let Some(&panel) = pictures.first() else { return Ok(Vec::new()) };
    debug_assert!(pictures.iter().all(|picture| picture.number == panel.number));
    context.check_cancelled()?;
    let figure = photo.and(panel.figure.as_ref());
    let figure = figure.and_then(|(matte, around)| breaking::figure(panel, matte.plane(), around));
    // Empty images are not drawn.
    let sees = |picture: &ScenePanel| match picture.shows {
        Shows::Panel => true,
        Shows::Front if figure.is_none() => picture.subject.as_ref().is_some_and(|it| !it.facts().is_vague()),
        _ => figure.is_some(),
    };
    let drawing = match photo.filter(|_| pictures.iter().any(|picture| sees(picture))) {
        Some(photo) => Some(Drawing::new(scene, &pictures, (photo, figure.as_ref()), context)?),
        None => None,
    };
    let patch = |picture: &&ScenePanel| match (&drawing, picture.shows) {
        (None, Shows::Panel) => framed(scene, panel, None),
        (Some(Drawing { image, shown, .. }), Shows::Panel) => framed(scene, panel, Some((image, shown.at))),
        (Some(drawing), shows) if sees(picture) => match &figure {
            Some(figure) => {
                let covered = panel.figure.as_ref().is_some_and(|(_, around)| around.covered);
                stepping::patch(scene, (panel, figure), drawing, covered || shows == Shows::Front)
            }
            None => front(scene, panel, drawing),
        },
        _ => Patch::nothing(panel.area),
    };
    Ok(pictures.iter().map(patch).collect())
}

impl Drawing {
    fn new(
        scene: &Scene,
        pictures: &[&ScenePanel],
        (photo, figure): (&Image, Option<&Figure>),
        context: &mut Context<'_>,
    ) -> Result<Self> {
        let mut panel = match figure {
            Some(figure) => stepping::widened(scene, pictures[0], figure),
            None => pictures[0].clone(),
        };
        // Only a foreground needs the mask for every style.
        panel.subject = pictures.iter().find_map(|picture| picture.subject.clone());
        context.set_scale(scene.scale);
        let shown = panel_photo(scene, &panel, photo);
        let image = drawn(&shown, (&panel, photo), scene, context)?;
        Ok(Self { shown, image, photo: (photo.width(), photo.height()) })
    }
}

/// The panel in its shape, with its border; without a picture an empty frame.
fn framed(scene: &Scene, panel: &ScenePanel, picture: Option<(&Image, PixelRect)>) -> Patch {
    let area = panel.area;
    let mut rgba = vec![0; area.width * area.height * 4];
    match picture {
        Some((image, at)) => fill_image(&mut rgba, area, image, at),
        None => rgba.chunks_exact_mut(4).for_each(|pixel| pixel[..3].copy_from_slice(&EMPTY)),
    }
    let inside = mask::inside(&panel.shape, scene.corner_radius, area);
    for (pixel, &coverage) in rgba.chunks_exact_mut(4).zip(&inside) {
        pixel[3] = coverage;
    }
    if panel.halo >= 0.05 {
        let ring = mask::border(&panel.shape, scene.corner_radius, 2.0 * panel.halo, area);
        lay_under(&mut rgba, &ring, scene.paper);
    }
    if let Some(line) = line(scene, panel).filter(|_| scene.bordered && !panel.plain) {
        lay_over(&mut rgba, &line, scene.border_color);
    }
    Patch { area, rgba }
}

/// Coverage mask of the panel border, or `None` without borders.
fn line(scene: &Scene, panel: &ScenePanel) -> Option<Vec<u8>> {
    let drawn = scene.border >= 0.05;
    drawn.then(|| mask::border(&panel.shape, scene.corner_radius, scene.border, panel.area))
}

/// The isolated subject of a panel, as the panel shows it. Transparent if it is unknown. Its border is left
/// out.
fn front(scene: &Scene, panel: &ScenePanel, Drawing { shown, image, .. }: &Drawing) -> Patch {
    let Some(subject) = &shown.subject else { return Patch::nothing(panel.area) };
    let area = panel.area;
    let mut rgba = vec![0; area.width * area.height * 4];
    // Pixels outside of the photo are outside of the subject. Only the alpha of this patch is used.
    let mut shares = rgba.clone();
    fill_image(&mut shares, area, &Image::from_luma(subject.clone()), shown.at);
    fill_image(&mut rgba, area, image, shown.at);
    let inside = mask::inside(&panel.shape, scene.corner_radius, area);
    let line = line(scene, panel);
    for (i, pixel) in rgba.chunks_exact_mut(4).enumerate() {
        let line = line.as_ref().map_or(0, |line| u32::from(line[i]));
        let seen = u32::from(inside[i]) * (255 - line) / 255;
        pixel[3] = (u32::from(shares[4 * i]) * seen / 255) as u8;
    }
    Patch { area, rgba }
}

/// Blends two images of equal size; `share` is the weight of `over` in 256ths.
pub fn mix(under: &mut [u8], over: &[u8], share: u32) {
    for (under, over) in under.iter_mut().zip(over) {
        *under = ((u32::from(*under) * (256 - share) + u32::from(*over) * share + 128) >> 8) as u8;
    }
}

/// Photo pixels per pixel of a style at which grain begins to be removed, and at which it is removed completely.
const GRAIN: (f64, f64) = (0.5, 0.3);
/// Pixels around the shown part of a photo that its filter and its enlargement use.
const GRAIN_ROOM: usize = 8;

/// Gray of a panel that has no photo yet.
pub(super) const EMPTY: [u8; 3] = [226, 226, 228];

fn panel_photo(scene: &Scene, panel: &ScenePanel, photo: &Image) -> Shown {
    let at = PixelRect::around(panel.image_bounds, 0.0);
    let Bounds { x, y, width, height } = panel.image_bounds;
    let (photo_width, photo_height) = (photo.width() as f64, photo.height() as f64);
    // If the photo ends before the bleed does, its mirror image continues.
    let outside = |start: f64, length: f64, bounds: f64, from: f64, pixel: i64, count: usize| {
        if start >= 0.0 && start + length <= 1.0 {
            return (0, 0);
        }
        let step = length / bounds;
        bleed::beyond(start + (pixel as f64 - from) * step, step, count)
    };
    let crop = panel.crop;
    let (before, behind) = outside(crop.x, crop.width, width, x, at.x, at.width);
    let (above, below) = outside(crop.y, crop.height, height, y, at.y, at.height);
    let inner = PixelRect {
        x: at.x + before as i64,
        y: at.y + above as i64,
        width: at.width - before - behind,
        height: at.height - above - below,
    };
    // The crop belongs to the exact bounds. Whole pixels extend a little further on each side.
    let (step_x, step_y) = (crop.width * photo_width / width, crop.height * photo_height / height);
    let span = |start: f64, step: f64, from: f64, pixel: i64, count: usize, limit: f64| {
        let low = (start + (pixel as f64 - from) * step).clamp(0.0, limit - 1e-3);
        let high = (start + ((pixel + count as i64) as f64 - from) * step).clamp(low + 1e-3, limit);
        (low, high - low)
    };
    let (left, region_width) = span(crop.x * photo_width, step_x, x, inner.x, inner.width, photo_width);
    let (top, region_height) = span(crop.y * photo_height, step_y, y, inner.y, inner.height, photo_height);
    let region = Region { x: left, y: top, width: region_width, height: region_height };
    // Photo pixels per page pixel.
    let share = (region.width / inner.width as f64).min(region.height / inner.height as f64);
    let clean = (!panel.plain).then(|| cleaned(photo, region, share * f64::from(scene.scale))).flatten();
    let (source, part) = clean.as_ref().map_or((photo, region), |(clean, part)| (clean, *part));
    let mut image = if share < scene.enlarge_below && !panel.plain {
        enlarged(source, part, inner.width, inner.height)
    } else {
        resample_image(source, part, inner.width, inner.height)
    };
    if scene.balanced && !panel.plain {
        let faces: Vec<[f64; 4]> =
            panel.faces.iter().map(|face| [face.x, face.y, face.width, face.height]).collect();
        if let Some(balance) = Balance::of(photo, &faces) {
            balance.apply(&mut image);
        }
        if let Some(light) = FillLight::of(photo) {
            light.apply(&mut image);
        }
    }
    if panel.toned && !panel.plain && scene.style.keeps_colours() && is_gray(photo) {
        image = toned(image);
    }
    let size = (photo.width(), photo.height());
    let known = panel.subject.as_ref();
    let subject = known.and_then(|matte| subject_in(matte, region, size, (&image, scene.scale)));
    if inner == at {
        return Shown { image, subject, region, at };
    }
    let mirrored = |image: &Image| bleed::mirrored(image, (before, above), at);
    let subject = subject.map(|plane| mirrored(&Image::from_luma(plane)).into_parts().0.swap_remove(0));
    Shown { image: mirrored(&image), subject, region, at }
}

/// The part of a photo with less grain, and its region in that part. `None` for a photo with enough pixels. `share`: photo
/// pixels per pixel of a style, which does not depend on the size of the page.
fn cleaned(photo: &Image, region: Region, share: f64) -> Option<(Image, Region)> {
    let amount = ((GRAIN.0 - share) / (GRAIN.0 - GRAIN.1)).clamp(0.0, 1.0);
    if amount <= 0.0 {
        return None;
    }
    let span = |start: f64, length: f64, side: usize| {
        let from = (start.floor() as usize).saturating_sub(GRAIN_ROOM);
        (from as f64, (((start + length).ceil() as usize + GRAIN_ROOM).min(side) - from) as f64)
    };
    let (x, width) = span(region.x, region.width, photo.width());
    let (y, height) = span(region.y, region.height, photo.height());
    let part = resample_image(photo, Region { x, y, width, height }, width as usize, height as usize);
    Some((without_grain(&part, amount as f32), Region { x: region.x - x, y: region.y - y, ..region }))
}

/// The stylised image of a panel. A merged group is stylised as one image, so that tones match across the
/// gutter, and then cut.
fn drawn(
    shown: &Shown,
    (panel, photo): (&ScenePanel, &Image),
    scene: &Scene,
    context: &mut Context<'_>,
) -> Result<Image> {
    context.check_cancelled()?;
    if panel.plain {
        return Ok(shown.image.clone());
    }
    let size = (photo.width() as f64, photo.height() as f64);
    context.show_faces(faces_in(panel, size, shown.region, shown.at));
    // A style without parts is drawn as usual.
    context.show_subject(shown.subject.clone().filter(|_| scene.style.has_parts()));
    stylize(&shown.image, &scene.style, context)
}

/// The faces of a panel's photo in pixels of its image.
fn faces_in(panel: &ScenePanel, photo: (f64, f64), region: Region, at: PixelRect) -> Vec<FaceBox> {
    let (across, down) = (at.width as f64 / region.width, at.height as f64 / region.height);
    let face = |face: &Crop| FaceBox {
        x: (face.x * photo.0 - region.x) * across,
        y: (face.y * photo.1 - region.y) * down,
        width: face.width * photo.0 * across,
        height: face.height * photo.1 * down,
    };
    panel.faces.iter().map(face).collect()
}

/// The whole page as opaque RGB, for drawing patches on it.
pub struct Sheet {
    width: usize,
    height: usize,
    rgb: Vec<u8>,
}

impl Sheet {
    /// Empty paper.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        Self::blank(scene.width, scene.height, scene.paper)
    }

    /// Empty paper of a size and colour.
    #[must_use]
    pub fn blank(width: usize, height: usize, paper: [u8; 3]) -> Self {
        let mut rgb = vec![0; width * height * 3];
        rgb.chunks_exact_mut(3).for_each(|pixel| pixel.copy_from_slice(&paper));
        Self { width, height, rgb }
    }

    /// A sheet with the pixels `rgb`.
    #[must_use]
    pub fn of(width: usize, height: usize, rgb: Vec<u8>) -> Self {
        debug_assert_eq!(rgb.len(), width * height * 3);
        Self { width, height, rgb }
    }

    /// Draws a patch on the sheet. Pixels outside of the page are ignored.
    ///
    /// # Errors
    /// `buffer-size` when the patch does not hold the pixels of its area.
    pub fn lay(&mut self, area: PixelRect, rgba: &[u8]) -> Result<()> {
        let expected = area.width.saturating_mul(area.height).saturating_mul(4);
        if rgba.len() != expected {
            let (width, height) = (area.width, area.height);
            return Err(Error::BufferSize { width, height, expected, actual: rgba.len() });
        }
        let left = area.x.max(0);
        let right = (area.x + area.width as i64).min(self.width as i64);
        for y in area.y.max(0)..(area.y + area.height as i64).min(self.height as i64) {
            if right <= left {
                break;
            }
            let source = ((y - area.y) as usize * area.width + (left - area.x) as usize) * 4;
            let target = (y as usize * self.width + left as usize) * 3;
            let count = (right - left) as usize;
            lay_row(&mut self.rgb[target..target + count * 3], &rgba[source..source + count * 4]);
        }
        Ok(())
    }

    /// Width in pixels.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Height in pixels.
    #[must_use]
    pub fn height(&self) -> usize {
        self.height
    }

    /// Interleaved RGB.
    #[must_use]
    pub fn rgb(&self) -> &[u8] {
        &self.rgb
    }

    /// Returns the pixels without the sheet.
    #[must_use]
    pub fn into_rgb(self) -> Vec<u8> {
        self.rgb
    }

    /// Interleaved RGBA with an alpha of 255.
    #[must_use]
    pub fn to_rgba(&self) -> Vec<u8> {
        let mut rgba = vec![255; self.width * self.height * 4];
        for (rgba, rgb) in rgba.chunks_exact_mut(4).zip(self.rgb.chunks_exact(3)) {
            rgba[..3].copy_from_slice(rgb);
        }
        rgba
    }
}

fn lay_row(rgb: &mut [u8], rgba: &[u8]) {
    for (below, above) in rgb.chunks_exact_mut(3).zip(rgba.chunks_exact(4)) {
        match above[3] {
            255 => below.copy_from_slice(&above[..3]),
            0 => {}
            alpha => {
                let alpha = u32::from(alpha);
                for (below, &above) in below.iter_mut().zip(above) {
                    let sum = u32::from(above) * alpha + u32::from(*below) * (255 - alpha);
                    *below = ((sum + 127) / 255) as u8;
                }
            }
        }
    }
}

/// Renders a whole page. `photo` finds the pixels of an id.
///
/// # Errors
/// `missing-photo` if `photo` does not return an id; `cancelled`.
pub fn compose<'p>(
    scene: &Scene,
    photo: impl Fn(&str) -> Option<&'p Image>,
    context: &mut Context<'_>,
) -> Result<Sheet> {
    let mut sheet = Sheet::new(scene);
    let mut over = Vec::new();
    for mut pictures in scene.by_panel() {
        // Foregrounds are in front of text, which is not drawn here.
        pictures.retain(|index| *index < scene.panels.len());
        let image = match &scene.picture(pictures[0])?.photo {
            Some(id) => Some(photo(id).ok_or_else(|| Error::MissingPhoto(id.clone()))?),
            None => None,
        };
        let mut patches = render_together(scene, &pictures, image, context)?.into_iter();
        if let Some(panel) = patches.next() {
            sheet.lay(panel.area, &panel.rgba)?;
        }
        over.extend(patches);
    }
    for figure in over {
        sheet.lay(figure.area, &figure.rgba)?;
    }
    Ok(sheet)
}
