//! Every test there is. All suites run even when one fails; a summary tells what ran, and how long it took.

use std::path::PathBuf;
use std::process::Command;
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Result, bail};

use crate::project::Project;
use crate::tally::{self, Tally};
use crate::{budget, chromium, corpora, engines, lane, licences, models, npm, package, readers, site, tools};

/// One kind of test.
struct Suite {
    name: &'static str,
    lane: Lane,
    needs: Needs,
    run: fn(&Project) -> Result<Outcome>,
}

/// What runs one after the other; the two lanes run side by side.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Lane {
    /// The compiler for this machine, and what it makes.
    Native,
    /// The modules, the site, and browsers.
    Web,
}

/// What must be there before a suite runs.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Needs {
    Nothing,
    /// The packages of www.
    Packages,
    /// The modules of the page, which have their types.
    Modules,
    /// The built site.
    Site,
}

/// How a suite ended: its count of tests, if its runner tells, and whether all was well.
type Outcome = (Tally, bool);

const SUITES: &[Suite] = &[
    Suite { name: "format", lane: Lane::Native, needs: Needs::Packages, run: format },
    Suite { name: "lint", lane: Lane::Native, needs: Needs::Packages, run: lint },
    Suite {
        name: "licences",
        lane: Lane::Native,
        needs: Needs::Nothing,
        run: |project| checked(licences::check(project)),
    },
    Suite { name: "rust", lane: Lane::Native, needs: Needs::Nothing, run: rust },
    Suite { name: "docs", lane: Lane::Native, needs: Needs::Nothing, run: docs },
    Suite { name: "corpora", lane: Lane::Native, needs: Needs::Nothing, run: corpora::check },
    Suite {
        name: "models",
        lane: Lane::Web,
        needs: Needs::Nothing,
        run: |project| checked(models::make(project)),
    },
    Suite {
        name: "build",
        lane: Lane::Web,
        needs: Needs::Packages,
        run: |project| checked(site::build(project, crate::wasm::Purpose::Publish)),
    },
    Suite {
        name: "size",
        lane: Lane::Web,
        needs: Needs::Modules,
        run: |project| checked(budget::check(project)),
    },
    Suite { name: "types", lane: Lane::Web, needs: Needs::Modules, run: types },
    // The document that the page edits is the core's.
    Suite { name: "unit", lane: Lane::Web, needs: Needs::Modules, run: unit },
    Suite { name: "wasm", lane: Lane::Web, needs: Needs::Modules, run: wasm },
    Suite { name: "page", lane: Lane::Web, needs: Needs::Site, run: page },
    Suite { name: "engines", lane: Lane::Web, needs: Needs::Site, run: engines },
    Suite { name: "package", lane: Lane::Web, needs: Needs::Modules, run: package::check },
];

/// The packages of the engine. What these and xtask share of libraries would be compiled once more, with the features of
/// both, if they were built by one command.
pub const ENGINE: [&str; 5] = ["--workspace", "--exclude", "xtask", "--features", CLI];

/// Without it there is no command line.
pub const CLI: &str = "inkpanel/cli";

/// The examples of stages, and what each is given.
const STAGES: [(&str, &[&str]); 7] = [
    ("raster", &["PHOTO", "OUT.png"]),
    ("select", &["PHOTO", "PHOTO"]),
    ("detect", &["www/models", "PHOTO"]),
    ("layout", &["cinema-4"]),
    ("framing", &["cinema-4", "PHOTO"]),
    ("style", &["PHOTO", "OUT.png"]),
    ("page", &["OUT.png", "PHOTO"]),
];

