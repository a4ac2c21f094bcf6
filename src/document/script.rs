//! Scripts: one line `NAME: dialogue` per speech, and an empty line between panels.

use super::limits::MOST_WAITING;
use super::speech::{self, Manner, Said, Taking, laid, named};
use super::subtitles::{lines, trimmed};
use crate::json::Writer;
use crate::page::words::model::NewText;

/// Most characters of a script: a book of comics has fewer.
pub const MOST_SCRIPT: usize = 200_000;

/// Maximum number of text items that a script puts on one panel.
pub const MOST_OF_PANEL: usize = 6;

/// Names of the narrator in the languages of the app, without accents.
const NARRATORS: [&str; 14] = [
    "CAPTION",
    "CAP",
    "NARRATOR",
    "NARRATION",
    "TITLE",
    "ERZÄHLER",
    "ERZÄHLERIN",
    "TEXT",
    "NARRADOR",
    "NARRADORA",
    "NARRATEUR",
    "RÉCITATIF",
    "LEGENDA",
    "ナレーション",
];
/// Names that mark a sound.
const SOUNDS: [&str; 10] =
    ["SFX", "SOUND", "SOUND EFFECT", "GERÄUSCH", "SONIDO", "BRUIT", "SOM", "EFECTO", "EFFET", "効果音"];
/// Words that begin the heading of a page or a panel. Headings are skipped.
const HEADINGS: [&str; 13] = [
    "PAGE",
    "PANEL",
    "SCENE",
    "SEITE",
    "BILD",
    "PÁGINA",
    "VIÑETA",
    "PLANCHE",
    "CASE",
    "QUADRO",
    "VINHETA",
    "ページ",
    "コマ",
];
/// Manner of speech, by the beginning of a word in round brackets after the name.
const MANNERS: [(Manner, &[&str]); 3] = [
    (Manner::Thought, &["think", "thought", "denk", "piens", "pens", "心"]),
    (Manner::Whisper, &["whisper", "flüster", "susurr", "chuchot", "sussurr", "ささや", "小声"]),
    (Manner::Shout, &["shout", "yell", "scream", "cri", "ruf", "schrei", "grit", "叫"]),
];

/// Paragraphs of a script, each with its speeches.
#[must_use]
pub fn read(text: &str) -> Vec<Vec<Said>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let lines: Vec<&str> = lines(text).into_iter().map(trimmed).collect();
    let has_names = lines.iter().any(|line| voice(line).is_some());
    let mut groups: Vec<Vec<Said>> = vec![Vec::new()];
    for line in lines {
        if line.is_empty() || is_heading(line) {
            groups.push(Vec::new());
            continue;
        }
        let Some(group) = groups.last_mut() else { continue };
        match voice(line) {
            Some(said) => group.push(said),
            // In scripts with names, a line without a name continues the speech before.
            None => match group.last_mut().filter(|_| has_names) {
                Some(last) => {
                    last.text.push(' ');
                    last.text.push_str(line);
                }
                None if has_names => {
                    group.push(Said { manner: Manner::Told, text: line.to_owned(), ..Said::default() });
                }
                None => group.append(&mut speech::of_lines(std::iter::once(line))),
            },
        }
    }
    for said in groups.iter_mut().flatten() {
        said.text = trimmed(&said.text).to_owned();
    }
    for group in &mut groups {
        group.retain(|said| !said.text.is_empty());
    }
    groups.retain(|group| !group.is_empty());
    groups
}

/// Speaker, manner and text of a line. `None` without a name.
fn voice(line: &str) -> Option<Said> {
    let (front, back) = line.split_at(line.find([':', '：'])?);
    let (name, how) = match front.split_once(['(', '（']) {
        Some((name, how)) => (trimmed(name), how.trim_end_matches([')', '）', ' '])),
        None => (trimmed(front), ""),
    };
    let colon = format!("{name}{back}");
    let (_, text) = named(&colon, false)?;
    let loud = name.to_uppercase();
    let how = how.to_lowercase();
    let manner = if NARRATORS.contains(&loud.as_str()) {
        Manner::Told
    } else if SOUNDS.contains(&loud.as_str()) {
        Manner::Sound
    } else {
        let said = |starts: &[&str]| {
            how.split([' ', ',']).any(|word| starts.iter().any(|start| word.starts_with(start)))
        };
        MANNERS.iter().find(|(_, starts)| said(starts)).map_or(Manner::Said, |(manner, _)| *manner)
    };
    Some(Said { manner, speaker: Some(name.to_owned()), text: text.to_owned(), turn: false })
}

