//! Tests of the documents: their `inkpanel` commands run, their examples exist, and their links lead to files.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Placeholder names in the commands, and the repository files for them.
const SAMPLES: [(&str, &str); 11] = [
    ("photos/1.jpg", "tests/photos/bee.jpg"),
    ("photos/2.jpg", "tests/photos/cat.jpg"),
    ("photos/3.jpg", "tests/photos/macaw.jpg"),
    ("photos/4.jpg", "tests/photos/horses.jpg"),
    ("photos/5.jpg", "tests/photos/pagoda.jpg"),
    ("photos/6.jpg", "tests/photos/wine.jpg"),
    ("photo.jpg", "tests/photos/raccoon.jpg"),
    ("picture.png", "docs/pages/noir.png"),
    ("film.mp4", "tests/videos/album.mp4"),
    ("font.ttf", "tests/oracles/data/fonts/japanese.ttf"),
    ("Trip.inkpanel", "tests/data/saved/version-1/storyboard.inkpanel"),
];
/// Languages of fenced blocks, and the files that they become in the folder of the commands.
const FILES: [(&str, &str); 2] = [("toml", "settings.toml"), ("json", "words.json")];
/// Width of the pages, in pixels, of commands without a width. Pages in print size would take most of the time of the test.
const WIDTH: u64 = 800;
/// Link to the forms for bugs and features, relative to the address of the repository.
const ISSUES: &str = "../../issues/new/choose";

/// Returns all Markdown files of the repository, relative to its top folder.
fn documents() -> Vec<PathBuf> {
    let mut git = Command::new("git");
    git.args(["ls-files", "-z", "--cached", "--others", "--exclude-standard", "*.md"])
        .current_dir(crate::root(""));
    let listed = String::from_utf8(git.output().unwrap().stdout).unwrap();
    let all = listed.split_terminator('\0').map(PathBuf::from);
    let files: Vec<PathBuf> = all.filter(|file| crate::root(file).is_file()).collect();
    assert!(files.len() > 20, "this test needs a git checkout");
    files
}

/// Returns the fenced blocks of a document with their languages.
fn blocks(text: &str) -> Vec<(&str, String)> {
    let mut found: Vec<(&str, String)> = Vec::new();
    let mut inside = false;
    for line in text.lines() {
        if let Some(language) = line.trim_start().strip_prefix("```") {
            inside = !inside;
            if inside {
                found.push((language.trim(), String::new()));
            }
        } else if inside && let Some((_, block)) = found.last_mut() {
            block.push_str(line);
            block.push('\n');
        }
    }
    found
}

/// Returns the commands of shell blocks.
fn commands(text: &str) -> Vec<String> {
    let shell = blocks(text).into_iter().filter(|(language, _)| ["sh", "console"].contains(language));
    shell
        .flat_map(|(_, block)| block.replace("\\\n", " ").lines().map(str::to_owned).collect::<Vec<_>>())
        .collect()
}

/// Returns a command with a page width, if it draws pages in print size. A thorough run draws them in print size.
fn with_small_pages(command: &str) -> String {
    // Projects and documents have a width.
    let is_small = |rest: &str| {
        let draws_photos = rest.contains(" photos/") && !rest.contains("--document");
        draws_photos && !rest.contains("--width") && crate::trials(0, 1) == 0
    };
    let small = ["inkpanel render ", "inkpanel book "].into_iter().find_map(|start| {
        let rest = command.strip_prefix(start).filter(|rest| is_small(rest))?;
        Some(format!("{start}--width {WIDTH} {rest}"))
    });
    small.unwrap_or_else(|| command.to_owned())
}