/// Runs the suites of these names, or all, and prints the summary.
///
/// # Errors
/// When a name is unknown or anything failed.
pub fn run(project: &Project, names: &[String]) -> Result<()> {
    if let Some(unknown) = names.iter().find(|name| SUITES.iter().all(|suite| suite.name != **name)) {
        let known: Vec<_> = SUITES.iter().map(|suite| suite.name).collect();
        bail!("no suite is called {unknown}; there are {}", known.join(", "));
    }
    let start = Instant::now();
    let wanted: Vec<_> = SUITES
        .iter()
        .filter(|suite| names.is_empty() || names.iter().any(|name| name == suite.name))
        .collect();
    // Both lanes read the nets, and one of them writes what is missing.
    models::make_or_warn(project);
    if wanted.iter().any(|suite| suite.needs != Needs::Nothing) {
        npm::install(project)?;
    }
    let lane = |lane: Lane| {
        let suites: Vec<_> = wanted.iter().copied().filter(|suite| suite.lane == lane).collect();
        run_lane(project, &suites)
    };
    let lines = thread::scope(|scope| {
        let native = scope.spawn(|| lane(Lane::Native));
        let mut lines = lane(Lane::Web);
        let lost = || vec![("lane", Tally { failed: 1, ..Tally::default() }, start.elapsed())];
        lines.extend(native.join().unwrap_or_else(|_| lost()));
        lines
    });
    let sum = |of: fn(&Tally) -> usize| lines.iter().map(|(_, tally, _)| of(tally)).sum::<usize>();
    let (passed, failed) = (sum(|tally| tally.passed), sum(|tally| tally.failed));
    println!();
    for (name, tally, _) in &lines {
        for failure in &tally.failures {
            println!("{name:<10}failed: {failure}");
        }
    }
    for (name, tally, took) in &lines {
        println!("{}", line(name, tally, *took));
    }
    println!("all in {:.1} min", start.elapsed().as_secs_f64() / 60.0);
    println!("{passed} passed, {failed} failed");
    if failed > 0 {
        bail!("some tests failed");
    }
    Ok(())
}

/// Runs suites one after the other; what one of them needs and no suite before it built is built first.
fn run_lane(project: &Project, suites: &[&Suite]) -> Vec<(&'static str, Tally, Duration)> {
    let mut built = None;
    let mut lines = Vec::new();
    for suite in suites {
        let start = Instant::now();
        let result = lane::named(suite.name, || {
            lane::say("begins");
            match (suite.needs, built) {
                (Needs::Modules | Needs::Site, Some(false)) => {
                    bail!("not run, as the site was not built")
                }
                (Needs::Modules, None) => site::build_modules(project, crate::wasm::Purpose::Publish)?,
                (Needs::Site, None) => site::build(project, crate::wasm::Purpose::Publish)?,
                _ => {}
            }
            (suite.run)(project)
        });
        let tally = judge(result);
        if suite.name == "build" {
            built = Some(tally.failed == 0);
        }
        let line = line(suite.name, &tally, start.elapsed());
        println!("{line}");
        lines.push((suite.name, tally, start.elapsed()));
    }
    lines
}

/// The count of a suite; one without a count of its own is one check, and a failure that no test explains
/// counts as one.
fn judge(result: Result<Outcome>) -> Tally {
    match result {
        Ok((tally, true)) if tally.failed == 0 => Tally { passed: tally.passed.max(1), ..tally },
        Ok((tally, _)) => Tally { failed: tally.failed.max(1), ..tally },
        Err(error) => {
            println!("{error:#}");
            Tally { failed: 1, ..Tally::default() }
        }
    }
}

fn line(name: &str, tally: &Tally, took: Duration) -> String {
    let verdict = if tally.failed == 0 { "ok" } else { "FAILED" };
    format!(
        "{name:<10}{verdict:<8}{:>7.1} s{:>6} passed{:>4} failed",
        took.as_secs_f64(),
        tally.passed,
        tally.failed
    )
}

/// The outcome of a check without a count.
fn checked(result: Result<()>) -> Result<Outcome> {
    result.map(|()| (Tally::default(), true))
}

fn format(project: &Project) -> Result<Outcome> {
    tools::run(project.cargo().args(["fmt", "--all", "--check"]))?;
    checked(tools::run(biome(project).arg("format")))
}

/// What formats and lints the page's sources; `biome.jsonc` has its rules.
fn biome(project: &Project) -> Command {
    let mut biome = npm::tool(project, "@biomejs/biome/bin/biome");
    biome.current_dir(&project.root);
    biome
}

/// Clippy for this machine and, as it is compiled nowhere else, the web boundaries for wasm; Biome for the page.
fn lint(project: &Project) -> Result<Outcome> {
    let strict = ["--", "-D", "warnings"];
    let all = ["--workspace", "--all-targets", "--features", CLI];
    // As programs of others have it.
    let facade = ["--package", "inkpanel", "--package", "inkpanel-pixels", "--lib", "--no-default-features"];
    for choice in [&all[..], &facade] {
        tools::run(project.cargo().arg("clippy").args(choice).args(strict))?;
    }
    crate::wasm::install_target()?;
    let nets = ["--package", "inkpanel-detectors"];
    let core = ["--package", "inkpanel", "--lib", "--features", "core"];
    // What comes later is linted together: each by itself is compiled by the suite `build`.
    let later =
        ["--package", "inkpanel", "--lib", "--features", "brush,decoders,exports,films,imitation,words"];
    for choice in [&nets[..], &core, &later] {
        let mut web = project.cargo();
        web.arg("clippy").args(choice).args(["--target", crate::wasm::TARGET]).args(strict);
        tools::run(&mut web)?;
    }
    checked(tools::run(biome(project).args(["lint", "--diagnostic-level=error"])))
}

