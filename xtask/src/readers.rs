//! Independent programs that check exported files: Poppler for PDF files, ffprobe for videos. It uses
//! installed programs, or installs Debian's packages.

use anyhow::{Result, bail};

use crate::{debian, tools};

/// Programs, and their Debian packages.
const PROGRAMS: [(&str, &str); 4] = [
    ("pdfinfo", "poppler-utils"),
    ("pdftotext", "poppler-utils"),
    ("pdftoppm", "poppler-utils"),
    ("ffprobe", "ffmpeg"),
];

/// Finds the programs in PATH, or installs them if this needs no interaction.
///
/// # Errors
/// When one is missing and cannot be installed; the message says what to do.
pub fn find() -> Result<()> {
    let mut packages = missing();
    packages.dedup();
    if packages.is_empty() || debian::install_all(&packages)? && missing().is_empty() {
        return Ok(());
    }
    let all: Vec<&str> = PROGRAMS.iter().map(|(program, _)| *program).collect();
    bail!("{} must be in PATH (Debian: apt install {})", all.join(", "), packages.join(" "));
}

/// The packages of missing programs.
fn missing() -> Vec<&'static str> {
    PROGRAMS
        .into_iter()
        .filter(|(program, _)| tools::in_path(&[program]).is_none())
        .map(|(_, package)| package)
        .collect()
}
