//! `cargo xtask release`: checks and packs a version. It either writes all files, or none and restores every
//! file of the checkout.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use semver::Version;
use tempfile::TempDir;
use time::{Date, OffsetDateTime};

use xtask::package::{self, notices};
use xtask::project::Project;
use xtask::{models, python, site, tools, wasm, wheel};

use crate::archive::{self, Archive, Kind};
use crate::versions::{self, Edit, Made};
use crate::{changelog, compare, sbom};

/// Maximum number of listed files that differ or are not committed.
const LISTED: usize = 20;

/// Scope of a release.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Extent {
    /// All of it.
    Release,
    /// Everything is built and compared, and thrown away.
    Check,
    /// Nothing is built.
    Quick,
}

/// Makes a release of the committed files, or checks that one can be made. Default version: the one in
/// Cargo.toml.
///
/// # Errors
/// When a check fails or something cannot be built. Then nothing is left over.
pub(crate) fn run(project: &Project, version: Option<&Version>, extent: Extent) -> Result<()> {
    clean(project)?;
    let current = versions::current(&project.root)?;
    let version = version.unwrap_or(&current);
    ensure!(*version >= current, "{version} is older than {current}, the version that Cargo.toml has");
    let made = project.target.join(format!("release-{version}"));
    if extent == Extent::Release {
        ensure!(!made.exists(), "{} already exists; move it first", made.display());
    }
    let told = fs::read_to_string(project.root.join("CHANGELOG.md")).context("cannot read CHANGELOG.md")?;
    let released = changelog::release(&told, version, OffsetDateTime::now_utc().date())?;
    let mut edits = versions::edits(&project.root, version)?;
    edits.extend(Edit::new(project.root.join("CHANGELOG.md"), told, released.text));
    locked(project)?;
    let parts = sbom::count(&sbom::json(project, version, released.day)?)?;
    println!(
        "{version}: changelog, versions and lock files are in order; {parts} parts of others, each with its licence"
    );
    if extent == Extent::Quick {
        return Ok(());
    }

    let edits = Made::make(if extent == Extent::Release { edits } else { Vec::new() })?;
    // On the same disk, so that it can be renamed in one step.
    fs::create_dir_all(&project.target)?;
    let folder = tempfile::Builder::new().prefix(".release-").tempdir_in(&project.target)?;
    write(project, version, released.day, folder.path())?;
    if extent == Extent::Check {
        println!("{version} can be released: both builds are the same, and everything can be packed");
        return Ok(());
    }
    readable(folder.path())?;
    fs::rename(folder.path(), &made).with_context(|| format!("cannot make {}", made.display()))?;
    // It has another name now.
    let _ = folder.keep();
    edits.keep();
    println!("{}: commit what changed, tag it v{version}, and publish these files", made.display());
    Ok(())
}

/// Fails if the checkout has uncommitted changes.
fn clean(project: &Project) -> Result<()> {
    let mut git = Command::new("git");
    let told = tools::output(git.args(["status", "--porcelain"]).current_dir(&project.root))?;
    let changed: Vec<_> = told.lines().collect();
    ensure!(
        changed.is_empty(),
        "a release contains only committed files: commit these, or remove them:\n{}",
        listed(&changed)
    );
    Ok(())
}

/// Returns some lines, and the number of the others.
fn listed(lines: &[impl AsRef<str>]) -> String {
    let mut shown: Vec<_> = lines.iter().take(LISTED).map(|line| format!("  {}", line.as_ref())).collect();
    if lines.len() > LISTED {
        shown.push(format!("  and {} more", lines.len() - LISTED));
    }
    shown.join("\n")
}

/// Fails if a lock file does not match its manifest.
fn locked(project: &Project) -> Result<()> {
    for manifest in ["Cargo.toml", "python/Cargo.toml"] {
        let mut cargo = project.cargo();
        cargo.args(["metadata", "--format-version", "1", "--locked", "--manifest-path", manifest]);
        tools::output(&mut cargo)
            .with_context(|| format!("the lock file of {manifest} is not up to date"))?;
    }
    Ok(())
}

