//! Automatic choice of a style: a built-in, a custom or a generated style. The request can retain the line
//! layer or the colour layer.

use super::fill::Stage;
use super::reference::StyleRef;
use super::request::Request;
use crate::error::{Error, Result};
use crate::layout::PageSettings;
use crate::plan::Plan;
use crate::plan::layouts::is_within;
use crate::plan::tones::{self, Shown};
use crate::style::{Style, catalogue, procedural};
use oorandom::Rand64;

/// Share of shuffles whose style keeps the colours of the photos.
const IN_COLOUR: f64 = 0.5;
/// Share of first pages whose style keeps the colours of the photos.
const FIRST_IN_COLOUR: f64 = 0.97;
/// Colours of paper and borders for a dark style.
const DARK_PAPER: &str = "#15141a";
const DARK_BORDER: &str = "#07070a";

/// Returns the style of the request, the retained style, or a random style.
pub(super) fn choose_style(
    request: &Request,
    stage: &Stage,
    plan: &Plan,
    random: &mut Rand64,
) -> Result<StyleRef> {
    if let Some(style) = &request.style {
        return Ok(style.clone());
    }
    let current = request.current.as_ref().map(|current| &current.style);
    let wish = &request.styling;
    if let Some(current) = current.filter(|_| request.keep.style || (wish.keep_lines && wish.keep_colours)) {
        return Ok(current.clone());
    }
    let shown = Shown::of(&stage.candidate.slots, &plan.panels, &request.photos, request.page.aspect());
    let drawn = draw(request, current, &shown, random)?;
    match current {
        Some(current) if wish.keep_lines => Ok(joined(&*drawn.style()?, &*current.style()?)),
        Some(current) if wish.keep_colours => Ok(joined(&*current.style()?, &*drawn.style()?)),
        _ => Ok(drawn),
    }
}

fn draw(
    request: &Request,
    current: Option<&StyleRef>,
    page: &Shown,
    random: &mut Rand64,
) -> Result<StyleRef> {
    let wish = &request.styling;
    // A generated style has no line layer, so it cannot replace only the lines.
    let lines_only = wish.keep_colours && current.is_some();
    let before = current.and_then(|style| style.id());
    let shown = |id: &str| Some(id) == before || request.avoid.styles.iter().any(|other| other == id);
    // The first page must look good at once: it gets one of the best styles, and no invented one. A request with families is not
    // a first page without wishes.
    let families = &request.within.styles;
    let best = current.is_none() && families.is_empty();
    if wish.invented > 0.0 && !lines_only && random.rand_float() < wish.invented && !best {
        let Some(tried) = &wish.inventions else {
            return Ok(StyleRef::of(&procedural::invent(random.rand_u64() as u32)));
        };
        let fresh: Vec<&StyleRef> =
            tried.iter().filter(|style| !shown(style.id().unwrap_or_default())).collect();
        if !fresh.is_empty() {
            return Ok(fresh[random.rand_range(0..fresh.len() as u64) as usize].clone());
        }
    }
    let is_slow = |style: &Style| wish.quick && style.has_block("painter");
    let colours = if best { FIRST_IN_COLOUR } else { IN_COLOUR };
    let designed = catalogue::catalogue()
        .iter()
        .filter(|style| !lines_only || style.foreground.is_some())
        .filter(|style| !best || tones::is_for_first_page(&style.id))
        .filter(|style| is_within(families, style.tags.first().map_or("", String::as_str)))
        .filter(|style| !families.is_empty() || !tones::is_retired(&style.id))
        .map(|style| {
            let weight = if shown(&style.id) || is_slow(style) {
                0.0
            } else {
                tones::weight(style, page, &request.taste)
            };
            (weight, style.keeps_colours(), StyleRef::from(style.id.as_str()))
        });
    let extra = wish
        .extra
        .iter()
        .filter(|style| {
            !lines_only || style.custom().is_some_and(|file| file.json().get("foreground").is_some())
        })
        .map(|style| {
            let id = style.id().unwrap_or_default();
            let read = style.style();
            let is_slow = read.as_ref().is_ok_and(|style| is_slow(style));
            let weight = if shown(id) || is_slow { 0.0 } else { tones::weight_of_own(id, &request.taste) };
            let keeps_colours = read.is_ok_and(|style| style.keeps_colours());
            (weight, keeps_colours, style.clone())
        });
    let others = shared(designed.chain(extra).collect(), colours);
    let sum: f64 = others.iter().map(|(weight, _)| weight).sum();
    let mut left = random.rand_float() * sum;
    let drawn = others.iter().filter(|(weight, _)| *weight > 0.0).find(|(weight, _)| {
        left -= weight;
        left <= 0.0
    });
    let other = || others.iter().find(|(_, style)| style.built_in().is_none_or(|id| Some(id) != before));
    drawn.or_else(other).map(|(_, style)| style.clone()).ok_or_else(|| Error::UnknownStyle("any".into()))
}

