import { beforeEach, describe, expect, it, vi } from 'vitest';
import { save as saveFile } from '../ui/files.ts';
import { readArchive } from '../engine/archive.ts';
import { openDatabase } from './database.ts';
import { bytesOf, encoded, recordIn } from '../engine/interned.ts';
import { documentOf, earlier, fakeBrowser } from './testing.ts';
import type { Database } from './database.ts';
import type { Tab } from './files/testing-pages.ts';

vi.mock('../ui/files.ts', () => ({ save: vi.fn() }));

let browser: ReturnType<typeof fakeBrowser>;
let base: Database;
/** The id of the open project in storage. */
let id: string;
let before: ReturnType<typeof documentOf>;

const said = (tab: Tab) => tab.messages.list.value.map(({ text }) => text);

/** The tab that made it has died. */
async function later(of?: Parameters<ReturnType<typeof fakeBrowser>['tab']>[0]) {
  return fakeBrowser(browser).tab(of);
}

async function spoil(
  table: 'projects' | 'states' | 'facts' | 'photos',
  change: (record: any) => any,
  key: string = id,
) {
  const record: any = await base.get(table, key);
  await base.put(table, change(table === 'states' ? earlier(record) : record));
}

beforeEach(async () => {
  vi.mocked(saveFile).mockClear();
  browser = fakeBrowser();
  const tab = await browser.tab();
  await tab.add('a.jpg', 'b.jpg');
  tab.store.change({ type: 'rename', name: 'Trip' });
  tab.pages.shuffle('all');
  tab.keeping.drawn();
  await tab.keeping.flush();
  before = documentOf(tab);
  id = tab.keeping.current.value;
  base = await openDatabase();
});

const present = (record: any, fields: any) => ({
  ...record,
  history: { ...record.history, present: { ...record.history.present, ...fields } },
});

/** Replaces all records of a table, except the drawn states, as if the tab that made them had died. Records of states are as an earlier version wrote them. */
async function spoilAll(table: 'projects' | 'states' | 'facts' | 'photos', change: (record: any) => any) {
  for (const record of await base.getAll(table)) {
    const { id: key } = record;
    if (table === 'states' && (key === 'orphans' || key.startsWith('drawn '))) continue;
    const other = change(table === 'states' ? earlier(record as any) : record);
    if (other === undefined) await base.delete(table, key);
    else await base.put(table, other);
  }
}

const onPage = (record: any, fields: any) => present(record, { page: { ...record.history.present.page, ...fields } });

/** Damage in a state that a version of the app could save. */
const DAMAGED_STATES: [string, (record: any) => any][] = [
  [
    'settings without a width',
    (record) => present(record, { settings: { ...record.history.present.settings, width: null } }),
  ],
  ['an empty merge', (record) => onPage(record, { merges: [null] })],
  ['a number as a text', (record) => onPage(record, { words: [{ kind: 'caption', text: 5, panel: 0 }] })],
  [
    'a thousand text items',
    (record) => onPage(record, { words: Array(1000).fill({ kind: 'caption', text: 'MORE', panel: 0 }) }),
  ],
  ['a fractional similarity', (record) => present(record, { alike: 10.5 })],
];

/** The bytes of a record as objects again: the damage of a state in a record of today. */
const inBytes =
  (change: (record: any) => any) =>
  (record: any): any => {
    const { history, ...rest } = change(record);
    return { ...rest, version: 2, bytes: bytesOf({ version: 1, history }) };
  };

const asBytes = inBytes((record) => record);

const bytesWith = (change: (history: any) => any) => (record: any) => {
  const whole = asBytes(record);
  const kept = recordIn(whole.bytes);
  return { ...whole, bytes: encoded({ ...kept, history: change(kept.history) }) };
};

