//! The npm package: the engine of `www/engine`, its wasm modules, glyphs, models and types, as files for a
//! static server. `www/package` has the files that are only in the package.

pub mod notices;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use serde_json::{Value, json};

use crate::project::Project;
use crate::tally::{self, Tally};
use crate::{chromium, letters, models, npm, tools, wasm};

const NAME: &str = "inkpanel";
/// The entry point without its extension: a module and its types.
const ENTRY: &str = "engine/index";
/// The library for reading videos is one module, under MPL 2.0. It is a separate, unchanged file.
const FILM_LIBRARY: (&str, &str) = ("mediabunny", "dist/bundles/mediabunny.min.mjs");
/// The modules that import it.
const FILM_READERS: [&str; 3] = ["video-worker.js", "film-looks.js", "sound-worker.js"];
/// The folders that are published.
const FOLDERS: [&str; 15] = [
    "engine",
    "pkg",
    "pkg-decoders",
    "pkg-heic",
    "pkg-texts",
    "pkg-words",
    "pkg-exports",
    "pkg-films",
    "pkg-imitation",
    "pkg-brush",
    "pkg-detector",
    "letters",
    "models",
    "vendor",
    "licences",
];

/// Builds the package and prints its path.
///
/// # Errors
/// When a part cannot be built.
pub fn make(project: &Project) -> Result<()> {
    let folder = build(project)?;
    println!("{}: publish it with `npm publish`, or try it with `npm install FOLDER`", folder.display());
    Ok(())
}

/// Builds the package below `target/package`.
fn build(project: &Project) -> Result<PathBuf> {
    npm::install(project)?;
    models::make(project)?;
    let modules = wasm::all(project);
    wasm::build_all(project, &modules, wasm::Purpose::Publish)?;
    let folder = project.target.join("package").join(NAME);
    if folder.exists() {
        fs::remove_dir_all(&folder)?;
    }
    for part in FOLDERS {
        fs::create_dir_all(folder.join(part))?;
    }
    for module in &modules {
        let name = module.folder.file_name().context("a module has a folder")?;
        copy_all(&module.folder, &folder.join(name), |_| true)?;
        without_disposal(&folder.join(name).join("inkpanel.d.ts"))?;
    }
    copy_all(&letters::folder(project), &folder.join("letters"), |_| true)?;
    engine(project, &folder)?;
    papers(project, &folder)?;
    fs::write(folder.join("package.json"), format!("{:#}\n", manifest(project)?))?;
    Ok(folder)
}

/// Removes the `Symbol.dispose` members for `using` from the types of a module, because older TypeScript
/// libraries lack this symbol.
fn without_disposal(types: &Path) -> Result<()> {
    let text = fs::read_to_string(types)?;
    let kept: String = text.split_inclusive('\n').filter(|line| !line.contains("[Symbol.dispose]")).collect();
    Ok(fs::write(types, kept)?)
}

/// The engine's modules, replacements from the package, the video library and the models.
fn engine(project: &Project, folder: &Path) -> Result<()> {
    let (www, out) = (project.www(), folder.join("engine"));
    compile(project, folder)?;
    copy_all(&www.join("package"), &out, is_script)?;
    let (library, bundle) = FILM_LIBRARY;
    let installed = www.join("node_modules").join(library);
    copy(&installed.join(bundle), &folder.join(format!("vendor/{library}.js")))?;
    copy(&installed.join("LICENSE"), &folder.join(format!("licences/{library}-MPL.txt")))?;
    // Browsers cannot resolve package names.
    for reader in FILM_READERS.map(|file| out.join(file)) {
        let text = fs::read_to_string(&reader)?;
        let named = format!("from '{library}'");
        let shown = reader.display();
        ensure!(text.matches(&named).count() == 1, "{shown} imports {library} in another way");
        fs::write(&reader, text.replace(&named, &format!("from '../vendor/{library}.js'")))?;
    }
    for net in ["faces.onnx", "objects.onnx", "painters.onnx", "landmarks.onnx"] {
        let file = models::folder(project).join(net);
        // The landmark model is optional.
        if net != "landmarks.onnx" || file.exists() {
            copy(&file, &folder.join("models").join(net))?;
        }
    }
    copy(&models::folder(project).join("README.md"), &folder.join("licences/models.md"))
}

/// The engine's modules as JavaScript with type declarations next to them.
fn compile(project: &Project, folder: &Path) -> Result<()> {
    let mut tsc = npm::tool(project, "typescript/bin/tsc");
    tools::run(tsc.args(["--project", "package", "--outDir"]).arg(folder))?;
    for entry in fs::read_dir(folder.join("engine"))? {
        let file = entry?.path();
        if file.is_file() {
            // The compiler rewrites imports, but neither the URLs of workers nor type imports.
            let text = fs::read_to_string(&file)?.replace(".ts', import.meta.url", ".js', import.meta.url");
            let types = file.to_string_lossy().ends_with(".d.ts");
            let named = if types { text.replace(".ts'", ".js'").replace(".ts\"", ".js\"") } else { text };
            fs::write(&file, named)?;
        }
    }
    ensure!(folder.join(format!("{ENTRY}.d.ts")).is_file(), "tsc left no types");
    Ok(())
}