/// Builds everything and writes the files of the release into `folder`.
fn write(project: &Project, version: &Version, day: Date, folder: &Path) -> Result<()> {
    // The versions may have changed since.
    locked(project)?;
    let time = u64::try_from(day.midnight().assume_utc().unix_timestamp()).context("a day before 1970")?;
    let host = sbom::host()?;
    models::make(project)?;
    for inkpanel_models::Part { file, .. } in inkpanel_models::parts() {
        ensure!(
            models::folder(project).join(file).is_file(),
            "the net {file} is missing, without which no release is whole: `cargo xtask models` says why"
        );
    }

    println!("the site, for the first time");
    site::build(project, wasm::Purpose::Publish)?;
    println!("the site, for the second time, from a copy in another place");
    same_twice(project)?;
    let name = format!("inkpanel-site-{version}");
    let mut archive = Archive::new(&name, time);
    archive.all(&project.www().join("dist"))?;
    licences(project, &mut archive, &notices::text(project, wasm::TARGET, &wasm::PACKAGES)?)?;
    fs::write(folder.join(format!("{name}.tar.gz")), archive.packed()?)?;

    println!("the package for npm");
    keep(&package::pack(project)?, folder)?;

    println!("the program for {host}");
    let program = program(project, &host)?;
    let name = format!("inkpanel-{version}-{host}");
    let mut archive = Archive::new(&name, time);
    archive.file(&format!("inkpanel{}", std::env::consts::EXE_SUFFIX), Kind::Program, &program)?;
    for file in ["README.md", "CHANGELOG.md"] {
        archive.file(file, Kind::Plain, &project.root.join(file))?;
    }
    licences(project, &mut archive, &notices::text(project, &host, &["inkpanel-cli"])?)?;
    fs::write(folder.join(format!("{name}.tar.gz")), archive.packed()?)?;

    match python::check() {
        Ok(()) => keep(&wheel::make(project, false, Some(time))?, folder)?,
        Err(error) => println!("the wheel is left out: {error:#}"),
    }
    fs::write(folder.join(format!("inkpanel-{version}.cdx.json")), sbom::json(project, version, day)?)?;
    fs::write(folder.join("SHA256SUMS"), archive::sums(folder)?)?;
    Ok(())
}

/// Copies a file that a step made.
fn keep(file: &Path, folder: &Path) -> Result<()> {
    let name = file.file_name().context("a file has a name")?;
    fs::copy(file, folder.join(name)).with_context(|| format!("cannot copy {}", file.display()))?;
    Ok(())
}

/// Adds the licences of this project and of compiled libraries to every archive.
fn licences(project: &Project, archive: &mut Archive, others: &str) -> Result<()> {
    for file in ["LICENSE-MIT", "LICENSE-APACHE"] {
        archive.file(file, Kind::Plain, &project.root.join(file))?;
    }
    archive.bytes("THIRD-PARTY.txt", Kind::Plain, others.as_bytes().to_vec());
    Ok(())
}

/// The command line for this machine, with no path of it inside.
fn program(project: &Project, host: &str) -> Result<PathBuf> {
    let mut cargo = project.cargo();
    cargo.args(["build", "--release", "--locked", "--bin", "inkpanel", "--target", host]);
    tools::run(cargo.args(["--config", &wasm::without_local_paths(project, host)]))?;
    let folder = project.target.join(host).join("release");
    Ok(folder.join(format!("inkpanel{}", std::env::consts::EXE_SUFFIX)))
}

/// Builds the site once more from a copy of its sources, and compares every byte.
fn same_twice(project: &Project) -> Result<()> {
    let (copy, _removed) = copy(project)?;
    site::build(&copy, wasm::Purpose::Publish)?;
    let differences = compare::folders(&project.www().join("dist"), &copy.www().join("dist"))?;
    if differences.is_empty() {
        return Ok(());
    }
    let lines: Vec<_> = differences.iter().map(ToString::to_string).collect();
    bail!("two builds of the same sources differ in {} files:\n{}", lines.len(), listed(&lines))
}

