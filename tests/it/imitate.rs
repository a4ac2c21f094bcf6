//! Styles from a picture. If a built-in style is drawn on one photo, the search finds it for another photo. A
//! picture without a distinct style is rejected. The same seed gives the same result.

use inkpanel_engine::raster::decode::{Limits, decode_fit};
use inkpanel_engine::raster::{Image, Plane};
use inkpanel_engine::style::catalogue::catalogue;
use inkpanel_engine::style::imitate::{self, Ask, Effort, Features, Search, Seen, Trial, palette_distance};
use inkpanel_engine::style::{Context, Style, stylize};
use rayon::prelude::*;
use std::collections::HashMap;
use std::fmt::Write as _;
use std::fs;

/// Number of styles to find, and the share that must be found.
const TRIALS: usize = 40;
const FOUND: f64 = 0.8;

/// Pixels of a trial. Fewer than in the app, to save time.
const AREA: usize = 60_000;
/// As many pixels as in the app.
const WHOLE: usize = 160_000;

fn photo(name: &str) -> Image {
    let path = crate::root("tests/photos").join(name);
    decode_fit(&fs::read(path).unwrap(), &Limits::default(), 1000).unwrap().image
}

fn drawn(photo: &Image, style: &Style) -> Image {
    let mut context = painting();
    context.fit_scale(photo);
    stylize(photo, style, &mut context).unwrap()
}

fn attempt(photo: &Image, style: &Style, (area, close): (usize, bool)) -> Trial {
    let seen = Seen::of(photo, &Ask { style: style.clone(), area, close });
    imitate::attempt(&seen, style, &mut painting()).unwrap()
}

/// A context with the model of the block Painter.
fn painting() -> Context<'static> {
    let mut context = Context::default();
    context.show_painters(Some(crate::painters::painters()));
    context
}

/// Trials on a photo that all searches share.
struct Survey<'p> {
    photo: &'p Image,
    known: HashMap<String, Trial>,
}

impl<'p> Survey<'p> {
    fn of(photo: &'p Image, area: usize) -> Self {
        let one = |style: &Style| (style.id.clone(), attempt(photo, style, (area, false)));
        let trials = catalogue().par_iter().map(one);
        Self { photo, known: trials.collect() }
    }

    /// Returns the proposals of a search for a look.
    fn search(&self, look: Features, seed: u32, effort: Effort) -> Vec<Style> {
        let mut search = Search::new(look, seed).with(effort);
        let mut first = true;
        loop {
            let asks = search.ask();
            if asks.is_empty() {
                return search.proposals();
            }
            let seen = Seen::of(self.photo, &asks[0]);
            let one = |ask: &Ask| {
                let known = self.known.get(&ask.style.id).filter(|_| first);
                known.cloned().or_else(|| imitate::attempt(&seen, &ask.style, &mut painting()).ok())
            };
            search.tell(asks.iter().map(one).collect());
            first = false;
        }
    }
}

/// Returns whether palette, lines and screen of a stylised photo match a picture.
fn alike(look: &Features, photo: &Image, style: &Style, area: usize) -> [bool; 3] {
    let whole = attempt(photo, style, (area, false)).features;
    let palette = palette_distance(&look.palette, &whole.palette) <= 4.0;
    let (a, b) = (look.dark.density, whole.dark.density);
    // Very thin lines cannot be measured.
    let lines = (a - b).abs() <= (0.2 * a).max(0.006);
    let pitch = look.screen.pitch;
    let screen = pitch == 0.0 || {
        let close = attempt(photo, style, (area, true)).features.screen;
        (close.pitch / pitch - 1.0).abs() <= 0.15
    };
    [palette, lines, screen]
}

/// Runs every `step`-th trial. Returns which of palette, lines and screen were found at best, for each style.
fn trials(step: usize, effort: Effort, area: usize) -> Vec<(String, [bool; 3])> {
    let pictures = ["macaw.jpg", "cat.jpg", "temple.jpg", "camera.jpg", "horses.jpg"].map(photo);
    // Trials with even numbers need only the first photo.
    let own: Vec<Image> =
        ["palace.jpg", "raccoon.jpg"].into_iter().take(2 - (step + 1) % 2).map(photo).collect();
    let surveys: Vec<Survey<'_>> = own.iter().map(|own| Survey::of(own, area)).collect();
    let numbers: Vec<usize> = (0..TRIALS).step_by(step).collect();
    let trial = |&i: &usize| {
        let style = &catalogue()[i * catalogue().len() / TRIALS];
        let look = Features::within(&drawn(&pictures[i % pictures.len()], style), area);
        let survey = &surveys[i % surveys.len()];
        let proposals = survey.search(look.clone(), 1, effort);
        assert!((3..=6).contains(&proposals.len()), "{}: {}", style.id, proposals.len());
        let best = proposals
            .iter()
            .map(|proposal| alike(&look, survey.photo, proposal, area))
            .max_by_key(|met| met.iter().filter(|met| **met).count());
        (style.id.clone(), best.unwrap())
    };
    numbers.par_iter().map(trial).collect()
}

