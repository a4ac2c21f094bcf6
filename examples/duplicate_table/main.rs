//! How well near-duplicates are grouped: precision and recall over altered copies of photos; `cargo xtask duplicates`
//! runs it.
//!
//!     cargo run --example duplicate_table -- TABLE.md FRAMES PHOTOS...

mod films;
mod variants;

use std::error::Error;
use std::fmt::Write as _;
use std::path::PathBuf;

use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode_fit};
use inkpanel_engine::select::{DUPLICATE_THRESHOLD, Measures, Settings, choose, measure};
use variants::variants;

/// Long side that photos are measured at, in pixels.
const SIDE: usize = 640;
const THRESHOLDS: [u32; 5] = [4, 7, 10, 13, 16];

const ABOUT: &str = "\
# Near-duplicates: found and mistaken

This report measures how reliably Inkpanel groups similar photos.
`cargo xtask duplicates` writes it from the test photos and the sample album.

Every photo is altered in the ways that the first table lists.
All photos and all copies form one album, which is grouped like an album in the app.

- Pair: two pictures of the album in one group.
- Precision: the share of pairs that come from one photo.
- Recall: the share of copies in the group of their photo.

A crop at a corner moves the content by a twentieth, which the fingerprint does not tolerate by design.
The last line and the second table exclude it.
";

/// A copy in the album: the index of its photo, and of its variant (0 is the photo itself).
struct Picture {
    photo: usize,
    kind: usize,
    measures: Measures,
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<PathBuf> = std::env::args().skip(1).map(PathBuf::from).collect();
    let [table, frames, photos @ ..] = arguments.as_slice() else {
        return Err("usage: duplicate_table TABLE.md FRAMES PHOTOS...".into());
    };
    let mut names = vec!["the photo itself"];
    let mut album = Vec::new();
    for (i, path) in photos.iter().enumerate() {
        let photo: Image = decode_fit(&std::fs::read(path)?, &Limits::default(), SIDE)?.image;
        album.push(Picture { photo: i, kind: 0, measures: measure(&photo) });
        for (kind, (name, copy)) in variants(&photo).into_iter().enumerate() {
            if i == 0 {
                names.push(name);
            }
            album.push(Picture { photo: i, kind: kind + 1, measures: measure(&copy) });
        }
        eprint!("\r{} of {}", i + 1, photos.len());
    }
    eprintln!();
    let text = written(&names, &album, photos.len()) + &films::written(frames)?;
    print!("{text}");
    std::fs::write(table, format!("{ABOUT}\n{text}"))?;
    Ok(())
}

/// The group of each picture.
fn groups(album: &[&Picture], duplicate_threshold: u32) -> Vec<usize> {
    let measures: Vec<Measures> = album.iter().map(|copy| copy.measures.clone()).collect();
    let names = vec!["x"; album.len()];
    choose(&names, &measures, &Settings { duplicate_threshold, ..Settings::default() })
        .into_iter()
        .map(|verdict| verdict.group)
        .collect()
}

/// Copies of a kind in the group of their photo, and copies of that kind.
fn found(album: &[&Picture], groups: &[usize], kind: usize) -> (usize, usize) {
    let home = |photo: usize| album.iter().position(|copy| copy.photo == photo && copy.kind == 0);
    let of_kind = || album.iter().enumerate().filter(|(_, copy)| copy.kind == kind);
    let right = of_kind().filter(|(i, copy)| home(copy.photo).is_some_and(|at| groups[at] == groups[*i]));
    (right.count(), of_kind().count())
}

/// Pairs of one photo in one group, and all pairs in one group.
fn pairs(album: &[&Picture], groups: &[usize]) -> (usize, usize) {
    let together =
        (0..album.len()).flat_map(|i| (0..i).map(move |j| (i, j))).filter(|&(i, j)| groups[i] == groups[j]);
    let (mut right, mut all) = (0, 0);
    for (i, j) in together {
        all += 1;
        right += usize::from(album[i].photo == album[j].photo);
    }
    (right, all)
}

fn percent((part, all): (usize, usize)) -> String {
    format!("{:.1} %", 100.0 * part as f64 / all.max(1) as f64)
}

fn written(names: &[&str], album: &[Picture], photos: usize) -> String {
    let everything: Vec<&Picture> = album.iter().collect();
    let threshold = DUPLICATE_THRESHOLD;
    let grouped = groups(&everything, threshold);
    let mut text = format!("| Copies of {photos} photos, threshold {threshold} | Recall |\n|---|--:|\n");
    let is_meant = |kind: usize| kind > 0 && !names[kind].contains("corner");
    let mut all = (0, 0);
    for (kind, name) in names.iter().enumerate().skip(1) {
        let one = found(&everything, &grouped, kind);
        // Writing to a string cannot fail.
        let _ = writeln!(text, "| {name} | {} |", percent(one));
        if is_meant(kind) {
            all = (all.0 + one.0, all.1 + one.1);
        }
    }
    let _ = writeln!(text, "| all except the corner | {} |", percent(all));
    let meant: Vec<&Picture> = album.iter().filter(|copy| copy.kind == 0 || is_meant(copy.kind)).collect();
    let _ = writeln!(text, "\n| Threshold | Precision | Recall | Wrong pairs |\n|--:|--:|--:|--:|");
    for threshold in THRESHOLDS {
        let grouped = groups(&meant, threshold);
        let (right, together) = pairs(&meant, &grouped);
        let kinds = (1..names.len()).filter(|kind| is_meant(*kind)).map(|kind| found(&meant, &grouped, kind));
        let recall = kinds.fold((0, 0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
        let _ = writeln!(
            text,
            "| {threshold} | {} | {} | {} |",
            percent((right, together)),
            percent(recall),
            together - right
        );
    }
    text
}
