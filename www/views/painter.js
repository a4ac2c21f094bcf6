// @ts-check
/**
 * Keeps the page's canvas true to the document. Panels are rendered one by one; a page in another layout appears
 * at once when all of its panels are there, or after a moment with those that are, so that a shuffle neither
 * flickers nor waits. While a length is dragged the old pictures follow the new geometry until the new ones come.
 */

import { drawPage, sheetSize } from './drawing.js';
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
    patches.keepOnly(sheet.slots.map(({ signature }) => signature));
    const slow = patches.expected(document, width) > COARSE_ABOVE;
    sheet.slots.forEach((slot, index) => request(/** @type {Sheet} */ (sheet), slot, index, slow));
    clearTimeout(timer);
    if (!visible || (near && sameLook(visible.document, document)) || complete(sheet)) paintSoon();
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
    if (slow && !slot.coarse && !slot.older) {
      patches.coarse(from.document, index, from.width).then((patch) => {
        if (!slot.patch && from === sheet) arrive(slot, { coarse: patch });
      }, () => {});
    }
    patches.get(slot.signature, from.document, index, from.width).then(
      (patch) => {
        // The sheet may have been replaced by one that wants the very same picture.
        const wanted = sheet?.slots.find((other) => other.signature === slot.signature);
        if (wanted) arrive(wanted, { patch });
      },
      (error) => {
        if (error.code === 'cancelled' || from !== sheet) return;
        arrive(slot, { failed: true });
        onError(error);
      },
    );
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

/**
 * @param {PageDocument} a
 * @param {PageDocument} b
 * @returns {boolean} whether the panels of both are the same ones, so that their pictures can follow each other
 */
function sameShape(a, b) {
  return JSON.stringify([a.layout, a.merges]) === JSON.stringify([b.layout, b.merges]);
}

/**
 * @param {Sheet} old
 * @param {Geometry} geometry
 * @returns {boolean} whether there are as many panels as before
 */
function onlyMoved({ slots }, { panels }) {
  return slots.length === panels.length;
}

/**
 * @param {PageDocument} a
 * @param {PageDocument} b
 * @returns {boolean} whether only lengths and colours differ, which must follow the hand at once
 */
function sameLook(a, b) {
  const photos = (/** @type {PageDocument} */ { panels }) => panels.map(({ photo }) => photo);
  return JSON.stringify([a.style, photos(a)]) === JSON.stringify([b.style, photos(b)]);
}
