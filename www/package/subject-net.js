// @ts-check
/** Replaces the file of this name in `engine/`: the package has no model that finds the subjects of photos. */

/** @type {string | undefined} */
export const NET = undefined;