/// Fails where fewer than that share of the styles are found with all three.
fn check(rows: &[(String, [bool; 3])], share: f64) {
    let found = rows.iter().filter(|(_, met)| met.iter().all(|met| *met)).count();
    let mut table = format!("{found} of {} (palette, lines, screen)", rows.len());
    for (id, met) in rows {
        let _ = write!(table, "\n  {id}: {met:?}");
    }
    eprintln!("{table}");
    assert!(found as f64 >= share * rows.len() as f64, "{table}");
}

/// Ten of forty styles with a brief search; in a thorough run all of them with a full search, which takes minutes.
#[test]
fn designed_styles_are_found_again_on_another_photo() {
    if crate::trials(0, 1) == 1 {
        check(&trials(1, Effort::FULL, WHOLE), FOUND);
    } else {
        check(&trials(4, Effort::BRIEF, AREA), 0.3);
    }
}

#[test]
fn the_same_seed_finds_the_same() {
    // Small pictures are enough to compare two searches.
    let area = AREA / 4;
    let own = photo("raccoon.jpg");
    let survey = Survey::of(&own, area);
    let look = Features::within(&drawn(&photo("cat.jpg"), &catalogue()[40]), area);
    let told = |seed| {
        let styles = survey.search(look.clone(), seed, Effort::BRIEF);
        styles.iter().map(|style| style.to_value().to_string()).collect::<Vec<_>>()
    };
    let found = told(5);
    assert_eq!(found, told(5));
    for text in found {
        Style::parse("imitated.json", &text).unwrap();
    }
}

#[test]
fn pictures_without_a_look_are_told() {
    let code = |image: &Image| imitate::read(image).map_err(|error| error.code());
    let plane = |value: u8| Plane::filled(300, 200, value);
    let blank = Image::from_rgb([plane(250), plane(248), plane(240)]).unwrap();
    assert_eq!(code(&blank).unwrap_err(), "blank-picture");
    let tiny = Image::from_luma(Plane::from_fn(63, 200, |x, y| (x * y) as u8));
    assert_eq!(code(&tiny).unwrap_err(), "small-picture");
    for name in [
        "macaw.jpg",
        "cat.jpg",
        "palace.jpg",
        "raccoon.jpg",
        "stream.jpg",
        "wine.jpg",
        "crab.jpg",
        "bee.jpg",
        "pagoda.jpg",
    ] {
        assert_eq!(code(&photo(name)).map(|_| ()), Err("plain-photo"), "{name}");
    }
    // Whole pages, with paper and panels.
    for name in ["comic", "gouache", "noir", "screenprint"] {
        let page = crate::root(format!("docs/pages/{name}.png"));
        let page = decode_fit(&fs::read(page).unwrap(), &Limits::default(), 4000).unwrap().image;
        assert!(code(&page).is_ok(), "{name}");
    }
    for id in ["comic", "noir", "manga", "newsprint", "copperplate", "riso-zine", "linocut", "screenprint"] {
        let style = inkpanel_engine::style::catalogue::find(id).unwrap();
        for name in ["cat.jpg", "temple.jpg"] {
            assert!(code(&drawn(&photo(name), style)).is_ok(), "{id} on {name}");
        }
    }
}

/// Prints measurements for setting the limits of photo detection: `cargo test --test imitate -- --ignored
/// --nocapture looks`.
#[test]
#[ignore = "it prints numbers and checks nothing"]
fn looks_of_photos_and_of_styles() {
    let folder = crate::root("tests/photos");
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|ending| ending == "jpg"));
    files.sort();
    let photos: Vec<(String, Image)> = files
        .iter()
        .map(|path| path.file_name().unwrap().to_string_lossy().into_owned())
        .map(|name| (name.clone(), photo(&name)))
        .collect();
    for (name, photo) in &photos {
        println!("photo\t{name}\t{}", serde_json::to_string(&Features::of(photo)).unwrap());
    }
    let rows: Vec<String> = catalogue()
        .par_iter()
        .enumerate()
        .map(|(i, style)| {
            let look = Features::of(&drawn(&photos[i % photos.len()].1, style));
            format!("style\t{}\t{}", style.id, serde_json::to_string(&look).unwrap())
        })
        .collect();
    println!("{}", rows.join("\n"));
}
