import { beforeEach, describe, expect, it, vi } from 'vitest';
import { openDatabase } from './database.ts';
import { createLocks } from './locks.ts';
import { sweep } from './sweeping.ts';
import { fakeBrowser } from './testing.ts';
import type { Database } from './database.ts';

vi.mock('../ui/files.ts', () => ({ save: vi.fn() }));

const HOUR = 3600 * 1000;

let tab: Awaited<ReturnType<ReturnType<typeof fakeBrowser>['tab']>>;
let base: Database;
/** Deletes unused data at a time in hours from now. */
let sweptAt: (hours: number) => Promise<string[]>;

beforeEach(async () => {
  const browser = fakeBrowser();
  tab = await browser.tab();
  await tab.add('a.jpg', 'b.jpg');
  base = await openDatabase();
  const locks = createLocks(browser.locks as any);
  sweptAt = async (hours) => {
    await sweep(base, locks, Date.now() + hours * HOUR);
    return (await base.getAll('photos')).map(({ name }) => name).sort();
  };
});

/** The project needs its first photo only. */
async function release(change: (record: any) => any = (record) => ({ ...record, refs: record.refs.slice(0, 1) })) {
  const [project] = await base.getAll('projects');
  await base.put('projects', change(project));
}

describe('photos', () => {
  it('that nobody needs are kept for a day', async () => {
    await release();
    expect(await sweptAt(0)).toEqual(['a.jpg', 'b.jpg']);
    expect(await sweptAt(23)).toEqual(['a.jpg', 'b.jpg']);
    expect(await sweptAt(25)).toEqual(['a.jpg']);
    expect(await base.count('facts')).toBe(1);
  });

  it('that are needed again have a whole day from the next time that they are not', async () => {
    await release();
    await sweptAt(0);
    tab.store.change({ type: 'rename', name: 'Again' });
    await tab.keeping.flush();
    await release();
    expect(await sweptAt(25)).toEqual(['a.jpg', 'b.jpg']);
    expect(await sweptAt(48)).toEqual(['a.jpg', 'b.jpg']);
    expect(await sweptAt(50)).toEqual(['a.jpg']);
  });

  it('of a state that could not be opened stay as long as its project, and go with it', async () => {
    await release((record) => ({ ...record, refs: [], held: record.refs }));
    expect([await sweptAt(0), await sweptAt(100)]).toEqual([
      ['a.jpg', 'b.jpg'],
      ['a.jpg', 'b.jpg'],
    ]);
    tab.store.change({ type: 'rename', name: 'Saved since' });
    await tab.keeping.flush();
    await release((record) => ({ ...record, refs: [] }));
    expect([await sweptAt(0), await sweptAt(100)]).toEqual([
      ['a.jpg', 'b.jpg'],
      ['a.jpg', 'b.jpg'],
    ]);
  });

  it.each([
    ['refs of another kind', (record: any) => ({ ...record, refs: 7 })],
    ['refs that are no keys', (record: any) => ({ ...record, refs: [{}] })],
    ['nothing but its id', ({ id }: any) => ({ id })],
  ])('of a project with %s are those that its state names', async (_, change) => {
    await base.put('photos', { id: 'other', name: 'other.jpg', file: null, work: null, small: null });
    await release(change);
    expect(await sweptAt(0)).toEqual(['a.jpg', 'b.jpg', 'other.jpg']);
    expect(await sweptAt(25)).toEqual(['a.jpg', 'b.jpg']);
  });

  it('all stay while one project cannot be read at all', async () => {
    await release(({ id }) => ({ id }));
    const [state] = (await base.getAll('states')).filter(({ bytes }) => bytes);
    await base.put('states', { id: state.id, facts: 'none' } as any);
    expect([await sweptAt(0), await sweptAt(100)]).toEqual([
      ['a.jpg', 'b.jpg'],
      ['a.jpg', 'b.jpg'],
    ]);
  });

  it('stay where the list of projects lost the one that needs them', async () => {
    await base.clear('projects');
    expect([await sweptAt(0), await sweptAt(100)]).toEqual([
      ['a.jpg', 'b.jpg'],
      ['a.jpg', 'b.jpg'],
    ]);
  });

  it('stay when the clock was wrong for a while', async () => {
    await release();
    await sweptAt(1000);
    expect(await sweptAt(0)).toEqual(['a.jpg', 'b.jpg']);
    expect(await sweptAt(23)).toEqual(['a.jpg', 'b.jpg']);
  });
});