/// Returns a checkout in a separate folder: the committed files with the version set, and the models with
/// known checksums.
fn copy(project: &Project) -> Result<(Project, TempDir)> {
    let folder = tempfile::Builder::new().prefix("inkpanel-").tempdir()?;
    let root = folder.path().canonicalize()?;
    let mut git = Command::new("git");
    let tracked = tools::output(git.args(["ls-files", "-z"]).current_dir(&project.root))?;
    let nets = inkpanel_models::parts().into_iter().map(|part| format!("www/models/{}", part.file));
    for file in tracked.split_terminator('\0').map(str::to_owned).chain(nets) {
        let (from, to) = (project.root.join(&file), root.join(&file));
        fs::create_dir_all(to.parent().context("a file lies in a folder")?)?;
        copy_one(&from, &to).with_context(|| format!("cannot copy {file}"))?;
    }
    let target = root.join("target");
    Ok((Project::at(root, target), folder))
}

/// Copies a file. A link becomes its target within the checkout.
fn copy_one(from: &Path, to: &Path) -> Result<()> {
    #[cfg(unix)]
    if from.is_symlink() {
        return Ok(std::os::unix::fs::symlink(fs::read_link(from)?, to)?);
    }
    fs::copy(from, to)?;
    Ok(())
}

/// Temporary folders are readable only by their owner, so this makes the release readable by others.
fn readable(folder: &Path) -> Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        fs::set_permissions(folder, fs::Permissions::from_mode(0o755))?;
    }
    let _ = folder;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_lists_are_told_with_how_many_more() {
        let lines: Vec<_> = (0..LISTED + 3).map(|n| n.to_string()).collect();
        let told = listed(&lines);
        assert_eq!(told.lines().count(), LISTED + 1);
        assert!(told.ends_with("  and 3 more"), "{told}");
        assert_eq!(listed(&lines[..1]), "  0");
    }

    #[cfg(unix)]
    #[test]
    fn a_copy_has_what_is_tracked_and_the_nets_alone() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        let write = |path: &str| {
            let path = root.join(path);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, "x").unwrap();
        };
        for path in ["a/b.txt", ".gitignore", "left.txt"] {
            write(path);
        }
        for net in inkpanel_models::parts() {
            write(&format!("www/models/{}", net.file));
        }
        std::os::unix::fs::symlink("../a", root.join("a/link")).unwrap();
        let git = |words: &[&str]| {
            tools::output(Command::new("git").args(words).current_dir(root)).unwrap();
        };
        git(&["init", "--quiet"]);
        git(&["add", "a", ".gitignore"]);
        let (copy, kept) = copy(&Project::at(root.to_owned(), root.join("target"))).unwrap();
        assert!(copy.root.join("a/link").is_symlink());
        fs::remove_file(copy.root.join("a/link")).unwrap();
        let nets = inkpanel_models::parts().into_iter().map(|net| format!("www/models/{}", net.file));
        let expected = [".gitignore", "a/b.txt"].map(str::to_owned).into_iter().chain(nets);
        assert_eq!(compare::files(&copy.root).unwrap(), expected.collect());
        assert_eq!(copy.target, copy.root.join("target"));
        drop(kept);
        assert!(!copy.root.exists());
    }

    #[test]
    fn what_is_not_committed_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let git = |words: &[&str]| {
            tools::output(Command::new("git").args(words).current_dir(folder.path())).unwrap();
        };
        git(&["init", "--quiet"]);
        let project = Project::at(folder.path().to_owned(), folder.path().join("target"));
        clean(&project).unwrap();
        fs::write(folder.path().join("new.txt"), "").unwrap();
        let told = clean(&project).unwrap_err().to_string();
        assert!(told.ends_with("remove them:\n  ?? new.txt"), "{told}");
    }
}