/// The crate's documentation, in which a link that leads nowhere is an error, and its examples of stages.
fn docs(project: &Project) -> Result<Outcome> {
    let mut cargo = project.cargo();
    cargo.args(["doc", "--workspace", "--no-deps", "--quiet"]).env("RUSTDOCFLAGS", "-D warnings");
    tools::run(&mut cargo)?;
    models::make(project)?;
    // As the suite `rust` builds them.
    tools::run(project.cargo().arg("build").args(ENGINE).args(["--examples", "--quiet"]))?;
    let photo = "www/public/samples/19-astronaut.jpg";
    let drawn = project.target.join("stage.png");
    for (stage, given) in STAGES {
        let example = format!("debug/examples/stage_{stage}{}", std::env::consts::EXE_SUFFIX);
        let mut example = Command::new(project.target.join(example));
        let given = given.iter().map(|word| match *word {
            "PHOTO" => photo.as_ref(),
            "OUT.png" => drawn.as_os_str(),
            other => other.as_ref(),
        });
        tools::run(example.args(given).current_dir(&project.root))?;
    }
    checked(Ok(()))
}

fn rust(project: &Project) -> Result<Outcome> {
    let mut tests = project.cargo();
    tests.arg("test").args(ENGINE).arg("--no-fail-fast");
    // Without them the test that needs them says that it is left out.
    match npm::install_ace(project).and_then(|()| chromium::find()) {
        Ok(browser) => {
            tests.env("CHROMIUM", browser);
        }
        Err(error) => println!("EPUB files are not looked at by Ace: {error:#}"),
    }
    let (mut tally, well) = tally::count(&mut tests)?;
    let (own, own_well) =
        tally::count(project.cargo().args(["test", "--package", "xtask", "--no-fail-fast"]))?;
    tally += own;
    Ok((tally, well && own_well))
}

fn types(project: &Project) -> Result<Outcome> {
    checked(tools::run(npm::tool(project, "typescript/bin/tsc").arg("--noEmit")))
}

fn unit(project: &Project) -> Result<Outcome> {
    tally::count(npm::tool(project, "vitest/vitest.mjs").arg("run"))
}

/// The module in a browser against the same code on this machine.
fn wasm(project: &Project) -> Result<Outcome> {
    // As the suite `rust` builds it: another choice of packages would compile the libraries anew.
    tools::run(project.cargo().arg("test").args(ENGINE).args(["--no-run", "--quiet"]))?;
    let native = project.target.join("debug").join(format!("inkpanel{}", std::env::consts::EXE_SUFFIX));
    // The shell without windows ends where a module reads beyond its memory, in the place of a trap.
    let mut playwright = playwright(project, chromium::find()?);
    playwright.args(["--config", "../tests/web/wasm/playwright.config.js"]).env("INKPANEL", native);
    tally::count(&mut playwright)
}

/// The built site in a browser.
fn page(project: &Project) -> Result<Outcome> {
    let port = site::free_port(4187)?;
    readers::find()?;
    tally::count(playwright(project, chromium::shell()?).env("INKPANEL_TEST_PORT", port.to_string()))
}

/// The main ways through the built site in Chromium, Firefox and `WebKit`.
fn engines(project: &Project) -> Result<Outcome> {
    let port = site::free_port(4287)?;
    let mut playwright = playwright(project, chromium::find()?);
    engines::find(project, &mut playwright)?;
    playwright.args(["--config", "../tests/engines/playwright.config.js"]);
    tally::count(playwright.env("INKPANEL_TEST_PORT", port.to_string()))
}

fn playwright(project: &Project, browser: PathBuf) -> Command {
    let mut command = npm::tool(project, "@playwright/test/cli.js");
    command.arg("test").env("CHROMIUM", browser);
    command
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_is_never_counted_as_success() {
        let tally = |passed, failed| Tally { passed, failed, ..Tally::default() };
        assert_eq!(judge(Ok((tally(3, 0), true))), tally(3, 0));
        assert_eq!(judge(Ok((tally(0, 0), true))), tally(1, 0));
        assert_eq!(judge(Ok((tally(3, 0), false))), tally(3, 1));
        assert_eq!(judge(Ok((tally(3, 2), false))), tally(3, 2));
        assert_eq!(judge(Ok((tally(3, 2), true))), tally(3, 2));
        assert_eq!(judge(Err(anyhow::anyhow!("broken"))), tally(0, 1));
    }
}
