// @ts-check
/** A planner and an engine of a few lines, for the tests of the state: no pixels, no wasm. */

import { unreadMeta } from './album.js';
import { createMessages } from './messages.js';
import { createPages } from './pages.js';
import { createReading } from './reading.js';
import { createStore } from './store.js';

/** @typedef {import('../engine/documents.js').PlanRequest} PlanRequest */

const LAYOUTS = [1, 2, 3, 4, 6].map((count) => ({ id: `l${count}`, name: `${count}`, family: 'rows', aspect: 1, count, panels: [] }));

/** Plans as the core does, in the little that the state relies on. */
export function fakePlanner() {
  /** @type {PlanRequest[]} */
  const requests = [];
  return {
    requests,
    styles: () => [],
    blocks: () => [],
    listLayouts: (/** @type {{ own: object[] }} */ { own }) => [
      ...own.map((layout, i) => ({ ...layout, own: i })), ...LAYOUTS.map((layout) => ({ ...layout, own: null })),
    ],
    layoutFacts: (/** @type {any} */ layout) => {
      const id = layout.id ?? layout;
      const count = Number(id.slice(1));
      return { id, base: count, count, good: true, editable: true, adjacent: count > 1 ? [[0, 1]] : [], cuts: [] };
    },
    layoutFile: (/** @type {any} */ layout) => (layout.id ? layout : { id: layout }),
    generateLayout: (/** @type {any} */ { least, most }) => ({ id: `g${least + most >> 1}`, family: 'generated' }),
    changeLayout: (/** @type {any} */ layout, /** @type {any} */ change) => {
      const count = Number((layout.id ?? layout).slice(1));
      return { id: `c${count + ({ split: 1, remove: -1 }[/** @type {string} */ (change.type)] ?? 0)}`, family: 'custom', change };
    },
    checkLayout: (/** @type {string} */ json, /** @type {string} */ file) => {
      const layout = JSON.parse(json);
      if (!layout.id) throw Object.assign(new Error(`layout ${file}: id: is missing`), { code: 'invalid-layout' });
      return layout;
    },
    geometry: () => ({ width: 1, height: 1, panels: [] }),
    choose: (/** @type {any[]} */ photos) => photos.map(({ id, twin }) => ({ id, group: 0, kept: !twin, why: twin ? 'same as another' : '' })),
    plan: (/** @type {PlanRequest} */ request) => {
      requests.push(request);
      const { seed, photos, page, current, keep, layout, style, panels } = request;
      const wanted = panels ?? photos.length;
      const nearest = LAYOUTS.reduce((best, other) => (Math.abs(other.count - wanted) < Math.abs(best.count - wanted) ? other : best));
      const taken = /** @type {any} */ (layout ?? (keep.layout && current ? current.layout : nearest.id));
      const count = Number((taken.id ?? taken).slice(1));
      const ids = photos.map((photo) => photo.id);
      const order = keep.photos && current ? current.order.filter((photo) => ids.includes(photo)) : ids;
      return {
        version: 1, seed, layout: taken, style: style ?? (keep.style && current ? current.style : `s${seed}`), order,
        panels: Array.from({ length: count }, (_, i) => ({ photo: order[i % order.length], crop: null })),
        merges: (current && taken === current.layout && current.merges) || [], page, words: current?.words ?? [],
      };
    },
  };
}

/**
 * @param {Record<string, 'bad' | 'twin'>} [odd] files that cannot be read or that look like another
 */
export function fakeApp(odd = {}) {
  const store = createStore();
  const planner = fakePlanner();
  store.planner.value = /** @type {any} */ (planner);
  let seed = 0;
  const pages = createPages(store, () => (seed += 1));
  const messages = createMessages();
  const imported = new Set();
  const engine = /** @type {any} */ ({
    ready: Promise.resolve(planner),
    importPhoto: async (/** @type {string} */ id, /** @type {File} */ { name }) => {
      await Promise.resolve();
      if (odd[name] === 'bad') throw Object.assign(new Error('not a photo'), { code: 'unsupported-format' });
      imported.add(id);
      return { ...unreadMeta(id), measures: { twin: odd[name] === 'twin' ? 1 : 0 } };
    },
    forgetPhoto: () => {},
  });
  const reading = createReading({ store, pages, engine, messages });
  const files = (/** @type {string[]} */ ...names) => names.map((name) => new File(['x'], name));
  return { store, planner, pages, messages, reading, files };
}
