//! Malformed style files: each is rejected with its position and the reason, without a panic.

use inkpanel_engine::style::Style;

/// A file, and the expected text of its error.
const MALFORMED: &[(&str, &str)] = &[
    // No JSON, or JSON of another kind.
    ("", "is not valid JSON"),
    (" ", "is not valid JSON"),
    ("nonsense", "is not valid JSON"),
    ("{", "is not valid JSON"),
    (r#"{"background":[]"#, "is not valid JSON"),
    (r#"{"background":[],}"#, "is not valid JSON"),
    ("{'background':[]}", "is not valid JSON"),
    (r#"{"background":[]} more"#, "is not valid JSON"),
    (r#"{"background":[{"block":"xdog","sigma":NaN}]}"#, "is not valid JSON"),
    (r#"{"background":[{"block":"xdog","sigma":1e999}]}"#, "is not valid JSON"),
    ("null", "must be an object"),
    ("true", "must be an object"),
    ("42", "must be an object"),
    (r#""style""#, "must be an object"),
    ("[]", "must be an object"),
    (r#"[{"background":[]}]"#, "must be an object"),
    // The fields of a style.
    ("{}", "background: is missing"),
    (r#"{"foreground":[]}"#, "background: is missing"),
    (r#"{"background":null}"#, "background: must be a list"),
    (r#"{"background":{}}"#, "background: must be a list"),
    (r#"{"background":"xdog"}"#, "background: must be a list"),
    (r#"{"background":[],"foreground":null}"#, "foreground: must be a list"),
    (r#"{"background":[],"foreground":{"block":"xdog"}}"#, "foreground: must be a list"),
    (r#"{"background":[],"middle":[]}"#, "middle: is not a field of a style"),
    (r#"{"background":[],"Ink":"black"}"#, "Ink: is not a field of a style"),
    (r#"{"background":[],"__proto__":{}}"#, "__proto__: is not a field of a style"),
    (r#"{"background":[],"id":""}"#, "id: must be a text"),
    (r#"{"background":[],"id":"   "}"#, "id: must be a text"),
    (r#"{"background":[],"id":7}"#, "id: must be a text"),
    (r#"{"background":[],"name":[]}"#, "name: must be a text"),
    (r#"{"background":[],"name":null}"#, "name: must be a text"),
    (r#"{"background":[],"tags":"ink"}"#, "tags: must be a list"),
    (r#"{"background":[],"tags":[1]}"#, "tags: must be a list"),
    (r#"{"background":[],"tags":[["ink"]]}"#, "tags: must be a list"),
    (r#"{"background":[],"ink":"black"}"#, "ink: is \"black\""),
    (r##"{"background":[],"ink":"#12345"}"##, "ink: is \"#12345\""),
    (r##"{"background":[],"ink":"#gggggg"}"##, "ink: is \"#gggggg\""),
    (r#"{"background":[],"ink":0}"#, "ink: is 0"),
    (r#"{"background":[],"score":"high"}"#, "score: must be a number"),
    // Its blocks.
    (r#"{"background":["xdog"]}"#, "background[0]: must be an object"),
    (r#"{"background":[null]}"#, "background[0]: must be an object"),
    (r#"{"background":[{"block":"tvf"},[]]}"#, "background[1]: must be an object"),
    (r#"{"background":[{}]}"#, "background[0]: needs a \"block\""),
    (r#"{"background":[{"block":null}]}"#, "background[0]: needs a \"block\""),
    (r#"{"background":[{"block":3}]}"#, "background[0]: needs a \"block\""),
    (r#"{"background":[{"Block":"xdog"}]}"#, "background[0]: needs a \"block\""),
    (r#"{"background":[{"block":""}]}"#, "background[0]: there is no block \"\""),
    (r#"{"background":[{"block":"XDoG"}]}"#, "background[0]: there is no block \"XDoG\""),
    (r#"{"background":[],"foreground":[{"block":"blur"}]}"#, "foreground[0]: there is no block \"blur\""),
    (r#"{"background":[{"block":"xdog","bypass":"yes"}]}"#, "background[0] (xdog), bypass: must be true"),
    (r#"{"background":[{"block":"xdog","bypass":null}]}"#, "background[0] (xdog), bypass: must be true"),
    // Their parameters.
    (
        r#"{"background":[{"block":"xdog","Sigma":2}]}"#,
        "(xdog), Sigma: is not a parameter of this block (sigma, p)",
    ),
    (
        r#"{"background":[{"block":"to_gray","amount":2}]}"#,
        "(to_gray), amount: is not a parameter of this block",
    ),
    (r#"{"background":[{"block":"xdog","sigma":"2"}]}"#, "(xdog), sigma: is \"2\", it must be a number"),
    (r#"{"background":[{"block":"xdog","sigma":null}]}"#, "(xdog), sigma: is null, it must be a number"),
    (r#"{"background":[{"block":"xdog","sigma":[2]}]}"#, "(xdog), sigma: is [2], it must be a number"),
    (r#"{"background":[{"block":"xdog","sigma":0}]}"#, "(xdog), sigma: is 0, it must be from 0.3 to 20"),
    (r#"{"background":[{"block":"xdog","sigma":-1e30}]}"#, "it must be from 0.3 to 20"),
    (r#"{"background":[{"block":"gaussian","sigma":50.01}]}"#, "is 50.01, it must be from 0.3 to 50"),
    (r#"{"background":[{"block":"posterize","levels":1}]}"#, "(posterize), levels: is 1"),
    (r#"{"background":[{"block":"posterize","levels":65}]}"#, "is 65, it must be from 2 to 64"),
    (r#"{"background":[{"block":"posterize","levels":7.5}]}"#, "it must be a whole number"),
    (r#"{"background":[{"block":"posterize","levels":true}]}"#, "it must be a whole number"),
    (r#"{"background":[{"block":"sobel","invert":0}]}"#, "(sobel), invert: is 0, it must be true or false"),
    (r#"{"background":[{"block":"sobel","invert":"true"}]}"#, "it must be true or false"),
    (r#"{"background":[{"block":"halftone","mode":"rgb"}]}"#, "it must be one of: cmyk, mono"),
    (r#"{"background":[{"block":"halftone","mode":1}]}"#, "it must be one of: cmyk, mono"),
    // Channels.
    (r#"{"background":[{"block":"pattern"}]}"#, "background[0] (pattern): needs gray"),
    (r#"{"background":[{"block":"to_gray"},{"block":"hue"}]}"#, "background[1] (hue): needs colour"),
    (r#"{"background":[],"foreground":[{"block":"colorize"}]}"#, "foreground[0] (colorize): needs gray"),
];

#[test]
fn every_malformed_file_is_refused_with_place_and_reason() {
    assert!(MALFORMED.len() >= 60);
    for (json, reason) in MALFORMED {
        let error = Style::parse("shared.json", json).map(|style| style.to_value()).unwrap_err();
        assert_eq!(error.code(), "invalid-style", "{json}");
        let message = error.to_string();
        assert!(message.contains("shared.json") && message.contains(reason), "{json}: {message}");
    }
}

#[test]
fn too_much_of_anything_is_refused() {
    let many = |what: &str, count: usize| vec![what; count].join(",");
    let blocks = format!(r#"{{"background":[{}]}}"#, many(r#"{"block":"tvf"}"#, 33));
    let tags = format!(r#"{{"background":[],"tags":[{}]}}"#, many(r#""ink""#, 21));
    let name = format!(r#"{{"background":[],"name":"{}"}}"#, "x".repeat(201));
    let deep = format!(r#"{{"background":{}{}}}"#, "[".repeat(5000), "]".repeat(5000));
    for (json, reason) in
        [(blocks, "has 33 blocks"), (tags, "tags"), (name, "name"), (deep, "is not valid JSON")]
    {
        let message = Style::parse("shared.json", &json).unwrap_err().to_string();
        assert!(message.contains(reason), "{message}");
    }
}

/// Each valid file, truncated or with one changed character, is either rejected or a style, without a panic.
#[test]
fn damage_anywhere_never_panics() {
    for style in inkpanel_engine::style::catalogue::catalogue().iter().take(12) {
        let json = style.to_value().to_string();
        for at in (0..json.len()).filter(|&at| json.is_char_boundary(at)) {
            if let Err(error) = Style::parse("cut.json", &json[..at]) {
                assert_eq!(error.code(), "invalid-style");
            }
            let mut changed = json.clone().into_bytes();
            changed[at] = b"}]:,\"9x"[at % 7];
            if let Ok(text) = String::from_utf8(changed)
                && let Ok(read) = Style::parse("changed.json", &text)
            {
                Style::from_value("again.json", &read.to_value()).unwrap();
            }
        }
    }
}
