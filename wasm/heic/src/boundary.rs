//! wasm bindings of the decoder. [`super::converted`] has its only class.

pub(crate) use inkpanel_image::raster::decode::decode_heic as decode;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(start)]
fn start() {
    console_error_panic_hook::set_once();
}
