//! Poppler's programs, which read the PDF files that the browser tests save: those that are there, or Debian's.

use std::env;

use anyhow::{Result, bail};

use crate::debian;

const PROGRAMS: [&str; 3] = ["pdfinfo", "pdftotext", "pdftoppm"];

const ADVICE: &str =
    "install Poppler's programs (Debian: apt install poppler-utils) so that they are in PATH";

/// Sees that the programs are in PATH, or installs them where that needs no questions.
///
/// # Errors
/// When one is missing and cannot be installed; the message says what to do.
pub(crate) fn find() -> Result<()> {
    if !(installed() || debian::install("poppler-utils")? && installed()) {
        bail!("no {} found: {ADVICE}", PROGRAMS.join(", "));
    }
    Ok(())
}

fn installed() -> bool {
    let path = env::var_os("PATH").unwrap_or_default();
    let there = |name: &str| {
        let program = format!("{name}{}", env::consts::EXE_SUFFIX);
        env::split_paths(&path).any(|folder| folder.join(&program).is_file())
    };
    PROGRAMS.into_iter().all(there)
}
