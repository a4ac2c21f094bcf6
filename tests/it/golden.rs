//! Golden pictures: compares rendered pictures with reviewed ones. A folder of `tests/goldens/` has one PNG
//! per subject, named after it. A test renders all subjects of a folder, so a missing golden is found, and a
//! golden without a subject too.
//!
//! `BLESS=1` (`cargo xtask bless goldens`) stores the current output of different pictures, and the test
//! fails once.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::{env, fs};

use inkpanel_engine::raster::Image;
use inkpanel_engine::raster::decode::{Limits, decode};
use png::{BitDepth, ColorType, Compression, Encoder};

/// Maximum difference of a channel in grey levels. On one machine, all builds agree: builds with and
/// without optimisation, for SSE2 and for AVX2 with fused multiply-add, give identical bytes. But powers,
/// logarithms and sines come from the platform, which may round their last bit differently.
const STEPS: u8 = 1;

/// Factor that brightens the differences in a triptych, so that invisible ones can be seen.
const BRIGHTENED: u8 = 8;

/// Pixels between the pictures of a triptych, and their grey.
const GAP: usize = 6;
const GAP_GREY: u8 = 128;

/// The goldens of one folder, against which pictures are held one by one.
pub(crate) struct Goldens {
    folder: &'static str,
    allowed: f64,
    seen: BTreeSet<String>,
    wrong: Vec<String>,
}

impl Goldens {
    /// The goldens of `tests/goldens/folder`. A share `allowed` of the pixels of a picture may differ by more.
    pub(crate) fn of(folder: &'static str, allowed: f64) -> Self {
        Self { folder, allowed, seen: BTreeSet::new(), wrong: Vec::new() }
    }

    /// Compares a rendered picture with the golden of this name.
    pub(crate) fn hold(&mut self, name: &str, now: &Image) {
        assert!(self.seen.insert(name.to_owned()), "{name} is drawn twice");
        let path = self.path().join(format!("{name}.png"));
        let before = fs::read(&path).ok().map(|bytes| decode(&bytes, &Limits::default()).unwrap().image);
        let told = match &before {
            None => "is missing".to_owned(),
            Some(before) if size(before) != size(now) => {
                format!("is {:?}, now {:?}", size(before), size(now))
            }
            Some(before) => {
                let count = differing(before, now);
                let pixels = now.width() * now.height();
                if count as f64 <= self.allowed * pixels as f64 {
                    return;
                }
                format!("{count} of {pixels} pixels differ")
            }
        };
        let subject = format!("{}/{name}.png: {told}", self.folder);
        if blessing() {
            fs::create_dir_all(self.path()).unwrap();
            fs::write(&path, encoded(now.width(), now.height(), &now.to_rgb())).unwrap();
            self.wrong.push(format!("{subject}; blessed"));
        } else {
            let failed = triptych(self.folder, name, before.as_ref(), now);
            self.wrong.push(format!("{subject}; see {}", failed.display()));
        }
    }

    /// Fails if goldens differ, are missing, or have no subject.
    pub(crate) fn finish(mut self) {
        let stored = fs::read_dir(self.path()).into_iter().flatten().map(|entry| entry.unwrap().path());
        let mut stale: Vec<PathBuf> = stored
            .filter(|path| !path.file_stem().is_some_and(|stem| self.seen.contains(&*stem.to_string_lossy())))
            .collect();
        stale.sort();
        for path in stale {
            let file = path.file_name().unwrap().to_string_lossy().into_owned();
            let done = if blessing() {
                fs::remove_file(&path).unwrap();
                "; removed"
            } else {
                ""
            };
            self.wrong.push(format!("{}/{file}: is stale, what it shows is gone{done}", self.folder));
        }
        assert!(
            self.wrong.is_empty(),
            "goldens (expected, actual and difference stand side by side; where the change is meant, \
             `cargo xtask bless goldens`):\n  {}",
            self.wrong.join("\n  ")
        );
    }

    fn path(&self) -> PathBuf {
        crate::root("tests/goldens").join(self.folder)
    }
}

fn blessing() -> bool {
    env::var_os("BLESS").is_some()
}

fn size(image: &Image) -> (usize, usize) {
    (image.width(), image.height())
}

/// Number of pixels with a channel that differs by more than [`STEPS`].
fn differing(a: &Image, b: &Image) -> usize {
    let (a, b) = (a.to_rgb(), b.to_rgb());
    let off = |(a, b): (&[u8], &[u8])| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > STEPS);
    a.chunks(3).zip(b.chunks(3)).filter(|pair| off(*pair)).count()
}

/// Writes expected, actual and difference side by side to `target/goldens/`. Without an expected picture, its
/// place stays empty.
fn triptych(folder: &str, name: &str, before: Option<&Image>, now: &Image) -> PathBuf {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().unwrap().join("goldens").join(folder);
    fs::create_dir_all(&target).unwrap();
    let (width, height) = before
        .map_or(size(now), |before| (before.width().max(now.width()), before.height().max(now.height())));
    let pixels = |image: &Image| on_grey(image, width, height);
    let expected = before.map_or_else(|| vec![GAP_GREY; 3 * width * height], pixels);
    let actual = pixels(now);
    let difference: Vec<u8> =
        expected.iter().zip(&actual).map(|(a, b)| a.abs_diff(*b).saturating_mul(BRIGHTENED)).collect();
    let gap = [GAP_GREY; 3 * GAP];
    let rows = (0..height).flat_map(|y| {
        let row = |pixels: &[u8]| pixels[3 * width * y..3 * width * (y + 1)].to_vec();
        [&row(&expected)[..], &gap, &row(&actual), &gap, &row(&difference)].concat()
    });
    let path = target.join(format!("{name}.png"));
    fs::write(&path, encoded(3 * width + 2 * GAP, height, &rows.collect::<Vec<_>>())).unwrap();
    path
}

/// The pixels of an image in the corner of a larger one.
fn on_grey(image: &Image, width: usize, height: usize) -> Vec<u8> {
    let mut whole = vec![GAP_GREY; 3 * width * height];
    for (below, row) in whole.chunks_mut(3 * width).zip(image.to_rgb().chunks(3 * image.width())) {
        below[..row.len()].copy_from_slice(row);
    }
    whole
}

/// A PNG with the best compression, because it stays in git.
fn encoded(width: usize, height: usize, rgb: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width as u32, height as u32);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(rgb).unwrap();
    writer.finish().unwrap();
    bytes
}