/** Damage of the bytes in a record. */
const DAMAGED_BYTES: [string, (record: any) => any][] = [
  ['no bytes', ({ history: _, ...record }) => ({ ...record, version: 2 })],
  ['an object as bytes', ({ history: _, ...record }) => ({ ...record, version: 2, bytes: { length: 5 } })],
  ['bytes of text', ({ history: _, ...record }) => ({ ...record, version: 2, bytes: new Uint8Array([111, 110]) })],
  [
    'bytes that are not UTF-8',
    ({ history: _, ...record }) => ({ ...record, version: 2, bytes: new Uint8Array([255]) }),
  ],
  [
    'the first half of its bytes',
    (record) => {
      const whole = asBytes(record);
      return { ...whole, bytes: whole.bytes.slice(0, whole.bytes.length / 2) };
    },
  ],
  [
    'a page that is not in the table',
    bytesWith((history) => ({ ...history, present: { ...history.present, page: 99 } })),
  ],
  ['no tables', bytesWith(({ parts: _, ...history }) => history)],
];

function circular(record: any) {
  const round = { ...record };
  round.history = { past: [round], present: round, future: [], shown: [] };
  return round;
}

const empty = ({ id: key }: any) => ({ id: key });
const deleted = () => undefined;

const DAMAGE: ['projects' | 'states' | 'facts' | 'photos', string, (record: any) => any][] = [
  ...DAMAGED_STATES.flatMap(([name, change]): typeof DAMAGE => [
    ['states', name, change],
    ['states', `${name}, in bytes`, inBytes(change)],
  ]),
  ...DAMAGED_BYTES.map(([name, change]) => ['states', name, change] as (typeof DAMAGE)[number]),
  ['states', 'bytes and a newer version', (record) => ({ ...asBytes(record), version: 99 })],
  ['states', 'nothing', empty],
  ['states', 'no record', deleted],
  ['states', 'no history', (record) => ({ ...record, history: null })],
  ['states', 'a history of text', (record) => ({ ...record, history: 'once upon a time' })],
  ['states', 'no version', (record) => ({ ...record, version: undefined })],
  ['states', 'a newer version', (record) => ({ ...record, version: 99 })],
  ['states', 'no present', (record) => ({ ...record, history: { ...record.history, present: 7 } })],
  [
    'states',
    'a present of bytes',
    (record) => ({ ...record, history: { ...record.history, present: new Uint8Array(9) } }),
  ],
  ['states', 'a circular history', circular],
  ['states', 'a tray of holes', (record) => present(record, { tray: [null, 5] })],
  ['states', 'a page of empty panels', (record) => onPage(record, { panels: [null, null] })],
  ['states', 'an unknown layout', (record) => onPage(record, { layout: 'no such layout' })],
  ['states', 'an unknown style', (record) => onPage(record, { style: { block: 'none' } })],
  ['states', 'a BigInt', (record) => present(record, { alike: 10n })],
  ['states', 'wrong types of videos and facts', (record) => ({ ...record, facts: 5, videos: [null, { key: 1 }] })],
  ['projects', 'nothing', empty],
  ['projects', 'no record', deleted],
  [
    'projects',
    'wrong types',
    ({ id: key }) => ({
      id: key,
      name: 5,
      created: 'x',
      changed: {},
      stamp: {},
      photos: null,
      picture: 'none',
      refs: 7,
      gone: null,
    }),
  ],
  ['projects', 'invalid times', (record) => ({ ...record, changed: NaN, created: 1e300 })],
  ['facts', 'nothing', empty],
  ['facts', 'no record', deleted],
  [
    'facts',
    'a photo without sides',
    (record) => ({ ...record, fact: { ...record.fact, meta: { ...record.fact.meta, width: 0 } } }),
  ],
  ['facts', 'an invalid name', (record) => ({ ...record, fact: { ...record.fact, name: 5 } })],
  ['photos', 'nothing', empty],
  ['photos', 'no record', deleted],
  ['photos', 'wrong types', ({ id: key }) => ({ id: key, name: 5, file: 'x', work: 7, small: [] })],
  ['photos', 'copies without planes', (record) => ({ ...record, work: { key: 1 }, small: {} })],
];

