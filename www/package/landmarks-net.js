// @ts-check
/** Replaces the file of this name in `engine/`: in the package, the landmark model has a fixed address. */

/** @type {string | undefined} */
export const NET = new URL('../models/landmarks.onnx', import.meta.url).href;
