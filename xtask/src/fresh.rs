//! The first command of the README on a fresh checkout: `cargo xtask serve` in a copy of the committed and new files, without
//! models and npm packages. The copy shares the compiled crates, so that the check takes a minute.

use std::collections::BTreeSet;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread;

use anyhow::{Context, Result, ensure};

use crate::project::Project;
use crate::{chromium, lane, npm, site, tools};

/// Begins the line in which `serve` prints the address of the page.
const ADDRESS: &str = "Inkpanel: ";

/// Starts `cargo xtask serve` in a fresh copy, and has a browser make a page with detected faces and download it.
///
/// # Errors
/// If `serve` ends before it serves the page, or if the browser test fails.
pub fn check(project: &Project) -> Result<crate::test::Outcome> {
    let browser = chromium::shell()?;
    let folder = tempfile::Builder::new().prefix("inkpanel-fresh-").tempdir()?;
    let root = folder.path().canonicalize()?;
    copy(project, &root)?;
    let mut serve = Command::new(crate::project::cargo());
    serve.args(["xtask", "serve", "--port", &site::free_port(4387)?.to_string()]).current_dir(&root);
    serve.env("CARGO_TARGET_DIR", &project.target).stdout(Stdio::piped());
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut serve, 0);
    let mut serve = Running(serve.spawn().map_err(|error| tools::cannot_start(&serve, &error))?);
    let address = serve.address()?;
    let mut playwright = npm::tool(project, "@playwright/test/cli.js");
    playwright.args(["test", "--config", "../tests/web/fresh/playwright.config.js"]);
    crate::tally::count(playwright.env("CHROMIUM", browser).env("INKPANEL_ADDRESS", address))
}

/// Copies the files that git tracks, and new files that it does not ignore. Cargo compares the times of change of files and
/// folders, so they are preserved.
fn copy(project: &Project, root: &Path) -> Result<()> {
    let mut git = Command::new("git");
    git.args(["ls-files", "-z", "--cached", "--others", "--exclude-standard"]).current_dir(&project.root);
    let mut folders = BTreeSet::new();
    for file in tools::output(&mut git)?.split_terminator('\0') {
        let (from, to) = (project.root.join(file), root.join(file));
        // A deleted file is still listed until the deletion is committed.
        let Ok(found) = from.symlink_metadata() else { continue };
        fs::create_dir_all(to.parent().context("a file is in a folder")?)?;
        #[cfg(unix)]
        if found.is_symlink() {
            std::os::unix::fs::symlink(fs::read_link(&from)?, &to)?;
            continue;
        }
        fs::copy(&from, &to).with_context(|| format!("cannot copy {file}"))?;
        fs::File::options().append(true).open(&to)?.set_modified(found.modified()?)?;
        folders.extend(Path::new(file).ancestors().skip(1).map(Path::to_owned));
    }
    // Windows cannot open a folder. There, the crates are compiled again.
    #[cfg(unix)]
    for folder in folders {
        let modified = project.root.join(&folder).metadata()?.modified()?;
        fs::File::open(root.join(&folder))?.set_modified(modified)?;
    }
    Ok(())
}

/// A server that ends with this value, together with the programs that it started.
struct Running(Child);

impl Running {
    /// Prints the output of the server up to its address, and returns the address.
    fn address(&mut self) -> Result<String> {
        let output = self.0.stdout.take().context("the output is piped")?;
        let mut lines = BufReader::new(output).lines();
        let mut address = None;
        for line in lines.by_ref() {
            let line = line?;
            lane::say(&line);
            if let Some(rest) = line.strip_prefix(ADDRESS) {
                address = rest.split(' ').next().map(str::to_owned);
                break;
            }
        }
        ensure!(address.is_some(), "`cargo xtask serve` ended before it served the page");
        // Its further output must not fill the pipe.
        thread::spawn(move || lines.map_while(Result::ok).for_each(|line| println!("serve    | {line}")));
        address.context("checked above")
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // The server runs Node and cargo, which would continue. They are in one process group.
        #[cfg(unix)]
        let _ = Command::new("kill").args(["-TERM", "--", &format!("-{}", self.0.id())]).status();
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}
