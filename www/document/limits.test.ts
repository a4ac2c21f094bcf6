import { describe, expect, it } from 'vitest';
import { fakeApp } from './testing.ts';
import { createLettering } from '../lettering/lettering.ts';
import { MOST, wellFormed } from './limits.ts';
import { createShelves } from '../storage/shelves.ts';
import { anchored } from '../lettering/word-places.ts';

/** A page with the lettering tools. */
async function lettered() {
  const app = fakeApp();
  await app.reading.addFiles(app.files('a.jpg', 'b.jpg'));
  const letters = { settle: (page: any) => page.words, measure: () => [] };
  const lettering = createLettering({
    store: app.store,
    messages: app.messages,
    scheduler: app.scheduler,
    selection: { panels: { peek: () => [] } } as any,
    load: async () => letters as any,
  });
  return { ...app, lettering };
}

const word = { kind: 'caption', text: 'x' } as const;
const styles = (count: number, of: string) =>
  Array.from({ length: count }, (_, i) => ({ id: `${of}${i}`, background: [] }) as any);

describe('what the page itself can write is readable again', () => {
  it('words of a page are bounded, and it is said', async () => {
    const { lettering, messages } = await lettered();
    expect(await lettering.addAll(Array.from({ length: MOST.words - 1 }, () => word))).toBe(MOST.words - 1);
    expect(messages.list.value).toEqual([]);
    expect(await lettering.addAll([word, word, word])).toBe(1);
    expect(lettering.words.value.length).toBe(MOST.words);
    expect(messages.list.value.map(({ text }) => text)).toEqual([expect.stringContaining('200')]);
    expect([await lettering.add('balloon'), lettering.words.value.length]).toEqual([false, MOST.words]);
  });

  it('halves of letters are none, and a text has an end', async () => {
    const { lettering } = await lettered();
    await lettering.addAll([word]);
    lettering.write(0, 'a\ud800b\udc00 \u{1f600}');
    expect(lettering.words.value[0].text).toBe('a\ufffdb\ufffd \u{1f600}');
    lettering.write(0, '\u{1f600}'.repeat(12_000));
    expect([...lettering.words.value[0].text].length).toBe(MOST.letters);
    expect(wellFormed('\udc00\ud800')).toBe('\ufffd\ufffd');
  });

  it('a word beside a narrow panel stays within reach of it', () => {
    const geometry = {
      width: 1,
      height: 1,
      panels: [{ bounds: { x: 0.9, y: 0, width: 0.02, height: 1 }, overlay: false, halo: 0 }],
      order: [0],
    };
    const { x, tail } = anchored(geometry, { kind: 'balloon', text: 'x', panel: 0 }, [0.1, 0.5], [0, 0.5]);
    expect([x, tail?.x]).toEqual([-MOST.away, -MOST.away]);
  });

  it('photos of a project are bounded, and it is said', async () => {
    const { store, reading, messages, files } = fakeApp();
    store.change({ type: 'add-photos', ids: Array.from({ length: MOST.photos - 1 }, (_, i) => `q${i}`) });
    await reading.addFiles(files('a.jpg', 'b.jpg'));
    expect(store.tray.value.length).toBe(MOST.photos);
    expect(messages.list.value.map(({ text }) => text)).toEqual([expect.stringContaining('5,000')]);
  });

  it('so are those of this browser', () => {
    const { store, messages } = fakeApp();
    Object.assign(store.planner.value as any, { checkStyle: JSON.parse });
    const shelves = createShelves({
      store,
      messages,
      box: () => ({ getItem: () => JSON.stringify(styles(3_000, 's')), setItem: () => {} }),
    });
    shelves.recall();
    expect(store.project.value.mine.length).toBe(MOST.styles);
  });
});
