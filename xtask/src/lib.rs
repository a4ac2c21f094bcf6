//! The task runner as a library, which the release tool in `tools/release` uses, too.

#![allow(
    missing_docs,
    clippy::missing_errors_doc,
    clippy::must_use_candidate,
    reason = "internal to this repository"
)]

pub mod albums;
pub mod batch;
pub mod bench;
pub mod bless;
pub mod budget;
pub mod chromium;
pub mod clamps;
pub mod corpora;
pub mod cpu;
pub mod debian;
pub mod duplicates;
pub mod engines;
pub mod faces;
pub mod fresh;
pub mod fuzz;
pub mod lane;
pub mod letters;
pub mod licences;
pub mod lighthouse;
pub mod models;
pub mod native;
pub mod npm;
pub mod package;
pub mod pages;
pub mod project;
pub mod prose;
pub mod python;
pub mod readers;
pub mod site;
pub mod stamp;
pub mod tables;
pub mod tally;
pub mod test;
pub mod tools;
pub mod train;
pub mod wasm;
pub mod wheel;
