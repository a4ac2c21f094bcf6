//! Colours in text notation.

/// Reads `#rrggbb`.
#[must_use]
pub fn parse_hex(text: &str) -> Option<[u8; 3]> {
    let digits = text.strip_prefix('#').filter(|digits| digits.len() == 6 && digits.is_ascii())?;
    // `from_str_radix` would also take a sign.
    if !digits.bytes().all(|digit| digit.is_ascii_hexdigit()) {
        return None;
    }
    let channel = |i: usize| u8::from_str_radix(&digits[i..i + 2], 16).ok();
    Some([channel(0)?, channel(2)?, channel(4)?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_six_hex_digits_are_a_colour() {
        assert_eq!(parse_hex("#10fF03"), Some([16, 255, 3]));
        for bad in ["", "#", "101010", "#12345", "#1234567", "#+1+1+1", "#zzzzzz", "#ééé"] {
            assert_eq!(parse_hex(bad), None, "{bad}");
        }
    }
}
