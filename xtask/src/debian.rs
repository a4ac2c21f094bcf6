//! Debian packages, which the tests install if they have permission.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::{Mutex, PoisonError};

use anyhow::Result;

use crate::tools;

/// Suites run in parallel, but apt-get cannot run twice.
static ALONE: Mutex<()> = Mutex::new(());

/// Installs a package if this needs no interaction. Returns `false` if the system is not Debian or the user
/// is not root.
///
/// # Errors
/// When apt-get fails.
pub fn install(package: &str) -> Result<bool> {
    install_all(&[package])
}

/// Installs several as `install` does one.
///
/// # Errors
/// When apt-get fails.
pub fn install_all(packages: &[&str]) -> Result<bool> {
    if !(is_root() && is_debian()) {
        return Ok(false);
    }
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    println!("apt-get install {}", packages.join(" "));
    tools::run(Command::new("apt-get").args(["update", "-qq"]))?;
    let mut install = Command::new("apt-get");
    install.args(["install", "-y", "-qq", "--no-install-recommends"]).args(packages);
    tools::run(install.env("DEBIAN_FRONTEND", "noninteractive"))?;
    Ok(true)
}

/// Returns whether a package is installed, by dpkg.
pub fn has(package: &str) -> bool {
    let mut query = Command::new("dpkg-query");
    query.args(["--show", "--showformat", "${db:Status-Status}", package]).stderr(Stdio::null());
    query.output().is_ok_and(|answer| answer.stdout == b"installed")
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

/// Debian or a child of it. Ubuntu's `chromium` is a stub that requires snap, so nothing is installed on
/// Ubuntu.
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
