//! `CHANGELOG.md` by the convention of [Keep a Changelog](https://keepachangelog.com): the entries under
//! Unreleased become the section of the version.

use anyhow::{Context, Result, bail, ensure};
use semver::Version;
use time::Date;
use time::format_description::well_known::Iso8601;

const UNRELEASED: &str = "Unreleased";

/// The changelog of a release.
#[derive(Debug, PartialEq)]
pub(crate) struct Released {
    /// The whole file with a section for the version.
    pub(crate) text: String,
    /// The day that the section has.
    pub(crate) day: Date,
}

/// Returns the changelog `text` with a section for `version`. An existing section does not change. Otherwise
/// the entries under Unreleased become the section, dated `today`, and an empty Unreleased section stays
/// above it.
///
/// # Errors
/// If the version has no entries, if both Unreleased and the section of the version have entries, or if a
/// section has no date.
pub(crate) fn release(text: &str, version: &Version, today: Date) -> Result<Released> {
    let sections = parse_changelog::parse(text).with_context(
        || "CHANGELOG.md has no section that begins with `## [VERSION]` or `## [Unreleased]`",
    )?;
    let waiting = sections.get(UNRELEASED).filter(|section| says_something(section.notes));
    let Some(section) = sections.get(version.to_string().as_str()) else {
        let waiting = waiting.with_context(|| {
            format!("CHANGELOG.md has neither entries under Unreleased nor a section for {version}")
        })?;
        return Ok(Released { text: renamed(text, waiting.title, version, today)?, day: today });
    };
    ensure!(
        waiting.is_none(),
        "CHANGELOG.md has a section for {version} already, and entries under Unreleased beside it: name the next version"
    );
    ensure!(says_something(section.notes), "CHANGELOG.md says nothing of {version}");
    Ok(Released { text: text.to_owned(), day: day(section.title)? })
}

/// Whether notes have more than headings.
fn says_something(notes: &str) -> bool {
    notes.lines().any(|line| !line.trim().is_empty() && !line.starts_with('#'))
}

/// Renames the section `title` to the version, and adds an empty section `title` above it.
fn renamed(text: &str, title: &str, version: &Version, today: Date) -> Result<String> {
    let day = written(today)?;
    let section = format!("## [{UNRELEASED}]\n\n## [{version}] - {day}\n");
    let heading = |line: &str| line.strip_prefix("## ").is_some_and(|rest| rest.trim() == title);
    let mut out = String::with_capacity(text.len() + 64);
    let mut found = 0;
    for line in text.split_inclusive('\n') {
        if heading(line.trim_end()) {
            found += 1;
            out += &section;
        } else {
            out += line;
        }
    }
    ensure!(found == 1, "CHANGELOG.md has {found} headings `## {title}`: one is what there should be");
    Ok(out)
}

/// A day as `2026-11-24`.
pub(crate) fn written(day: Date) -> Result<String> {
    day.format(&Iso8601::DATE).context("a day that cannot be written")
}

/// Returns the date in a heading such as `[1.2.0] - 2026-11-24`.
fn day(title: &str) -> Result<Date> {
    let told = title.rsplit_once(" - ").map_or("", |(_, day)| day.trim());
    match Date::parse(told, &Iso8601::DATE) {
        Ok(day) if told.len() == 10 => Ok(day),
        _ => bail!("the heading `## {title}` of CHANGELOG.md has no day: it should end with ` - YYYY-MM-DD`"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TODAY: &str = "2026-11-24";

    fn today() -> Date {
        Date::parse(TODAY, &Iso8601::DATE).unwrap()
    }

    fn released(text: &str, version: &str) -> Result<Released> {
        release(text, &Version::parse(version).unwrap(), today())
    }

    fn refused(text: &str, version: &str) -> String {
        released(text, version).unwrap_err().to_string()
    }

    const BEFORE: &str =
        "# Changes\n\n## [Unreleased]\n\n### Added\n\n- A thing.\n\n## [0.1.0] - 2026-01-02\n\n- First.\n";

    #[test]
    fn what_is_unreleased_becomes_the_section_of_the_version() {
        let Released { text, day } = released(BEFORE, "0.2.0").unwrap();
        assert_eq!(
            text,
            "# Changes\n\n## [Unreleased]\n\n## [0.2.0] - 2026-11-24\n\n### Added\n\n- A thing.\n\n## [0.1.0] - 2026-01-02\n\n- First.\n"
        );
        assert_eq!(written(day).unwrap(), TODAY);
    }

    #[test]
    fn a_version_that_has_its_section_is_left_with_its_day() {
        let once = released(BEFORE, "0.2.0").unwrap();
        let later = Date::parse("2027-01-01", &Iso8601::DATE).unwrap();
        assert_eq!(release(&once.text, &Version::parse("0.2.0").unwrap(), later).unwrap(), once);
    }

    #[test]
    fn nothing_to_tell_is_no_release() {
        let empty = "# Changes\n\n## [Unreleased]\n\n### Added\n\n## [0.1.0] - 2026-01-02\n\n- First.\n";
        assert_eq!(
            refused(empty, "0.2.0"),
            "CHANGELOG.md has neither entries under Unreleased nor a section for 0.2.0"
        );
        assert!(refused("# Changes\n", "0.1.0").contains("no section that begins with"));
    }

    #[test]
    fn entries_beside_a_section_of_the_version_ask_for_the_next() {
        assert!(refused(BEFORE, "0.1.0").ends_with("name the next version"));
    }

    #[test]
    fn a_section_without_a_day_is_told() {
        for heading in ["[0.1.0]", "[0.1.0] - soon", "[0.1.0] - 2026"] {
            let told = refused(&format!("## {heading}\n\n- First.\n"), "0.1.0");
            assert!(told.contains("YYYY-MM-DD"), "{heading}: {told}");
        }
    }

    #[test]
    fn the_changelog_of_the_project_can_be_released() {
        let text = include_str!("../../../CHANGELOG.md");
        assert!(
            released(text, "999.0.0").is_ok()
                || !says_something(parse_changelog::parse(text).unwrap()[UNRELEASED].notes)
        );
    }
}
