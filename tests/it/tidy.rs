//! Rules of the house that no compiler checks, over all files that git tracks or would track.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Maximum size of a file in bytes, which also limits photos and goldens.
const BYTES: u64 = 2_000_000;

/// Paths relative to the top folder, with forward slashes.
fn files() -> Vec<String> {
    let mut git = Command::new("git");
    git.args(["ls-files", "-z", "--cached", "--others", "--exclude-standard"]).current_dir(crate::root(""));
    let listed = String::from_utf8(git.output().unwrap().stdout).unwrap();
    let files: Vec<_> = listed.split_terminator('\0').filter(|file| crate::root(file).is_file()).collect();
    assert!(files.contains(&"Cargo.toml"), "the rules need git and a checkout");
    files.into_iter().map(str::to_owned).collect()
}

fn extension(file: &str) -> &str {
    Path::new(file).extension().and_then(|extension| extension.to_str()).unwrap_or("")
}

/// Fails with all offences together.
fn none(rule: &str, offences: &[String]) {
    assert!(offences.is_empty(), "{rule}:\n  {}", offences.join("\n  "));
}

#[test]
fn nothing_generated_or_heavy_is_in_git() {
    const FOLDERS: &[&str] = &["target", "node_modules", "dist", "pkg"];
    const KINDS: &[&str] = &["wasm", "onnx", "tflite", "pt", "pth", "safetensors", "gguf", "pb", "zip", "gz"];
    let mut offences = Vec::new();
    for file in files() {
        let bytes = fs::metadata(crate::root(&file)).unwrap().len();
        if file.split('/').any(|part| FOLDERS.contains(&part)) || KINDS.contains(&extension(&file)) {
            offences.push(format!("{file}: made by a command, so it does not belong in git"));
        } else if bytes > BYTES {
            offences.push(format!("{file}: {bytes} bytes, at most {BYTES}"));
        }
    }
    none("keep the repository light", &offences);
}

#[test]
fn no_text_names_a_machine_or_a_registry() {
    // In two parts, so that this file does not offend by its own rules.
    let forbidden = [
        ("/ro", "ot/"),
        ("/ho", "me/"),
        ("/tm", "p/"),
        ("/wo", "rk/"),
        ("/Us", "ers/"),
        ("C:\\Us", "ers"),
        ("registry.np", "mjs.org"),
        ("static.cra", "tes.io"),
        ("index.cra", "tes.io"),
        ("files.python", "hosted.org"),
        ("proxy.gol", "ang.org"),
    ]
    .map(|(a, b)| format!("{a}{b}"));
    let mut offences = Vec::new();
    for file in files() {
        let Ok(text) = fs::read_to_string(crate::root(&file)) else { continue };
        for (number, line) in text.lines().enumerate() {
            for word in forbidden.iter().filter(|word| line.contains(word.as_str())) {
                offences.push(format!("{file}:{}: {word}", number + 1));
            }
        }
    }
    none("paths are relative and registries are left to their clients", &offences);
}

#[test]
fn every_module_says_what_it_is_for() {
    let offences: Vec<_> = files()
        .into_iter()
        .filter(|file| match extension(file) {
            "rs" => !starts_with(file, "//!"),
            "js" if file.starts_with("www/") => !starts_with(file, "// @ts-check"),
            _ => false,
        })
        .collect();
    none("a Rust file starts with //!, a script with // @ts-check", &offences);
}

fn starts_with(file: &str, start: &str) -> bool {
    fs::read_to_string(crate::root(file)).unwrap().starts_with(start)
}

/// Data files are registered by being there; a file whose name is not its id would be found under another name.
#[test]
fn data_files_are_named_by_their_id() {
    let mut offences = Vec::new();
    for folder in ["layouts", "styles"] {
        let mut seen = BTreeSet::new();
        for file in files().iter().filter(|file| file.starts_with(&format!("{folder}/"))) {
            if extension(file) != "json" {
                continue;
            }
            let text = fs::read_to_string(crate::root(file)).unwrap();
            let value: serde_json::Value = serde_json::from_str(&text).unwrap();
            let id = value["id"].as_str().unwrap_or("").to_owned();
            if *file != format!("{folder}/{id}.json") {
                offences.push(format!("{file}: its id is {id:?}"));
            }
            if value["name"].as_str().is_none_or(str::is_empty) {
                offences.push(format!("{file}: has no name"));
            }
            if !seen.insert(id) {
                offences.push(format!("{file}: its id is taken"));
            }
        }
    }
    none("one id a file", &offences);
}
