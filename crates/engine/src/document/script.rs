//! Scripts: one line `NAME: dialogue` per speech, and an empty line or a heading such as `Panel 3` between panels.

use super::limits::MOST_WAITING;
use super::speech::{self, Manner, Said, Taking, laid, named};
use super::text_lines::{lines, trimmed};
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
/// Words that begin the heading of a page. No text item is made of a heading.
const PAGES: [&str; 5] = ["PAGE", "SEITE", "PÁGINA", "PLANCHE", "ページ"];
/// Words that begin the heading of a panel.
const PANELS: [&str; 7] = ["PANEL", "BILD", "VIÑETA", "CASE", "QUADRO", "VINHETA", "コマ"];
/// Words that begin the heading of a scene.
const SCENES: [&str; 1] = ["SCENE"];
/// Manner of speech, by the beginning of a word in round brackets after the name.
const MANNERS: [(Manner, &[&str]); 3] = [
    (Manner::Thought, &["think", "thought", "denk", "piens", "pens", "心"]),
    (Manner::Whisper, &["whisper", "flüster", "susurr", "chuchot", "sussurr", "ささや", "小声"]),
    (Manner::Shout, &["shout", "yell", "scream", "cri", "ruf", "schrei", "grit", "叫"]),
];

/// A paragraph of a script.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Paragraph {
    /// Speeches in order.
    pub said: Vec<Said>,
    /// Number of panels before the panel of its heading, on all pages of the script. `None` without a numbered heading.
    pub panel: Option<usize>,
    /// The same number of the first numbered heading after it.
    pub next: Option<usize>,
}

/// Paragraphs of a script, each with its speeches.
#[must_use]
pub fn read(text: &str) -> Vec<Paragraph> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let lines: Vec<&str> = lines(text).into_iter().map(trimmed).collect();
    let has_names = lines.iter().any(|line| heading(line).is_none() && voice(line).is_some());
    let mut paragraphs = vec![Paragraph::default()];
    let mut numbers = Numbers::default();
    for line in lines {
        let heading = heading(line);
        let follows = paragraphs.last().is_some_and(|last| !last.said.is_empty());
        if follows && (line.is_empty() || heading.is_some()) {
            paragraphs.push(Paragraph::default());
        }
        let mut line = line;
        if let (Some(heading), Some(paragraph)) = (heading, paragraphs.last_mut()) {
            line = if has_names { "" } else { heading.rest };
            let place = numbers.place(&heading);
            paragraph.panel = place;
            let earlier = paragraphs.iter_mut().rev().filter(|before| !before.said.is_empty());
            for before in earlier.take_while(|before| place.is_some() && before.next.is_none()) {
                before.next = place;
            }
        }
        if line.is_empty() {
            continue;
        }
        let Some(Paragraph { said: group, .. }) = paragraphs.last_mut() else { continue };
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
    for paragraph in &mut paragraphs {
        for said in &mut paragraph.said {
            said.text = trimmed(&said.text).to_owned();
        }
        paragraph.said.retain(|said| !said.text.is_empty());
    }
    paragraphs.retain(|paragraph| !paragraph.said.is_empty());
    paragraphs
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

/// A line such as `PAGE 2, PANEL 3` or `Panel 3: Run!`.
struct Heading<'a> {
    /// Whether it begins a page.
    page: bool,
    /// Number of the panel on its page, from 1.
    panel: Option<usize>,
    /// Text after the colon.
    rest: &'a str,
}

/// Returns `None` for a line of dialogue.
fn heading(line: &str) -> Option<Heading<'_>> {
    let (front, rest) = line.split_once([':', '：']).unwrap_or((line, ""));
    let loud = front.to_uppercase();
    let starts = |words: &[&str]| words.iter().any(|word| number_after(&loud, word, true).is_some());
    let page = starts(&PAGES);
    if !page && !starts(&PANELS) && !starts(&SCENES) {
        return None;
    }
    // A sentence such as `Page 3 of my diary is missing` is dialogue.
    if front.chars().filter(|letter| letter.is_alphabetic()).count() > 15 {
        return None;
    }
    let panel = PANELS.iter().find_map(|word| number_after(&loud, word, false)).filter(|&number| number > 0);
    Some(Heading { page, panel, rest: trimmed(rest) })
}

/// Returns the number after a word. `start`: the word must be at the start of the line.
fn number_after(line: &str, word: &str, start: bool) -> Option<usize> {
    let after = if start { line.strip_prefix(word)? } else { &line[line.find(word)? + word.len()..] };
    let after = after.trim_start();
    let end = after.find(|letter: char| !letter.is_numeric()).unwrap_or(after.len());
    // Digits of other scripts count as a number without a value.
    (end > 0).then(|| after[..end].parse::<u16>().map_or(0, usize::from))
}

/// The numbering of panels in the headings of a script, which begins again on each page.
#[derive(Default)]
struct Numbers {
    /// Panels of the pages before.
    before: usize,
    /// Panels up to the greatest number so far.
    end: usize,
    /// The number of the heading before, on the same page.
    last: usize,
    /// Whether headings of pages were found. Otherwise, a page begins with its first panel.
    paged: bool,
}

impl Numbers {
    /// Returns the number of panels before the panel of a heading, over all pages.
    fn place(&mut self, heading: &Heading<'_>) -> Option<usize> {
        self.paged |= heading.page;
        let begins = heading.panel == Some(1) && self.last > 1 && !self.paged;
        if heading.page || begins {
            self.before = self.end;
            self.last = 0;
        }
        let number = heading.panel?;
        self.last = number;
        self.end = self.end.max(self.before + number);
        Some(self.before + number - 1)
    }
}

