//! Compatibility of saved styles with blocks that later got a choice of methods. A saved style looks the same
//! as before.
//!
//! If a block gets a second method, a parameter selects it, and the better method is the default. The program
//! always writes such a parameter, even if it has the default value. A style in a saved page, a project or
//! browser storage may lack the parameter. Then it was saved before the choice existed, and [`told`] adds the
//! old method. A style file without the parameter uses the default, as for any other parameter.

use serde_json::{Map, Value};

/// Block, parameter, and the value that is what the block did before it had this parameter.
const BEFORE: &[(&str, &str, &str)] = &[
    ("soft_threshold", "channels", "luma"),
    ("brightness", "channels", "each"),
    ("equalize", "channels", "each"),
];

/// Returns whether a written style includes this parameter even if it has the default value.
#[must_use]
pub fn is_always_told(block: &str, param: &str) -> bool {
    BEFORE.iter().any(|&(of, id, _)| (of, id) == (block, param))
}

/// Adds the parameters that a saved style in JSON lacks, because its blocks had no choice then. An id and an
/// invalid style stay unchanged.
#[must_use]
pub fn told(mut style: Value) -> Value {
    for layer in ["background", "foreground"] {
        let steps = style.get_mut(layer).and_then(Value::as_array_mut);
        for step in steps.into_iter().flatten().filter_map(Value::as_object_mut) {
            let block = step.get("block").and_then(Value::as_str).unwrap_or_default().to_owned();
            complete(&block, step);
        }
    }
    style
}

/// Adds missing parameters to one block, as [`told`] does for a style.
pub fn complete(block: &str, values: &mut Map<String, Value>) {
    for &(_, param, before) in BEFORE.iter().filter(|&&(of, ..)| of == block) {
        values.entry(param).or_insert_with(|| before.into());
    }
}

/// Returns whether a style file has id, name and tags, as the app wrote them before blocks had a choice. A
/// hand-written file can omit them.
#[must_use]
pub fn is_of_the_page(style: &Value) -> bool {
    ["id", "name", "tags"].iter().all(|field| style.get(field).is_some())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::{Style, blocks};
    use serde_json::json;

    #[test]
    fn every_choice_is_one_of_its_block() {
        for &(block, param, before) in BEFORE {
            let param = blocks::find(block).unwrap().params.iter().find(|known| known.id == param).unwrap();
            assert!(
                param.value_from_json(&before.into()).unwrap() > 0.0,
                "{block}: the default is what was before"
            );
        }
    }

    #[test]
    fn what_was_saved_is_completed_and_what_is_told_stays() {
        let old = json!({ "background": [{ "block": "brightness", "gain": 2 }, { "block": "xdog" }],
            "foreground": [{ "block": "soft_threshold" }, { "block": "equalize", "channels": "luma" }] });
        let new = told(old);
        assert_eq!(new["background"][0], json!({ "block": "brightness", "gain": 2, "channels": "each" }));
        assert_eq!(new["background"][1], json!({ "block": "xdog" }));
        assert_eq!(new["foreground"][0]["channels"], "luma");
        assert_eq!(new["foreground"][1]["channels"], "luma");
        assert_eq!(told(json!("noir")), json!("noir"));
    }

    #[test]
    fn a_style_that_is_written_is_complete() {
        let style = Style::parse(
            "x",
            r#"{"background":[{"block":"brightness"},{"block":"equalize"},{"block":"soft_threshold"}]}"#,
        );
        let written = style.unwrap().to_value();
        assert_eq!(told(written.clone()), written);
        assert_eq!(written["background"][0], json!({ "block": "brightness", "channels": "luma" }));
    }
}
