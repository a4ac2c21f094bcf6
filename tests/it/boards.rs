//! Storyboard sheets with a logo in their header: the logo is drawn unchanged, read with the header, and
//! drawn from a saved project by the command line.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use inkpanel_engine::native::{self, Photo, Photos};
use inkpanel_engine::output::board::{Logo, PictureOf, Request};
use inkpanel_engine::output::shots::{ListedShot, ShotList};
use inkpanel_engine::page::pdf::{Options, write};
use inkpanel_engine::page::words::Letters;
use inkpanel_engine::page::words::given::GivenFonts;
use inkpanel_engine::page::{Document, png};
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::{Image, Matte};
use serde_json::{Value, json};
use std::fs;
use std::io::{Cursor, Read, Write};
use std::path::Path;
use std::process::Output;

/// A picture without equal neighbours.
fn checked(width: usize, height: usize) -> Image {
    let rgba: Vec<u8> = (0..width * height)
        .flat_map(|i| [(i * 89 % 256) as u8, (i * 53 % 256) as u8, (i / width * 31 % 256) as u8, 255])
        .collect();
    Image::from_rgba(width, height, &rgba, [255; 3]).unwrap()
}

#[test]
fn a_plain_picture_is_that_photo_to_the_pixel_in_any_style() {
    // Two adjacent panels of 60 by 50 pixels.
    let polygon = |x: f64| json!([[x, 0.25], [x + 0.3, 0.25], [x + 0.3, 0.75], [x, 0.75]]);
    let page = |style: &str, plain: bool| {
        let value = json!({
            "version": 1, "seed": 1, "style": style, "merges": [], "words": [], "order": ["a"],
            "layout": { "id": "board", "name": "Board", "family": "board", "aspect": 2.0, "polygons": [polygon(0.1), polygon(0.6)] },
            "panels": [{ "photo": "a" }, { "photo": "a", "plain": plain }],
            "page": { "width": 200, "height": 100, "gutter": 0, "margin": 0, "border": 0.02, "cornerRadius": 0, "enlarge": true },
        });
        let page = Document::parse(&value.to_string()).unwrap();
        assert_eq!(Document::parse(&page.to_json()).unwrap(), page);
        page
    };
    let image = checked(60, 50);
    // Also if the style draws only a part of it.
    let subject = Some(Matte::try_from("2x2:ap2a".to_owned()).unwrap());
    let photos: Photos = [("a".to_owned(), Photo { image: image.clone(), subject })].into();
    for style in ["noir", "storyboard", "spot-colour"] {
        let drawn = |plain| native::sheet(&page(style, plain), &photos, &GivenFonts::default()).unwrap();
        let (plain, styled) = (drawn(true), drawn(false));
        let pixel = |x: usize, y: usize| &plain.rgb()[(y * 200 + x) * 3..][..3];
        let expected = |x: usize, y: usize| {
            if (120..180).contains(&x) && (25..75).contains(&y) {
                [0, 1, 2].map(|channel| image.planes()[channel].at(x - 120, y - 25))
            } else {
                [255; 3]
            }
        };
        for (x, y) in (0..100).flat_map(|y| (100..200).map(move |x| (x, y))) {
            assert_eq!(pixel(x, y), expected(x, y), "{style}: {x}, {y}");
        }
        assert_ne!(styled.rgb(), plain.rgb());
    }
}

fn request(logo: bool) -> Request {
    let shot = |number: &str| ListedShot { number: number.into(), ..ListedShot::default() };
    let picture = |photo: &str| PictureOf { photo: photo.into(), ..PictureOf::default() };
    Request {
        list: ShotList { title: "Night".into(), shots: vec![shot("1"), shot("2")], ..ShotList::default() },
        pictures: vec![picture("a"), picture("b")],
        frames: 2,
        style: "noir".into(),
        author: "Ann".into(),
        logo: logo.then(|| Logo { photo: "logo".into(), aspect: 2.0 }),
        ..Request::default()
    }
}

