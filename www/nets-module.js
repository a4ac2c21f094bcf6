// @ts-check
/**
 * Adds the detection module to the site as separate files, so that the app can be built and served before the module is
 * compiled. With `INKPANEL_NETS=later`, the build writes empty files, and the server fills them.
 */

import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const FOLDER = fileURLToPath(new URL('./pkg-detector/', import.meta.url));
const [SCRIPT, MODULE] = ['inkpanel.js', 'inkpanel_bg.wasm'];

/** @returns {import('vite').Plugin} */
export function netsModule() {
  const later = process.env.INKPANEL_NETS === 'later';
  /** @type {{name: string, source: string | Buffer}[]} */
  let parts = [];
  return {
    name: 'inkpanel-nets-module',
    // Not before: the unit tests read this configuration too, and need no module.
    config(_, { command }) {
      // `npm run dev` serves the source folders directly.
      if (command === 'serve') {
        return { define: { INKPANEL_NETS: JSON.stringify([SCRIPT, MODULE].map((name) => `/pkg-detector/${name}`)) } };
      }
      parts = [SCRIPT, MODULE].map((name) => {
        const source = later ? '' : readFileSync(FOLDER + name);
        const mark = later ? 'later' : createHash('sha256').update(source).digest('hex').slice(0, 8);
        return { name: `nets-${mark}.${name.split('.')[1]}`, source };
      });
      return { define: { INKPANEL_NETS: JSON.stringify(parts.map(({ name }) => name)) } };
    },
    buildStart() {
      for (const { name, source } of parts) this.emitFile({ type: 'asset', fileName: `assets/${name}`, source });
    },
  };
}
