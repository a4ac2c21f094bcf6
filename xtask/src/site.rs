//! The site: wasm core and front end, built into www/dist as static files and served from there.

use std::net::TcpListener;
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail};

use crate::project::Project;
use crate::stamp::{Inputs, Stamp};
use crate::{models, npm, tools, wasm};

/// Builds everything that the page needs; each step is skipped when nothing it reads has changed.
pub(crate) fn build(project: &Project) -> Result<()> {
    npm::install(project)?;
    models::make_or_warn(project);
    wasm::build(project, &wasm::core(project))?;
    wasm::build(project, &wasm::detectors(project))?;
    wasm::build(project, &wasm::words(project))?;
    bundle(project)
}

/// Builds one module and nothing else.
pub(crate) fn build_module(project: &Project, name: &str) -> Result<()> {
    let modules = [wasm::core(project), wasm::words(project), wasm::detectors(project)];
    match modules.iter().find(|module| module.name == name) {
        Some(module) => wasm::build(project, module),
        None => bail!("there is no module {name}: it is one of core, words, detector"),
    }
}

/// Builds, then serves on 127.0.0.1 until interrupted.
pub(crate) fn serve(project: &Project, port: u16) -> Result<()> {
    build(project)?;
    let port = free_port(port)?;
    println!("Inkpanel: http://127.0.0.1:{port}/ (stop with Ctrl+C)");
    let mut server = Command::new("node");
    server.args(["serve.js", &port.to_string(), "/"]).current_dir(project.www()).stdout(Stdio::null());
    tools::run(&mut server)
}

fn bundle(project: &Project) -> Result<()> {
    let www = project.www();
    let mut inputs = Inputs::default();
    inputs.path(&www, &["node_modules", "dist"])?;
    let stamp = Stamp::new(project, "site", &inputs);
    if stamp.is_current(&www.join("dist/index.html")) {
        return Ok(());
    }
    tools::run(npm::tool(project, "vite/bin/vite.js").args(["build", "--logLevel", "warn"]))?;
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
