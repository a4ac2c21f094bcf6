//! wasm bindings of the decoder. [`super::converted`] has its only class.

use wasm_bindgen::prelude::*;

#[wasm_bindgen(start)]
fn start() {
    console_error_panic_hook::set_once();
}
