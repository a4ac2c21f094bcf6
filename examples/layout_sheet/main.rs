//! Draws all layouts with photos in them on one sheet:
//! `cargo run --release --example layout_sheet -- [--page a4] [--family hero] [-o SHEET.png|jpg] [PHOTOS...]`
//!
//! Without `--page`, every layout is drawn on a page of its preferred aspect ratio. With `--page`, only
//! layouts that suit this page are drawn. `--generated 60` draws generated layouts instead. By default it
//! uses the photos of the sample album, and `--plain` draws no photos.

#[path = "../sheets/file.rs"]
mod file;
#[path = "../sheets/font.rs"]
mod font;

use std::error::Error;
use std::path::PathBuf;

use file::save;
use inkpanel_engine::framing::{EnergyMap, PhotoMeta};
use inkpanel_engine::layout::{
    PRESETS, PageSettings, ResolvedPanel, ResolvedShape, Template, catalogue, generate, resolve,
};
use inkpanel_engine::plan::{Order, assign, slots};
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::resize::{Region, fit, resample_image};
use tiny_skia::{Color, FillRule, Mask, Paint, Path, PathBuilder, Pixmap, PixmapPaint, Stroke, Transform};

/// The box that each layout fits in, pixels, and the space round it.
const BOX: (f64, f64) = (148.0, 190.0);
const GAP: f64 = 20.0;
const LABEL: f64 = 30.0;
const A4: f64 = 210.0 / 297.0;
const COLUMNS: usize = 11;
/// Quality of a JPEG file.
const QUALITY: u8 = 70;

type Outcome<T> = Result<T, Box<dyn Error>>;

fn main() -> Outcome<()> {
    let options = Options::read(std::env::args().skip(1))?;
    let photos = options.photos.iter().map(|path| open(path)).collect::<Outcome<Vec<_>>>()?;
    let page = options.page.map(|page| f64::from(page.0) / f64::from(page.1));
    let family = options.family.as_deref();
    let generated: Vec<Template> =
        (0..options.generated).map(|seed| generate(seed, page.unwrap_or(A4), 3..=8)).collect();
    let source = if generated.is_empty() { catalogue() } else { &generated };
    let shown: Vec<&Template> = source
        .iter()
        .filter(|template| page.is_none_or(|aspect| template.good_for(aspect)))
        .filter(|template| family.is_none_or(|family| template.family() == family))
        .collect();
    let columns = COLUMNS.min(shown.len()).max(1);
    let rows = shown.len().div_ceil(columns).max(1);
    let step = (BOX.0 + GAP, BOX.1 + GAP + LABEL);
    let size = (step.0 * columns as f64 + GAP, step.1 * rows as f64 + GAP);
    let mut sheet = Pixmap::new(size.0 as u32, size.1 as u32).ok_or("an empty sheet")?;
    sheet.fill(Color::from_rgba8(226, 226, 222, 255));
    for (i, template) in shown.iter().enumerate() {
        let place = (GAP + step.0 * (i % columns) as f64, GAP + step.1 * (i / columns) as f64);
        let aspect = page.unwrap_or_else(|| template.aspect());
        let drawn = thumbnail(template, aspect, &photos, i as u64)?;
        let at = (place.0 as i32, place.1 as i32);
        sheet.draw_pixmap(at.0, at.1, drawn.as_ref(), &PixmapPaint::default(), Transform::default(), None);
        font::write(&mut sheet, template.id(), at.0 as u32, (place.1 + BOX.1 + 8.0) as u32);
    }
    save(&sheet, &options.out, QUALITY)?;
    println!("{} layouts in {}", shown.len(), options.out.display());
    Ok(())
}

struct Options {
    out: PathBuf,
    page: Option<(u32, u32)>,
    family: Option<String>,
    generated: u64,
    photos: Vec<PathBuf>,
}

impl Options {
    fn read(mut words: impl Iterator<Item = String>) -> Outcome<Self> {
        let (mut out, mut page, mut family, mut plain) =
            (PathBuf::from("target/layouts.png"), None, None, false);
        let (mut photos, mut generated): (Vec<PathBuf>, u64) = (Vec::new(), 0);
        while let Some(word) = words.next() {
            match word.as_str() {
                "-o" => out = words.next().ok_or("-o needs a file")?.into(),
                "--plain" => plain = true,
                "--family" => family = words.next(),
                "--generated" => generated = words.next().ok_or("--generated needs a number")?.parse()?,
                "--page" => {
                    let id = words.next().ok_or("--page needs an id")?;
                    let preset = PRESETS.iter().find(|preset| preset.id == id).ok_or("no such page")?;
                    page = Some((preset.width, preset.height));
                }
                _ => photos.push(word.into()),
            }
        }
        if photos.is_empty() && !plain {
            let files =
                std::fs::read_dir("www/public/samples")?.filter_map(Result::ok).map(|file| file.path());
            photos = files.filter(|path| path.extension().is_some_and(|kind| kind == "jpg")).collect();
            photos.sort();
        }
        Ok(Self { out, page, family, generated, photos })
    }
}

