//! The contact sheet of the designed styles, family by family: each on twelve photos, some of them taken in bad light.
//!
//!     cargo run --release --example style_sheet
//!
//! draws `docs/styles.jpg`. While a style is being made, larger cells show more:
//!
//!     cargo run --release --example style_sheet -- -o try.png --cell 400 --across 4 --styles try.json,noir
//!
//! A style is drawn on a panel of 400 pixels, as on a page on the screen. `--panel 1920` draws as for print.
//! Some styles have blocks that apply only to the subject. They use the masks in `--masks DIR`, a folder that
//! `inkpanel segment` filled. Without it, the whole photo counts as the subject.
//!
//! Photos may be named too; `photo.jpg@dark` shows one as if taken in that light, see [`LIGHTS`].

#[path = "sheets/file.rs"]
mod file;
#[path = "sheets/font.rs"]
mod font;
#[path = "sheets/picture.rs"]
mod picture;

use std::error::Error;
use std::fs;
use std::path::Path;
use std::sync::Arc;

use file::save;
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::resize::{Region, resample_image};
use inkpanel_engine::raster::{Image, Matte};
use inkpanel_engine::style::catalogue::{by_family, find};
use inkpanel_engine::style::painters::Painters;
use inkpanel_engine::style::part::subject_in;
use inkpanel_engine::style::{Context, Style, stylize};
use picture::paste;
use tiny_skia::{Color, Pixmap};

type Outcome<T> = Result<T, Box<dyn Error>>;

/// People, animals and buildings; in haze, by night, overexposed and dull ones among them.
const PHOTOS: [&str; 12] = [
    "www/public/samples/09-mariachi.jpg",
    "www/public/samples/19-astronaut.jpg",
    "www/public/samples/13-didgeridoo.jpg",
    "www/public/samples/07-red-panda.jpg",
    "www/public/samples/08-kingfisher.jpg",
    "www/public/samples/16-gate.jpg",
    "www/public/samples/12-pyramid.jpg",
    "www/public/samples/06-castle.jpg@hazy",
    "www/public/samples/17-festival.jpg",
    "www/public/samples/02-kitten.jpg@dark",
    "www/public/samples/11-giraffe.jpg@bright",
    "tests/photos/cat.jpg@dull",
];

/// Simulated bad light: gain and bias of a channel, clipped.
const LIGHTS: [(&str, f32, f32); 4] =
    [("hazy", 0.4, 140.0), ("dark", 0.25, 0.0), ("bright", 1.5, 40.0), ("dull", 0.35, 75.0)];

/// Height of a line with an id.
const LINE: u32 = 16;

/// Quality of a JPEG file.
const QUALITY: u8 = 34;

fn main() -> Outcome<()> {
    let options = Options::read(std::env::args().skip(1))?;
    let photos: Vec<Image> =
        options.photos.iter().map(|name| photo(name, options.panel)).collect::<Outcome<_>>()?;
    let subjects: Vec<Option<Matte>> =
        options.photos.iter().map(|name| mask(&options, name)).collect::<Outcome<_>>()?;
    let painters = Arc::new(Painters::new(&fs::read("www/models/painters.onnx")?)?);
    let (width, height) = (options.cell, options.cell * 3 / 4);
    let across = options.across.min(photos.len() as u32).max(1);
    let strip = (photos.len() as u32).div_ceil(across) * height + LINE;
    let mut sheet =
        Pixmap::new(across * width, strip * options.styles.len() as u32).ok_or("an empty sheet")?;
    sheet.fill(Color::WHITE);
    for (row, style) in options.styles.iter().enumerate() {
        let top = row as u32 * strip;
        font::write(&mut sheet, &format!("{} - {}", style.tags.join(" "), style.id), 4, top + 3);
        for (i, photo) in photos.iter().enumerate() {
            let mut context = Context::for_image(photo);
            context.show_painters(Some(painters.clone()));
            let size = (photo.width(), photo.height());
            context.show_subject(subjects[i].as_ref().and_then(|matte| {
                subject_in(matte, Region::whole(size.0, size.1), size, (photo, context.scale()))
            }));
            let drawn = stylize(photo, style, &mut context)?;
            let whole = Region::whole(drawn.width(), drawn.height());
            let cell = resample_image(&drawn, whole, width as usize, height as usize);
            let (column, line) = (i as u32 % across, i as u32 / across);
            paste(&mut sheet, &cell, column * width, top + LINE + line * height);
        }
    }
    save(&sheet, Path::new(&options.out), QUALITY)
}

