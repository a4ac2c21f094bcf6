//! Embeds the layouts: every file of `layouts/` becomes a (name, text) pair of a table in `OUT_DIR`, which
//! `layout` includes. `crates/style/build.rs` embeds `styles/`. Text colours are computed from the
//! styles. The fonts of `fonts/` become the table of glyphs, except for WebAssembly modules, which receive it
//! at run time.

mod pack;
#[path = "src/page/words/palette.rs"]
#[allow(dead_code, unreachable_pub)]
mod palette;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use sha2::{Digest, Sha256};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// Paths are relative to the package, where cargo runs this program, so that a checkout can be moved without a new build.
fn main() -> io::Result<()> {
    layouts()?;
    palettes()?;
    reader()?;
    letters()
}

/// Writes `OUT_DIR/palettes.rs`: text colours on pages of each style, sorted by style id.
fn palettes() -> io::Result<()> {
    println!("cargo:rerun-if-changed=src/page/words/palette.rs");
    let folder = top("styles");
    let mut rows = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.extension().is_none_or(|extension| extension != "json") {
            continue;
        }
        let style: serde_json::Value = serde_json::from_str(&fs::read_to_string(&path)?)?;
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let id = style["id"].as_str().map_or(stem, str::to_owned);
        let palette::Palette { ink, paper, note, accent, edge } = palette::of(&style);
        rows.push(format!("    ({id:?}, [{ink:?}, {paper:?}, {note:?}, {accent:?}, {edge:?}]),\n"));
    }
    rows.sort();
    let out = env::var("OUT_DIR").map_err(io::Error::other)?;
    let table = "static PALETTES: &[(&str, [[u8; 3]; 5])] = &[\n";
    fs::write(Path::new(&out).join("palettes.rs"), format!("{table}{}];\n", rows.concat()))
}

/// Writes `OUT_DIR/reader.rs`: the hashes that allow the inline script and style of an HTML comic in its
/// Content-Security-Policy.
fn reader() -> io::Result<()> {
    println!("cargo:rerun-if-changed=src/output/reader");
    let out = env::var("OUT_DIR").map_err(io::Error::other)?;
    let folder = Path::new("src/output/reader");
    let mut constants = String::new();
    for (name, file) in [("STYLE_HASH", "reader.css"), ("SCRIPT_HASH", "reader.js")] {
        let hash = BASE64_STANDARD.encode(Sha256::digest(fs::read(folder.join(file))?));
        let _ = writeln!(constants, "const {name}: &str = \"{hash}\";");
    }
    fs::write(Path::new(&out).join("reader.rs"), constants)
}

/// Writes `OUT_DIR/letters.bin`.
fn letters() -> io::Result<()> {
    println!("cargo:rerun-if-changed=pack.rs");
    let folder = top("fonts");
    // `cargo xtask` writes the table for the app.
    if env::var("CARGO_CFG_TARGET_ARCH").is_ok_and(|target| target == "wasm32") {
        return Ok(());
    }
    let out = env::var("OUT_DIR").map_err(io::Error::other)?;
    let table = pack::pack(&folder).map_err(io::Error::other)?;
    fs::write(Path::new(&out).join("letters.bin"), table)
}

/// Writes `OUT_DIR/layouts.rs` with `static LAYOUT_FILES: &[(&str, &str)]`, sorted by file name.
fn layouts() -> io::Result<()> {
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
