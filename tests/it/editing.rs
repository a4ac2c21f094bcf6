//! Edits of a project, with undo: the cases of the app's former tests, invariants after any edit, and the
//! results of the former JavaScript implementation (`tests/oracles/edits.mjs`).

use inkpanel_engine::document::draft::Draft;
use inkpanel_engine::document::edit::{Edit, How, Part, Shelf};
use inkpanel_engine::document::editor::Editor;
use inkpanel_engine::document::file::ProjectFile;
use inkpanel_engine::document::history::History;
use inkpanel_engine::document::planning::{Planning, Seeds};
use inkpanel_engine::document::project::{Focus, List, Order, Project, Sheet, Styling};
use inkpanel_engine::document::sheets::photos_on;
use inkpanel_engine::document::shots::{Board, RATES, Shot};
use inkpanel_engine::document::spreading::balanced;
use inkpanel_engine::document::upkeep::Groups;
use inkpanel_engine::document::{kept, limits, own};
use inkpanel_engine::framing::PhotoMeta;
use inkpanel_engine::layout::{self, PageSettings};
use inkpanel_engine::page::request::{Keep, Mode, Request};
use inkpanel_engine::page::shuffle;
use inkpanel_engine::page::words::model::NewText;
use inkpanel_engine::page::words::{TextItem, TextKind};
use inkpanel_engine::page::{CustomFile, Document};
use inkpanel_engine::raster::Matte;
use oorandom::Rand64;
use serde_json::{Map, Value, json};
use std::collections::HashSet;
use std::sync::{Arc, OnceLock};

/// A page without photos. Its seed identifies it.
fn page(seed: u32) -> Arc<Document> {
    let panel = json!({ "photo": null });
    let page = json!({ "version": 1, "seed": seed, "layout": "grid-4", "style": "comic", "panels": [panel, panel, panel, panel] });
    Arc::new(Document::parse(&page.to_string()).unwrap())
}

fn show(id: u64) -> Edit {
    Edit::ShowPage { page: page(id as u32), page_id: id }
}

fn texts(ids: &[&str]) -> Vec<String> {
    ids.iter().map(|&id| id.to_owned()).collect()
}

fn played(edits: impl IntoIterator<Item = Edit>) -> Editor {
    let mut editor = Editor::default();
    for edit in edits {
        editor.apply(&edit, &How::default());
    }
    editor
}

fn shown_ids(editor: &Editor) -> Vec<u64> {
    editor.history().shown.iter().map(|shown| shown.id).collect()
}

fn seed_of(editor: &Editor) -> Option<u32> {
    editor.project().page().map(|page| page.seed)
}

#[test]
fn undo_and_redo_walk_through_the_steps_and_a_new_step_drops_what_was_undone() {
    let mut editor = played([show(1), show(2), Edit::Undo]);
    assert_eq!(seed_of(&editor), Some(1));
    assert!(editor.apply(&Edit::Redo, &How::default()));
    assert_eq!(seed_of(&editor), Some(2));
    editor.apply(&Edit::Undo, &How::default());
    editor.apply(&show(3), &How::default());
    assert!(!editor.apply(&Edit::Redo, &How::default()));
}

#[test]
fn one_drag_of_a_slider_is_one_step() {
    let mut editor = played([show(1)]);
    for gutter in [0.02, 0.03, 0.04] {
        let settings = PageSettings { gutter, ..PageSettings::default() };
        let on_paper = Document { page: settings.clone(), ..Document::clone(&page(1)) };
        let edit = Edit::ChangeSettings { settings: Arc::new(settings), page: Some(Arc::new(on_paper)) };
        editor.apply(&edit, &How { gesture: Some("gutter".into()), silent: false });
    }
    assert_eq!(editor.history().past.len(), 2);
    editor.apply(&Edit::Undo, &How::default());
    assert_eq!(*editor.project().settings, PageSettings::default());
}

#[test]
fn a_page_that_is_still_growing_makes_no_steps() {
    let mut editor = played([show(1)]);
    editor.apply(&Edit::ChangePage { page: page(7) }, &How { silent: true, gesture: None });
    assert_eq!(editor.history().past.len(), 1);
    assert_eq!((shown_ids(&editor), editor.history().shown[0].page.seed), (vec![1], 7));
}

#[test]
fn a_first_page_none_of_whose_photos_could_be_read_was_none() {
    let mut editor = Editor::default();
    editor.apply(&show(1), &How { silent: true, gesture: None });
    editor.apply(&Edit::NoPage, &How { silent: true, gesture: None });
    assert_eq!((shown_ids(&editor), editor.history().past.len()), (vec![], 0));
}

#[test]
fn a_photo_that_could_not_be_read_comes_back_by_no_undo() {
    let add = Edit::AddPhotos { ids: texts(&["a", "b"]) };
    let editor = played([add.clone(), show(1), Edit::ForgetPhotos { ids: texts(&["a"]) }, Edit::Undo]);
    let tray: Vec<_> = editor.project().tray.iter().map(|item| item.id.as_str()).collect();
    assert_eq!(tray, ["b"]);
    // Adding only such photos creates no undo step.
    assert_eq!(played([show(1), add.clone()]).history().past.len(), 2);
    assert_eq!(
        played([show(1), add.clone(), Edit::ForgetPhotos { ids: texts(&["a"]) }]).history().past.len(),
        2
    );
    assert_eq!(
        played([show(1), add, Edit::ForgetPhotos { ids: texts(&["a", "b"]) }]).history().past.len(),
        1
    );
}

#[test]
fn the_pages_shown_are_kept_in_order_with_their_last_edit_and_their_origin() {
    let editor = played([show(1), Edit::ChangePage { page: page(99) }, show(2), Edit::Undo, show(3)]);
    assert_eq!((shown_ids(&editor), editor.history().shown[0].page.seed), (vec![1, 2, 3], 99));
    assert_eq!(editor.history().position(), Some(2));
    let editor = played([show(1), show(2), show(1), show(3)]);
    let from: Vec<_> = editor.history().shown.iter().map(|shown| (shown.id, shown.from)).collect();
    assert_eq!(from, [(1, None), (2, Some(1)), (3, Some(1))]);
    let mut editor = played([show(1), show(2), show(1)]);
    assert_eq!((shown_ids(&editor).len(), editor.history().position()), (2, Some(0)));
    editor.apply(&Edit::Undo, &How::default());
    assert_eq!(editor.history().position(), Some(1));
}

#[test]
fn favourites_stay_when_the_oldest_go() {
    let love = Edit::LovePage { page_id: 1, on: true };
    let editor = played([show(1), show(2), love].into_iter().chain((3..1103).map(show)));
    assert_eq!(editor.history().shown.len(), 1000);
    assert_eq!(shown_ids(&editor)[..2], [1, 104]);
    assert_eq!(editor.history().past.len(), 500);
}

#[test]
fn a_photo_that_leaves_the_table_leaves_the_pages() {
    let mut shown = Document::clone(&page(1));
    for (panel, id) in shown.panels.iter_mut().zip(["a", "b", "a", "c"]) {
        panel.photo = Some(id.into());
    }
    shown.order = texts(&["a", "b", "c"]);
    let other = Sheet { page: Arc::new(shown.clone()), page_id: 2, sheet: 5, rest: Map::new() };
    let own = Sheet { page: Arc::new(shown.clone()), page_id: 1, sheet: 0, rest: Map::new() };
    let both = Edit::SetSheets { sheets: vec![Arc::new(own), Arc::new(other)], at: 0 };
    let add = Edit::AddPhotos { ids: texts(&["a", "b", "c"]) };
    let mut editor = played([add, both, Edit::RemovePhotos { ids: texts(&["a"]) }]);
    for sheet in editor.project().sheets() {
        let photos: Vec<_> = sheet.page.panels.iter().map(|panel| panel.photo.as_deref()).collect();
        assert_eq!((photos, sheet.page.order.len()), (vec![None, Some("b"), None, Some("c")], 2));
    }
    // After an earlier version of the page returns, the item is gone. Undo restores both.
    editor.apply(&Edit::ShowPage { page: Arc::new(shown), page_id: 1 }, &How::default());
    assert_eq!(editor.project().page().unwrap().panels[0].photo, None);
    editor.apply(&Edit::Undo, &How::default());
    editor.apply(&Edit::Undo, &How::default());
    assert_eq!(editor.project().page().unwrap().panels[0].photo.as_deref(), Some("a"));
}

