//! Page drawing outside the browser, on all cores. The command line and the Python package share it.

use crate::error::Result;
use crate::framing::Subject;
use crate::layout::COARSE;
use crate::output::describing::described;
use crate::page::pdf::{Leaf, picture};
use crate::page::plates::Separation;
use crate::page::words::Letters;
use crate::page::words::draw as word_drawing;
use crate::page::words::given::GivenFonts;
use crate::page::{Document, Patch, Scene, compose};
use crate::raster::{Image, Matte};
use crate::style::painters::Painters;
use crate::style::{Context, Style};
use rayon::prelude::*;
use std::collections::{BTreeSet, HashMap};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Default quality of JPEG files and of images in PDF files.
pub const QUALITY: u8 = 90;

/// Reads the model of the block Painter, or returns `None`.
type ReadPainters = dyn Fn() -> Option<Arc<Painters>> + Send + Sync;

static READ_PAINTERS: Mutex<Option<Box<ReadPainters>>> = Mutex::new(None);
static PAINTERS: OnceLock<Option<Arc<Painters>>> = OnceLock::new();

/// Sets the function that reads the model of the block Painter. It is called once, for the first style with the
/// block. Without it, the block changes nothing.
pub fn read_painters_with(read: impl Fn() -> Option<Arc<Painters>> + Send + Sync + 'static) {
    *READ_PAINTERS.lock().unwrap_or_else(PoisonError::into_inner) = Some(Box::new(read));
}

/// Returns a context for drawing in a style, with the model of painters if the style needs it.
#[must_use]
pub fn context(style: &Style) -> Context<'static> {
    let mut context = Context::default();
    if style.has_block("painter") {
        let read = || READ_PAINTERS.lock().unwrap_or_else(PoisonError::into_inner).as_ref()?();
        context.show_painters(PAINTERS.get_or_init(read).clone());
    }
    context
}

/// Like [`context`], with the scale of a separate image.
#[must_use]
pub fn context_for(style: &Style, image: &Image) -> Context<'static> {
    let mut context = context(style);
    context.fit_scale(image);
    context
}

/// A photo as pages are drawn with it.
pub struct Photo {
    /// At its full size.
    pub image: Image,
    /// Subject mask, if known.
    pub subject: Option<Matte>,
}

/// Photos by id.
pub type Photos = HashMap<String, Photo>;

impl From<Image> for Photo {
    fn from(image: Image) -> Self {
        Self { image, subject: None }
    }
}

/// The ids of the photos that a page shows.
///
/// # Errors
/// As [`Scene::new`].
pub fn photos_of(document: &Document) -> Result<BTreeSet<String>> {
    let scene = Scene::new(document, document.page.width as usize)?;
    Ok(scene.panels.into_iter().filter_map(|panel| panel.photo).collect())
}

/// Whether any panel of the page shows the photo in a style.
#[must_use]
pub fn is_styled(document: &Document, photo: &str) -> bool {
    document.panels.iter().any(|panel| !panel.plain && panel.photo.as_deref() == Some(photo))
}

/// Draws the page at its own size with its text. Glyphs come from the bundled fonts and from `fonts`. A panel
/// without a photo stays empty.
///
/// # Errors
/// As [`Scene::new`]; errors of a style that does not fit; `invalid-document` for invalid text items.
pub fn sheet(document: &Document, photos: &Photos, fonts: &GivenFonts) -> Result<compose::Sheet> {
    let (mut sheet, fronts) = bare(document, photos)?;
    word_drawing::lay_words_behind(&mut sheet, document, &fonts.letters(&document.words)?, &fronts)?;
    Ok(sheet)
}

/// Like [`sheet`], in layers: the page without text, and each text item with its index, from back to front.
///
/// # Errors
/// As [`sheet`].
pub fn layers(
    document: &Document,
    photos: &Photos,
    letters: &Letters,
) -> Result<(compose::Sheet, Vec<(usize, Patch)>)> {
    let (sheet, fronts) = bare(document, photos)?;
    let mut words = Vec::with_capacity(document.words.len());
    word_drawing::drawn_behind((document, sheet.width()), letters, &fronts, &mut |place, patch| {
        words.push((place, patch));
        Ok(())
    })?;
    Ok((sheet, words))
}