describe('a damaged database', () => {
  it.each(DAMAGE)('with records of %s that have %s: the app starts and lists the project', async (table, _, change) => {
    await spoilAll(table, change);
    const tab = await later();
    await vi.waitFor(() => expect(tab.store.reading.value).toBe(null));
    expect(tab.keeping.running.value).toBe(false);
    if (tab.names().length > 0) {
      await tab.keeping.flush();
      expect(tab.keeping.status.value).toBe('saved');
    }
    await tab.keeping.refresh();
    expect(tab.keeping.list.value.length).toBeGreaterThan(0);
  });

  it.each([
    ...DAMAGED_STATES,
    ...DAMAGED_STATES.map(
      ([name, change]) => [`${name}, in bytes`, inBytes(change)] as (typeof DAMAGED_STATES)[number],
    ),
    ...DAMAGED_BYTES,
  ])('with a state that has %s: the last good version is restored', async (what, change) => {
    await spoilAll('states', change);
    const tab = await later();
    const why = what.startsWith('a thousand text items') ? 'too-large-project' : 'damaged-project';
    expect(tab.keeping.broken.value).toMatchObject({ id, name: 'Trip', why, back: true });
    expect(await tab.keeping.goBack()).toBe(true);
    expect(documentOf(tab).present).toEqual(before.present);
    await tab.keeping.flush();
    expect(tab.keeping.status.value).toBe('saved');
    const again = await later();
    expect([documentOf(again).present, again.keeping.broken.value]).toEqual([before.present, null]);
  });
});

describe('a project of an earlier version', () => {
  it('opens with its undo steps and pages, and is saved as bytes', async () => {
    await spoilAll('states', (record) => record);
    const tab = await later();
    expect([documentOf(tab), tab.names(), tab.keeping.broken.value]).toEqual([before, ['a.jpg', 'b.jpg'], null]);
    tab.pages.undo();
    tab.pages.undo();
    expect(tab.store.project.value.name).toBe('');
    await tab.keeping.flush();
    expect(await base.get('states', id)).toMatchObject({ version: 2, bytes: expect.any(Uint8Array) });
    expect(await base.get('states', id)).not.toHaveProperty('history');
    expect(documentOf(await later())).toEqual(documentOf(tab));
  });

  it('is renamed and copied in the list', async () => {
    const tab = await later();
    await tab.keeping.create();
    await spoilAll('states', (record) => record);
    await tab.keeping.refresh();
    expect(await tab.keeping.rename(id, 'Lisbon')).toBe(true);
    const copy = await tab.keeping.duplicate(id);
    expect(await tab.keeping.open(String(copy))).toBe(true);
    expect(tab.store.project.value.name).toBe('Lisbon copy');
    tab.pages.undo();
    expect(tab.store.project.value.name).toBe('Lisbon');
  });
});

