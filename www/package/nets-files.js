// @ts-check
/** In place of the file of this name in `engine/`: in the package the module of the nets has a folder of its own. */

export const SCRIPT = new URL('../pkg-detector/inkpanel.js', import.meta.url);
export const MODULE = new URL('../pkg-detector/inkpanel_bg.wasm', import.meta.url);
