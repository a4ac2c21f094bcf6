//! The facade for other programs: same results as the command line, and errors for invalid input.

use inkpanel::{Album, Failure, Nets, PageOptions, Photo, Pixels, Style, layouts, pdf};
use std::path::PathBuf;

fn samples(count: usize) -> Vec<PathBuf> {
    let folder = crate::root("www/public/samples");
    let mut all: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    all.retain(|path| path.extension().is_some_and(|ending| ending == "jpg"));
    all.sort();
    all.truncate(count);
    all
}

fn album(count: usize) -> Album {
    Album::read(samples(count).into_iter().map(Photo::open).collect()).unwrap()
}

fn small() -> PageOptions {
    PageOptions::new().size("a4", None, Some(320)).unwrap().style(&Style::designed("comic").unwrap()).seed(5)
}

/// The code of a failure, and the photo that it names.
fn told<T>(result: Result<T, Failure>) -> (&'static str, Option<String>) {
    let failure = result.err().unwrap();
    assert!(!failure.to_string().is_empty());
    (failure.code(), failure.photo().map(str::to_owned))
}

#[test]
fn a_page_is_that_of_the_command_line() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("page.png");
    let mut command = crate::inkpanel();
    command.args(["render", "--no-detect", "--width", "320", "--style", "comic", "--seed", "5", "-o"]);
    let output = command.arg(&file).args(samples(6)).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let expected = inkpanel_engine::raster::decode::decode(
        &std::fs::read(&file).unwrap(),
        &inkpanel_engine::raster::decode::Limits::default(),
    );
    let drawn = album(6).page(&small()).unwrap().pixels().unwrap();
    assert_eq!((drawn.width, drawn.height), (320, 453));
    assert!(drawn.rgb == expected.unwrap().image.to_rgb(), "the pixels differ");
}

#[test]
fn files_bytes_and_pixels_make_the_same_page() {
    let files = samples(3);
    let bytes = files.iter().map(|path| Photo::from_bytes("photo", std::fs::read(path).unwrap())).collect();
    let pixels = files.iter().map(|path| {
        let limits = inkpanel_engine::raster::decode::Limits::default();
        let image =
            inkpanel_engine::raster::decode::decode(&std::fs::read(path).unwrap(), &limits).unwrap().image;
        Photo::from_rgb("photo", image.width(), image.height(), &image.to_rgb()).unwrap()
    });
    let options = small().as_given(true);
    let drawn = [album(3), Album::read(bytes).unwrap(), Album::read(pixels.collect()).unwrap()]
        .map(|album| album.page(&options).unwrap().png().unwrap());
    assert!(drawn[0].starts_with(b"\x89PNG"));
    assert!(drawn[0] == drawn[1], "bytes of files differ");
    assert!(drawn[0] == drawn[2], "pixels differ");
}

