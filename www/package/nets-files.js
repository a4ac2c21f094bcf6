// @ts-check
/** Replaces the file of this name in `engine/`: in the package, the detection module has a separate folder. */

export const SCRIPT = new URL('../pkg-detector/inkpanel.js', import.meta.url);
export const MODULE = new URL('../pkg-detector/inkpanel_bg.wasm', import.meta.url);
