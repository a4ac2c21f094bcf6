//! Generated TypeScript modules match their Rust sources: the limits of a document
//! (`crates/model/src/limits.rs`), and the empty project.

use inkpanel_engine::document::history::History;
use inkpanel_engine::document::{kept, limits, script, spreading, subtitles};
use inkpanel_engine::kinds::{KINDS, Kind, Role, SIGNATURES, SYSTEM_FOLDERS, SYSTEM_NAMES};
use inkpanel_engine::layout::{DPI, Field, MOST_PIXELS, PRESETS, PagePreset, SETTINGS, SIDES, Setting};
use inkpanel_engine::output::animatic::{self, Animatic};
use inkpanel_engine::page::words::model::FARTHEST;
use inkpanel_engine::raster::heif;
use inkpanel_engine::select;
use inkpanel_engine::style::painters;
use serde_json::Value;

/// Returns the expected module of limits, in the format of Biome.
fn bounds() -> String {
    let most = [
        ("Photos of a project.", "photos", limits::MOST_PHOTOS),
        ("Pages of a storyboard.", "sheets", limits::MOST_SHEETS),
        ("Words of a page.", "words", limits::MOST_WORDS),
        ("Characters of a word.", "letters", limits::MOST_LETTERS),
        (
            "Maximum number of custom styles, of favourites, and of custom layouts.",
            "styles",
            limits::MOST_STYLES,
        ),
        ("Blocks of one layer of a style.", "blocks", limits::MOST_BLOCKS),
        ("Bytes of the file of a texture.", "texture", limits::TEXTURE),
        ("Bytes of the file of a model of painters.", "painters", painters::MAX_BYTES),
        ("Characters of a name.", "name", limits::LONGEST_NAME),
        ("A place of a word, in widths and heights of its panel to either side.", "away", FARTHEST as usize),
        ("Bytes of the text of a project.", "text", limits::PROJECT.bytes),
        ("Bytes of a file of subtitles.", "subtitles", subtitles::MOST_BYTES),
        ("Characters of a field of a shot.", "field", limits::LONGEST_FIELD),
        (
            "Characters of the number or scene of a shot, and of the name of a column.",
            "label",
            limits::LONGEST_LABEL,
        ),
        ("Characters of the logo of a board as a data URL.", "logo", limits::LONGEST_LOGO),
        ("Maximum number of custom columns.", "columns", limits::MOST_COLUMNS),
        ("Frames of a shot.", "shotFrames", limits::MOST_SHOT_FRAMES as usize),
        ("Characters of a script.", "script", script::MOST_SCRIPT),
        ("Text items that one edit adds.", "added", limits::MOST_ADDED),
    ];
    let head = "/**\n * Limits of a project. `cargo xtask bless` generates this file from `crates/model/src/limits.rs`. The core rejects projects that\n * exceed them, so the app never makes such projects.\n */\n\nexport const MOST = Object.freeze({\n";
    let lines = most.map(|(what, name, value)| format!("  /** {what} */\n  {name}: {},\n", grouped(value)));
    format!("{head}{}}});\n\n{}\n{}\n{}", lines.concat(), ranges(), animatics(), sizes())
}

/// Ranges of numbers, from minimum to maximum.
fn ranges() -> String {
    let [least_side, most_side] = SIDES;
    let [least_dpi, most_dpi] = DPI;
    let (standard, [min, max]) = (select::DUPLICATE_THRESHOLD, select::DUPLICATE_THRESHOLD_RANGE);
    let grouped = |value: u32| grouped(value as usize);
    [
        "/** Limits of a page: pixels per side, total pixels, DPI. */".to_owned(),
        "export const PAGE = Object.freeze({".to_owned(),
        format!("  leastSide: {},\n  mostSide: {},", grouped(least_side), grouped(most_side)),
        format!("  mostPixels: {},", self::grouped(MOST_PIXELS as usize)),
        format!("  leastDpi: {},\n  mostDpi: {},\n}});\n", grouped(least_dpi), grouped(most_dpi)),
        "/** Maximum fingerprint distance of near-duplicates, in bits: default, and range in the app. */".to_owned(),
        format!("export const DUPLICATE_THRESHOLD = Object.freeze({{ default: {standard}, min: {min}, max: {max} }});\n"),
        "/** Maximum number of panels of a first page, and default number of later pages. */".to_owned(),
        format!("export const USUAL_PANELS = {};\n", spreading::USUAL),
    ]
    .join("\n")
}

/// Constants of animatics.
fn animatics() -> String {
    let sizes = animatic::SIZES
        .map(|(id, [width, height])| format!("  {{ id: '{id}', width: {width}, height: {height} }},\n"));
    format!(
        "/** Animatics: `foot` is the distance of captions from the lower edge in frame heights, `columns` the numbers per frame in the table. */\nexport const ANIMATIC = Object.freeze({{ foot: {}, columns: {} }});\n\n/** Frame sizes of animatics by common name, in pixels. */\nexport const ANIMATIC_SIZES = Object.freeze([\n{}] as const);\n",
        Animatic::FOOT,
        Animatic::COLUMNS,
        sizes.concat()
    )
}

