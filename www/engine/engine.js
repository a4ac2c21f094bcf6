// @ts-check
/**
 * The engine: everything that makes pixels, behind promises. It knows nothing of the page that uses it, so that
 * benchmarks and other sites use the same.
 */

import { createAesthetics } from './aesthetics.js';
import { loadCore } from './core.js';
import { createDesign } from './design.js';
import { createDetector } from './detector.js';
import { createExports } from './export.js';
import { createFiles } from './files.js';
import { createMeasures } from './measures.js';
import { createPhotos } from './photos.js';
import { createPool } from './pool.js';
import { Priority } from './queue.js';
import { createRenders, nameOf } from './renders.js';
import { readVideo } from './video.js';
import { givesWebp } from './webp.js';
import { createWords } from './words.js';

/** @typedef {import('./documents.js').PageDocument} PageDocument */
/** @typedef {{ signal?: AbortSignal, priority?: number, key?: string }} Call */
/** @typedef {ReturnType<typeof createEngine>} Engine */

const MOST_WORKERS = 8;
/** Photos that all workers together keep at hand, in bytes. */
const PHOTO_BUDGET = 256 * 2 ** 20;
const LEAST_BUDGET = 64 * 2 ** 20;

/**
 * @param {{ workers?: number }} [options] `workers`: as many as the device has cores unless told, 8 at most
 */
