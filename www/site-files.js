// @ts-check
/**
 * The last step of the build: the service worker, with the list of the files that there are by then. Also
 * `node site-files.js FOLDER`, for a site whose files were changed afterwards.
 */

import { createHash } from 'node:crypto';
import { readFile, readdir } from 'node:fs/promises';
import { join, relative, resolve, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

/** @typedef {import('./offline/worker/worker-types.ts').Site} Site */

const WORKER = 'service-worker.js';
const SOURCE = fileURLToPath(new URL('./offline/worker/main.ts', import.meta.url));
/** The models, their module, and the table of places. They are larger than the rest of the app, and not every user needs them. */
const ON_USE = /^assets\/(?:nets-[^/]*\.wasm|[^/]*\.onnx|places-[^/]*\.bin)$/;
/** The sample album and the fonts of the text field work offline, but are not necessary. */
const EXTRAS = /^samples\/.*\.(?:jpg|json)$|^assets\/[^/]*\.ttf$/;
/** Files that the app never requests, that are still being built, or that configure the host. */
const NOT = /\.(?:md|map)$|^assets\/nets-later\.|^_headers$/;

/** @returns {import('vite').Plugin} */
export function siteFiles() {
  let folder = '';
  let isWritten = false;
  return {
    name: 'inkpanel-site-files',
    apply: 'build',
    configResolved: ({ root, build: { outDir } }) => {
      folder = resolve(root, outDir);
    },
    writeBundle: () => {
      isWritten = true;
    },
    closeBundle: {
      order: 'post',
      sequential: true,
      // It is also called after a failed build, whose error a second one would hide.
      handler: async () => {
        if (isWritten) await sealSite(folder);
      },
    },
  };
}

/**
 * Writes the service worker of a built site.
 * @param {string} folder
 */
export async function sealSite(folder) {
  const site = await filesOf(folder);
  await build({
    configFile: false,
    logLevel: 'warn',
    publicDir: false,
    define: { INKPANEL_SITE: JSON.stringify(site) },
    build: {
      outDir: folder,
      emptyOutDir: false,
      target: 'es2022',
      modulePreload: false,
      // One file, and no module: Firefox before 147 has no service workers of modules.
      rolldownOptions: { input: SOURCE, output: { format: 'iife', entryFileNames: WORKER } },
    },
  });
}

/**
 * @param {string} folder
 * @returns {Promise<Site>}
 */
export async function filesOf(folder) {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  const paths = entries
    .filter((entry) => entry.isFile())
    .map(({ parentPath, name }) => relative(folder, join(parentPath, name)).split(sep).join('/'));
  const kept = paths.filter((path) => path !== WORKER && !NOT.test(path)).sort();
  const files = await Promise.all(
    kept.map(
      async (path) =>
        /** @type {import('./offline/worker/worker-types.ts').SiteFile} */ ([
          path === 'index.html' ? '' : path,
          await integrityOf(join(folder, path)),
        ]),
    ),
  );
  const needed = files.filter(([path]) => !ON_USE.test(path) && !EXTRAS.test(path));
  const extras = files.filter(([path]) => EXTRAS.test(path));
  const onUse = files.map(([path]) => path).filter((path) => ON_USE.test(path));
  const version = createHash('sha256').update(JSON.stringify(files)).digest('hex').slice(0, 12);
  return { version, needed, extras, onUse };
}

/** @param {string} file */
async function integrityOf(file) {
  return `sha256-${createHash('sha256')
    .update(await readFile(file))
    .digest('base64')}`;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await sealSite(resolve(process.argv[2]));
