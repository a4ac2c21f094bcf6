//! The integration tests of the library and of the command line, in one program of the package `inkpanel-cli`.
//!
//! One program links once and runs all tests in parallel. `cargo test --test it blocks::` runs the tests of one file.
//! `tests/memory.rs` is a separate program because it counts every allocation.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a panic fails the test")]

mod aesthetics;
mod animate;
mod batch;
mod behind;
mod block_properties;
mod blocks;
mod boards;
mod books;
mod bounds;
mod breaking;
mod catalogue;
mod comics;
mod composing;
mod damaged_photos;
mod designed_styles;
mod detect;
mod docs;
mod editing;
mod facade;
mod folders;
mod framing_faces;
mod golden;
mod goldens;
mod hearing;
mod heic;
mod imitate;
mod import;
mod landmarks;
mod layout_files;
mod layout_pages;
mod lettering;
mod licences;
mod near_duplicates;
mod odd_files;
mod painters;
mod pdf;
mod phones;
mod plans;
mod preview;
mod project_reading;
mod regressions;
mod rooms;
mod saved;
mod segment;
mod selection;
mod shots;
mod style_imports;
mod subjects;
mod tidy;
mod trained_block;
mod turns;
mod words;

/// Returns the number of random trials: `few` by default, `all` if `INKPANEL_THOROUGH` is set (`cargo xtask test --all`).
fn trials(few: u64, all: u64) -> u64 {
    if std::env::var_os("INKPANEL_THOROUGH").is_some() { all } else { few }
}

/// Returns the absolute path of a file of the repository.
fn root(path: impl AsRef<std::path::Path>) -> std::path::PathBuf {
    // The package is two folders below the top folder.
    let package = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    package.ancestors().nth(2).unwrap().join(path)
}

/// Returns a call of the command line.
fn inkpanel() -> std::process::Command {
    std::process::Command::new(env!("CARGO_BIN_EXE_inkpanel"))
}
