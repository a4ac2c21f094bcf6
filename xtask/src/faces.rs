//! The table of faces found and cut, over the photos of the repository and some of people that are for tests only.

use anyhow::Result;

use crate::albums::{own_folders, photos_in};
use crate::models;
use crate::project::Project;
use crate::tools;

/// Photos of people. They are used only in the table, and are never published.
const PEOPLE: [&str; 2] =
    ["@vladmandic/face-api@1.7.15", "0d77fffeef362ef9c0939cf6c567f3a2e8e177f114fa257a3270cbd2e509b031"];

/// Writes `docs/reports/faces.md`'s table, and a sheet to look at into `target/faces.jpg`.
pub fn run(project: &Project) -> Result<()> {
    models::make(project)?;
    let people = models::fetch_package(project, PEOPLE[0], PEOPLE[1])?.join("demo");
    let photos = photos_in(&[own_folders(project), vec![people]].concat())?;
    let mut cargo = project.cargo();
    cargo.args(["run", "--example", "face_table", "--", "docs/reports/faces.md"]);
    cargo.arg(project.target.join("faces.jpg")).args(photos);
    tools::run(&mut cargo)
}