#[test]
fn a_photo_in_the_place_of_another_is_it_everywhere() {
    let mut shown = Document::clone(&page(1));
    shown.panels[2].photo = Some("a".into());
    shown.order = texts(&["b", "a"]);
    let edits = [
        Edit::AddPhotos { ids: texts(&["a", "b"]) },
        Edit::ShowPage { page: Arc::new(shown), page_id: 1 },
        Edit::ExchangePhoto { id: "a".into(), by: "d".into() },
    ];
    let editor = played(edits.clone());
    let tray: Vec<_> = editor.project().tray.iter().map(|item| (item.id.as_str(), item.used)).collect();
    assert_eq!(tray, [("d", Some(true)), ("b", None)]);
    let page = editor.project().page().cloned().unwrap();
    assert_eq!(
        (page.panels[2].photo.as_deref(), page.order.as_slice()),
        (Some("d"), texts(&["b", "d"]).as_slice())
    );
    // One that is on the table already is there once.
    let editor = played(edits.into_iter().chain([Edit::ExchangePhoto { id: "d".into(), by: "b".into() }]));
    assert_eq!(editor.project().tray.len(), 1);
    assert_eq!(editor.project().page().unwrap().order, ["b"]);
}

fn custom(file: Value) -> Arc<CustomFile> {
    Arc::new(CustomFile::new(file))
}

fn shelf(ids: &[&str]) -> List<CustomFile> {
    ids.iter().map(|id| custom(json!({ "id": id }))).collect()
}

fn ids_of(list: &List<CustomFile>) -> Vec<&str> {
    list.iter().map(|item| item.id()).collect()
}

#[test]
fn what_another_project_does_to_shared_lists_no_undo_takes_back() {
    let own = |ids: &[&str]| Edit::OwnStyles { mine: shelf(ids) };
    let mut editor = played([own(&["a"]), own(&["b", "a"]), Edit::Rename { name: "x".into() }]);
    // Another tab added `c` and removed `a`.
    assert!(editor.apply(&Edit::Share { lists: vec![(Shelf::Mine, shelf(&["c", "b"]))] }, &How::default()));
    assert!(!editor.apply(&Edit::Share { lists: vec![(Shelf::Mine, shelf(&["c", "b"]))] }, &How::default()));
    let states: Vec<_> = editor.history().states().map(|state| ids_of(&state.mine).join("")).collect();
    assert_eq!(states, ["c", "c", "cb", "cb"]);
    let History { past, present, .. } = editor.history();
    assert!(std::ptr::eq(past[2].mine.as_ptr(), present.mine.as_ptr()));
}

#[test]
fn what_is_told_of_a_shot_goes_with_its_photo_and_is_undone() {
    let told = Shot { frames: Some(48), ..shot(1, true) };
    let describe =
        Edit::DescribeShots { shots: vec![("a".into(), told.clone()), ("gone".into(), told.clone())] };
    let mut editor =
        played([Edit::AddPhotos { ids: texts(&["a", "b"]) }, describe.clone(), show(1), show(2)]);
    assert_eq!(editor.project().tray[0].shot, told);
    // Repeating an edit creates no undo step.
    assert!(!editor.apply(&describe, &How::default()));
    let columns = Edit::SetBoard { board: Arc::new(board(1, true)) };
    assert!(editor.apply(&columns, &How::default()));
    assert_eq!(editor.project().tray[0].shot.frames, Some(50));
    editor.apply(&Edit::ExchangePhoto { id: "a".into(), by: "d".into() }, &How::default());
    assert_eq!(editor.project().board.order, ["c", "d", "f"]);
    assert_eq!(
        (editor.project().tray[0].id.as_str(), &editor.project().tray[0].shot.scene),
        ("d", &told.scene)
    );
    let (again, dropped) = kept::parse(&kept::write(editor.history(), &Vec::new())).unwrap();
    assert!(dropped.is_empty() && again == *editor.history());
    for _ in 0..2 {
        editor.apply(&Edit::Undo, &How::default());
    }
    assert_eq!((&editor.project().tray[0].shot, &*editor.project().board), (&told, &Board::default()));
}

#[test]
fn a_mask_corrected_by_hand_is_of_its_photo_and_cuts_its_figures_until_it_is_undone() {
    let (found, own) = (matte(3), matte(7));
    let correct = |mask: Option<Matte>, found: Option<Matte>| Edit::MaskPhoto { id: "a".into(), mask, found };
    let mut shown = Document::clone(&page(1));
    for (panel, photo) in shown.panels.iter_mut().zip(["a", "b", "a"]) {
        panel.photo = Some(photo.into());
        panel.figure = Some(found.clone());
    }
    shown.panels[2].figure = None;
    let mut editor = played([
        Edit::AddPhotos { ids: texts(&["a", "b"]) },
        Edit::ShowPage { page: Arc::new(shown), page_id: 1 },
        correct(Some(own.clone()), None),
    ]);
    let figures = |editor: &Editor| {
        let page = editor.project().page().cloned().unwrap();
        page.panels[..3].iter().map(|panel| panel.figure.clone()).collect::<Vec<_>>()
    };
    let cut = vec![Some(own.clone()), Some(found.clone()), None];
    assert_eq!(
        (editor.project().corrected_mask("a"), editor.project().corrected_mask("b")),
        (Some(&own), None)
    );
    assert_eq!(figures(&editor), cut);
    // Neither a repeated correction nor the correction of a missing photo creates an undo step.
    assert!(!editor.apply(&correct(Some(own.clone()), None), &How::default()));
    let gone = Edit::MaskPhoto { id: "gone".into(), mask: Some(own.clone()), found: None };
    assert!(!editor.apply(&gone, &How::default()));
    let (again, dropped) = kept::parse(&kept::write(editor.history(), &Vec::new())).unwrap();
    assert!(dropped.is_empty() && again == *editor.history());
    editor.apply(&Edit::Undo, &How::default());
    assert_eq!(
        (editor.project().corrected_mask("a"), figures(&editor)[0].clone()),
        (None, Some(found.clone()))
    );
    editor.apply(&Edit::Redo, &How::default());
    assert_eq!(figures(&editor), cut);
    // The detected mask counts again. Without one, no subject breaks its border.
    let mut none = editor.clone();
    editor.apply(&correct(None, Some(found.clone())), &How::default());
    assert_eq!((editor.project().corrected_mask("a"), figures(&editor)[0].clone()), (None, Some(found)));
    none.apply(&correct(None, None), &How::default());
    assert_eq!(figures(&none)[0], None);
}

#[test]
fn a_mask_stays_with_its_photo_when_another_takes_the_place() {
    let mask = |id: &str, pixels| Edit::MaskPhoto { id: id.into(), mask: Some(matte(pixels)), found: None };
    let exchange = |id: &str, by: &str| Edit::ExchangePhoto { id: id.into(), by: by.into() };
    let add = Edit::AddPhotos { ids: texts(&["a", "b"]) };
    let editor = played([add.clone(), mask("a", 3), exchange("a", "d")]);
    assert_eq!(editor.project().corrected_mask("d"), None);
    let editor = played([add, mask("a", 3), mask("b", 7), exchange("a", "b")]);
    assert_eq!(editor.project().corrected_mask("b"), Some(&matte(7)));
}

#[test]
fn a_mask_in_an_edit_is_one_or_the_edit_is_refused() {
    let mut editor = Editor::default();
    editor.apply_json(&json!({ "type": "add-photos", "ids": ["a"] }).to_string()).unwrap();
    let edit = |mask: Value| json!({ "type": "mask-photo", "id": "a", "mask": mask }).to_string();
    let told: Value = serde_json::from_str(&editor.apply_json(&edit(json!("2x1:ap"))).unwrap()).unwrap();
    assert_eq!(told["parts"]["items"], json!([{ "id": "a", "use": null, "mask": "2x1:ap" }]));
    let long = format!("320x320:{}", "a".repeat(70_000));
    for wrong in [json!("2x1:a"), json!("321x1:a321"), json!(7), json!(long)] {
        let error = editor.apply_json(&edit(wrong)).unwrap_err();
        assert_eq!(error.code(), "invalid-document");
        assert!(error.to_string().contains("mask"), "{error}");
    }
    editor.apply_json(&edit(Value::Null)).unwrap();
    assert_eq!(editor.project().corrected_mask("a"), None);
}

