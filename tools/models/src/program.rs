//! Runs npm and Python.

use std::io::ErrorKind;
use std::process::{Command, Stdio};

use anyhow::{Result, anyhow, bail};

/// Program name of npm.
pub(crate) const NPM: &str = if cfg!(windows) { "npm.cmd" } else { "npm" };

/// Program name of Python 3.
pub(crate) const PYTHON: &str = if cfg!(windows) { "python" } else { "python3" };

/// Runs a program and discards its standard output.
///
/// # Errors
/// If the program is missing or fails.
pub(crate) fn run(command: &mut Command) -> Result<()> {
    let program = command.get_program().to_string_lossy().into_owned();
    let status = command.stdout(Stdio::null()).status().map_err(|error| match error.kind() {
        ErrorKind::NotFound => anyhow!("`{program}` is not installed"),
        _ => anyhow!("cannot start `{program}`: {error}"),
    })?;
    if !status.success() {
        bail!("`{program}` failed ({status})");
    }
    Ok(())
}
