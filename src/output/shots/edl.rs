//! An edit decision list, CMX 3600: each shot a cut on the one picture track, with the time codes of its film and those of
//! the programme, which begins at one hour. What it is called and of which file, and what is told of it, are comments.

use super::{Cut, ShotList, line};
use std::collections::HashMap;
use std::fmt::Write as _;

/// What stands for material without a reel.
const AUXILIARY: &str = "AX";
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
    for (i, cut) in list.cuts().enumerate() {
        let Cut { shot, start, frames, at } = &cut;
        let reel = shot.film.as_ref().map_or(AUXILIARY.to_owned(), |film| reels.of(&film.name));
        let record = rate.programme() + at;
        let [from, to, begin, end] =
            [*start, start + frames, record, record + frames].map(|frame| rate.timecode(frame));
        let _ = write!(out, "\n{:03}  {reel:<8} V     C        {from} {to} {begin} {end}\n", i + 1);
        for (what, text) in [
            ("FROM CLIP NAME", cut.file()),
            ("COMMENT: SCENE", &shot.scene),
            ("COMMENT: SHOT", &shot.number),
            ("COMMENT: ACTION", &shot.action),
            ("COMMENT: DIALOGUE", &shot.dialogue),
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

/// Names of reels, of eight letters and digits, one a film.
#[derive(Default)]
struct Reels(HashMap<String, String>);

impl Reels {
    fn of(&mut self, film: &str) -> String {
        if let Some(reel) = self.0.get(film) {
            return reel.clone();
        }
        let stem = film.rsplit_once('.').map_or(film, |(stem, _)| stem);
        let plain = |letter: &char| letter.is_ascii_alphanumeric();
        let short: String = stem.chars().filter(plain).take(REEL).collect::<String>().to_ascii_uppercase();
        let taken = |reel: &String| reel == AUXILIARY || self.0.values().any(|other| other == reel);
        let mut reel = if short.is_empty() { "FILM".to_owned() } else { short.clone() };
        let mut count = 1;
        while taken(&reel) {
            count += 1;
            let digits = count.to_string();
            let kept: String = short.chars().take(REEL.saturating_sub(digits.len())).collect();
            reel = format!("{kept}{digits}");
        }
        self.0.insert(film.to_owned(), reel.clone());
        reel
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
        let names = ["holidays-1.mp4", "holidays-2.mp4", "夏.mp4", "冬.mp4", "ax.mov", "holidays-1.mp4"]
            .map(|name| reels.of(name));
        assert_eq!(names, ["HOLIDAYS", "HOLIDAY2", "FILM", "2", "AX2", "HOLIDAYS"]);
    }
}
