//! Embeds the layouts: every file of `layouts/` becomes a (name, text) pair of a table in `OUT_DIR`, which
//! `layout` includes. `crates/style/build.rs` embeds `styles/`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// Writes `OUT_DIR/layouts.rs` with `static LAYOUT_FILES: &[(&str, &str)]`, sorted by file name.
fn main() -> io::Result<()> {
    let mut files: Vec<_> = fs::read_dir(top("layouts"))?
        .filter_map(Result::ok)
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "json"))
        .collect();
    files.sort();
    let mut source = "static LAYOUT_FILES: &[(&str, &str)] = &[\n".to_owned();
    for path in &files {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let text = without_space(&fs::read_to_string(path)?);
        writeln!(source, "    ({name:?}, {text:?}),").map_err(io::Error::other)?;
    }
    source.push_str("];\n");
    let out = env::var("OUT_DIR").map_err(io::Error::other)?;
    fs::write(Path::new(&out).join("layouts.rs"), source)
}

/// Returns a folder at the top of the repository, or inside the published crate, which has copies instead of the links. A change in
/// it starts this program again.
fn top(name: &str) -> PathBuf {
    let folder = Path::new("../..").join(name);
    let folder = if folder.is_dir() { folder } else { PathBuf::from(name) };
    println!("cargo:rerun-if-changed={}", folder.display());
    folder
}

/// Removes white space between JSON tokens, because every visitor downloads these texts.
fn without_space(json: &str) -> String {
    let (mut inside, mut escaped) = (false, false);
    let mut kept = json.to_owned();
    kept.retain(|letter| {
        let keep = inside || !letter.is_ascii_whitespace();
        inside ^= letter == '"' && !escaped;
        escaped = inside && letter == '\\' && !escaped;
        keep
    });
    kept
}
