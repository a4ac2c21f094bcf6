//! Describes the content of panels in English, from the subjects of their photos. The app has its own
//! descriptions, in the user's language.

use crate::framing::{Crop, Subject};
use crate::page::Document;
use std::collections::HashMap;

/// Minimum detection score. Lower scores are often wrong.
const SURE: f64 = 0.5;
/// The most kinds of things that are named.
const MOST: usize = 4;
/// Numbers as words.
const NUMBERS: [&str; 13] =
    ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"];

/// Description of each panel of a page, in paint order. Empty without subjects. `subjects` returns the
/// subjects of a photo id.
#[must_use]
pub fn described<'s>(document: &Document, subjects: impl Fn(&str) -> &'s [Subject]) -> Vec<String> {
    (0..document.panels.len())
        .map(|i| {
            // Panels that are merged show one photo together.
            let leader = document.merge_of(i).and_then(|group| group.first().copied()).unwrap_or(i);
            let panel = &document.panels[leader.min(document.panels.len() - 1)];
            let found = panel.photo.as_deref().map_or(&[][..], &subjects);
            seen(found, panel.crop)
        })
        .collect()
}

/// Description of the visible subjects, people first, then by size: `two people and a dog`.
fn seen(subjects: &[Subject], crop: Option<Crop>) -> String {
    let mut kinds: HashMap<&str, (usize, f64)> = HashMap::new();
    for subject in subjects.iter().filter(|subject| subject.score >= SURE && holds(crop, subject)) {
        let kind = kinds.entry(&subject.label).or_default();
        *kind = (kind.0 + 1, kind.1 + subject.width * subject.height);
    }
    // A detector may find the whole person, the face, or both.
    let people = ["person", "face"].map(|label| kinds.remove(label).map_or(0, |(count, _)| count));
    let people = people[0].max(people[1]);
    let mut things: Vec<(&str, (usize, f64))> = kinds.into_iter().collect();
    things.sort_by(|(a, (_, large)), (b, (_, larger))| larger.total_cmp(large).then(a.cmp(b)));
    let things = things.into_iter().map(|(label, (count, _))| (label, count));
    let people = (people > 0).then_some(("person", people));
    let all: Vec<String> = people.into_iter().chain(things).take(MOST).map(counted).collect();
    match &all[..] {
        [] => String::new(),
        [one] => one.clone(),
        [one, other] => format!("{one} and {other}"),
        [most @ .., last] => format!("{}, and {last}", most.join(", ")),
    }
}

/// Whether the middle of a subject is in view.
fn holds(crop: Option<Crop>, subject: &Subject) -> bool {
    let Some(crop) = crop else { return true };
    let u = (subject.x + subject.width / 2.0 - crop.x) / crop.width;
    let v = (subject.y + subject.height / 2.0 - crop.y) / crop.height;
    (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v)
}

/// `a dog`, `two dogs`, `13 dogs`.
fn counted((label, count): (&str, usize)) -> String {
    if count == 1 {
        return match label {
            "skis" | "scissors" => format!("a pair of {label}"),
            "broccoli" | "lettering" => label.to_owned(),
            "mouse" => "a computer mouse".to_owned(),
            "tv" => "a television".to_owned(),
            "remote" => "a remote control".to_owned(),
            _ if label.starts_with(['a', 'e', 'i', 'o', 'u']) => format!("an {label}"),
            _ => format!("a {label}"),
        };
    }
    let many = match label {
        "person" => "people".to_owned(),
        "sheep" => label.to_owned(),
        "knife" => "knives".to_owned(),
        "skis" | "scissors" => format!("pairs of {label}"),
        "broccoli" => "heads of broccoli".to_owned(),
        "lettering" => "lines of lettering".to_owned(),
        "mouse" => "computer mice".to_owned(),
        _ if label.ends_with(['s', 'x']) || label.ends_with("ch") || label.ends_with("sh") => {
            format!("{label}es")
        }
        _ => format!("{label}s"),
    };
    NUMBERS.get(count).map_or_else(|| format!("{count} {many}"), |number| format!("{number} {many}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn subject(label: &str, x: f64, width: f64, score: f64) -> Subject {
        Subject {
            x,
            y: 0.4,
            width,
            height: 0.2,
            label: label.to_owned(),
            score,
            points: None,
            expression: None,
            light: None,
        }
    }

    #[test]
    fn what_is_seen_is_counted() {
        let mut all = vec![
            subject("face", 0.1, 0.1, 0.9),
            subject("person", 0.1, 0.1, 0.9),
            subject("face", 0.3, 0.1, 0.9),
            subject("elephant", 0.5, 0.3, 0.8),
            subject("cat", 0.5, 0.1, 0.3),
        ];
        assert_eq!(seen(&all, None), "two people and an elephant");
        let left = Crop { x: 0.0, y: 0.0, width: 0.25, height: 1.0 };
        assert_eq!(seen(&all, Some(left)), "a person");
        all.extend((0..13).map(|_| subject("knife", 0.9, 0.02, 0.9)));
        assert_eq!(seen(&all, None), "two people, an elephant, and 13 knives");
        assert_eq!(seen(&[], None), "");
    }
}
