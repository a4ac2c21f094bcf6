//! Dependencies between the modules of the engine, between the files of the crates, and between the folders of the page.
//! `ARCHITECTURE.md` lists the modules in this order. A module depends only on modules below it. The compiler checks the crates.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Component, Path, PathBuf};

/// The sources of the engine.
const ENGINE: &str = "crates/engine/src";

/// Crates whose files must not depend on each other in a circle.
const CRATES: [&str; 7] = [
    "crates/image/src",
    "crates/style/src",
    "crates/detect/src",
    "crates/model/src",
    ENGINE,
    "src",
    "crates/cli/src",
];

/// The modules from the lowest to the highest. `json` and `layout` are modules of the model.
const ROOMS: [&str; 13] = [
    "json", "layout", "kinds", "places", "texts", "select", "hearing", "framing", "plan", "page", "output",
    "document", "native",
];

/// All files below a folder with one of these extensions.
fn files(folder: &Path, endings: &[&str]) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() {
            if !matches!(name.as_str(), "node_modules" | "dist" | "public" | "models")
                && !name.starts_with("pkg")
            {
                found.extend(files(&path, endings));
            }
        } else if endings.iter().any(|ending| name.ends_with(ending)) {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// Returns the module of a path below `top`: its first folder, or the file without extension.
fn room(path: &Path, top: &Path) -> String {
    let below = path.strip_prefix(top).unwrap();
    below.with_extension("").components().next().unwrap().as_os_str().to_string_lossy().into_owned()
}

/// Names after `crate::` in code, tests and comments left out.
fn names(text: &str) -> BTreeSet<String> {
    let code = text.split("#[cfg(test)]\nmod tests").next().unwrap();
    let mut names = BTreeSet::new();
    for line in code.lines().filter(|line| !line.trim_start().starts_with("//")) {
        for after in line.split("crate::").skip(1) {
            let parts = after.strip_prefix('{').map_or(after, |list| list.split('}').next().unwrap());
            let single = !after.starts_with('{');
            for part in parts.split(',').take(if single { 1 } else { usize::MAX }) {
                let name = part.trim().split(|c: char| !(c.is_ascii_lowercase() || c == '_')).next().unwrap();
                names.insert(name.to_owned());
            }
        }
    }
    names
}

#[test]
fn no_room_of_the_engine_knows_one_above_it() {
    let level = |name: &str| ROOMS.iter().position(|room| *room == name);
    let top = crate::root(ENGINE);
    let mut wrong = Vec::new();
    let mut known = 0;
    for file in files(&top, &[".rs"]) {
        let Some(here) = level(&room(&file, &top)) else { continue };
        for name in names(&fs::read_to_string(&file).unwrap()) {
            let Some(there) = level(&name) else { continue };
            known += 1;
            if there > here {
                wrong.push(format!("{} uses {name}", file.strip_prefix(&top).unwrap().display()));
            }
        }
    }
    assert!(known > 100, "the imports were found: {known}");
    assert!(wrong.is_empty(), "a room may use those below it only:\n  {}", wrong.join("\n  "));
}

/// Adds the paths of a path or a tree of paths to `found`, and returns the text after it. `start` is the path before it.
fn grow<'t>(mut text: &'t str, start: &[&'t str], found: &mut Vec<Vec<&'t str>>) -> &'t str {
    let mut path = start.to_vec();
    loop {
        text = text.trim_start();
        if let Some(list) = text.strip_prefix('{') {
            text = list.trim_start();
            while !text.is_empty() && !text.starts_with('}') {
                let rest = grow(text, &path, found).trim_start();
                text = rest.strip_prefix(',').unwrap_or(rest).trim_start();
            }
            return text.get(1..).unwrap_or_default();
        }
        let end = text.find(|c: char| !c.is_alphanumeric() && !matches!(c, '_' | '*')).unwrap_or(text.len());
        let (name, rest) = text.split_at(end);
        path.extend(Some(name).filter(|name| !name.is_empty()));
        let rest =
            rest.strip_prefix(" as ").map_or(rest, |rest| &rest[rest.find([',', '}', ';']).unwrap_or(0)..]);
        let Some(next) = rest.strip_prefix("::") else {
            found.push(path);
            return rest;
        };
        text = next;
    }
}

/// The modules that a module uses, as paths from its crate. Unit tests and comments are left out.
fn used(code: &str, here: &[String], modules: &BTreeSet<Vec<String>>) -> BTreeSet<Vec<String>> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    let mut paths = Vec::new();
    for start in ["crate::", "super::", "self::"] {
        for (at, _) in code.match_indices(start).filter(|(at, _)| !code[..*at].ends_with(is_part)) {
            grow(&code[at..], &[], &mut paths);
        }
    }
    let module = |path: Vec<&str>| {
        let up = path.iter().take_while(|name| **name == "super").count();
        let base = if path[0] == "crate" { &[] } else { &here[..here.len() - up] };
        let names = path[up..].iter().filter(|name| !matches!(**name, "crate" | "self"));
        let mut whole: Vec<String> =
            base.iter().cloned().chain(names.map(|name| (*name).to_owned())).collect();
        while !modules.contains(&whole) && whole.pop().is_some() {}
        whole
    };
    // A module may use the modules around it, which only declare it.
    paths.into_iter().map(module).filter(|there| !here.starts_with(there)).collect()
}

