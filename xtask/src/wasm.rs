//! Builds the wasm modules: cargo, then wasm-bindgen as a library (so its version is the one in Cargo.lock).
//! Published modules are also optimised by wasm-opt from the npm package `binaryen` and by `clamps`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

use anyhow::{Context, Result, bail};
use wasm_bindgen_cli_support::Bindgen;

use crate::project::Project;
use crate::stamp::{Inputs, Stamp};
use crate::{clamps, lane, letters, npm, tools};

/// Compiler target of the browser.
pub const TARGET: &str = "wasm32-unknown-unknown";

/// Packages of all modules.
pub const PACKAGES: [&str; 10] = [
    "inkpanel-brush",
    "inkpanel-core",
    "inkpanel-decoders",
    "inkpanel-detectors",
    "inkpanel-exports",
    "inkpanel-films",
    "inkpanel-heic",
    "inkpanel-imitation",
    "inkpanel-texts",
    "inkpanel-words",
];

/// Sources of the modules, in the top folder.
const SOURCES: [&str; 12] = [
    ".cargo/config.toml",
    "Cargo.lock",
    "Cargo.toml",
    "crates/detect",
    "crates/engine",
    "crates/image",
    "crates/model",
    "crates/style",
    "fonts",
    "layouts",
    "styles",
    "wasm",
];

/// CPU features for wasm-opt. `.cargo/config.toml` turns the same features on for rustc.
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

/// Who a module is built for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// For a local server: compiled on all cores, hardly slower at run time.
    Serve,
    /// Everyone: small and fast, whatever it takes.
    Publish,
}

/// Modules that one cargo call compiles. They use the same features of the libraries, which are then compiled once.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Group {
    /// The engine without rare image formats.
    Engine,
    /// The image crate with rare image formats.
    Rare,
    /// The image crate with the decoder of HEIC.
    Heic,
    /// The neural networks.
    Detectors,
}

/// One of the modules of the page: a crate of `wasm/`.
pub struct Module {
    /// Name of the stamp.
    pub name: &'static str,
    /// The crate.
    package: &'static str,
    /// Its features.
    features: &'static str,
    /// The modules that are compiled together.
    group: Group,
    /// Cargo profile of published modules.
    profile: &'static str,
    /// Optimisation goal of wasm-opt for published modules: `-O3` speed, `-Oz` size.
    level: &'static str,
    /// Folder of `inkpanel.js`, `inkpanel.d.ts` and `inkpanel_bg.wasm`.
    pub folder: PathBuf,
}

/// The module that the page loads.
pub fn core(project: &Project) -> Module {
    Module { name: "core", folder: project.www().join("pkg"), ..fast() }
}

/// The detectors, which the page loads after its first page is drawn. Most of the time is spent in tract's
/// kernels, which the profile compiles for speed. The rest is large.
pub fn detectors(project: &Project) -> Module {
    let folder = project.www().join("pkg-detector");
    Module { name: "detectors", package: "inkpanel-detectors", group: Group::Detectors, folder, ..small() }
}

/// The `words` module, loaded with the first text. Compiled for size, because speed does not matter.
pub fn words(project: &Project) -> Module {
    Module { name: "words", package: "inkpanel-words", folder: project.www().join("pkg-words"), ..small() }
}

/// The decoder of text files and the reader of subtitles, loaded with the first of them.
pub fn texts(project: &Project) -> Module {
    Module { name: "texts", package: "inkpanel-texts", folder: project.www().join("pkg-texts"), ..small() }
}

/// The module for file types other than PNG, loaded with the first such export.
pub fn exports(project: &Project) -> Module {
    let folder = project.www().join("pkg-exports");
    Module { name: "exports", package: "inkpanel-exports", folder, ..small() }
}

/// The decoders of rare photos, loaded with the first of them.
pub fn decoders(project: &Project) -> Module {
    let folder = project.www().join("pkg-decoders");
    Module { name: "decoders", package: "inkpanel-decoders", group: Group::Rare, folder, ..small() }
}

