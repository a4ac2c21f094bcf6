//! Updates stored expectations with the current output, by topic.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::project::Project;
use crate::tools;

/// Files that are stored together, and the tests that write them.
struct Topic {
    name: &'static str,
    /// A file of `tests/it/` without its extension, or [`LIBRARY`], and the test in it that writes if `BLESS` is set.
    tests: &'static [(&'static str, &'static str)],
    /// Files, and folders with all that is in them.
    stored: &'static [&'static str],
}

/// Instead of a file of `tests/it/`: the unit tests of the library, which generate the TypeScript types.
const LIBRARY: &str = "lib";

const TOPICS: &[Topic] = &[
    Topic {
        name: "goldens",
        tests: &[
            ("goldens", "a_page_of_each_family_of_layouts_looks_as_it_did"),
            ("goldens", "every_designed_style_looks_as_it_did"),
            ("words", "a_page_of_words_looks_as_it_did"),
            ("lettering", "a_page_by_a_letterer_looks_as_it_did"),
        ],
        stored: &["tests/goldens"],
    },
    Topic {
        name: "tables",
        tests: &[
            ("catalogue", "the_readme_of_the_styles_lists_the_blocks_as_they_are"),
            ("designed_styles", "the_readme_lists_the_families_as_they_are"),
        ],
        stored: &["styles/README.md"],
    },
    Topic {
        name: "bounds",
        tests: &[
            ("bounds", "the_page_has_the_bounds_of_the_core"),
            ("bounds", "the_page_begins_with_the_project_of_the_core"),
            ("bounds", "the_page_has_the_kinds_of_files_of_the_core"),
            ("bounds", "python_has_the_types_of_the_page_settings"),
        ],
        stored: &[
            "www/engine/bounds.ts",
            "www/document/empty.ts",
            "www/engine/file-table.ts",
            "python/inkpanel/__init__.pyi",
        ],
    },
    Topic {
        name: "shots",
        tests: &[("shots", "lists_are_those_that_were_read")],
        stored: &["tests/oracles/data/shots"],
    },
    Topic {
        name: "types",
        tests: &[
            (LIBRARY, "typescript::the_page_has_the_types_of_the_core"),
            (LIBRARY, "typescript::what_the_core_writes_is_there_for_the_compiler"),
        ],
        stored: &["www/engine/types.ts", "www/engine/types-written.ts"],
    },
];

/// Updates the topics with these names, or all topics.
///
/// # Errors
/// If a name is unknown or a test fails for another reason. Also if anything changed, with a list of the
/// changes, so that unattended runs fail.
pub fn run(project: &Project, names: &[String]) -> Result<()> {
    let topics = topics(names)?;
    let before = stored(project, &topics)?;
    tools::run(tests(project, &topics).arg("--no-run"))?;
    // A test that stores new expectations fails, so that it never counts as passed.
    let mut blessing = only(tests(project, &topics), &topics);
    if tools::run(blessing.env("BLESS", "1").env("RUST_BACKTRACE", "0")).is_err() {
        println!("\nOnce more, to see that what is stored now is what is drawn:");
        tools::run(&mut only(tests(project, &topics), &topics))?;
    }
    let changed = changes(&before, &stored(project, &topics)?);
    if changed.is_empty() {
        println!("\nNothing changed.");
        return Ok(());
    }
    println!("\nChanged:\n  {}", changed.join("\n  "));
    bail!("{} stored files changed: look at each before committing it", changed.len())
}

fn topics(names: &[String]) -> Result<Vec<&'static Topic>> {
    if let Some(unknown) = names.iter().find(|name| TOPICS.iter().all(|topic| topic.name != **name)) {
        let known: Vec<_> = TOPICS.iter().map(|topic| topic.name).collect();
        bail!("no topic is called {unknown}; there are {}", known.join(", "));
    }
    Ok(TOPICS
        .iter()
        .filter(|topic| names.is_empty() || names.iter().any(|name| name == topic.name))
        .collect())
}

/// Cargo about the test files of the topics, to be compiled at least.
fn tests(project: &Project, topics: &[&Topic]) -> Command {
    let mut command = project.cargo();
    command.args(["test", "--no-fail-fast"]);
    let mut tests = topics.iter().flat_map(|topic| topic.tests);
    if tests.clone().any(|(file, _)| *file == LIBRARY) {
        command.args(["--package", "inkpanel-engine", "--lib"]);
    }
    if tests.any(|(file, _)| *file != LIBRARY) {
        command.args(["--package", "inkpanel-cli", "--test", "it"]);
    }
    command
}

