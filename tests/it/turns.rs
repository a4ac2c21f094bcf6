//! Choice of photos for automatic pages: people before things, each photo in its turn, no documents.

use inkpanel_engine::document::planning::seen_on;
use inkpanel_engine::framing::{FACE, LETTERING, PhotoMeta, Subject};
use inkpanel_engine::layout;
use inkpanel_engine::page::Document;
use inkpanel_engine::page::request::Request;
use inkpanel_engine::page::shuffle::plan;

fn subject(label: &str, [x, y, width, height]: [f64; 4]) -> Subject {
    Subject {
        x,
        y,
        width,
        height,
        label: label.into(),
        score: 0.9,
        points: None,
        expression: None,
        light: None,
    }
}

/// Photos of objects. The first `people` photos contain one person each.
fn album(count: usize, people: usize) -> Vec<PhotoMeta> {
    (0..count)
        .map(|i| {
            let (width, height) = if i % 3 == 2 { (3000, 4000) } else { (4000, 3000) };
            let mut photo = PhotoMeta {
                fingerprint: (i as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15),
                ..PhotoMeta::unmeasured(&format!("p{i:02}"), width, height)
            };
            photo.subjects = if i < people {
                vec![subject(FACE, [0.42, 0.2, 0.12, 0.16]), subject("person", [0.3, 0.15, 0.35, 0.8])]
            } else {
                vec![subject("clock", [0.3, 0.3, 0.3, 0.35])]
            };
            photo
        })
        .collect()
}

fn shown(page: &Document) -> Vec<String> {
    page.panels.iter().filter_map(|panel| panel.photo.clone()).collect()
}

#[test]
fn after_twelve_shuffles_each_photo_has_appeared() {
    for (count, people) in [(8, 2), (12, 3), (24, 6), (40, 4)] {
        for first in [1, 100, 900] {
            let mut request = Request { photos: album(count, people), ..Request::default() };
            // A small photo, and a blurred one.
            (request.photos[count - 1].width, request.photos[count - 1].height) = (400, 300);
            request.photos[count - 2].sharpness = 0.01;
            for seed in first..first + 12 {
                request.seed = seed;
                let page = plan(&request).unwrap();
                request.recent.push(seen_on(&page));
                request.current = Some(page);
            }
            let missing: Vec<&String> = (request.photos.iter().map(|photo| &photo.id))
                .filter(|id| !request.recent.iter().any(|page| page.contains(id)))
                .collect();
            assert!(missing.is_empty(), "{count} photos, seed {first}: {missing:?}");
        }
    }
}

#[test]
fn people_lead_and_are_not_left_out() {
    let photos = album(12, 3);
    let (mut led, mut all) = (0, 0);
    for seed in 0..60 {
        let page = plan(&Request { seed, photos: photos.clone(), ..Request::default() }).unwrap();
        let seen = seen_on(&page);
        let is_person = |id: &String| photos[..3].iter().any(|photo| &photo.id == id);
        led += usize::from(is_person(&seen[0]));
        all += seen.iter().filter(|id| is_person(id)).count();
        assert!(seen.iter().any(is_person), "seed {seed}");
    }
    assert!(led >= 57, "{led} of 60");
    assert!(all >= 150, "{all} of 180");
}

#[test]
fn a_page_of_text_has_no_panel_while_there_is_anything_else() {
    let mut photos = album(9, 2);
    let mut tones = ["00"; 16];
    (tones[15], tones[14]) = ("c0", "30");
    let facts: inkpanel_engine::framing::Facts =
        serde_json::from_value(format!("{}2020{}{}", tones.concat(), "04", "f0".repeat(6)).into()).unwrap();
    for photo in &mut photos[6..] {
        photo.facts = Some(facts.clone());
        photo.subjects =
            (0..3).map(|line| subject(LETTERING, [0.1, 0.1 + 0.25 * f64::from(line), 0.7, 0.12])).collect();
    }
    for seed in 0..40 {
        let page = plan(&Request { seed, photos: photos.clone(), ..Request::default() }).unwrap();
        let text: Vec<String> = shown(&page).into_iter().filter(|id| **id >= *"p06").collect();
        assert!(text.is_empty(), "seed {seed}: {text:?}");
    }
    let page = plan(&Request { photos: photos.split_off(6), ..Request::default() }).unwrap();
    assert!(!shown(&page).is_empty(), "there is nothing else");
}

#[test]
fn only_dates_and_the_user_give_photos_an_order() {
    let ascending = |request: &Request| {
        (0..30u32)
            .filter(|&seed| {
                let page = plan(&Request { seed, ..request.clone() }).unwrap();
                let all = shown(&page);
                // A photo with a close crop has two places.
                let once = |id: &&String| all.iter().filter(|other| other == id).count() == 1;
                all.iter().filter(once).collect::<Vec<_>>().is_sorted()
            })
            .count()
    };
    let mut request = Request { photos: album(12, 4), merge: Some(false), ..Request::default() };
    assert!(ascending(&request) < 10);
    request.ordered = Some(true);
    assert_eq!(ascending(&request), 30);
    request.ordered = None;
    for (i, photo) in request.photos.iter_mut().enumerate() {
        photo.taken = Some(format!("2024:05:17 10:{i:02}:00"));
    }
    assert_eq!(ascending(&request), 30);
    for photo in &mut request.photos {
        photo.taken = Some("2024:05:17 10:00:00".into());
    }
    assert!(ascending(&request) < 10, "one moment is no order");
}

#[test]
fn a_group_may_be_seen_from_near_as_well() {
    let mut photos = album(10, 0);
    photos[4].subjects = [0.2, 0.45, 0.7].map(|x| subject(FACE, [x, 0.3, 0.08, 0.14])).to_vec();
    let mut twice = 0;
    for seed in 0..40 {
        let page = plan(&Request { seed, photos: photos.clone(), merge: Some(false), ..Request::default() })
            .unwrap();
        let crops: Vec<_> =
            page.panels.iter().filter(|panel| panel.photo.as_deref() == Some("p04")).collect();
        assert!(crops.len() <= 2, "seed {seed}");
        if let [a, b] = crops[..] {
            let (a, b) = (a.crop.unwrap(), b.crop.unwrap());
            let ratio = (a.width * a.height) / (b.width * b.height);
            assert!(!(0.5..2.0).contains(&ratio), "{a:?} {b:?}");
            twice += 1;
        }
    }
    assert!(twice > 10, "{twice} of 40");
}

#[test]
fn automatic_layouts_have_no_stamps_few_panels_and_are_lively() {
    let photos = album(12, 4);
    let (mut lively, mut liked, mut led) = (0, 0, 0);
    for seed in 0..100 {
        let page = plan(&Request { seed, photos: photos.clone(), ..Request::default() }).unwrap();
        let template = page.template().unwrap();
        let mut shares = template.shares(page.page.aspect());
        shares.sort_by(|a, b| b.total_cmp(a));
        assert!(shares.last() >= Some(&0.069), "{}", template.id());
        lively += usize::from(template.is_lively());
        liked += usize::from((5..=6).contains(&shares.len()));
        led += usize::from(shares[0] >= 1.55 * shares[1]);
    }
    assert!(lively >= 50, "{lively} of 100");
    assert!(liked >= 75 && led >= 75, "{liked} {led} of 100");
    assert!(layout::catalogue().len() >= 70);
}
