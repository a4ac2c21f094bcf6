//! `cargo xtask bench native`: blocks outside the browser beside native `OpenCV`, on one thread each.

use std::fs;
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::project::Project;
use crate::tools;

/// What is installed from the Python registry, in an environment below `target`.
const PEER: &str = "opencv-python-headless==5.0.0.93";

const MARKERS: [&str; 2] = ["<!-- native:start -->", "<!-- native:end -->"];

/// Builds for this machine's processor, as `OpenCV` chooses its kernels by it, measures, and writes the README's table.
pub(crate) fn run(project: &Project) -> Result<()> {
    let folder = project.target.join("native");
    let photo = project.root.join("www/public/samples/06-castle.jpg");
    let mut build = project.cargo();
    build.args(["run", "--release", "--example", "native", "--target-dir"]).arg(&folder);
    build.env("RUSTFLAGS", "-C target-cpu=native").arg("--").arg(&photo);
    let times = folder.join("times.json");
    let measured = tools::output(&mut build)?;
    fs::write(&times, measured)?;
    let python = folder.join("python/bin/python");
    if !python.exists() {
        tools::run(Command::new("python3").args(["-m", "venv"]).arg(folder.join("python")))?;
    }
    tools::run(Command::new(&python).args(["-m", "pip", "install", "--quiet", PEER]))?;
    let script = project.root.join("bench/native.py");
    let table = tools::output(Command::new(&python).arg(script).arg(&photo).arg(&times))?;
    println!("{table}");
    let readme = project.root.join("README.md");
    let text = fs::read_to_string(&readme)?;
    fs::write(&readme, between(&text, table.trim())?).context("cannot write the README")
}

/// The text with a table between the markers.
fn between(text: &str, table: &str) -> Result<String> {
    let (Some((before, rest)), [start, end]) = (text.split_once(MARKERS[0]), MARKERS) else {
        bail!("README.md lacks the markers {MARKERS:?}");
    };
    let Some((_, after)) = rest.split_once(end) else { bail!("README.md lacks the marker {end}") };
    Ok(format!("{before}{start}\n{table}\n{end}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_replaces_the_last_one() {
        let text = "a\n<!-- native:start -->\nold\n<!-- native:end -->\nb\n";
        let new = between(text, "new").unwrap();
        assert_eq!(new, "a\n<!-- native:start -->\nnew\n<!-- native:end -->\nb\n");
        assert_eq!(between(&new, "new").unwrap(), new);
        assert!(between("nothing", "new").is_err());
    }
}
