import fc from 'fast-check';
import { describe, expect, it, vi } from 'vitest';
import { EMPTY_HISTORY } from '../document/history.ts';
import { openEditing } from '../document/editing.ts';
import { edited, pageOf } from '../document/testing.ts';
import { core } from '../engine/testing-core.ts';
import { createJournal, patchOf } from './journal.ts';
import { fakeBrowser } from './testing.ts';
import type { KeptHistory } from '../engine/core.ts';
import type { Change } from '../document/history.ts';

vi.mock('../ui/files.ts', () => ({ save: vi.fn() }));

const anyChange: fc.Arbitrary<Change> = fc.oneof(
  fc.nat(9).map((id) => ({ type: 'show-page', page: pageOf(id), pageId: id }) as Change),
  fc.nat(99).map((seed) => ({ type: 'change-page', page: pageOf(seed), gesture: `g${seed % 3}` }) as Change),
  fc.string().map((name) => ({ type: 'rename', name }) as Change),
  fc.nat(5).map((n) => ({ type: 'add-photos', ids: [`p${n}`] }) as Change),
  fc.nat(5).map((n) => ({ type: 'remove-photos', ids: [`p${n}`] }) as Change),
  fc.nat(9).map((pageId) => ({ type: 'love-page', pageId, on: pageId % 2 === 0 }) as Change),
  fc.constantFrom({ type: 'undo' } as Change, { type: 'redo' } as Change),
);

const boxOf = () => fakeBrowser().local;
const readHistory = (record: KeptHistory) => openEditing(core.createEditor(), record);
const named = (...names: string[]) => edited(...names.map((name) => ({ type: 'rename', name }) as Change)).history();

