import fc from 'fast-check';
import { describe, expect, it, vi } from 'vitest';
import { unreadMeta } from '../document/album.ts';
import { createEditing, openEditing } from '../document/editing.ts';
import { DEFAULT_SETTINGS } from '../document/empty.ts';
import { historyOf, pageOf } from '../document/testing.ts';
import { core } from '../engine/testing-core.ts';
import { createJournal } from './journal.ts';
import { documentOf, fakeBrowser } from './testing.ts';
import type { Editing } from '../document/editing.ts';
import type { Change } from '../document/history.ts';

vi.mock('../ui/files.ts', () => ({ save: vi.fn() }));

const photos = ['p0', 'p1', 'p2', 'p3', 'p4', 'p5'].map((id) => unreadMeta(id));
const draw = (value: number) => ({ seed: value });
const crop = (seed: number) => ({ type: 'zoom', factor: 1 + seed / 10 }) as const;
const seed = fc.nat(9);

const plain: fc.Arbitrary<Change> = fc.oneof(
  seed.map((id) => ({ type: 'show-page', page: pageOf(id), pageId: id }) as Change),
  seed.map((id) => ({ type: 'change-page', page: pageOf(id) }) as Change),
  fc.string().map((name) => ({ type: 'rename', name }) as Change),
  fc.nat(5).map((n) => ({ type: 'add-photos', ids: [`p${n}`, `p${n + 1}`] }) as Change),
  fc.nat(5).map((n) => ({ type: 'remove-photos', ids: [`p${n}`] }) as Change),
  fc.nat(5).map((n) => ({ type: 'forget-photos', ids: [`p${n}`] }) as Change),
  fc.nat(5).map((n) => ({ type: 'exchange-photo', id: `p${n}`, by: 'p9' }) as Change),
  seed.map((pageId) => ({ type: 'love-page', pageId, on: pageId % 2 === 0 }) as Change),
  seed.map(
    (text) => ({ type: 'set-words', pages: [{ at: 0, words: [{ kind: 'caption', text: `${text}` }] }] }) as Change,
  ),
  seed.map((n) => ({ type: 'add-words', words: [{ kind: 'caption', text: 'x', photo: `p${n}`, auto: true }] }) as any),
  fc.constant({ type: 'no-page' } as Change),
  fc.constant({ type: 'own-layouts', ownLayouts: [] } as Change),
);
const intent: fc.Arbitrary<Change> = fc.oneof(
  seed.map((n) => ({ type: 'crop-panel', panel: n % 3, crop: crop(n) }) as Change),
  seed.map((n) => ({ type: 'swap-panels', panel: n % 3, with: (n + 1) % 3 }) as Change),
  seed.map((n) => ({ type: 'place-photo', panel: n % 3, photo: `p${n}` }) as Change),
  seed.map((n) => ({ type: 'lock-panel', panel: n % 3, on: n > 4 }) as Change),
  seed.map((n) => ({ type: 'shuffle', part: 'all', draw: draw(n) }) as Change),
  seed.map((n) => ({ type: 'refit', grow: n > 4, draw: draw(n) }) as Change),
  seed.map((n) => ({ type: 'add-page', draw: draw(n) }) as Change),
  seed.map((n) => ({ type: 'go-to-page', at: n % 3 }) as Change),
  seed.map((pageId) => ({ type: 'restore-version', pageId }) as Change),
  fc.constant({ type: 'remove-page' } as Change),
  fc.constant({ type: 'recrop' } as Change),
  fc
    .tuple(seed, fc.boolean())
    .map(([n, held]) => ({ type: 'set-paper', settings: { ...DEFAULT_SETTINGS, gutter: n / 100 }, held }) as Change),
);
const how = fc.constantFrom({}, {}, { silent: true }, { gesture: 'g1' }, { gesture: 'g1' }, { gesture: 'g2' });
const lists = fc.constantFrom([], [{ id: 'x', name: 'x', tags: [], background: [] }]);
const anyChange: fc.Arbitrary<Change> = fc.oneof(
  { weight: 3, arbitrary: fc.tuple(plain, how).map(([change, more]) => ({ ...change, ...more })) },
  { weight: 4, arbitrary: fc.tuple(intent, how).map(([change, more]) => ({ ...change, ...more })) },
  { weight: 1, arbitrary: fc.constantFrom({ type: 'undo' } as Change, { type: 'redo' } as Change) },
  { weight: 1, arbitrary: lists.map((mine) => ({ type: 'share', lists: { mine } }) as any as Change) },
);

