//! Measures the subject mask of a photo against the manually marked subject
//! (`tests/data/subjects/PROVENANCE.md`).

use std::fs;
use std::path::{Path, PathBuf};

use inkpanel_engine::detect::Segmenter;
use inkpanel_engine::page::import::import;
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::guided::{refined, softened};
use inkpanel_engine::raster::resize::{Region, resample, resample_image};
use inkpanel_engine::raster::{Image, Plane};
use inkpanel_engine::style::context::scale_of;

/// Photos of the album, which were used for tuning.
pub(crate) const TUNED: [&str; 14] = [
    "01-coffee",
    "02-kitten",
    "03-friends",
    "04-dandelions",
    "06-castle",
    "07-red-panda",
    "08-kingfisher",
    "10-fig",
    "11-giraffe",
    "12-pyramid",
    "13-didgeridoo",
    "16-gate",
    "18-rocket",
    "19-astronaut",
];
/// Photos that were held out.
pub(crate) const HELD_OUT: [&str; 12] = [
    "bee", "camera", "cat", "crab", "dahlia", "horses", "macaw", "pagoda", "pika", "raccoon", "temple",
    "wine",
];
/// Width in pixels of the render that is measured.
pub(crate) const WIDTH: usize = 1920;
/// Distances in pixels of that render within which a border counts as the marked one.
pub(crate) const NEAR: [i64; 2] = [2, 6];
/// From this share on a pixel is the subject.
const WITHIN: u8 = 128;

/// A mask against a mark.
pub(crate) struct Measured {
    /// The photo, `WIDTH` pixels wide, and the pixels of mask and mark, row by row.
    pub(crate) picture: Image,
    pub(crate) mask: Vec<bool>,
    pub(crate) mark: Vec<bool>,
    /// How sure the mask's border is, and the share of the photo that it covers, 0 to 1.
    pub(crate) sure: f64,
    pub(crate) covers: f64,
    /// Intersection over union, 0 to 1.
    pub(crate) overlap: f64,
    /// The share of the mask's border within each of the distances [`NEAR`] of the marked border, 0 to 1. The
    /// edge of the photo does not count as a border.
    pub(crate) near: [f64; 2],
}

fn root(path: &str) -> PathBuf {
    // The tests of another package also compile this file.
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let top = package.ancestors().find(|folder| folder.join("Cargo.lock").is_file());
    top.unwrap_or(package).join(path)
}

/// Returns the path of a photo.
pub(crate) fn path(name: &str) -> PathBuf {
    let folder =
        if name.starts_with(|c: char| c.is_ascii_digit()) { "www/public/samples" } else { "tests/photos" };
    root(folder).join(format!("{name}.jpg"))
}

/// Measures the mask of a photo as the page makes it: of the working copy, refined at the size of the render.
///
/// # Errors
/// Errors of files and of the model.
pub(crate) fn measure(net: &Segmenter, name: &str) -> Result<Measured, Box<dyn std::error::Error>> {
    let photo = import(name, &fs::read(path(name))?, &Limits::default())?.work;
    let matte = net.look(&photo)?;
    let size = (WIDTH, (WIDTH * photo.height()).div_ceil(photo.width()));
    let picture = resample_image(&photo, Region::whole(photo.width(), photo.height()), size.0, size.1);
    let shares = matte.plane();
    let whole = Region::whole(shares.width(), shares.height());
    let mask = within(&refined(&shares, whole, &picture, scale_of((size.0 * size.1) as f64)));
    let file = fs::read(root(&format!("tests/data/subjects/{name}.png")))?;
    let mark = within(&smooth(&decode(&file, &Limits::default())?.image.planes()[0], size));
    let both = mask.iter().zip(&mark).filter(|(a, b)| **a && **b).count();
    let either = mask.iter().zip(&mark).filter(|(a, b)| **a || **b).count();
    let near = shares_near(&border(&mask, size.0), &border(&mark, size.0), size.0);
    Ok(Measured {
        picture,
        mask,
        mark,
        sure: matte.facts().confidence,
        covers: matte.facts().coverage,
        overlap: both as f64 / either.max(1) as f64,
        near,
    })
}

/// Resizes a mark. Its steps of whole pixels become lines.
fn smooth(mark: &Plane, (width, height): (usize, usize)) -> Plane {
    let large = resample(mark, Region::whole(mark.width(), mark.height()), width, height);
    softened(&large, WIDTH / mark.width().max(1) / 2)
}

fn within(plane: &Plane) -> Vec<bool> {
    plane.samples().iter().map(|share| *share >= WITHIN).collect()
}

/// Returns the border of a mask of this width: pixels inside with a neighbour outside.
pub(crate) fn border(within: &[bool], width: usize) -> Vec<bool> {
    let height = within.len() / width;
    (0..within.len())
        .map(|i| {
            let (x, y) = (i % width, i / width);
            let ends = (x > 0 && !within[i - 1])
                || (x + 1 < width && !within[i + 1])
                || (y > 0 && !within[i - width])
                || (y + 1 < height && !within[i + width]);
            within[i] && ends
        })
        .collect()
}

/// Which part of a border has some of another within each of the distances [`NEAR`].
fn shares_near(border: &[bool], other: &[bool], width: usize) -> [f64; 2] {
    let height = other.len() / width;
    let there = |x: i64, y: i64| {
        (0..width as i64).contains(&x)
            && (0..height as i64).contains(&y)
            && other[y as usize * width + x as usize]
    };
    let length = border.iter().filter(|is| **is).count().max(1);
    NEAR.map(|far| {
        let disc: Vec<(i64, i64)> = (-far..=far)
            .flat_map(|dy| (-far..=far).map(move |dx| (dx, dy)))
            .filter(|(dx, dy)| dx * dx + dy * dy <= far * far)
            .collect();
        let is_near = |i: &usize| {
            let (x, y) = ((i % width) as i64, (i / width) as i64);
            disc.iter().any(|(dx, dy)| there(x + dx, y + dy))
        };
        let near = (0..border.len()).filter(|i| border[*i]).filter(is_near).count();
        near as f64 / length as f64
    })
}
