// @ts-check
/** Replaces the file of this name in `engine/`: the package has no model that rates pictures. */

/** @type {string | undefined} */
export const NET = undefined;
