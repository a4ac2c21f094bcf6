//! Language tags of documents.

/// Checks the language tag of a comic: letters and digits in parts of up to eight characters, as in BCP 47.
pub(crate) fn tag(tag: &str) -> Result<String, String> {
    let part = |part: &str| (1..=8).contains(&part.len()) && part.chars().all(|c| c.is_ascii_alphanumeric());
    let first = tag.split('-').next().unwrap_or_default();
    if first.len() < 2 || first.chars().any(|c| c.is_ascii_digit()) || !tag.split('-').all(part) {
        return Err(format!("{tag} is not a language tag such as en or pt-BR"));
    }
    Ok(tag.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn languages_are_tags() {
        for good in ["en", "pt-BR", "zh-Hant-TW", "de"] {
            assert_eq!(tag(good).unwrap(), good);
        }
        for bad in ["", "e", "en_US", "en-", "1n", "en\"", "unbelievable"] {
            assert!(tag(bad).is_err(), "{bad}");
        }
    }
}