/// Styles with their weights. Styles with the colours of photos get a fixed share of all choices, if there
/// are others.
fn shared(styles: Vec<(f64, bool, StyleRef)>, share: f64) -> Vec<(f64, StyleRef)> {
    let sum =
        |kept: bool| styles.iter().filter(|(_, keeps, _)| *keeps == kept).map(|(weight, ..)| weight).sum();
    let (kept, others): (f64, f64) = (sum(true), sum(false));
    let factor = |keeps: bool| match (kept > 0.0 && others > 0.0, keeps) {
        (false, _) => 1.0,
        (true, true) => share / kept,
        (true, false) => (1.0 - share) / others,
    };
    styles.into_iter().map(|(weight, keeps, style)| (weight * factor(keeps), style)).collect()
}

/// The settings of a page in a style: white paper becomes dark for a dark style, and white again for others.
/// Custom colours do not change.
pub(super) fn papered(page: &PageSettings, style: &StyleRef) -> PageSettings {
    let usual = PageSettings::default();
    let light = (usual.paper.as_str(), usual.border_color.as_str());
    let dark = (DARK_PAPER, DARK_BORDER);
    let mut page = page.clone();
    if [light, dark].contains(&(page.paper.as_str(), page.border_color.as_str())) {
        let is_dark = style.style().is_ok_and(|style| style.dark);
        let (paper, border) = if is_dark { dark } else { light };
        page.paper = paper.into();
        page.border_color = border.into();
    }
    page
}

