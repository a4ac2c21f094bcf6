//! The block Painter: the network against ONNX Runtime (`tests/oracles/painters.py`), mixtures, faces, frames, sizes,
//! cancellation, malformed models, and the command line.

use std::fs;
use std::sync::{Arc, OnceLock};

use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::resize::{Region, resample_image};
use inkpanel_engine::raster::{Image, Plane};
use inkpanel_engine::simd::point::luma_plane;
use inkpanel_engine::style::blocks::painter::PAINTERS;
use inkpanel_engine::style::catalogue::catalogue;
use inkpanel_engine::style::faces::FaceBox;
use inkpanel_engine::style::painters::{Choice, MAX_BYTES, Painters};
use inkpanel_engine::style::{Context, Style, stylize};
use inkpanel_engine::{Error, Result};
use serde_json::{Value, json};

fn file() -> Vec<u8> {
    fs::read(crate::root("www/models/painters.onnx")).expect("run `cargo xtask models`")
}

/// Returns the model of `cargo xtask models`.
pub(crate) fn painters() -> Arc<Painters> {
    static READ: OnceLock<Arc<Painters>> = OnceLock::new();
    READ.get_or_init(|| Arc::new(Painters::new(&file()).unwrap())).clone()
}

fn photo(file: &str) -> Image {
    decode(&fs::read(crate::root(file)).unwrap(), &Limits::default()).unwrap().image
}

fn choice(number: f64) -> Choice {
    let place = number - 1.0;
    Choice { first: place as usize, second: place.ceil() as usize, share: place.fract() as f32 }
}

