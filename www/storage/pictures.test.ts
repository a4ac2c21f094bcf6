import { signal } from '@preact/signals';
import { afterEach, expect, test, vi } from 'vitest';
import { createPictures } from './pictures.ts';

afterEach(() => vi.unstubAllGlobals());

function app(pages: readonly object[]) {
  vi.stubGlobal(
    'OffscreenCanvas',
    class {
      getContext = () => null;
      convertToBlob = async () => new Blob();
    },
  );
  const sheets = signal(pages);
  const drawn: object[] = [];
  const kept: object[] = [];
  const table = { get: async () => ({ id: 'a' }), put: async (project: object) => void kept.push(project) };
  const finished: (() => void)[] = [];
  const pictures = createPictures({
    store: { sheets, place: signal({ id: 'a' }), reading: signal(null) } as any,
    engine: {
      renderPage: async (page: object) => {
        drawn.push(page);
        return { bitmap: { width: 3, height: 4 } };
      },
    } as any,
    scheduler: { background: (job: () => Promise<void>) => void job().then(() => finished.pop()?.()) } as any,
    database: async () => ({ transaction: () => ({ store: table, done: Promise.resolve() }) }) as any,
    onDrawn: () => {},
  });
  const later = () =>
    new Promise<void>((resolve) => {
      finished.push(resolve);
      pictures.later();
    });
  return { sheets, drawn, kept, later };
}

test('a project shows its first page, whatever page is open', async () => {
  const [cover, end] = [{ at: 'cover' }, { at: 'end' }];
  const { sheets, drawn, kept, later } = app([cover, end]);
  await later();
  expect(drawn).toEqual([cover]);
  expect(kept).toEqual([{ id: 'a', picture: expect.any(Blob) }]);
  // Another page changed.
  sheets.value = [cover, { at: 'new end' }];
  await later();
  expect(drawn).toEqual([cover]);
  sheets.value = [{ at: 'new cover' }, end];
  await later();
  expect(drawn).toEqual([cover, { at: 'new cover' }]);
});

test('a project without pages gets no picture', async () => {
  const { drawn, later } = app([]);
  await later();
  expect(drawn).toEqual([]);
});
