//! Geometric measurements of two hundred automatic pages.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::time::Instant;

use inkpanel_engine::framing::{FACE, PhotoMeta, Subject};
use inkpanel_engine::layout::{self, Bounds, PageSettings, ResolvedPanel, ResolvedShape, polygon};
use inkpanel_engine::page::Document;
use inkpanel_engine::page::request::Request;
use inkpanel_engine::page::shuffle::planned;
use inkpanel_engine::plan::Shelf;
use inkpanel_engine::plan::composer::gallery;
use inkpanel_engine::plan::slots::LEADS;
use rayon::prelude::*;

use crate::seen::seen;
use crate::{Failure, Photo, page, shuffles};

const PAGES: u32 = 200;
/// Text above the table.
const ABOUT: &str = "\
# Automatic pages

This report measures what automatic pages cut and how varied they are.
`cargo xtask pages` writes it.

It plans 200 pages.
Each page uses twelve random photos of the sample album and the tests, and its page number as seed.
Cuts are measured with points against the exact panel outlines.
A subject counts if it covers at least 1 % of the photo and is not scenery.
A body does not count if its face is complete.

| Metric | Measured | Goal |
|---|---|---|
";

#[derive(Default)]
struct Counted {
    family: String,
    layout: String,
    style: String,
    panels: usize,
    cut_faces: usize,
    cut_heads: usize,
    cut_subjects: usize,
    little: usize,
    blown_up: usize,
    hero: bool,
    merged: bool,
    what: Vec<String>,
}

pub(crate) fn write(photos: &[Photo], output: &str) -> Result<(), Failure> {
    let shelves = |number: u32| {
        let (planned, album) = page(photos, number)?;
        counted(&planned.document, &album, photos)
    };
    let pages = (1..=PAGES).into_par_iter().map(shelves).collect::<Result<Vec<Counted>, Failure>>()?;
    let text = format!("{ABOUT}{}{}{}", table(&pages), shuffles::rows(photos)?, times(photos)?);
    if output == "-" {
        print!("{text}");
    } else {
        std::fs::write(output, text)?;
    }
    if std::env::var_os("WHAT").is_some() {
        for (i, page) in pages.iter().enumerate().filter(|(_, page)| !page.what.is_empty()) {
            eprintln!("{} {} {}: {}", i + 1, page.layout, page.style, page.what.join("; "));
        }
    }
    Ok(())
}

fn counted(document: &Document, album: &[PhotoMeta], photos: &[Photo]) -> Result<Counted, Failure> {
    let template = document.template()?;
    let page = &document.page;
    let panels = layout::resolve(&template, page.aspect(), page);
    let mut counted = Counted {
        family: template.family().to_owned(),
        layout: template.id().to_owned(),
        style: document.style.built_in().unwrap_or("own").to_owned(),
        merged: !document.merges.is_empty(),
        ..Counted::default()
    };
    let shelf = Shelf::new(album.len());
    let gallery = gallery(album, &shelf);
    let mut largest = (0.0, 0.0);
    for (i, content) in document.panels.iter().enumerate() {
        let group = document.merge_of(i).map_or_else(|| vec![i], <[usize]>::to_vec);
        if group[0] != i {
            continue;
        }
        let (Some(id), Some(crop)) = (&content.photo, content.crop) else { continue };
        let at = album.iter().position(|photo| &photo.id == id).unwrap_or(0);
        let photo = &album[at];
        let name = photos.iter().find(|p| &p.meta.id == id).map_or("", |p| p.name.as_str());
        let bounds =
            group.iter().map(|&i| panels[i].bounds).reduce(Bounds::union).unwrap_or(panels[i].bounds);
        counted.panels += 1;
        let (mut face, mut head, mut subject) = (false, false, false);
        for s in &photo.subjects {
            let partly = |s: &Subject, most: f64| {
                let (all, one) = seen(s, &crop, bounds, &panels, &group);
                all > 0.08 && one < most
            };
            if s.label == FACE {
                face |= partly(s, 0.9);
                head |= partly(&s.grown(), 0.9);
            } else {
                let whole = |o: &&Subject| {
                    s.label == "person" && o.label == FACE && s.surrounds(o) && !partly(o, 0.9)
                };
                let portrait = photo.subjects.iter().any(|other| whole(&other));
                let counts = s.width * s.height >= 0.01 && !s.is_scenery() && !portrait;
                subject |= counts && partly(s, 0.82);
            }
        }
        let whole = Subject {
            x: 0.0,
            y: 0.0,
            width: 1.0,
            height: 1.0,
            label: String::new(),
            score: 1.0,
            points: None,
            expression: None,
            light: None,
        };
        let (kept, _) = seen(&whole, &crop, bounds, &panels, &group);
        let enlarged = bounds.width * f64::from(page.width) / (crop.width * f64::from(photo.width));
        counted.cut_faces += usize::from(face);
        counted.cut_heads += usize::from(head && !face);
        counted.cut_subjects += usize::from(subject);
        counted.little += usize::from(kept < 0.4);
        counted.blown_up += usize::from(enlarged > 2.5);
        let faults = [
            (face, "face"),
            (head, "head"),
            (subject, "subject"),
            (kept < 0.4, "little"),
            (enlarged > 2.5, "blown up"),
        ];
        for (_, fault) in faults.iter().filter(|(is, _)| *is) {
            counted.what.push(format!("panel {} {name} {fault} kept {kept:.2}", i + 1));
        }
        let area = group.iter().map(|&i| size(&panels[i])).sum::<f64>();
        if area > largest.0 / LEADS {
            largest = (area, gallery.rank[at]);
        } else if area >= LEADS * largest.0 {
            largest = (area.max(largest.0), gallery.rank[at].max(largest.1));
        }
    }
    counted.hero = largest.1 > 2.0 / 3.0 - 1e-9;
    Ok(counted)
}

