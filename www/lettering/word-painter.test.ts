import { expect, it, vi } from 'vitest';
import type { BitmapPatch } from '../engine/protocol.ts';
import type { PageDocument, Word } from '../engine/types.ts';
import { createWordPainter } from './word-painter.ts';

/** A page with these texts. */
function paged(...texts: string[]): PageDocument {
  const words = texts.map((text) => ({ kind: 'caption', text }) as Word);
  return { layout: 'grid-4', page: { width: 100, height: 100 }, style: 'noir', words } as unknown as PageDocument;
}

it.each([
  ['of more words than pictures are kept', [], Array.from({ length: 90 }, (_, i) => `word ${i}`)],
  [
    'whose first word was drawn long ago',
    [['old'], ...Array.from({ length: 80 }, (_, i) => [`between ${i}`])],
    ['old', 'new'],
  ],
])('a page %s is painted in the end', async (_, before, texts) => {
  const canvas = { width: 0, height: 0, getContext: () => null } as unknown as HTMLCanvasElement;
  let painted: PageDocument | null = null;
  const painter = createWordPainter(canvas, {
    render: async () => ({}) as BitmapPatch,
    onPainted: (document) => {
      painted = document;
    },
    onError: (error) => {
      throw error;
    },
  });
  for (const page of [...before, texts].map((words) => paged(...words))) {
    painter.show(page, 100);
    await vi.waitFor(() => expect(painted).toBe(page));
  }
});

it('an effect behind a figure is drawn anew when the crop or the mask before it changes, one in front is not', async () => {
  const canvas = { width: 0, height: 0, getContext: () => null } as unknown as HTMLCanvasElement;
  const render = vi.fn(async () => ({}) as BitmapPatch);
  let mask = '';
  let painted: PageDocument | null = null;
  const painter = createWordPainter(canvas, {
    render,
    subjectsOf: () => mask,
    onPainted: (document) => {
      painted = document;
    },
    onError: () => {},
  });
  const cropped = (x: number) => {
    const words = [true, false].map((behind) => ({ kind: 'effect', text: 'x', panel: 0, behind }) as Word);
    return { ...paged(), panels: [{ photo: 'a', crop: { x } }], merges: [], words } as unknown as PageDocument;
  };
  const shown = async (page: PageDocument) => {
    painter.show(page, 100);
    await vi.waitFor(() => expect(painted).toBe(page));
    return render.mock.calls.length;
  };
  expect(await shown(cropped(0))).toBe(2);
  expect(await shown(cropped(0.1))).toBe(3);
  mask = 'mask';
  expect(await shown(cropped(0.1))).toBe(4);
});