/// The page without text, and the subjects in front of effects.
fn bare(document: &Document, photos: &Photos) -> Result<(compose::Sheet, Vec<Patch>)> {
    let scene = Scene::new(document, document.page.width as usize)?;
    let mut sheet = compose::Sheet::new(&scene);
    let mut patches = render(document, photos, true)?;
    let fronts = patches.split_off(scene.panels.len());
    for patch in patches {
        sheet.lay(patch.area, &patch.rgba)?;
    }
    Ok((sheet, fronts))
}

/// Returns the page as the PDF writer needs it, with alternative text for the panels. `plate` is the ink.
/// `quality` is the JPEG quality, from 1 to 100.
///
/// # Errors
/// As [`sheet`]; `encode`.
pub fn leaf(
    document: &Document,
    photos: &Photos,
    alts: Vec<String>,
    (plate, quality): (Option<(&Separation, usize)>, u8),
) -> Result<Leaf> {
    let scene = Scene::new(document, document.page.width as usize)?;
    // Borders are lines of the file. Breakouts depend on borders nevertheless.
    let patches = render(document, photos, false)?;
    let pictures = patches
        .par_iter()
        .enumerate()
        .filter(|(index, _)| scene.picture(*index).is_ok_and(|panel| panel.photo.is_some()))
        .map(|(index, patch)| picture::cut(document, (index, patch.area, &patch.rgba), quality, plate))
        .collect::<Result<Vec<_>>>()?;
    Ok(Leaf { document: document.clone(), pictures, alts })
}

/// Describes the detected content of each panel: `Panel 2 of 6: a person and a dog`, and `Logo` for a panel
/// with a logo. `subjects` returns the subjects of a photo.
pub fn alts<'s>(document: &Document, subjects: &dyn Fn(&str) -> &'s [Subject]) -> Vec<String> {
    let shows = described(document, subjects);
    let count = document.panels.iter().filter(|panel| !panel.plain).count();
    let alt = |i: usize| {
        if document.panels[i].plain {
            return "Logo".to_owned();
        }
        let what = shows.get(i).filter(|what| !what.is_empty()).map_or("a photo", String::as_str);
        format!("Panel {} of {count}: {what}", i + 1)
    };
    (0..document.panels.len()).map(alt).collect()
}

/// Returns the panels whose photos have fewer pixels per inch than [`COARSE`] at the page's own size, with
/// their PPI. Logos are skipped. `size` returns width and height of a photo in pixels.
///
/// # Errors
/// As [`Scene::new`].
pub fn coarse(document: &Document, size: &dyn Fn(&str) -> Option<(u32, u32)>) -> Result<Vec<(usize, u32)>> {
    let scene = Scene::new(document, document.page.width as usize)?;
    let leads = |i: usize| document.merge_of(i).is_none_or(|group| group.first() == Some(&i));
    let found = scene.panels.iter().enumerate().filter(|(i, _)| leads(*i)).filter_map(|(i, panel)| {
        let (width, height) = size(panel.photo.as_deref().filter(|_| !panel.plain)?)?;
        let across = panel.crop.width * f64::from(width) / panel.image_bounds.width;
        let down = panel.crop.height * f64::from(height) / panel.image_bounds.height;
        let dpi = across.min(down) * f64::from(document.page.dpi);
        (dpi < COARSE).then_some((i, dpi.round() as u32))
    });
    Ok(found.collect())
}

/// Renders the pictures of a page in order: panels with or without borders, breakouts, foregrounds.
fn render(document: &Document, photos: &Photos, bordered: bool) -> Result<Vec<Patch>> {
    let mut scene = Scene::new(document, document.page.width as usize)?;
    scene.bordered = bordered;
    scene.show_subjects(&|id| photos.get(id)?.subject.clone());
    let render = |pictures: Vec<usize>| {
        let photo = scene.picture(pictures[0])?.photo.as_deref().and_then(|id| photos.get(id));
        let image = photo.map(|photo| &photo.image);
        let patches = compose::render_together(&scene, &pictures, image, &mut context(&scene.style))?;
        Ok(pictures.into_iter().zip(patches).collect::<Vec<_>>())
    };
    let drawn = scene.by_panel().into_par_iter().map(render).collect::<Result<Vec<_>>>()?;
    let mut patches: Vec<(usize, Patch)> = drawn.into_iter().flatten().collect();
    patches.sort_by_key(|(index, _)| *index);
    Ok(patches.into_iter().map(|(_, patch)| patch).collect())
}
