//! Folders of photos: every file in a folder is read, counted or named.

use serde_json::Value;
use std::fs;
use std::path::Path;

/// Selects the photos of a folder. Returns the names of the photos in order and the lines on standard error.
fn selected(folder: &Path) -> (Vec<String>, Vec<String>) {
    let output = crate::inkpanel().args(["select", "--json"]).arg(folder).output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{said}");
    let rows: Value = serde_json::from_slice(&output.stdout).unwrap();
    let name = |row: &Value| {
        let file = row["file"].as_str().unwrap();
        Path::new(file).strip_prefix(folder).unwrap().display().to_string()
    };
    (rows.as_array().unwrap().iter().map(name).collect(), said.lines().map(str::to_owned).collect())
}

#[test]
fn everything_in_a_folder_is_read_or_counted_or_named() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    for inside in ["1", "2/@eaDir", "10", "__MACOSX"] {
        fs::create_dir_all(at(inside)).unwrap();
    }
    let photo = fs::read(crate::root("tests/photos/cat.jpg")).unwrap();
    let photos = ["1/a.jfif", "1/b.pjpeg", "2/a.JPE", "10/a.jif", "c.JPG"];
    for name in photos {
        fs::write(at(name), &photo).unwrap();
    }
    let sidecars =
        ["1/b.AAE", "1/b.xmp", "1/._b.jpg", "2/Thumbs.db", "desktop.ini", ".DS_Store", "c.JPG.json"];
    for name in sidecars.iter().chain(&["2/@eaDir/a.jpg", "__MACOSX/a.jpg", "readme.txt", "10/data.bin"]) {
        fs::write(at(name), "What: is this").unwrap();
    }
    let named = [
        ("book.cbr", "RAR"),
        ("clip.mov", "video"),
        ("raw.NEF", "JPEG"),
        ("pages.zip", "archive"),
        ("no.jpg", "image"),
    ];
    for (name, _) in named {
        fs::write(at(name), "?").unwrap();
    }
    let (found, said) = selected(folder.path());
    assert_eq!(found, photos);
    let skipped = format!(
        "inkpanel: {}: skipped {} files that systems and programs store next to photos, 2 files of other kinds",
        folder.path().display(),
        sidecars.len()
    );
    assert!(said.contains(&skipped), "{said:?}");
    for (name, what) in named {
        let line = said.iter().find(|line| line.contains(name));
        let line = line.unwrap_or_else(|| panic!("{name} is not named: {said:?}"));
        assert!(line.contains(what) && line.ends_with("left out"), "{line}");
    }
    assert_eq!(said.len(), named.len() + 1, "{said:?}");
}

#[test]
fn the_video_of_a_live_photo_is_counted_with_its_photo() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::copy(crate::root("tests/photos/cat.jpg"), at("IMG_1.JPG")).unwrap();
    for name in ["IMG_1.MOV", "IMG_2.MOV"] {
        fs::write(at(name), "?").unwrap();
    }
    let (found, said) = selected(folder.path());
    assert_eq!(found, ["IMG_1.JPG"]);
    assert_eq!(said.len(), 2, "{said:?}");
    assert!(said[0].contains("IMG_2.MOV: this is a video (QuickTime), not a photo"), "{said:?}");
    assert!(said[1].ends_with("skipped 1 video of Live Photos with the name of a photo"), "{said:?}");
}

#[cfg(unix)]
#[test]
fn an_entry_that_cannot_be_read_costs_only_itself() {
    let folder = tempfile::tempdir().unwrap();
    fs::copy(crate::root("tests/photos/cat.jpg"), folder.path().join("a.jpg")).unwrap();
    std::os::unix::fs::symlink("nowhere", folder.path().join("b.jpg")).unwrap();
    let (found, said) = selected(folder.path());
    assert_eq!(found, ["a.jpg"]);
    assert!(
        said.len() == 1 && said[0].contains("b.jpg: it cannot be read; it may be a broken link"),
        "{said:?}"
    );
}
