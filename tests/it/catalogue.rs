//! The built-in catalogue: it contains every data file and every block's file, and the table of blocks in
//! `styles/README.md` matches the descriptors.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;

use inkpanel_engine::page::catalogue;
use serde_json::Value;

const START: &str = "<!-- blocks:start -->\n";
const END: &str = "<!-- blocks:end -->";

fn ids(catalogue: &Value) -> BTreeSet<String> {
    catalogue.as_array().unwrap().iter().map(|entry| text(entry, "id")).collect()
}

fn text(entry: &Value, field: &str) -> String {
    entry[field].as_str().unwrap().to_owned()
}

/// Returns the names in a folder up to the first dot, except `other`.
fn stems(folder: &str, other: &[&str]) -> BTreeSet<String> {
    fs::read_dir(crate::root(folder))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter_map(|name| name.split('.').next().map(str::to_owned))
        .filter(|stem| !stem.is_empty() && !other.contains(&stem.as_str()))
        .collect()
}

fn told(catalogue: &impl serde::Serialize) -> Value {
    serde_json::to_value(catalogue).unwrap()
}

#[test]
fn every_file_is_in_its_catalogue_and_every_entry_has_a_file() {
    assert_eq!(stems("layouts", &["README", "sheet"]), ids(&told(&catalogue::layouts())));
    assert_eq!(stems("styles", &["README"]), ids(&catalogue::styles()));
    assert_eq!(stems("crates/style/src/blocks", &["mod"]), ids(&told(&catalogue::blocks())));
}

#[test]
fn every_block_and_parameter_explains_itself() {
    for block in told(&catalogue::blocks()).as_array().unwrap() {
        for described in std::iter::once(block).chain(block["params"].as_array().unwrap()) {
            let id = text(described, "id");
            assert!(!text(described, "label").is_empty(), "{} {id}", block["id"]);
            assert!(text(described, "help").ends_with('.'), "{} {id}: help is a sentence", block["id"]);
        }
    }
}

/// `BLESS=1` updates the table, and the test fails once.
#[test]
fn the_readme_of_the_styles_lists_the_blocks_as_they_are() {
    let path = crate::root("styles/README.md");
    let readme = fs::read_to_string(&path).unwrap();
    let (before, rest) = readme.split_once(START).unwrap();
    let (table, after) = rest.split_once(END).unwrap();
    let expected = blocks_table();
    if std::env::var_os("BLESS").is_some() && table != expected {
        fs::write(&path, format!("{before}{START}{expected}{END}{after}")).unwrap();
    }
    assert_eq!(table, expected, "`cargo xtask bless` writes the table anew");
}

fn blocks_table() -> String {
    let mut table = String::from("| Block | Parameters | Effect |\n|---|---|---|\n");
    for block in told(&catalogue::blocks()).as_array().unwrap() {
        let params: Vec<_> = block["params"].as_array().unwrap().iter().map(parameter).collect();
        let cells = [format!("`{}`", text(block, "id")), params.join("; "), text(block, "help")];
        writeln!(table, "| {} |", cells.join(" | ")).unwrap();
    }
    table
}

/// `sigma` .3..50 px (2), or the choices with the default first.
fn parameter(param: &Value) -> String {
    let default = &param["default"];
    let domain = match text(param, "kind").as_str() {
        "boolean" => "true or false".to_owned(),
        "texture" => return format!("`{}` a PNG or JPEG picture as a data URL (none)", text(param, "id")),
        "model" => return format!("`{}` a hash and a file name (none)", text(param, "id")),
        "colour" => "`#rrggbb`".to_owned(),
        "choice" => {
            let choices: Vec<_> =
                param["choices"].as_array().unwrap().iter().map(|c| c.as_str().unwrap_or_default()).collect();
            choices.join(", ")
        }
        _ => {
            let unit = param["unit"].as_str().filter(|unit| !unit.is_empty());
            format!("{}..{}{}", param["min"], param["max"], unit.map(|u| format!(" {u}")).unwrap_or_default())
        }
    };
    let default = default.as_str().map_or_else(|| default.to_string(), str::to_owned);
    format!("`{}` {domain} ({default})", text(param, "id"))
}
