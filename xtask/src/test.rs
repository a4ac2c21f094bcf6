//! Every test there is. All suites run even when one fails; a summary tells what ran, and how long it took.

use std::process::Command;
use std::time::{Duration, Instant};

use anyhow::{Result, bail};

use crate::project::Project;
use crate::tally::{self, Tally};
use crate::{budget, chromium, corpora, licences, models, npm, package, poppler, site, tools};

/// One kind of test.
struct Suite {
    name: &'static str,
    needs_site: bool,
    run: fn(&Project) -> Result<Outcome>,
}

/// How a suite ended: its count of tests, if its runner tells, and whether all was well.
type Outcome = (Tally, bool);

const SUITES: &[Suite] = &[
    Suite { name: "format", needs_site: false, run: format },
    Suite { name: "lint", needs_site: false, run: lint },
    Suite { name: "licences", needs_site: false, run: |project| checked(licences::check(project)) },
    Suite { name: "models", needs_site: false, run: |project| checked(models::make(project)) },
    Suite { name: "rust", needs_site: false, run: rust },
    Suite { name: "docs", needs_site: false, run: docs },
    Suite { name: "build", needs_site: false, run: |project| checked(site::build(project)) },
    Suite { name: "size", needs_site: true, run: |project| checked(budget::check(project)) },
    Suite { name: "types", needs_site: true, run: types },
    Suite { name: "unit", needs_site: true, run: unit },
    Suite { name: "wasm", needs_site: true, run: wasm },
    Suite { name: "page", needs_site: true, run: page },
    Suite { name: "package", needs_site: false, run: package::check },
    Suite { name: "corpora", needs_site: false, run: corpora::check },
];

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
pub(crate) fn run(project: &Project, names: &[String]) -> Result<()> {
    if let Some(unknown) = names.iter().find(|name| SUITES.iter().all(|suite| suite.name != **name)) {
        let known: Vec<_> = SUITES.iter().map(|suite| suite.name).collect();
        bail!("no suite is called {unknown}; there are {}", known.join(", "));
    }
    let wanted = |suite: &Suite| names.is_empty() || names.iter().any(|name| name == suite.name);
    let site = SUITES.iter().any(|suite| wanted(suite) && suite.needs_site);
    let mut built = true;
    let mut total = Tally::default();
    let mut lines = Vec::new();
    for suite in SUITES.iter().filter(|suite| wanted(suite) || site && suite.name == "build") {
        println!("\n== {}", suite.name);
        let start = Instant::now();
        let result = if suite.needs_site && !built {
            Err(anyhow::anyhow!("not run, as the site was not built"))
        } else {
            (suite.run)(project)
        };
        let tally = judge(result);
        built &= suite.name != "build" || tally.failed == 0;
        total += tally;
        lines.push(line(suite.name, tally, start.elapsed()));
    }
    println!("\n{}\n{} passed, {} failed", lines.join("\n"), total.passed, total.failed);
    if total.failed > 0 {
        bail!("some tests failed");
    }
    Ok(())
}

/// The count of a suite; one without a count of its own is one check, and a failure that no test explains
/// counts as one.
fn judge(result: Result<Outcome>) -> Tally {
    match result {
        Ok((tally, true)) if tally.failed == 0 => Tally { passed: tally.passed.max(1), failed: 0 },
        Ok((tally, _)) => Tally { failed: tally.failed.max(1), ..tally },
        Err(error) => {
            println!("{error:#}");
            Tally { passed: 0, failed: 1 }
        }
    }
}

fn line(name: &str, tally: Tally, took: Duration) -> String {
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
    checked(tools::run(project.cargo().args(["fmt", "--all", "--check"])))
}

/// Clippy for this machine and, as it is compiled nowhere else, the web boundaries for wasm.
fn lint(project: &Project) -> Result<Outcome> {
    let strict = ["--", "-D", "warnings"];
    for choice in [&["--workspace"][..], &["--package", "inkpanel", "--no-default-features"]] {
        tools::run(project.cargo().arg("clippy").args(choice).arg("--all-targets").args(strict))?;
    }
    crate::wasm::install_target()?;
    for features in ["", "detect", "words"] {
        let web = [
            "clippy",
            "--package",
            "inkpanel",
            "--lib",
            "--no-default-features",
            "--target",
            crate::wasm::TARGET,
            "--features",
            features,
        ];
        tools::run(project.cargo().args(web).args(strict))?;
    }
    checked(Ok(()))
}

/// The crate's documentation, in which a link that leads nowhere is an error, and its examples of stages.
fn docs(project: &Project) -> Result<Outcome> {
    let mut cargo = project.cargo();
    cargo.args(["doc", "--workspace", "--no-deps", "--quiet"]).env("RUSTDOCFLAGS", "-D warnings");
    tools::run(&mut cargo)?;
    models::make(project)?;
    // As the suite `rust` builds them.
    tools::run(project.cargo().args(["build", "--workspace", "--examples", "--quiet"]))?;
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
    tally::count(project.cargo().args(["test", "--workspace", "--no-fail-fast"]))
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
    tools::run(project.cargo().args(["test", "--workspace", "--no-run", "--quiet"]))?;
    let native = project.target.join("debug").join(format!("inkpanel{}", std::env::consts::EXE_SUFFIX));
    let mut playwright = playwright(project)?;
    playwright.args(["--config", "../tests/web/wasm/playwright.config.js"]).env("INKPANEL", native);
    tally::count(&mut playwright)
}

/// The built site in a browser.
fn page(project: &Project) -> Result<Outcome> {
    let port = site::free_port(4187)?;
    poppler::find()?;
    tally::count(playwright(project)?.env("INKPANEL_TEST_PORT", port.to_string()))
}

fn playwright(project: &Project) -> Result<Command> {
    let mut command = npm::tool(project, "@playwright/test/cli.js");
    command.arg("test").env("CHROMIUM", chromium::find()?);
    Ok(command)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_is_never_counted_as_success() {
        let tally = |passed, failed| Tally { passed, failed };
        assert_eq!(judge(Ok((tally(3, 0), true))), tally(3, 0));
        assert_eq!(judge(Ok((tally(0, 0), true))), tally(1, 0));
        assert_eq!(judge(Ok((tally(3, 0), false))), tally(3, 1));
        assert_eq!(judge(Ok((tally(3, 2), false))), tally(3, 2));
        assert_eq!(judge(Ok((tally(3, 2), true))), tally(3, 2));
        assert_eq!(judge(Err(anyhow::anyhow!("broken"))), tally(0, 1));
    }
}
