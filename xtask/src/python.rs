//! Python with packages, in an environment of its own below `target`.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;

use crate::tools;

/// What Python is called here.
pub(crate) fn program() -> &'static str {
    if cfg!(windows) { "python" } else { "python3" }
}

/// The Python of an environment in `folder` that has these packages alone, without those that they would like.
///
/// # Errors
/// When Python is missing, or pip does not give a package.
pub(crate) fn with(folder: &Path, packages: &[&str]) -> Result<PathBuf> {
    let environment = folder.join("python");
    let python = environment.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    if !python.exists() {
        tools::run(Command::new(program()).args(["-m", "venv"]).arg(&environment))?;
    }
    let mut pip = Command::new(&python);
    pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps"]);
    tools::run(pip.args(packages))?;
    Ok(python)
}