/// Pages of random shuffles. Some of them show photos.
fn pages() -> &'static [Arc<Document>] {
    static PAGES: OnceLock<Vec<Arc<Document>>> = OnceLock::new();
    PAGES.get_or_init(|| {
        let page = |seed| {
            let photos = PHOTOS[seed as usize % 3..].iter();
            let request = json!({ "seed": seed });
            let mut request: Request = serde_json::from_value(request).unwrap();
            request.photos = photos.map(|id| PhotoMeta::unmeasured(id, 1500, 1000)).collect();
            Arc::new(shuffle::plan(&request).unwrap())
        };
        (0..12).map(page).collect()
    })
}

const PHOTOS: [&str; 5] = ["a", "b", "c", "d", "e"];
const WORDS: [&str; 3] = ["", "One", "Two"];

fn some<'a, T>(random: &mut Rand64, of: &'a [T]) -> &'a T {
    &of[random.rand_range(0..of.len() as u64) as usize]
}

fn some_photos(random: &mut Rand64) -> Vec<String> {
    PHOTOS.iter().filter(|_| random.rand_float() < 0.4).map(|&id| id.to_owned()).collect()
}

/// Any edit; `id` is of a page that was perhaps never there.
fn edit(random: &mut Rand64) -> (Edit, How) {
    let id = random.rand_range(1..10);
    let on = random.rand_float() < 0.5;
    let photo = (*some(random, &PHOTOS)).to_owned();
    let page = some(random, pages()).clone();
    let edit = match random.rand_range(0..32) {
        0 | 1 => Edit::AddPhotos { ids: some_photos(random) },
        2 => Edit::RemovePhotos { ids: some_photos(random) },
        3 => Edit::UsePhotos { uses: vec![(photo, on)] },
        26 => Edit::StarPhoto { id: photo, on },
        4 => Edit::ExchangePhoto { id: photo, by: (*some(random, &["d", "e", "f"])).to_owned() },
        5 => Edit::ChooseBy {
            alike: on.then_some(id as u8),
            order: Some(*some(random, &[Order::Time, Order::Name])),
        },
        6 => Edit::FocusPhoto { id: photo, focus: on.then_some(Focus { x: 0.2, y: 0.7 }) },
        7 => Edit::Lock { part: *some(random, &[Part::Layout, Part::Style, Part::Photos]), on },
        8 => Edit::WantPanels { count: on.then_some(id as u32) },
        9..=12 => Edit::ShowPage { page, page_id: id },
        13 | 14 => Edit::ChangePage { page },
        15 => Edit::ChangeSettings { settings: Arc::new(page.page.clone()), page: on.then_some(page) },
        16 | 17 => {
            let count = random.rand_range(1..5);
            let sheet = |i| {
                let page = pages()[((id + i) % 12) as usize].clone();
                Arc::new(Sheet { page, page_id: i + 10, sheet: i, rest: Map::new() })
            };
            Edit::SetSheets { sheets: (0..count).map(sheet).collect(), at: (id % count) as usize }
        }
        18 => Edit::NoPage,
        19 => Edit::Design { draft: on.then(|| Arc::new(Draft::empty("d", "D"))) },
        20 => {
            let list = if random.rand_float() < 0.5 { own_styles() } else { shelf(&[]) };
            if on { Edit::OwnStyles { mine: list } } else { Edit::Favourites { favourites: list } }
        }
        21 => Edit::LovePage { page_id: id, on },
        22 => Edit::Rename { name: (*some(random, &WORDS)).to_owned() },
        23 => Edit::Styling { styling: Styling { invented: 0.5, keep_lines: on, ..Styling::default() } },
        24 => Edit::Undo,
        27 => Edit::AddWords { words: vec![word_of(&photo, &format!("{id}"))] },
        29 => Edit::DescribeShots { shots: vec![(photo, shot(id, on))] },
        30 => Edit::SetBoard { board: Arc::new(board(id, on)) },
        31 => Edit::MaskPhoto { id: photo, mask: on.then(|| matte(id)), found: None },
        28 => Edit::DropWaiting { words: vec![0] },
        _ => Edit::Redo,
    };
    let gesture = [None, None, Some("drag"), Some("other")];
    (edit, How { silent: false, gesture: some(random, &gesture).map(str::to_owned) })
}

/// A mask of one row with `pixels` pixels.
fn matte(pixels: u64) -> Matte {
    Matte::try_from(format!("{pixels}x1:p{pixels}")).unwrap()
}

/// Metadata of a shot.
fn shot(id: u64, on: bool) -> Shot {
    let more = on.then(|| ("Lens".to_owned(), json!("35")));
    Shot {
        scene: if on { "2".into() } else { String::new() },
        action: format!("Somebody enters, {id}"),
        frames: Some(id as u32 * 12),
        more: more.into_iter().collect(),
        ..Shot::default()
    }
}

fn board(id: u64, on: bool) -> Board {
    let columns = if on { texts(&["Lens", "Sound"]) } else { texts(&["Optics"]) };
    Board { fps: RATES[id as usize % 3], columns, order: texts(&["c", "a", "f"]), ..Board::default() }
}

/// A text item of a photo, made of a subtitle.
fn word_of(photo: &str, text: &str) -> NewText {
    let word = json!({ "kind": "balloon", "text": text, "panel": 0, "photo": photo, "auto": true, "cue": format!("film {text}") });
    NewText::read(word).unwrap()
}

fn own_styles() -> List<CustomFile> {
    ["x", "y"].iter().map(|id| custom(json!({ "id": id, "background": [] }))).collect()
}

/// Checks the invariants after any edit.
fn check(editor: &Editor) {
    let History { past, present, future, shown } = editor.history();
    check_photos(present);
    let ids: HashSet<u64> = shown.iter().map(|shown| shown.id).collect();
    assert_eq!(ids.len(), shown.len(), "a page is shown twice");
    assert!(present.page().is_none() || editor.history().position().is_some());
    assert!(!ids.contains(&editor.history().fresh_page_id()));
    assert!(past.len() <= 500 && future.len() <= 500 && shown.len() <= 1000);
    assert!(present.pages.active() < present.sheets().len().max(1));
    if let Some(page) = present.page() {
        assert_eq!(page.page, *present.settings);
    }
}

/// Checks the invariants of the photos in a state.
fn check_photos(state: &Project) {
    let table: HashSet<&str> = state.tray.iter().map(|item| item.id.as_str()).collect();
    assert_eq!(table.len(), state.tray.len(), "a photo is on the table twice");
    let sheets = state.sheets();
    for sheet in sheets {
        assert!(photos_on(&[&sheet.page]).is_subset(&table), "a panel shows a removed photo");
        assert!(sheet.page.order.iter().all(|id| table.contains(id.as_str())));
    }
    let places: HashSet<u64> = sheets.iter().map(|sheet| sheet.sheet).collect();
    assert_eq!(places.len(), sheets.len(), "two pages claim one place");
}

/// Undone to the start it is the start, redone to the end it is the end, saved and loaded it is the same.
fn walk(editor: &Editor, start: &Project) {
    let mut back = editor.clone();
    while back.apply(&Edit::Undo, &How::default()) {}
    assert_eq!(*back.project(), *start);
    check(&back);
    back.history().states().for_each(|state| check_photos(state));
    for _ in 0..editor.history().past.len() {
        assert!(back.apply(&Edit::Redo, &How::default()));
    }
    assert_eq!(back.project(), editor.project());
    assert_eq!(back.history().future, editor.history().future);
}

/// Saved and loaded it is the same, and so is the project file of the present state.
fn saved(editor: &Editor) {
    let (loaded, dropped) = kept::parse(&kept::write(editor.history(), &Vec::new())).unwrap();
    assert!(dropped.is_empty(), "{dropped:?}");
    assert_eq!(loaded, *editor.history());
    let photos =
        PHOTOS.map(|id| json!({ "id": id, "name": id, "path": format!("photos/{id}"), "video": "a" }));
    let videos = json!([{ "key": "a", "name": "a.mp4", "path": "videos/a.mp4", "ids": PHOTOS }]);
    let empty = json!({
        "format": "inkpanel", "version": 1, "history": { "present": {} }, "photos": photos, "videos": videos,
    });
    let mut file = ProjectFile::parse(&empty.to_string()).unwrap();
    file.history = History { past: Vec::new(), future: Vec::new(), ..editor.history().clone() };
    let opened = ProjectFile::parse(&file.write()).unwrap();
    assert!(opened.dropped.is_empty(), "{:?}", opened.dropped);
    assert_eq!(opened.history, file.history);
}

