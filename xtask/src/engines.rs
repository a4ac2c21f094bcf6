//! Firefox, `WebKit`, and the `WebDriver` programs for them and Chromium. It uses installed programs, or
//! installs Debian's packages.

use std::env;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Result, bail};

use crate::project::Project;
use crate::{debian, tools};

/// Programs and the packages of Debian that they are in.
const PROGRAMS: [(&str, &str); 4] = [
    ("chromedriver", "chromium-driver"),
    ("firefox-esr", "firefox-esr"),
    ("WebKitWebDriver", "webkit2gtk-driver"),
    ("Xvfb", "xvfb"),
];

/// Libraries for the window of `WebKit` (`tests/engines/window.py`), and for MP4 in `WebKit` and Firefox.
const LIBRARIES: [&str; 3] = ["python3-gi", "gir1.2-webkit2-4.1", "gstreamer1.0-libav"];

/// Debian has no package. cargo builds it once per target folder.
const GECKODRIVER: &str = "0.37.1";

/// Sees that the browsers and their drivers are there, and tells `command` where geckodriver is.
///
/// # Errors
/// When one is missing and cannot be installed; the message says what to do.
pub fn find(project: &Project, command: &mut Command) -> Result<()> {
    let programs = PROGRAMS
        .iter()
        .filter(|(program, _)| tools::in_path(&[program]).is_none())
        .map(|(_, package)| *package);
    let libraries = LIBRARIES.into_iter().filter(|package| !debian::has(package));
    let missing: Vec<_> = programs.chain(libraries).collect();
    if !(missing.is_empty() || debian::install_all(&missing)?) {
        bail!("Firefox and WebKit are driven with these packages of Debian: install {}", missing.join(" "));
    }
    command.env("GECKODRIVER", geckodriver(project)?);
    Ok(())
}

fn geckodriver(project: &Project) -> Result<PathBuf> {
    let root = project.target.join("tools").join(format!("geckodriver-{GECKODRIVER}"));
    let program = root.join("bin").join(format!("geckodriver{}", env::consts::EXE_SUFFIX));
    if !program.is_file() {
        let mut install = project.cargo();
        install.args(["install", "geckodriver", "--locked", "--quiet", "--version", GECKODRIVER, "--root"]);
        tools::run(install.arg(&root))?;
    }
    Ok(program)
}