/** Applies a change, if the planner can. */
function attempt(editing: Editing, change: Change) {
  try {
    editing.apply(change, photos);
  } catch (error) {
    expect(error).toHaveProperty('code');
  }
}

function begun(): Editing {
  const editing = createEditing(core.createEditor());
  editing.apply({ type: 'add-photos', ids: photos.map(({ id }) => id) });
  editing.apply({ type: 'refit', grow: true, draw: draw(1) }, photos);
  return editing;
}

const boxOf = () => fakeBrowser().local;
const journalOf = (box = boxOf()) => createJournal({ box: () => box });
const entry = (...names: string[]) => ({
  bases: [{ stamp: 's', from: 0 }],
  changes: names.map((name) => JSON.stringify([{ type: 'rename', name }])),
  photos: [],
});

describe('the changes of an editor', () => {
  it('lead to the same history from what was saved, whatever they are, and without measurements', () => {
    fc.assert(
      fc.property(fc.array(anyChange), fc.array(anyChange), fc.array(anyChange), (before, between, after) => {
        const editing = begun();
        before.forEach((change) => attempt(editing, change));
        const first = editing.save();
        between.forEach((change) => attempt(editing, change));
        const second = editing.save();
        after.forEach((change) => attempt(editing, change));
        const end = historyOf(editing);
        const journal = journalOf();
        const changes = editing.since(first.at) as string[];
        const bases = [
          { stamp: 'one', from: 0 },
          { stamp: 'two', from: second.at - first.at },
        ];
        expect(journal.note('id', { bases, changes, photos: [] })).toBe(true);
        for (const [stamp, { bytes }] of [
          ['one', first],
          ['two', second],
        ] as const) {
          const told = journal.recall('id', stamp)?.changes as string[];
          const again = openEditing(core.createEditor(), bytes, told);
          expect(historyOf(again)).toEqual(end);
          expect(again.fresh()).toEqual(editing.fresh());
        }
      }),
    );
  });

  it('include each step of a drag once', () => {
    const editing = begun();
    const { at } = editing.save();
    const page = editing.mirror().present.page as any;
    for (let i = 0; i < 50; i += 1) {
      editing.apply({ type: 'crop-panel', panel: 0, crop: { type: 'zoom', factor: 1.01 }, gesture: 'drag' }, photos);
      // Text is placed after each step.
      const words = [{ kind: 'caption', text: `${i}` } as const];
      editing.apply({ type: 'set-words', pages: [{ at: 0, words }], silent: true });
    }
    expect([editing.since(at)?.length, editing.mirror().undos]).toEqual([2, 3]);
    expect(editing.mirror().present.page).not.toEqual(page);
    // After a save in the middle of a drag, later changes include none before it.
    const middle = editing.save();
    for (let i = 0; i < 50; i += 1)
      editing.apply({ type: 'crop-panel', panel: 1, crop: { type: 'zoom', factor: 1.01 }, gesture: 'drag' }, photos);
    expect([editing.since(at)?.length, editing.since(middle.at)?.length]).toEqual([3, 1]);
    editing.trim(middle.at);
    expect([editing.since(at), editing.since(middle.at)?.length]).toEqual([null, 1]);
    const again = openEditing(core.createEditor(), middle.bytes, editing.since(middle.at) as string[]);
    expect(historyOf(again)).toEqual(historyOf(editing));
  });

  it('have pages in full where a later one includes an earlier one', () => {
    const editing = begun();
    editing.apply({ type: 'add-page', draw: draw(2) }, photos);
    const saved = editing.save();
    editing.apply({ type: 'change-page', page: { ...(editing.mirror().present.page as any), seed: 77 }, silent: true });
    editing.apply({ type: 'go-to-page', at: 0, silent: true });
    const changes = editing.since(saved.at) as string[];
    expect(changes.length).toBe(1);
    expect(historyOf(openEditing(core.createEditor(), saved.bytes, changes))).toEqual(historyOf(editing));
  });

  it('are kept apart where a later one does not include an earlier one', () => {
    const editing = begun();
    const { at } = editing.save();
    editing.apply({ type: 'star-photo', id: 'p0', on: true, gesture: 'g' });
    editing.apply({ type: 'star-photo', id: 'p1', on: true, gesture: 'g' });
    editing.apply({ type: 'rename', name: 'One', gesture: 'g' });
    editing.apply({ type: 'rename', name: 'Two', gesture: 'other' });
    editing.apply({ type: 'rename', name: 'Three', gesture: 'other' });
    expect(editing.since(at)?.map((change) => JSON.parse(change)[0].name)).toEqual([
      undefined,
      undefined,
      'One',
      'Three',
    ]);
  });

  it('begin a new step after loading, also with a gesture of the same name', () => {
    const editing = begun();
    editing.apply({ type: 'rename', name: 'One', gesture: 'g' });
    const { bytes } = editing.save();
    const again = openEditing(core.createEditor(), bytes);
    again.apply({ type: 'rename', name: 'Two', gesture: 'g' });
    expect(again.mirror().undos).toBe(editing.mirror().undos + 1);
    const third = openEditing(core.createEditor(), bytes, again.since(0) as string[]);
    expect(historyOf(third)).toEqual(historyOf(again));
    third.apply({ type: 'rename', name: 'Three', gesture: 'g' });
    const fourth = openEditing(core.createEditor(), bytes, third.since(0) as string[]);
    expect(historyOf(fourth)).toEqual(historyOf(third));
    expect(fourth.mirror().undos).toBe(editing.mirror().undos + 2);
  });
});

