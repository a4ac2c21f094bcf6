//! The preview matches print: every built-in style at 960 x 540 looks like the reduced picture at 1920 x
//! 1080.

use std::fs;
use std::sync::Mutex;

use inkpanel_engine::raster::decode::{Limits, decode};
use inkpanel_engine::raster::resize::{Region, resample_image};
use inkpanel_engine::raster::{Image, Plane};
use inkpanel_engine::simd::point::luma_plane;
use inkpanel_engine::style::{Context, Style, catalogue::catalogue, stylize};
use serde_json::Value;

/// Photos with fur, fine twigs and a soft background; and people in bright colours before a wall.
const PHOTOS: &[&str] = &["www/public/samples/02-kitten.jpg", "www/public/samples/09-mariachi.jpg"];

/// Minimum structural similarity of pictures that count as equal.
const SAME: f64 = 0.9;

fn read(path: &str) -> Image {
    decode(&fs::read(crate::root(path)).unwrap(), &Limits::default()).unwrap().image
}

fn sized(image: &Image, width: usize, height: usize) -> Image {
    resample_image(image, Region::whole(image.width(), image.height()), width, height)
}

/// The middle of an image that has the shape of the screen, at its size.
fn screenful(image: &Image) -> Image {
    let (width, height) = (image.width() as f64, image.height() as f64);
    let tall = (width * 9.0 / 16.0).min(height);
    let wide = tall * 16.0 / 9.0;
    let region = Region { x: (width - wide) / 2.0, y: (height - tall) / 2.0, width: wide, height: tall };
    resample_image(image, region, 1920, 1080)
}

fn drawn(style: &Style, image: &Image) -> Image {
    let mut context = Context::for_image(image);
    context.show_painters(Some(crate::painters::painters()));
    stylize(image, style, &mut context).unwrap()
}

/// Mean structural similarity of two planes: windows of 7 x 7, unbiased variances, the borders left out.
///
/// Source: Wang et al., "Image quality assessment: from error visibility to structural similarity", 2004.
fn similarity(a: &Plane, b: &Plane) -> f64 {
    const SIDE: usize = 7;
    const COUNT: f64 = (SIDE * SIDE) as f64;
    let (c1, c2) = ((0.01f64 * 255.0).powi(2), (0.03f64 * 255.0).powi(2));
    let (width, height) = (a.width(), a.height());
    let products = |x: usize, y: usize| {
        let (a, b) = (f64::from(a.at(x, y)), f64::from(b.at(x, y)));
        [a, b, a * a, b * b, a * b]
    };
    // Sums over the last seven rows of each column, then over seven columns.
    let mut columns = vec![[0.0; 5]; width];
    let mut total = 0.0;
    for y in 0..height {
        for (x, column) in columns.iter_mut().enumerate() {
            let old = if y >= SIDE { products(x, y - SIDE) } else { [0.0; 5] };
            let new = products(x, y);
            for i in 0..5 {
                column[i] += new[i] - old[i];
            }
        }
        if y + 1 < SIDE {
            continue;
        }
        for window in columns.windows(SIDE) {
            let mean: [f64; 5] =
                std::array::from_fn(|i| window.iter().map(|sums| sums[i]).sum::<f64>() / COUNT);
            let unbiased = COUNT / (COUNT - 1.0);
            let [u, v, uu, vv, uv] = mean;
            let (var_u, var_v, cov) =
                ((uu - u * u) * unbiased, (vv - v * v) * unbiased, (uv - u * v) * unbiased);
            total += (2.0 * u * v + c1) * (2.0 * cov + c2) / ((u * u + v * v + c1) * (var_u + var_v + c2));
        }
    }
    total / ((width - SIDE + 1) * (height - SIDE + 1)) as f64
}

/// scikit-image's `structural_similarity` of two files, as `tests/oracles/blocks.py` found it.
#[test]
fn similarity_is_that_of_scikit_image() {
    let text = fs::read_to_string(crate::root("tests/oracles/data/blocks/similarity.json")).unwrap();
    let expected: Value = serde_json::from_str(&text).unwrap();
    let luma = luma_plane(&read("tests/oracles/data/blocks/luma.png"));
    let other = luma_plane(&read("tests/oracles/data/blocks/etf.png"));
    let (width, height) = (luma.width(), luma.height());
    let other = Plane::from_fn(width, height, |x, y| other.at(x, y));
    let found = similarity(&luma, &other);
    assert!((found - expected["luma_etf"].as_f64().unwrap()).abs() < 1e-6, "{found} {expected}");
    assert!((similarity(&luma, &luma) - 1.0).abs() < 1e-12);
}

#[test]
fn the_preview_of_every_style_looks_like_its_export() {
    let photos: Vec<(Image, Image)> = PHOTOS
        .iter()
        .map(|path| {
            let full = screenful(&read(path));
            (sized(&full, 960, 540), full)
        })
        .collect();
    // Every fifth style on one photo by default. All styles on both photos take ten minutes on two cores.
    let step = crate::trials(5, 1) as usize;
    let all = step == 1;
    let work: Vec<(&Style, usize)> = catalogue()
        .iter()
        .enumerate()
        .flat_map(|(i, style)| (0..photos.len()).map(move |photo| (i, style, photo)))
        .filter(|&(i, _, _)| i.is_multiple_of(step))
        .filter(|&(i, _, photo)| all || (i + photo).is_multiple_of(PHOTOS.len()))
        .map(|(_, style, photo)| (style, photo))
        .collect();
    let (next, found) = (Mutex::new(work.iter()), Mutex::new(Vec::new()));
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let Some(&(style, photo)) = next.lock().unwrap().next() else { break };
                    let (small, full) = &photos[photo];
                    let preview = drawn(style, small);
                    let export = sized(&drawn(style, full), preview.width(), preview.height());
                    let similarity = similarity(&luma_plane(&preview), &luma_plane(&export));
                    found.lock().unwrap().push((similarity, style.id.clone(), PHOTOS[photo]));
                }
            });
        }
    });
    let mut found = found.into_inner().unwrap();
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (similarity, style, photo) in &found {
        println!("{similarity:.3} {style} {photo}");
    }
    let different: Vec<String> = found
        .iter()
        .filter(|(similarity, ..)| *similarity < SAME)
        .map(|(similarity, style, photo)| format!("{style} on {photo}: {similarity:.3}"))
        .collect();
    assert!(different.is_empty(), "unlike their preview:\n  {}", different.join("\n  "));
}
