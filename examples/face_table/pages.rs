//! Counts faces and heads that the panels of whole pages cut: every panel of every layout, and every merge of
//! its panels.

use std::fmt::Write as _;

use inkpanel_engine::framing::{Crop, FACE, PhotoMeta, Subject, frame};
use inkpanel_engine::layout::merge::mergeable;
use inkpanel_engine::layout::{PageSettings, ResolvedPanel, Template, catalogue, resolve};
use inkpanel_engine::plan::slots::{Slot, slot};
use rayon::prelude::*;

use crate::cuts::crops;
use crate::seen::seen;

/// Text above the table.
const ABOUT: &str = "\
## Whole pages

Each photo with a face is cropped for every panel of every layout, including slanted edges, circles and overlays.
It is also cropped for every group of panels that can share one photo, with the gutters inside the image.
A face is cut if a panel shows between 8 % and 90 % of it, measured with points against the exact outlines.
A head is the face with hair and ears.
A cut is avoidable if another crop of the same shape shows a face or head completely and cuts no other.

| Panels | Crops | Faces cut | Avoidable | Heads cut, face complete | Avoidable |
|---|--:|--:|--:|--:|--:|
";
/// Steps of the sizes and places of crops that are tried for a cut that could be avoided.
const SIZES: usize = 7;
const PLACES: usize = 15;

/// Panels framed, faces cut, those avoidable, heads cut, those avoidable.
type Counts = [usize; 5];

pub(crate) fn table(photos: &[&PhotoMeta]) -> String {
    let photos: Vec<&PhotoMeta> =
        photos.iter().copied().filter(|photo| photo.subjects.iter().any(|s| s.label == FACE)).collect();
    let of = |template: &Template| {
        let page = page_for(template.aspect());
        let panels = resolve(template, page.aspect(), &page);
        let mut counts = [Counts::default(); 3];
        let singles = (0..panels.len()).map(|i| vec![i]);
        for group in singles.chain(mergeable(template)) {
            let Some(slot) = slot(&panels, &group, f64::from(page.width), false) else { continue };
            let kind = match (group.len() > 1, slot.target.region.is_plain() && !slot.target.round) {
                (true, _) => 2,
                (false, plain) => usize::from(!plain),
            };
            for photo in &photos {
                let counted = counted(photo, &slot, &panels, &group);
                counts[kind].iter_mut().zip(counted).for_each(|(sum, count)| *sum += count);
            }
        }
        counts
    };
    let all: Vec<[Counts; 3]> = catalogue().par_iter().map(of).collect();
    let mut text = ABOUT.to_owned();
    for (kind, name) in ["rectangles", "slanted, round or below overlays", "merged"].iter().enumerate() {
        let mut total = Counts::default();
        for counts in &all {
            total.iter_mut().zip(counts[kind]).for_each(|(sum, count)| *sum += count);
        }
        // Writing to a string cannot fail.
        let _ = writeln!(text, "| {name} | {} |", total.map(|count| count.to_string()).join(" | "));
    }
    let _ = writeln!(text, "\n{} layouts, {} photos with faces.", all.len(), photos.len());
    text
}

fn counted(photo: &PhotoMeta, slot: &Slot, panels: &[ResolvedPanel], group: &[usize]) -> Counts {
    let crop = frame(photo, &slot.target, 0);
    let faces: Vec<&Subject> = photo.subjects.iter().filter(|subject| subject.label == FACE).collect();
    let heads: Vec<Subject> = faces.iter().map(|face| face.grown()).collect();
    let heads: Vec<&Subject> = heads.iter().collect();
    let shares = |crop: &Crop, subject: &Subject| seen(subject, crop, slot.bounds, panels, group);
    let cut = |crop: &Crop, subjects: &[&Subject]| {
        subjects.iter().any(|subject| {
            let (all, one) = shares(crop, subject);
            all > 0.08 && one < 0.9
        })
    };
    let (face, head) = (cut(&crop, &faces), cut(&crop, &heads));
    let possible = |subjects: &[&Subject]| {
        crops(photo, slot.target.aspect, SIZES, PLACES).any(|crop| {
            !cut(&crop, subjects) && subjects.iter().any(|subject| shares(&crop, subject).1 >= 0.9)
        })
    };
    let count = |is: bool| usize::from(is);
    [
        1,
        count(face),
        count(face && possible(&faces)),
        count(head && !face),
        count(head && !face && possible(&heads)),
    ]
}

/// A page of that width over its height.
fn page_for(aspect: f64) -> PageSettings {
    let mut page = PageSettings::default();
    page.height = (f64::from(page.width) / aspect).round() as u32;
    page
}
