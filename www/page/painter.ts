/**
 * Draws the document to the page's canvas. Panels are rendered one by one. A new layout appears when all of its panels
 * are rendered, or after a short time with the finished ones. So Shuffle neither flickers nor waits. While a length is
 * dragged, the old pictures follow the new geometry until the new ones arrive.
 */

import { drawPage, sheetSize } from './drawing.ts';
import { panelOf, picturesOf } from '../engine/figures.ts';
import { onlyMoved, sameLook, sameShape } from './likeness.ts';
import { createPatches } from './patches.ts';
import { mentionsPainter } from '../engine/painters.ts';
import { createTimer } from '../engine/scheduler.ts';
import type { Thumbnail } from '../engine/photo-header.ts';
import type { Geometry, PageDocument } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';
import type { Patch } from './patches.ts';

/** `signature` contains everything that affects the picture of a panel. */
export type Slot = {
  signature: string;
  patch: Patch | null;
  coarse: Patch | null;
  older: Patch | null;
  failed: boolean;
};
export type Sheet = { document: PageDocument; geometry: Geometry; width: number; slots: Slot[] };

/** Maximum time in ms that a new layout waits for all of its panels. */
const PATIENCE = 120;
/** Pages with a longer expected time, in ms, are first drawn at half size. */
const COARSE_ABOVE = 100;