/// Runs random sequences on all cores.
fn sequences(count: u64, run: impl Fn(u64) + Sync) {
    std::thread::scope(|scope| {
        for part in 0..4 {
            let run = &run;
            scope.spawn(move || (part * count / 4..(part + 1) * count / 4).for_each(run));
        }
    });
}

#[test]
fn whatever_is_done_can_be_undone_and_saved() {
    sequences(crate::trials(1000, 10_000), |seed| {
        let mut random = Rand64::new(u128::from(seed));
        let mut editor = Editor::default();
        let mut steps: Vec<Project> = Vec::new();
        for _ in 0..50 {
            let (edit, how) = edit(&mut random);
            let before = editor.clone();
            let changed = editor.apply(&edit, &how);
            assert!(changed || editor.history() == before.history());
            // Number of undo steps, as an observer counts them.
            let grown = editor.history().past.len();
            match edit {
                Edit::Undo => drop(steps.pop()),
                _ if grown > before.history().past.len() => steps.push(before.project().clone()),
                _ => {}
            }
            assert_eq!(grown, steps.len());
            check(&editor);
        }
        for (kept, told) in editor.history().past.iter().zip(&steps) {
            assert_eq!(**kept, *told, "a step was changed afterwards");
        }
        walk(&editor, &Project::default());
        saved(&editor);
    });
}

/// Edits without an undo step, between edits with one. They change all states, which must remain valid.
#[test]
fn what_changes_all_times_leaves_every_state_whole() {
    sequences(crate::trials(1000, 10_000), |seed| {
        let mut random = Rand64::new(u128::from(seed) << 64);
        let mut editor = Editor::default();
        let mut lost = HashSet::new();
        for _ in 0..50 {
            let (edit, how) = match random.rand_range(0..10) {
                0 => (Edit::ForgetPhotos { ids: some_photos(&mut random) }, How::default()),
                1 => {
                    let list = if random.rand_float() < 0.5 { own_styles() } else { shelf(&[]) };
                    (
                        Edit::Share {
                            lists: vec![(*some(&mut random, &[Shelf::Mine, Shelf::Favourites]), list)],
                        },
                        How::default(),
                    )
                }
                kind => {
                    let (edit, how) = edit(&mut random);
                    (edit, How { silent: kind < 4, ..how })
                }
            };
            let forgets = editor.apply(&edit, &how);
            match &edit {
                // No state lists these photos. They return only if they are added again.
                Edit::ForgetPhotos { ids } if forgets => lost.extend(ids.iter().cloned()),
                Edit::AddPhotos { ids } => lost.retain(|id| !ids.contains(id)),
                Edit::ExchangePhoto { by, .. } => lost.retain(|id| id != by),
                _ => {}
            }
            check(&editor);
        }
        for state in editor.history().states() {
            check_photos(state);
            assert!(!state.tray.iter().any(|item| lost.contains(&item.id)), "a forgotten photo came back");
        }
        let first = editor.history().states().next().unwrap().clone();
        walk(&editor, &first);
        saved(&editor);
    });
}

#[test]
fn an_edit_in_json_tells_what_it_changed_or_changes_nothing() {
    let mut editor = Editor::default();
    let mut apply = |edit: Value| {
        editor.apply_json(&edit.to_string()).map(|told| serde_json::from_str::<Value>(&told).unwrap())
    };
    let told = apply(json!({ "type": "add-photos", "ids": ["a", "b"] })).unwrap();
    assert_eq!(told["parts"]["items"], json!([{ "id": "a", "use": null }, { "id": "b", "use": null }]));
    assert_eq!((&told["parts"]["trays"], &told["present"]), (&json!([[0, 1]]), &json!({ "tray": 0 })));
    let steps = |told: &Value| json!([told["undos"], told["redos"], told["stepped"], told["changed"]]);
    assert_eq!(steps(&told), json!([1, 0, true, true]));
    assert_eq!((&told["entries"], &told["shown"]), (&json!([]), &json!([])));
    // The page has the settings of a new project, so these do not change.
    let mut full: Value = serde_json::from_str(&page(3).to_json()).unwrap();
    full["page"]["forScreens"] = json!(true);
    let told = apply(json!({ "type": "show-page", "page": full, "pageId": 4 })).unwrap();
    assert_eq!(
        (&told["parts"]["pages"], &told["present"]),
        (&json!([full]), &json!({ "page": 0, "pageId": 4 }))
    );
    assert_eq!((steps(&told), &told["edits"]), (json!([2, 0, true, true]), &json!([])));
    assert_eq!((&told["entries"], &told["shown"]), (&json!([{ "id": 4, "page": 0 }]), &json!([[0, 1]])));
    assert_eq!((&told["pageId"], &told["sheet"]), (&json!(5), &json!(1)));
    // A known page is referenced by its id in both directions. It is the second of the two shown pages, after
    // the current page.
    let mut other = page(5).to_json().parse::<Value>().unwrap();
    other["page"]["forScreens"] = json!(true);
    apply(json!({ "type": "show-page", "page": other, "pageId": 5 })).unwrap();
    let told = apply(json!({ "type": "show-page", "pageId": 4 })).unwrap();
    assert_eq!((&told["parts"]["pages"], &told["present"]), (&json!([]), &json!({ "page": 1, "pageId": 4 })));
    // The answer to an undo contains the fields that it brings back. Their parts may be known.
    let told = apply(json!({ "type": "undo" })).unwrap();
    assert_eq!((&told["parts"]["pages"], &told["shown"]), (&json!([]), &json!([[0, 2]])));
    assert_eq!(
        (&told["present"], steps(&told)),
        (&json!({ "page": 2, "pageId": 5 }), json!([3, 1, true, true]))
    );
    let told = apply(json!({ "type": "love-page", "pageId": 4, "on": false })).unwrap();
    assert_eq!((&told["present"], steps(&told)), (&json!({}), json!([3, 1, false, false])));
    // The answer contains only the starred photo, because the other one is known.
    let told = apply(json!({ "type": "star-photo", "id": "b", "on": true })).unwrap();
    assert_eq!(told["parts"]["items"], json!([{ "id": "b", "use": null, "starred": true }]));
    assert_eq!(told["parts"]["trays"], json!([[0, 2]]));
    for (wrong, place) in [
        (json!({ "type": "show-page", "pageId": 9 }), "page"),
        (json!({ "type": "fly" }), "type"),
        (json!({ "type": "add-photos", "ids": [1] }), "ids[0]"),
        (json!([]), ""),
    ] {
        let error = apply(wrong).unwrap_err();
        assert_eq!(error.code(), "invalid-document");
        assert!(error.to_string().contains(place), "{error}");
    }
    assert_eq!(editor.history().past.len(), 4);
}

#[test]
fn a_name_has_an_end() {
    let mut editor = Editor::default();
    editor.apply_json(&json!({ "type": "rename", "name": "é".repeat(2_000) }).to_string()).unwrap();
    assert_eq!(editor.project().name, "é".repeat(1_000));
}

#[test]
fn a_forgotten_photo_is_gone_from_the_pages_of_all_times_and_what_these_share_they_share() {
    let mut shown = Document::clone(&page(1));
    shown.panels[0].photo = Some("a".into());
    shown.order = texts(&["a"]);
    let mut editor = played([
        Edit::AddPhotos { ids: texts(&["a", "b"]) },
        Edit::ShowPage { page: Arc::new(shown), page_id: 1 },
        Edit::Rename { name: "One".into() },
        show(2),
    ]);
    assert!(editor.apply(&Edit::ForgetPhotos { ids: texts(&["a"]) }, &How::default()));
    let history = editor.history();
    assert!(history.shown.iter().all(|shown| photos_on(&[&shown.page]).is_empty()));
    assert!(history.states().all(|state| state.tray.iter().all(|item| item.id != "a")));
    let before = history.past.iter().rev().find_map(|state| state.pages.edited()).unwrap();
    assert!(
        history
            .past
            .iter()
            .filter_map(|state| state.pages.edited())
            .all(|sheet| Arc::ptr_eq(&sheet.page, &before.page))
    );
    assert!(Arc::ptr_eq(&history.shown[0].page, &before.page));
    assert!(!editor.apply(&Edit::ForgetPhotos { ids: texts(&["a"]) }, &How::default()));
}

