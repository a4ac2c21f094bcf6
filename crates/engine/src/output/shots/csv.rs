//! A shot list as comma-separated values, RFC 4180. It begins with a byte order mark, so that spreadsheets
//! detect UTF-8. An apostrophe precedes cells that a spreadsheet would read as formulas.

use super::{Cut, HEADINGS, ShotList};

/// Columns in order, as indices of [`HEADINGS`]: captions and sounds are next to the dialogue.
const ORDER: [usize; HEADINGS.len()] = [0, 1, 2, 3, 4, 5, 6, 7, 8, CAPTION, SOUND, 9];
const CAPTION: usize = 10;
const SOUND: usize = 11;
/// Characters that begin a formula. Source: OWASP, CSV Injection.
const FORMULA: [char; 6] = ['=', '+', '-', '@', '\t', '\r'];

pub(super) fn write(list: &ShotList) -> String {
    let mut out = String::from("\u{feff}");
    let told = list.headings.len() == HEADINGS.len();
    let heading = |i: usize, name: &str| if told { list.headings[i].clone() } else { name.to_owned() };
    let captions = list.shots.iter().any(|shot| !shot.caption.is_empty());
    let sounds = list.shots.iter().any(|shot| !shot.sound.is_empty());
    let is_used = |i: &usize| match *i {
        CAPTION => captions,
        SOUND => sounds,
        _ => true,
    };
    let names = ORDER.into_iter().filter(is_used).map(|i| heading(i, HEADINGS[i]));
    row(&mut out, names.chain(list.columns.iter().cloned()));
    for cut in &list.cuts() {
        // A table that is imported again must not change the lengths of the board.
        let Cut { shot, start, wanted: frames, .. } = cut;
        let of_film = |text: &str| if shot.film.is_some() { text.to_owned() } else { String::new() };
        let known = [
            shot.scene.clone(),
            shot.number.clone(),
            shot.name.clone(),
            of_film(cut.file()),
            of_film(&cut.timecode(*start)),
            list.rate().timecode(*frames),
            frames.to_string(),
            shot.action.clone(),
            shot.dialogue.clone(),
            shot.notes.clone(),
            shot.caption.clone(),
            shot.sound.clone(),
        ];
        let known = ORDER.into_iter().filter(is_used).map(|i| known[i].clone());
        let own = list.columns.iter().map(|column| shot.more.get(column).cloned().unwrap_or_default());
        row(&mut out, known.chain(own));
    }
    out
}

fn row(out: &mut String, cells: impl Iterator<Item = String>) {
    for (i, cell) in cells.enumerate() {
        if i > 0 {
            out.push(',');
        }
        // The import removes one apostrophe.
        let is_formula = cell.trim_start_matches('\'').starts_with(FORMULA);
        let guarded = if is_formula { format!("'{cell}") } else { cell };
        if guarded.contains(['"', ',', '\r', '\n']) {
            out.push('"');
            out.push_str(&guarded.replace('"', "\"\""));
            out.push('"');
        } else {
            out.push_str(&guarded);
        }
    }
    out.push_str("\r\n");
}

#[cfg(test)]
mod tests {
    use super::super::tests::list;
    use super::*;

    #[test]
    fn cells_are_quoted_and_no_cell_is_a_formula() {
        let mut list = list(24);
        list.shots.truncate(2);
        list.shots[1].notes = "=HYPERLINK(\"x\")".into();
        list.shots[1].more.insert("Lens".into(), "35".into());
        let text = write(&list);
        let head = "\u{feff}Scene,Shot,Picture,Film,Time code,Duration,Frames,Action,Dialogue,Notes,Lens\r\n";
        let first = "1,1,1 ä.jpg,,,00:00:01:12,36,\"She opens \"\"1\"\",\nthe door.\",,,\r\n";
        let second = "1,4A,4A ä.jpg,night.mp4,00:00:12:12,00:00:02:00,48,\"She opens \"\"4A\"\",\nthe door.\",,\"'=HYPERLINK(\"\"x\"\")\",35\r\n";
        assert_eq!(text, [head, first, second].concat());
    }

    #[test]
    fn captions_and_sounds_are_next_to_the_dialogue_if_a_shot_has_them() {
        let mut list = list(24);
        list.shots.truncate(1);
        list.shots[0].dialogue = "Hi".into();
        list.shots[0].sound = "BANG".into();
        let text = write(&list);
        assert!(text.lines().next().unwrap().ends_with(",Action,Dialogue,Sound,Notes,Lens"), "{text}");
        assert!(text.contains(",Hi,BANG,,"), "{text}");
        list.shots[0].caption = "Later".into();
        assert!(write(&list).contains(",Hi,Later,BANG,,"));
    }
}