/// `PAGE 2, PANEL 3`, with or without a colon.
fn is_heading(line: &str) -> bool {
    let loud = line.to_uppercase();
    let Some(rest) = HEADINGS.iter().find_map(|word| loud.strip_prefix(word)) else { return false };
    let rest = rest.trim_start();
    rest.starts_with(|letter: char| letter.is_numeric())
        && rest.chars().filter(|letter| letter.is_alphabetic()).count() <= 10
}

/// Lays the paragraphs of a script over panels in order. Returns JSON, `{words, unplaced, lines}`: the text
/// items, the number of text items without a panel, and the number of lines that were read. See [`placed`].
#[must_use]
pub fn told(text: &str, panels: usize, taking: Taking) -> String {
    let text = text.char_indices().nth(MOST_SCRIPT).map_or(text, |(end, _)| &text[..end]);
    let groups = read(text);
    let placed = placed(&groups, (panels, MOST_OF_PANEL), taking);
    let mut out = Writer::default();
    out.open(b'{');
    placed.write(&mut out);
    out.key("lines").whole(groups.iter().map(Vec::len).sum::<usize>() as u64);
    out.close(b'}');
    out.finish()
}

/// Text items laid over panels.
#[derive(Debug, Default)]
pub(super) struct Placed {
    /// Text items in order, each with its `place` among the panels. Those without a place are unplaced, at most
    /// [`MOST_WAITING`] of them.
    pub(super) words: Vec<NewText>,
    /// Number of unplaced text items, including items that are not in `words`.
    pub(super) unplaced: usize,
}

impl Placed {
    /// Writes the fields `words` and `unplaced`.
    pub(super) fn write(&self, out: &mut Writer) {
        out.key("words").list(&self.words, &|out, word| out.put(word));
        out.key("unplaced").whole(self.unplaced as u64);
    }
}