struct Photo {
    image: Image,
    meta: PhotoMeta,
}

fn open(path: &PathBuf) -> Outcome<Photo> {
    let rgb = image::open(path)?.to_rgb8();
    let (width, height) = (rgb.width() as usize, rgb.height() as usize);
    let full = Image::from_interleaved_rgb(width, height, rgb.as_raw())?;
    let (w, h) = fit(width, height, 480);
    let image = resample_image(&full, Region::whole(width, height), w, h);
    let measured = PhotoMeta::unmeasured(&path.display().to_string(), width as u32, height as u32);
    let meta = PhotoMeta { energy: EnergyMap::of(&image), ..measured };
    Ok(Photo { image, meta })
}

/// A page with one layout, as large as the box allows.
fn thumbnail(template: &Template, aspect: f64, photos: &[Photo], seed: u64) -> Outcome<Pixmap> {
    let width = BOX.0.min(BOX.1 * aspect);
    let mut page = Pixmap::new(width as u32, ((width / aspect) as u32).max(1)).ok_or("an empty page")?;
    page.fill(Color::WHITE);
    let panels = resolve(template, aspect, &PageSettings::default());
    let metas: Vec<PhotoMeta> = photos.iter().map(|photo| photo.meta.clone()).collect();
    let chosen = assign(&metas, &slots(&panels, width), Order::Free, seed);
    for (i, panel) in panels.iter().enumerate() {
        let Some(outline) = outline(&panel.shape) else { continue };
        let scale = Transform::from_scale(width as f32, width as f32);
        stroke(&mut page, &outline, (panel.halo * 2.0) as f32, Color::WHITE, scale);
        match chosen.get(i) {
            Some(choice) => {
                let photo = &photos[choice.photo].image;
                let (w, h) = (photo.width() as f64, photo.height() as f64);
                let crop = choice.crop;
                let (x, y) = (crop.x * w, crop.y * h);
                let region = Region { x, y, width: crop.width * w, height: crop.height * h };
                picture(&mut page, photo, region, panel, &outline, width)?;
            }
            None => plain(&mut page, panel, i, &outline, scale),
        }
        stroke(&mut page, &outline, 0.007, Color::from_rgba8(17, 17, 17, 255), scale);
    }
    Ok(page)
}

fn picture(
    page: &mut Pixmap,
    photo: &Image,
    region: Region,
    panel: &ResolvedPanel,
    outline: &Path,
    width: f64,
) -> Outcome<()> {
    let bounds = panel.bounds;
    let (w, h) = ((bounds.width * width).ceil().max(1.0), (bounds.height * width).ceil().max(1.0));
    let pixels = resample_image(photo, region, w as usize, h as usize);
    let mut crop = Pixmap::new(w as u32, h as u32).ok_or("an empty panel")?;
    pixels.write_rgba(crop.data_mut())?;
    let mut mask = Mask::new(page.width(), page.height()).ok_or("an empty mask")?;
    mask.fill_path(outline, FillRule::Winding, true, Transform::from_scale(width as f32, width as f32));
    let (x, y) = ((bounds.x * width) as i32, (bounds.y * width) as i32);
    page.draw_pixmap(x, y, crop.as_ref(), &PixmapPaint::default(), Transform::default(), Some(&mask));
    Ok(())
}

/// A flat panel, darker the more it draws the eye.
fn plain(page: &mut Pixmap, panel: &ResolvedPanel, index: usize, outline: &Path, scale: Transform) {
    let depth = (panel.weight.clamp(0.4, 3.0) / 3.0).sqrt();
    let tone = |from: f32, to: f32| (from + (to - from) * depth) as u8;
    let tint = if panel.overlay { (250.0, 214.0) } else { (226.0, 120.0) };
    let colour = (tone(tint.0, tint.1), tone(224.0, 150.0 + (index % 3) as f32 * 12.0), tone(210.0, 140.0));
    let mut paint = Paint::default();
    paint.set_color_rgba8(colour.0, colour.1, colour.2, 255);
    page.fill_path(outline, &paint, FillRule::Winding, scale, None);
}

fn stroke(page: &mut Pixmap, outline: &Path, width: f32, colour: Color, scale: Transform) {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color(colour);
    if width > 0.0 {
        page.stroke_path(outline, &paint, &Stroke { width, ..Stroke::default() }, scale, None);
    }
}

fn outline(shape: &ResolvedShape) -> Option<Path> {
    match shape {
        ResolvedShape::Circle { center, radius } => {
            PathBuilder::from_circle(center.x as f32, center.y as f32, *radius as f32)
        }
        ResolvedShape::Polygon(corners) => {
            let mut path = PathBuilder::new();
            for (i, corner) in corners.iter().enumerate() {
                let (x, y) = (corner.x as f32, corner.y as f32);
                if i == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
            }
            path.close();
            path.finish()
        }
    }
}
