//! The command line with many files. Bad files are reported and left out, and the others are processed.

#[allow(dead_code, reason = "the example makes more of it")]
#[path = "../../examples/hostile/made.rs"]
mod made;

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use inkpanel_engine::document::saved::Saved;
use inkpanel_engine::raster::decode::{Limits, decode};
use made::Tiff;

/// A folder with a photo, a TIFF with planar tiles that do not divide its size, and files that are not
/// photos.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let sample = crate::root("tests/oracles/data/files/jpeg-444.jpg");
    fs::copy(sample, folder.path().join("good.jpg")).unwrap();
    let tiles = Tiff { tile: Some((16, 16)), planar: true, ..Tiff::rgb(45, 27) };
    fs::write(folder.path().join("tiles.tif"), tiles.file()).unwrap();
    let photo = fs::read(folder.path().join("good.jpg")).unwrap();
    fs::write(folder.path().join("cut.jpg"), &photo[..photo.len() / 2]).unwrap();
    fs::write(folder.path().join("words.png"), "no picture").unwrap();
    fs::write(folder.path().join("empty.gif"), "").unwrap();
    folder
}

fn inkpanel(folder: &Path, arguments: &[&str]) -> Output {
    crate::inkpanel().args(arguments).current_dir(folder).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

const FILES: [&str; 6] = ["cut.jpg", "good.jpg", "words.png", "tiles.tif", "empty.gif", "missing.jpg"];
const BAD: [&str; 4] = ["cut.jpg", "words.png", "empty.gif", "missing.jpg"];

fn check_complaints(output: &Output) {
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}");
    for file in BAD {
        let lines = said.lines().filter(|line| line.contains(file)).count();
        assert_eq!(lines, 1, "{file} is named once: {said}");
    }
    assert!(!said.contains("good.jpg") && !said.contains("panicked"), "{said}");
}

#[test]
fn select_goes_on_without_the_bad_files() {
    let folder = folder();
    let output = inkpanel(folder.path(), &[&["select", "--json"][..], &FILES].concat());
    check_complaints(&output);
    let rows: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let names: Vec<_> = rows.as_array().unwrap().iter().map(|row| row["file"].as_str().unwrap()).collect();
    assert_eq!(names, ["good.jpg", "tiles.tif"]);
}

#[test]
fn render_goes_on_without_the_bad_files() {
    let folder = folder();
    for page in ["page.png", "page.pdf"] {
        let options = ["render", "--no-detect", "--width", "200", "--panels", "2", "-o", page];
        let output = inkpanel(folder.path(), &[&options[..], &FILES].concat());
        check_complaints(&output);
        assert!(fs::metadata(folder.path().join(page)).unwrap().len() > 500);
    }
}

#[test]
fn nothing_left_is_a_failure() {
    let folder = folder();
    for options in [&["select"][..], &["render", "--no-detect", "-o", "page.png"]] {
        let output = inkpanel(folder.path(), &[options, &BAD].concat());
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.contains("there is no usable photo"), "{said}");
        assert!(BAD.iter().all(|file| said.contains(file)), "{said}");
    }
    assert!(!folder.path().join("page.png").exists());
}

/// A folder with four photos that look like no other.
fn album() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let photos = crate::root("tests/photos");
    for (i, name) in ["bee.jpg", "cat.jpg", "macaw.jpg", "wine.jpg"].into_iter().enumerate() {
        fs::create_dir_all(folder.path().join("album/day")).unwrap();
        let place = if i < 2 { format!("album/{name}") } else { format!("album/day/{name}") };
        fs::copy(photos.join(name), folder.path().join(place)).unwrap();
    }
    folder
}

/// Runs it with that on standard input.
fn fed(folder: &Path, arguments: &[&str], input: &[u8]) -> Output {
    let mut command = crate::inkpanel();
    command.args(arguments).current_dir(folder);
    let piped = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = piped.spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let input = input.to_vec();
    // The reader may stop before it has read everything.
    let writing = std::thread::spawn(move || drop(stdin.write_all(&input)));
    let output = child.wait_with_output().unwrap();
    writing.join().unwrap();
    output
}

#[test]
fn a_font_gives_letters_and_what_none_has_is_named() {
    let folder = album();
    let fonts = crate::root("tests/oracles/data/fonts");
    let font = |name: &str| fonts.join(name).display().to_string();
    let words = r#"[{ "kind": "balloon", "text": "مرحبا 漢字 😀" }]"#;
    fs::write(folder.path().join("words.json"), words).unwrap();
    let drawn = |more: &[&str], page: &str| {
        render(folder.path(), &[&["--words", "words.json", "-o", page], more, &["album"]].concat())
    };
    let bare = drawn(&[], "bare.png");
    assert_eq!(bare.status.code(), Some(0));
    assert!(text(&bare.stderr).contains("no font has these characters"), "{}", text(&bare.stderr));
    let (arabic, japanese) = (font("arabic.ttf"), font("japanese.ttf"));
    for page in ["page.png", "page.pdf", "page.html"] {
        let output = drawn(&["--font", &arabic, "--font", &japanese], page);
        let said = text(&output.stderr);
        assert!(output.status.success() && said.contains("😀") && !said.contains('漢'), "{said}");
    }
    let page = |name: &str| fs::read(folder.path().join(name)).unwrap();
    assert_ne!(page("page.png"), page("bare.png"));
    // A warning stops a run with --strict. An invalid font stops every run.
    assert_eq!(drawn(&["--strict"], "strict.png").status.code(), Some(1));
    let output = drawn(&["--font", "words.json"], "wrong.png");
    let said = text(&output.stderr);
    assert_eq!((output.status.code(), said.lines().count()), (Some(1), 1), "{said}");
    assert!(said.contains("words.json: it is not a valid TrueType or OpenType font"), "{said}");
    assert!(!folder.path().join("wrong.png").exists() && !folder.path().join("strict.png").exists());
}

