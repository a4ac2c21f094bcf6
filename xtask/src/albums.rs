//! The sample album of the repository, and the photos of other folders.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result};

use crate::project::Project;

/// The sample album, and the photos of the tests.
pub fn own_folders(project: &Project) -> Vec<PathBuf> {
    ["www/public/samples", "tests/photos"].iter().map(|folder| project.root.join(folder)).collect()
}

/// The JPEG files of folders, by name in each.
///
/// # Errors
/// If a folder cannot be listed.
pub fn photos_in(folders: &[PathBuf]) -> Result<Vec<PathBuf>> {
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