/// The decoder of HEIC photos, loaded with the first of them.
pub fn heic(project: &Project) -> Module {
    let folder = project.www().join("pkg-heic");
    Module { name: "heic", package: "inkpanel-heic", group: Group::Heic, folder, ..fast() }
}

/// The module that finds the shots of a video, loaded with the first video.
pub fn films(project: &Project) -> Module {
    Module { name: "films", package: "inkpanel-films", folder: project.www().join("pkg-films"), ..fast() }
}

/// The search for styles from a picture, loaded with the first such picture. Compiled for speed like the
/// core, because it tries hundreds of styles.
pub fn imitation(project: &Project) -> Module {
    let folder = project.www().join("pkg-imitation");
    Module { name: "imitation", package: "inkpanel-imitation", folder, ..fast() }
}

/// The mask editor, loaded with the first corrected mask. It draws while the brush moves.
pub fn brush(project: &Project) -> Module {
    Module { name: "brush", package: "inkpanel-brush", folder: project.www().join("pkg-brush"), ..fast() }
}

/// All modules of the page.
pub fn all(project: &Project) -> [Module; 10] {
    [
        core(project),
        decoders(project),
        words(project),
        texts(project),
        exports(project),
        films(project),
        heic(project),
        imitation(project),
        brush(project),
        detectors(project),
    ]
}

/// The core with the benchmark's entry point.
pub fn bench(project: &Project) -> Module {
    Module {
        name: "bench",
        features: "inkpanel-core/bench",
        folder: project.target.join("bench/pkg"),
        ..fast()
    }
}

fn fast() -> Module {
    let folder = PathBuf::new();
    Module {
        name: "",
        package: "inkpanel-core",
        features: "",
        group: Group::Engine,
        profile: "wasm",
        level: "-O3",
        folder,
    }
}

fn small() -> Module {
    Module { profile: "wasm-detect", level: "-Oz", ..fast() }
}

/// Builds the modules that are not current for this purpose, and the fonts of the page. The npm packages must be installed.
///
/// # Errors
/// If a module does not compile. The modules of other profiles are still built.
pub fn build_all(project: &Project, modules: &[Module], purpose: Purpose) -> Result<()> {
    letters::make(project)?;
    let stale = stale(project, modules, purpose);
    let mut by_profile: Vec<Vec<&Module>> = Vec::new();
    for module in stale {
        match by_profile.iter_mut().find(|group| module.profile(purpose) == group[0].profile(purpose)) {
            Some(group) => group.push(module),
            None => by_profile.push(vec![module]),
        }
    }
    // Cargo has one lock per profile, and the last steps of a module use one core.
    let lane = lane::name();
    let build = |group: &Vec<&Module>| {
        let all = || {
            compile(project, group, purpose)?;
            group.iter().try_for_each(|module| finish(project, module, purpose))
        };
        lane.map_or_else(all, |name| lane::named(name, all))
    };
    thread::scope(|scope| {
        let running: Vec<_> = by_profile.iter().map(|group| scope.spawn(|| build(group))).collect();
        running.into_iter().try_for_each(|one| one.join().unwrap_or_else(|_| bail!("a build panicked")))
    })
}

/// Builds a module unless it is current for this purpose. The npm packages must be installed.
pub fn build(project: &Project, module: &Module, purpose: Purpose) -> Result<()> {
    if module.is_current(project, purpose)? {
        return Ok(());
    }
    compile(project, &[module], purpose)?;
    finish(project, module, purpose)
}

/// Returns the modules that are not current for this purpose.
pub fn stale<'a>(project: &Project, modules: &'a [Module], purpose: Purpose) -> Vec<&'a Module> {
    modules.iter().filter(|module| !module.is_current(project, purpose).unwrap_or(false)).collect()
}