#[test]
fn the_quality_of_jpeg_is_told_and_what_is_there_is_not_planned_again() {
    let folder = album();
    let size = |name: &str| fs::metadata(folder.path().join(name)).unwrap().len();
    for (page, quality) in [("low.jpg", "20"), ("high.jpg", "97"), ("low.pdf", "20"), ("high.pdf", "97")] {
        assert!(render(folder.path(), &["--quality", quality, "-o", page, "album"]).status.success());
    }
    assert!(2 * size("low.jpg") < size("high.jpg") && size("low.pdf") < size("high.pdf"));
    let wrong = render(folder.path(), &["--quality", "20", "-o", "page.png", "album"]);
    assert!(wrong.status.code() == Some(1) && text(&wrong.stderr).contains("--quality needs an output file"));
    assert_eq!(render(folder.path(), &["--quality", "0", "-o", "page.jpg", "album"]).status.code(), Some(2));
    let pages = ["--pages", "2", "-o", "page-%02d.png", "--skip-existing", "--progress", "json", "album"];
    let first = text(&render(folder.path(), &pages).stderr);
    assert!(first.contains(r#""event":"photo""#), "{first}");
    let again = text(&render(folder.path(), &pages).stderr);
    assert!(again.contains(r#""event":"skipped""#) && !again.contains(r#""event":"photo""#), "{again}");
}

#[test]
fn coarse_photos_are_enlarged_where_that_is_asked_for_and_each_is_told() {
    let folder = album();
    let large = ["--no-detect", "--page-size", "a5", "--style", "noir", "--panels", "2"];
    let drawn = |more: &[&str], page: &str| {
        let arguments =
            [&["render"][..], &large, more, &["-o", page, "album/bee.jpg", "album/cat.jpg"]].concat();
        let output = inkpanel(folder.path(), &arguments);
        assert!(output.status.success(), "{}", text(&output.stderr));
        (text(&output.stderr), fs::read(folder.path().join(page)).unwrap())
    };
    let (quiet, plain) = drawn(&[], "plain.png");
    let (said, well) = drawn(&["--enlarge"], "well.png");
    assert!(!quiet.contains("enlarged") && said.matches("enlarged from").count() == 2, "{said}");
    assert_ne!(plain, well);
    let (said, _) = drawn(&["--enlarge", "--progress", "json"], "well.pdf");
    assert_eq!(said.matches(r#""event":"enlarged""#).count(), 2, "{said}");
}

const SMALL: [&str; 6] = ["--no-detect", "--style", "noir", "--page-size", "200x280", "--seed=5"];

fn render(folder: &Path, arguments: &[&str]) -> Output {
    inkpanel(folder, &[&["render"][..], &SMALL, arguments].concat())
}

#[test]
fn an_ending_that_is_not_known_is_refused_and_those_that_are_tell_the_truth() {
    let folder = album();
    let photo = "album/bee.jpg";
    let starts = [("png", &b"\x89PNG"[..]), ("jpg", b"\xFF\xD8"), ("JPEG", b"\xFF\xD8"), ("webp", b"RIFF")];
    for (ending, start) in starts {
        let file = format!("out.{ending}");
        let done = inkpanel(folder.path(), &["stylize", "--style", "noir", photo, "-o", &file]);
        assert!(done.status.success(), "{}", text(&done.stderr));
        assert!(fs::read(folder.path().join(&file)).unwrap().starts_with(start), "{file}");
        let done = render(folder.path(), &["-o", &file, "album"]);
        assert!(done.status.success(), "{}", text(&done.stderr));
        assert!(fs::read(folder.path().join(&file)).unwrap().starts_with(start), "{file}");
    }
    for file in ["x.tiff", "x.gif", "x", "x.jpg.bak"] {
        for done in [
            inkpanel(folder.path(), &["stylize", "--style", "noir", photo, "-o", file]),
            render(folder.path(), &["-o", file, "album"]),
        ] {
            let said = text(&done.stderr);
            assert_eq!(done.status.code(), Some(1), "{file}: {said}");
            assert!(said.contains("must end in .png, .jpg, .webp"), "{said}");
            assert!(!folder.path().join(file).exists());
        }
    }
    let pdf = inkpanel(folder.path(), &["stylize", "--style", "noir", photo, "-o", "x.pdf"]);
    assert_eq!(pdf.status.code(), Some(1));
}

#[test]
fn standard_input_and_output_stand_for_files() {
    let folder = album();
    let photo = fs::read(folder.path().join("album/bee.jpg")).unwrap();
    let by_pipe =
        fed(folder.path(), &["stylize", "--style", "noir", "-", "-o", "-", "--format", "jpg"], &photo);
    assert!(by_pipe.stdout.starts_with(b"\xFF\xD8"), "{}", text(&by_pipe.stderr));
    let by_file = inkpanel(folder.path(), &["stylize", "--style", "noir", "album/bee.jpg", "-o", "bee.jpg"]);
    assert!(by_file.status.success());
    assert_eq!(fs::read(folder.path().join("bee.jpg")).unwrap(), by_pipe.stdout);
    let page = fed(folder.path(), &[&["render"][..], &SMALL, &["-o", "-", "-"]].concat(), &photo);
    assert!(page.stdout.starts_with(b"\x89PNG"), "{}", text(&page.stderr));
    assert!(!folder.path().join("-").exists());
    let twice = fed(folder.path(), &[&["render"][..], &SMALL, &["-o", "x.png", "-", "-"]].concat(), &photo);
    assert!(text(&twice.stderr).contains("only once"));
    let both = render(folder.path(), &["--json", "-o", "-", "album"]);
    assert!(text(&both.stderr).contains("cannot both go to standard output") && both.stdout.is_empty());
}

#[test]
fn what_is_not_as_it_was_asked_for_is_told_and_strict_stops_there() {
    let folder = album();
    fs::copy(folder.path().join("album/bee.jpg"), folder.path().join("album/bee-2.jpg")).unwrap();
    let asked = ["-o", "page.png", "--panels", "50", "--star", "nobody.jpg", "album", "missing.jpg"];
    let done = render(folder.path(), &asked);
    let said = text(&done.stderr);
    assert_eq!(done.status.code(), Some(0), "{said}");
    for part in [
        "missing.jpg: ",
        "bee",
        "left out",
        "panels instead of 50",
        "photos repeat: 4 photos",
        "nobody.jpg: --star",
    ] {
        assert!(said.contains(part), "{part}: {said}");
    }
    fs::remove_file(folder.path().join("page.png")).unwrap();
    let strict = render(folder.path(), &[&asked[..], &["--strict"]].concat());
    assert_eq!(strict.status.code(), Some(1));
    assert!(text(&strict.stderr).contains("so nothing is written"), "{}", text(&strict.stderr));
    assert!(!folder.path().join("page.png").exists());
    let few = render(folder.path(), &["-o", "page.png", "--panels", "2", "album"]);
    assert!(text(&few.stderr).contains("2 of 4 photos have no panel"), "{}", text(&few.stderr));
    let clean = render(
        folder.path(),
        &["-o", "page.png", "--panels", "4", "--strict", "album/bee.jpg", "album/cat.jpg", "album/day"],
    );
    assert!(clean.status.success(), "{}", text(&clean.stderr));
    assert_eq!(text(&clean.stderr), "");
}

#[test]
fn the_width_changes_the_dots_and_not_the_paper() {
    let folder = album();
    for width in ["64", "300", "400", "620"] {
        let page =
            ["render", "--no-detect", "--style", "noir", "--width", width, "-o", "page.pdf", "album/bee.jpg"];
        let done = inkpanel(folder.path(), &page);
        assert!(done.status.success(), "{}", text(&done.stderr));
        let pdf = String::from_utf8_lossy(&fs::read(folder.path().join("page.pdf")).unwrap()).into_owned();
        let at = pdf.find("/MediaBox[0 0 ").unwrap();
        let sides: Vec<f64> =
            pdf[at + 14..].split(']').next().unwrap().split(' ').map(|n| n.parse().unwrap()).collect();
        // A4 in points.
        assert!((sides[0] - 595.28).abs() < 1.0 && (sides[1] - 841.89).abs() < 1.0, "{width}: {sides:?}");
    }
    let wrong = inkpanel(folder.path(), &["render", "-o", "page.png", "album", "--page-size", "a7b"]);
    assert_eq!(wrong.status.code(), Some(2));
    assert!(text(&wrong.stderr).contains("a4-landscape"), "{}", text(&wrong.stderr));
}

#[test]
fn settings_come_from_a_file_and_what_is_said_goes_before() {
    let folder = album();
    let by_options =
        render(folder.path(), &["-o", "options.png", "--panels", "3", "--gutter", "0.03", "album"]);
    assert!(by_options.status.success(), "{}", text(&by_options.stderr));
    let toml = "no-detect = true\nstyle = \"noir\"\npage_size = \"200x280\"\nseed = 5\npanels = 3\ngutter = 0.03\n\
        output = \"file.png\"\nfiles = [\"album\"]\n";
    fs::write(folder.path().join("page.toml"), toml).unwrap();
    let json = r#"{ "no-detect": true, "style": "comic", "page-size": "200x280", "seed": 5, "panels": 3, "gutter": 0.03, "files": "album" }"#;
    fs::write(folder.path().join("page.json"), json).unwrap();
    let by_toml = inkpanel(folder.path(), &["render", "--config", "page.toml"]);
    assert!(by_toml.status.success(), "{}", text(&by_toml.stderr));
    let by_json =
        inkpanel(folder.path(), &["render", "--config=page.json", "--style", "noir", "-o", "other.png"]);
    assert!(by_json.status.success(), "{}", text(&by_json.stderr));
    let page = |name: &str| fs::read(folder.path().join(name)).unwrap();
    assert_eq!(page("file.png"), page("options.png"));
    assert_eq!(page("other.png"), page("options.png"));
    for (text_of, sentence) in [
        ("sede = 1", "unknown setting \"sede\""),
        ("seed = ", "not valid TOML"),
        ("merge = 1", "merge: must be true or false"),
    ] {
        fs::write(folder.path().join("bad.toml"), text_of).unwrap();
        let done = inkpanel(folder.path(), &["render", "--config", "bad.toml", "-o", "x.png", "album"]);
        assert_eq!(done.status.code(), Some(2), "{text_of}");
        assert!(text(&done.stderr).contains(sentence), "{}", text(&done.stderr));
    }
    let none = inkpanel(folder.path(), &["render", "-o", "x.png"]);
    assert_eq!(none.status.code(), Some(2));
}

#[test]
fn stopped_work_goes_on_and_files_are_there_whole_or_not_at_all() {
    let folder = album();
    let asked = ["--pages", "2", "-o", "page-%02d.png", "--skip-existing", "album"];
    assert!(render(folder.path(), &asked).status.success());
    let page = |number: u32| folder.path().join(format!("page-0{number}.png"));
    let before = fs::metadata(page(1)).unwrap().modified().unwrap();
    fs::remove_file(page(2)).unwrap();
    let again = render(folder.path(), &asked);
    assert!(text(&again.stderr).contains("page-01.png, skipped"), "{}", text(&again.stderr));
    assert_eq!(fs::metadata(page(1)).unwrap().modified().unwrap(), before);
    assert!(page(2).exists());
    let one = render(folder.path(), &["-o", "page-01.png", "--skip-existing", "album"]);
    assert!(one.status.success() && text(&one.stderr).contains("exists already, skipped"));
    let left = fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name());
    assert!(left.into_iter().all(|name| !name.to_string_lossy().ends_with(".part")));
    let nowhere = render(folder.path(), &["-o", "missing/page.png", "album"]);
    assert_eq!(nowhere.status.code(), Some(1));
    assert!(text(&nowhere.stderr).contains("missing/page.png"), "{}", text(&nowhere.stderr));
}

#[test]
fn steps_are_lines_of_json_where_asked_for() {
    let folder = album();
    let done = render(
        folder.path(),
        &["--progress", "json", "--pages", "2", "-o", "page-%02d.png", "album", "missing.jpg"],
    );
    assert!(done.status.success(), "{}", text(&done.stderr));
    let lines: Vec<serde_json::Value> =
        text(&done.stderr).lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let events = |event: &str| lines.iter().filter(|line| line["event"] == event).count();
    assert_eq!((events("photo"), events("page"), events("done")), (5, 2, 1));
    assert!(lines.iter().any(|line| line["event"] == "note" && line["file"] == "missing.jpg"));
    assert_eq!(lines.last().unwrap()["files"], serde_json::json!(["page-01.png", "page-02.png"]));
    let failed = render(folder.path(), &["--progress", "json", "-o", "x.png", "--layout", "gone", "album"]);
    let said = text(&failed.stderr);
    let last: serde_json::Value = serde_json::from_str(said.lines().last().unwrap()).unwrap();
    assert_eq!((last["event"].as_str(), failed.status.code()), (Some("error"), Some(1)));
}

#[test]
fn a_page_goes_out_as_data_and_comes_in_as_the_same_page() {
    let folder = album();
    let one = render(folder.path(), &["-o", "one.png", "--save-document", "album/one.json", "album"]);
    assert!(one.status.success(), "{}", text(&one.stderr));
    let again =
        inkpanel(folder.path(), &["render", "--document", "album/one.json", "-o", "again.png", "album"]);
    assert!(again.status.success(), "{}", text(&again.stderr));
    let page = |name: &str| fs::read(folder.path().join(name)).unwrap();
    assert_eq!(page("one.png"), page("again.png"));
    let several = render(folder.path(), &["--pages", "2", "--save-document", "two.json", "album"]);
    assert!(several.status.success(), "{}", text(&several.stderr));
    let book = inkpanel(folder.path(), &["render", "--document", "two.json", "-o", "two.pdf", "album"]);
    assert!(book.status.success(), "{}", text(&book.stderr));
    assert!(page("two.pdf").starts_with(b"%PDF"));
    for (arguments, sentence) in [
        (
            vec!["--document", "two.json", "-o", "x.png"],
            "is neither in its folder nor among the given photos",
        ),
        (
            vec!["--document", "two.json", "-o", "x.png", "--style", "noir", "album"],
            "a saved page takes only",
        ),
        (vec!["--document", "gone.json", "-o", "x.png"], "gone.json: "),
        (vec!["--document", "album/bee.jpg", "-o", "x.png"], "is not JSON"),
    ] {
        let done = inkpanel(folder.path(), &[&["render"][..], &arguments].concat());
        assert_eq!(done.status.code(), Some(1), "{arguments:?}");
        assert!(text(&done.stderr).contains(sentence), "{}", text(&done.stderr));
        assert!(!folder.path().join("x.png").exists());
    }
}

#[test]
fn a_project_and_a_page_with_its_project_open_again_as_they_were() {
    let folder = album();
    for (file, more) in [("Trip.inkpanel", &[][..]), ("page-%02d.png", &["--embed", "photos"])] {
        let asked = [&["--pages", "2", "-o", file, "album"][..], more].concat();
        let done = render(folder.path(), &asked);
        assert!(done.status.success(), "{}", text(&done.stderr));
    }
    let plain = render(folder.path(), &["--pages", "2", "-o", "plain-%02d.png", "album"]);
    assert!(plain.status.success());
    let pixels = |name: &str| {
        let bytes = fs::read(folder.path().join(name)).unwrap();
        decode(&bytes, &Limits::default()).unwrap().image.to_rgb()
    };
    for (number, file) in
        [("1", "Trip.inkpanel"), ("2", "Trip.inkpanel"), ("2", "page-01.png"), ("1", "page-02.png")]
    {
        let done = inkpanel(folder.path(), &["render", "--page", number, "-o", "again.png", file]);
        assert!(done.status.success(), "{file}: {}", text(&done.stderr));
        assert_eq!(pixels("again.png"), pixels(&format!("plain-0{number}.png")), "{file}, page {number}");
    }
    let saved = Saved::read(fs::read(folder.path().join("Trip.inkpanel")).unwrap()).unwrap().unwrap();
    assert_eq!((saved.project().history.present.name.as_str(), saved.project().photos.len()), ("album", 4));
    let again = inkpanel(folder.path(), &["render", "-o", "x.inkpanel", "Trip.inkpanel"]);
    assert_eq!(again.status.code(), Some(1));
    let wrong = render(folder.path(), &["-o", "x.jpg", "--embed", "project", "album"]);
    assert!(text(&wrong.stderr).contains("only a PNG carries its project"));
}

/// Six shots of one second each.
fn film() -> Vec<u8> {
    fs::read(crate::root("tests/videos/album.mp4")).unwrap()
}

/// Runs it with a pipe that is closed already, as standard output or as standard error.
fn closed(folder: &Path, arguments: &[&str], is_error: bool) -> Output {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let mut command = crate::inkpanel();
    command.args(arguments).current_dir(folder).stdout(Stdio::piped()).stderr(Stdio::piped());
    if is_error {
        command.stderr(writer)
    } else {
        command.stdout(writer)
    };
    command.spawn().unwrap().wait_with_output().unwrap()
}

#[test]
fn no_command_panics_when_its_output_is_closed() {
    let folder = album();
    let path = folder.path();
    let plan = render(path, &["--json", "--panels", "2", "album"]);
    fs::write(path.join("plan.json"), plan.stdout).unwrap();
    fs::write(path.join("broken.jpg"), "no photo").unwrap();
    let small = crate::root("tests/oracles/data/files/jpeg-444.jpg");
    fs::copy(small, path.join("small.jpg")).unwrap();
    fs::write(path.join("film.mp4"), film()).unwrap();
    let saved = crate::root("tests/data/saved/version-1/storyboard.inkpanel");
    fs::copy(saved, path.join("Trip.inkpanel")).unwrap();
    let bee = "album/bee.jpg";
    let animate = ["animate", "Trip.inkpanel", "-o", "frames", "--size", "160x90", "--seconds", "0.25"];
    let commands: Vec<Vec<&str>> = vec![
        vec!["--help"],
        vec!["--version"],
        [&["render"][..], &SMALL, &["-o", "page.png", "album", "broken.jpg"]].concat(),
        [&["render"][..], &SMALL, &["-o", "-", "album"]].concat(),
        [&["render"][..], &SMALL, &["--json", "album"]].concat(),
        [&["render"][..], &SMALL, &["--progress", "json", "-o", "page.png", "album"]].concat(),
        vec!["render", "-o", "nothing.png", "missing.jpg"],
        vec!["score", "--no-detect", "plan.json"],
        vec!["score", "--no-detect", "--json", "plan.json"],
        vec!["stylize", "--style", "noir", bee, "-o", "-"],
        vec!["select", "album", "broken.jpg"],
        vec!["select", "--json", "album"],
        vec!["detect", bee],
        vec!["detect", "--json", bee],
        vec!["segment", bee, "-o", "masks"],
        vec!["segment", "--json", bee, "-o", "masks"],
        vec!["generate", "--count", "2"],
        vec!["generate", "--count", "1", "small.jpg"],
        vec!["imitate", "--anyway", "small.jpg", "small.jpg"],
        vec!["shots", "film.mp4"],
        vec!["shots", "--json", "film.mp4"],
        animate.to_vec(),
        [&animate[..], &["--json", "--skip-existing"]].concat(),
        vec!["blocks"],
        vec!["blocks", "--json"],
        vec!["layouts"],
        vec!["styles"],
    ];
    for command in commands {
        for is_error in [false, true] {
            let done = closed(path, &command, is_error);
            let said = text(&[done.stdout, done.stderr].concat());
            assert!(
                done.status.code().is_some_and(|code| code <= 2),
                "{command:?}: {:?}: {said}",
                done.status
            );
            assert!(!said.contains("panicked"), "{command:?}: {said}");
        }
    }
}

#[test]
fn a_film_has_shots_whatever_it_is_called() {
    let folder = tempfile::tempdir().unwrap();
    let shots = |name: &str| inkpanel(folder.path(), &["shots", "--json", "--", name]);
    let named = |name: &str| {
        fs::write(folder.path().join(name), film()).unwrap();
        let done = shots(name);
        assert_eq!((done.status.code(), text(&done.stderr)), (Some(0), String::new()), "{name}");
        serde_json::from_slice::<serde_json::Value>(&done.stdout).unwrap()
    };
    let plain = named("film.mp4");
    assert_eq!((plain.as_array().unwrap().len(), &plain[5]["end"]), (6, &serde_json::json!(6.0)));
    for name in ["clip:1.mp4", "-dash.mp4", "file:a.mp4", "%03d.mp4", "Größe 12\u{30b3}.mp4"] {
        assert_eq!(named(name), plain, "{name}");
    }
    fs::write(folder.path().join("no:film.mp4"), "this is no film").unwrap();
    for (name, why) in [("no:film.mp4", "Invalid data"), ("none.mp4", "No such file")] {
        let done = shots(name);
        let said = text(&done.stderr);
        assert_eq!((done.status.code(), said.lines().count()), (Some(1), 1), "{said}");
        assert!(said.contains(&format!("{name}: ffmpeg cannot read this video: ")), "{said}");
        assert!(said.contains(why) && !said.contains("file:"), "{said}");
    }
}

#[test]
fn a_truncated_film_ends_with_its_last_frame_and_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let film = film();
    fs::write(folder.path().join("cut.mp4"), &film[..film.len() / 2]).unwrap();
    let done = inkpanel(folder.path(), &["shots", "--json", "cut.mp4"]);
    let said = text(&done.stderr);
    assert_eq!(done.status.code(), Some(0), "{said}");
    let shots: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    let shots = shots.as_array().unwrap();
    let end = shots.last().unwrap()["end"].as_f64().unwrap();
    // The frames are counted by ffprobe.
    let mut ffprobe = Command::new("ffprobe");
    ffprobe.args([
        "-v",
        "quiet",
        "-count_frames",
        "-show_entries",
        "stream=nb_read_frames",
        "-of",
        "csv=p=0",
    ]);
    let counted = ffprobe.arg("cut.mp4").current_dir(folder.path()).output().unwrap();
    let frames: f64 = text(&counted.stdout).trim().parse().unwrap();
    assert!(end < 4.5 && (end - frames / 12.0).abs() < 0.13, "{end} s, {frames} frames");
    let expected =
        format!("inkpanel: cut.mp4: the video is truncated: its frames end at {end:.2} s of 6.00 s\n");
    assert_eq!(said, expected);
}

#[test]
fn a_byte_order_mark_is_no_part_of_a_file() {
    let folder = album();
    let path = folder.path();
    let files = [
        ("words.json", r#"[{ "kind": "caption", "text": "Later" }]"#.to_owned()),
        (
            "style.json",
            r#"{ "id": "mine", "background": [{ "block": "posterize", "levels": 5 }] }"#.to_owned(),
        ),
        (
            "layout.json",
            r#"{ "id": "mine", "name": "Mine", "family": "custom", "aspect": 0.7, "tree": { "rows": ["panel", "panel"] } }"#
                .to_owned(),
        ),
        (
            "settings.json",
            r#"{ "seed": 5, "words": "words.json", "style": "style.json", "layout": "layout.json" }"#
                .to_owned(),
        ),
        (
            "settings.toml",
            "seed = 5\nwords = \"words.json\"\nstyle = \"style.json\"\nlayout = \"layout.json\"\n".to_owned(),
        ),
    ];
    let pages = |mark: &str| {
        for (name, text) in &files {
            fs::write(path.join(name), format!("{mark}{text}")).unwrap();
        }
        let page = |settings: &str| {
            let more = ["--config", settings, "-o", "page.png", "--save-document", "page.json", "album"];
            let small = ["render", "--no-detect", "--page-size", "200x280"];
            let done = inkpanel(path, &[&small[..], &more].concat());
            assert!(done.status.success(), "{settings}: {}", text(&done.stderr));
            fs::read(path.join("page.png")).unwrap()
        };
        let drawn = ["settings.json", "settings.toml"].map(page);
        let document = fs::read_to_string(path.join("page.json")).unwrap();
        fs::write(path.join("page.json"), format!("{mark}{document}")).unwrap();
        let again = inkpanel(path, &["render", "--document", "page.json", "-o", "again.png", "album"]);
        assert!(again.status.success(), "{}", text(&again.stderr));
        let plan = render(path, &["--json", "album"]);
        fs::write(path.join("plan.json"), format!("{mark}{}", text(&plan.stdout))).unwrap();
        let score = inkpanel(path, &["score", "--no-detect", "plan.json"]);
        assert!(score.status.success(), "{}", text(&score.stderr));
        (drawn, fs::read(path.join("again.png")).unwrap(), score.stdout)
    };
    assert!(pages("\u{feff}") == pages(""));
}

#[test]
fn settings_may_be_utf_16_as_power_shell_writes_them() {
    let folder = album();
    let wide = |text: &str| -> Vec<u8> { text.encode_utf16().flat_map(u16::to_le_bytes).collect() };
    let words = wide("\u{feff}[{ \"kind\": \"caption\", \"text\": \"Später\" }]");
    fs::write(folder.path().join("words.json"), words).unwrap();
    fs::write(folder.path().join("page.json"), wide("{ \"seed\": 5, \"words\": \"words.json\" }")).unwrap();
    let done = render(folder.path(), &["--config", "page.json", "-o", "page.png", "album"]);
    assert!(done.status.success(), "{}", text(&done.stderr));
    fs::write(folder.path().join("words.json"), b"[\"\xe9\"]").unwrap();
    let wrong = render(folder.path(), &["--words", "words.json", "-o", "page.png", "album"]);
    assert_eq!(wrong.status.code(), Some(1));
    assert!(text(&wrong.stderr).contains("words.json: is not JSON or TOML"), "{}", text(&wrong.stderr));
}

#[test]
fn pages_of_earlier_runs_are_left_out_of_a_folder() {
    let folder = album();
    let photos = |more: &[&str]| -> Vec<String> {
        let done = render(folder.path(), &[&["--keep-all", "--json"], more].concat());
        assert!(done.status.success(), "{}", text(&done.stderr));
        let plan: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
        let panels = plan["pages"][0]["panels"].as_array().unwrap();
        let mut names: Vec<String> =
            panels.iter().map(|panel| panel["photo"].as_str().unwrap().to_owned()).collect();
        names.sort();
        names.dedup();
        names
    };
    let before = photos(&["album"]);
    for page in ["album/page.png", "album/day/page.jpg", "album/page.webp"] {
        assert_eq!(photos(&["-o", page, "album"]), before, "{page}");
        assert!(folder.path().join(page).is_file());
    }
    // They are reported, but not as warnings.
    let done = render(folder.path(), &["--progress", "json", "--keep-all", "-o", "again.png", "album"]);
    assert!(done.status.success(), "{}", text(&done.stderr));
    assert!(text(&done.stderr).contains(r#""event":"left-out""#), "{}", text(&done.stderr));
    // A page that is named is a photo, and so are the pages of a folder without photos.
    assert_eq!(photos(&["album/page.png"]), ["album/page.png"]);
    fs::create_dir(folder.path().join("pages")).unwrap();
    fs::rename(folder.path().join("again.png"), folder.path().join("pages/again.png")).unwrap();
    assert_eq!(photos(&["pages"]), ["pages/again.png"]);
}

#[test]
fn a_font_in_a_file_of_settings_is_beside_it() {
    let folder = album();
    let font = crate::root("tests/oracles/data/fonts/arabic.ttf");
    let settings = folder.path().join("settings");
    fs::create_dir(&settings).unwrap();
    fs::copy(font, settings.join("arabic.ttf")).unwrap();
    fs::write(settings.join("words.json"), r#"[{ "kind": "balloon", "text": "مرحبا" }]"#).unwrap();
    let toml = "font = [\"arabic.ttf\"]\nwords = \"words.json\"\n";
    fs::write(settings.join("page.toml"), toml).unwrap();
    let done = render(folder.path(), &["--config", "settings/page.toml", "-o", "page.png", "album"]);
    let said = text(&done.stderr);
    assert!(done.status.success() && !said.contains("no font"), "{said}");
}

#[test]
fn a_percent_sign_may_stand_before_the_place_of_the_number() {
    let folder = album();
    let done = render(folder.path(), &["--pages", "2", "-o", "100% page-%02d.png", "album"]);
    assert!(done.status.success(), "{}", text(&done.stderr));
    assert!(["100% page-01.png", "100% page-02.png"].iter().all(|name| folder.path().join(name).is_file()));
}

#[test]
fn families_of_layouts_and_styles_are_kept_to() {
    let folder = folder();
    for seed in ["1", "2", "3"] {
        let asked = [
            "render",
            "--layout-family",
            "slanted",
            "--style-family",
            "woodcut",
            "--style-family",
            "ink",
            "--seed",
            seed,
            "--no-detect",
            "--keep-all",
            "--json",
            "good.jpg",
            "tiles.tif",
        ];
        let output = inkpanel(folder.path(), &asked);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        let plan: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let id =
            |value: &serde_json::Value| value.as_str().or_else(|| value["id"].as_str()).unwrap().to_owned();
        let page = &plan["pages"][0];
        let layout = inkpanel_engine::layout::find(&id(&page["layout"])).unwrap();
        assert_eq!(layout.family(), "slanted");
        let style = inkpanel_engine::style::catalogue::find(&id(&page["style"])).unwrap();
        assert!(["woodcut", "ink"].contains(&&*style.tags[0]), "{}", style.tags[0]);
    }
    for wrong in [&["--layout-family", "spiral"][..], &["--style-family", "ink", "--style", "noir"]] {
        let output =
            inkpanel(folder.path(), &[&["render", "-o", "page.png", "good.jpg"][..], wrong].concat());
        assert_eq!(output.status.code(), Some(2), "{}", text(&output.stderr));
        assert!(!folder.path().join("page.png").exists());
    }
}

#[test]
fn each_error_has_a_stable_code() {
    let folder = album();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    write("page.json", "{");
    write("style.json", r#"{ "id": "x" }"#);
    write("layout.json", r#"{ "id": "x" }"#);
    write("words.json", "[1]");
    write("broken.inkpanel", "not a project");
    write("other.txt", "no photo");
    fs::create_dir(folder.path().join("empty")).unwrap();
    let cases: &[(&[&str], &str, i32)] = &[
        (&["album", "-o", "page.tiff"], "invalid-argument", 1),
        (&["album", "-o", "page.png", "--bleed", "3"], "invalid-argument", 1),
        (&["album", "-o", "page.png", "--style", "nope"], "unknown-style", 1),
        (&["album", "-o", "page.png", "--style", "style.json"], "invalid-style", 1),
        (&["album", "-o", "page.png", "--layout", "nope"], "unknown-layout", 1),
        (&["album", "-o", "page.png", "--layout", "layout.json"], "invalid-layout", 1),
        (&["album", "-o", "page.png", "--gutter", "0.5"], "invalid-document", 1),
        (&["album", "-o", "page.png", "--words", "words.json"], "invalid-document", 1),
        (&["album", "-o", "page.png", "--words", "missing.json"], "not-found", 1),
        (&["album", "-o", "page.png", "--font", "other.txt"], "invalid-argument", 1),
        (&["album", "-o", "page.png", "--figures", "--models", "empty"], "no-models", 1),
        (&["album", "other.txt", "-o", "page.png", "--strict"], "warnings", 1),
        (&["album", "-o", "missing/page.png"], "unwritable", 1),
        (&["empty", "-o", "page.png"], "no-photos", 1),
        (&["missing.jpg", "-o", "page.png"], "no-photos", 1),
        (&["broken.inkpanel", "-o", "page.png"], "unknown-format", 1),
        (&["--document", "page.json", "-o", "page.png"], "invalid-document", 1),
        (&["--document", "missing.json", "-o", "page.png"], "not-found", 1),
        (&["--config", "missing.toml", "-o", "page.png"], "not-found", 2),
        (&["album", "-o", "page.png", "--sede", "7"], "invalid-argument", 2),
        (&["album", "-o", "page.png", "--dpi", "many"], "invalid-argument", 2),
        (&["-o", "page.png"], "invalid-argument", 2),
        (&["album"], "invalid-argument", 2),
    ];
    for (arguments, code, status) in cases {
        let is_planned = ["album", "empty", "missing.jpg"].contains(&arguments[0]);
        let planning = ["--no-detect", "--width", "120", "--panels", "3"];
        let planning = if is_planned { &planning[..] } else { &[] };
        let options = [&["render", "--progress", "json"][..], planning, arguments].concat();
        let output = inkpanel(folder.path(), &options);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(*status), "{arguments:?}: {said}");
        let events: Vec<serde_json::Value> =
            said.lines().map(|line| serde_json::from_str(line).expect(line)).collect();
        let errors: Vec<_> = events.iter().filter(|event| event["event"] == "error").collect();
        assert_eq!(errors.len(), 1, "{arguments:?}: {said}");
        assert_eq!(errors[0]["code"], *code, "{arguments:?}: {said}");
        assert!(!errors[0]["message"].as_str().unwrap().is_empty());
        assert_eq!(events.last(), Some(errors[0]), "the error is the last event");
        assert!(!folder.path().join("page.png").exists(), "{arguments:?}");
    }
}

#[test]
fn edits_of_a_file_change_the_planned_pages() {
    let folder = album();
    let plan = |edits: &str, more: &[&str]| {
        fs::write(folder.path().join("edits.json"), edits).unwrap();
        let options = ["--layout", "cinema-4", "--json", "--edits", "edits.json"];
        render(folder.path(), &[&options[..], more, &["album"]].concat())
    };
    let photos = |output: &Output| -> Vec<String> {
        let plan: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let panels = plan["pages"][0]["panels"].as_array().unwrap();
        panels.iter().map(|panel| panel["photo"].as_str().unwrap().to_owned()).collect()
    };
    let before = photos(&plan("[]", &[]));
    let swapped = plan(r#"[{ "type": "swap-panels", "panel": 0, "with": 3 }]"#, &[]);
    let after = photos(&swapped);
    assert_eq!([&after[0], &after[3]], [&before[3], &before[0]], "{}", text(&swapped.stderr));
    let placed = plan(r#"[{ "type": "place-photo", "panel": 2, "photo": "bee.jpg" }]"#, &[]);
    assert!(photos(&placed)[2].ends_with("bee.jpg"), "{}", text(&placed.stderr));
    let idle = r#"[{ "type": "swap-panels", "panel": 0, "with": 99 }]"#;
    let unchanged = plan(idle, &[]);
    assert!(text(&unchanged.stderr).contains("edits[0] changes nothing"), "{}", text(&unchanged.stderr));
    assert_eq!(photos(&unchanged), before);
    assert_eq!(plan(idle, &["--strict"]).status.code(), Some(1));
    let wrong = plan(r#"[{ "type": "swap" }]"#, &[]);
    let said = text(&wrong.stderr);
    assert_eq!(wrong.status.code(), Some(1));
    assert!(said.contains("edits.json") && said.contains("edits[0].type: is not a known edit"), "{said}");
}
