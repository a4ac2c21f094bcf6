//! A Chromium for the browser tests and the benchmarks: the one that is there, or Debian's.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Result, bail};

use crate::tools;

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
    if !(is_root() && is_debian()) {
        bail!("no Chromium found: {ADVICE}");
    }
    println!("apt-get install chromium");
    tools::run(Command::new("apt-get").args(["update", "-qq"]))?;
    let mut install = Command::new("apt-get");
    install.args(["install", "-y", "-qq", "--no-install-recommends", "chromium"]);
    tools::run(install.env("DEBIAN_FRONTEND", "noninteractive"))?;
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

fn is_root() -> bool {
    // The owner of the own process folder: std has no other way without `unsafe` or a crate.
    #[cfg(target_os = "linux")]
    {
        use std::os::unix::fs::MetadataExt;
        fs::metadata("/proc/self").is_ok_and(|process| process.uid() == 0)
    }
    #[cfg(not(target_os = "linux"))]
    false
}

/// Debian or a child of it. Ubuntu's `chromium` is a stub that wants snap, so Ubuntu is left to its owner.
fn is_debian() -> bool {
    Path::new("/usr/bin/apt-get").exists()
        && fs::read_to_string("/etc/os-release").is_ok_and(|release| says_debian(&release))
}

fn says_debian(release: &str) -> bool {
    let field =
        |name: &str| release.lines().find_map(|line| Some(line.strip_prefix(name)?.trim_matches('"')));
    field("ID=") == Some("debian")
        || field("ID=") != Some("ubuntu") && field("ID_LIKE=").is_some_and(|like| like.contains("debian"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn debian_is_told_from_ubuntu() {
        assert!(says_debian("NAME=x\nID=debian\n"));
        assert!(says_debian("ID=raspbian\nID_LIKE=\"debian\"\n"));
        assert!(!says_debian("ID=ubuntu\nID_LIKE=debian\n"));
        assert!(!says_debian("ID=fedora\n"));
    }
}
