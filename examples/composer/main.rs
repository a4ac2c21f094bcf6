//! Rates automatic pages: writes a sheet to look at, and a table of geometric measurements.
//!
//!     cargo run --release --example composer -- sheet FOLDER PHOTOS...    48 pages as PNG files, scores apart
//!     cargo run --release --example composer -- table FILE|- PHOTOS...    the bars over 200 pages
//!
//! Each page is planned from twelve of the given photos, like `inkpanel render` with the page number as seed.
//! Cut subjects are counted with sample points of their boxes against the exact outlines. The count does not
//! use the approximations of the composer.

mod bars;
#[path = "../sheets/seen.rs"]
mod seen;
mod shuffles;

use std::path::{Path, PathBuf};

use inkpanel_engine::detect::Detectors;
use inkpanel_engine::framing::{PhotoMeta, subject_of};
use inkpanel_engine::layout::PageSettings;
use inkpanel_engine::page::import::import;
use inkpanel_engine::page::request::Request;
use inkpanel_engine::page::shuffle::{Planned, planned};
use inkpanel_engine::page::{Scene, compose, png};
use inkpanel_engine::plan::Shelf;
use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::Limits;
use inkpanel_engine::style::Context;
use oorandom::Rand64;
use rayon::prelude::*;

/// Photos that a page is made of.
const ALBUM: usize = 12;
/// Pages of a sheet, and their width in pixels.
const SHEET: u32 = 48;
const WIDTH: usize = 1000;

type Failure = Box<dyn std::error::Error + Send + Sync>;

struct Photo {
    name: String,
    meta: PhotoMeta,
    work: Image,
}

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [task, output, files @ ..] = &arguments[..] else {
        return Err("say: sheet FOLDER PHOTOS... or table FILE PHOTOS...".into());
    };
    let photos = read(files)?;
    match task.as_str() {
        "sheet" => sheet(&photos, Path::new(output)),
        "table" => bars::write(&photos, output),
        other => Err(format!("there is no {other}; say sheet or table").into()),
    }
}

fn read(files: &[String]) -> Result<Vec<Photo>, Failure> {
    let models = ["www/models", "target/models"].map(PathBuf::from);
    let models = std::env::var_os("INKPANEL_MODELS").map(PathBuf::from).into_iter().chain(models);
    let models = models.into_iter().find(|folder| folder.join("faces.onnx").is_file());
    let models = models.ok_or("the detectors' nets are missing: make them with `cargo xtask models`")?;
    let read = |name: &str| std::fs::read(models.join(name));
    let detectors = Detectors::new(&read("faces.onnx")?, &read("objects.onnx")?)?;
    let photo = |(i, file): (usize, &String)| -> Result<Photo, Failure> {
        let name =
            Path::new(file).file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let mut photo = import(&format!("photo-{i}"), &std::fs::read(file)?, &Limits::default())?;
        photo.meta.find(detectors.detect(&photo.work)?.into_iter().map(subject_of));
        Ok(Photo { name, meta: photo.meta, work: photo.work })
    };
    files.par_iter().enumerate().map(photo).collect()
}

/// The page of a number: twelve photos in their order, planned with the number as seed.
fn page(photos: &[Photo], number: u32) -> Result<(Planned, Vec<PhotoMeta>), Failure> {
    let mut random = Rand64::new(u128::from(number) ^ 0x616c_6275_6d73);
    let mut left: Vec<usize> = (0..photos.len()).collect();
    let mut drawn = Vec::new();
    while drawn.len() < ALBUM && !left.is_empty() {
        drawn.push(left.swap_remove(random.rand_range(0..left.len() as u64) as usize));
    }
    drawn.sort_unstable();
    let album: Vec<PhotoMeta> = drawn.iter().map(|&i| photos[i].meta.clone()).collect();
    let request =
        Request { seed: number, photos: album.clone(), page: PageSettings::default(), ..Request::default() };
    Ok((planned(&request, &Shelf::new(album.len()))?, album))
}

fn sheet(photos: &[Photo], folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder)?;
    let draw = |number: u32| -> Result<String, Failure> {
        let (planned, _) = page(photos, number)?;
        let document = &planned.document;
        let scene = Scene::new(document, WIDTH)?;
        let find = |id: &str| photos.iter().find(|photo| photo.meta.id == id).map(|photo| &photo.work);
        let drawn = compose::compose(&scene, find, &mut Context::default())?;
        std::fs::write(folder.join(format!("page-{number:02}.png")), png::encode(&drawn, 96)?)?;
        let name =
            |id: &String| photos.iter().find(|p| &p.meta.id == id).map_or("", |photo| photo.name.as_str());
        let shown: Vec<&str> =
            document.panels.iter().filter_map(|panel| panel.photo.as_ref()).map(name).collect();
        let terms: Vec<String> =
            planned.score.terms().iter().map(|(term, value)| format!("{term} {value:.2}")).collect();
        Ok(format!(
            "{number:02}  {:.2}  {}  {}  merges {}  {}\n    {}\n",
            planned.score.total(),
            document.layout.built_in().unwrap_or("?"),
            document.style.built_in().unwrap_or("?"),
            document.merges.len(),
            terms.join(", "),
            shown.join(", "),
        ))
    };
    let lines = (1..=SHEET).into_par_iter().map(draw).collect::<Result<Vec<String>, Failure>>()?;
    // Apart, so that pages can be rated before their scores are read.
    std::fs::write(folder.join("scores.txt"), lines.concat())?;
    Ok(())
}
