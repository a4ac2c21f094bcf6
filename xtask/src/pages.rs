//! How good automatic pages are: 48 to be looked at, and a table of what geometry can tell of two hundred.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result};

use crate::models;
use crate::project::Project;
use crate::tools;

/// The repository's albums.
const FOLDERS: [&str; 2] = ["www/public/samples", "tests/photos"];

/// Draws 48 pages into `target/pages`, scores apart, and writes `docs/automatic-pages.md` where the photos are the repository's own.
///
/// # Errors
/// Where a folder cannot be listed, or the example fails.
pub(crate) fn run(project: &Project, folders: &[String]) -> Result<()> {
    models::make(project)?;
    let own = folders.is_empty();
    let folders: Vec<PathBuf> = if own {
        FOLDERS.iter().map(|folder| project.root.join(folder)).collect()
    } else {
        folders.iter().map(PathBuf::from).collect()
    };
    let photos = photos_in(&folders)?;
    let sheet = project.target.join("pages");
    let table = if own { project.root.join("docs/automatic-pages.md") } else { PathBuf::from("-") };
    for (task, output) in [("sheet", &sheet), ("table", &table)] {
        let mut cargo = project.cargo();
        cargo.args(["run", "--release", "--example", "composer", "--", task]);
        tools::run(cargo.arg(output).args(&photos))?;
    }
    println!(
        "48 pages are in {}, their scores in scores.txt there: rate them before you read it",
        sheet.display()
    );
    Ok(())
}

/// The JPEG files of folders, by name.
pub(crate) fn photos_in(folders: &[PathBuf]) -> Result<Vec<PathBuf>> {
    let mut photos = Vec::new();
    for folder in folders {
        let files = fs::read_dir(folder).with_context(|| format!("cannot list {}", folder.display()))?;
        let mut files = files.map(|file| Ok(file?.path())).collect::<Result<Vec<_>>>()?;
        let ending = |file: &PathBuf| file.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        files.retain(|file| matches!(ending(file).as_deref(), Some("jpg" | "jpeg")));
        files.sort();
        photos.extend(files);
    }
    Ok(photos)
}
