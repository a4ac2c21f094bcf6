// @ts-check
/**
 * Keeps the page's canvas true to the document. Panels are rendered one by one; a page in another layout appears
 * at once when all of its panels are there, or after a moment with those that are, so that a shuffle neither
 * flickers nor waits. While a length is dragged the old pictures follow the new geometry until the new ones come.
 */

import { drawPage, sheetSize } from './drawing.js';
import { onlyMoved, sameLook, sameShape } from './likeness.js';
import { createPatches } from './patches.js';

/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('../engine/documents.js').Geometry} Geometry */
/** @typedef {import('./patches.js').Patch} Patch */

/**
 * `signature` says everything the picture of a panel depends on.
 * @typedef {{ signature: string, patch: Patch | null, coarse: Patch | null, older: Patch | null, failed: boolean }} Slot
 * @typedef {{ document: PageDocument, geometry: Geometry, width: number, slots: Slot[] }} Sheet
 */

/** A new layout is shown with what there is after this time, in ms. */
const PATIENCE = 120;
/** A page that will take longer than this, in ms, is first drawn at half the size. */
const COARSE_ABOVE = 100;

/**
 * @param {HTMLCanvasElement} canvas
 * @param {{
 *   engine: Pick<import('../engine/engine.js').Engine, 'renderPanel' | 'hasPhoto'>,
 *   onPainted: (document: PageDocument | null) => void, onError: (error: Error & { code?: string }) => void,
 * }} options
 */
export function createPainter(canvas, { engine, onPainted, onError }) {
  const patches = createPatches(engine.renderPanel);
  /** @type {Sheet | null} */
  let sheet = null;
  /** What is on the canvas. @type {Sheet | null} */
  let visible = null;
  /** What is being drawn of each panel, by its place: a hand that moves it waits for that picture before the next. @type {Map<number, string>} */
  const running = new Map();
  let frame = 0;
  /** @type {any} */
  let timer;

  return { show, dispose };

  /**
   * @param {PageDocument} document
   * @param {Geometry} geometry
   * @param {number} width of the page on the screen, in its pixels
   * @param {boolean} [follow] whether the layout is changed by hand, so that the pictures follow its panels
   */
  function show(document, geometry, width, follow = false) {
    const old = sheet;
    sheet = { document, geometry, width, slots: [] };
    const near = old !== null && (sameShape(old.document, document) || (follow && onlyMoved(old, geometry)));
    sheet.slots = document.panels.map((_, i) => slotOf(/** @type {Sheet} */ (sheet), i, near ? old : null));
    const moving = near && sameLook(/** @type {Sheet} */ (old).document, document);
    const wanted = sheet.slots.map(({ signature }) => signature);
    if (!moving) running.clear();
    patches.keepOnly([...wanted, ...running.values()]);
    const slow = patches.expected(document, width) > COARSE_ABOVE;
    sheet.slots.forEach((slot, index) => request(/** @type {Sheet} */ (sheet), slot, index, slow));
    clearTimeout(timer);
    if (!visible || (moving && sameLook(visible.document, document)) || complete(sheet)) paintSoon();
    else timer = setTimeout(paintSoon, PATIENCE);
    report();
  }

  /**
   * @param {Sheet} of
   * @param {number} index
   * @param {Sheet | null} near the sheet before where its panels are the same ones
   * @returns {Slot}
   */
  function slotOf({ document, geometry, width }, index, near) {
    const signature = patches.signature(document, geometry, index, width);
    const before = near?.slots[index];
    if (before?.signature === signature) return { ...before, failed: false };
    const older = before ? before.patch ?? before.coarse ?? before.older : null;
    return { signature, patch: patches.cached(signature), coarse: null, older, failed: false };
  }

  /**
   * @param {Sheet} from
   * @param {Slot} slot
   * @param {number} index
   * @param {boolean} slow
   */
  function request(from, slot, index, slow) {
    const { photo } = from.document.panels[index];
    if (slot.patch || photo === null || !engine.hasPhoto(photo)) return;
    const before = running.get(index);
    if (before !== undefined && before !== slot.signature) return;
    running.set(index, slot.signature);
    if (slow && !slot.coarse && !slot.older) {
      patches.coarse(from.document, from.geometry, index, from.width).then((patch) => {
        if (!slot.patch && from === sheet) arrive(slot, { coarse: patch });
      }, () => {});
    }
    patches.get(slot.signature, from.document, from.geometry, index, from.width).then(
      (patch) => {
        if (stale(slot, index)) follow(index, patch);
        // The sheet may have been replaced by one that wants the very same picture.
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

  /**
   * Whether a picture came for a panel that has moved on meanwhile.
   * @param {Slot} slot
   * @param {number} index
   */
  function stale({ signature }, index) {
    if (running.get(index) !== signature) return false;
    running.delete(index);
    return sheet !== null && sheet.slots[index] !== undefined && sheet.slots[index].signature !== signature;
  }

  /**
   * Shows the picture in the place of the one before, and asks for what is wanted by now.
   * @param {number} index
   * @param {Patch | null} patch
   */
  function follow(index, patch) {
    const now = /** @type {Sheet} */ (sheet);
    const slot = now.slots[index];
    if (patch && !slot.patch) arrive(slot, { older: patch });
    request(now, slot, index, false);
  }

  /**
   * @param {Slot} slot
   * @param {Partial<Slot>} news
   */
  function arrive(slot, news) {
    Object.assign(slot, news);
    if (sheet && (visible === sheet || complete(sheet))) paintSoon();
    report();
  }

  /** @param {Sheet} of @returns {boolean} whether nothing more is to come */
  function complete(of) {
    return of.slots.every((slot, i) => {
      const { photo } = of.document.panels[i];
      return slot.patch || slot.failed || photo === null || !engine.hasPhoto(photo);
    });
  }

  function paintSoon() {
    clearTimeout(timer);
    frame ||= requestAnimationFrame(paint);
  }

  function paint() {
    frame = 0;
    if (!sheet) return;
    visible = sheet;
    const { width, height } = sheetSize(sheet);
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    const context = canvas.getContext('2d');
    if (context) drawPage(context, sheet);
    report();
  }

  function report() {
    const done = sheet !== null && sheet === visible && frame === 0 && complete(sheet);
    onPainted(done ? /** @type {Sheet} */ (sheet).document : null);
  }

  function dispose() {
    cancelAnimationFrame(frame);
    clearTimeout(timer);
    patches.dispose();
    sheet = null;
  }
}