/// Documents: README and licences.
fn papers(project: &Project, folder: &Path) -> Result<()> {
    for file in ["README.md", "example.html"] {
        copy(&project.www().join("package").join(file), &folder.join(file))?;
    }
    for file in ["LICENSE-MIT", "LICENSE-APACHE"] {
        copy(&project.root.join(file), &folder.join(file))?;
    }
    copy_all(&project.root.join("fonts"), &folder.join("licences"), |name| name.ends_with("-OFL.txt"))?;
    fs::write(folder.join("THIRD-PARTY.txt"), notices::text(project, wasm::TARGET, &wasm::PACKAGES)?)?;
    Ok(())
}

/// The package's manifest; name, version and description are the crate's.
fn manifest(project: &Project) -> Result<Value> {
    let mut cargo = project.cargo();
    let metadata =
        tools::output(cargo.args(["metadata", "--format-version", "1", "--no-deps", "--offline"]))?;
    let metadata: Value = serde_json::from_str(&metadata)?;
    let mut packages = metadata["packages"].as_array().into_iter().flatten();
    let package = packages.find(|package| package["name"] == NAME).context("the crate is not there")?;
    let mut files: Vec<String> = FOLDERS.iter().map(|folder| format!("{folder}/")).collect();
    files.extend(["LICENSE-MIT", "LICENSE-APACHE", "THIRD-PARTY.txt", "example.html"].map(str::to_owned));
    Ok(json!({
        "name": NAME,
        "version": package["version"],
        "description": package["description"],
        "keywords": package["keywords"],
        "license": package["license"],
        "type": "module",
        // TypeScript expects the types next to the module.
        "exports": {
            ".": {
                "types": format!("./{ENTRY}.d.ts"),
                "node": "./engine/node.js",
                "default": format!("./{ENTRY}.js"),
            },
            // Defines the element `inkpanel-page`.
            "./element": {
                "types": "./engine/page-element.d.ts",
                "default": "./engine/page-element.js",
            },
            "./package.json": "./package.json",
        },
        "types": format!("./{ENTRY}.d.ts"),
        // A worker begins by listening; all other modules only export.
        "sideEffects": ["./engine/worker.js", "./engine/*-worker.js", "./engine/node*.js", "./engine/page-element.js"],
        "files": files,
    }))
}

/// Builds the package, packs it and prints the path of the file. npm sets one time for all entries.
///
/// # Errors
/// When a part cannot be built, or npm does not pack it.
pub fn pack(project: &Project) -> Result<PathBuf> {
    let folder = build(project)?;
    let mut pack = Command::new(npm::program());
    pack.args(["pack", "--silent", "--pack-destination", ".."]).current_dir(&folder);
    Ok(project.target.join("package").join(tools::output(&mut pack)?.trim()))
}

/// Packs the package, and tests it in a browser as another project installs it.
///
/// # Errors
/// When the package cannot be built or packed.
pub fn check(project: &Project) -> Result<(Tally, bool)> {
    let tarball = pack(project)?;
    println!("{}: {} bytes", tarball.display(), fs::metadata(&tarball)?.len());
    // As the suite `rust` builds it.
    tools::run(
        project.cargo().arg("test").args(crate::test::ENGINE).args(["--test", "it", "--no-run", "--quiet"]),
    )?;
    let native = project.target.join("debug").join(format!("inkpanel{}", std::env::consts::EXE_SUFFIX));
    let mut playwright = npm::tool(project, "@playwright/test/cli.js");
    playwright.args(["test", "--config", "../tests/web/package/playwright.config.js"]);
    playwright.env("CHROMIUM", chromium::find()?).env("INKPANEL", native).env("INKPANEL_PACKAGE", tarball);
    tally::count(&mut playwright)
}

fn is_script(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|extension| extension == "js")
}

/// Copies the selected files of a folder, without subfolders.
fn copy_all(from: &Path, to: &Path, wanted: impl Fn(&str) -> bool) -> Result<()> {
    for entry in fs::read_dir(from).with_context(|| format!("cannot list {}", from.display()))? {
        let path = entry?.path();
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        if path.is_file() && wanted(name) {
            copy(&path, &to.join(name))?;
        }
    }
    Ok(())
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    fs::copy(from, to).map(|_| ()).with_context(|| format!("cannot copy {}", from.display()))
}