#[test]
fn what_was_done_to_a_list_is_done_to_another_state_of_it() {
    sequences(2_000, |seed| {
        let mut random = Rand64::new(u128::from(seed));
        let mut some_list = || -> List<CustomFile> {
            let mut items = Vec::new();
            for id in ["a", "b", "c", "d"] {
                if random.rand_float() < 0.6 {
                    items.push(custom(json!({ "id": id, "name": random.rand_range(0..2) })));
                }
            }
            items.into()
        };
        let (state, before, after) = (some_list(), some_list(), some_list());
        assert_eq!(own::carried(&before, &before, &after), after);
        assert_eq!(own::carried(&state, &before, &before), state);
        let plain = |list: &List<CustomFile>| list.iter().map(|item| item.json().clone()).collect::<Value>();
        let told =
            json!({ "list": plain(&state), "before": plain(&before), "after": plain(&after) }).to_string();
        let found: Vec<Value> = serde_json::from_str(&own::carried_json(&told).unwrap()).unwrap();
        let found: List<CustomFile> = found.into_iter().map(custom).collect();
        assert_eq!(found, own::carried(&state, &before, &after));
        let has = |list: &List<CustomFile>, id: &str| ids_of(list).contains(&id);
        assert_eq!(ids_of(&found).iter().collect::<HashSet<_>>().len(), found.len());
        for id in ["a", "b", "c", "d"] {
            if has(&after, id) && !has(&before, id) {
                assert!(has(&found, id));
            }
            if has(&before, id) && !has(&after, id) {
                assert!(!has(&found, id));
            }
        }
    });
    assert_eq!(own::carried_json("{\"list\": 1}").unwrap_err().code(), "invalid-document");
}

#[test]
fn the_lists_of_a_project_join_those_that_are_there() {
    let styles = |count: usize, of: &str| -> List<CustomFile> {
        (0..count).map(|i| custom(json!({ "id": format!("{of}{i}"), "background": [] }))).collect()
    };
    let mut editor =
        played([Edit::OwnStyles { mine: styles(900, "a") }, Edit::Favourites { favourites: styles(1, "f") }]);
    let steps = editor.history().past.len();
    editor.apply(&Edit::Join { lists: vec![(Shelf::Mine, styles(900, "b"))] }, &How::default());
    let mine = ids_of(&editor.project().mine);
    assert_eq!((mine.len(), mine[0], mine[999]), (1_000, "b0", "a99"));
    assert_eq!((ids_of(&editor.project().favourites), editor.history().past.len()), (vec!["f0"], steps));
}

#[test]
fn a_list_that_many_share_never_grows_too_long_to_be_opened() {
    let many = |from: usize| {
        (from..from + 1000)
            .map(|i| custom(json!({ "id": format!("{i}"), "background": [] })))
            .collect::<List<CustomFile>>()
    };
    let mut editor = played([Edit::OwnStyles { mine: many(0) }, Edit::OwnStyles { mine: shelf(&[]) }]);
    editor.apply(&Edit::Undo, &How::default());
    editor.apply(&Edit::Redo, &How::default());
    editor.apply(&Edit::Share { lists: vec![(Shelf::Mine, many(1000))] }, &How::default());
    saved(&editor);
}

#[test]
fn what_is_shared_in_memory_is_shared_in_what_is_saved() {
    let photos: Vec<String> = (0..1_000).map(|i| format!("photo-{i}")).collect();
    let mut editor = played([Edit::AddPhotos { ids: photos.clone() }]);
    for i in 0..600 {
        editor.apply(&Edit::UsePhotos { uses: vec![(photos[i % 50].clone(), i % 2 == 0)] }, &How::default());
        editor.apply(&show(i as u64 + 1), &How::default());
    }
    let text = kept::write(editor.history(), &Vec::new());
    assert!(text.len() < 4_000_000, "{}", text.len());
    let (loaded, _) = kept::parse(&text).unwrap();
    assert_eq!(loaded, *editor.history());
    let items: HashSet<_> = loaded.states().flat_map(|state| state.tray.iter().map(Arc::as_ptr)).collect();
    assert!(items.len() < 2_000, "{}", items.len());
}

fn metas(count: usize) -> Vec<PhotoMeta> {
    (0..count).map(|i| PhotoMeta::unmeasured(&format!("p{i}"), 1500, 1000)).collect()
}

/// An editor of a project of one page.
fn opened(photos: &[PhotoMeta]) -> Editor {
    let mut editor = played([Edit::AddPhotos { ids: photos.iter().map(|photo| photo.id.clone()).collect() }]);
    let planning = Planning::new(editor.project(), photos);
    let mut request = planning.request(1);
    (request.keep.layout, request.keep.style, request.keep.photos) = (false, false, false);
    request.panels = Some(photos.len().min(6));
    let page = planning.plan(request, None).unwrap().unwrap();
    editor.apply(&Edit::ShowPage { page: Arc::new(page), page_id: 1 }, &How::default());
    editor
}

fn spread(editor: &mut Editor, photos: &[PhotoMeta], seeds: &mut Seeds) {
    let fresh = (editor.history().fresh_page_id(), editor.history().fresh_sheet());
    let planning = Planning::new(editor.project(), photos);
    if let Some(sheets) = planning.spread(fresh, seeds).unwrap() {
        editor.apply(&Edit::SetSheets { sheets, at: 0 }, &How::default());
    }
}

fn shown(editor: &Editor) -> Vec<Vec<String>> {
    let photos =
        |sheet: &Arc<Sheet>| sheet.page.panels.iter().filter_map(|panel| panel.photo.clone()).collect();
    editor.project().sheets().iter().map(photos).collect()
}

#[test]
fn frames_of_a_video_keep_their_order_on_a_page() {
    let frames: Vec<PhotoMeta> =
        metas(6).into_iter().map(|photo| PhotoMeta { frame: true, taken: None, ..photo }).collect();
    let photos: Vec<PhotoMeta> =
        frames.iter().map(|frame| PhotoMeta { frame: false, ..frame.clone() }).collect();
    let editor = played([Edit::AddPhotos { ids: frames.iter().map(|photo| photo.id.clone()).collect() }]);
    let is_in_order = |photos: &[PhotoMeta], seed: u32| {
        let planning = Planning::new(editor.project(), photos);
        let request = Request {
            panels: Some(6),
            keep: Keep { layout: false, style: false, photos: false },
            ..planning.request(seed)
        };
        let page = planning.plan(request, Some(planning.photos[..6].to_vec())).unwrap().unwrap();
        let mut read: Vec<String> =
            page.reading_order().into_iter().filter_map(|panel| page.panels[panel].photo.clone()).collect();
        read.dedup();
        read.is_sorted()
    };
    assert!((1..9).all(|seed| is_in_order(&frames, seed)));
    // A photo that is still being read is not on the page.
    let unread = [&frames[..], &[PhotoMeta::unmeasured("unread", 1600, 1200)]].concat();
    assert!((1..9).all(|seed| is_in_order(&unread, seed)));
    assert!(!(1..9).all(|seed| is_in_order(&photos, seed)), "the order of photos without dates is free");
}

#[test]
fn an_album_is_spread_over_pages_in_order_in_one_style() {
    let photos = metas(40);
    let mut editor = opened(&photos);
    let before = editor.project().clone();
    let style = before.page().unwrap().style.clone();
    spread(&mut editor, &photos, &mut Seeds::new(5));
    // Each photo gets the panel of its page that fits best.
    let number = |id: &String| id[1..].parse::<usize>().unwrap();
    let mut pages = shown(&editor);
    for page in &mut pages {
        page.sort_by_key(number);
    }
    assert_eq!(pages.concat(), photos.iter().map(|photo| photo.id.clone()).collect::<Vec<_>>());
    let sheets = editor.project().sheets();
    assert_eq!(sheets.len(), 7);
    assert!(sheets.iter().all(|sheet| sheet.page.style == style));
    assert!(sheets.windows(3).all(|three| three[0].page.layout != three[2].page.layout));
    assert_eq!(sheets[0].sheet, before.sheet());
    editor.apply(&Edit::Undo, &How::default());
    assert_eq!(*editor.project(), before);
}

