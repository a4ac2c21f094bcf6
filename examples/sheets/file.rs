//! A sheet in a file.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use image::RgbImage;
use image::codecs::jpeg::JpegEncoder;
use tiny_skia::Pixmap;

/// Writes a PNG file if the name ends in `.png`, otherwise a JPEG file of this quality.
pub(crate) fn save(sheet: &Pixmap, path: &Path, quality: u8) -> Result<(), Box<dyn Error>> {
    // A sheet is opaque, so that premultiplied and straight pixels are the same.
    let pixels = sheet.pixels().iter().flat_map(|pixel| [pixel.red(), pixel.green(), pixel.blue()]).collect();
    let picture = RgbImage::from_raw(sheet.width(), sheet.height(), pixels).ok_or("too large")?;
    let mut file = BufWriter::new(File::create(path)?);
    if path.extension().is_some_and(|kind| kind == "png") {
        let mut encoder = png::Encoder::new(file, picture.width(), picture.height());
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        return Ok(encoder.write_header()?.write_image_data(&picture)?);
    }
    Ok(JpegEncoder::new_with_quality(&mut file, quality).encode_image(&picture)?)
}