describe('a journal', () => {
  it('fits its own project and writing only', () => {
    const journal = journalOf();
    const { changes } = entry('One', 'Two');
    const bases = [
      { stamp: 's1', from: 0 },
      { stamp: 's2', from: 1 },
    ];
    journal.note('one', { bases, changes, photos: [['p9', 'late.jpg']] });
    expect(journal.recall('one', 's1')).toEqual({ changes, photos: [['p9', 'late.jpg']] });
    // Either of the two may have been written.
    expect(journal.recall('one', 's2')?.changes).toEqual(changes.slice(1));
    expect(journal.names('one')).toEqual(['late.jpg']);
    expect(journal.recall('one', 's0')).toBe(null);
    expect(journal.recall('two', 's1')).toBe(null);
    journal.clear('one');
    expect(journal.recall('one', 's1')).toBe(null);
  });

  it('leaves nothing where it cannot tell all', () => {
    const box = boxOf();
    const journal = createJournal({ box: () => box, most: 900 });
    expect(journal.note('one', entry('Short'))).toBe(true);
    expect(journal.note('one', entry('x'.repeat(3000)))).toBe(false);
    expect(journal.recall('one', 's')).toBe(null);
    const refused = createJournal({
      box: () => {
        throw new Error('refused');
      },
    });
    expect([refused.note('one', entry('Short')), refused.recall('one', 's'), refused.names('one')]).toEqual([
      false,
      null,
      [],
    ]);
  });

  it.each([
    ['no JSON', () => '{'],
    ['of another version', (told: any) => ({ ...told, version: 1 })],
    ['without bases', (told: any) => ({ ...told, bases: null })],
    ['with a base that is none', (told: any) => ({ ...told, bases: [null] })],
    ['with changes that are none', (told: any) => ({ ...told, changes: { length: 1 } })],
    ['with too many changes', (told: any) => ({ ...told, changes: Array(10_001).fill([]) })],
    ['with a photo without a name', (told: any) => ({ ...told, photos: [['p1']] })],
    ['that begins before its changes', (told: any) => ({ ...told, bases: [{ stamp: 's', from: -1 }] })],
    ['that begins between its changes', (told: any) => ({ ...told, bases: [{ stamp: 's', from: 0.5 }] })],
  ])('%s is passed over', (_what, spoil) => {
    const box = boxOf();
    const journal = journalOf(box);
    journal.note('one', entry('One'));
    const told = JSON.parse(box.getItem('inkpanel.journal.one') as string);
    const bad = spoil(told);
    box.setItem('inkpanel.journal.one', typeof bad === 'string' ? bad : JSON.stringify(bad));
    expect(journal.recall('one', 's')).toBe(null);
  });

  it('that fits no project any more goes, others stay', async () => {
    const box = boxOf();
    const journal = journalOf(box);
    for (const id of ['one', 'two', 'three']) journal.note(id, entry('One'));
    box.setItem('inkpanel.styles', '[]');
    await journal.tidy(async (id) => ({ one: 's', two: 'other' })[id]);
    expect(Array.from({ length: box.length }, (_, i) => box.key(i))).toEqual([
      'inkpanel.journal.one',
      'inkpanel.styles',
    ]);
  });
});