fn size(panel: &ResolvedPanel) -> f64 {
    match &panel.shape {
        ResolvedShape::Circle { radius, .. } => std::f64::consts::PI * radius * radius,
        ResolvedShape::Polygon(corners) => polygon::area(corners),
    }
}

fn table(pages: &[Counted]) -> String {
    let panels: usize = pages.iter().map(|page| page.panels).sum();
    let share = |count: usize, of: usize| 100.0 * count as f64 / of.max(1) as f64;
    let of_panels = |f: &dyn Fn(&Counted) -> usize| share(pages.iter().map(f).sum(), panels);
    let mut families: BTreeMap<&str, usize> = BTreeMap::new();
    let mut layouts: BTreeMap<&str, usize> = BTreeMap::new();
    let mut styles: BTreeMap<&str, usize> = BTreeMap::new();
    for page in pages {
        *families.entry(&page.family).or_default() += 1;
        *layouts.entry(&page.layout).or_default() += 1;
        *styles.entry(&page.style).or_default() += 1;
    }
    let entropy: f64 =
        layouts.values().map(|&n| n as f64 / pages.len() as f64).map(|share| -share * share.log2()).sum();
    let aspect = PageSettings::default().aspect();
    let offered: std::collections::BTreeSet<&str> = layout::good_for(aspect)
        .iter()
        .filter(|t| (3..=9).contains(&t.panels().len()))
        .map(|t| t.family())
        .collect();
    let missing: Vec<&str> = offered.into_iter().filter(|family| !families.contains_key(family)).collect();
    let heroes = share(pages.iter().filter(|page| page.hero).count(), pages.len());
    let mut text = String::new();
    let mut row = |name: &str, value: String, bar: &str| {
        let _ = writeln!(text, "| {name} | {value} | {bar} |");
    };
    row("pages, panels", format!("{}, {panels}", pages.len()), "");
    row("panels with a cut face", format!("{:.1} %", of_panels(&|p| p.cut_faces)), "0");
    row("panels with a cut head and a complete face", format!("{:.1} %", of_panels(&|p| p.cut_heads)), "");
    row("panels with a cut subject", format!("{:.1} %", of_panels(&|p| p.cut_subjects)), "2 %");
    row(
        "panels that show less than 40 % of their photo",
        format!("{:.1} %", of_panels(&|p| p.little)),
        "3 %",
    );
    row("panels enlarged by more than 2.5", format!("{:.1} %", of_panels(&|p| p.blown_up)), "1 %");
    row("pages with one of the best photos in the largest panel", format!("{heroes:.0} %"), "90 %");
    row(
        "pages of the most frequent family",
        most_frequent(pages.iter().map(|page| page.family.as_str())),
        "35 %",
    );
    row("families never used", if missing.is_empty() { "none".into() } else { missing.join(", ") }, "none");
    row("layouts used, entropy", format!("{}, {entropy:.2} bits", layouts.len()), "5 bits");
    row("styles used", styles.len().to_string(), "");
    row(
        "pages with merged panels",
        format!("{:.0} %", share(pages.iter().filter(|p| p.merged).count(), pages.len())),
        "",
    );
    let counts: Vec<String> = families.iter().map(|(family, n)| format!("{family} {n}")).collect();
    row("pages by family", counts.join(", "), "");
    text
}

/// The most frequent family of some pages, and its share.
pub(crate) fn most_frequent<'a>(pages: impl Iterator<Item = &'a str>) -> String {
    let mut families: BTreeMap<&str, usize> = BTreeMap::new();
    let mut all = 0;
    for family in pages {
        *families.entry(family).or_default() += 1;
        all += 1;
    }
    let most = families.into_iter().max_by_key(|(_, count)| *count);
    most.map_or_else(String::new, |(family, count)| {
        format!("{:.0} % ({family})", 100.0 * count as f64 / f64::from(all))
    })
}

/// Milliseconds of a plan on this machine, from analysed photos.
fn times(photos: &[Photo]) -> Result<String, Failure> {
    let mut text = String::new();
    for count in [12, 100, 1000] {
        let album: Vec<PhotoMeta> = (0..count)
            .map(|i| {
                let meta = &photos[i % photos.len()].meta;
                let fingerprint = meta.fingerprint ^ (i as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
                PhotoMeta { id: format!("copy-{i}"), fingerprint, ..meta.clone() }
            })
            .collect();
        let shelf = Shelf::new(count);
        let begin = Instant::now();
        // A gallery contains every photo.
        let _ = gallery(&album, &shelf);
        let look = begin.elapsed().as_secs_f64() * 1e3 / count as f64;
        let mut request = Request { photos: album, ..Request::default() };
        let mut spent = Vec::new();
        for seed in 0..30 {
            request.seed = seed;
            let begin = Instant::now();
            planned(&request, &shelf)?;
            spent.push(begin.elapsed().as_secs_f64() * 1e3);
        }
        spent.sort_by(f64::total_cmp);
        let _ = writeln!(
            text,
            "| plan of {count} photos, native | {:.1} ms (max {:.1}), plus {look:.2} ms once per photo | |",
            spent[spent.len() / 2],
            spent[spent.len() - 1],
        );
    }
    Ok(text)
}
