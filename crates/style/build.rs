//! Embeds the designed styles: every file of `styles/` becomes a (name, text) pair of a table in `OUT_DIR`, which
//! `catalogue.rs` includes. `crates/model/build.rs` embeds the layouts with equal code: a file that both scripts include would be
//! in the package of neither.

use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs, io};

/// Writes `OUT_DIR/styles.rs` with `static STYLE_FILES: &[(&str, &str)]`, sorted by file name. Paths are relative to the package,
/// where cargo runs this program, so that a checkout can be moved without a new build.
fn main() -> io::Result<()> {
    let folder = styles();
    println!("cargo:rerun-if-changed={}", folder.display());
    let mut files: Vec<_> = fs::read_dir(folder)?
        .filter_map(Result::ok)
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "json"))
        .collect();
    files.sort();
    let mut source = "static STYLE_FILES: &[(&str, &str)] = &[\n".to_owned();
    for path in &files {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let text = without_space(&fs::read_to_string(path)?);
        writeln!(source, "    ({name:?}, {text:?}),").map_err(io::Error::other)?;
    }
    source.push_str("];\n");
    let out = env::var("OUT_DIR").map_err(io::Error::other)?;
    fs::write(Path::new(&out).join("styles.rs"), source)
}

/// The styles folder: at the top of the repository, or inside the published crate, which has a copy instead
/// of the link.
fn styles() -> &'static Path {
    let top = Path::new("../../styles");
    if top.is_dir() { top } else { Path::new("styles") }
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