describe('a journal', () => {
  it('tells any edits, steps back and forth among them', () => {
    fc.assert(
      fc.property(fc.array(anyChange), fc.array(anyChange), (before, after) => {
        const editing = edited(...before);
        const base = editing.history();
        after.forEach((change) => editing.apply(change));
        const now = editing.history();
        const box = boxOf();
        const journal = createJournal({ box: () => box });
        expect(
          journal.note('one', {
            bases: [{ stamp: 's', history: base }],
            history: now,
            photos: [['p9', 'late.jpg']],
          }),
        ).toBe(true);
        // The database returns equal data, but new objects.
        const found = structuredClone(base);
        expect(journal.recall('one', { stamp: 's', history: found }, readHistory)).toEqual({
          history: now,
          photos: [['p9', 'late.jpg']],
        });
      }),
    );
  });

  it('tells one edit of a long history in few words', () => {
    const editing = edited();
    for (let i = 1; i <= 300; i += 1) editing.apply({ type: 'show-page', page: pageOf(i), pageId: i });
    const before = editing.history();
    const after = editing.apply({ type: 'rename', name: 'Summer' });
    expect(JSON.stringify(patchOf(before, after)).length).toBeLessThan(500);
  });

  it('fits its own project and writing only', () => {
    const box = boxOf();
    const journal = createJournal({ box: () => box });
    const base = { stamp: 's1', history: EMPTY_HISTORY };
    const next = { stamp: 's2', history: named('One') };
    const now = named('One', 'Two');
    journal.note('one', { bases: [base, next], history: now, photos: [] });
    expect(journal.recall('one', base, readHistory)?.history.present.name).toBe('Two');
    // Either of the two may have been written.
    expect(journal.recall('one', next, readHistory)?.history.present.name).toBe('Two');
    expect(journal.recall('one', { ...base, stamp: 's0' }, readHistory)).toBe(null);
    expect(journal.recall('two', base, readHistory)).toBe(null);
    journal.clear('one');
    expect(journal.recall('one', base, readHistory)).toBe(null);
  });

  it('leaves nothing where it cannot tell all', () => {
    const box = boxOf();
    const journal = createJournal({ box: () => box, most: 900 });
    const base = { stamp: 's', history: EMPTY_HISTORY };
    const history = named('Short');
    expect(journal.note('one', { bases: [base], history, photos: [] })).toBe(true);
    const long = named('x'.repeat(3000));
    expect(journal.note('one', { bases: [base], history: long, photos: [] })).toBe(false);
    expect(journal.recall('one', base, readHistory)).toBe(null);
    const refused = createJournal({
      box: () => {
        throw new Error('refused');
      },
    });
    expect([
      refused.note('one', { bases: [base], history, photos: [] }),
      refused.recall('one', base, readHistory),
      refused.names('one'),
    ]).toEqual([false, null, []]);
  });

  it.each([
    ['no JSON', () => '{'],
    ['of another version', (entry: any) => ({ ...entry, version: 2 })],
    ['without bases', (entry: any) => ({ ...entry, bases: null })],
    ['with a photo without a name', (entry: any) => ({ ...entry, photos: [['p1']] })],
    [
      'that tells of states that are not there',
      (entry: any) => {
        entry.bases[0].patch.present = 7;
        return entry;
      },
    ],
    [
      'that repeats without end',
      (entry: any) => {
        entry.bases[0].patch.past = [[0, 1e9]];
        return entry;
      },
    ],
    [
      'with a page that is none',
      (entry: any) => {
        entry.bases[0].patch.states[0].page = { panels: [null] };
        return entry;
      },
    ],
    [
      'with a tray of numbers',
      (entry: any) => {
        entry.bases[0].patch.states[0].tray = [1];
        return entry;
      },
    ],
  ])('%s is passed over', (_what, spoil) => {
    const box = boxOf();
    const journal = createJournal({ box: () => box });
    const base = { stamp: 's', history: EMPTY_HISTORY };
    journal.note('one', {
      bases: [base],
      history: named('One'),
      photos: [],
    });
    const entry = JSON.parse(box.getItem('inkpanel.journal.one') as string);
    const bad = spoil(entry);
    box.setItem('inkpanel.journal.one', typeof bad === 'string' ? bad : JSON.stringify(bad));
    expect(journal.recall('one', base, readHistory)).toBe(null);
  });

  it('that fits no project any more goes, others stay', async () => {
    const box = boxOf();
    const journal = createJournal({ box: () => box });
    const history = named('One');
    for (const id of ['one', 'two', 'three'])
      journal.note(id, { bases: [{ stamp: 's', history: EMPTY_HISTORY }], history, photos: [] });
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
    const [page, steps] = [before.store.page.value, before.store.history.value.past.length];

    const after = await browser.died().tab();
    expect([after.store.project.value.name, after.store.page.value, after.store.history.value.past.length]).toEqual([
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

  it('is there after when another save was on its way', async () => {
    for (const arrives of [true, false]) {
      const browser = fakeBrowser();
      const before = await browser.tab();
      await before.add('a.jpg');
      before.store.change({ type: 'rename', name: 'One' });
      const { put } = IDBObjectStore.prototype;
      let edited = false;
      vi.spyOn(IDBObjectStore.prototype, 'put').mockImplementation(function spied(value: any, key) {
        // @ts-expect-error -- `this` is the table
        const request = put.call(this, value, key);
        if (value.history && !edited) {
          edited = true;
          before.store.change({ type: 'rename', name: 'Two' });
          // @ts-ignore
          if (!arrives) this.transaction.abort();
        }
        return request;
      });
      void before.keeping.flush();
      await vi.waitFor(() => expect(edited).toBe(true));
      await new Promise((resolve) => {
        setTimeout(resolve, 20);
      });
      const later = browser.died();
      vi.restoreAllMocks();
      const after = await later.tab();
      expect(after.store.project.value.name).toBe('Two');
    }
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

  it('that makes a page which cannot be drawn does not lock the project', async () => {
    const browser = fakeBrowser();
    const before = await browser.tab();
    await before.add('a.jpg');
    const key = `inkpanel.journal.${before.keeping.current.value}`;
    before.pages.shuffle('all');
    const entry = JSON.parse(browser.local.getItem(key) as string);
    const at = entry.bases[0].patch.states.findIndex(({ page: one }: any) => one);
    entry.bases[0].patch.states[at].page.layout = 'none';
    const later = browser.died();
    browser.local.setItem(key, JSON.stringify(entry));
    const after = await later.tab();
    expect([after.names(), after.messages.list.value]).toEqual([['a.jpg'], []]);
    await after.keeping.flush();
    expect(after.keeping.status.value).toBe('saved');
  });
});
