// @ts-check
/** Names that the core and the data files bring along. They are English there, so here they pass as they are. */

/** @typedef {{ id: string, label: string, help: string }} Block @typedef {{ id: string, label: string, help?: string }} Parameter */

/** @param {string} id */
const asName = (id) => id.charAt(0).toUpperCase() + id.slice(1).replaceAll(/[-_]/g, ' ');

export const coreStrings = {
  /** @param {string} id of a family of layouts or a tag of styles */
  familyName: (id) => asName(id),
  blockName: (/** @type {Block} */ block) => block.label,
  blockHelp: (/** @type {Block} */ block) => block.help,
  /** @param {string} _block id @param {Parameter} parameter */
  parameterName: (_block, parameter) => parameter.label,
  /** @param {string} _block id @param {Parameter} parameter */
  parameterHelp: (_block, parameter) => parameter.help ?? '',
  /** @param {string} id of a choice of a parameter */
  choiceName: (id) => asName(id),
  /** Why a photo is kept or set aside. @param {string} why */
  verdict: (why) => why,
  layoutTitle: (/** @type {{ id: string, name: string }} */ layout) => layout.name,
  styleTitle: (/** @type {{ id: string, name: string }} */ style) => style.name,
};
