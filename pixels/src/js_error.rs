//! Errors for the app, from all modules: a JavaScript `Error` with a `code` and a `message`.

use crate::error::Error;
use wasm_bindgen::prelude::*;

/// Converts an error to the JavaScript value to throw.
#[allow(clippy::needless_pass_by_value, reason = "it is what map_err hands over")]
#[must_use]
pub fn thrown(error: Error) -> JsValue {
    let object = js_sys::Error::new(&error.to_string());
    // Setting a property of a fresh object cannot fail.
    let _ = js_sys::Reflect::set(&object, &"code".into(), &error.code().into());
    object.into()
}
