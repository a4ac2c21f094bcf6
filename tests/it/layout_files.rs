//! Malformed layout files: each is an error that names the file, the field and the reason, and never a panic.

use inkpanel_engine::Error;
use inkpanel_engine::layout::{Template, catalogue};
use proptest::prelude::*;

/// A layout file with the given fields after a sound head.
fn file(fields: &str) -> String {
    format!(r#"{{"id": "good-one", "name": "Good", "family": "custom", "aspect": 0.7, {fields}}}"#)
}

/// A layout file whose tree has `cell` in place of its second row.
fn with_cell(cell: &str) -> String {
    file(&format!(r#""tree": {{"rows": ["panel", {cell}]}}"#))
}

/// A layout file with one overlay.
fn with_overlay(overlay: &str) -> String {
    file(&format!(r#""tree": "panel", "overlays": [{overlay}]"#))
}

/// A layout file of polygons.
fn with_polygons(polygons: &str) -> String {
    file(&format!(r#""polygons": {polygons}"#))
}

fn nested(depth: usize) -> String {
    let (mut head, mut tail) = (String::new(), String::new());
    for _ in 0..depth {
        head.push_str(r#"{"rows": ["panel", "#);
        tail.push_str("]}");
    }
    file(&format!(r#""tree": {head}"panel"{tail}"#))
}

fn row_of(count: usize) -> String {
    let panels = vec![r#""panel""#; count].join(", ");
    format!(r#"{{"columns": [{panels}]}}"#)
}

/// The file, the path that the error must name, and a part of the reason.
type Case = (String, &'static str, &'static str);

/// A body without fault.
const TREE: &str = r#""tree": "panel""#;

fn not_an_object() -> Vec<Case> {
    let text = |text: &str| text.to_owned();
    vec![
        (text(""), "line 1", "EOF"),
        (text("layout"), "line 1", "expected"),
        (text("{\"id\": \"a\","), "line 1", "EOF"),
        (text("\u{0}\u{1}\u{2}"), "line 1", "expected"),
        (text("null"), "file", "object"),
        (text("[]"), "file", "object"),
        (text("\"panel\""), "file", "object"),
        (text("7"), "file", "object"),
        (format!("{}1", "[".repeat(5000)), "line 1", "recursion"),
        (format!("{{\"id\": \"{}\"}}", "a".repeat(300_000)), "file", "longer"),
    ]
}

fn faults_of_the_head() -> Vec<Case> {
    vec![
        ("{}".to_owned(), "id", "missing"),
        (file(&format!("{TREE}, \"colour\": 1")), "colour", "not a field"),
        (file(TREE).replace("\"good-one\"", "7"), "id", "text"),
        (file(TREE).replace("good-one", "Good_One"), "id", "kebab-case"),
        (file(TREE).replace("good-one", "a--b"), "id", "kebab-case"),
        (file(TREE).replace("good-one", ""), "id", "1 to 60"),
        (file(TREE).replace("good-one", "../../etc/passwd"), "id", "kebab-case"),
        (file(TREE).replace("\"Good\"", "null"), "name", "text"),
        (file(TREE).replace("\"Good\"", &format!("\"{}\"", "x".repeat(61))), "name", "1 to 60"),
        (file(TREE).replace("\"Good\"", "\"a\\u0007b\""), "name", "printable"),
        (file(TREE).replace("custom", "fancy"), "family", "one of"),
        (file(TREE).replace("0.7", "\"0.7\""), "aspect", "number"),
        (file(TREE).replace("0.7", "0"), "aspect", "from 0.1 to 10"),
        (file(TREE).replace("0.7", "-3"), "aspect", "from 0.1 to 10"),
        (file(TREE).replace("0.7", "1e300"), "aspect", "from 0.1 to 10"),
        (file(TREE).replace("0.7", "1e999"), "line 1", "out of range"),
        (file(TREE).replace("0.7", "NaN"), "line 1", "expected"),
    ]
}

fn faults_of_trees() -> Vec<Case> {
    vec![
        (file("\"weights\": []"), "file", "tree or polygons"),
        (file(&format!("{TREE}, \"polygons\": []")), "polygons", "cannot be combined with tree"),
        (file("\"tree\": null"), "tree", "object"),
        (file("\"tree\": {}"), "tree", "rows or columns"),
        (file("\"tree\": \"pannel\""), "tree", "object"),
        (file("\"tree\": [\"panel\"]"), "tree", "object"),
        (file("\"tree\": {\"rows\": []}"), "tree.rows", "2 to 40"),
        (file("\"tree\": {\"rows\": [\"panel\"]}"), "tree.rows", "2 to 40"),
        (file("\"tree\": {\"rows\": \"panel\"}"), "tree.rows", "list"),
        (with_cell("null"), "tree.rows[1]", "object"),
        (with_cell("{\"rows\": [\"panel\", 3]}"), "tree.rows[1].rows[1]", "object"),
        (with_cell("{\"cols\": [\"panel\", \"panel\"]}"), "tree.rows[1].cols", "not a field"),
        (
            with_cell("{\"rows\": [\"panel\", \"panel\"], \"columns\": [\"panel\", \"panel\"]}"),
            "tree.rows[1].columns",
            "cannot be combined with rows",
        ),
        (
            with_cell("{\"columns\": [\"panel\", \"panel\"], \"shares\": [1]}"),
            "tree.rows[1].shares",
            "2 elements",
        ),
        (
            with_cell("{\"columns\": [\"panel\", \"panel\"], \"shares\": [1, 0]}"),
            "tree.rows[1].shares[1]",
            "from 0.01",
        ),
        (
            with_cell("{\"columns\": [\"panel\", \"panel\"], \"shares\": [1, -2]}"),
            "tree.rows[1].shares[1]",
            "from 0.01",
        ),
        (
            with_cell("{\"columns\": [\"panel\", \"panel\"], \"shares\": [1, \"2\"]}"),
            "tree.rows[1].shares[1]",
            "number",
        ),
        (
            with_cell("{\"columns\": [\"panel\", \"panel\"], \"shares\": [100, 0.01]}"),
            "tree.rows[1].shares",
            "child 1",
        ),
        (
            with_cell("{\"columns\": [\"panel\", \"panel\"], \"slants\": [0.1, 0.1]}"),
            "tree.rows[1].slants",
            "1 elements",
        ),
        (
            with_cell("{\"columns\": [\"panel\", \"panel\"], \"slants\": [4]}"),
            "tree.rows[1].slants[0]",
            "from -1 to 1",
        ),
        (
            with_cell("{\"columns\": [\"panel\", \"panel\"], \"slants\": [1]}"),
            "tree.rows[1].slants",
            "cuts must not cross",
        ),
        (
            with_cell("{\"columns\": [\"panel\", \"panel\", \"panel\"], \"slants\": [0.6, -0.6]}"),
            "tree.rows[1].slants",
            "child 1",
        ),
        (
            nested(11),
            "tree.rows[1].rows[1].rows[1].rows[1].rows[1].rows[1].rows[1].rows[1].rows[1].rows[1].rows",
            "deep",
        ),
        (with_cell(&row_of(41)), "tree.rows[1].columns", "2 to 40"),
        (with_cell(&row_of(40)), "tree", "has 41 panels"),
    ]
}

fn faults_of_polygons() -> Vec<Case> {
    let halves = "[[0, 0], [1, 0], [1, 0.5], [0, 0.5]], [[0, 0.5], [1, 0.5], [1, 1], [0, 1]]";
    vec![
        (with_polygons("[]"), "polygons", "1 to 40"),
        (with_polygons("[[]]"), "polygons[0]", "3 to 12"),
        (with_polygons("[[[0, 0], [1, 0]]]"), "polygons[0]", "3 to 12"),
        (with_polygons("[[[0, 0], [1, 0], [1]]]"), "polygons[0][2]", "2 elements"),
        (with_polygons("[[[0, 0], [1, 0], [1, 2]]]"), "polygons[0][2][1]", "from 0 to 1"),
        (with_polygons("[[[0, 0], [1, 0], [1, true]]]"), "polygons[0][2][1]", "number"),
        (with_polygons("[[[0, 0], [1, 0], [0.5, 0]]]"), "polygons[0]", "convex"),
        (with_polygons("[[[0, 0], [1, 1], [1, 0], [0, 1]]]"), "polygons[0]", "convex"),
        (with_polygons("[[[0, 0], [1, 0], [0.3, 0.3], [0, 1]]]"), "polygons[0]", "convex"),
        (with_polygons("[[[0, 0], [1, 0], [1, 1], [0, 0.99]]]"), "polygons", "tile"),
        (with_polygons(&format!("[{halves}, {halves}]")), "polygons[2]", "overlaps polygon 0"),
        (
            with_polygons("[[[0, 0], [0.6, 0], [0.6, 1], [0, 1]], [[0.4, 0], [1, 0], [1, 1], [0.4, 1]]]"),
            "polygons[1]",
            "overlaps polygon 0",
        ),
    ]
}

fn faults_of_order_and_weights() -> Vec<Case> {
    vec![
        (file(&format!("{TREE}, \"order\": [1]")), "order[0]", "whole number"),
        (file(&format!("{TREE}, \"order\": [0, 1]")), "order", "1 elements"),
        (file("\"tree\": {\"rows\": [\"panel\", \"panel\"]}, \"order\": [0, 0]"), "order[1]", "second time"),
        (
            file("\"tree\": {\"rows\": [\"panel\", \"panel\"]}, \"order\": [0, 0.5]"),
            "order[1]",
            "whole number",
        ),
        (
            file("\"tree\": {\"rows\": [\"panel\", \"panel\"]}, \"order\": [0, -1]"),
            "order[1]",
            "whole number",
        ),
        (file(&format!("{TREE}, \"weights\": []")), "weights", "1 elements"),
        (file(&format!("{TREE}, \"weights\": [0]")), "weights[0]", "from 0.01"),
        (file(&format!("{TREE}, \"weights\": [1e40]")), "weights[0]", "from 0.01"),
        (file(&format!("{TREE}, \"weights\": {{}}")), "weights", "list"),
    ]
}

fn faults_of_overlays() -> Vec<Case> {
    vec![
        (file(&format!("{TREE}, \"overlays\": {{}}")), "overlays", "list"),
        (with_overlay("{}"), "overlays[0]", "exactly one"),
        (with_overlay("7"), "overlays[0]", "object"),
        (with_overlay("{\"ellipse\": {}}"), "overlays[0].ellipse", "not a field"),
        (
            with_overlay("{\"circle\": {\"x\": 0.5, \"y\": 0.5, \"radius\": 0.1}, \"polygon\": []}"),
            "overlays[0]",
            "exactly one",
        ),
        (
            with_overlay("{\"rect\": {\"x\": 0.1, \"y\": 0.1, \"width\": 0.2}}"),
            "overlays[0].rect.height",
            "missing",
        ),
        (
            with_overlay("{\"rect\": {\"x\": 0.1, \"y\": 0.1, \"w\": 0.2, \"height\": 0.2}}"),
            "overlays[0].rect.w",
            "not a field",
        ),
        (
            with_overlay("{\"rect\": {\"x\": 0.9, \"y\": 0.1, \"width\": 0.2, \"height\": 0.2}}"),
            "overlays[0].rect.width",
            "over the edge",
        ),
        (
            with_overlay("{\"rect\": {\"x\": -0.1, \"y\": 0.1, \"width\": 0.2, \"height\": 0.2}}"),
            "overlays[0].rect.x",
            "from 0 to 1",
        ),
        (
            with_overlay("{\"rect\": {\"x\": 0.1, \"y\": 0.1, \"width\": 0.2, \"height\": 0}}"),
            "overlays[0].rect.height",
            "from 0.05",
        ),
        (
            with_overlay("{\"circle\": {\"x\": 0.5, \"y\": 0.5, \"radius\": 0.6}}"),
            "overlays[0].circle.radius",
            "from 0.03 to 0.5",
        ),
        (
            with_overlay("{\"circle\": {\"x\": 0.1, \"y\": 0.5, \"radius\": 0.2}}"),
            "overlays[0].circle.radius",
            "over the edge",
        ),
        (
            with_overlay("{\"circle\": {\"x\": 0.5, \"y\": 0.95, \"radius\": 0.2}}"),
            "overlays[0].circle.radius",
            "over the edge",
        ),
        (
            with_overlay("{\"polygon\": [[0.1, 0.1], [0.5, 0.5], [0.5, 0.1], [0.1, 0.5]]}"),
            "overlays[0].polygon",
            "convex",
        ),
        (
            with_overlay("{\"polygon\": [[0.1, 0.1], [1.1, 0.1], [0.5, 0.5]]}"),
            "overlays[0].polygon[1][0]",
            "from 0 to 1",
        ),
        (
            with_overlay("{\"circle\": {\"x\": 0.5, \"y\": 0.5, \"radius\": 0.1}, \"halo\": -1}"),
            "overlays[0].halo",
            "from 0 to 3",
        ),
        (
            file(&format!(
                "{TREE}, \"overlays\": [{}]",
                vec!["{\"circle\": {\"x\": 0.5, \"y\": 0.5, \"radius\": 0.1}}"; 13].join(", ")
            )),
            "overlays",
            "0 to 12",
        ),
    ]
}

#[test]
fn every_malformed_file_names_file_field_and_reason() {
    let groups = [
        not_an_object(),
        faults_of_the_head(),
        faults_of_trees(),
        faults_of_polygons(),
        faults_of_order_and_weights(),
        faults_of_overlays(),
    ];
    let cases = groups.concat();
    assert!(cases.len() >= 40);
    for (json, path, part) in cases {
        let shown: String = json.chars().take(200).collect();
        match Template::parse("broken.json", &json) {
            Err(Error::InvalidLayout { file, location, reason }) => {
                assert_eq!(file, "broken.json");
                let named =
                    if path.starts_with("line") { location.starts_with(path) } else { location == path };
                assert!(named, "{shown}\n  names {location:?}, not {path:?}");
                assert!(reason.contains(part), "{shown}\n  says {reason:?}, without {part:?}");
            }
            other => panic!("{shown}\n  gives {other:?}"),
        }
    }
}

#[test]
fn the_sound_file_is_sound() {
    for json in [
        file("\"tree\": \"panel\""),
        with_cell(&row_of(39)),
        nested(10),
        with_polygons("[[[0, 0], [0, 1], [1, 1], [1, 0]]]"),
        with_overlay("{\"rect\": {\"x\": 0.8, \"y\": 0.8, \"width\": 0.2, \"height\": 0.2}, \"halo\": 0}"),
        with_overlay("{\"circle\": {\"x\": 0.5, \"y\": 0.5, \"radius\": 0.5}}"),
    ] {
        let template = Template::parse("good.json", &json).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(Template::parse("again.json", &template.to_json()), Ok(template));
    }
}

#[test]
fn the_reading_order_can_be_given() {
    let tree = "\"tree\": {\"columns\": [\"panel\", \"panel\"], \"shares\": [1, 2]}";
    let straight = Template::parse("a.json", &file(tree)).unwrap();
    let turned = Template::parse("b.json", &file(&format!("{tree}, \"order\": [1, 0]"))).unwrap();
    assert_eq!(turned.panels()[0], straight.panels()[1]);
    assert_eq!(Template::parse("c.json", &turned.to_json()), Ok(turned));
}

proptest! {
    /// A damaged part of a real file gives a result or an error.
    #[test]
    fn damaged_files_never_panic(
        which in 0usize..1000,
        from in 0.0f64..1.0,
        length in 0usize..12,
        patch in "[-0-9a-z\\[\\]{}\",:. ]{0,8}",
    ) {
        let json = catalogue()[which % catalogue().len()].to_json();
        let start = (from * json.len() as f64) as usize;
        let end = (start + length).min(json.len());
        if json.is_char_boundary(start) && json.is_char_boundary(end) {
            let damaged = format!("{}{patch}{}", &json[..start], &json[end..]);
            if let Err(error) = Template::parse("damaged.json", &damaged) {
                prop_assert_eq!(error.code(), "invalid-layout");
            }
        }
    }
}