/// Compiles modules of one profile.
pub fn compile(project: &Project, modules: &[&Module], purpose: Purpose) -> Result<()> {
    install_target()?;
    for group in [Group::Engine, Group::Rare, Group::Heic, Group::Detectors] {
        let group: Vec<_> = modules.iter().filter(|module| module.group == group).collect();
        let Some(first) = group.first() else { continue };
        let mut cargo = project.cargo();
        cargo.args(["build", "--target", TARGET, "--profile", first.profile(purpose)]);
        for module in &group {
            cargo.args(["--package", module.package]);
        }
        let features: Vec<_> = group.iter().map(|module| module.features).filter(|f| !f.is_empty()).collect();
        if !features.is_empty() {
            cargo.args(["--features", &features.join(",")]);
        }
        if purpose == Purpose::Publish {
            cargo.args(["--config", &without_local_paths(project, TARGET)]);
        }
        tools::run(&mut cargo)?;
    }
    Ok(())
}

/// Makes a compiled module loadable, and reduces its size for publication.
pub fn finish(project: &Project, module: &Module, purpose: Purpose) -> Result<()> {
    let stamp = module.stamp(project, purpose)?;
    println!(
        "wasm-bindgen{}: {}",
        if purpose == Purpose::Publish { " and wasm-opt" } else { "" },
        module.name
    );
    let file = format!("{}.wasm", module.package.replace('-', "_"));
    let compiled = project.target.join(TARGET).join(module.profile(purpose)).join(file);
    // A change of the sources may not change the compiled code.
    let mut made = Inputs::default();
    made.path(&compiled, &[])?
        .value(module.level)
        .value(include_str!("wasm.rs"))
        .value(include_str!("clamps.rs"));
    made.value(module.profile(purpose)).path(&project.www().join("package-lock.json"), &[])?;
    let made = Stamp::new(project, &format!("{}-made", module.name), &made);
    if made.is_current(&module.folder.join("inkpanel_bg.wasm")) {
        return stamp.keep();
    }
    let fresh = project.target.join("xtask").join(module.name);
    clear(&fresh)?;
    bind(&compiled, &fresh)?;
    if purpose == Purpose::Publish {
        optimise(project, &fresh.join("inkpanel_bg.wasm"), module.level)?;
    }
    clear(&module.folder)?;
    for entry in fs::read_dir(&fresh)? {
        let entry = entry?;
        fs::copy(entry.path(), module.folder.join(entry.file_name()))?;
    }
    made.keep()?;
    stamp.keep()
}

impl Module {
    fn profile(&self, purpose: Purpose) -> &'static str {
        if purpose == Purpose::Serve { "wasm-serve" } else { self.profile }
    }

    /// Whether the module is there, for this purpose or a higher one, as its sources are now.
    pub fn is_current(&self, project: &Project, purpose: Purpose) -> Result<bool> {
        let module = self.folder.join("inkpanel_bg.wasm");
        let there = |purpose| -> Result<bool> { Ok(self.stamp(project, purpose)?.is_current(&module)) };
        Ok(there(Purpose::Publish)? || purpose == Purpose::Serve && there(purpose)?)
    }

    fn stamp(&self, project: &Project, purpose: Purpose) -> Result<Stamp> {
        let mut inputs = Inputs::default();
        for source in SOURCES {
            inputs.path(&project.root.join(source), &[])?;
        }
        inputs.value(self.package).value(self.features).value(self.profile(purpose)).value(self.level);
        inputs.value(include_str!("wasm.rs")).value(include_str!("clamps.rs"));
        inputs.path(&project.www().join("package-lock.json"), &[])?;
        Ok(Stamp::new(project, self.name, &inputs))
    }
}

/// Removes local folders from the source paths in panic messages of published modules.
pub fn without_local_paths(project: &Project, target: &str) -> String {
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| Some(std::env::home_dir()?.join(".cargo")));
    let mut flags = vec![format!("--remap-path-prefix={}=inkpanel", project.root.display())];
    flags.extend(home.map(|home| format!("--remap-path-prefix={}=cargo", home.display())));
    format!("target.{target}.rustflags={}", serde_json::json!(flags))
}

fn bind(compiled: &Path, folder: &Path) -> Result<()> {
    let mut bindgen = Bindgen::new();
    bindgen
        .input_path(compiled)
        .out_name("inkpanel")
        .web(true)?
        .typescript(true)
        .omit_default_module_path(false);
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
pub fn install_target() -> Result<()> {
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