/// Lays the paragraphs of a script over panels in order. Returns JSON, `{words, unplaced, lines}`: the text
/// items, the number of text items without a panel, and the number of lines that were read. A paragraph below the heading
/// `Panel 3` goes to panel 3. See `placed` for a script without numbers.
#[must_use]
pub fn told(text: &str, panels: usize, taking: Taking) -> String {
    let text = text.char_indices().nth(MOST_SCRIPT).map_or(text, |(end, _)| &text[..end]);
    let paragraphs = read(text);
    let lines = paragraphs.iter().map(|paragraph| paragraph.said.len()).sum::<usize>();
    let placed = if paragraphs.iter().any(|paragraph| paragraph.panel.is_some()) {
        let places = numbered(&paragraphs);
        let groups = paragraphs.iter().map(|paragraph| texts(&paragraph.said, taking));
        set(groups.zip(places), (panels, MOST_OF_PANEL))
    } else {
        let groups: Vec<Vec<Said>> = paragraphs.into_iter().map(|paragraph| paragraph.said).collect();
        placed(&groups, (panels, MOST_OF_PANEL), taking)
    };
    let mut out = Writer::default();
    out.open(b'{');
    placed.write(&mut out);
    out.key("lines").whole(lines as u64);
    out.close(b'}');
    out.finish()
}

/// Returns the panel of each paragraph. One without a number goes to the panel after the paragraph before, but
/// not as far as the next number.
fn numbered(paragraphs: &[Paragraph]) -> Vec<usize> {
    let mut next = 0_usize;
    let place = |paragraph: &Paragraph| {
        let last = paragraph.next.map_or(usize::MAX, |next| next.saturating_sub(1));
        let place = paragraph.panel.unwrap_or(next.min(last.max(next.saturating_sub(1))));
        next = place + 1;
        place
    };
    paragraphs.iter().map(place).collect()
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
/// evenly. A single group is laid out line by line.
pub(super) fn placed(groups: &[Vec<Said>], (panels, most): (usize, usize), taking: Taking) -> Placed {
    let alone: Vec<&[Said]> = match groups {
        [one] => one.chunks(1).collect(),
        _ => groups.iter().map(Vec::as_slice).collect(),
    };
    let groups: Vec<Vec<NewText>> =
        alone.into_iter().map(|group| texts(group, taking)).filter(|words| !words.is_empty()).collect();
    let places = if panels == 0 { Vec::new() } else { laid(groups.len(), panels) };
    set(groups.into_iter().zip(places), (panels, most))
}

/// The text items of a group of speech.
fn texts(group: &[Said], taking: Taking) -> Vec<NewText> {
    // Sounds with a name are never dropped.
    let taking = |said: &Said| Taking { sounds: taking.sounds || said.speaker.is_some(), ..taking };
    group.iter().flat_map(|said| speech::words(said, taking(said))).collect()
}

/// Puts each group on its panel. A panel takes its groups until one does not fit; only a group that is larger than the
/// panel is split. Groups of panels that do not exist are unplaced.
fn set(groups: impl Iterator<Item = (Vec<NewText>, usize)>, (panels, most): (usize, usize)) -> Placed {
    let mut all = Placed::default();
    if panels == 0 {
        return all;
    }
    let mut room = vec![most; panels];
    for (words, place) in groups {
        let mut none = 0;
        let room = room.get_mut(place).unwrap_or(&mut none);
        if words.len() > *room && *room < most {
            *room = 0;
        }
        for mut word in words {
            if *room > 0 {
                *room -= 1;
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
    fn a_numbered_heading_is_the_panel_of_its_paragraphs() {
        let places = |text: &str, panels| -> Vec<(String, Option<u64>)> {
            let told: Value = serde_json::from_str(&told(text, panels, TAKING)).unwrap();
            let word = |word: &Value| (word["text"].as_str().unwrap().to_owned(), word["place"].as_u64());
            told["words"].as_array().unwrap().iter().map(word).collect()
        };
        let at = |text: &str, place| (text.to_owned(), place);
        assert_eq!(places("PANEL 3\nAnna: Hi", 6), [at("Hi", Some(2))]);
        assert_eq!(places("Panel 2: Run!\nPanel 5: Stop!", 6), [at("Run!", Some(1)), at("Stop!", Some(4))]);
        // Silent panels are panels, and paragraphs of one panel stay on it.
        let script = "Panel 1\n\nA: One\n\nB: Two\n\nPanel 2\nPanel 3\nA: Three\n\nA: Four\nPanel 6\nA: Six";
        let expected = [("One", 0), ("Two", 0), ("Three", 2), ("Four", 3), ("Six", 5)]
            .map(|(text, place)| at(text, Some(place)));
        assert_eq!(places(script, 6), expected);
        // The next page continues after the last panel of the page before.
        let pages =
            "PAGE 1\nPanel 1\nA: One\nPanel 4\nPAGE 2, PANEL 2\nA: Six\nPanel 1\nA: Five\nBILD 9\nA: Gone";
        let expected = [("One", Some(0)), ("Six", Some(5)), ("Five", Some(4)), ("Gone", None)];
        assert_eq!(places(pages, 8), expected.map(|(text, place)| at(text, place)));
        assert_eq!(places("A: First\nPanel 1\nA: Second", 3), [at("First", Some(0)), at("Second", Some(0))]);
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
