//! Finds a Chromium for the browser tests and the benchmarks: an installed one, or Debian's package.

use std::env;
use std::path::PathBuf;

use anyhow::{Result, bail};

use crate::debian;
use crate::tools::in_path;

/// Names of Chromium and related browsers in PATH.
const NAMES: &[&str] = &["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];

/// Names of the headless version of the same engine.
const SHELLS: &[&str] = &["chromium-headless-shell", "chrome-headless-shell"];

/// Places outside PATH.
const PLACES: &[&str] = &[
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files\Chromium\Application\chrome.exe",
];

const ADVICE: &str = "install Chromium (Debian: apt install chromium) or set CHROMIUM to its path";

/// Finds the browser, or installs it if this needs no interaction.
///
/// # Errors
/// If it is missing and cannot be installed. The message has instructions.
pub fn find() -> Result<PathBuf> {
    if let Some(given) = env::var_os("CHROMIUM").map(PathBuf::from) {
        if given.is_file() {
            return Ok(given);
        }
        bail!("CHROMIUM: {} is not a file", given.display());
    }
    if let Some(found) = installed() {
        return Ok(found);
    }
    if !debian::install("chromium")? {
        bail!("no Chromium found: {ADVICE}");
    }
    match installed() {
        Some(found) => Ok(found),
        None => bail!("apt-get installed no Chromium: {ADVICE}"),
    }
}

/// Finds the browser for tests with many pages. It prefers a headless browser, which saves one second of
/// processor time per page.
///
/// # Errors
/// As [`find`].
pub fn shell() -> Result<PathBuf> {
    if env::var_os("CHROMIUM").is_some() {
        return find();
    }
    if let Some(found) = in_path(SHELLS) {
        return Ok(found);
    }
    // Debian releases before version 12 lack this package.
    if let Err(error) = debian::install("chromium-headless-shell") {
        println!("tests run in the whole browser: {error:#}");
    }
    in_path(SHELLS).map_or_else(find, Ok)
}

fn installed() -> Option<PathBuf> {
    in_path(NAMES).or_else(|| PLACES.iter().map(PathBuf::from).find(|program| program.is_file()))
}
