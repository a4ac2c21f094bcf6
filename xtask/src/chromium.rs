//! A Chromium for the browser tests and the benchmarks: the one that is there, or Debian's.

use std::env;
use std::path::PathBuf;

use anyhow::{Result, bail};

use crate::debian;

/// Names that Chromium and its kin go by in PATH.
const NAMES: &[&str] = &["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];

/// Places outside PATH.
const PLACES: &[&str] = &[
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files\Chromium\Application\chrome.exe",
];

const ADVICE: &str = "install Chromium (Debian: apt install chromium) or set CHROMIUM to its path";

/// Finds the browser's program, or installs it where that needs no questions.
///
/// # Errors
/// When there is none and it cannot be installed; the message says what to do.
pub(crate) fn find() -> Result<PathBuf> {
    if let Some(given) = env::var_os("CHROMIUM").map(PathBuf::from) {
        if given.is_file() {
            return Ok(given);
        }
        bail!("CHROMIUM is {}, which is no file", given.display());
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

fn installed() -> Option<PathBuf> {
    let path = env::var_os("PATH").unwrap_or_default();
    let suffix = env::consts::EXE_SUFFIX;
    let in_path = env::split_paths(&path)
        .flat_map(|folder| NAMES.iter().map(move |name| folder.join(format!("{name}{suffix}"))));
    in_path.chain(PLACES.iter().map(PathBuf::from)).find(|program| program.is_file())
}
