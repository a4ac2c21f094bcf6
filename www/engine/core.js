// @ts-check
/**
 * The wasm module: compiled once here, instantiated on the main thread for planning and in each worker for pixels.
 */

import initCore, * as core from '../pkg/inkpanel.js';
import { expanded, interned } from './interned.js';
import { failure } from './protocol.js';

/** Photos no longer planned with that are remembered, since undo may bring them back. */
const SPARE_PHOTOS = 500;

const ADDRESS = new URL('../pkg/inkpanel_bg.wasm', import.meta.url);

/** @returns {Promise<WebAssembly.Module>} */
async function compile() {
  const response = await fetch(ADDRESS);
  if (!response.ok) throw failure('core-missing', `The program could not be loaded (${response.status}).`);
  // A static host may serve wasm under any content type, which streaming would refuse.
  const streams = response.headers.get('content-type')?.startsWith('application/wasm');
  return streams ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

/** @returns {Promise<{ module: WebAssembly.Module, planner: Planner }>} */
export async function loadCore() {
  const module = await compile();
  await initCore({ module_or_path: module });
  return { module, planner: createPlanner() };
}

/** @typedef {ReturnType<typeof createPlanner>} Planner */

/**
 * The pure functions of the core, with plain objects in place of JSON. Each takes well under a millisecond or
 * two and throws an error with a `code`.
 */
function createPlanner() {
  const albumOf = createAlbum();
  return {
    /** @returns {Block[]} */
    blocks: () => JSON.parse(core.blocks()),
    /** @returns {Layout[]} */
    layouts: () => JSON.parse(core.layouts()),
    /** @returns {Style[]} */
    styles: () => JSON.parse(core.styles()),
    /**
     * @param {string} json the text of a style file
     * @param {string} file its name, for the message
     * @returns {Style}
     */
    checkStyle: (json, file) => JSON.parse(core.check_style(json, file)),
    /**
     * @param {string} json the text of a layout file
     * @param {string} file its name, for the message
     * @returns {Template}
     */
    checkLayout: (json, file) => JSON.parse(core.check_layout(json, file)),
    /**
     * @param {string | object} layout
     * @param {PageSettings} page
     * @returns {Geometry}
     */
    geometry: (layout, page) => JSON.parse(core.page_geometry(JSON.stringify({ layout, page }))),
    /**
     * @param {{ page: Partial<PageSettings>, own: Template[] }} request `own`: a person's own layouts
     * @returns {LayoutEntry[]} those first, then the catalogue's that are good for the page
     */
    listLayouts: (request) => JSON.parse(core.list_layouts(JSON.stringify(request))),
    /**
     * @param {string | object} layout
     * @param {PageSettings} page
     * @returns {LayoutFacts}
     */
    layoutFacts: (layout, page) => JSON.parse(core.layout_facts(JSON.stringify({ layout, page }))),
    /**
     * @param {string | object} layout
     * @returns {Template} in full
     */
    layoutFile: (layout) => JSON.parse(core.layout_file(JSON.stringify({ layout }))),
    /**
     * @param {{ seed: number, page: PageSettings, least: number, most: number }} request the numbers of panels
     * @returns {Template}
     */
    generateLayout: (request) => JSON.parse(core.generate_layout(JSON.stringify(request))),
    /**
     * @param {string | object} layout
     * @param {LayoutChange} change
     * @returns {Template}
     */
    changeLayout: (layout, change) => JSON.parse(core.change_layout(JSON.stringify({ layout, change }))),
    /**
     * @param {PlanRequest} request
     * @returns {PageDocument}
     */
    plan: ({ photos, ...rest }) => JSON.parse(albumOf(photos).plan(JSON.stringify(rest), JSON.stringify(photos.map(({ id }) => id)))),
    /**
     * @param {number} seed
     * @returns {Style} invented
     */
    inventStyle: (seed) => JSON.parse(core.invent_style(seed)),
    /**
     * @param {{ a: string | object, b: string | object, seed: number, surprise: number }} request `surprise`: 0 to 1
     * @returns {Style} a child of both
     */
    breedStyle: (request) => JSON.parse(core.breed_style(JSON.stringify(request))),
    /**
     * @param {object[]} photos
     * @param {number} threshold
     * @returns {Verdict[]}
     */
    choose: (photos, threshold) => JSON.parse(core.choose_photos(JSON.stringify({ photos, threshold }))),
    /**
     * Reads a project file or the text of a page PNG and checks all of it. Throws `damaged-project` or `newer-project`.
     * @param {string} text
     * @param {{ prefix?: string }} [how] `prefix`: all photos and videos get fresh ids that begin with it
     * @returns {{ format: string, version: number, history: { present: any, shown: any[] }, photos: any[], videos: any[], dropped: string[] }}
     *   `dropped`: sentences about what was left out
     */
    readProject: (text, { prefix } = {}) => JSON.parse(core.read_project(text, prefix)),
    readHistory,
  };
}

/**
 * Reads a history out of the database and checks all of it. What states share they share again. Throws `damaged-project` or
 * `newer-project`.
 * @param {any} record with `version` and `history`
 * @returns {{ version: number, history: import('./interned.js').KeptHistory, dropped: string[] }} `dropped`: sentences about
 *   what was left out
 */
function readHistory(record) {
  let text;
  try {
    text = JSON.stringify({ version: record?.version, history: interned(record?.history) });
  } catch {
    // Something that refers to itself, or a number without end.
    throw failure('damaged-project', 'history: is no plain data');
  }
  const { version, history, dropped } = JSON.parse(core.read_history(text));
  return { version, history: expanded(history), dropped };
}

/**
 * The core's album, which is told of a photo once, and again when more is known of it.
 * @returns {(photos: PlanRequest['photos']) => core.Album} that knows these photos
 */
function createAlbum() {
  const album = new core.Album();
  /** @type {Map<string, PlanRequest['photos'][number]>} */
  const told = new Map();
  return (photos) => {
    const fresh = photos.filter((photo) => told.get(photo.id) !== photo);
    if (fresh.length > 0) album.know(JSON.stringify(fresh));
    for (const photo of fresh) told.set(photo.id, photo);
    if (told.size > 2 * photos.length + SPARE_PHOTOS) {
      const ids = new Set(photos.map(({ id }) => id));
      album.keep(JSON.stringify([...ids]));
      for (const id of [...told.keys()]) if (!ids.has(id)) told.delete(id);
    }
    return album;
  };
}

/** @typedef {import('./documents.js').Block} Block */
/** @typedef {import('./documents.js').Layout} Layout */
/** @typedef {import('./documents.js').Template} Template */
/** @typedef {import('./documents.js').LayoutEntry} LayoutEntry */
/** @typedef {import('./documents.js').LayoutFacts} LayoutFacts */
/** @typedef {import('./documents.js').LayoutChange} LayoutChange */
/** @typedef {import('./documents.js').Style} Style */
/** @typedef {import('./documents.js').Geometry} Geometry */
/** @typedef {import('./documents.js').PageSettings} PageSettings */
/** @typedef {import('./documents.js').PageDocument} PageDocument */
/** @typedef {import('./documents.js').PlanRequest} PlanRequest */
/** @typedef {import('./documents.js').Verdict} Verdict */