#[test]
fn spreading_takes_the_wanted_number_of_panels_or_the_locked_layout_and_keeps_words_on_their_photos() {
    let photos = metas(13);
    let mut editor = opened(&photos);
    editor.apply(&Edit::WantPanels { count: Some(4) }, &How::default());
    let mut page = Document::clone(editor.project().page().unwrap());
    page.words = vec![
        TextItem { panel: Some(5), ..TextItem::new(TextKind::Caption, "Here") },
        TextItem::new(TextKind::Effect, "BAM"),
    ];
    let (here, first) = (page.panels[5].photo.clone(), page.panels[0].photo.clone());
    editor.apply(&Edit::ChangePage { page: Arc::new(page) }, &How::default());
    let mut seeds = Seeds::new(3);
    spread(&mut editor, &photos, &mut seeds);
    assert_eq!(shown(&editor).iter().map(Vec::len).collect::<Vec<_>>(), [4, 3, 3, 3]);
    let words: Vec<_> = editor
        .project()
        .sheets()
        .iter()
        .flat_map(|sheet| {
            let on = |word: &TextItem| sheet.page.panels[word.panel.unwrap_or(0)].photo.clone();
            sheet.page.words.iter().map(|word| (word.text.clone(), on(word))).collect::<Vec<_>>()
        })
        .collect();
    assert!(words.contains(&("Here".into(), here)) && words.len() == 2, "{words:?}");
    assert!(words.iter().any(|(text, _)| text == "BAM") && first.is_some());
    editor.apply(&Edit::Lock { part: Part::Layout, on: true }, &How::default());
    let layout = editor.project().page().unwrap().layout.clone();
    spread(&mut editor, &photos, &mut seeds);
    let sheets = editor.project().sheets();
    assert_eq!(shown(&editor).iter().map(Vec::len).collect::<Vec<_>>(), [4, 4, 4, 1]);
    assert!(sheets[..3].iter().all(|sheet| sheet.page.layout == layout));
}

/// Returns the place of each text item with a photo: its text, and the photo of its panel, or `None` if it is
/// unplaced.
fn homes(project: &Project) -> Vec<(String, Option<String>)> {
    let text = |word: &TextItem| word.text.clone();
    let sheets = project.sheets();
    let shown = sheets.iter().flat_map(|sheet| {
        let on = |word: &TextItem| sheet.page.panels[word.panel.unwrap()].photo.clone();
        sheet.page.words.iter().map(move |word| (text(word), on(word)))
    });
    let mut all: Vec<_> = shown.chain(project.waiting.iter().map(|word| (text(word), None))).collect();
    all.sort();
    all
}

#[test]
fn words_stay_with_their_photos_whatever_becomes_of_the_page() {
    let photos = metas(14);
    for seed in 0..12 {
        let mut random = Rand64::new(u128::from(seed));
        let mut seeds = Seeds::new(seed);
        let mut editor = opened(&photos);
        let first = editor.project().page().unwrap().panels[0].photo.clone().unwrap();
        let last = photos.last().unwrap().id.clone();
        let words = vec![word_of(&first, "one"), word_of(&last, "two"), word_of("nobody", "three")];
        assert!(editor.apply(&Edit::AddWords { words: words.clone() }, &How::default()));
        assert!(!editor.apply(&Edit::AddWords { words }, &How::default()), "a subtitle came twice");
        let homed = |editor: &Editor, what: &str| {
            let project = editor.project();
            let seen: Vec<String> = shown(editor).concat();
            let home = |photo: &str| seen.iter().any(|seen| seen == photo).then(|| photo.to_owned());
            let mut wanted = vec![
                ("one".to_owned(), home(&first)),
                ("two".to_owned(), home(&last)),
                ("three".into(), None),
            ];
            wanted.sort();
            assert_eq!(homes(project), wanted, "seed {seed}: {what}");
        };
        homed(&editor, "added");
        for _ in 0..12 {
            let before = editor.project().clone();
            let what = random.rand_range(0..6);
            match what {
                // Other layouts, styles and photos.
                0..=2 => {
                    let keep = Keep { layout: what == 1, style: what != 1, photos: what != 2 };
                    let mode = if what == 2 { Mode::Photos } else { Mode::Shuffle };
                    let planning = Planning::new(editor.project(), &photos);
                    let request = Request { keep, mode, ..planning.request(seeds.next_seed()) };
                    let page = planning.plan(request, None).unwrap().unwrap();
                    let page_id = editor.history().fresh_page_id();
                    editor.apply(&Edit::ShowPage { page: Arc::new(page), page_id }, &How::default());
                }
                // The user swaps two photos.
                3 => {
                    let mut page = Document::clone(editor.project().page().unwrap());
                    page.merges.clear();
                    let count = page.panels.len();
                    page.panels.swap(0, count - 1);
                    editor.apply(&Edit::ChangePage { page: Arc::new(page) }, &How::default());
                }
                4 => spread(&mut editor, &photos, &mut seeds),
                // Another page is edited.
                _ => {
                    let sheets = editor.project().sheets().to_vec();
                    let at = random.rand_range(0..sheets.len() as u64) as usize;
                    editor.apply(&Edit::SetSheets { sheets, at }, &How::default());
                }
            }
            homed(&editor, &format!("after {what}"));
            editor.apply(&Edit::Undo, &How::default());
            assert_eq!(*editor.project(), before, "seed {seed}: undone {what}");
            editor.apply(&Edit::Redo, &How::default());
            homed(&editor, "done again");
        }
        let kept = kept::write(editor.history(), &Vec::new());
        assert_eq!(kept::parse(&kept).unwrap().0, *editor.history());
    }
}

#[test]
fn a_word_that_was_removed_by_hand_stays_away_and_one_moved_to_another_photo_is_of_that() {
    let photos = metas(6);
    let mut editor = opened(&photos);
    let page = |editor: &Editor| Document::clone(editor.project().page().unwrap());
    let [one, two] = [0, 1].map(|panel: usize| page(&editor).panels[panel].photo.clone().unwrap());
    editor.apply(&Edit::AddWords { words: vec![word_of(&one, "a"), word_of(&one, "b")] }, &How::default());
    let mut changed = page(&editor);
    changed.words.remove(0);
    (changed.words[0].panel, changed.words[0].photo) = (Some(1), None);
    editor.apply(&Edit::ChangePage { page: Arc::new(changed) }, &How::default());
    assert_eq!(homes(editor.project()), [("b".to_owned(), Some(two.clone()))]);
    // One photo replaces another, and takes over its dialogue.
    editor.apply(&Edit::ExchangePhoto { id: two, by: "new".into() }, &How::default());
    assert_eq!(homes(editor.project()), [("b".to_owned(), Some("new".into()))]);
    // Long speech is split into linked balloons of one speaker. Speech of another speaker is not linked.
    let mut parts = vec![word_of(&one, "c"), word_of(&one, "d"), word_of(&one, "e"), word_of(&one, "f")];
    parts[1].joins = true;
    parts[3].item.by = Some("anna".into());
    editor.apply(&Edit::AddWords { words: parts }, &How::default());
    let words = page(&editor).words;
    let said = &words[words.len() - 4..];
    assert!(said[0].by.is_some() && said[0].by == said[1].by, "{said:?}");
    assert_eq!((&said[2].by, said[3].by.as_deref()), (&None, Some("anna")));
    assert!(said.iter().all(|word| word.joined.is_none()), "where they hang is found when they are placed");
}

#[test]
fn no_page_is_a_leftover() {
    for count in 1..100 {
        let sizes = balanced(count, 6, &[1, 2, 3, 4, 5, 6]);
        assert_eq!(sizes.iter().sum::<usize>(), count);
        assert!(sizes.iter().max().unwrap() - sizes.iter().min().unwrap() <= 1 && sizes[0] <= 6);
    }
    assert_eq!(balanced(13, 6, &[2, 4]), [4, 4, 4, 1]);
    assert_eq!(balanced(5, 6, &[]), [5]);
}

/// A page with `count` text items on its first panel.
fn worded(page: &Document, count: usize) -> Arc<Document> {
    let word = TextItem { panel: Some(0), ..TextItem::new(TextKind::Caption, "x") };
    Arc::new(Document { words: vec![word; count], ..page.clone() })
}

#[test]
fn a_large_album_has_no_more_pages_than_a_storyboard_each_with_no_more_words_than_a_page() {
    let photos = metas(2_500);
    let mut editor = opened(&photos);
    let mut sheets = editor.project().sheets().to_vec();
    let again = sheets[0].page.clone();
    sheets = (0..2)
        .map(|i| {
            let page = worded(&again, 150);
            Arc::new(Sheet { page, page_id: 90 + i, sheet: 90 + i, rest: Map::new() })
        })
        .collect();
    editor.apply(&Edit::SetSheets { sheets, at: 0 }, &How::default());
    editor.apply(&Edit::WantPanels { count: Some(1) }, &How::default());
    spread(&mut editor, &photos, &mut Seeds::new(1));
    let sheets = editor.project().sheets();
    assert!(sheets.len() <= limits::MOST_SHEETS, "{}", sheets.len());
    assert_eq!(shown(&editor).concat().len(), 2_500);
    assert_eq!(sheets.iter().map(|sheet| sheet.page.words.len()).max(), Some(limits::MOST_WORDS));
    let mut editor = opened(&photos);
    let splash = Document::clone(&page(1));
    let splash = Document { layout: "splash".into(), panels: splash.panels[..1].to_vec(), ..splash };
    editor.apply(&Edit::ChangePage { page: Arc::new(splash) }, &How::default());
    editor.apply(&Edit::Lock { part: Part::Layout, on: true }, &How::default());
    let planning = Planning::new(editor.project(), &photos);
    let sheets = planning.spread((100, 100), &mut Seeds::new(1)).unwrap().unwrap();
    assert!(sheets.len() <= limits::MOST_SHEETS, "{}", sheets.len());
}