describe('an edit right before the page closes', () => {
  it('is there after, undo too, and is saved then', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add('a.jpg', 'b.jpg');
    before.pages.shuffle('all');
    before.store.change({ type: 'rename', name: 'Last words' });
    expect(before.asks()).toBe(false);
    const [page, steps] = [before.store.page.value, before.store.mirror.value.undos];

    const after = await browser.died().tab();
    expect([after.store.project.value.name, after.store.page.value, after.store.mirror.value.undos]).toEqual([
      'Last words',
      page,
      steps,
    ]);
    await after.keeping.flush();
    expect(after.keeping.status.value).toBe('saved');
    expect(browser.local.getItem(`inkpanel.journal.${after.keeping.current.value}`)).toBe(null);
    after.pages.undo();
    expect(after.store.project.value.name).toBe('');
  });

  it.each([
    ['arrived', true],
    ['did not arrive', false],
  ])('is there after a crash during another save that %s', async (_what, arrives) => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add('a.jpg');
    before.store.change({ type: 'rename', name: 'One' });
    before.store.change({ type: 'rename', name: 'Two' });
    const key = `inkpanel.journal.${before.keeping.current.value}`;
    const { put } = IDBObjectStore.prototype;
    let entry: string | null = null;
    vi.spyOn(IDBObjectStore.prototype, 'put').mockImplementation(function spied(value: any, name) {
      // @ts-expect-error -- `this` is the table
      const request = put.call(this, value, name);
      if (value.bytes && entry === null) {
        before.store.change({ type: 'rename', name: 'Three' });
        entry = browser.local.getItem(key);
        // @ts-expect-error -- `this` is the table
        if (!arrives) this.transaction.abort();
      }
      return request;
    });
    void before.keeping.flush();
    await vi.waitFor(() => expect(entry).not.toBe(null));
    const wanted = historyOf(before.store.editing());
    await new Promise((resolve) => {
      setTimeout(resolve, 20);
    });
    const later = browser.died();
    vi.restoreAllMocks();
    // The tab died before it knew.
    browser.local.setItem(key, String(entry));
    const after = await later.tab();
    expect(documentOf(after)).toEqual(wanted);
  });

  it('is not there when somebody else has written since', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add('a.jpg');
    const key = `inkpanel.journal.${before.keeping.current.value}`;
    before.store.change({ type: 'rename', name: 'Lost in time' });
    const entry = browser.local.getItem(key) as string;
    before.store.change({ type: 'rename', name: 'Written' });
    await before.keeping.flush();
    browser.local.setItem(key, entry);
    const after = await browser.died().tab();
    expect(after.store.project.value.name).toBe('Written');
  });

  it('is there after, with the drag that it belongs to', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add('a.jpg', 'b.jpg');
    const pan = () =>
      before.pages.edit({ type: 'crop-panel', panel: 0, crop: { type: 'zoom', factor: 1.05 }, gesture: 'drag' });
    for (let i = 0; i < 5; i += 1) pan();
    await before.keeping.flush();
    for (let i = 0; i < 5; i += 1) pan();
    const wanted = documentOf(before);
    const after = await browser.died().tab();
    expect(documentOf(after)).toEqual(wanted);
    after.pages.undo();
    expect(after.store.project.value.page?.panels[0].edited).toBe(false);
  });

  it.each([
    ['a page which cannot be drawn', [[{ type: 'change-page', page: { ...pageOf(1), layout: 'none' } }]]],
    ['a page that is none', [[{ type: 'change-page', page: { panels: [null] } }]]],
    ['photos that are numbers', [[{ type: 'add-photos', ids: [1] }]]],
    ['an intent', [[{ type: 'rename', name: 'Lost' }], [{ type: 'recrop' }]]],
    ['an edit that does not exist', [[{ type: 'rename', name: 'Lost' }, { type: 'explode' }]]],
    ['a number', [7]],
    ['an edit without a list', [{ type: 'rename', name: 'Lost' }]],
  ])('is ignored as a whole with %s, and does not lock the project', async (_what, changes) => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add('a.jpg');
    const key = `inkpanel.journal.${before.keeping.current.value}`;
    const wanted = documentOf(before);
    before.pages.shuffle('all');
    const told = JSON.parse(browser.local.getItem(key) as string);
    const later = browser.died();
    browser.local.setItem(key, JSON.stringify({ ...told, changes }));
    const after = await later.tab();
    expect([after.names(), after.messages.list.value, documentOf(after)]).toEqual([['a.jpg'], [], wanted]);
    await after.keeping.flush();
    expect(after.keeping.status.value).toBe('saved');
  });
});
