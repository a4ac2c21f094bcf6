// @ts-check
/** Where the net that scores pictures is, if it is part of the site: nobody asks for a file that is not there. */

const FOUND = /** @type {string[]} */ (Object.values(import.meta.glob('../models/aesthetics.onnx', { query: '?url', import: 'default', eager: true })));

/** @type {string | undefined} */
export const NET = FOUND[0];
