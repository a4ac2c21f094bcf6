//! TypeScript types of all data between Rust and the app. `www/engine/types.ts` is generated from the types
//! of this crate. `www/engine/types-written.ts` has sample output of the core, so that the TypeScript
//! compiler checks it against the types. The shape of manually read and written JSON is defined here.
#![allow(dead_code, clippy::unwrap_used, reason = "only for the TypeScript types; a test may panic")]

use crate::detect::{Detection, FirstLook};
use crate::document::carrying_out::Obstacles;
use crate::document::draft::{self, Draft, DraftEdit, DraftStep, Layer, Place};
use crate::document::edit::{Edit, How, Part};
use crate::document::editor::Editor;
use crate::document::file::{FilePhoto, FileVideo, Likeness, ProjectFile};
use crate::document::history::{History, Shown};
use crate::document::intent::{CropChange, Draw, Intent, Shuffled};
use crate::document::kept;
use crate::document::project::{Focus, Locks, Order, Project, Sheet, Styling, TrayItem};
use crate::document::shots::{Board, Shot};
use crate::framing::{Crop, Expression, PhotoMeta, Subject};
use crate::hearing;
use crate::layout::edit::Cut;
use crate::layout::merge::Obstacle;
use crate::layout::tree::Axis;
use crate::layout::{
    Bounds, Circle, Descriptor, LayoutChange, LayoutPanel, Outline, PageSettings, PlacedPanel, Point,
    Template,
};
use crate::output::animatic::{self, Animatic, Clip};
use crate::output::board::{self, Labels, Logo, PictureOf};
use crate::output::motion;
use crate::output::reading::{Reading, Said, Stop};
use crate::output::shots::timecode::{Pace, StartTimecode};
use crate::output::shots::{Film, ListedShot, ShotList};
use crate::output::{self, Comic, ComicPage, PictureKind, Piece};
use crate::page::book;
use crate::page::catalogue::{BlockEntry, ChoiceRequest, MeasuresEntry, ParamEntry, ParamKind, VerdictEntry};
use crate::page::document::{LayoutChoice, PanelContent, StyleChoice};
use crate::page::import::{ImportEntry, PixelSize};
use crate::page::layouts::{GenerateRequest, Geometry, LayoutEntry, LayoutFacts, LayoutsRequest};
use crate::page::pdf::{Imposition, Options};
use crate::page::request::{Avoid, Families, Keep, Mode, Request, Taste};
use crate::page::words::TextItem;
use crate::page::words::layout::WordBox;
use crate::page::{Document, catalogue, layouts, request, shuffle};
use crate::raster::decode::Damage;
use crate::select::Reason;
use crate::style::Style;
use crate::style::blocks::Channels;
use crate::style::file::Step;
use crate::style::part::{Part as StylePart, Parts as LayerParts};
use serde::Deserialize;
use serde_json::{Value, json};
use std::collections::HashMap;
use std::path::Path;
use ts_rs::{Config, TS};

/// Index of a page in a table.
type Number = usize;

/// The tables that states name their parts of.
#[derive(TS, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
struct Tables {
    #[ts(as = "Vec<TrayItem>")]
    items: Vec<Value>,
    trays: Vec<Vec<Number>>,
    #[ts(as = "Vec<Document>")]
    pages: Vec<Value>,
    #[ts(type = "ReadonlyArray<KeptSheet>")]
    sheets: Vec<Value>,
    books: Vec<Vec<Number>>,
    #[ts(as = "Vec<Style>")]
    styles: Vec<Value>,
    shelves: Vec<Vec<Number>>,
    #[ts(as = "Vec<Template>")]
    layouts: Vec<Value>,
    layout_shelves: Vec<Vec<Number>>,
    #[ts(as = "Vec<PageSettings>")]
    settings: Vec<Value>,
    #[ts(as = "Vec<Draft>")]
    drafts: Vec<Value>,
    #[ts(as = "Vec<TextItem>")]
    words: Vec<Value>,
    waits: Vec<Vec<Number>>,
    #[ts(as = "Vec<Board>")]
    boards: Vec<Value>,
}