fn style(params: &str) -> Style {
    Style::parse("case", &format!(r#"{{"background":[{{"block":"painter"{params}}}]}}"#)).unwrap()
}

/// A photo in a style. `scale` is the scale of lengths.
fn drawn(photo: &Image, style: &Style, scale: f32, painters: &Arc<Painters>) -> Image {
    let mut context = Context::default();
    context.set_scale(scale);
    context.show_painters(Some(painters.clone()));
    stylize(photo, style, &mut context).unwrap()
}

fn sized(photo: &Image, width: usize, height: usize) -> Image {
    resample_image(photo, Region::whole(photo.width(), photo.height()), width, height)
}

/// Mean difference of all samples, in grey steps.
fn difference(a: &Image, b: &Image) -> f64 {
    let (a, b) = (a.to_rgb(), b.to_rgb());
    a.iter().zip(&b).map(|(&a, &b)| f64::from(a.abs_diff(b))).sum::<f64>() / a.len() as f64
}

#[test]
fn paintings_are_those_of_onnx_runtime() {
    let painters = painters();
    assert_eq!(painters.count(), usize::from(PAINTERS));
    let photo = photo("tests/oracles/data/blocks/photo.png");
    let rows: Vec<Value> =
        serde_json::from_slice(&fs::read(crate::root("tests/oracles/data/painters.json")).unwrap()).unwrap();
    assert_eq!(rows.len(), usize::from(PAINTERS) + 2);
    for row in rows {
        let number = row["painter"].as_f64().unwrap();
        let (painting, _) = painters.paint(&photo, choice(number), None, &|| Ok(())).unwrap();
        let digits = row["pixels"].as_str().unwrap();
        let expected =
            (0..digits.len()).step_by(2).map(|at| u8::from_str_radix(&digits[at..at + 2], 16).unwrap());
        let places =
            (0..photo.height()).step_by(3).flat_map(|y| (0..photo.width()).step_by(3).map(move |x| (x, y)));
        let found = places.flat_map(|(x, y)| painting.planes().iter().map(move |plane| plane.at(x, y)));
        let differences: Vec<u8> =
            found.zip(expected).map(|(found, expected)| found.abs_diff(expected)).collect();
        let mean = differences.iter().map(|&by| f64::from(by)).sum::<f64>() / differences.len() as f64;
        let far = differences.iter().filter(|&&by| by > 3).count() as f64 / differences.len() as f64;
        println!("painter {number}: mean {mean:.3}, over 3: {far:.5}, most {:?}", differences.iter().max());
        // Weights have 15 bits, activations 16.
        assert!(mean < 0.5 && far < 0.005, "painter {number}: mean {mean:.3}, over 3: {far:.5}");
    }
}

#[test]
fn a_mixture_is_between_its_painters() {
    let (painters, photo) = (painters(), sized(&photo("www/public/samples/06-castle.jpg"), 192, 128));
    let at = |number: f64| painters.paint(&photo, choice(number), None, &|| Ok(())).unwrap().0;
    let (one, middle, other) = (at(3.0), at(3.5), at(4.0));
    let whole = difference(&one, &other);
    assert!(whole > 10.0 && difference(&one, &middle) < whole && difference(&middle, &other) < whole);
}

#[test]
fn thumbnails_previews_and_prints_agree() {
    let (painters, photo) = (painters(), photo("www/public/samples/07-red-panda.jpg"));
    let style = style("");
    // The print is at scale 0.5, the preview at 0.25.
    let print = drawn(&sized(&photo, 960, 640), &style, 0.5, &painters);
    let preview = drawn(&sized(&photo, 480, 320), &style, 0.25, &painters);
    let apart = difference(&sized(&print, 240, 160), &sized(&preview, 240, 160));
    assert!(apart < 6.0, "{apart:.2}");
}

#[test]
fn strength_and_photo_colours_lead_back_to_the_photo() {
    let (painters, photo) = (painters(), sized(&photo("www/public/samples/09-mariachi.jpg"), 240, 160));
    let by = |params: &str| drawn(&photo, &style(params), 0.2, &painters);
    assert!(by(r#","strength":0"#) == photo);
    let (full, half) = (by(""), by(r#","strength":50"#));
    let (far, near) = (difference(&full, &photo), difference(&half, &photo));
    assert!((near / far - 0.5).abs() < 0.05, "{near} {far}");
    // Differences of channels are colours.
    let colours = |image: &Image| {
        let [r, g, b] = [0, 1, 2].map(|i| image.planes()[i].samples());
        let apart = |a: &[u8], b: &[u8]| {
            a.iter().zip(b).map(|(&a, &b)| i32::from(a) - i32::from(b)).collect::<Vec<_>>()
        };
        [apart(r, g), apart(g, b)].concat()
    };
    let far = |image: &Image| -> i32 {
        colours(image).iter().zip(colours(&photo)).map(|(a, b)| (a - b).abs()).sum()
    };
    assert!(5 * far(&by(r#","colours":100"#)) < far(&full));
}

#[test]
fn without_a_model_nothing_changes() {
    let photo = sized(&photo("www/public/samples/09-mariachi.jpg"), 90, 60);
    assert!(stylize(&photo, &style(""), &mut Context::for_image(&photo)).unwrap() == photo);
}

/// A face is painted again with a finer brush, and in the colours of the whole picture.
#[test]
fn faces_have_finer_strokes_and_the_colours_of_the_picture() {
    let (painters, photo) = (painters(), sized(&photo("www/public/samples/19-astronaut.jpg"), 512, 512));
    let draw = |faces: Vec<FaceBox>| {
        let mut context = Context::for_image(&photo);
        context.show_painters(Some(painters.clone()));
        context.show_faces(faces);
        stylize(&photo, &style(""), &mut context).unwrap()
    };
    let face = FaceBox { x: 170.0, y: 60.0, width: 100.0, height: 125.0 };
    let (plain, cared) = (draw(Vec::new()), draw(vec![face]));
    let cut = |image: &Image, x: usize, y: usize, side: usize| {
        let plane = |plane: &Plane| Plane::from_fn(side, side, |i, k| plane.at(x + i, y + k));
        Image::from_rgb([0, 1, 2].map(|i| plane(&image.planes()[i]))).unwrap()
    };
    let inside = |image: &Image| luma_plane(&cut(image, 185, 90, 70)).into_samples();
    let follows = |image: &Image| correlation(&inside(image), &inside(&photo));
    let (finer, plain_face) = (follows(&cared), follows(&plain));
    println!("correlation with the photo: {plain_face:.3}, with a face box {finer:.3}");
    assert!(finer > plain_face + 0.02, "{plain_face:.3} {finer:.3}");
    // Only the light of the face changes the rest of the picture.
    let far = difference(&cut(&cared, 330, 300, 160), &cut(&plain, 330, 300, 160));
    assert!(far < 3.0, "{far:.2}");
}

/// A face that keeps its colours gets less paint than the picture, at any size.
#[test]
fn strong_paint_spares_faces() {
    let (painters, photo) = (painters(), sized(&photo("www/public/samples/19-astronaut.jpg"), 512, 512));
    // The second face is too large for a finer brush.
    for height in [125.0, 180.0] {
        let draw = |params: &str| {
            let mut context = Context::for_image(&photo);
            context.show_painters(Some(painters.clone()));
            context.show_faces(vec![FaceBox {
                x: 220.0 - 0.4 * height,
                y: 60.0,
                width: 0.8 * height,
                height,
            }]);
            stylize(&photo, &style(params), &mut context).unwrap()
        };
        let apart = |colours: u8, x: usize, y: usize| {
            let [strong, weak] = [100, 38].map(|strength| {
                let drawn = draw(&format!(r#","strength":{strength},"colours":{colours}"#));
                let plane = |plane: &Plane| Plane::from_fn(50, 50, |i, k| plane.at(x + i, y + k));
                Image::from_rgb([0, 1, 2].map(|i| plane(&drawn.planes()[i]))).unwrap()
            });
            difference(&strong, &weak)
        };
        let (face, suit) = (apart(60, 195, 110), apart(60, 195, 350));
        println!("{height}: face {face:.2}, suit {suit:.2}");
        assert!(face < 1.0 && suit > 3.0, "{height}: {face:.2} {suit:.2}");
        // A style with the painter's colours paints faces as well.
        assert!(apart(0, 195, 110) > 3.0);
    }
}

/// A painting costs much more than the rest of a picture, so it is only done where it is seen. The network asks for
/// cancellation at regular rows, which counts its work.
#[test]
fn nothing_is_painted_that_is_not_seen() {
    let (painters, photo) = (painters(), sized(&photo("www/public/samples/19-astronaut.jpg"), 512, 512));
    let work = |params: &str, faces: Vec<FaceBox>, subject: Option<Plane>| {
        let asked = std::cell::Cell::new(0);
        let count = || {
            asked.set(asked.get() + 1);
            false
        };
        let mut context = Context::for_image(&photo);
        context.show_painters(Some(painters.clone()));
        context.show_faces(faces);
        context.show_subject(subject);
        context.stop_when(&count);
        stylize(&photo, &style(params), &mut context).unwrap();
        asked.get()
    };
    let large = FaceBox { x: 140.0, y: 40.0, width: 160.0, height: 200.0 };
    let plain = work("", Vec::new(), None);
    assert!(plain > 100, "{plain}");
    // The painting of a large face is a part of the whole painting.
    let again = work("", vec![large], None) - plain;
    assert!(again < 10, "{again} of {plain}");
    // Without a mask, the whole picture is the subject.
    let background = r#","where":"background""#;
    assert!(work(background, Vec::new(), None) < 10);
    let half = || Some(Plane::from_fn(512, 512, |x, _| if x < 256 { 255 } else { 0 }));
    assert!(work(background, Vec::new(), half()) >= plain);
    // The other part has another strength of the same painting.
    let both = r#","where":"background"},{"block":"painter","strength":50,"where":"subject""#;
    let again = work(both, Vec::new(), half()) - plain;
    assert!(again < 10, "{again} of {plain}");
}

/// A painting is used again with other strengths and colours, and not for another picture, painter or brush.
#[test]
fn a_stored_painting_is_used_for_the_same_picture_only() {
    let (painters, path) = (painters(), sized(&photo("www/public/samples/05-path.jpg"), 240, 160));
    let castle = sized(&photo("www/public/samples/06-castle.jpg"), 240, 160);
    let mut context = Context::for_image(&path);
    context.show_painters(Some(painters.clone()));
    let changes =
        ["", r#","strength":40"#, r#","colours":70"#, r#","painter":2"#, r#","painter":2,"brush":4"#];
    for (photo, params) in changes.map(|params| (&path, params)).into_iter().chain([(&castle, changes[4])]) {
        let again = stylize(photo, &style(params), &mut context).unwrap();
        assert!(again == drawn(photo, &style(params), context.scale(), &painters), "{params}");
    }
}

/// Pearson's coefficient of two planes.
fn correlation(a: &[u8], b: &[u8]) -> f64 {
    let mean = |values: &[u8]| values.iter().map(|&v| f64::from(v)).sum::<f64>() / values.len() as f64;
    let (mean_a, mean_b) = (mean(a), mean(b));
    let pairs = || a.iter().zip(b).map(|(&a, &b)| (f64::from(a) - mean_a, f64::from(b) - mean_b));
    let sum = |of: fn((f64, f64)) -> f64| pairs().map(of).sum::<f64>();
    sum(|(a, b)| a * b) / (sum(|(a, _)| a * a) * sum(|(_, b)| b * b)).sqrt()
}

/// The background of a frame does not change if something else does.
#[test]
fn later_frames_have_the_statistics_of_the_first() {
    let (painters, photo) = (painters(), sized(&photo("www/public/samples/05-path.jpg"), 240, 160));
    let lit = |x: usize, tone: u8| if x > 160 { tone / 4 } else { tone };
    let plane = |plane: &Plane| Plane::from_fn(240, 160, |x, y| lit(x, plane.at(x, y)));
    let next = Image::from_rgb([0, 1, 2].map(|i| plane(&photo.planes()[i]))).unwrap();
    let flicker = |steady: bool| {
        let mut context = Context::for_image(&photo);
        context.show_painters(Some(painters.clone()));
        if steady {
            context.begin_frames();
        }
        let first = stylize(&photo, &style(""), &mut context).unwrap();
        context.next_frame();
        let second = stylize(&next, &style(""), &mut context).unwrap();
        context.end_frames();
        let left = |image: &Image| {
            let plane = |plane: &Plane| Plane::from_fn(110, 160, |x, y| plane.at(x, y));
            Image::from_rgb([0, 1, 2].map(|i| plane(&image.planes()[i]))).unwrap()
        };
        difference(&left(&first), &left(&second))
    };
    let (steady, separate) = (flicker(true), flicker(false));
    println!("steady {steady:.2}, separate {separate:.2}");
    assert!(steady < 0.1 && separate > 2.0, "{steady:.2} {separate:.2}");
}

#[test]
fn work_that_is_cancelled_ends_early() {
    let (painters, photo) = (painters(), sized(&photo("www/public/samples/05-path.jpg"), 480, 320));
    let asked = std::cell::Cell::new(0);
    let cancel = || {
        asked.set(asked.get() + 1);
        asked.get() > 5
    };
    let mut context = Context::for_image(&photo);
    context.show_painters(Some(painters));
    context.stop_when(&cancel);
    assert_eq!(stylize(&photo, &style(""), &mut context).unwrap_err(), Error::Cancelled);
    assert_eq!(asked.get(), 6);
}

#[test]
fn damaged_and_foreign_models_are_refused_with_a_reason() {
    let bytes = file();
    let reason = |bytes: &[u8]| match Painters::new(bytes) {
        Err(error) => format!("{}: {error}", error.code()),
        Ok(_) => "none".to_owned(),
    };
    for length in (0..bytes.len()).step_by(bytes.len() / 50) {
        let reason = reason(&bytes[..length]);
        assert!(reason.starts_with("damaged-painters: this is not"), "{length} bytes: {reason}");
    }
    let large = reason(&vec![0; MAX_BYTES + 1]);
    assert!(large.starts_with("large-painters: ") && large.contains("limit"), "{large}");
    let subject = fs::read(crate::root("www/models/subject.onnx")).expect("run `cargo xtask models`");
    let subject = reason(&subject);
    assert!(subject.starts_with("invalid-painters: this is not a model of painters: "), "{subject}");
    let replaced = |from: &[u8], to: &[u8]| {
        let mut bytes = bytes.clone();
        for at in 0..bytes.len() - from.len() {
            if &bytes[at..at + from.len()] == from {
                bytes[at..at + from.len()].copy_from_slice(to);
            }
        }
        reason(&bytes)
    };
    assert!(replaced(b"Sigmoid", b"Softmax").contains("the operator Softmax"));
    assert!(replaced(b"reflect", b"zeroing").contains("Pad"));
    // One damaged byte at a time never panics.
    let mut random = oorandom::Rand32::new(9);
    for _ in 0..crate::trials(400, 60) {
        let mut damaged = bytes.clone();
        let at = random.rand_range(0..damaged.len() as u32) as usize;
        damaged[at] = random.rand_range(0..256) as u8;
        let _: Result<Painters> = Painters::new(&damaged);
    }
}

/// A style names a model of the user by its hash. Without this model, the built-in one replaces it.
#[test]
fn a_style_is_painted_with_the_model_that_it_names() {
    let photo = sized(&photo("www/public/samples/05-path.jpg"), 96, 64);
    // Weights of an inner layer are missing.
    let mut bytes = file();
    let middle = bytes.len() / 2;
    bytes[middle..middle + 4000].fill(0);
    let own = Arc::new(Painters::new(&bytes).unwrap());
    let named = style(r#","model":"00112233445566ff own model.onnx""#);
    let draw = |style: &Style, models: &[(&str, &Arc<Painters>)]| {
        let mut context = Context::for_image(&photo);
        context.show_painters(Some(painters()));
        for (hash, model) in models {
            context.show_own_painters(hash, Arc::clone(model));
        }
        stylize(&photo, style, &mut context).unwrap()
    };
    let known = [("ffeeddccbbaa9988", &painters()), ("00112233445566ff", &own)];
    let (built_in, owned) = (draw(&style(""), &known), draw(&named, &known));
    assert!(difference(&built_in, &owned) > 2.0);
    let mut alone = Context::for_image(&photo);
    alone.show_painters(Some(own.clone()));
    assert!(stylize(&photo, &style(""), &mut alone).unwrap() == owned);
    assert!(draw(&named, &known[..1]) == built_in);
    // A number beyond the last painter is the last painter.
    assert!(draw(&style(r#","painter":40"#), &[]) == draw(&style(r#","painter":10"#), &[]));
}

#[test]
fn styles_with_painters_have_ids_that_the_app_knows() {
    let painted: Vec<&Style> = catalogue().iter().filter(|style| style.has_block("painter")).collect();
    assert!(painted.len() >= 6);
    assert!(painted.iter().all(|style| style.id.starts_with("painter-")));
    let named = catalogue().iter().filter(|style| style.id.starts_with("painter"));
    assert_eq!(named.count(), painted.len());
}

#[test]
fn the_command_line_paints() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out.png");
    let done = crate::inkpanel()
        .args(["stylize", "--no-detect", "--style", "painter-night"])
        .arg(crate::root("tests/oracles/data/blocks/photo.png"))
        .arg("-o")
        .arg(&out)
        .output()
        .unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let photo = photo("tests/oracles/data/blocks/photo.png");
    let night = catalogue().iter().find(|style| style.id == "painter-night").unwrap();
    let mut context = Context::for_image(&photo);
    context.show_painters(Some(painters()));
    let expected = stylize(&photo, night, &mut context).unwrap();
    let written = decode(&fs::read(&out).unwrap(), &Limits::default()).unwrap().image;
    assert!(written == expected);
    // A model of the user, and a file of another model.
    let own = crate::root("www/models/painters.onnx");
    let other = crate::root("www/models/subject.onnx");
    for (model, succeeds) in [(own, true), (other, false)] {
        let done = crate::inkpanel()
            .args(["stylize", "--no-detect", "--style", "painter-night", "--painters"])
            .arg(model)
            .arg(crate::root("tests/oracles/data/blocks/photo.png"))
            .arg("-o")
            .arg(&out)
            .output()
            .unwrap();
        let printed = String::from_utf8_lossy(&done.stderr);
        assert_eq!(done.status.success(), succeeds, "{printed}");
        assert_eq!(
            printed.contains("subject.onnx: this is not a model of painters: "),
            !succeeds,
            "{printed}"
        );
    }
}

#[test]
fn the_command_line_warns_about_a_style_with_another_model() {
    let folder = tempfile::tempdir().unwrap();
    let model = crate::root("www/models/painters.onnx");
    let bytes = fs::read(&model).unwrap();
    let given = format!("{:08x}{:08x}", crc32fast::hash(&bytes), bytes.len());
    let style = folder.path().join("style.json");
    let printed = |reference: &str, form: &[&str]| {
        let json = format!(r#"{{"background":[{{"block":"painter","model":"{reference}"}}]}}"#);
        fs::write(&style, json).unwrap();
        let done = crate::inkpanel()
            .args(["stylize", "--no-detect", "--style"])
            .arg(&style)
            .args(form)
            .arg(crate::root("tests/oracles/data/blocks/photo.png"))
            .arg("-o")
            .arg(folder.path().join("out.png"))
            .output()
            .unwrap();
        let printed = String::from_utf8_lossy(&done.stderr).into_owned();
        assert!(done.status.success(), "{printed}");
        printed
    };
    let file = ["--painters", model.to_str().unwrap()];
    let (same, other) = (format!("{given} own.onnx"), "00112233445566ff other.onnx");
    assert_eq!(printed(&same, &file), "");
    let warning = "a style names this model of painters; the file of --painters replaces it";
    assert_eq!(printed(other, &file), format!("inkpanel: other.onnx: {warning}\n"));
    let page = folder.path().join("page.png");
    let render = |form: &[&str]| {
        let done = crate::inkpanel()
            .args(["render", "--no-detect", "--page-size", "200x280", "--style"])
            .arg(&style)
            .args(file)
            .args(form)
            .arg(crate::root("tests/oracles/data/blocks/photo.png"))
            .arg("-o")
            .arg(&page)
            .output()
            .unwrap();
        (done.status.success(), String::from_utf8(done.stderr).unwrap())
    };
    let (drawn, lines) = render(&["--progress", "json"]);
    let notes: Vec<Value> = lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let note = json!({ "event": "note", "file": "other.onnx", "message": warning });
    assert!(drawn && notes.contains(&note), "{lines}");
    fs::remove_file(&page).unwrap();
    let (drawn, lines) = render(&["--strict"]);
    assert!(!drawn && !page.exists() && lines.contains(warning), "{lines}");
    let built_in = printed(other, &[]);
    assert!(built_in.contains("other.onnx") && built_in.contains("the built-in model"), "{built_in}");
}
