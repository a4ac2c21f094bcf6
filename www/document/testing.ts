/** The core with a catalogue and verdicts that a test foresees, and an engine of a few lines: no pixels. */

import { unreadMeta } from './album.ts';
import { createMessages } from '../ui/messages.ts';
import { createEditing } from './editing.ts';
import { createPages } from './pages.ts';
import { DEFAULT_SETTINGS } from './empty.ts';
import { createReading } from '../photos/reading.ts';
import { core } from '../engine/testing-core.ts';
import { expanded, recordIn } from '../engine/interned.ts';
import { createScheduler } from '../engine/scheduler.ts';
import { createStore } from './store.ts';
import type { History, Layout, PageDocument, PhotoMeta, VerdictReason } from '../engine/types.ts';
import type { Editing } from './editing.ts';
import type { Store } from './store.ts';
import type { Change } from './history.ts';

/** One layout of the catalogue a number of panels. */
const LAYOUTS = ['splash', 'grid-2', 'grid-3', 'grid-4', 'grid-6'].map(
  (wanted) => core.layouts().find(({ id }) => id === wanted) as Layout,
);

/** The intents that plan a page. */
const INTENTS = [
  'compose',
  'recrop',
  'recrop-photo',
  'shuffle',
  'choose-layout',
  'choose-style',
  'fit-layout',
  'refit',
];

/** A page without photos, identified by its seed. */
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

/** Applies changes to an empty project. */
export function edited(...changes: readonly Change[]): Editing {
  const editing = createEditing(core.createEditor());
  changes.forEach((change) => editing.apply(change));
  return editing;
}

/** The complete history in an editor, as plain data. */
export function historyOf(editing: Editing | null): History {
  return expanded(recordIn((editing ?? edited()).save().bytes).history);
}

/** The core, with a record of its calls. */
export function fakePlanner() {
  /** Planner requests and intents, the latest last. */
  const wishes: any[] = [];
  const planner = {
    ...core,
    wishes,
    /** The photos in use that the last was planned from. */
    used: [] as readonly PhotoMeta[],
    /** Replaces a page that the core planned, or that an intent would make the current page. */
    planned: null as ((page: PageDocument, wish: any) => PageDocument) | null,
    styles: () => [],
    blocks: () => [],
    listLayouts: ({ own }: { own: object[] }) => [
      ...own.map((layout, i) => ({ ...layout, own: i })),
      ...LAYOUTS.map((layout) => ({ ...layout, own: null })),
    ],
    createEditor: () => {
      const editor = core.createEditor();
      const plans = (photos: readonly PhotoMeta[]) => {
        const all = editor.plans(photos);
        const page = (wish: Parameters<typeof all.page>[0]) => {
          wishes.push(wish);
          planner.used = photos;
          return replaced(all.page(wish), wish);
        };
        return { ...all, page };
      };
      const replaced = (page: PageDocument | null, wish: any) =>
        page && planner.planned ? planner.planned(page, wish) : page;
      const preview = (text: string, photos: readonly PhotoMeta[]) => {
        const intent = JSON.parse(text);
        wishes.push(intent);
        planner.used = photos;
        return replaced(editor.preview(text, photos), intent);
      };
      const apply = (text: string, photos?: readonly PhotoMeta[]) => {
        const { silent, gesture, ...intent } = JSON.parse(text);
        if (!INTENTS.includes(intent.type)) return editor.apply(text, photos);
        if (!planner.planned || !photos) {
          wishes.push(intent);
          planner.used = photos ?? [];
          return editor.apply(text, photos);
        }
        const page = preview(JSON.stringify(intent), photos);
        if (!page) return editor.apply(text, photos);
        return editor.apply(JSON.stringify({ type: 'change-page', page, silent, gesture }));
      };
      return { ...editor, plans, preview, apply };
    },
    geometry: () => ({ width: 1, height: 1, panels: [] }),
    choose: (photos: any[]) =>
      photos.map(({ id, twin }) => {
        const reason: VerdictReason = twin ? { code: 'same-as', name: 'another' } : { code: 'only' };
        return { id, group: 0, kept: !twin, why: '', reason };
      }),
  };
  return planner;
}

/** Sorts the photos by name, because the default order is random. */
export function orderByName({ store }: { store: Pick<Store, 'change'> }) {
  store.change({ type: 'choose-by', order: 'name', silent: true });
}

/**
 * @param odd files that cannot be read, that are damaged or that look like another
 * @param detects whether faces are detected
 */
export function fakeApp(
  odd: Record<string, 'bad' | 'damaged' | 'coarse' | 'twin'> = {},
  hooks: Parameters<typeof createPages>[1] = {},
  detects = false,
) {
  const store = createStore();
  const planner = fakePlanner();
  store.planner.value = planner as any;
  let seed = 0;
  const pages = createPages(store, { seed: () => (seed += 1), ...hooks });
  const messages = createMessages();
  const imported = new Set();
  const engine: any = {
    facesReady: () => true,
    ready: Promise.resolve(planner),
    files: new Map() as Map<string, File>,
    importPhoto: async (id: string, file: File) => {
      const { name } = file;
      engine.files.set(id, file);
      await Promise.resolve();
      if (odd[name] === 'bad') throw Object.assign(new Error('not a photo'), { code: 'unknown-format' });
      imported.add(id);
      const damage =
        { damaged: { missing: 0.124, coarse: 0 }, coarse: { missing: 0, coarse: 0.001 } }[odd[name] as string] ?? null;
      return { ...unreadMeta(id), damage, measures: { twin: odd[name] === 'twin' ? 1 : 0 } };
    },
    importDraft: () => null,
    isDraft: () => false,
    forgetPhoto: () => {},
  } as any;
  const reading = createReading({ store, pages, engine, messages, detects });
  const files = (...names: string[]) => names.map((name) => new File(['x'], name, { lastModified: 0 }));
  return { store, planner, pages, messages, engine, reading, files, scheduler: createScheduler() };
}