describe('a project that cannot be read', () => {
  it('is told, and goes back to what was drawn last; its photos stay for good', async () => {
    await spoil('states', (record) => present(record, { tray: [null] }));
    const tab = await later();
    expect([tab.names(), tab.keeping.running.value, said(tab)]).toEqual([[], false, []]);
    expect(tab.keeping.broken.value).toMatchObject({ id, name: 'Trip', why: 'damaged-project', back: true });
    expect((await base.get('projects', id))?.held?.length).toBe(2);
    expect(await tab.keeping.goBack()).toBe(true);
    expect([tab.keeping.broken.value, documentOf(tab).present, said(tab)]).toEqual([
      null,
      before.present,
      ['The last good version of Trip was restored.'],
    ]);
    await tab.keeping.flush();
    const again = await later();
    expect([documentOf(again).present, again.keeping.broken.value]).toEqual([before.present, null]);
    expect((await base.get('projects', id))?.held?.length).toBe(2);
  });

  it('is told again when the page is loaded again, until something else was made', async () => {
    await spoil('states', () => ({ id, version: 1 }));
    const { session, keeping } = await later();
    expect(keeping.broken.value?.id).toBe(id);
    const second = await later({ session });
    expect(second.keeping.broken.value?.id).toBe(id);
    await second.add('c.jpg');
    const third = await later({ session });
    expect([third.keeping.broken.value, third.names()]).toEqual([null, ['c.jpg']]);
  });

  it("opens in no other project's place", async () => {
    await spoil('states', (record) => present(record, { alike: 'ten' }));
    const tab = await later();
    await tab.add('c.jpg');
    const [mine, now] = [tab.keeping.current.value, documentOf(tab)];
    expect(await tab.keeping.open(id)).toBe(false);
    expect([tab.keeping.current.value, documentOf(tab), tab.keeping.broken.value?.id]).toEqual([mine, now, id]);
    // No tab holds the lock.
    expect(await tab.keeping.goBack()).toBe(true);
    expect([tab.keeping.current.value, tab.names()]).toEqual([id, ['a.jpg', 'b.jpg']]);
  });

  it('of which nothing else is left has no way back, and says so', async () => {
    await base.clear('states');
    await base.put('states', { id, version: 1, history: 'lost', facts: [] } as any);
    const tab = await later();
    expect(tab.keeping.broken.value?.back).toBe(false);
  });

  it('of which the last drawn state is spoilt, too, goes back to the one before', async () => {
    await spoil(
      'states',
      (record) => ({ ...record, drawn: [...record.drawn, { ...record.drawn[0], name: 'Other', alike: null }] }),
      `drawn ${id}`,
    );
    await spoil('states', () => ({ id }));
    const tab = await later();
    expect(await tab.keeping.goBack()).toBe(true);
    expect(tab.store.project.value.name).toBe('Trip');
  });

  it.each([
    ['a state that is text', (record: any) => ({ ...record, history: 'once upon a time' })],
    ['a state of a newer version', (record: any) => ({ ...record, version: 99 })],
    ['a state of nothing', () => ({ id })],
    ['bytes of text', () => ({ id, version: 2, bytes: new TextEncoder().encode('once upon a time'), facts: [] })],
    [
      'bytes of a state with a page that is not in the table',
      bytesWith((history) => ({ ...history, present: { ...history.present, page: 99 } })),
    ],
  ])('is saved as a file with its photos: %s', async (_, change) => {
    await spoil('states', change);
    const tab = await later();
    await tab.keeping.saveBroken();
    const [blob, name] = vi.mocked(saveFile).mock.calls[0];
    expect(name).toBe('Trip.inkpanel');
    const entries = await readArchive(new File([blob], name));
    expect([...entries.keys()]).toEqual([
      'project.json',
      expect.stringMatching(/a\.jpg/),
      expect.stringMatching(/b\.jpg/),
    ]);
    const text = await (await entries.get('project.json')?.read())?.text();
    const kept = (await base.get('states', id)) as any;
    const words = kept.bytes && new TextDecoder().decode(kept.bytes);
    if (words) expect(text).toContain(words.startsWith('{') ? '"layout"' : words);
    for (const part of [kept.history, kept.bytes ? undefined : kept.version].filter(
      (value) => typeof value !== 'object' && value !== undefined,
    ))
      expect(text).toContain(String(part));
  });
});

describe('the list of projects', () => {
  it.each([
    [
      'another kind of everything',
      (record: any) => ({
        id: record.id,
        name: 5,
        created: 'x',
        changed: {},
        stamp: {},
        photos: null,
        picture: 'none',
        refs: 7,
        gone: null,
      }),
    ],
    ['times that are none', (record: any) => ({ ...record, changed: NaN, created: 1e300 })],
    ['nothing', ({ id: key }) => ({ id: key })],
  ])('shows a record of %s, which opens, is copied and deleted', async (_, change) => {
    await spoil('projects', change);
    const tab = await later();
    await tab.keeping.refresh();
    expect(
      tab.keeping.list.value.map((entry) => [entry.id, Number.isFinite(entry.changed), typeof entry.name]),
    ).toEqual([[id, true, 'string']]);
    expect(tab.names()).toEqual(['a.jpg', 'b.jpg']);
    await tab.keeping.create();
    const copy = await tab.keeping.duplicate(id);
    expect(await tab.keeping.open(String(copy))).toBe(true);
    await tab.keeping.remove(id);
    await tab.keeping.refresh();
    expect(tab.keeping.list.value.map((entry) => entry.id)).toEqual([copy]);
  });

  it('shows a project whose record was lost, and none that is not a project', async () => {
    await base.clear('projects');
    for (const key of [5, new Date(0), ['x']]) await base.put('projects', { id: key, gone: null } as any);
    const tab = await later();
    await tab.keeping.refresh();
    expect(tab.keeping.list.value.map((entry) => entry.id)).toEqual([id]);
    expect(tab.names()).toEqual(['a.jpg', 'b.jpg']);
    tab.store.change({ type: 'rename', name: 'Found' });
    await tab.keeping.flush();
    expect((await base.get('projects', id))?.name).toBe('Found');
  });
});