/// The difference after a change, see `difference` in `crates/model/src/kept.rs`.
#[derive(TS, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
struct Difference {
    /// The fields that changed.
    #[ts(type = "Partial<KeptState>")]
    present: Value,
    #[ts(type = "Runs")]
    shown: Runs,
    #[ts(type = "ReadonlyArray<KeptShown>")]
    entries: Vec<Value>,
    /// The edits that an intent led to.
    #[ts(type = "ReadonlyArray<KeptEdit>")]
    edits: Vec<Value>,
    parts: Tables,
    undos: Number,
    redos: Number,
    /// Whether the steps to undo are others.
    stepped: bool,
    /// Whether the history changed at all.
    changed: bool,
    /// Number of earlier changes that a journal need not have.
    includes: Number,
    /// Dropped parts, as sentences.
    dropped: Vec<String>,
    /// An id for a new page,
    page_id: u64,
    /// and one for a new place.
    sheet: u64,
}

/// Missing input of a block.
#[derive(TS, Deserialize)]
#[serde(deny_unknown_fields)]
struct Misfit {
    #[ts(as = "draft::Misfit")]
    lacks: String,
    /// The block that provides it.
    remedy: String,
}

/// Analysis of a layer of a draft.
#[derive(TS, Deserialize)]
#[serde(deny_unknown_fields)]
struct LayerFacts {
    /// For each of its blocks.
    misfits: Vec<Option<Misfit>>,
    /// For each block that could be added at the end, by id.
    #[ts(type = "Record<string, Misfit | null>")]
    brings: HashMap<String, Option<Misfit>>,
}

/// Analysis of a draft.
#[derive(TS, Deserialize)]
#[serde(deny_unknown_fields)]
struct DraftFacts {
    /// Its file.
    #[ts(as = "Style")]
    style: Value,
    /// The file with unusable blocks bypassed.
    #[ts(as = "Style")]
    shown: Value,
    /// Whether all blocks are usable.
    whole: bool,
    background: LayerFacts,
    foreground: LayerFacts,
}

/// Consecutive numbers: the first, and the count.
type Runs = Vec<(usize, usize)>;

/// A history with tables of its parts.
#[derive(TS, Deserialize)]
#[serde(deny_unknown_fields)]
struct TabledHistory {
    parts: Tables,
    #[ts(type = "ReadonlyArray<KeptState>")]
    past: Vec<Value>,
    #[ts(type = "KeptState")]
    present: Value,
    #[ts(type = "ReadonlyArray<KeptState>")]
    future: Vec<Value>,
    #[ts(type = "ReadonlyArray<KeptShown>")]
    shown: Vec<Value>,
}

/// A history out of the database, checked.
#[derive(TS, Deserialize)]
#[serde(deny_unknown_fields)]
struct ReadHistory {
    version: u64,
    history: TabledHistory,
    /// Dropped parts, as sentences.
    dropped: Vec<String>,
}

/// A project file or the text of a page, checked.
#[derive(TS)]
struct ReadProject {
    format: String,
    version: u64,
    #[ts(type = "{ present: Project; shown: ReadonlyArray<Shown> }")]
    history: Value,
    photos: Vec<FilePhoto>,
    videos: Vec<FileVideo>,
    /// Dropped parts, as sentences.
    dropped: Vec<String>,
}

/// Request to combine two styles.
#[derive(TS)]
struct BreedRequest {
    a: StyleChoice,
    b: StyleChoice,
    seed: u32,
    /// 0 to 1.
    surprise: f64,
}

/// TypeScript types without a type in Rust.
const MORE: &str = "\
/** A value of a parameter: a number, an entry of its choices, or whether it is on. */
export type ParamValue = number | string | boolean;

/** The lists that all projects have in common. They are a part of each project, so that undo reaches them. */
export type SharedLists = Pick<Project, 'mine' | 'favourites' | 'ownLayouts'>;

/** Consecutive numbers. */
export type Runs = ReadonlyArray<readonly [first: number, count: number]>;

/** Fields of a state that are stored in tables and referenced by number. */
export type Tabled = 'tray' | 'settings' | 'page' | 'others' | 'draft' | 'board' | 'waiting' | 'mine' | 'favourites' | 'ownLayouts';