export function createPainter(
  canvas: HTMLCanvasElement,
  {
    engine,
    onPainted,
    onError,
  }: {
    engine: Pick<Engine, 'renderPictures' | 'hasPhoto'> & {
      subjectOf?: (document: PageDocument, photo: string) => string | undefined;
      modelsOf?: (document: PageDocument) => string;
      isDraft?: (photo: string) => boolean;
      /** A small image of a photo that is not read yet. */
      thumbnailOf?: (photo: string) => Thumbnail | undefined;
    };
    /** `whole`: all panels are drawn, and none failed. */
    onPainted: (document: PageDocument | null, whole: boolean) => void;
    onError: (error: Error & { code?: string }) => void;
  },
) {
  const patches = createPatches(engine.renderPictures, engine.subjectOf, engine.modelsOf, engine.isDraft);
  let sheet: Sheet | null = null;
  /** The content of the canvas. */
  let visible: Sheet | null = null;
  /** Panels that are being drawn, by index. During a drag, the next picture of a panel waits for the current one. */
  const running: Map<number, string> = new Map();
  let frame = 0;
  const timer = createTimer();

  return { show, prepare, forget: patches.forget, dispose };

  /**
   * @param width of the page on the screen, in its pixels
   * @param follow whether the user changes the layout manually, so that the pictures follow its panels
   */
  function show(document: PageDocument, geometry: Geometry, width: number, follow: boolean = false) {
    const old = sheet;
    sheet = { document, geometry, width, slots: [] };
    const near = old !== null && (sameShape(old.document, document) || (follow && onlyMoved(old, geometry)));
    sheet.slots = picturesOf(document).map((i) => slotOf(sheet as Sheet, i, near ? old : null));
    const moving = near && sameLook((old as Sheet).document, document);
    const wanted = sheet.slots.map(({ signature }) => signature);
    if (!moving) running.clear();
    patches.keepOnly([...wanted, ...running.values()]);
    // The block Painter takes as long at half size.
    const slow = patches.expected(document, width) > COARSE_ABOVE && !mentionsPainter(document.style);
    sheet.slots.forEach((slot, index) => request(sheet as Sheet, slot, index, slow));
    timer.stop();
    // A page that was drawn in advance appears in this frame, not in the one after the next.
    if (visible && !near && complete(sheet)) paint();
    else if (!visible || (moving && sameLook(visible.document, document)) || complete(sheet)) paintSoon();
    else timer.start(PATIENCE, paintSoon);
    report();
  }

  /**
   * Draws the panels of a likely next page with the lowest priority. The next page that is shown or prepared cancels it.
   * @returns whether all panels are drawn
   */
  async function prepare(document: PageDocument, geometry: Geometry, width: number): Promise<boolean> {
    const pictures = picturesOf(document).map((index) => {
      return { index, signature: patches.signature(document, geometry, index, width) };
    });
    const visible = (sheet?.slots ?? []).map(({ signature }) => signature);
    patches.keepOnly([...visible, ...running.values(), ...pictures.map(({ signature }) => signature)]);
    const jobs = pictures.flatMap(({ index, signature }) => {
      const { photo } = document.panels[panelOf(document, index)];
      if (photo === null || !engine.hasPhoto(photo) || patches.cached(signature)) return [];
      return patches.get(signature, document, geometry, index, width, true);
    });
    // Errors are reported when the page is shown.
    return (await Promise.allSettled(jobs)).every(({ status }) => status === 'fulfilled');
  }

  /** @param near the sheet before where its panels are the same ones */
  function slotOf({ document, geometry, width }: Sheet, index: number, near: Sheet | null): Slot {
    const signature = patches.signature(document, geometry, index, width);
    const before = near?.slots[index];
    if (before?.signature === signature) return { ...before, failed: false };
    const older = before ? (before.patch ?? before.coarse ?? before.older) : null;
    return { signature, patch: patches.cached(signature), coarse: null, older, failed: false };
  }

  function request(from: Sheet, slot: Slot, index: number, slow: boolean) {
    const { photo } = from.document.panels[panelOf(from.document, index)];
    if (slot.patch || photo === null || !engine.hasPhoto(photo)) return;
    const before = running.get(index);
    if (before !== undefined && before !== slot.signature) return;
    running.set(index, slot.signature);
    if (slow && !slot.coarse && !slot.older) {
      patches.coarse(from.document, from.geometry, index, from.width).then(
        (patch) => {
          if (!slot.patch && from === sheet) arrive(slot, { coarse: patch });
        },
        () => {},
      );
    }
    patches.get(slot.signature, from.document, from.geometry, index, from.width).then(
      (patch) => {
        if (stale(slot, index)) follow(index, patch);
        // A new sheet may need the same picture.
        const wanted = sheet?.slots.find((other) => other.signature === slot.signature);
        if (wanted) arrive(wanted, { patch });
      },
      (error) => {
        if (stale(slot, index)) follow(index, null);
        if (error.code === 'cancelled' || from !== sheet) return;
        arrive(slot, { failed: true });
        onError(error);
      },
    );
  }

  /** Returns whether a picture arrived for a panel that changed meanwhile. */
  function stale({ signature }: Slot, index: number) {
    if (running.get(index) !== signature) return false;
    running.delete(index);
    return sheet !== null && sheet.slots[index] !== undefined && sheet.slots[index].signature !== signature;
  }

  /** Shows the new picture of a panel, and requests the picture for its current state. */
  function follow(index: number, patch: Patch | null) {
    const now = sheet as Sheet;
    const slot = now.slots[index];
    if (patch && !slot.patch) arrive(slot, { older: patch });
    request(now, slot, index, false);
  }

  function arrive(slot: Slot, news: Partial<Slot>) {
    Object.assign(slot, news);
    if (sheet && (visible === sheet || complete(sheet))) paintSoon();
    report();
  }

  /** @returns whether all pictures are final */
  function complete(of: Sheet): boolean {
    return of.slots.every((slot, i) => {
      const { photo } = of.document.panels[panelOf(of.document, i)];
      return slot.patch || slot.failed || photo === null || !engine.hasPhoto(photo);
    });
  }

  function paintSoon() {
    timer.stop();
    frame ||= requestAnimationFrame(paint);
  }

  function paint() {
    cancelAnimationFrame(frame);
    frame = 0;
    if (!sheet) return;
    visible = sheet;
    const { width, height } = sheetSize(sheet);
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    const context = canvas.getContext('2d');
    if (context) drawPage(context, sheet, engine.thumbnailOf);
    report();
  }

  function report() {
    const done = sheet !== null && sheet === visible && frame === 0 && complete(sheet);
    onPainted(done ? (sheet as Sheet).document : null, done && !(sheet as Sheet).slots.some(({ failed }) => failed));
  }

  function dispose() {
    cancelAnimationFrame(frame);
    timer.stop();
    patches.dispose();
    sheet = null;
  }
}