/// Limits the command to the tests that bless, because other tests in these files take minutes.
fn only(mut command: Command, topics: &[&Topic]) -> Command {
    let name = |(file, test): &(&str, &str)| {
        if *file == LIBRARY { (*test).to_owned() } else { format!("{file}::{test}") }
    };
    command.args(["--", "--exact"]).args(topics.iter().flat_map(|topic| topic.tests).map(name));
    command
}

/// Every stored file with its bytes.
fn stored(project: &Project, topics: &[&Topic]) -> Result<BTreeMap<PathBuf, Vec<u8>>> {
    let mut found = BTreeMap::new();
    let mut left: Vec<PathBuf> =
        topics.iter().flat_map(|topic| topic.stored).map(|path| project.root.join(path)).collect();
    while let Some(path) = left.pop() {
        if path.is_dir() {
            for entry in fs::read_dir(&path)? {
                left.push(entry?.path());
            }
        } else if path.is_file() {
            let bytes = fs::read(&path).with_context(|| path.display().to_string())?;
            found.insert(path.strip_prefix(&project.root).map(Path::to_path_buf).unwrap_or(path), bytes);
        }
    }
    Ok(found)
}

fn changes(before: &BTreeMap<PathBuf, Vec<u8>>, after: &BTreeMap<PathBuf, Vec<u8>>) -> Vec<String> {
    let line = |what: &str, path: &Path| format!("{what} {}", path.display());
    let written = after.iter().filter_map(|(path, bytes)| match before.get(path) {
        None => Some(line("new    ", path)),
        Some(old) if old != bytes => Some(line("changed", path)),
        Some(_) => None,
    });
    let gone = before.keys().filter(|path| !after.contains_key(*path)).map(|path| line("gone   ", path));
    written.chain(gone).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root() -> &'static Path {
        Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
    }

    #[test]
    fn every_test_that_blesses_is_in_a_topic_and_every_topic_has_its_tests() {
        let named = |file: &str| TOPICS.iter().any(|topic| topic.tests.iter().any(|(test, _)| *test == file));
        for entry in fs::read_dir(root().join("tests/it")).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_none_or(|extension| extension != "rs") {
                continue;
            }
            let text = fs::read_to_string(&path).unwrap();
            let file = path.file_stem().unwrap().to_string_lossy();
            // `golden.rs` writes for the files that use it, and `main.rs` declares them.
            if file == "golden" || file == "main" {
                continue;
            }
            let blesses = text.contains("(\"BLESS\")") || text.contains("crate::golden::");
            assert_eq!(blesses, named(&file), "{file}: no topic has it, or it blesses no more");
        }
        for (file, test) in TOPICS.iter().flat_map(|topic| topic.tests) {
            let (folder, name) =
                test.rsplit_once("::").map_or(("tests/it", *test), |(_, name)| ("crates/engine/src", name));
            let module = if *file == LIBRARY { "typescript" } else { file };
            let text = fs::read_to_string(root().join(format!("{folder}/{module}.rs"))).unwrap();
            assert!(text.contains(&format!("fn {name}()")), "{file} has no test {test}");
        }
    }

    #[test]
    fn topics_are_found_by_name() {
        let chosen = topics(&["bounds".into()]).unwrap();
        assert_eq!(chosen.iter().map(|topic| topic.name).collect::<Vec<_>>(), ["bounds"]);
        assert_eq!(topics(&[]).unwrap().len(), TOPICS.len());
        let said = topics(&["pages".into()]).err().unwrap().to_string();
        assert_eq!(said, "no topic is called pages; there are goldens, tables, bounds, shots, types");
    }

    #[test]
    fn what_is_new_changed_or_gone_is_listed() {
        let files = |files: &[(&str, &str)]| {
            files.iter().map(|(path, text)| (PathBuf::from(path), text.as_bytes().to_vec())).collect()
        };
        let before = files(&[("same", "1"), ("other", "1"), ("left", "1")]);
        let after = files(&[("same", "1"), ("other", "2"), ("made", "1")]);
        assert_eq!(changes(&before, &after), ["new     made", "changed other", "gone    left"]);
        assert!(changes(&before, &before).is_empty());
    }
}
