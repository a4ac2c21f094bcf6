/** A planner that does what a test foresees beside the core's editor, and an engine of a few lines: no pixels. */

import { unreadMeta } from './album.ts';
import { createMessages } from '../ui/messages.ts';
import { createEditing } from './editing.ts';
import { createPages } from './pages.ts';
import { DEFAULT_SETTINGS } from './empty.ts';
import { createReading } from '../photos/reading.ts';
import { core } from '../engine/testing-core.ts';
import { createStore } from './store.ts';
import type { PlanRequest } from '../engine/core.ts';
import type { Layout, PageDocument } from '../engine/types.ts';
import type { Editing } from './editing.ts';
import type { Change } from './history.ts';

/** One layout of the catalogue a number of panels. */
const LAYOUTS = ['splash', 'grid-2', 'grid-3', 'grid-4', 'grid-6'].map(
  (wanted) => core.layouts().find(({ id }) => id === wanted) as Layout,
);
const STYLES = core.styles();

/** A page without photos that is told from others by its seed. */
export function pageOf(seed: number): PageDocument {
  const panel = { photo: null, crop: null, locked: false, edited: false };
  return {
    version: 1,
    seed,
    layout: 'grid-4',
    style: 'comic',
    order: [],
    panels: [panel, panel, panel, panel],
    merges: [],
    page: DEFAULT_SETTINGS,
    words: [],
  };
}

/** What the changes make of an empty project. */
export function edited(...changes: readonly Change[]): Editing {
  const editing = createEditing(core.createEditor());
  changes.forEach(editing.apply);
  return editing;
}

/** Plans as the core does, in the little that the state relies on. */
export function fakePlanner() {
  const requests: PlanRequest[] = [];
  return {
    requests,
    styles: () => [],
    blocks: () => [],
    listLayouts: ({ own }: { own: object[] }) => [
      ...own.map((layout, i) => ({ ...layout, own: i })),
      ...LAYOUTS.map((layout) => ({ ...layout, own: null })),
    ],
    createEditor: core.createEditor,
    carried: core.carried,
    layoutFacts: core.layoutFacts,
    layoutFile: core.layoutFile,
    generateLayout: core.generateLayout,
    changeLayout: core.changeLayout,
    checkLayout: core.checkLayout,
    geometry: () => ({ width: 1, height: 1, panels: [] }),
    choose: (photos: any[]) =>
      photos.map(({ id, twin }) => ({ id, group: 0, kept: !twin, why: twin ? 'same as another' : '' })),
    plan: (request: PlanRequest) => {
      requests.push(request);
      const { seed, photos, page, current, keep, layout, style, panels } = request;
      const wanted = panels ?? photos.length;
      const nearest = LAYOUTS.reduce((best, other) =>
        Math.abs(other.count - wanted) < Math.abs(best.count - wanted) ? other : best,
      );
      const taken = (layout ?? (keep.layout && current ? current.layout : nearest.id)) as any;
      const { count } = core.layoutFacts(taken, page);
      const ids = photos.map((photo) => photo.id);
      const order = keep.photos && current ? current.order.filter((photo) => ids.includes(photo)) : ids;
      return {
        version: 1,
        seed,
        layout: taken,
        style: style ?? (keep.style && current ? current.style : STYLES[seed % STYLES.length].id),
        order,
        panels: Array.from({ length: count }, (_, i) => ({
          photo: order[i % order.length] ?? null,
          crop: null,
          locked: false,
          edited: false,
        })),
        merges: (current && taken === current.layout && current.merges) || [],
        page,
        words: current?.words ?? [],
      };
    },
  };
}

/** @param odd files that cannot be read or that look like another */
export function fakeApp(odd: Record<string, 'bad' | 'twin'> = {}) {
  const store = createStore();
  const planner = fakePlanner();
  store.planner.value = planner as any;
  let seed = 0;
  const pages = createPages(store, () => (seed += 1));
  const messages = createMessages();
  const imported = new Set();
  const engine = {
    facesReady: () => true,
    ready: Promise.resolve(planner),
    importPhoto: async (id: string, { name }: File) => {
      await Promise.resolve();
      if (odd[name] === 'bad') throw Object.assign(new Error('not a photo'), { code: 'unsupported-format' });
      imported.add(id);
      return { ...unreadMeta(id), measures: { twin: odd[name] === 'twin' ? 1 : 0 } };
    },
    forgetPhoto: () => {},
  } as any;
  const reading = createReading({ store, pages, engine, messages });
  const files = (...names: string[]) => names.map((name) => new File(['x'], name));
  return { store, planner, pages, messages, engine, reading, files };
}