/// Common page sizes, the default first.
fn sizes() -> String {
    let size =
        |PagePreset { id, purpose, width, height, dpi, safe: [across, down], fold, .. }: &PagePreset| {
            let purpose = format!("{purpose:?}").to_lowercase();
            [
                "  {".to_owned(),
                format!("    id: '{id}',\n    purpose: '{purpose}',\n    width: {width},"),
                format!("    height: {height},\n    dpi: {dpi},"),
                format!("    safe: [{across}, {down}],\n    fold: {fold},\n  }},\n"),
            ]
            .join("\n")
        };
    let all: Vec<_> = PRESETS.iter().map(size).collect();
    format!(
        "/** Named page sizes, the default first; `safe` and `fold`: distance in pixels from the sides, and from the middle. */\nexport const PAGE_SIZES = Object.freeze([\n{}] as const);\n",
        all.concat()
    )
}

/// Returns digits in groups of three, in TypeScript syntax.
fn grouped(value: usize) -> String {
    let digits = value.to_string();
    let groups: Vec<_> =
        digits.as_bytes().rchunks(3).rev().map(|group| String::from_utf8_lossy(group)).collect();
    groups.join("_")
}

/// The module of the empty project, likewise.
fn empty() -> String {
    let text = kept::write(&History::default(), &Vec::new());
    let written: Value = serde_json::from_str(&text).unwrap();
    let history = &written["history"];
    let settings: String = fields(&history["parts"]["settings"][0], &text)
        .map(|(name, value)| line(name, &told(value, &text)))
        .collect();
    let project: String = fields(&history["present"], &text)
        .map(|(name, value)| match name.as_str() {
            "settings" => line(name, "DEFAULT_SETTINGS"),
            // The one list of its table is empty.
            "tray" | "others" | "mine" | "favourites" | "ownLayouts" => line(name, "Object.freeze([])"),
            _ => line(name, &told(value, &text)),
        })
        .collect();
    let head = "/** An empty project. `cargo xtask bless` generates this file from `crates/model/src/project.rs`. */";
    let imports = "import type { Project } from './project.ts';";
    let page = format!(
        "/** Default settings of a page. */\nexport const DEFAULT_SETTINGS = Object.freeze({{\n{settings}}});"
    );
    let state = format!("export const EMPTY_PROJECT: Project = Object.freeze({{\n{project}}});");
    format!("{head}\n\n{imports}\n\n{page}\n\n{state}\n")
}

fn line(name: &str, value: &str) -> String {
    format!("  {name}: {value},\n")
}

/// The fields of an object in the order in which the core writes them: the page compares some of it as text.
fn fields<'v>(object: &'v Value, text: &str) -> impl Iterator<Item = (&'v String, &'v Value)> + use<'v> {
    let mut fields: Vec<_> = object.as_object().unwrap().iter().collect();
    fields.sort_by_key(|(name, _)| text.find(&format!("\"{name}\":")));
    fields.into_iter()
}

/// A value as TypeScript has it.
fn told(value: &Value, text: &str) -> String {
    match value {
        Value::String(text) => format!("'{text}'"),
        Value::Number(number) => number.as_f64().unwrap().to_string(),
        Value::Array(list) if list.is_empty() => "Object.freeze([])".into(),
        Value::Object(_) => {
            let fields: Vec<_> =
                fields(value, text).map(|(name, value)| format!("{name}: {}", told(value, text))).collect();
            format!("Object.freeze({{ {} }})", fields.join(", "))
        }
        value => value.to_string(),
    }
}

