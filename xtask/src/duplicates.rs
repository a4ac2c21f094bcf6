//! The tables of near-duplicates found and mistaken, over the photos of the repository.

use std::fs;

use anyhow::{Context, Result};

use crate::project::Project;
use crate::tools;

const FOLDERS: [&str; 2] = ["www/public/samples", "tests/photos"];

/// Writes `docs/near-duplicates.md`.
///
/// # Errors
/// When a folder cannot be listed or the program fails.
pub(crate) fn run(project: &Project) -> Result<()> {
    let mut photos = Vec::new();
    for folder in FOLDERS.map(|folder| project.root.join(folder)) {
        let files = fs::read_dir(&folder).with_context(|| format!("cannot list {}", folder.display()))?;
        photos.extend(files.map(|file| Ok(file?.path())).collect::<Result<Vec<_>>>()?);
    }
    photos.retain(|file| file.extension().is_some_and(|extension| extension == "jpg"));
    photos.sort();
    let mut cargo = project.cargo();
    cargo.args(["run", "--example", "duplicate_table", "--", "docs/near-duplicates.md"]).args(photos);
    tools::run(&mut cargo)
}