/** A state whose parts are stored in tables. */
export type KeptState = Omit<Project, Tabled> & {
  [Field in Exclude<Tabled, 'board' | 'waiting'>]: number | Extract<Project[Field], null>;
} & { board?: number | null; waiting?: number };

/** A page of a storyboard, and a version of a page. Their pages are stored in a table. */
export type KeptSheet = Omit<Sheet, 'page'> & { page: number };
export type KeptShown = Omit<Shown, 'page'> & { page: number };

/** An edit that an intent led to. Its pages and settings are stored in tables. */
export type KeptEdit = How & (
| { type: 'show-page'; page: number; pageId: number }
| { type: 'change-page'; page: number }
| { type: 'change-settings'; settings: number; page?: number }
| { type: 'set-sheets'; sheets: ReadonlyArray<KeptSheet>; at: number }
| { type: 'no-page' }
);
";

/// The module of types.
#[allow(clippy::too_many_lines, reason = "a list of types")]
fn types() -> String {
    let cfg = Config::new().with_large_int("number");
    let mut out = String::from(
        "/**\n * Types of all data between the app and the core. Generated from the types of the core by `cargo xtask bless types`.\n */\n",
    );
    macro_rules! tell {
        ($($told:ty),* $(,)?) => {
            $(out.push('\n');
            if let Some(docs) = <$told>::docs() {
                out.push_str(&docs);
            }
            out.push_str("export ");
            out.push_str(&<$told>::decl(&cfg));
            out.push('\n');)*
        };
    }
    tell!(
        Project,
        TrayItem,
        Shot,
        Board,
        ShotList,
        ListedShot,
        Film,
        Pace,
        StartTimecode,
        board::Request,
        PictureOf,
        Logo,
        animatic::Request,
        animatic::Picture,
        Animatic,
        Clip,
        motion::Request,
        Reading,
        Said,
        Stop,
        Labels,
        Focus,
        Order,
        Locks,
        Styling,
        Sheet,
        Draft,
        DraftStep,
        Layer,
        Place,
        DraftEdit,
        DraftFacts,
        LayerFacts,
        Misfit,
        draft::Misfit,
        Shown,
        History,
        Edit,
        Intent,
        Obstacles,
        Obstacle,
        CropChange,
        Shuffled,
        Draw,
        Part,
        How,
        Document,
        PanelContent,
        LayoutChoice,
        StyleChoice,
        PageSettings,
        Crop,
        TextItem,
        WordBox,
        Template,
        Style,
        Step,
        Request,
        Keep,
        Mode,
        book::Wish,
        book::Styles,
        book::Dates,
        Taste,
        Avoid,
        Families,
        request::Styling,
        PhotoMeta,
        crate::framing::energy::Hexadecimal,
        Subject,
        Expression,
        BlockEntry,
        ParamEntry,
        ParamKind,
        Channels,
        StylePart,
        LayerParts,
        Descriptor<'static>,
        LayoutPanel<'static>,
        Outline<'static>,
        Circle,
        LayoutEntry<'static>,
        LayoutFacts<'static>,
        Cut,
        Axis,
        LayoutChange,
        LayoutsRequest,
        GenerateRequest,
        Geometry<'static>,
        PlacedPanel<'static>,
        Bounds,
        Point,
        VerdictEntry<'static>,
        Reason,
        ChoiceRequest,
        catalogue::Candidate,
        MeasuresEntry,
        ImportEntry<'static>,
        PixelSize,
        Damage,
        Detection,
        FirstLook,
        hearing::Event,
        hearing::Kind,
        hearing::Word,
        BreedRequest,
        Tables,
        Difference,
        TabledHistory,
        ReadHistory,
        ReadProject,
        FilePhoto,
        FileVideo,
        Likeness,
        Options,
        Imposition,
        Comic,
        ComicPage,
        PictureKind,
        Piece,
        output::File,
        output::strip::Request,
        output::strip::StripPhoto,
    );
    out.push('\n');
    out.push_str(MORE);
    out.push_str(&error_codes());
    formatted(&out)
}

