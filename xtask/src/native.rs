//! `cargo xtask bench native`: compares blocks outside the browser with native `OpenCV`, on one thread each.

use std::fs;
use std::process::Command;

use anyhow::Result;

use crate::project::Project;
use crate::{tables, tools};

/// Python package that is installed in an environment below `target`.
const PEER: &str = "opencv-python-headless==5.0.0.93";

/// Builds for this machine's processor, as `OpenCV` chooses its kernels by it, measures, and writes a table of `docs/reports/benchmarks.md`.
pub fn run(project: &Project) -> Result<()> {
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
    tables::put(&project.root.join(tables::BENCHMARKS), "native", &table)
}