/// Returns the generated module of file kinds.
fn file_table() -> String {
    let quoted = |text: &str| format!("'{}'", text.replace('\r', "\\r"));
    let list = |name: &str, texts: &[&str]| {
        let lines: Vec<String> = texts.iter().map(|text| format!("  {},\n", quoted(text))).collect();
        format!("export const {name}: readonly string[] = [\n{}];\n", lines.concat())
    };
    let kind = |Kind { name, media_type, endings, role }: &Kind| {
        let role = match role {
            Role::Unsupported(remedy) => format!("'{}',\n    remedy: '{}'", role.id(), remedy.id()),
            role => format!("'{}'", role.id()),
        };
        format!(
            "  {{\n    name: '{name}',\n    type: '{media_type}',\n    endings: '{}',\n    role: {role},\n  }},\n",
            endings.join(" ")
        )
    };
    let signature = |(at, start, ending): &(usize, &[u8], &str)| {
        let bytes: Vec<_> = start.iter().map(u8::to_string).collect();
        format!("  [{at}, [{}], '{ending}'],\n", bytes.join(", "))
    };
    [
        "/** Kinds of files. `cargo xtask bless` generates this file from `crates/engine/src/kinds.rs`. */\n\n",
        "export type Role =\n  | 'photo'\n  | 'video'\n  | 'subtitles'\n  | 'text'\n  | 'board'\n  | 'json'\n  | 'project'\n  | 'archive'\n  | 'painters'\n  | 'sidecar'\n  | 'unsupported';\n",
        "export type Remedy = 'jpeg' | 'unpack' | 'pages' | 'mp4' | 'srt' | 'fountain' | 'csv' | 'text';\n",
        "/** `endings` of names, separated by spaces; `type`: media type, if any; `remedy` for files that cannot be read */\n",
        "export type FileKind = { name: string; type: string; endings: string; role: Role; remedy?: Remedy };\n\n",
        "export const FILE_KINDS: readonly FileKind[] = [\n",
        &KINDS.iter().map(kind).collect::<String>(),
        "];\n\n/** Names of files of systems and programs, in lower case. */\n",
        &list("SYSTEM_NAMES", SYSTEM_NAMES),
        "\n/** Folders of systems and programs. */\n",
        &list("SYSTEM_FOLDERS", SYSTEM_FOLDERS),
        "\n/** First bytes of kinds: a position, the bytes there, and an ending of the kind. */\n",
        "export const SIGNATURES: readonly [at: number, bytes: readonly number[], ending: string][] = [\n",
        &SIGNATURES.iter().map(signature).collect::<String>(),
        "];\n\n/** Brands of HEIC and AVIF files. */\n",
        &format!("export const HEIC_BRANDS = {};\n", brands(&heif::HEIC)),
        &format!("export const AVIF_BRANDS = {};\n", brands(&heif::AVIF)),
    ]
    .concat()
}

fn brands(brands: &[&[u8; 4]]) -> String {
    let quoted: Vec<_> =
        brands.iter().map(|brand| format!("'{}'", String::from_utf8_lossy(&brand[..]))).collect();
    format!("[{}]", quoted.join(", "))
}

/// `BLESS=1` updates a module, and the test fails once.
fn check(file: &str, expected: &str) {
    let path = crate::root(file);
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    if std::env::var_os("BLESS").is_some() && found != expected {
        std::fs::write(&path, expected).unwrap();
        panic!("blessed {file}");
    }
    assert_eq!(found, expected, "`cargo xtask bless` writes {file} anew");
}

#[test]
fn the_page_has_the_bounds_of_the_core() {
    check("www/engine/bounds.ts", &bounds());
}

/// The types of the Python package, with all page settings.
#[test]
fn python_has_the_types_of_the_page_settings() {
    let file = "python/inkpanel/__init__.pyi";
    let types = std::fs::read_to_string(crate::root(file)).unwrap();
    let (before, rest) = types.split_once("class _PageSettings").unwrap();
    let (_, after) = rest.split_once("\n\n").unwrap();
    let line = |Setting { name, field, .. }| {
        let kind = match field {
            Field::Length(..) => "float",
            Field::Colour(_) => "str",
            Field::Flag(_) => "bool",
        };
        format!("    {}: {kind} | None\n", name.replace('-', "_"))
    };
    let lines = SETTINGS.map(line).concat();
    let head = "class _PageSettings(TypedDict, total=False):\n    # `cargo xtask bless bounds` writes these lines.\n";
    check(file, &format!("{before}{head}{lines}\n{after}"));
}

#[test]
fn the_page_has_the_kinds_of_files_of_the_core() {
    check("www/engine/file-table.ts", &file_table());
}

#[test]
fn the_system_hands_over_files_of_known_kinds() {
    let text = std::fs::read_to_string(crate::root("www/public/manifest.webmanifest")).unwrap();
    let manifest: Value = serde_json::from_str(&text).unwrap();
    let handlers = manifest["file_handlers"].as_array().unwrap();
    let accepted = handlers.iter().flat_map(|handler| handler["accept"].as_object().unwrap());
    let photos = KINDS.iter().filter(|kind| kind.role == Role::Photo).count();
    let mut seen = 0;
    for (media_type, endings) in accepted {
        let kind = KINDS.iter().find(|kind| kind.media_type == media_type).unwrap();
        seen += usize::from(kind.role == Role::Photo);
        for ending in endings.as_array().unwrap() {
            let ending = ending.as_str().unwrap().trim_start_matches('.');
            assert!(kind.endings.contains(&ending), "{media_type}: {ending}");
        }
    }
    assert_eq!(seen, photos);
}

#[test]
fn the_page_begins_with_the_project_of_the_core() {
    check("www/document/empty.ts", &empty());
}