/// The colours of one style below the lines of another.
fn joined(colours: &Style, lines: &Style) -> StyleRef {
    let mut style = colours.clone();
    style.foreground.clone_from(&lines.foreground);
    style.ink = lines.ink;
    // Joined again and again the names would grow without end.
    let both = |colours: &str, lines: &str, sign: &str| {
        let first = colours.split('+').next().unwrap_or_default().trim();
        let last = lines.rsplit('+').next().unwrap_or_default().trim();
        [first, last].join(sign)
    };
    style.id = both(&colours.id, &lines.id, "+");
    style.name = both(&colours.name, &lines.name, " + ");
    style.score = None;
    StyleRef::of(&style)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::framing::PhotoMeta;
    use crate::page::document::Document;
    use crate::page::request::Styling;
    use crate::page::shuffle::plan;
    use serde_json::Value;
    use std::collections::BTreeSet;

    fn request(seed: u32, styling: Styling) -> Request {
        let photo = |i: u64| PhotoMeta {
            fingerprint: (i + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15),
            ..PhotoMeta::unmeasured(&format!("p{i}"), 3000, 2000)
        };
        Request {
            seed,
            photos: (0..4).map(photo).collect(),
            page: crate::layout::PageSettings::default(),
            styling,
            merge: Some(false),
            ..Request::default()
        }
    }

    fn text(style: &StyleRef) -> String {
        serde_json::to_string(style).unwrap()
    }

    fn parts(style: &StyleRef) -> (Value, Value, Value) {
        let style = style.style().unwrap().to_value();
        (style["background"].clone(), style["foreground"].clone(), style["ink"].clone())
    }

    #[test]
    fn quick_shuffles_have_no_painters() {
        let painter = Style::parse("own.json", r#"{"background":[{"block":"painter"}]}"#).unwrap();
        let first = plan(&request(0, Styling::default())).unwrap();
        let painted = |quick: bool| {
            let styling = Styling { extra: vec![StyleRef::of(&painter)], quick, ..Styling::default() };
            let shuffle = |seed| {
                let current = Some(first.clone());
                plan(&Request { current, ..request(seed, styling.clone()) }).unwrap().style
            };
            (0..100).filter(|&seed| shuffle(seed).style().unwrap().has_block("painter")).count()
        };
        assert!(painted(false) > 0);
        assert_eq!(painted(true), 0);
    }

    #[test]
    fn own_styles_come_as_often_as_others_and_invented_ones_by_their_share() {
        let own = StyleRef::of(&procedural::invent(7));
        let styling = |invented| Styling { extra: vec![own.clone()], invented, ..Styling::default() };
        let first = plan(&request(3, styling(1.0))).unwrap();
        assert!(first.style.built_in().is_some(), "a first page has no invented style");
        let drawn = |invented: f64| -> Vec<StyleRef> {
            let shuffle = |seed| Request { current: Some(first.clone()), ..request(seed, styling(invented)) };
            (0..400).map(|seed| plan(&shuffle(seed)).unwrap().style).collect()
        };
        let all: BTreeSet<String> = drawn(0.0).iter().map(text).collect();
        assert!(all.contains(&text(&own)));
        assert!(all.len() <= catalogue::catalogue().len() + 1);
        let invented = drawn(0.5).iter().filter(|style| style.custom().is_some() && **style != own).count();
        assert!((150..250).contains(&invented), "{invented} of 400");
        assert!(drawn(1.0).iter().all(|style| style.custom().is_some()));
    }

    #[test]
    fn half_of_the_shuffles_and_most_first_pages_keep_the_colours() {
        let first = plan(&request(3, Styling::default())).unwrap();
        let share = |current: Option<&Document>| {
            let kept = (0..400).filter(|&seed| {
                let request = Request { current: current.cloned(), ..request(seed, Styling::default()) };
                plan(&request).unwrap().style().unwrap().keeps_colours()
            });
            kept.count() as f64 / 400.0
        };
        let (shuffled, first) = (share(Some(&first)), share(None));
        assert!((0.43..0.57).contains(&shuffled) && (0.94..0.995).contains(&first), "{shuffled} {first}");
    }

    #[test]
    fn chance_draws_no_style_with_a_low_mark_unless_its_family_is_asked_for() {
        let first = plan(&request(3, Styling::default())).unwrap();
        let mut request = Request { current: Some(first), ..request(0, Styling::default()) };
        let mut drawn = |families: &[&str]| -> Vec<String> {
            request.within.styles = families.iter().map(|&family| family.to_owned()).collect();
            let styles = (0..300).map(|seed| plan(&Request { seed, ..request.clone() }).unwrap().style);
            styles.map(|style| style.id().unwrap().to_owned()).collect()
        };
        assert!(drawn(&[]).iter().all(|id| !tones::is_retired(id)));
        assert!(drawn(&["blueprint"]).iter().any(|id| tones::is_retired(id)));
    }

    #[test]
    fn dark_styles_get_dark_paper_unless_a_person_chose_another() {
        let drawn = |style: StyleRef, page: &PageSettings| {
            let request =
                Request { style: Some(style), page: page.clone(), ..request(1, Styling::default()) };
            plan(&request).unwrap().page
        };
        let white = PageSettings::default();
        let own = PageSettings { paper: "#f4efe6".into(), ..PageSettings::default() };
        let dark = drawn("moonlight".into(), &white);
        assert_eq!(dark.paper, DARK_PAPER);
        assert_eq!(drawn("moonlight".into(), &own), own);
        assert_eq!(
            [drawn("comic".into(), &white), drawn("comic".into(), &dark)],
            [white.clone(), white.clone()]
        );
        let moonlight = StyleRef::from("moonlight");
        let copy = Style { id: "mine".into(), ..moonlight.style().unwrap().into_owned() };
        assert_eq!(drawn(StyleRef::of(&copy), &white), dark);
        assert_eq!(drawn(StyleRef::of(&Style { dark: false, ..copy }), &dark), white);
    }

    #[test]
    fn families_that_are_asked_for_are_kept_to() {
        for family in ["ink", "watercolour"] {
            for seed in 0..40 {
                let mut asked = request(seed, Styling::default());
                asked.within.styles = vec![family.to_owned()];
                let style = plan(&asked).unwrap().style;
                assert_eq!(style.style().unwrap().tags[0], family);
            }
        }
        let mut none = request(1, Styling::default());
        none.within.styles = vec!["nothing of the kind".to_owned()];
        assert!(plan(&none).is_err());
    }

    #[test]
    fn where_styles_were_tried_only_these_are_drawn_as_inventions() {
        let tried: Vec<StyleRef> = (1..4).map(|seed| StyleRef::of(&procedural::invent(seed))).collect();
        let styling = |inventions: &[StyleRef]| Styling {
            invented: 0.5,
            inventions: Some(inventions.to_vec()),
            ..Styling::default()
        };
        let first = plan(&request(3, Styling::default())).unwrap();
        let drawn = |inventions: &[StyleRef]| -> Vec<StyleRef> {
            let shuffle =
                |seed| Request { current: Some(first.clone()), ..request(seed, styling(inventions)) };
            (0..200).map(|seed| plan(&shuffle(seed)).unwrap().style).collect()
        };
        assert!(drawn(&[]).iter().all(|style| style.built_in().is_some()));
        let invented: Vec<StyleRef> =
            drawn(&tried).into_iter().filter(|style| style.custom().is_some()).collect();
        assert!((70..130).contains(&invented.len()), "{} of 200", invented.len());
        assert!(tried.iter().all(|style| invented.contains(style)));
        assert!(invented.iter().all(|style| tried.contains(style)));
    }

    #[test]
    fn each_layer_is_locked_alone() {
        let current = plan(&request(3, Styling::default())).unwrap();
        let mut looks = BTreeSet::new();
        for seed in 0..60 {
            for (keep_lines, keep_colours) in [(true, false), (false, true), (true, true)] {
                let styling = Styling { keep_lines, keep_colours, invented: 0.3, ..Styling::default() };
                let mut next = request(seed, styling);
                next.current = Some(current.clone());
                let style = plan(&next).unwrap().style;
                let (now, before) = (parts(&style), parts(&current.style));
                assert!(!keep_colours || now.0 == before.0);
                assert!(!keep_lines || (&now.1, &now.2) == (&before.1, &before.2));
                looks.insert(text(&style));
            }
        }
        assert!(looks.len() > 20, "{} looks", looks.len());
    }

    #[test]
    fn a_broken_style_of_ones_own_is_an_error() {
        let broken = serde_json::json!({ "id": "x", "background": [{ "block": "nope" }] });
        let extra: Vec<StyleRef> = vec![serde_json::from_value(broken).unwrap()];
        // First pages hardly ever have a style without the colours of the photos.
        let first = plan(&request(3, Styling::default())).unwrap();
        let broken = (0..200).find_map(|seed| {
            let styling = Styling { extra: extra.clone(), ..Styling::default() };
            plan(&Request { current: Some(first.clone()), ..request(seed, styling) }).err()
        });
        assert_eq!(broken.unwrap().code(), "invalid-style");
    }
}
