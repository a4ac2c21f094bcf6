// @ts-check
/** In place of the file of this name in `engine/`: the package has no net that scores pictures. */

/** @type {string | undefined} */
export const NET = undefined;