/// Lays groups of speech over `panels` in order, with at most `most` text items on each panel. All panels share the groups
/// evenly. A panel takes its groups until one does not fit; only a group that is larger than the panel is split.
/// A single group is laid out line by line.
pub(super) fn placed(groups: &[Vec<Said>], (panels, most): (usize, usize), taking: Taking) -> Placed {
    // Sounds with a name are never dropped.
    let taking = |said: &Said| Taking { sounds: taking.sounds || said.speaker.is_some(), ..taking };
    let alone: Vec<&[Said]> = match groups {
        [one] => one.chunks(1).collect(),
        _ => groups.iter().map(Vec::as_slice).collect(),
    };
    let groups: Vec<Vec<NewText>> = alone
        .into_iter()
        .map(|group| group.iter().flat_map(|said| speech::words(said, taking(said))).collect())
        .filter(|words: &Vec<NewText>| !words.is_empty())
        .collect();
    let mut all = Placed::default();
    if panels == 0 {
        return all;
    }
    let places = laid(groups.len(), panels);
    let mut room = vec![most; panels];
    for (words, place) in groups.into_iter().zip(places) {
        if words.len() > room[place] && room[place] < most {
            room[place] = 0;
        }
        for mut word in words {
            if room[place] > 0 {
                room[place] -= 1;
                word.place = Some(place);
            } else {
                all.unplaced += 1;
                if all.unplaced > MOST_WAITING {
                    continue;
                }
            }
            all.words.push(word);
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::words::TextKind;
    use proptest::prelude::*;
    use serde_json::{Value, json};

    const TAKING: Taking = Taking { kind: TextKind::Balloon, sounds: false };

    fn words(text: &str, panels: usize) -> Vec<(String, String, u64)> {
        let told: Value = serde_json::from_str(&told(text, panels, TAKING)).unwrap();
        let word = |word: &Value| {
            let kind = word["shape"].as_str().or(word["kind"].as_str()).unwrap();
            (kind.to_owned(), word["text"].as_str().unwrap().to_owned(), word["place"].as_u64().unwrap())
        };
        told["words"].as_array().unwrap().iter().map(word).collect()
    }

    fn word(kind: &str, text: &str, place: u64) -> (String, String, u64) {
        (kind.to_owned(), text.to_owned(), place)
    }

    #[test]
    fn a_script_is_laid_over_panels_paragraph_by_paragraph() {
        let script = "PAGE 1, PANEL 1\nCaption: Lisbon, in summer.\nAnna: Where are we?\nBen (whispering): Nearly\nthere.\n\nPanel 2:\nANNA (thinks): Hm.\nSFX: Bam\n\nBen： Run!";
        assert_eq!(
            words(script, 6),
            [
                word("caption", "Lisbon, in summer.", 0),
                word("balloon", "Where are we?", 0),
                word("whisper", "Nearly there.", 0),
                word("thought", "Hm.", 1),
                word("effect", "BAM", 1),
                word("balloon", "Run!", 2),
            ]
        );
    }

    #[test]
    fn one_paragraph_is_laid_line_by_line_and_more_lines_than_panels_stand_close() {
        assert_eq!(words("A: One\nB: Two", 4), [word("balloon", "One", 0), word("balloon", "Two", 1)]);
        let places: Vec<u64> = words("One\nTwo\nThree\nFour", 2).into_iter().map(|word| word.2).collect();
        assert_eq!(places, [0, 0, 1, 1]);
        assert!(words("A: One", 0).is_empty() && words(" \n\n", 3).is_empty());
    }

    #[test]
    fn a_panel_takes_no_more_than_it_holds_and_the_rest_is_unplaced() {
        let script = |lines: usize| vec!["Line"; lines].join("\n\n");
        let read =
            |lines, panels| -> Value { serde_json::from_str(&told(&script(lines), panels, TAKING)).unwrap() };
        let count = |read: &Value, place: Option<u64>| {
            read["words"].as_array().unwrap().iter().filter(|word| word["place"].as_u64() == place).count()
        };
        let film = read(1332, 4);
        assert!((0..4).all(|place| count(&film, Some(place)) == MOST_OF_PANEL));
        assert_eq!(count(&film, None), 1332 - 4 * MOST_OF_PANEL);
        assert_eq!(film["unplaced"], 1332 - 4 * MOST_OF_PANEL);
        let long = read(5000, 2);
        assert_eq!((count(&long, None), &long["unplaced"]), (MOST_WAITING, &json!(5000 - 2 * MOST_OF_PANEL)));
        assert_eq!(read(12, 2)["unplaced"], 0);
        // Lines of one group stay together where they fit.
        let said = |text: &str| Said { text: text.into(), ..Said::default() };
        let groups = [vec![said("a"), said("b")], vec![said("c"), said("d")], vec![said("e")]];
        let placed = placed(&groups, (1, 3), TAKING);
        let texts: Vec<_> = placed
            .words
            .iter()
            .filter(|word| word.place == Some(0))
            .map(|word| word.item.text.as_str())
            .collect();
        assert_eq!((json!(texts), placed.unplaced), (json!(["a", "b"]), 3));
    }

    proptest! {
        #[test]
        fn cues_are_spread_over_all_panels_in_order_up_to_a_limit(
            count in 1_usize..=5000,
            panels in 1_usize..=12,
            most in 1_usize..=MOST_OF_PANEL,
        ) {
            let cue = |i: usize| vec![Said { text: i.to_string(), ..Said::default() }];
            let groups: Vec<_> = (0..count).map(cue).collect();
            let Placed { words, unplaced } = placed(&groups, (panels, most), TAKING);
            let number = |word: &NewText| word.item.text.parse::<usize>().unwrap();
            prop_assert!(words.is_sorted_by_key(number));
            let shown: Vec<usize> =
                words.iter().filter_map(|word| word.place).collect();
            prop_assert!(shown.is_sorted());
            let waiting = words.len() - shown.len();
            prop_assert_eq!(waiting, unplaced.min(MOST_WAITING));
            prop_assert_eq!(shown.len() + waiting + (unplaced - waiting), count);
            let mut counts = vec![0; panels];
            for place in shown {
                counts[place] += 1;
            }
            prop_assert!(counts.iter().all(|&count| count <= most));
            if count <= panels * most {
                prop_assert_eq!(unplaced, 0);
                let (least, greatest) = (counts.iter().min().unwrap(), counts.iter().max().unwrap());
                prop_assert!(greatest - least <= 1, "{counts:?}");
            } else {
                prop_assert!(counts.iter().all(|&count| count >= 1), "{counts:?}");
            }
        }

        #[test]
        fn any_text_is_a_script(text in "[\\PC\n:()]{0,200}", panels in 0_usize..9) {
            let told: Value = serde_json::from_str(&told(&text, panels, TAKING)).unwrap();
            for word in told["words"].as_array().unwrap() {
                prop_assert!(word["place"].as_u64().is_none_or(|place| place < panels as u64));
                prop_assert!(!word["text"].as_str().unwrap().is_empty());
            }
        }
    }
}
