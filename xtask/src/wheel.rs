//! `cargo xtask wheel`: builds the Python package with maturin and tests it in an empty environment.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};

use crate::project::Project;
use crate::{models, python, test::ENGINE, tools};

/// Files of `www/models` in the wheel.
const MODELS: [&str; 4] = ["faces.onnx", "objects.onnx", "painters.onnx", "README.md"];
/// Optional files of `www/models` in the wheel.
const OPTIONAL: [&str; 2] = ["landmarks.onnx", "places.bin"];

/// Builds the wheel into `target/wheels` and tests it; `with_ray` also on a cluster of this machine.
///
/// # Errors
/// When Python is missing or too old, something cannot be fetched or built, or a test fails.
pub fn run(project: &Project, with_ray: bool) -> Result<()> {
    make(project, with_ray, None).map(|_| ())
}

/// Like [`run`], and prints the path of the wheel. Its entries have this time, in seconds since 1970, or the
/// time of the build.
///
/// # Errors
/// As there.
pub fn make(project: &Project, with_ray: bool, time: Option<u64>) -> Result<PathBuf> {
    python::check()?;
    models::make(project)?;
    let package = project.root.join("python");
    copy_models(project, &package)?;
    lint(project, &package)?;
    let wheel = build(project, &package, time)?;
    println!("made {}", wheel.display());
    test(project, &package, (&wheel, with_ray))?;
    Ok(wheel)
}

/// The program that the wheel has to draw the same pixels as, as the suite `rust` builds it: an example has cargo choose the
/// features that tests have, too.
fn command_line(project: &Project) -> Result<PathBuf> {
    let mut cargo = project.cargo();
    cargo.arg("build").args(ENGINE).args(["--quiet", "--bin", "inkpanel", "--example", "stage_raster"]);
    tools::run(&mut cargo)?;
    Ok(project.target.join("debug").join(format!("inkpanel{}", std::env::consts::EXE_SUFFIX)))
}

/// Cargo's target folder for the package, which is a separate workspace, and for its environments.
fn folder(project: &Project) -> PathBuf {
    project.target.join("wheel")
}

fn copy_models(project: &Project, package: &Path) -> Result<()> {
    let folder = package.join("inkpanel/models");
    fs::create_dir_all(&folder)?;
    let found = OPTIONAL.into_iter().filter(|file| project.www().join("models").join(file).exists());
    for file in MODELS.into_iter().chain(found) {
        let from = project.www().join("models").join(file);
        fs::copy(&from, folder.join(file)).with_context(|| format!("cannot copy {}", from.display()))?;
    }
    Ok(())
}

/// Format and lint checks of the package, with the profile of the wheel, so that libraries are compiled once.
fn lint(project: &Project, package: &Path) -> Result<()> {
    let manifest = package.join("Cargo.toml");
    tools::run(project.cargo().arg("fmt").arg("--manifest-path").arg(&manifest).arg("--check"))?;
    let mut clippy = project.cargo();
    clippy.args(["clippy", "--release", "--locked", "--manifest-path"]).arg(&manifest);
    tools::run(clippy.arg("--target-dir").arg(folder(project)).args(["--", "-D", "warnings"]))
}

fn build(project: &Project, package: &Path, time: Option<u64>) -> Result<PathBuf> {
    let wheels = project.target.join("wheels");
    if wheels.exists() {
        fs::remove_dir_all(&wheels)?;
    }
    let needs = package.join("requirements/build.txt");
    let interpreter = python::environment(&folder(project).join("build"), &[&needs])?;
    let mut maturin = std::process::Command::new(&interpreter);
    maturin.args(["-m", "maturin", "build", "--release", "--locked", "--out"]).arg(&wheels);
    maturin.arg("--target-dir").arg(folder(project)).arg("--interpreter").arg(&interpreter);
    maturin.envs(time.map(|seconds| ("SOURCE_DATE_EPOCH", seconds.to_string())));
    tools::run(maturin.current_dir(package))?;
    let mut made = fs::read_dir(&wheels)?.map(|entry| Ok(entry?.path())).collect::<Result<Vec<_>>>()?;
    made.retain(|file| file.extension().is_some_and(|ending| ending == "whl"));
    match (made.pop(), made.is_empty()) {
        (Some(wheel), true) => Ok(wheel),
        _ => bail!("maturin made no wheel in {}, or several", wheels.display()),
    }
}

fn test(project: &Project, package: &Path, (wheel, with_ray): (&Path, bool)) -> Result<()> {
    // Nothing of an earlier wheel may be there.
    let clean = folder(project).join("clean");
    if clean.exists() {
        fs::remove_dir_all(&clean)?;
    }
    let mut needs = vec![package.join("requirements/test.txt")];
    if with_ray {
        needs.push(package.join("requirements/ray.txt"));
    }
    let needs: Vec<&Path> = needs.iter().map(PathBuf::as_path).collect();
    let interpreter = python::environment(&clean, &needs)?;
    python::install(&interpreter, |pip| pip.args(["--no-index", "--no-deps"]).arg(wheel))?;
    let mut pytest = std::process::Command::new(&interpreter);
    pytest.env("INKPANEL", command_line(project)?);
    // From the top folder, because Python would import the source package in its folder.
    pytest.args(["-m", "pytest", "--quiet", "-p", "no:cacheprovider", "--config-file"]);
    pytest.arg(package.join("pyproject.toml")).arg(package.join("tests"));
    if !with_ray {
        pytest.args(["-m", "not ray"]);
    }
    tools::run(pytest.current_dir(&project.root).env("PYTHONDONTWRITEBYTECODE", "1"))
}