export function createEngine({ workers = navigator.hardwareConcurrency || 2 } = {}) {
  const size = Math.max(1, Math.min(MOST_WORKERS, Math.floor(workers)));
  const photos = createPhotos();
  const detector = createDetector(photos, (count) => pool?.spare(count));
  const design = createDesign(photos);
  const words = createWords();
  const files = createFiles();
  /** @type {ReturnType<typeof createPool> | undefined} */
  let pool;
  let imported = 0;

  const ready = loadCore().then(({ module, planner }) => {
    const budget = Math.max(LEAST_BUDGET, PHOTO_BUDGET / size);
    pool = createPool({ size, spawn: () => spawn(module, budget) });
    design.prepare(() => spawn(module, LEAST_BUDGET));
    return planner;
  });
  // Whoever awaits it is told; nobody has to.
  ready.catch(() => {});

  const renders = createRenders({ run, photos, words });
  const aesthetics = createAesthetics({ run, photos });

  return {
    /** Resolves to the planner, whose functions are synchronous. */
    ready,
    /** @returns {Promise<import('./documents.js').Block[]>} */
    blocks: async () => (await ready).blocks(),
    /** @returns {Promise<import('./documents.js').Layout[]>} */
    layouts: async () => (await ready).layouts(),
    /** @returns {Promise<import('./documents.js').Style[]>} */
    styles: async () => (await ready).styles(),
    stylize, compose, select, detect, dispose, importPhoto, importVideo,
    /** Subjects of an imported photo, in fractions of it. */
    loadDetectors: detector.load, findFaces: detector.findFaces, findMoreFaces: detector.findMoreFaces, findObjects: detector.findObjects,
    forgetPhoto: photos.forget, hasPhoto: photos.has, photos,
    lettering: words.lettering,
    ...renders,
    judges: aesthetics.judges, judgeStyle: aesthetics.judgeStyle,
    drawDesign: design.draw,
    ...createExports({ run, photos, words, files }), ...createMeasures({ run, renders, files }), givesWebp,
  };

  /**
   * @param {import('./pool.js').Job} job
   * @returns {Promise<any>}
   */
  async function run(job) {
    await ready;
    return /** @type {NonNullable<typeof pool>} */ (pool).run(job);
  }

  /**
   * @param {{ width: number, height: number, data: Uint8Array | Uint8ClampedArray, style: string | object }} image RGBA
   * @param {Call} [call]
   * @returns {Promise<import('./protocol.js').PixelPatch>}
   */
  function stylize({ width, height, data, style }, call) {
    const bytes = new Uint8Array(data);
    const args = { style: JSON.stringify(style), width, height, data: bytes };
    return run({ op: 'stylize', args, transfer: [bytes.buffer], priority: Priority.PAGE, ...call });
  }

  /**
   * A whole page as pixels.
   * @param {PageDocument} document
   * @param {Call & { width: number, photos?: Record<string, Blob> }} options `photos`: files by id, for those not imported yet
   * @returns {Promise<import('./protocol.js').PixelPatch>}
   */
  async function compose(document, { width, photos: files = {}, ...call }) {
    const missing = Object.keys(files).filter((id) => !photos.has(id));
    await Promise.all(missing.map((id) => importPhoto(id, files[id], call)));
    return renders.composePixels(document, width, call);
  }

  /**
   * Which of some photos are worth keeping, and why.
   * @param {Blob[]} blobs
   * @param {{ signal?: AbortSignal, threshold?: number }} [call]
   */
  async function select(blobs, { signal, threshold = 10 } = {}) {
    const ids = blobs.map(() => `select-${(imported += 1)}`);
    try {
      const read = await Promise.all(blobs.map((blob, i) => importPhoto(ids[i], blob, { signal })));
      const measured = read.map((meta, i) => ({ id: ids[i], name: nameOf(blobs[i], ids[i]), ...meta.measures }));
      const verdicts = (await ready).choose(measured, threshold);
      return verdicts.map(({ group, kept, why }, i) => (
        { fingerprint: read[i].fingerprint, sharpness: read[i].sharpness, group, kept, why }
      ));
    } finally {
      ids.forEach(photos.forget);
    }
  }

  /**
   * Faces and objects, in pixels of the upright photo.
   * @param {Blob} blob
   * @param {{ signal?: AbortSignal }} [call]
   * @returns {Promise<import('./detector.js').Found[]>}
   */
  async function detect(blob, call) {
    const id = `detect-${(imported += 1)}`;
    try {
      const { width, height } = await importPhoto(id, blob, call);
      const found = await detector.detect(id, call);
      return found.map((box) => ({ ...box, x: box.x * width, y: box.y * height, width: box.width * width, height: box.height * height }));
    } finally {
      photos.forget(id);
    }
  }

  /**
   * Decodes a photo, reduces and measures it, and keeps it under `id`.
   * @param {string} id
   * @param {Blob} file
   * @param {Call} [call]
   * @returns {Promise<import('./protocol.js').Imported['meta']>}
   */
  async function importPhoto(id, file, call) {
    const name = nameOf(file, id);
    const job = { op: 'import', args: { id, file }, photo: name, holds: [`${id}/work`, `${id}/small`] };
    const { meta, work, small } = await run({ ...job, priority: Priority.PAGE, ...call });
    photos.add(id, { name, file, work, small });
    return meta;
  }

  /**
   * Takes frames out of a video; each becomes a photo, kept under the id given for its place.
   * @param {Blob} file
   * @param {{
   *   ids: string[], leading?: string[], start?: number, end?: number, signal?: AbortSignal,
   *   onAbout?: (about: { duration: number }) => void,
   *   onPhoto: (id: string, meta: import('./protocol.js').Imported['meta'], time: number) => void,
   * }} wish one frame an id, between `start` and `end` in seconds, those `leading` first; `time` is where in the video the frame is
   */
  async function importVideo(file, { ids, leading = [], start, end, signal, onAbout = () => {}, onPhoto }) {
    await ready;
    const name = nameOf(file, 'video');
    await readVideo(file, { count: ids.length, start, end, leading: leading.map((id) => ids.indexOf(id)) }, { signal, onAbout, onFrame });

    /** @param {import('./video.js').Frame} frame */
    async function onFrame({ index, time, ...frame }) {
      const id = ids[index];
      const job = { op: 'importFrame', args: { id, frame }, transfer: [frame.data.buffer], photo: name, holds: [`${id}/work`, `${id}/small`] };
      const { meta, work, small, file: still } = await run({ ...job, priority: leading.includes(id) ? Priority.PAGE : Priority.REST, signal });
      photos.add(id, { name, file: still, work, small });
      onPhoto(id, meta, time);
    }
  }

  function dispose() {
    for (const part of [detector, design, aesthetics, words, files]) part.dispose();
    ready.then(() => pool?.dispose(), () => {});
  }
}

/**
 * @param {WebAssembly.Module} module
 * @param {number} budget
 */
function spawn(module, budget) {
  const worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module', name: 'inkpanel' });
  worker.postMessage({ id: 0, op: 'start', args: { module, budget } });
  return worker;
}
