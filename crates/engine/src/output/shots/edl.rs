//! An edit decision list, CMX 3600. Each shot is a cut on the one video track, with the timecodes of its
//! source and of the programme. The programme begins at one hour. Title, source file and shot fields are
//! comments. Each video has a reel. Each photo with another file name has a separate reel as well.

use super::{Cut, ShotList, line};
use std::collections::HashMap;
use std::fmt::Write as _;

/// Reel name of material without a reel, and of black.
const AUXILIARY: &str = "AX";
const BLACK: &str = "BL";
/// Characters of the name of a reel.
const REEL: usize = 8;

pub(super) fn write(list: &ShotList) -> String {
    let rate = list.rate();
    let mut out = String::new();
    let title = line(&list.title);
    let count = if rate.drops() { "DROP FRAME" } else { "NON-DROP FRAME" };
    // Writing into text never fails.
    let _ = write!(out, "TITLE: {}\nFCM: {count}\n", if title.is_empty() { "Untitled" } else { &title });
    let mut reels = Reels::default();
    for (i, cut) in list.cuts().iter().enumerate() {
        let Cut { shot, source, start, frames, at, .. } = cut;
        let still = shot.film.is_none() && source.namesake == 1;
        let reel = if still { AUXILIARY } else { reels.of(source.first, cut.file()) };
        let record = rate.programme() + at;
        let [from, to] = [*start, start + frames].map(|frame| cut.timecode(frame));
        let [begin, end] = [record, record + frames].map(|frame| rate.timecode(frame));
        let _ = write!(out, "\n{:03}  {reel:<8} V     C        {from} {to} {begin} {end}\n", i + 1);
        for (what, text) in [
            ("FROM CLIP NAME", cut.file()),
            ("COMMENT: SCENE", &shot.scene),
            ("COMMENT: SHOT", &shot.number),
            ("COMMENT: ACTION", &shot.action),
            ("COMMENT: DIALOGUE", &shot.dialogue),
            ("COMMENT: CAPTION", &shot.caption),
            ("COMMENT: SOUND", &shot.sound),
            ("COMMENT: NOTES", &shot.notes),
        ] {
            let text = line(text);
            if !text.is_empty() {
                let _ = writeln!(out, "* {what}: {text}");
            }
        }
    }
    out
}

/// Reel names of eight letters and digits, by the index of their source.
#[derive(Default)]
struct Reels(HashMap<usize, String>);

impl Reels {
    fn of(&mut self, source: usize, file: &str) -> &str {
        let reel = self.0.get(&source).cloned().unwrap_or_else(|| self.fresh(file));
        self.0.entry(source).or_insert(reel)
    }

    /// A reel that no other source has.
    fn fresh(&self, file: &str) -> String {
        let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
        let plain = |letter: &char| letter.is_ascii_alphanumeric();
        let short: String = stem.chars().filter(plain).take(REEL).collect::<String>().to_ascii_uppercase();
        let short = if short.is_empty() { "FILM" } else { &short };
        let taken =
            |reel: &str| [AUXILIARY, BLACK].contains(&reel) || self.0.values().any(|other| other == reel);
        let numbered = (2_u64..).map(|count| {
            let digits = count.to_string();
            let kept: String = short.chars().take(REEL.saturating_sub(digits.len())).collect();
            kept + &digits
        });
        let mut names = std::iter::once(short.to_owned()).chain(numbered);
        names.find(|reel| !taken(reel)).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::list;
    use super::*;

    #[test]
    fn a_shot_is_a_cut_with_the_time_codes_of_its_film_and_of_the_programme() {
        let text = write(&list(25));
        assert!(text.starts_with("TITLE: One & two\nFCM: NON-DROP FRAME\n\n001  AX       V     C        00:00:00:00 00:00:01:11 01:00:00:00 01:00:01:11\n* FROM CLIP NAME: 1 ä.jpg\n"), "{text}");
        assert!(text.contains("002  NIGHT    V     C        00:00:12:13 00:00:14:13 01:00:01:11 01:00:03:11\n* FROM CLIP NAME: night.mp4\n* COMMENT: SCENE: 1\n* COMMENT: SHOT: 4A\n* COMMENT: ACTION: She opens \"4A\", the door.\n"), "{text}");
    }

    #[test]
    fn films_of_one_beginning_have_reels_of_their_own() {
        let mut reels = Reels::default();
        let names = ["holidays-1.mp4", "holidays-2.mp4", "夏.mp4", "冬.mp4", "ax.mov", "bl.mov"];
        let mut named: Vec<String> =
            names.iter().enumerate().map(|(source, name)| reels.of(source, name).to_owned()).collect();
        named.push(reels.of(0, names[0]).to_owned());
        // Another file of the same name.
        named.push(reels.of(7, names[0]).to_owned());
        assert_eq!(named, ["HOLIDAYS", "HOLIDAY2", "FILM", "FILM2", "AX2", "BL2", "HOLIDAYS", "HOLIDAY3"]);
    }
}