/// Twelve photos on two pages of six.
fn two_pages() -> (Vec<PhotoMeta>, Editor) {
    let photos = metas(12);
    let mut editor = opened(&photos);
    spread(&mut editor, &photos, &mut Seeds::new(1));
    assert_eq!(editor.project().sheets().len(), 2);
    (photos, editor)
}

#[test]
fn words_that_no_page_has_room_for_are_unplaced_and_saved() {
    let (_, mut editor) = two_pages();
    let sheet = editor.project().sheets()[0].sheet;
    let new = |word: Value| NewText::read(word).unwrap();
    let on_panel = |i| new(json!({ "kind": "balloon", "text": format!("{i}"), "panel": 0, "sheet": sheet }));
    let loose = |i| new(json!({ "kind": "balloon", "text": format!("loose {i}") }));
    let over = 50;
    let words = (0..limits::MOST_WORDS + over).map(on_panel).chain((0..limits::MOST_WAITING).map(loose));
    assert!(editor.apply(&Edit::AddWords { words: words.collect() }, &How::default()));
    let project = editor.project();
    assert_eq!(project.sheets()[0].page.words.len(), limits::MOST_WORDS);
    let waiting: Vec<&str> = project.waiting.iter().map(|word| word.text.as_str()).collect();
    assert_eq!(waiting.len(), limits::MOST_WAITING);
    let on_page = waiting.iter().filter(|text| !text.starts_with("loose")).count();
    assert_eq!(on_page, over);
    saved(&editor);
}

#[test]
fn a_page_that_wants_more_photos_than_are_free_for_it_takes_from_all() {
    let (photos, editor) = two_pages();
    let planning = Planning::new(editor.project(), &photos);
    let own = photos_on(planning.project.page().as_slice()).len();
    assert_eq!(planning.free(&planning.elsewhere(), planning.project.page()).len(), own);
    let count = |panels| {
        let mut request = planning.request(5);
        (request.keep.layout, request.keep.photos, request.panels) = (false, false, Some(panels));
        let page = planning.plan(request, None).unwrap().unwrap();
        let elsewhere = photos_on(&planning.elsewhere());
        let shown = photos_on(&[&page]);
        (shown.len(), shown.intersection(&elsewhere).count() > 0)
    };
    assert_eq!(count(4), (4, false));
    assert_eq!(count(9), (9, true));
}

#[test]
fn a_photo_that_goes_out_of_use_leaves_the_other_pages_for_the_one_of_its_stack() {
    let (mut photos, mut editor) = two_pages();
    editor.apply(&Edit::SetSheets { sheets: editor.project().sheets().to_vec(), at: 1 }, &How::default());
    let torn = |editor: &Editor, photos: &[PhotoMeta]| Planning::new(editor.project(), photos).torn();
    assert!(!torn(&editor, &photos));
    let gone = photos.remove(2).id;
    let of_gone = |panel: &inkpanel_engine::page::document::PanelContent| panel.photo.as_ref() == Some(&gone);
    let place = editor.project().sheets()[0].page.panels.iter().position(of_gone).unwrap();
    // It is similar to a photo on no page, and to a photo on another page.
    photos.push(PhotoMeta::unmeasured("twin", 1500, 1000));
    let ids = [gone.clone(), "twin".to_owned(), photos[8].id.clone()];
    let groups: Groups = ids.map(|id| (id, json!(3))).into_iter().collect();
    assert!(torn(&editor, &photos));
    let planning = Planning::new(editor.project(), &photos);
    let (sheets, at) = planning.repaired(&groups).unwrap().unwrap();
    let before = editor.project().sheets();
    let photo = |sheet: &Sheet, panel: usize| sheet.page.panels[panel].photo.clone();
    assert_eq!((at, photo(&sheets[0], place).as_deref()), (1, Some("twin")));
    assert_eq!(sheets[0].page.layout, before[0].page.layout);
    assert!(Arc::ptr_eq(&sheets[1].page, &before[1].page));
    // If no photo is left for it, the page is removed.
    let last = Planning::new(editor.project(), &photos[6..11]);
    assert_eq!(last.repaired(&Groups::new()).unwrap().map(|(sheets, at)| (sheets.len(), at)), Some((1, 0)));
}

#[test]
fn other_paper_changes_what_it_must() {
    let (photos, mut editor) = two_pages();
    let planning = Planning::new(editor.project(), &photos);
    let page = planning.project.page().unwrap();
    let settings = &page.page;
    let wider = PageSettings { gutter: 0.03, ..settings.clone() };
    let same = planning.on_paper(page, &wider).unwrap();
    assert_eq!((&same.layout, &same.order, &same.page), (&page.layout, &page.order, &wider));
    // A page among others retains its photos in any layout.
    let wide = PageSettings { width: settings.height, height: settings.width / 2, ..settings.clone() };
    let template = layout::find(page.layout.built_in().unwrap()).unwrap();
    let turned = planning.on_paper(page, &wide).unwrap();
    assert_eq!(turned.layout == page.layout, template.good_for(wide.aspect()));
    assert_eq!(photos_on(&[&turned]), photos_on(&[page]));
    let none = Planning::new(editor.project(), &[]);
    assert_eq!(none.on_paper(page, &wide).unwrap(), Document { page: wide.clone(), ..page.clone() });
    editor.apply(&Edit::Lock { part: Part::Layout, on: true }, &How::default());
    let locked = Planning::new(editor.project(), &photos);
    let page = locked.project.page().unwrap();
    assert_eq!(locked.on_paper(page, &wide).unwrap().layout, page.layout);
}

#[test]
fn a_page_comes_back_with_photos_of_the_table_on_the_paper_of_the_others() {
    let (photos, mut editor) = two_pages();
    let page = editor.project().page().cloned().unwrap();
    let back = |editor: &Editor, photos: &[PhotoMeta]| {
        Planning::new(editor.project(), photos).brought_back(&page).unwrap()
    };
    assert_eq!(back(&editor, &photos), page);
    let paper = PageSettings { gutter: 0.03, ..page.page.clone() };
    let settings = Arc::new(paper.clone());
    let now = Arc::new(Document { page: paper.clone(), ..Document::clone(&page) });
    editor.apply(&Edit::ChangeSettings { settings, page: Some(now) }, &How::default());
    assert_eq!(back(&editor, &photos).page, paper);
    editor.apply(&Edit::RemovePhotos { ids: vec![photos[0].id.clone()] }, &How::default());
    let back = back(&editor, &photos[1..]);
    assert!(back.panels.iter().all(|panel| panel.photo.as_ref().is_some_and(|id| *id != photos[0].id)));
    // The only page of a project returns with its old paper.
    let mut alone = opened(&photos);
    let settings = Arc::new(paper);
    let now = alone.project().page().cloned().map(Arc::new);
    alone.apply(&Edit::ChangeSettings { settings, page: now }, &How::default());
    assert_eq!(Planning::new(alone.project(), &photos).brought_back(&page).unwrap(), page);
}