/// Runs the `inkpanel` commands of a document in a folder with the sample files. Returns their number and the errors.
fn run(document: &Path) -> (usize, Vec<String>) {
    let text = fs::read_to_string(crate::root(document)).unwrap();
    let commands = commands(&text).into_iter().filter(|command| command.starts_with("inkpanel "));
    let calls: Vec<String> = commands.map(|command| with_small_pages(&command)).collect();
    if calls.is_empty() {
        return (0, Vec::new());
    }
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("photos")).unwrap();
    for (name, file) in SAMPLES {
        fs::copy(crate::root(file), folder.path().join(name)).unwrap();
    }
    for (language, name) in FILES {
        if let Some((_, block)) = blocks(&text).into_iter().find(|(known, _)| *known == language) {
            fs::write(folder.path().join(name), block).unwrap();
        }
    }
    let programs = Path::new(env!("CARGO_BIN_EXE_inkpanel")).parent().unwrap();
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path =
        std::env::join_paths([programs.to_owned()].into_iter().chain(std::env::split_paths(&path))).unwrap();
    let mut errors = Vec::new();
    for call in &calls {
        let mut shell = Command::new("sh");
        let output = shell.args(["-c", call]).current_dir(folder.path()).env("PATH", &path).output().unwrap();
        if !output.status.success() {
            errors.push(format!(
                "{}: {call}\n{}",
                document.display(),
                String::from_utf8_lossy(&output.stderr)
            ));
        }
    }
    (calls.len(), errors)
}

#[cfg(unix)]
#[test]
fn commands_of_documents_run() {
    let guides = |file: &&PathBuf| file.starts_with("docs") || file.as_path() == Path::new("README.md");
    let documents = documents();
    let results: Vec<_> = std::thread::scope(|scope| {
        let started = documents.iter().filter(guides).map(|file| scope.spawn(move || run(file)));
        let started: Vec<_> = started.collect();
        started.into_iter().map(|run| run.join().unwrap()).collect()
    });
    let count: usize = results.iter().map(|(count, _)| count).sum();
    assert!(count > 40, "only {count} commands were found");
    let errors: Vec<String> = results.into_iter().flat_map(|(_, errors)| errors).collect();
    assert!(errors.is_empty(), "{} commands failed:\n{}", errors.len(), errors.join("\n"));
}

#[test]
fn examples_of_documents_exist() {
    let mut missing = Vec::new();
    for document in documents() {
        let text = fs::read_to_string(crate::root(&document)).unwrap();
        for name in text.split("--example ").skip(1).filter_map(|rest| rest.split([' ', '`', '\n']).next()) {
            let found = ["", "/main.rs", ".rs"]
                .iter()
                .any(|end| crate::root(format!("examples/{name}{end}")).is_file());
            if !found {
                missing.push(format!("{}: {name}", document.display()));
            }
        }
    }
    assert!(missing.is_empty(), "these examples do not exist:\n{}", missing.join("\n"));
}

/// Returns the targets of the links and pictures of a document.
fn links(text: &str) -> Vec<String> {
    let markdown = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    let html = text.split("src=\"").skip(1).filter_map(|rest| rest.split('"').next());
    markdown.chain(html).map(str::to_owned).collect()
}

/// Returns the anchors of the headings of a document, like GitHub makes them.
fn anchors(text: &str) -> BTreeSet<String> {
    let headings = text.lines().filter(|line| line.starts_with('#'));
    let anchor = |line: &str| -> String {
        let title = line.trim_start_matches('#').trim().to_lowercase();
        title
            .chars()
            .filter(|c| c.is_alphanumeric() || " -_".contains(*c))
            .map(|c| if c == ' ' { '-' } else { c })
            .collect()
    };
    headings.map(anchor).collect()
}

#[test]
fn links_of_documents_lead_to_files() {
    let mut broken = Vec::new();
    for document in documents() {
        let text = fs::read_to_string(crate::root(&document)).unwrap();
        let code: String = blocks(&text).into_iter().map(|(_, block)| block).collect();
        for link in links(&text) {
            if link.contains(':') || link.contains(' ') || link == ISSUES || code.contains(&link) {
                continue;
            }
            let (file, anchor) = link.split_once('#').unwrap_or((&link, ""));
            let target =
                if file.is_empty() { document.clone() } else { document.parent().unwrap().join(file) };
            let target = crate::root(target);
            let known = || anchors(&fs::read_to_string(&target).unwrap_or_default()).contains(anchor);
            if !target.exists() || !(anchor.is_empty() || known()) {
                broken.push(format!("{}: {link}", document.display()));
            }
        }
    }
    assert!(broken.is_empty(), "these links are broken:\n{}", broken.join("\n"));
}