/// Returns the type of error codes, from the function that returns them.
fn error_codes() -> String {
    let (_, code) = include_str!("../../image/src/error.rs").split_once("pub fn code(").unwrap();
    let arms = code.split("    }\n\n").next().unwrap().lines();
    let codes = arms.filter_map(|arm| arm.split_once("=> \"")?.1.split('"').next());
    let codes: Vec<_> = codes.map(|code| format!("  | '{code}'")).collect();
    format!("\n/** Codes of the errors of the core. */\nexport type ErrorCode =\n{};\n", codes.join("\n"))
}

/// Comments of one line on one line, lists that are only read, and lines set in by the brackets about them.
fn formatted(text: &str) -> String {
    let changes = [
        ("Array<", "ReadonlyArray<"),
        ("ReadonlyReadonly", "Readonly"),
        (", }", ",\n}"),
        (" | {", "\n| {"),
        ("[`", "`"),
        ("`]", "`"),
    ];
    let text = changes.iter().fold(text.to_owned(), |text, (from, to)| text.replace(from, to));
    let mut out = Vec::new();
    let (mut depth, mut comment) = (0usize, None::<Vec<&str>>);
    for line in text.lines().map(str::trim) {
        let indent = "  ".repeat(depth);
        if line == "/**" {
            comment = Some(Vec::new());
        } else if let (Some(told), "*/") = (&comment, line) {
            if let [only] = told[..] {
                out.push(format!("{indent}/** {only} */"));
            } else {
                out.push(format!("{indent}/**"));
                out.extend(told.iter().map(|line| format!("{indent} * {line}")));
                out.push(format!("{indent} */"));
            }
            comment = None;
        } else if let Some(told) = &mut comment {
            told.push(line.trim_start_matches('*').trim());
        } else if !line.is_empty() {
            depth = depth + line.matches('{').count() - line.matches('}').count();
            let indent = if line.starts_with('}') { "  ".repeat(depth) } else { indent };
            out.push(format!("{indent}{line}"));
        } else if depth == 0 {
            out.push(String::new());
        }
    }
    out.join("\n") + "\n"
}