/// User actions that move photos between pages. After each, a photo is on one page only, if there are enough
/// photos.
#[test]
fn no_two_pages_claim_one_photo() {
    sequences(crate::trials(100, 1_000), |seed| {
        let mut random = Rand64::new(u128::from(seed));
        let mut seeds = Seeds::new(seed);
        let all = metas(6 + (seed % 20) as usize);
        let mut photos = all.clone();
        let mut editor = opened(&photos);
        for _ in 0..12 {
            match random.rand_range(0..6) {
                0 => spread(&mut editor, &photos, &mut seeds),
                1 => {
                    let planning = Planning::new(editor.project(), &photos);
                    let Some(page) = planning.another(&mut seeds).unwrap() else { continue };
                    let (page_id, place) = (editor.history().fresh_page_id(), editor.history().fresh_sheet());
                    let mut sheets = editor.project().sheets().to_vec();
                    // With too few unused photos, the page takes any photo.
                    let shown = photos_on(&sheets.iter().map(|sheet| &*sheet.page).collect::<Vec<_>>());
                    if photos.iter().filter(|photo| !shown.contains(photo.id.as_str())).count() < 2 {
                        continue;
                    }
                    let at = editor.project().pages.active() + 1;
                    sheets.insert(
                        at,
                        Arc::new(Sheet { page: Arc::new(page), page_id, sheet: place, rest: Map::new() }),
                    );
                    editor.apply(&Edit::SetSheets { sheets, at }, &How::default());
                }
                2 => {
                    // One photo leaves the table.
                    if photos.len() < 4 {
                        continue;
                    }
                    let gone = photos.remove(random.rand_range(0..photos.len() as u64) as usize).id;
                    let how = How { silent: false, gesture: Some("gone".into()) };
                    editor.apply(&Edit::RemovePhotos { ids: vec![gone] }, &how);
                    let planning = Planning::new(editor.project(), &photos);
                    if let Some(page) = planning.refitted(false, seeds.next_seed()).unwrap() {
                        let page_id = editor.history().fresh_page_id();
                        editor.apply(&Edit::ShowPage { page: Arc::new(page), page_id }, &how);
                    }
                    let planning = Planning::new(editor.project(), &photos);
                    if let Some((sheets, at)) = planning.repaired(&Groups::new()).unwrap() {
                        editor.apply(&Edit::SetSheets { sheets, at }, &How { silent: true, gesture: None });
                    }
                }
                3 => {
                    // Another layout, or other photos.
                    let planning = Planning::new(editor.project(), &photos);
                    let mut request = planning.request(seeds.next_seed());
                    request.keep.layout = random.rand_float() < 0.5;
                    request.keep.photos = !request.keep.layout;
                    let Some(page) = planning.plan(request, None).unwrap() else { continue };
                    let page_id = editor.history().fresh_page_id();
                    editor.apply(&Edit::ShowPage { page: Arc::new(page), page_id }, &How::default());
                }
                4 => {
                    let sheets = editor.project().sheets().to_vec();
                    let at = random.rand_range(0..sheets.len() as u64) as usize;
                    editor.apply(&Edit::SetSheets { sheets, at }, &How { silent: true, gesture: None });
                }
                _ => {
                    let mut sheets = editor.project().sheets().to_vec();
                    if sheets.len() > 1 {
                        sheets.remove(editor.project().pages.active());
                        editor.apply(&Edit::SetSheets { sheets, at: 0 }, &How::default());
                    }
                }
            }
            check(&editor);
            let sheets = editor.project().sheets();
            let places: usize = sheets.iter().map(|sheet| photos_on(&[&sheet.page]).len()).sum();
            if places <= photos.len() {
                assert_eq!(editor.project().claimed_twice(), Vec::<String>::new(), "seed {seed}");
            }
            // Every panel of every page shows a photo that is in use.
            let used: HashSet<&str> = photos.iter().map(|photo| photo.id.as_str()).collect();
            for sheet in sheets {
                let full =
                    |photo: &Option<String>| photo.as_deref().is_some_and(|photo| used.contains(photo));
                assert!(sheet.page.panels.iter().all(|panel| full(&panel.photo)), "seed {seed}");
            }
        }
        let start = Project::default();
        walk(&editor, &start);
    });
}

/// The change in the format of the core.
fn told(change: &Value) -> Value {
    let full = |seed: &Value, gutter: Option<&Value>| {
        let mut made: Value = serde_json::from_str(&page(seed.as_u64().unwrap() as u32).to_json()).unwrap();
        if let Some(gutter) = gutter {
            made["page"]["gutter"] = gutter.clone();
        }
        made
    };
    let mut change = change.clone();
    if change["page"].is_u64() {
        change["page"] = full(&change["page"], change.get("settings"));
    }
    if change.get("settings").is_some() {
        change["settings"] = change["page"]["page"].clone();
    }
    for sheet in change.get_mut("sheets").and_then(Value::as_array_mut).into_iter().flatten() {
        sheet["page"] = full(&sheet["page"], None);
    }
    change
}

/// A state in the format of the oracle.
fn state_of(project: &Project) -> Value {
    let history = History { present: Arc::new(project.clone()), ..History::default() };
    let mut written: Value = serde_json::from_str(&kept::write(&history, &Vec::new())).unwrap();
    let parts = written["history"]["parts"].take();
    let mut told = written["history"]["present"].take();
    let part = |table: &str, at: &Value| parts[table][at.as_u64().unwrap() as usize].clone();
    let tables = [
        ("tray", "trays", "items"),
        ("others", "books", "sheets"),
        ("mine", "shelves", "styles"),
        ("favourites", "shelves", "styles"),
        ("ownLayouts", "layoutShelves", "layouts"),
    ];
    for (field, lists, items) in tables {
        let list = part(lists, &told[field]);
        told[field] = list.as_array().unwrap().iter().map(|at| part(items, at)).collect();
    }
    told["settings"] = part("settings", &told["settings"]);
    if !told["draft"].is_null() {
        told["draft"] = part("drafts", &told["draft"]);
    }
    told["page"] = project.page().map_or(Value::Null, |page| json!(page.seed));
    for (sheet, other) in told["others"].as_array_mut().unwrap().iter_mut().zip(project.pages.others()) {
        sheet["page"] = json!(other.page.seed);
    }
    told
}

fn comparable(value: Value) -> Value {
    match value {
        Value::Number(number) => json!(number.as_f64()),
        Value::Array(list) => list.into_iter().map(comparable).collect(),
        // A missing mark and an empty mark are equal.
        Value::Object(map) => {
            // The stored runs are older than the text size for screens.
            let told = map
                .into_iter()
                .filter(|(name, value)| (name != "focus" || !value.is_null()) && name != "forScreens");
            told.map(|(name, value)| (name, comparable(value))).collect()
        }
        other => other,
    }
}

#[test]
fn the_same_edits_make_what_they_made_in_the_page() {
    let runs: Value = serde_json::from_str(include_str!("../oracles/data/edits.json")).unwrap();
    for (number, run) in runs.as_array().unwrap().iter().enumerate() {
        let mut editor = Editor::default();
        // At that time, the page did not choose generated styles automatically.
        let styling = Styling { invented: 0.0, ..Styling::default() };
        editor.apply(&Edit::Styling { styling }, &How { silent: true, gesture: None });
        for (i, (change, step)) in
            run["changes"].as_array().unwrap().iter().zip(run["steps"].as_array().unwrap()).enumerate()
        {
            let (edit, how) = Edit::read(told(change), &|_| None).unwrap();
            editor.apply(&edit, &how);
            let History { past, present, future, .. } = editor.history();
            let counts = json!([past.len(), future.len(), present.page_id(), present.tray.len()]);
            assert_eq!(counts, *step, "run {number}, step {i}: {change}");
        }
        assert_eq!(
            comparable(state_of(editor.project())),
            comparable(run["present"].clone()),
            "run {number}"
        );
        let shown: Vec<_> = editor
            .history()
            .shown
            .iter()
            .map(|shown| json!([shown.id, shown.from, shown.sheet, shown.page.seed]))
            .collect();
        assert_eq!(json!(shown), run["shown"], "run {number}");
        while editor.apply(&Edit::Undo, &How::default()) {}
        assert_eq!(comparable(state_of(editor.project())), comparable(run["start"].clone()), "run {number}");
    }
}

#[test]
fn other_paper_keeps_the_number_of_panels() {
    for count in 2..=9 {
        let photos = metas(count);
        let mut editor = opened(&photos);
        let mut request = Planning::new(editor.project(), &photos).request(1);
        (request.keep.layout, request.panels) = (false, Some(count));
        let page = Planning::new(editor.project(), &photos).plan(request, None).unwrap().unwrap();
        editor.apply(&Edit::ShowPage { page: Arc::new(page.clone()), page_id: 2 }, &How::default());
        for (width, height) in [(3840, 2160), (2400, 2400), (1600, 4000), (2550, 3300)] {
            let settings = PageSettings { width, height, ..PageSettings::default() };
            let other = Planning::new(editor.project(), &photos).on_paper(&page, &settings).unwrap();
            assert_eq!(other.panels.len(), page.panels.len(), "{count} panels on {width} x {height}");
        }
    }
}