#[test]
fn a_logo_is_read_with_the_head_and_has_no_border() {
    let photos: Photos = ["a", "b", "logo"].map(|id| (id.to_owned(), Photo::from(checked(40, 20)))).into();
    let file = |logo: bool| {
        let [sheet] = &request(logo).sheets().unwrap()[..] else { panic!("one sheet") };
        let mut sheet = sheet.clone();
        // Less to draw.
        (sheet.page.width, sheet.page.height, sheet.page.dpi) =
            (sheet.page.width / 4, sheet.page.height / 4, 75);
        let leaf = native::leaf(&sheet, &photos, native::alts(&sheet, &|_| &[]), (None, 90)).unwrap();
        write(&[leaf], &Options::default(), &Letters::bundled().unwrap()).unwrap()
    };
    let (with, without) = (file(true), file(false));
    let at = |file: &[u8], text: &str| file.windows(text.len()).position(|window| window == text.as_bytes());
    let read = [
        "/Alt(Logo)",
        "/ActualText(Night)",
        "/ActualText(Ann)",
        "/Alt(Panel 1 of 2: a photo)",
        "/Alt(Panel 2 of 2: a photo)",
    ];
    assert!(read.iter().map(|text| at(&with, text).unwrap()).is_sorted());
    assert_eq!(at(&without, "/Alt(Logo)"), None);
    let count = |file: &[u8], text: &str| {
        file.windows(text.len()).filter(|window| *window == text.as_bytes()).count()
    };
    assert_eq!(count(&with, "/Filter/DCTDecode"), count(&without, "/Filter/DCTDecode") + 1);
    // Each border is two outlines that are filled between.
    let borders = |file: &[u8]| {
        let starts = (0..file.len() - 8)
            .filter(|&i| file[i..].starts_with(b"stream\n") && !file[..i].ends_with(b"end"));
        let packed =
            starts.filter_map(|start| miniz_oxide::inflate::decompress_to_vec_zlib(&file[start + 7..]).ok());
        packed.map(|content| count(&content, "f*\n")).sum::<usize>()
    };
    assert_eq!((borders(&with), borders(&without)), (2, 2));
}

/// A saved project whose board has that logo.
fn project(folder: &Path, logo: &str) -> String {
    let saved = crate::root("tests/data/saved/version-1/storyboard.inkpanel");
    let mut archive = zip::ZipArchive::new(fs::File::open(saved).unwrap()).unwrap();
    let mut writer = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for i in 0..archive.len() {
        let mut entry = archive.by_index(i).unwrap();
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes).unwrap();
        if entry.name() == "project.json" {
            let mut value: Value = serde_json::from_slice(&bytes).unwrap();
            value["history"]["present"]["board"] = json!({ "logo": logo });
            bytes = value.to_string().into_bytes();
        }
        writer.start_file(entry.name(), zip::write::SimpleFileOptions::default()).unwrap();
        writer.write_all(&bytes).unwrap();
    }
    let path = folder.join("project.inkpanel");
    fs::write(&path, writer.finish().unwrap().into_inner()).unwrap();
    path.to_str().unwrap().to_owned()
}

fn render(project: &str, output: &Path) -> Output {
    let mut command = crate::inkpanel();
    command.args(["render", project, "--board", "6", "-o"]).arg(output).output().unwrap()
}

#[test]
fn the_command_line_draws_the_logo_of_a_saved_board() {
    let folder = tempfile::tempdir().unwrap();
    let red = png::encode_rgb(60, 30, &[220, 20, 30].repeat(60 * 30), 96).unwrap();
    let logo = format!("data:image/png;base64,{}", BASE64_STANDARD.encode(red));
    let sheet = folder.path().join("sheet.png");
    let done = render(&project(folder.path(), &logo), &sheet);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    assert!(done.stderr.is_empty(), "{}", String::from_utf8_lossy(&done.stderr));
    let image = decode(&fs::read(&sheet).unwrap(), &Limits::default()).unwrap().image;
    let pixels = |millimetres: f64| (millimetres / 25.4 * 300.0) as usize;
    let at = |x: f64, y: f64| [0, 1, 2].map(|channel| image.planes()[channel].at(pixels(x), pixels(y)));
    // In the left corner of the header, 18 mm wide and 9 mm high, with paper around it.
    for (x, y) in [(11.2, 11.2), (28.8, 11.2), (11.2, 19.8), (28.8, 19.8), (20.0, 15.0)] {
        assert_eq!(at(x, y), [220, 20, 30], "{x}, {y}");
    }
    for (x, y) in [(10.8, 15.0), (29.2, 19.8), (20.0, 10.8), (20.0, 20.2)] {
        assert_eq!(at(x, y), [255; 3], "{x}, {y}");
    }
}

#[test]
fn a_logo_that_cannot_be_read_is_told() {
    let folder = tempfile::tempdir().unwrap();
    for (logo, sentence) in [
        ("data:image/png;base64,iVBORw0KGgo=", "the logo of the board: "),
        ("logo.png", "present.board.logo: must be a PNG data URL"),
    ] {
        let output = folder.path().join("sheet.png");
        let done = render(&project(folder.path(), logo), &output);
        let said = String::from_utf8_lossy(&done.stderr).into_owned();
        assert!(!done.status.success() && !output.exists() && said.contains(sentence), "{said}");
    }
}
