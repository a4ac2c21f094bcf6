//! Quality of automatic pages: 48 sample pages, and a table with scores of two hundred.

use std::path::PathBuf;

use anyhow::Result;

use crate::albums::{own_folders, photos_in};
use crate::models;
use crate::project::Project;
use crate::tools;

/// Draws 48 pages into `target/pages`, with separate scores. For the sample album it also writes
/// `docs/reports/automatic-pages.md`.
///
/// # Errors
/// If a folder cannot be listed, or the example fails.
pub fn run(project: &Project, folders: &[String]) -> Result<()> {
    models::make(project)?;
    let own = folders.is_empty();
    let folders = if own { own_folders(project) } else { folders.iter().map(PathBuf::from).collect() };
    let photos = photos_in(&folders)?;
    let sheet = project.target.join("pages");
    let table = if own { project.root.join("docs/reports/automatic-pages.md") } else { PathBuf::from("-") };
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

/// Starts the rating tool with the command line program in a release build and its models.
///
/// # Errors
/// If a build fails, or the tool does.
pub fn rate(project: &Project, arguments: &[String]) -> Result<()> {
    models::make(project)?;
    let mut cargo = project.cargo();
    tools::run(cargo.args(["build", "--quiet", "--release", "--bin", "inkpanel"]))?;
    let inkpanel = project.target.join("release").join(format!("inkpanel{}", std::env::consts::EXE_SUFFIX));
    let mut cargo = project.cargo();
    cargo.args(["run", "--quiet", "--package", "inkpanel-rate", "--", "--inkpanel"]).arg(inkpanel);
    tools::run(cargo.args(arguments))
}
