// Random edits, and the results of the former JavaScript implementation. `tests/editing.rs` expects the same results
// from Rust.
// Run it in a checkout of the commit `Read saved projects in Rust`:
//     node tests/oracles/edits.mjs > tests/oracles/data/edits.json
// Pages are identified by their seeds. All have the same layout and show nothing.

import { EMPTY_HISTORY, advance } from '../../www/document/history.ts';
import { DEFAULT_SETTINGS } from '../../www/document/project.ts';

let state = 1;
const random = () => {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  return state / 2 ** 32;
};
const below = (count) => Math.floor(random() * count);
const one = (list) => list[below(list.length)];
const some = (list) => list.filter(() => random() < 0.4);

const EMPTY = { photo: null, crop: null, locked: false, edited: false };
const page = (seed) => ({
  version: 1, seed, layout: 'grid-4', style: 'comic', order: [], panels: [EMPTY, EMPTY, EMPTY, EMPTY], merges: [], page: DEFAULT_SETTINGS, words: [],
});
const styles = (ids) => ids.map((id) => ({ id, name: id, tags: [], background: [] }));
const settings = (gutter) => ({ ...DEFAULT_SETTINGS, gutter });
let fresh = 0;

// An edit of one photo is written as an edit of several photos since then.
const today = ({ type, id, use, ...rest }) => {
  if (type === 'remove-photo') return { type: 'remove-photos', ids: [id], ...rest };
  if (type === 'use-photo') return { type: 'use-photos', uses: { [id]: use }, ...rest };
  return { type, ...(id === undefined ? {} : { id }), ...rest };
};

const MAKE = {
  'add-photos': () => ({ ids: some(['a', 'b', 'c', 'd']) }),
  'remove-photo': () => ({ id: one(['a', 'b']) }),
  'remove-photos': () => ({ ids: some(['a', 'b', 'c']) }),
  'forget-photos': () => ({ ids: random() < 0.3 ? [one(['a', 'b', 'c', 'd'])] : [] }),
  'use-photo': () => ({ id: one(['a', 'b', 'c']), use: random() < 0.5 }),
  'use-photos': () => ({ uses: Object.fromEntries(some(['a', 'b', 'c']).map((id) => [id, random() < 0.5])) }),
  'exchange-photo': () => ({ id: one(['a', 'b', 'c']), by: `x${(fresh += 1)}` }),
  'choose-by': () => ({ alike: 4 + below(4), order: one(['time', 'name']) }),
  'focus-photo': () => ({ id: one(['a', 'b']), focus: one([null, { x: 0.2, y: 0.7 }]) }),
  lock: () => ({ part: one(['layout', 'style', 'photos']), on: random() < 0.5 }),
  'want-panels': () => ({ count: one([null, 1, 4]) }),
  'show-page': () => ({ page: 1 + below(9), pageId: 1 + below(9) }),
  'change-page': () => ({ page: 20 + below(9) }),
  'change-settings': () => ({ page: 40 + below(9), settings: 0.01 * (1 + below(4)) }),
  'set-sheets': () => {
    const ids = some([1, 2, 3, 4, 5]);
    return { sheets: (ids.length > 0 ? ids : [1]).map((id) => ({ page: id + 60, pageId: id + 10, sheet: id })), at: below(Math.max(1, ids.length)) };
  },
  'no-page': () => ({}),
  design: () => ({ draft: one([null, { id: 'd', name: 'D', tags: [], background: [], foreground: [], ink: '#000000' }]) }),
  'own-styles': () => ({ mine: styles(some(['x', 'y', 'z'])) }),
  favourites: () => ({ favourites: styles(some(['x', 'y', 'z'])) }),
  'love-page': () => ({ pageId: 1 + below(9), on: random() < 0.5 }),
  rename: () => ({ name: one(['', 'One', 'Two']) }),
  styling: () => ({ styling: { invented: one([0, 0.5]), keepLines: random() < 0.5, keepColours: random() < 0.5 } }),
  undo: () => ({}),
  redo: () => ({}),
  share: () => ({ lists: { mine: styles(some(['x', 'y', 'z', 'w'])), ...(random() < 0.5 ? { favourites: styles(some(['x', 'q'])) } : {}) } }),
};
const KINDS = Object.keys(MAKE).concat('undo', 'undo', 'redo', 'show-page', 'show-page', 'add-photos', 'set-sheets');

/** The change as the history takes it. */
function whole(change) {
  const made = { ...change };
  if (change.page) made.page = page(change.page);
  if (change.settings) {
    made.settings = settings(change.settings);
    made.page = { ...made.page, page: made.settings };
  }
  if (change.sheets) made.sheets = change.sheets.map((sheet) => ({ ...sheet, page: page(sheet.page) }));
  if (change.uses) made.uses = new Map(Object.entries(change.uses));
  return made;
}

const runs = [];
for (let run = 0; run < 40; run += 1) {
  let history = EMPTY_HISTORY;
  const changes = [];
  const steps = [];
  for (let i = 0; i < 80; i += 1) {
    const type = one(KINDS);
    const gesture = one([undefined, undefined, 'drag', 'drag', 'other']);
    const change = { type, ...MAKE[type](), ...(gesture ? { gesture } : {}), ...(random() < 0.1 ? { silent: true } : {}) };
    history = advance(history, whole(change));
    changes.push(today(change));
    steps.push([history.past.length, history.future.length, history.present.pageId, history.present.tray.length]);
  }
  let back = history;
  while (back.past.length > 0) back = advance(back, { type: 'undo' });
  const told = ({ page: shown, others, ...rest }) => ({
    ...rest, page: shown?.seed ?? null, others: others.map((sheet) => ({ ...sheet, page: sheet.page.seed })),
  });
  runs.push({
    changes, steps, present: told(history.present), start: told(back.present),
    shown: history.shown.map(({ id, from, sheet = 0, page: { seed } }) => [id, from ?? null, sheet, seed]),
  });
}
process.stdout.write(`[\n${runs.map((run) => JSON.stringify(run)).join(',\n')}\n]\n`);
