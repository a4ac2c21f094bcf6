//! The luma of the photos in a folder.

use std::path::Path;

use inkpanel_engine::raster::Plane;
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::resize::{Region, resample};
use inkpanel_engine::simd::point::luma_plane;
use inkpanel_engine::style::Context;
use inkpanel_engine::style::blade::bank::Shape;
use inkpanel_engine::style::blade::buckets;

use crate::Outcome;

/// Maximum size of a photo. Larger photos are cropped to their centre.
const SIDES: (usize, usize) = (1280, 960);

/// A photo's luma.
pub(crate) struct Photo {
    pub(crate) name: String,
    pub(crate) luma: Plane,
}

impl Photo {
    /// The bucket of each block of 2 x 2 pixels.
    pub(crate) fn places(&self, shape: &Shape) -> Plane {
        let mut places = Plane::filled(self.luma.width().div_ceil(2), self.luma.height().div_ceil(2), 0);
        buckets::choose(&self.luma, shape, &mut places, &mut Context::default());
        places
    }

    /// Returns the sample at a place. Places outside repeat the edge.
    #[inline]
    pub(crate) fn at(&self, x: isize, y: isize) -> f32 {
        let x = x.clamp(0, self.luma.width() as isize - 1) as usize;
        let y = y.clamp(0, self.luma.height() as isize - 1) as usize;
        f32::from(self.luma.at(x, y))
    }
}

/// All JPEG, PNG and WebP files of a folder, by name.
pub(crate) fn read_folder(folder: &Path) -> Outcome<Vec<Photo>> {
    let entries = std::fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut files: Vec<_> = entries.filter_map(Result::ok).map(|entry| entry.path()).collect();
    files.sort();
    let is_photo = |path: &Path| {
        let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or("");
        ["jpg", "jpeg", "png", "webp"].iter().any(|known| extension.eq_ignore_ascii_case(known))
    };
    let mut photos = Vec::new();
    for path in files.iter().filter(|path| is_photo(path)) {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let decoded =
            decode(&std::fs::read(path)?, &Limits::default()).map_err(|error| format!("{name}: {error}"))?;
        let luma = luma_plane(&decoded.image);
        let (width, height) = (luma.width().min(SIDES.0), luma.height().min(SIDES.1));
        let (x, y) = ((luma.width() - width) / 2, (luma.height() - height) / 2);
        let region = Region { x: x as f64, y: y as f64, width: width as f64, height: height as f64 };
        photos.push(Photo { name, luma: resample(&luma, region, width, height) });
    }
    Ok(photos)
}