/// One of each edit, in the form that the app sends.
fn edits(page: &Value) -> Vec<Value> {
    let style = json!({ "id": "a", "name": "A", "tags": ["ink"], "background": [{ "block": "posterize", "levels": 5, "bypass": true }], "foreground": [{ "block": "to_gray" }], "ink": "#102030", "score": 0.5 });
    let layout = json!({ "id": "b", "name": "B", "family": "custom", "aspect": 1, "tree": { "rows": ["panel", { "columns": ["panel", "panel"] }] }, "weights": [1, 2, 3] });
    let step = json!({ "key": 1, "block": "posterize", "values": { "levels": 5 }, "bypass": false });
    let draft = json!({ "id": "d", "name": "D", "tags": [], "background": [step], "foreground": [], "ink": "#000000" });
    let sheet = |id: u64| json!({ "page": page, "pageId": id, "sheet": id });
    let styling = json!({ "invented": 0.5, "keepLines": true, "keepColours": false });
    let drawn = json!({ "extra": [style], "invented": 0.5, "inventions": [style], "keepLines": true, "keepColours": false, "quick": true });
    let draw = json!({ "seed": 1, "taste": { "families": { "grid": 0.5 }, "styles": {} }, "styling": drawn });
    let told = json!([
        { "type": "add-photos", "ids": ["p", "q", "r", "s"], "silent": true },
        { "type": "remove-photos", "ids": ["q"], "gesture": "g" },
        { "type": "forget-photos", "ids": ["r"] },
        { "type": "use-photos", "uses": { "p": true } },
        { "type": "exchange-photo", "id": "s", "by": "t" },
        { "type": "choose-by", "alike": 9, "order": "name" },
        { "type": "focus-photo", "id": "p", "focus": { "x": 0.25, "y": 0.5 } },
        { "type": "star-photo", "id": "p", "on": true },
        { "type": "mask-photo", "id": "p", "mask": "2x1:ap" },
        { "type": "lock", "part": "layout", "on": true },
        { "type": "want-panels", "count": 4 },
        { "type": "show-page", "page": page, "pageId": 1 },
        { "type": "change-page", "page": page },
        { "type": "change-settings", "settings": page["page"], "page": page },
        { "type": "set-sheets", "sheets": [sheet(1), sheet(2)], "at": 1 },
        { "type": "add-words", "words": [{ "kind": "balloon", "text": "Hi", "photo": "p", "panel": 0, "auto": true }, { "kind": "balloon", "text": "Ho", "sheet": 2, "panel": 1, "joins": true }] },
        { "type": "set-words", "pages": [{ "at": 1, "words": [{ "kind": "caption", "text": "Hi" }] }] },
        { "type": "drop-waiting", "words": [0] },
        { "type": "design", "draft": draft },
        { "type": "own-styles", "mine": [style] },
        { "type": "favourites", "favourites": [style] },
        { "type": "own-layouts", "ownLayouts": [layout] },
        { "type": "love-page", "pageId": 1, "on": true },
        { "type": "rename", "name": "One" },
        { "type": "styling", "styling": styling },
        { "type": "describe-shots", "shots": { "p": { "scene": "1", "number": "4A", "action": "She enters.", "dialogue": "Hi", "notes": "dusk", "frames": 36, "more": { "Lens": "35" } } } },
        { "type": "set-board", "board": { "fps": 30, "pace": "drop", "columns": ["Lens"], "frames": 4, "aspect": "1.85", "beside": true, "ruled": false, "author": "me", "date": "today", "order": ["p"] } },
        { "type": "share", "lists": { "mine": [style] } },
        { "type": "join", "lists": { "ownLayouts": [layout] } },
        { "type": "undo" },
        { "type": "redo" },
        { "type": "no-page" },
    ]);
    let intents = json!([
        { "type": "crop-panel", "panel": 0, "crop": { "type": "zoom", "factor": 2, "at": [0.5, 0.25] }, "gesture": "g" },
        { "type": "swap-panels", "panel": 0, "with": 1 },
        { "type": "place-photo", "panel": 0, "photo": "p" },
        { "type": "lock-panel", "panel": 0, "on": true },
        { "type": "break-frame", "panel": 0, "mask": "2x1:ap" },
        { "type": "merge-panels", "panels": [0, 1] },
        { "type": "split-panels", "panels": [] },
        { "type": "reshape", "change": { "type": "split", "panel": 0, "axis": "rows" } },
        { "type": "enlarge-panel", "panel": 0 },
        { "type": "recrop", "sheet": 1 },
        { "type": "recrop-photo", "photo": "p", "everywhere": true },
        { "type": "shuffle", "part": "all", "draw": draw },
        { "type": "fit-layout", "draw": { "seed": 1 } },
        { "type": "choose-layout", "layout": "grid-4", "seed": 1 },
        { "type": "choose-style", "style": style, "seed": 1 },
        { "type": "restyle", "style": "comic" },
        { "type": "sort-photos" },
        { "type": "use-duplicate", "photo": "p", "alike": ["q"] },
        { "type": "refit", "grow": true, "draw": { "seed": 1 } },
        { "type": "set-paper", "settings": page["page"], "held": true, "taste": { "styles": { "comic": 0.5 } } },
        { "type": "compose", "photos": ["p"], "panels": 1, "layout": "splash", "style": "comic", "surprise": 0, "draw": { "seed": 1 } },
        { "type": "add-page", "draw": { "seed": 1 } },
        { "type": "remove-page" },
        { "type": "move-page", "from": 0, "to": 1 },
        { "type": "go-to-page", "at": 1 },
        { "type": "spread-album", "draw": { "seed": 1 } },
        { "type": "style-pages" },
        { "type": "repair-pages", "groups": { "p": 0 } },
        { "type": "restore-version", "pageId": 9 },
    ]);
    [told, intents].iter().flat_map(|list| list.as_array().unwrap().clone()).collect()
}

