/**
 * Draws the text items of the document to a canvas, one picture per item, so that moving one does not redraw the
 * others. An item waits for its current picture before it requests the next.
 */

import { paintOrder, standsBehind } from '../engine/figures.ts';
import type { PageDocument, Word } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';
import type { BitmapPatch } from '../engine/protocol.ts';

type Sheet = { document: PageDocument; width: number; keys: string[] };

/** Maximum number of cached pictures: enough for a few pages. Pictures of the visible page are always cached. */
const MOST = 80;

export function createWordPainter(
  canvas: HTMLCanvasElement,
  {
    render,
    subjectsOf = () => '',
    onPainted,
    onError,
  }: {
    render: Engine['renderWord'];
    /** a text that changes when the subject masks in front of sound effects change */
    subjectsOf?: (document: PageDocument) => string;
    /** `whole`: all text items are drawn, and none failed. */
    onPainted: (document: PageDocument | null, whole: boolean) => void;
    onError: (error: Error & { code?: string }) => void;
  },
) {
  /** By key, oldest first. */
  const kept: Map<string, BitmapPatch> = new Map();
  /** The last picture of each item, shown until the next one arrives. */
  let shown: (BitmapPatch | null)[] = [];
  const running: Set<number> = new Set();
  /** Text items that failed are not tried again. */
  const failed: Set<string> = new Set();
  let sheet: Sheet | null = null;

  return { show, dispose };

  /** @param width of the page, in pixels of the screen */
  function show(document: PageDocument, width: number) {
    const { words = [], layout, page, style } = document;
    const same =
      sheet &&
      sheet.width === width &&
      JSON.stringify([sheet.document.layout, sheet.document.page]) === JSON.stringify([layout, page]);
    // A new page must not show text items of the previous page in their old positions.
    if (!same || words.length !== sheet?.keys.length) shown = [];
    // Linked balloons are drawn as one shape. Text items without colours use the colours of the style.
    const joined = words.filter(({ id, joined, linked }) => id || joined || linked);
    // A subject in front of a sound effect clips it.
    const before = JSON.stringify([document.panels, document.merges, style, subjectsOf(document)]);
    const key = (word: Word) => [
      word,
      layout,
      page,
      width,
      style,
      (word.id || word.joined || word.linked) && joined,
      standsBehind(word) !== null && before,
    ];
    sheet = { document, width, keys: words.map((word) => JSON.stringify(key(word))) };
    words.forEach((_, i) => request(i));
    paint();
  }

  function request(index: number) {
    const now = sheet;
    if (!now || running.has(index) || index >= now.keys.length) return;
    const key = now.keys[index];
    if (kept.has(key) || failed.has(key)) return;
    running.add(index);
    render(now.document, index, now.width)
      .then(
        (patch) => {
          kept.set(key, patch);
          forget();
        },
        (error) => {
          failed.add(key);
          if (error.code !== 'cancelled') onError(error);
        },
      )
      .finally(() => {
        running.delete(index);
        request(index);
        paint();
      });
  }

  /** Removes the oldest pictures, except pictures of the visible page, which would not be requested again. */
  function forget() {
    const own = new Set(sheet?.keys);
    for (const old of [...kept.keys()]) {
      if (kept.size <= MOST) return;
      if (!own.has(old)) kept.delete(old);
    }
  }

  function paint() {
    if (!sheet) return;
    const { document, width, keys } = sheet;
    const height = Math.max(1, Math.round((width * document.page.height) / document.page.width));
    shown = keys.map((key, i) => kept.get(key) ?? shown[i] ?? null);
    canvas.width = width;
    canvas.height = height;
    const context = canvas.getContext('2d');
    for (const patch of paintOrder(document).map((index) => shown[index])) {
      if (patch) context?.drawImage(patch.bitmap, patch.x, patch.y);
    }
    const done = keys.every((key) => kept.has(key) || failed.has(key));
    onPainted(done ? document : null, done && !keys.some((key) => failed.has(key)));
  }

  function dispose() {
    sheet = null;
    kept.clear();
  }
}
