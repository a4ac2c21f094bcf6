//! The site: wasm core and front end, built into www/dist as static files and served from there.

use std::fs;
use std::net::TcpListener;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Instant;

use anyhow::{Context, Result, bail, ensure};

use crate::project::Project;
use crate::stamp::{Inputs, Stamp};
use crate::wasm::Purpose;
use crate::{letters, models, npm, tools, wasm};

/// Builds everything that the page needs, as it is published; each step is skipped when nothing it reads has changed.
pub(crate) fn build(project: &Project) -> Result<()> {
    fetch(project)?;
    build_modules(project)?;
    bundle(project, Nets::There)
}

/// The modules as they are published.
pub(crate) fn build_modules(project: &Project) -> Result<()> {
    wasm::build_all(project, &wasm::all(project), Purpose::Publish)
}

/// Whether the module of the nets is there when the front end is bundled.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Nets {
    There,
    Later,
}

/// What comes out of registries.
fn fetch(project: &Project) -> Result<()> {
    npm::install(project)?;
    models::make_or_warn(project);
    Ok(())
}

/// Builds one module and nothing else.
pub(crate) fn build_module(project: &Project, name: &str) -> Result<()> {
    letters::make(project)?;
    let modules = wasm::all(project);
    match modules.iter().find(|module| module.name == name) {
        Some(module) => wasm::build(project, module, Purpose::Publish),
        None => bail!(
            "there is no module {name}: it is one of core, decoders, words, exports, films, imitation, brush, detectors"
        ),
    }
}

/// Serves on 127.0.0.1 until interrupted: as soon as the page is there, while the module of the nets may still be built.
pub(crate) fn serve(project: &Project, port: u16) -> Result<()> {
    let start = Instant::now();
    wasm::install_target()?;
    letters::make(project)?;
    let [core, decoders, words, exports, films, imitation, brush, detectors] = wasm::all(project);
    let needed = [core, decoders, words, exports, films, imitation, brush];
    let stale: Vec<_> =
        needed.iter().filter(|module| !module.is_current(project, SERVE).unwrap_or(false)).collect();
    // What comes over the network takes hardly any of the compiler's time.
    thread::scope(|scope| {
        let fetched = scope.spawn(|| fetch(project));
        let compiled = stale.iter().try_for_each(|module| wasm::compile(project, module, SERVE));
        fetched.join().unwrap_or_else(|_| bail!("fetching panicked")).and(compiled)
    })?;
    stale.iter().try_for_each(|module| wasm::finish(project, module, SERVE))?;
    let nets = if detectors.is_current(project, SERVE)? { Nets::There } else { Nets::Later };
    bundle(project, nets)?;

    let port = free_port(port)?;
    let mut server = Command::new("node");
    server
        .args(["serve.js", &port.to_string(), "/", "headers"])
        .current_dir(project.www())
        .stdout(Stdio::null());
    let mut server = server.spawn().map_err(|error| tools::cannot_start(&server, &error))?;
    println!("Inkpanel: http://127.0.0.1:{port}/ (after {} s; stop with Ctrl+C)", start.elapsed().as_secs());
    if nets == Nets::Later {
        println!("What finds faces and objects is still being built; the page waits for it by itself.");
        match wasm::build(project, &detectors, SERVE).and_then(|()| fill_in(project, &detectors)) {
            Ok(()) => println!("It is there, after {} s.", start.elapsed().as_secs()),
            Err(error) => {
                let _ = LATER.map(|name| fs::remove_file(assets(project).join(name)));
                eprintln!("The page does without it: {error:#}");
            }
        }
    }
    ensure!(server.wait()?.success(), "the server stopped");
    Ok(())
}

const SERVE: Purpose = Purpose::Serve;

/// The files of the module of the nets in a site that was bundled before it was there. `nets-module.js` names them.
const LATER: [&str; 2] = ["nets-later.js", "nets-later.wasm"];

fn assets(project: &Project) -> PathBuf {
    project.www().join("dist/assets")
}

/// Gives the files that `serve.js` waits for their content, each at once.
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
    inputs.path(&www, &["node_modules", "dist"])?;
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

/// The first port from `first` on that nothing listens on.
pub(crate) fn free_port(first: u16) -> Result<u16> {
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
