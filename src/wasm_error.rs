//! How errors cross to the page, out of every module: as a JavaScript `Error` with a `code` beside its `message`.

use crate::error::Error;
use wasm_bindgen::prelude::*;

#[allow(clippy::needless_pass_by_value)] // It is what map_err hands over.
pub(crate) fn thrown(error: Error) -> JsValue {
    let object = js_sys::Error::new(&error.to_string());
    // Setting a property of a fresh object cannot fail.
    let _ = js_sys::Reflect::set(&object, &"code".into(), &error.code().into());
    object.into()
}
