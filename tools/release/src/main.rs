//! Makes a release, or checks that one can be made. `cargo xtask release` runs this program.

mod archive;
mod changelog;
mod compare;
mod release;
mod sbom;
mod versions;

use std::process::ExitCode;

use clap::Parser;
use xtask::project::Project;

use release::Extent;

/// Set the version, build everything twice, and write the files with their SHA-256 into target/release-VERSION
#[derive(Parser)]
#[command(name = "cargo xtask release", bin_name = "cargo xtask release")]
struct Arguments {
    /// Version, such as 0.2.0 [default: the version in Cargo.toml]
    version: Option<semver::Version>,
    /// Run all checks and change no file
    #[arg(long)]
    check: bool,
    /// Skip all builds
    #[arg(long, requires = "check")]
    quick: bool,
}

fn main() -> ExitCode {
    let Arguments { version, check, quick } = Arguments::parse();
    let extent = match (check, quick) {
        (false, _) => Extent::Release,
        (true, false) => Extent::Check,
        (true, true) => Extent::Quick,
    };
    match Project::locate().and_then(|project| release::run(&project, version.as_ref(), extent)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