#[test]
fn no_files_of_a_crate_know_each_other_in_a_circle() {
    for top in CRATES.map(crate::root) {
        let module = |file: &PathBuf| {
            let path = file.strip_prefix(&top).unwrap().with_extension("");
            let names = path.iter().map(|name| name.to_str().unwrap().to_owned());
            names.filter(|name| !matches!(name.as_str(), "mod" | "lib" | "main")).collect::<Vec<_>>()
        };
        let files = files(&top, &[".rs"]);
        let modules: BTreeSet<Vec<String>> = files.iter().map(module).collect();
        let mut doors: BTreeMap<(String, String), String> = BTreeMap::new();
        for file in &files {
            let text = fs::read_to_string(file).unwrap();
            let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
            let code: Vec<&str> = code.lines().map(|line| line.split("//").next().unwrap()).collect();
            let here = module(file);
            for there in used(&code.join("\n"), &here, &modules) {
                let (from, to) = (here.join("/"), there.join("/"));
                doors.insert((from.clone(), to.clone()), format!("{from} uses {to}"));
            }
        }
        assert!(doors.len() >= files.len() / 2, "the imports were found: {}", doors.len());
        let circles = circles(&doors);
        assert!(circles.is_empty(), "files that know each other in a circle:\n  {circles:#?}");
    }
}

/// Returns the files that a script imports at run time. Type-only imports are not included.
fn imports(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(at) = rest.find("from '") {
        let (before, after) = rest.split_at(at);
        let statement = before
            .rfind("\nimport")
            .max(before.rfind("\nexport"))
            .map_or(before, |start| &before[start + 1..]);
        let target = after[6..].split('\'').next().unwrap();
        let types = ["import type", "export type"].iter().any(|start| statement.starts_with(start));
        if target.starts_with('.') && !types && !statement.contains(';') {
            found.push(target.to_owned());
        }
        rest = &after[6..];
    }
    found
}

/// Without `.` and `..`.
fn plain(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => {
                out.pop();
            }
            Component::CurDir => {}
            other => out.push(other),
        }
    }
    out
}

/// A module without dependencies, or without dependents.
fn end_of<'a>(rooms: &BTreeSet<&'a str>, doors: &'a BTreeMap<(String, String), String>) -> Option<&'a str> {
    let left = |(from, to): &&(String, String)| rooms.contains(from.as_str()) && rooms.contains(to.as_str());
    let within: Vec<_> = doors.keys().filter(left).collect();
    let knows = |room: &str| within.iter().any(|(from, _)| from == room);
    let is_known = |room: &str| within.iter().any(|(_, to)| to == room);
    rooms.iter().copied().find(|room| !knows(room) || !is_known(room))
}

/// The dependencies in circles and between circles.
fn circles(doors: &BTreeMap<(String, String), String>) -> Vec<&String> {
    let mut rooms: BTreeSet<&str> = doors.keys().flat_map(|(a, b)| [a.as_str(), b.as_str()]).collect();
    // Removes modules without dependencies or without dependents, until only cycles and the modules between
    // them are left.
    while let Some(end) = end_of(&rooms, doors) {
        rooms.remove(end);
    }
    doors
        .iter()
        .filter(|((from, to), _)| rooms.contains(from.as_str()) && rooms.contains(to.as_str()))
        .map(|(_, file)| file)
        .collect()
}

#[test]
fn no_rooms_of_the_page_know_each_other_in_a_circle() {
    let top = crate::root("www");
    // One file for each pair of modules, for the error message.
    let mut doors: BTreeMap<(String, String), String> = BTreeMap::new();
    for file in files(&top, &[".ts", ".tsx"]) {
        let name = file.strip_prefix(&top).unwrap().display().to_string();
        if name.contains(".test.") || name.contains("testing") || !name.contains('/') {
            continue;
        }
        let here = room(&file, &top);
        for import in imports(&fs::read_to_string(&file).unwrap()) {
            let found = plain(&file.parent().unwrap().join(&import));
            // Fonts are outside of the page.
            if !found.starts_with(&top) {
                continue;
            }
            let there = room(&found, &top);
            if there != here && !there.starts_with("pkg") {
                doors.entry((here.clone(), there)).or_insert_with(|| format!("{name} imports {import}"));
            }
        }
    }
    assert!(doors.len() > 40, "the imports were found: {}", doors.len());
    let inside = circles(&doors);
    assert!(inside.is_empty(), "rooms that know each other in a circle:\n  {inside:#?}");
}