#[test]
fn options_are_what_the_page_becomes() {
    let album = album(5);
    let page = |options: PageOptions| album.page(&options).unwrap();
    let plain = page(small());
    assert_ne!(plain.plan(), page(small().seed(6)).plan());
    assert_eq!(page(small().panels(3)).panels(), 3);
    let cinema = page(small().layout("cinema-4").unwrap());
    assert!(cinema.plan().contains("\"cinema-4\""));
    assert_eq!(cinema.panels(), 4);
    let named = samples(5).iter().any(|path| plain.plan().contains(path.to_str().unwrap()));
    assert!(named, "a plan names photos as they were given");
    let square = page(small().size("square", None, Some(300)).unwrap());
    assert_eq!((square.width(), square.height()), (300, 300));
    // Panels of some layouts reach the edge of the page.
    let framed = small().layout("grid-4").unwrap().paper("#000000").unwrap().margin(0.1).unwrap();
    let black = page(framed).pixels().unwrap();
    assert_eq!(black.rgb[..3], [0, 0, 0]);
    let worded =
        page(small().words(r#"[{"kind": "balloon", "text": "Look, \uE123!", "panel": 0}]"#).unwrap());
    assert_ne!(worded.pixels().unwrap().rgb, plain.pixels().unwrap().rgb);
    assert!(worded.notes().iter().any(|note| note.reason().contains("U+E123")), "{:?}", worded.notes());
    assert!(layouts().any(|(id, panels)| (id, panels) == ("cinema-4", 4)));
}

#[test]
fn an_album_becomes_pages_and_one_file() {
    let album = album(12);
    let pages = album.pages(&small(), 3).unwrap();
    assert!(pages.len() > 1 && pages.len() <= 3, "{}", pages.len());
    let file = pdf(&pages.iter().collect::<Vec<_>>(), "Twelve", "en").unwrap();
    assert!(file.starts_with(b"%PDF-"));
    let count = |needle: &[u8]| file.windows(needle.len()).filter(|part| *part == needle).count();
    assert_eq!(count(b"/MediaBox"), pages.len());
    assert_eq!(told(pdf(&[], "", "en")).0, "invalid-argument");
    assert!(pages[0].jpeg(80).unwrap().starts_with(&[0xff, 0xd8]));
    assert_eq!(told(pages[0].jpeg(0)).0, "invalid-argument");
}

#[test]
fn a_starred_photo_is_on_the_page() {
    let files = samples(9);
    let shows = |starred: Option<usize>| {
        let mut album = album(9);
        if let Some(place) = starred {
            album.star(place).unwrap();
        }
        let plan = album.page(&small().panels(2)).unwrap().plan();
        let panels = plan.split("\"panels\"").nth(1).unwrap().to_owned();
        (0..9).filter(|place| panels.contains(files[*place].to_str().unwrap())).collect::<Vec<_>>()
    };
    let plain = shows(None);
    let other = (0..9).find(|place| !plain.contains(place)).unwrap();
    assert!(shows(Some(other)).contains(&other), "{plain:?} without a star");
    assert_eq!(told(album(2).star(2)).0, "invalid-argument");
}

#[test]
fn what_cannot_be_read_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let half = folder.path().join("half.jpg");
    let whole = std::fs::read(&samples(1)[0]).unwrap();
    std::fs::write(&half, &whole[..whole.len() / 50]).unwrap();
    let name = half.display().to_string();
    let given = || vec![Photo::open(&samples(1)[0]), Photo::open(&half), Photo::open("no-such-file.jpg")];
    assert_eq!(told(Album::read(given())), ("damaged", Some(name.clone())));
    let album = Album::read_skipping_broken(given());
    assert_eq!(album.notes().len(), 2, "{:?}", album.notes());
    assert_eq!(album.notes()[0].photo(), Some(&*name));
    assert!(album.notes()[1].reason().ends_with("; left out"));
    assert!(album.page(&small()).unwrap().notes().starts_with(album.notes()));

    let one = |photo: Photo| told(Album::read(vec![photo])).0;
    assert_eq!(one(Photo::open("no-such-file.jpg")), "not-found");
    assert_eq!(one(Photo::open(folder.path())), "unreadable");
    assert_eq!(one(Photo::from_bytes("text", b"no photo at all".as_slice())), "unknown-format");
    assert_eq!(told(Photo::from_rgb("p", 4, 4, &[0; 47])), ("buffer-size", Some("p".into())));
    assert_eq!(told(Photo::from_rgb("p", 0, 4, &[])).1.as_deref(), Some("p"));
    assert_eq!(told(Photo::from_rgb("p", 1 << 20, 1 << 20, &[])).0, "too-large");
    assert_eq!(told(Album::read(vec![]).unwrap().page(&small())).0, "no-photos");
}

#[test]
fn settings_out_of_range_are_refused() {
    assert_eq!(told(small().gutter(0.2)).0, "invalid-document");
    assert_eq!(told(small().paper("white")).0, "invalid-document");
    assert_eq!(told(small().size("a4", None, Some(20_000))).0, "invalid-document");
    assert_eq!(told(small().size("napkin", None, None)).0, "invalid-document");
    assert_eq!(told(small().layout("no-such-layout")).0, "unknown-layout");
    assert_eq!(told(small().words("{")).0, "invalid-argument");
    assert_eq!(told(Style::designed("no-such-style")).0, "unknown-style");
    assert_eq!(told(Style::from_json(r#"{"id": "x"}"#)).0, "invalid-style");
    let album = album(2);
    assert_eq!(told(album.pages(&small(), 0)).0, "invalid-argument");
    assert_eq!(told(small().words(r#"[{"kind": "shout"}]"#)).0, "invalid-document");
    assert_eq!(told(Nets::open("no-such-folder")).0, "no-models");
    assert_eq!(told(Nets::from_bytes(b"", b"")).0, "detector");
}

#[test]
fn a_picture_is_drawn_in_a_style() {
    let rgb: Vec<u8> =
        (0..64 * 48u32).flat_map(|at| [(at % 64 * 4) as u8, (at / 64 * 5) as u8, 90]).collect();
    let picture = Pixels::new(64, 48, rgb).unwrap();
    for (id, name) in Style::all() {
        assert!(!name.is_empty(), "{id}");
    }
    let style = Style::designed("pop-art").or_else(|_| Style::designed("comic")).unwrap();
    let drawn = style.draw(&picture).unwrap();
    assert_eq!((drawn.width, drawn.height, drawn.dpi), (64, 48, 96));
    assert_ne!(drawn, picture);
    let read = Style::from_json(&style.to_json()).unwrap();
    assert_eq!(read.draw(&picture).unwrap(), drawn);
    assert_eq!(told(Pixels::new(64, 48, vec![0; 9])).0, "buffer-size");
}
