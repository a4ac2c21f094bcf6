//! The site: wasm core and front end, built into www/dist as static files and served from there.

use std::fs;
use std::net::TcpListener;
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::Instant;

use anyhow::{Context, Result, bail, ensure};

use crate::project::Project;
use crate::stamp::{Inputs, Stamp};
use crate::wasm::Purpose;
use crate::{letters, models, npm, tools, wasm};

/// Builds the modules and the site for a purpose. A step is skipped if its inputs did not change.
///
/// # Errors
/// If a module does not compile, or the bundler fails.
pub fn build(project: &Project, purpose: Purpose) -> Result<()> {
    npm::install(project)?;
    models::make_or_warn(project);
    build_modules(project, purpose)?;
    bundle(project, Nets::There)
}

/// Builds all modules for a purpose.
///
/// # Errors
/// If a module does not compile.
pub fn build_modules(project: &Project, purpose: Purpose) -> Result<()> {
    wasm::build_all(project, &wasm::all(project), purpose)
}

/// Whether the detection module exists when the front end is bundled.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Nets {
    There,
    Later,
}

/// Builds one module and nothing else.
pub fn build_module(project: &Project, name: &str) -> Result<()> {
    letters::make(project)?;
    let modules = wasm::all(project);
    match modules.iter().find(|module| module.name == name) {
        Some(module) => wasm::build(project, module, Purpose::Publish),
        None => bail!(
            "there is no module {name}: it is one of core, decoders, words, texts, exports, films, heic, imitation, brush, detectors"
        ),
    }
}

/// Serves on 127.0.0.1 until interrupted. The page is served before the detector module is built.
///
/// # Errors
/// If the page cannot be built. Missing models or detectors are a warning: the page works without them.
pub fn serve(project: &Project, port: u16) -> Result<()> {
    let start = Instant::now();
    let (mut server, address) = start_serving(project, port)?;
    println!("Inkpanel: {address} (after {} s; stop with Ctrl+C)", start.elapsed().as_secs());
    match add_detectors(project) {
        Ok(false) => {}
        Ok(true) => println!("Face and object detection is ready, after {} s.", start.elapsed().as_secs()),
        Err(error) => eprintln!("warning: the page does not detect faces and objects: {error:#}"),
    }
    ensure!(server.wait()?.success(), "the server stopped");
    Ok(())
}

/// Builds the page without the detector module and starts the server. Returns it with the page's address.
///
/// # Errors
/// If the page cannot be built.
pub fn start_serving(project: &Project, port: u16) -> Result<(Child, String)> {
    let modules = wasm::all(project);
    let (detectors, needed) = modules.split_last().context("there are modules")?;
    letters::make(project)?;
    let stale = wasm::stale(project, needed, SERVE);
    // Downloads need little CPU time, so they run in parallel with the compiler.
    thread::scope(|scope| {
        let fetched = scope.spawn(|| npm::install(project).inspect(|()| models::make_or_warn(project)));
        let compiled = wasm::compile(project, &stale, SERVE);
        fetched.join().unwrap_or_else(|_| bail!("installing npm packages panicked")).and(compiled)
    })?;
    stale.iter().try_for_each(|module| wasm::finish(project, module, SERVE))?;
    bundle(project, if detectors.is_current(project, SERVE)? { Nets::There } else { Nets::Later })?;

    let port = free_port(port)?;
    let mut server = Command::new("node");
    server
        .args(["serve.js", &port.to_string(), "/", "headers"])
        .current_dir(project.www())
        .stdout(Stdio::null());
    let server = server.spawn().map_err(|error| tools::cannot_start(&server, &error))?;
    Ok((server, format!("http://127.0.0.1:{port}/")))
}

/// Builds the detector module and adds it to a site that was bundled without it. Returns false if the site
/// has it.
///
/// # Errors
/// If it cannot be built; the page then stops waiting for it.
pub fn add_detectors(project: &Project) -> Result<bool> {
    let detectors = wasm::detectors(project);
    if detectors.is_current(project, SERVE)? {
        return Ok(false);
    }
    let added = wasm::build(project, &detectors, SERVE).and_then(|()| fill_in(project, &detectors));
    if added.is_err() {
        let _ = LATER.map(|name| fs::remove_file(assets(project).join(name)));
    }
    added.map(|()| true)
}

const SERVE: Purpose = Purpose::Serve;

/// Placeholders of the detection module in a site that was bundled before the module was compiled.
/// `nets-module.js` names them.
const LATER: [&str; 2] = ["nets-later.js", "nets-later.wasm"];

fn assets(project: &Project) -> PathBuf {
    project.www().join("dist/assets")
}

/// Fills the placeholder files that `serve.js` waits for, each in one step.
fn fill_in(project: &Project, detectors: &wasm::Module) -> Result<()> {
    for (name, file) in LATER.iter().zip(["inkpanel.js", "inkpanel_bg.wasm"]) {
        let (part, whole) = (assets(project).join(format!("{name}.part")), assets(project).join(name));
        fs::copy(detectors.folder.join(file), &part)?;
        fs::rename(&part, &whole)?;
    }
    Ok(())
}

fn bundle(project: &Project, nets: Nets) -> Result<()> {
    let www = project.www();
    let mut inputs = Inputs::default();
    // Vite writes `strings/compiled`.
    inputs.path(&www, &["node_modules", "dist", "compiled"])?;
    inputs.value(if nets == Nets::Later { "later" } else { "there" });
    let stamp = Stamp::new(project, "site", &inputs);
    if stamp.is_current(&www.join("dist/index.html")) {
        return Ok(());
    }
    let mut vite = npm::tool(project, "vite/bin/vite.js");
    vite.args(["build", "--logLevel", "warn"]);
    if nets == Nets::Later {
        vite.env("INKPANEL_NETS", "later");
    }
    tools::run(&mut vite)?;
    stamp.keep()
}

/// Returns the first free port from `first` on.
pub fn free_port(first: u16) -> Result<u16> {
    (first..=first.saturating_add(99))
        .find(|port| TcpListener::bind(("127.0.0.1", *port)).is_ok())
        .with_context(|| format!("no free port from {first} on: choose another with --port"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_taken_port_is_passed_over() {
        let taken = TcpListener::bind(("127.0.0.1", 0)).unwrap();
        let port = taken.local_addr().unwrap().port();
        assert_ne!(free_port(port).unwrap(), port);
    }
}