/// One of each edit of a draft, in the form that the app sends.
fn draft_edits() -> Vec<Value> {
    let told = json!([
        { "type": "add", "layer": "background", "at": 0, "blocks": ["pattern", "posterize"] },
        { "type": "move", "layer": "background", "at": 1, "toLayer": "foreground", "to": -1 },
        { "type": "duplicate", "layer": "foreground", "at": 0 },
        { "type": "remove", "layer": "foreground", "at": 0 },
        { "type": "set", "layer": "foreground", "at": 0, "param": "levels", "value": 3 },
        { "type": "where", "layer": "foreground", "at": 0, "part": "subject" },
        { "type": "layer-where", "layer": "background", "part": "background" },
        { "type": "reset", "layer": "foreground", "at": 0 },
        { "type": "bypass", "layer": "foreground", "at": 0, "on": true },
        { "type": "name", "name": "One" },
        { "type": "faces", "on": false },
        { "type": "dark", "on": true },
        { "type": "ink", "ink": "#102030" },
    ]);
    told.as_array().unwrap().clone()
}

/// The module with sample output of the core.
fn written() -> String {
    let settings = serde_json::to_value(PageSettings::default()).unwrap();
    let photo = PhotoMeta { starred: true, ..PhotoMeta::unmeasured("p", 1600, 1200) };
    let photo = serde_json::to_value(photo).unwrap();
    let wanted = json!({ "seed": 7, "photos": [photo], "page": settings, "current": null, "keep": { "layout": false }, "panels": 4, "mode": "photos", "merge": false, "taste": { "families": { "grid": 0.5 } }, "avoid": { "layouts": ["grid-4"] }, "within": { "layouts": ["grid"], "styles": ["ink"] }, "styling": { "extra": [], "invented": 0.5 }, "surprise": 1 });
    let planned = shuffle::plan(&serde_json::from_value(wanted.clone()).unwrap()).unwrap();
    let mut page: Value = serde_json::from_str(&planned.to_json()).unwrap();
    page["words"] = json!([{ "kind": "balloon", "text": "Hi", "shape": "shout", "panel": 0, "x": 0.5, "y": 0.25, "width": 0.25, "size": "auto", "tail": { "x": 0.5, "y": 0.5 }, "font": "bangers", "color": "#111111", "fill": "#ffffff", "angle": 5, "arc": 0.5, "auto": true, "boxless": false, "capitals": true, "slant": 5, "outline": 0.1, "behind": false, "id": "b", "joined": "a", "linked": "a", "apart": false, "by": "Anna", "language": "en", "vertical": false, "room": [0.5, 0.25], "photo": "a", "cue": "1.000/0" }]);
    let mut editor = Editor::default();
    let differences: Vec<_> =
        edits(&page).iter().map(|edit| editor.apply_json(&edit.to_string()).unwrap()).collect();
    for difference in &differences {
        serde_json::from_str::<Difference>(difference).unwrap();
    }
    let sheets = edits(&page).into_iter().find(|edit| edit["type"] == "set-sheets").unwrap();
    editor.apply_json(&sheets.to_string()).unwrap();
    let mut draft = draft::empty_json("d", "D");
    for edit in draft_edits() {
        draft = draft::after_json(&draft, &edit.to_string()).unwrap();
    }
    let draft_facts = draft::facts_json(&draft).unwrap();
    serde_json::from_str::<DraftFacts>(&draft_facts).unwrap();
    let history = kept::write(editor.history(), &vec!["photo.jpg: left out".into()]);
    serde_json::from_str::<ReadHistory>(&history).unwrap();
    let whole =
        ProjectFile { history: editor.history().clone(), photos: vec![], videos: vec![], dropped: vec![] }
            .write();
    let whole: Value = serde_json::from_str(&whole).unwrap();
    let file = ProjectFile::parse(&json!({ "format": "inkpanel", "version": 1, "history": whole["history"], "photos": [{ "id": "p", "name": "P", "path": "p.jpg", "type": "image/jpeg", "credit": "me", "video": "v", "time": 2, "measured": true, "subjects": [{ "label": "face", "score": 1, "x": 0, "y": 0, "width": 1, "height": 1, "expression": { "rightEye": 0.3, "leftEye": 0.3, "mouth": 0, "smile": 0.1 } }], "rank": 1, "like": { "hash": "", "fingerprint": "0123456789abcdef", "width": 4, "height": 3 } }], "videos": [{ "key": "v", "name": "V", "path": "v.mp4", "type": "video/mp4", "ids": ["p"], "duration": 5, "start": 1, "end": 2, "timecode": { "frame": 1_078_920, "fps": 30, "drop": true } }] }).to_string()).unwrap().write();
    let on = |layout: &str| json!({ "layout": layout, "page": settings }).to_string();
    let layouts = catalogue::layouts();
    let layouts: Vec<_> = layouts
        .iter()
        .filter(|one| one.id == "grid-4" || one.panels.iter().any(|panel| panel.shape.circle.is_some()))
        .take(2)
        .collect();
    let entries: Vec<Value> =
        serde_json::from_str(&layouts::list(&json!({ "page": settings }).to_string()).unwrap()).unwrap();
    let measures =
        MeasuresEntry { fingerprint: "0123456789abcdef".into(), gradient: 1.0, paper: 0.5, laplacian: 2.0 };
    let mut candidate = serde_json::to_value(&measures).unwrap();
    candidate["id"] = json!("p");
    candidate["name"] = json!("P");
    candidate["faces"] = json!([{ "rightEye": 0.3, "leftEye": 0.3, "mouth": 0, "smile": 0.1 }]);
    let choice = json!({ "photos": [candidate], "duplicateThreshold": 10 });
    let style: Value = catalogue::styles()[0].clone();
    let facts = layouts::facts(&on("grid-4")).unwrap();
    let geometry = layouts::geometry(&on(layouts[1].id)).unwrap();
    let told = [
        ("page", "PageDocument", page.to_string()),
        ("request", "Request", wanted.to_string()),
        ("differences", "readonly Difference[]", format!("[\n  {}\n]", differences.join(",\n  "))),
        ("draft", "Draft", draft),
        ("draftFacts", "DraftFacts", draft_facts),
        ("history", "ReadHistory", history),
        ("file", "ReadProject", file),
        ("blocks", "readonly Block[]", serde_json::to_string(&catalogue::blocks()).unwrap()),
        ("layouts", "readonly Layout[]", serde_json::to_string(&layouts).unwrap()),
        ("entry", "LayoutEntry", entries[0].to_string()),
        ("facts", "LayoutFacts", facts),
        ("geometry", "Geometry", geometry),
        ("choice", "ChoiceRequest", choice.to_string()),
        ("verdicts", "readonly Verdict[]", catalogue::choose(&choice.to_string()).unwrap()),
        ("style", "Style", style.to_string()),
    ];
    let each = |name: &str, of: &str, type_of: &str, edits: Vec<Value>| {
        let edits: Vec<_> = edits.iter().map(|edit| format!("  {}: {edit},\n", edit["type"])).collect();
        format!(
            "\nexport const {name}: {{ [Type in {of}['type']]: {type_of} }} = {{\n{}}};\n",
            edits.concat()
        )
    };
    let edits = [
        each("edits", "Edit", "Extract<Edit, { type: Type }> & How", edits(&page)),
        each("draftEdits", "DraftEdit", "Extract<DraftEdit, { type: Type }>", draft_edits()),
    ];
    let mut names: Vec<_> =
        told.iter().map(|(_, of, _)| of.trim_start_matches("readonly ").trim_end_matches("[]")).collect();
    names.extend(["DraftEdit", "Edit", "How"]);
    names.sort_unstable();
    let told: Vec<_> =
        told.iter().map(|(name, of, value)| format!("\nexport const {name}: {of} = {value};\n")).collect();
    format!(
        "/**\n * What the core wrote and read, for the compiler to read against its types. Written by `cargo xtask bless types`.\n */\n\nimport type {{ {} }} from './types.ts';\n{}{}",
        names.join(", "),
        told.concat(),
        edits.concat()
    )
}

/// With `BLESS=1` the module is written again, and the test fails once.
fn check(file: &str, expected: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(file);
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    if std::env::var_os("BLESS").is_some() && found != expected {
        std::fs::write(&path, expected).unwrap();
        panic!("blessed {file}");
    }
    assert!(found == expected, "{file} is stale: run `cargo xtask bless types`");
}

#[test]
fn the_page_has_the_types_of_the_core() {
    check("www/engine/types.ts", &types());
}

#[test]
fn what_the_core_writes_is_there_for_the_compiler() {
    check("www/engine/types-written.ts", &written());
}
