//! A contact sheet: one row a style, one column a photo.
//!
//!     cargo run --release --example style_sheet -- OUT.png WIDTH STYLE[,STYLE...]|all PHOTOS...

use inkpanel::raster::Image;
use inkpanel::style::{Context, Style, catalogue, stylize};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [out, width, styles, photos @ ..] = args.as_slice() else {
        return Err("usage: style_sheet OUT.png WIDTH STYLES PHOTOS...".into());
    };
    let width: u32 = width.parse()?;
    let height = width * 3 / 4;
    let wanted: Vec<&str> = styles.split(',').collect();
    let read = |id: &str| -> Result<Style, Box<dyn Error>> {
        match std::fs::read_to_string(id) {
            Ok(json) => Ok(Style::parse(id, &json)?),
            Err(_) => Ok(catalogue::find(id)?.clone()),
        }
    };
    let styles: Vec<Style> = if wanted == ["all"] {
        catalogue::catalogue().to_vec()
    } else {
        wanted.iter().map(|id| read(id)).collect::<Result<_, _>>()?
    };
    let mut sheet = image::RgbImage::new(width * photos.len() as u32, height * styles.len() as u32);
    for (column, path) in photos.iter().enumerate() {
        let photo = image::open(path)?.resize_to_fill(width, height, image::imageops::FilterType::Triangle);
        let photo = Image::from_interleaved_rgb(width as usize, height as usize, photo.to_rgb8().as_raw())?;
        for (row, style) in styles.iter().enumerate() {
            let mut context = Context::for_image(&photo);
            let drawn = stylize(&photo, style, &mut context)?.to_rgba();
            for (i, pixel) in drawn.chunks_exact(4).enumerate() {
                let (x, y) = (i as u32 % width, i as u32 / width);
                let pixel = image::Rgb([pixel[0], pixel[1], pixel[2]]);
                sheet.put_pixel(column as u32 * width + x, row as u32 * height + y, pixel);
            }
        }
    }
    sheet.save(out)?;
    for (row, style) in styles.iter().enumerate() {
        println!("row {row}: {}", style.id);
    }
    Ok(())
}
