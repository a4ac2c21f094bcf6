//! The built-in styles: each is in a family that `styles/README.md` lists, all look different, and all
//! preserve the picture in haze, at night, overexposed or in dull light.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;

use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::resize::{Region, resample_image};
use inkpanel_engine::style::catalogue::{by_family, catalogue};
use inkpanel_engine::style::{Context, Style, stylize};

/// A family's tag and what its styles look like, in the order of the README.
const FAMILIES: &[(&str, &str)] = &[
    ("ink", "Lines of a pen or a brush, black or brown."),
    ("noir", "Few tones, deep shadows."),
    ("manga", "Black lines over screen tone."),
    ("comic", "Flat colours inside lines."),
    ("pop", "Loud colours, as on posters."),
    ("halftone", "Dots of one or four inks."),
    ("sketch", "Pencil, chalk, charcoal, pen."),
    ("hatch", "Tones drawn with strokes."),
    ("woodcut", "Cut in wood or linoleum."),
    ("watercolour", "Painted: washes, gouache, oil."),
    ("vintage", "Faded photos and prints."),
    ("duotone", "Two or three colours from shadow to light."),
    ("blueprint", "Light lines on a dark ground, screens."),
    ("paper", "Filter chains of the original paper."),
];

/// Fewest designed styles.
const FEWEST: usize = 50;

/// Simulated bad light: gain and bias of a channel, clipped.
const LIGHTS: [(&str, f32, f32); 4] =
    [("hazy", 0.4, 140.0), ("dark", 0.25, 0.0), ("bright", 1.5, 40.0), ("dull", 0.35, 75.0)];

/// Minimum share of its contrast that a style preserves in bad light.
const KEPT: f64 = 0.5;

/// Chains exactly as printed in the paper, without a block that corrects bad light. Designed styles akin to
/// them do.
const AS_PRINTED: [&str; 4] = ["paper-a", "paper-b", "paper-c", "paper-d"];

/// Mean difference of a channel, 0..=255, below which two styles look identical.
const ALIKE: f64 = 6.0;

const START: &str = "<!-- families:start -->\n";
const END: &str = "<!-- families:end -->";

/// A sample photo at the size of a small panel.
fn panel(name: &str) -> Image {
    let bytes = fs::read(crate::root("www/public/samples").join(name)).unwrap();
    let photo = decode(&bytes, &Limits::default()).unwrap().image;
    resample_image(&photo, Region::whole(photo.width(), photo.height()), 320, 214)
}

fn lit(photo: &Image, gain: f32, bias: f32) -> Image {
    let light = |value: u8| f32::from(value).mul_add(gain, bias).clamp(0.0, 255.0) as u8;
    let rgb: Vec<u8> = photo.to_rgb().into_iter().map(light).collect();
    Image::from_interleaved_rgb(photo.width(), photo.height(), &rgb).unwrap()
}

fn drawn(style: &Style, photo: &Image) -> Vec<u8> {
    let mut context = Context::for_image(photo);
    context.show_painters(Some(crate::painters::painters()));
    stylize(photo, style, &mut context).unwrap().to_rgb()
}

/// Standard deviation of all channels.
fn contrast(rgb: &[u8]) -> f64 {
    let count = rgb.len() as f64;
    let mean = rgb.iter().map(|&v| f64::from(v)).sum::<f64>() / count;
    (rgb.iter().map(|&v| (f64::from(v) - mean).powi(2)).sum::<f64>() / count).sqrt()
}

fn difference(a: &[u8], b: &[u8]) -> f64 {
    a.iter().zip(b).map(|(&a, &b)| f64::from(a.abs_diff(b))).sum::<f64>() / a.len() as f64
}

#[test]
fn the_page_lists_them_family_by_family_in_this_order() {
    let mut shown: Vec<&str> = by_family().iter().map(|style| style.tags[0].as_str()).collect();
    shown.dedup();
    let order: Vec<&str> = FAMILIES.iter().map(|(family, _)| *family).collect();
    assert_eq!(shown, order);
    assert_eq!(by_family().len(), catalogue().len());
}

#[test]
fn there_are_many_and_each_is_in_its_families() {
    assert!(catalogue().len() >= FEWEST, "{} styles", catalogue().len());
    let mut names = BTreeSet::new();
    for style in catalogue() {
        assert!(names.insert(&style.name), "two styles are called {}", style.name);
        let tags: BTreeSet<&str> = style.tags.iter().map(String::as_str).collect();
        assert_eq!(tags.len(), style.tags.len(), "{} has a tag twice", style.id);
        for tag in tags {
            assert!(FAMILIES.iter().any(|(family, _)| *family == tag), "{}: no family {tag}", style.id);
        }
    }
    for (family, _) in FAMILIES {
        let members = catalogue().iter().filter(|style| style.tags.first().is_some_and(|tag| tag == family));
        assert!(members.count() >= 3, "{family} is hardly a family");
    }
}

/// `BLESS=1` updates the table, and the test fails once.
#[test]
fn the_readme_lists_the_families_as_they_are() {
    let mut expected = String::from("| Family | Look | Styles |\n|---|---|---|\n");
    for (family, look) in FAMILIES {
        let members = catalogue().iter().filter(|style| style.tags.first().is_some_and(|tag| tag == family));
        let names: Vec<&str> = members.map(|style| style.name.as_str()).collect();
        writeln!(expected, "| `{family}` | {look} | {} |", names.join(", ")).unwrap();
    }
    let path = crate::root("styles/README.md");
    let readme = fs::read_to_string(&path).unwrap();
    let (before, rest) = readme.split_once(START).unwrap();
    let (table, after) = rest.split_once(END).unwrap();
    if std::env::var_os("BLESS").is_some() && table != expected {
        fs::write(&path, format!("{before}{START}{expected}{END}{after}")).unwrap();
    }
    assert_eq!(table, expected, "`cargo xtask bless` writes the table anew");
}

#[test]
fn no_two_look_alike() {
    let photos = ["07-red-panda.jpg", "09-mariachi.jpg"].map(panel);
    let looks: Vec<Vec<u8>> = catalogue()
        .iter()
        .map(|style| photos.iter().flat_map(|photo| drawn(style, photo)).collect())
        .collect();
    let mut alike = Vec::new();
    for (i, a) in catalogue().iter().enumerate() {
        for (j, b) in catalogue().iter().enumerate().take(i) {
            let apart = difference(&looks[i], &looks[j]);
            if apart < ALIKE {
                alike.push(format!("{} and {}: {apart:.1}", a.id, b.id));
            }
        }
    }
    assert!(alike.is_empty(), "hard to tell apart:\n  {}", alike.join("\n  "));
}

#[test]
fn bad_light_does_not_lose_the_picture() {
    for id in AS_PRINTED {
        assert!(catalogue().iter().any(|style| style.id == id), "no style {id}");
    }
    let mut lost = Vec::new();
    let photos = ["06-castle.jpg", "07-red-panda.jpg"];
    for photo in &photos[..crate::trials(1, 2) as usize] {
        let good = panel(photo);
        for style in catalogue().iter().filter(|style| !AS_PRINTED.contains(&style.id.as_str())) {
            let wanted = contrast(&drawn(style, &good)) * KEPT;
            for (light, gain, bias) in LIGHTS {
                let found = contrast(&drawn(style, &lit(&good, gain, bias)));
                if found < wanted {
                    lost.push(format!("{} on {light} {photo}: {found:.0}, wants {wanted:.0}", style.id));
                }
            }
        }
    }
    assert!(lost.is_empty(), "pale or black:\n  {}", lost.join("\n  "));
}
