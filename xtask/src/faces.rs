//! The table of faces found and cut, over the photos of the repository and some of people that are for tests only.

use anyhow::Result;

use crate::albums::{own_folders, photos_in};
use crate::models::{self, Package, Registry};
use crate::project::Project;
use crate::test::CLI;
use crate::tools;

/// Photos of people; nothing of it is shipped or shown, so they are in the table only.
const PEOPLE: Package = Package {
    registry: Registry::Npm,
    name: "@vladmandic/face-api@1.7.15",
    sha256: "0d77fffeef362ef9c0939cf6c567f3a2e8e177f114fa257a3270cbd2e509b031",
};

/// Writes `docs/faces.md`'s table, and a sheet to look at into `target/faces.jpg`.
pub(crate) fn run(project: &Project) -> Result<()> {
    models::make(project)?;
    let people = PEOPLE.obtain(&project.target.join("models"))?.join("demo");
    let photos = photos_in(&[own_folders(project), vec![people]].concat())?;
    let mut cargo = project.cargo();
    cargo.args(["run", "--features", CLI, "--example", "face_table", "--", "docs/faces.md"]);
    cargo.arg(project.target.join("faces.jpg")).args(photos);
    tools::run(&mut cargo)
}
