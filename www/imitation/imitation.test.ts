import { signal } from '@preact/signals';
import { describe, expect, it, vi } from 'vitest';
import { createImitation } from './imitation.ts';

const file = (name: string) => new File(['x'], name);
const fault = (code: string, message = code) => Object.assign(new Error(message), { code });

function app({
  readLook = async () => 'look',
  photos = 3,
}: {
  readLook?: () => Promise<string>;
  photos?: number;
} = {}) {
  const ends: AbortSignal[] = [];
  const engine = {
    importPhoto: vi.fn(async () => ({})),
    forgetPhoto: vi.fn(),
    readLook: vi.fn(readLook),
    surveyLooks: vi.fn((_id: string, { signal: end }: any) => {
      ends.push(end);
      return Promise.reject(fault('imitation-missing'));
    }),
    imitate: vi.fn(async (_look: string, _id: string, { onProgress, signal: end }: any) => {
      ends.push(end);
      onProgress(0.5);
      await new Promise((done) => {
        setTimeout(done, 2);
      });
      return [1, 2, 3].map((i) => ({ id: `imitated-${i}`, name: 'After Comic', tags: [], background: [], score: 0.5 }));
    }),
  };
  const messages = { alert: vi.fn() };
  const ui = { work: signal(null) };
  let [ids, seeds] = [0, 0];
  const imitation = createImitation({
    store: { tray: signal(Array.from({ length: photos })) },
    engine,
    messages,
    ui,
    seed: () => (seeds += 1),
    freshId: () => `my-${(ids += 1)}`,
  } as any);
  return { imitation, engine, messages, ui, ends };
}

describe('a style from a picture', () => {
  it('proposes styles named after the picture, under ids of their own, and shows the first', async () => {
    const { imitation, ui, engine } = app();
    imitation.take([file('page 12.png')]);
    expect(ui.work.value).toBe('imitation');
    await imitation.search('p1');
    expect(imitation.proposals.value.map(({ id, name }) => [id, name])).toEqual([
      ['my-1', 'Like page 12 1'],
      ['my-2', 'Like page 12 2'],
      ['my-3', 'Like page 12 3'],
    ]);
    expect(imitation.proposals.value[0]).not.toHaveProperty('score');
    expect(imitation.shown.value).toBe('my-1');
    expect(imitation.progress.value).toBeNull();
    expect(engine.forgetPhoto).toHaveBeenCalledOnce();
  });

  it('reads a picture once, however often it is searched for', async () => {
    const { imitation, engine } = app();
    imitation.take([file('a.png')]);
    await imitation.search('p1');
    await imitation.search('p2');
    expect(engine.readLook).toHaveBeenCalledOnce();
    expect(engine.imitate.mock.calls.map(([look, id, { seed }]) => [look, id, seed])).toEqual([
      ['look', 'p1', 1],
      ['look', 'p2', 2],
    ]);
  });

  it('says in the words of the page why there is nothing to imitate, and lets the picture go', async () => {
    const { imitation, engine } = app({ readLook: () => Promise.reject(fault('plain-photo')) });
    imitation.take([file('a.jpg')]);
    await imitation.search('p1');
    expect(imitation.fault.value).toMatch(/^This looks like a plain photo/);
    expect(imitation.doubted.value).toBe(true);
    imitation.insist('p1');
    await vi.waitFor(() => expect(imitation.progress.value).toBeNull());
    expect(engine.readLook.mock.calls.map((call: any) => call[1].anyway)).toEqual([false, true]);
    engine.forgetPhoto.mockClear();
    await imitation.search('p1');
    expect(imitation.proposals.value).toEqual([]);
    expect(engine.forgetPhoto).toHaveBeenCalledOnce();
    const other = app({ readLook: () => Promise.reject(fault('new', 'A sentence of the core.')) });
    other.imitation.take([file('a.jpg')]);
    await other.imitation.search('p1');
    expect(other.imitation.fault.value).toBe('A sentence of the core.');
  });

  it('gives each picture an id of its own, as workers keep the pixels of the one before', async () => {
    const { imitation, engine } = app();
    for (const name of ['a.png', 'b.png']) {
      imitation.take([file(name)]);
      await imitation.search('p1');
    }
    const ids = engine.importPhoto.mock.calls.map(([id]: any) => id);
    expect(new Set(ids).size).toBe(2);
    expect([engine.readLook, engine.forgetPhoto].map(({ mock }: any) => mock.calls.map(([id]: any) => id))).toEqual([
      ids,
      ids,
    ]);
  });

  it('keeps what was found when the next search is stopped', async () => {
    const { imitation, ends } = app();
    imitation.take([file('a.png')]);
    await imitation.search('p1');
    const before = imitation.proposals.value;
    const again = imitation.search('p1');
    await Promise.resolve();
    expect(imitation.progress.value).not.toBeNull();
    imitation.stop();
    await again;
    expect(ends.at(-1)?.aborted).toBe(true);
    expect([imitation.proposals.value, imitation.progress.value, imitation.fault.value]).toEqual([before, null, null]);
  });

  it('prepares searches on a photo until it is ended, and leaves what fails to the search', async () => {
    const { imitation, engine, ends } = app();
    const end = imitation.prepare('p1');
    expect(engine.surveyLooks.mock.calls[0][0]).toBe('p1');
    await Promise.resolve();
    expect([imitation.fault.value, imitation.progress.value, ends[0].aborted]).toEqual([null, null, false]);
    end();
    expect(ends[0].aborted).toBe(true);
  });

  it('asks for photos first', () => {
    const { imitation, messages, ui } = app({ photos: 0 });
    imitation.take([file('a.png')]);
    imitation.open();
    expect([ui.work.value, messages.alert.mock.calls.length]).toEqual([null, 2]);
  });
});