/// Which part of a photo is its subject, cut as the photo is.
fn mask(options: &Options, name: &str) -> Outcome<Option<Matte>> {
    let Some(folder) = &options.masks else { return Ok(None) };
    let path = Path::new(name.split('@').next().unwrap_or(name));
    let file =
        Path::new(folder).join(path.with_extension("png").file_name().ok_or("a photo without a name")?);
    let shares = photo(&file.to_string_lossy(), options.panel)?.into_parts().0.swap_remove(0);
    let size = (shares.width(), shares.height());
    Ok(Some(Matte::new(&shares, size)))
}

struct Options {
    out: String,
    /// Pixels across in which styles are drawn; cells of the sheet are made from these.
    panel: usize,
    cell: u32,
    across: u32,
    masks: Option<String>,
    styles: Vec<Style>,
    photos: Vec<String>,
}

impl Options {
    fn read(mut words: impl Iterator<Item = String>) -> Outcome<Self> {
        let mut options = Self {
            out: "docs/styles.jpg".into(),
            panel: 400,
            cell: 80,
            across: PHOTOS.len() as u32,
            masks: None,
            styles: by_family().into_iter().cloned().collect(),
            photos: Vec::new(),
        };
        while let Some(word) = words.next() {
            let mut value = || words.next().ok_or_else(|| format!("{word} needs a value"));
            match word.as_str() {
                "-o" => options.out = value()?,
                "--panel" => options.panel = value()?.parse()?,
                "--cell" => options.cell = value()?.parse()?,
                "--across" => options.across = value()?.parse()?,
                "--masks" => options.masks = Some(value()?),
                "--styles" => options.styles = value()?.split(',').map(style).collect::<Outcome<_>>()?,
                _ => options.photos.push(word),
            }
        }
        if options.photos.is_empty() {
            options.photos = PHOTOS.map(str::to_owned).to_vec();
        }
        Ok(options)
    }
}

/// A file, or an id of the catalogue.
fn style(name: &str) -> Outcome<Style> {
    match fs::read_to_string(name) {
        Ok(json) => Ok(Style::parse(name, &json)?),
        Err(_) => Ok(find(name)?.clone()),
    }
}

/// A photo in the shape of a cell: of wide ones the middle, of tall ones the upper part, where heads are.
fn photo(name: &str, width: usize) -> Outcome<Image> {
    let (path, light) = name.split_once('@').unwrap_or((name, ""));
    let photo = decode(&fs::read(path)?, &Limits::default())?.image;
    let height = (width * 3 / 4).max(1);
    let (w, h) = (photo.width() as f64, photo.height() as f64);
    let scale = (w / width as f64).min(h / height as f64);
    let (across, down) = (width as f64 * scale, height as f64 * scale);
    let region = Region { x: (w - across) / 2.0, y: (h - down) * 0.1, width: across, height: down };
    let photo = resample_image(&photo, region, width, height);
    match LIGHTS.iter().find(|(known, ..)| *known == light) {
        Some(&(_, gain, bias)) => lit(&photo, gain, bias),
        None if light.is_empty() => Ok(photo),
        None => Err(format!("{name}: no such light").into()),
    }
}

fn lit(photo: &Image, gain: f32, bias: f32) -> Outcome<Image> {
    let light = |value: u8| f32::from(value).mul_add(gain, bias).clamp(0.0, 255.0) as u8;
    let rgb: Vec<u8> = photo.to_rgb().into_iter().map(light).collect();
    Ok(Image::from_interleaved_rgb(photo.width(), photo.height(), &rgb)?)
}
