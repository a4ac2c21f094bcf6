/** Address of the detector module. The build puts it next to its worker (`nets-module.js`). */

/** A constant of the build. */
declare const INKPANEL_NETS: string[];

const [script, module] = INKPANEL_NETS;

export const SCRIPT = new URL(script, globalThis.location.href);
export const MODULE = new URL(module, globalThis.location.href);
