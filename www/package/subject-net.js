// @ts-check
/** In place of the file of this name in `engine/`: the package has no net that finds the subjects of photos. */

/** @type {string | undefined} */
export const NET = undefined;
