//! The benchmark: this project's blocks and the same operations by other libraries, in one browser session,
//! and the real page. JavaScript in `bench/` does the measuring. This module prepares its input.

use std::fs;
use std::process::Command;

use anyhow::Result;

use crate::project::Project;
use crate::{batch, chromium, engines, lighthouse, native, npm, site, tables, tools, wasm};

/// Results of earlier runs of `bench speed`, one JSON object per line.
const SPEED_HISTORY: &str = "docs/reports/speed-history.jsonl";

/// Builds everything, then measures, and writes the table of the reports and the numbers of the README. With words in `filter`, only matching rows are timed, and nothing is
/// written. The groups `page`, `album`, `films`, `making`, `masking`, `animatic`, `living`, `detect`,
/// `figures` and `masks` run if they are listed. `alone` skips the other libraries. `native`, `batch`,
/// `speed`, `engines` and `lighthouse` must be the only word.
pub fn run(project: &Project, filter: &[String], alone: bool) -> Result<()> {
    if filter == ["native"] {
        return native::run(project);
    }
    if filter == ["batch"] {
        return batch::run(project);
    }
    let browser = chromium::find()?;
    if filter == ["lighthouse"] {
        site::build(project, crate::wasm::Purpose::Publish)?;
        return lighthouse::check(project);
    }
    if filter == ["speed"] {
        site::build(project, crate::wasm::Purpose::Publish)?;
        npm::install_peers(project)?;
        let mut speed = Command::new("node");
        speed.arg("bench/speed.js").current_dir(&project.root).env("CHROMIUM", browser);
        speed.arg("--target").arg(&project.target).args(["--history", SPEED_HISTORY]);
        return tools::run(&mut speed);
    }
    if filter == ["engines"] {
        site::build(project, crate::wasm::Purpose::Publish)?;
        let mut playwright = npm::tool(project, "@playwright/test/cli.js");
        playwright.args(["test", "--config", "../bench/engines.config.js"]).env("CHROMIUM", browser);
        engines::find(project, &mut playwright)?;
        tools::run(playwright.env("INKPANEL_TARGET", &project.target))?;
        let table = fs::read_to_string(project.target.join("bench/engines.md"))?;
        println!("{table}");
        return tables::put(&project.root.join(tables::BENCHMARKS), "engines", &table);
    }
    // Rows need only the blocks; the site takes minutes.
    if filter.is_empty()
        || filter.iter().any(|word| {
            ["page", "album", "films", "making", "masking", "animatic", "living", "detect", "figures"]
                .contains(&word.as_str())
        })
    {
        site::build(project, crate::wasm::Purpose::Publish)?;
    } else {
        npm::install(project)?;
    }
    wasm::build(project, &wasm::bench(project), wasm::Purpose::Publish)?;
    npm::install_peers(project)?;
    let mut bench = Command::new("node");
    bench.arg("bench/run.js").current_dir(&project.root).env("CHROMIUM", browser);
    bench.arg("--target").arg(&project.target).args(alone.then_some("--alone"));
    tools::run(bench.arg("--").args(filter))
}
