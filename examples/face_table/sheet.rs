//! The sheet: each photo with its boxes, and its crops for a tall, a square and a wide panel.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use image::codecs::jpeg::JpegEncoder;
use image::{Rgb, RgbImage};
use inkpanel_engine::framing::{Crop, FACE, Target, frame};
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::resize::{Region, resample_image};
use tiny_skia::Pixmap;

use super::{Row, font};

const COLUMNS: usize = 3;
/// Height of the pictures, and width of the cell for a photo, in pixels.
const HEIGHT: u32 = 120;
const PHOTO: u32 = 180;
const GAP: u32 = 8;
const LABEL: u32 = 16;
const ASPECTS: [f64; 3] = [0.5, 1.0, 1.7];
const QUALITY: u8 = 78;

const PAPER: Rgb<u8> = Rgb([232, 232, 228]);
const FACES: Rgb<u8> = Rgb([255, 214, 10]);
const OBJECTS: Rgb<u8> = Rgb([64, 200, 255]);

/// Draws the rows and writes the file.
pub(crate) fn draw(rows: &[Row], out: &Path) -> Result<(), Box<dyn Error>> {
    let crops: u32 = ASPECTS.iter().map(|aspect| side(HEIGHT, *aspect) + GAP).sum();
    let step = (PHOTO + crops + 3 * GAP, HEIGHT + LABEL + GAP);
    let down = rows.len().div_ceil(COLUMNS) as u32;
    let mut sheet = RgbImage::from_pixel(step.0 * COLUMNS as u32 + GAP, step.1 * down + GAP, PAPER);
    for (i, row) in rows.iter().enumerate() {
        let at = (GAP + step.0 * (i as u32 % COLUMNS as u32), GAP + step.1 * (i as u32 / COLUMNS as u32));
        label(&mut sheet, &row.name, at)?;
        let top = at.1 + LABEL;
        let whole = Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };
        let fit = (f64::from(HEIGHT)).min(f64::from(PHOTO) / row.meta.aspect()) as u32;
        let mut photo = cropped(&row.picture, &whole, side(fit, row.meta.aspect()), fit);
        outline(&mut photo, row);
        image::imageops::replace(&mut sheet, &photo, at.0.into(), top.into());
        let mut left = at.0 + PHOTO + GAP;
        for aspect in ASPECTS {
            let crop = frame(&row.meta, &Target::of_aspect(aspect), 0);
            let width = side(HEIGHT, aspect);
            let picture = cropped(&row.picture, &crop, width, HEIGHT);
            image::imageops::replace(&mut sheet, &picture, left.into(), top.into());
            left += width + GAP;
        }
    }
    let mut file = BufWriter::new(File::create(out)?);
    Ok(JpegEncoder::new_with_quality(&mut file, QUALITY).encode_image(&sheet)?)
}

fn side(height: u32, aspect: f64) -> u32 {
    (f64::from(height) * aspect).round().max(1.0) as u32
}

fn cropped(picture: &Image, crop: &Crop, width: u32, height: u32) -> RgbImage {
    let (across, down) = (picture.width() as f64, picture.height() as f64);
    let region = Region {
        x: crop.x * across,
        y: crop.y * down,
        width: crop.width * across,
        height: crop.height * down,
    };
    let small = resample_image(picture, region, width as usize, height as usize).to_rgba();
    RgbImage::from_fn(width, height, |x, y| {
        let at = ((y * width + x) * 4) as usize;
        Rgb([small[at], small[at + 1], small[at + 2]])
    })
}

/// Draws the boxes of all subjects, faces last.
fn outline(photo: &mut RgbImage, row: &Row) {
    let (width, height) = (f64::from(photo.width()), f64::from(photo.height()));
    for faces in [false, true] {
        for subject in row.meta.subjects.iter().filter(|subject| (subject.label == FACE) == faces) {
            let color = if faces { FACES } else { OBJECTS };
            let (x0, x1) = (subject.x * width, (subject.x + subject.width) * width - 1.0);
            let (y0, y1) = (subject.y * height, (subject.y + subject.height) * height - 1.0);
            for t in 0..=200 {
                let along = |a: f64, b: f64| a + (b - a) * f64::from(t) / 200.0;
                for (x, y) in
                    [(along(x0, x1), y0), (along(x0, x1), y1), (x0, along(y0, y1)), (x1, along(y0, y1))]
                {
                    if let Some(pixel) = photo.get_pixel_mut_checked(x.max(0.0) as u32, y.max(0.0) as u32) {
                        *pixel = color;
                    }
                }
            }
        }
    }
}

/// Writes a photo's name above it.
fn label(sheet: &mut RgbImage, name: &str, at: (u32, u32)) -> Result<(), Box<dyn Error>> {
    let mut strip = Pixmap::new(PHOTO, LABEL).ok_or("no room for a name")?;
    strip.fill(tiny_skia::Color::from_rgba8(PAPER[0], PAPER[1], PAPER[2], 255));
    font::write(&mut strip, name.trim_end_matches(".jpg"), 0, 2);
    for (i, pixel) in strip.pixels().iter().enumerate() {
        let (x, y) = (at.0 + i as u32 % PHOTO, at.1 + i as u32 / PHOTO);
        sheet.put_pixel(x, y, Rgb([pixel.red(), pixel.green(), pixel.blue()]));
    }
    Ok(())
}
