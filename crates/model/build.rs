//! Embeds the layouts: every file of `layouts/` becomes a (name, text) pair of a table in `OUT_DIR`, which
//! `layout` includes. `crates/style/build.rs` embeds `styles/` with equal code: a file that both scripts include would be in the
//! package of neither.

use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs, io};

/// Writes `OUT_DIR/layouts.rs` with `static LAYOUT_FILES: &[(&str, &str)]`, sorted by file name.
fn main() -> io::Result<()> {
    let folder = layouts();
    println!("cargo:rerun-if-changed={}", folder.display());
    let mut files: Vec<_> = fs::read_dir(folder)?
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

/// The layouts folder: at the top of the repository, or inside the published crate, which has a copy instead
/// of the link.
fn layouts() -> &'static Path {
    let top = Path::new("../../layouts");
    if top.is_dir() { top } else { Path::new("layouts") }
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
