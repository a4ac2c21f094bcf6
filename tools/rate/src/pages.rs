//! Automatic pages of albums, drawn by the command line program.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};
use serde_json::{Map, Value};

/// Width of a drawn page in pixels.
const WIDTH: &str = "720";
/// Photos of an album at most.
const MOST_PHOTOS: usize = 60;
/// Extensions of files that count as photos.
const ENDINGS: [&str; 5] = ["jpg", "jpeg", "png", "webp", "tif"];

/// A drawn page.
#[derive(Debug, Clone)]
pub(crate) struct Page {
    /// The folder of its photos.
    pub(crate) album: String,
    /// The seed of its plan.
    pub(crate) seed: u64,
    /// The drawn PNG file.
    pub(crate) file: PathBuf,
    /// The terms of its score, by name.
    pub(crate) terms: Map<String, Value>,
}

/// Draws `count` pages of each album into `folder`. Pages that were drawn before are drawn again.
///
/// # Errors
/// If a folder has no photos, or the program fails.
pub(crate) fn draw(
    inkpanel: &Path,
    albums: &[PathBuf],
    count: u32,
    seed: u64,
    folder: &Path,
) -> Result<Vec<Page>> {
    fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
    let mut pages = Vec::new();
    for (number, album) in albums.iter().enumerate() {
        let photos = photos_in(album)?;
        for page in 0..u64::from(count) {
            let seed = seed * 1000 + page;
            let file = folder.join(format!("{number}-{page}.png"));
            eprintln!("{}: page {} of {count}", album.display(), page + 1);
            let mut command = Command::new(inkpanel);
            command.args(["render", "--json", "--width", WIDTH, "--seed"]).arg(seed.to_string());
            let output = command.arg("-o").arg(&file).args(&photos).output();
            let output = output.with_context(|| format!("cannot start {}", inkpanel.display()))?;
            if !output.status.success() {
                bail!("{}: {}", album.display(), String::from_utf8_lossy(&output.stderr).trim());
            }
            let plan: Value = serde_json::from_slice(&output.stdout).context("the plan is not JSON")?;
            let terms = plan["pages"][0]["terms"].as_object().context("the plan has no terms")?.clone();
            pages.push(Page { album: album.display().to_string(), seed, file, terms });
        }
    }
    Ok(pages)
}

fn photos_in(album: &Path) -> Result<Vec<PathBuf>> {
    let files = fs::read_dir(album).with_context(|| format!("cannot list {}", album.display()))?;
    let mut photos = files.map(|file| Ok(file?.path())).collect::<Result<Vec<_>>>()?;
    photos.retain(|file| {
        file.extension().is_some_and(|ending| ENDINGS.iter().any(|known| ending.eq_ignore_ascii_case(known)))
    });
    photos.sort();
    photos.truncate(MOST_PHOTOS);
    if photos.is_empty() {
        bail!("{} has no photos", album.display());
    }
    Ok(photos)
}
