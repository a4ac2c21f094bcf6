//! The crate as wasm modules, the core and the detectors: cargo, then wasm-bindgen as a library (so its version is the one in Cargo.lock),
//! then wasm-opt from the npm package `binaryen`, and what it leaves to do.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};
use wasm_bindgen_cli_support::Bindgen;

use crate::project::Project;
use crate::stamp::{Inputs, Stamp};
use crate::{clamps, npm, tools};

/// What rustc calls the browser.
pub(crate) const TARGET: &str = "wasm32-unknown-unknown";

/// What wasm-opt may use. `.cargo/config.toml` turns the same features on for rustc.
const OPTIMISE: &[&str] = &[
    "--enable-simd",
    "--enable-bulk-memory",
    "--enable-nontrapping-float-to-int",
    "--enable-sign-ext",
    "--enable-mutable-globals",
    "--enable-reference-types",
    "--enable-multivalue",
    "--strip-debug",
    "--strip-producers",
];

/// One build of the crate for the browser.
pub(crate) struct Module {
    /// Name of the stamp.
    pub(crate) name: &'static str,
    /// Cargo features, without the default ones.
    pub(crate) features: &'static [&'static str],
    /// Cargo profile.
    pub(crate) profile: &'static str,
    /// What wasm-opt shall aim at: `-O3` speed, `-Oz` size.
    pub(crate) level: &'static str,
    /// Folder of `inkpanel.js`, `inkpanel.d.ts` and `inkpanel_bg.wasm`.
    pub(crate) folder: PathBuf,
}

/// The module that the page loads.
pub(crate) fn core(project: &Project) -> Module {
    fast("core", &[], project.www().join("pkg"))
}

/// The detectors, which the page loads after its first page is drawn. The time goes into tract's kernels, which the
/// profile compiles for speed; the rest is large.
pub(crate) fn detectors(project: &Project) -> Module {
    let folder = project.www().join("pkg-detector");
    Module { name: "detector", features: &["detect"], profile: "wasm-detect", level: "-Oz", folder }
}

/// The module of words and files, which a page loads when it first has words or becomes another file than PNG: small, as
/// nobody waits for what it does.
pub(crate) fn words(project: &Project) -> Module {
    let folder = project.www().join("pkg-words");
    Module { name: "words", features: &["words"], profile: "wasm-detect", level: "-Oz", folder }
}

/// The same with the benchmark's entry point.
pub(crate) fn bench(project: &Project) -> Module {
    fast("bench", &["bench"], project.target.join("bench/pkg"))
}

fn fast(name: &'static str, features: &'static [&'static str], folder: PathBuf) -> Module {
    Module { name, features, profile: "wasm", level: "-O3", folder }
}

/// Builds a module; the slow steps after cargo are skipped when its output is the same as last time. The npm
/// packages must be installed.
pub(crate) fn build(project: &Project, module: &Module) -> Result<()> {
    install_target()?;
    compile(project, module)?;
    let compiled = project.target.join(TARGET).join(module.profile).join("inkpanel.wasm");
    let mut inputs = Inputs::default();
    inputs.path(&compiled, &[])?.path(&project.www().join("node_modules/binaryen/package.json"), &[])?;
    inputs.path(&project.root.join("Cargo.lock"), &[])?.value(include_str!("wasm.rs"));
    inputs.value(include_str!("clamps.rs"));
    let stamp = Stamp::new(project, module.name, &inputs);
    let optimised = module.folder.join("inkpanel_bg.wasm");
    if stamp.is_current(&optimised) {
        return Ok(());
    }
    println!("wasm-bindgen and wasm-opt: {} module", module.name);
    let fresh = project.target.join("xtask").join(module.name);
    clear(&fresh)?;
    bind(&compiled, &fresh)?;
    optimise(project, &fresh.join("inkpanel_bg.wasm"), module.level)?;
    clear(&module.folder)?;
    for entry in fs::read_dir(&fresh)? {
        let entry = entry?;
        fs::copy(entry.path(), module.folder.join(entry.file_name()))?;
    }
    stamp.keep()
}

fn compile(project: &Project, module: &Module) -> Result<()> {
    tools::run(
        project
            .cargo()
            .args([
                "build",
                "--package",
                "inkpanel",
                "--lib",
                "--profile",
                module.profile,
                "--target",
                TARGET,
            ])
            .args(["--no-default-features", "--features", &module.features.join(",")])
            .args(["--config", &without_local_paths(project)]),
    )
}

/// Panic messages carry source paths; in what is published they start at the crate, not at someone's home.
fn without_local_paths(project: &Project) -> String {
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| Some(std::env::home_dir()?.join(".cargo")));
    let mut flags = vec![format!("--remap-path-prefix={}=inkpanel", project.root.display())];
    flags.extend(home.map(|home| format!("--remap-path-prefix={}=cargo", home.display())));
    format!("target.{TARGET}.rustflags={}", serde_json::json!(flags))
}

fn bind(compiled: &Path, folder: &Path) -> Result<()> {
    let mut bindgen = Bindgen::new();
    bindgen.input_path(compiled).web(true)?.typescript(true).omit_default_module_path(false);
    bindgen.generate(folder).context("wasm-bindgen")
}

fn optimise(project: &Project, module: &Path, level: &str) -> Result<()> {
    let optimised = module.with_extension("optimised");
    tools::run(
        npm::tool(project, "binaryen/bin/wasm-opt")
            .arg(level)
            .args(OPTIMISE)
            .arg(module)
            .arg("-o")
            .arg(&optimised),
    )?;
    let (clean, removed) = clamps::remove(&fs::read(&optimised)?)?;
    println!("needless clamps taken out: {removed}");
    fs::remove_file(&optimised)?;
    fs::write(module, clean).context("cannot replace the module by the optimised one")
}

/// An empty folder in place of whatever was there.
fn clear(folder: &Path) -> Result<()> {
    if folder.exists() {
        fs::remove_dir_all(folder).with_context(|| format!("cannot clear {}", folder.display()))?;
    }
    fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))
}

/// Rust's standard library for wasm. A distribution may bring it without rustup.
pub(crate) fn install_target() -> Result<()> {
    let sysroot = tools::output(Command::new("rustc").args(["--print", "sysroot"]))?;
    if Path::new(sysroot.trim()).join("lib/rustlib").join(TARGET).exists() {
        return Ok(());
    }
    println!("rustup target add {TARGET}");
    if let Err(error) = tools::run(Command::new("rustup").args(["target", "add", TARGET])) {
        bail!("Rust's wasm target is missing and cannot be added: {error}");
    }
    Ok(())
}
