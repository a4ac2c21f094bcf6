/** A planner and an engine of a few lines, for the tests of the state: no pixels, no wasm. */

import { unreadMeta } from './album.ts';
import { createMessages } from '../app/messages.ts';
import { createPages } from './pages.ts';
import { createReading } from '../photos/reading.ts';
import { createStore } from './store.ts';
import type { PlanRequest } from '../engine/documents.ts';

const LAYOUTS = [1, 2, 3, 4, 6].map((count) => ({
  id: `l${count}`,
  name: `${count}`,
  family: 'rows',
  aspect: 1,
  count,
  panels: [],
}));

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
    layoutFacts: (layout: any) => {
      const id = layout.id ?? layout;
      const count = Number(id.slice(1));
      return { id, base: count, count, good: true, editable: true, adjacent: count > 1 ? [[0, 1]] : [], cuts: [] };
    },
    layoutFile: (layout: any) => (layout.id ? layout : { id: layout }),
    generateLayout: ({ least, most }: any) => ({ id: `g${(least + most) >> 1}`, family: 'generated' }),
    changeLayout: (layout: any, change: any) => {
      const count = Number((layout.id ?? layout).slice(1));
      return { id: `c${count + ({ split: 1, remove: -1 }[change.type as string] ?? 0)}`, family: 'custom', change };
    },
    checkLayout: (json: string, file: string) => {
      const layout = JSON.parse(json);
      if (!layout.id) throw Object.assign(new Error(`layout ${file}: id: is missing`), { code: 'invalid-layout' });
      return layout;
    },
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
      const count = Number((taken.id ?? taken).slice(1));
      const ids = photos.map((photo) => photo.id);
      const order = keep.photos && current ? current.order.filter((photo) => ids.includes(photo)) : ids;
      return {
        version: 1,
        seed,
        layout: taken,
        style: style ?? (keep.style && current ? current.style : `s${seed}`),
        order,
        panels: Array.from({ length: count }, (_, i) => ({ photo: order[i % order.length], crop: null })),
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
