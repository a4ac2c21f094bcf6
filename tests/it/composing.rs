//! Albums with little or no choice for the composer: each gives a complete page, and the same seed gives the
//! same page.

use inkpanel_engine::framing::PhotoMeta;
use inkpanel_engine::page::Document;
use inkpanel_engine::page::import::import;
use inkpanel_engine::page::request::{Mode, Request};
use inkpanel_engine::page::shuffle::planned;
use inkpanel_engine::plan::Shelf;
use inkpanel_engine::raster::decode::Limits;

/// A photo of one colour, read as a file would be.
fn plain(id: &str, width: usize, height: usize, grey: u8) -> PhotoMeta {
    let pixels = vec![grey; width * height * 3];
    let png = inkpanel_engine::page::png::encode_rgb(width, height, &pixels, 96).unwrap();
    import(id, &png, &Limits::default()).unwrap().meta
}

fn page(photos: &[PhotoMeta], panels: Option<usize>, mode: Mode, seed: u32) -> Document {
    let request = Request { seed, photos: photos.to_vec(), panels, mode, ..Request::default() };
    let document = planned(&request, &Shelf::new(photos.len())).unwrap().document;
    assert_eq!(
        document,
        planned(&request, &Shelf::new(photos.len())).unwrap().document,
        "the same seed, the same page"
    );
    document
}

/// Checks that every panel has a photo of the album and a crop inside it.
fn check(document: &Document, photos: &[PhotoMeta]) {
    assert!(!document.panels.is_empty());
    for (i, panel) in document.panels.iter().enumerate() {
        if document.merge_of(i).is_some_and(|group| group.first() != Some(&i)) {
            continue;
        }
        let id = panel.photo.as_ref().unwrap();
        assert!(photos.iter().any(|photo| &photo.id == id));
        let crop = panel.crop.unwrap();
        for value in [crop.x, crop.y, crop.width, crop.height] {
            assert!(value.is_finite() && (0.0..=1.0).contains(&value), "{crop:?}");
        }
        assert!(crop.width > 0.0 && crop.height > 0.0);
        assert!(crop.x + crop.width <= 1.0 + 1e-9 && crop.y + crop.height <= 1.0 + 1e-9, "{crop:?}");
    }
}

fn check_all(photos: &[PhotoMeta]) {
    for mode in [Mode::Shuffle, Mode::Photos] {
        for panels in [None, Some(1), Some(6), Some(9)] {
            for seed in 0..4 {
                check(&page(photos, panels, mode, seed), photos);
            }
        }
    }
}

#[test]
fn photos_of_one_row_and_of_one_column() {
    let mut photos: Vec<_> = (0..4).map(|i| plain(&format!("row-{i}"), 3000, 1, 40 * i)).collect();
    photos.extend((0..4).map(|i| plain(&format!("column-{i}"), 1, 3000, 40 * i)));
    photos.push(plain("dot", 1, 1, 128));
    check_all(&photos);
}

#[test]
fn photos_that_are_all_alike_or_all_black() {
    for grey in [0, 255] {
        let photos: Vec<_> = (0..12).map(|i| plain(&format!("p{i}"), 90, 60, grey)).collect();
        check_all(&photos);
        let document = page(&photos, Some(6), Mode::Shuffle, 1);
        let mut shown: Vec<_> = document.panels.iter().filter_map(|panel| panel.photo.clone()).collect();
        shown.sort();
        shown.dedup();
        assert!(shown.len() >= 5, "photos that look alike are still different photos: {shown:?}");
    }
}

#[test]
fn one_photo_for_nine_panels() {
    let photos = [plain("only", 300, 200, 90)];
    check_all(&photos);
    let document = page(&photos, Some(9), Mode::Shuffle, 2);
    assert_eq!(document.panels.len(), 9);
}

#[test]
fn a_thousand_photos() {
    let one = plain("one", 120, 90, 77);
    let photos: Vec<_> = (0..1000u64)
        .map(|i| PhotoMeta {
            id: format!("p{i}"),
            fingerprint: i.wrapping_mul(0x9e37_79b9_7f4a_7c15),
            starred: i == 500,
            ..one.clone()
        })
        .collect();
    for seed in 0..4 {
        let document = page(&photos, None, Mode::Shuffle, seed);
        check(&document, &photos);
        assert!(
            document.panels.iter().any(|panel| panel.photo.as_deref() == Some("p500")),
            "the star is on it"
        );
    }
}

#[test]
fn no_photos_are_refused_in_words() {
    let request = Request::default();
    let said = planned(&request, &Shelf::new(0)).unwrap_err().to_string();
    assert!(said.contains("photo"), "{said}");
}