describe('what lies beside the document', () => {
  it.each([
    ['facts of nothing', 'facts', (record: any) => ({ id: record.id })],
    [
      'a photo without sides',
      'facts',
      (record: any) => ({ ...record, fact: { ...record.fact, meta: { ...record.fact.meta, width: 0 } } }),
    ],
    ['copies without planes', 'photos', (record: any) => ({ ...record, work: { key: 1 }, small: {} })],
  ])('%s: the photo is read again from its file', async (_, table, change) => {
    const [key] = (await base.get('states', id))?.facts ?? [];
    await spoil(table as 'facts', change, key);
    const tab = await later();
    await vi.waitFor(() => expect(tab.decoded).toEqual(['a.jpg']));
    await vi.waitFor(() => expect(tab.store.reading.value).toBe(null));
    expect([tab.names(), tab.store.facts.value.every(({ meta }) => (meta?.width ?? 0) > 0)]).toEqual([
      ['a.jpg', 'b.jpg'],
      true,
    ]);
  });

  it('a photo of nothing is missing and named, and the rest is there', async () => {
    const [key] = (await base.get('states', id))?.facts ?? [];
    await spoil('photos', (record) => ({ id: record.id, name: 5, file: 'x', work: 7 }), key);
    const tab = await later();
    await vi.waitFor(() => expect(tab.store.reading.value).toBe(null));
    expect([tab.names(), tab.store.facts.value.map(({ absent }) => !!absent), tab.keeping.broken.value]).toEqual([
      ['a.jpg', 'b.jpg'],
      [true, false],
      null,
    ]);
    expect(said(tab).join()).toContain('a.jpg');
  });
});

describe('a project that the views cannot draw', () => {
  const views = () => ({ drawn: vi.fn(async () => {}), retry: vi.fn() });

  it('is taken back while it is tried, and nothing of it was saved', async () => {
    const eyes = views();
    const tab = await later({ views: eyes });
    await tab.keeping.files.save();
    const [blob] = vi.mocked(saveFile).mock.calls[0];
    const now = documentOf(tab);
    eyes.drawn.mockImplementation(async () => {
      expect(tab.keeping.current.value).not.toBe(id);
      // Longer than autosave waits.
      await new Promise((resolve) => {
        setTimeout(resolve, 600);
      });
      throw new Error('a view that cannot');
    });
    await tab.keeping.files.open(new File([blob], 'trap.inkpanel'));
    expect([documentOf(tab), tab.keeping.current.value, tab.keeping.status.value]).toEqual([now, id, 'saved']);
    expect(said(tab).at(-1)).toContain('trap.inkpanel could not be opened');
    expect([await base.count('projects'), eyes.retry.mock.calls.length]).toEqual([1, 3]);
    eyes.drawn.mockImplementation(async () => {});
    tab.store.change({ type: 'rename', name: 'On' });
    await tab.keeping.flush();
    expect((await base.getAll('projects')).map(({ name }) => name)).toEqual(['On']);
  });

  it('by an edit goes back to the last state that they could', async () => {
    const tab = await later({ views: views() });
    tab.keeping.drawn();
    tab.store.change({ type: 'rename', name: 'Trap' });
    tab.keeping.failedToShow(new Error('a view that cannot'));
    expect(tab.keeping.broken.value).toMatchObject({
      id,
      name: 'Trap',
      why: '',
      detail: 'a view that cannot',
      back: true,
    });
    expect(await tab.keeping.goBack()).toBe(true);
    await tab.keeping.flush();
    expect([tab.store.project.value.name, tab.keeping.current.value, (await base.get('projects', id))?.name]).toEqual([
      'Trip',
      id,
      'Trip',
    ]);
  });
});
