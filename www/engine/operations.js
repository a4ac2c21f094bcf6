// @ts-check
/**
 * What a worker does, one function an operation of `protocol.js`. Each answers with the value and the buffers
 * to hand over.
 */

import { blobOf } from './blobs.js';
import { asBmp, foreignKind } from './foreign.js';
import { fileMs, frameMs, pageMs, photoMs, pngMs, styleMs } from './measured.js';
import { failure } from './protocol.js';
import { STORING, readingOf } from './serving.js';
import { createStyleOperations } from './style-operations.js';
import { takenOf } from './taken.js';

/** @typedef {import('../pkg/inkpanel.js').Studio} Studio */
/** @typedef {import('../pkg/inkpanel.js').Patch} Patch */
/** @typedef {import('./protocol.js').PhotoHandle} PhotoHandle */
/** @typedef {import('./protocol.js').Operations} Operations */
/** @typedef {import('./serving.js').Tell} Tell */
/** @typedef {{ ok: any, transfer: Transferable[] }} Answer */

/** No photo is larger; a film that was dropped by mistake must not fill the memory. */
const MOST_BYTES = 512 * 2 ** 20;

/**
 * @param {Studio} studio
 * @param {ReturnType<typeof import('./lru.js').createLru>} held the photos in the studio
 * @returns {Record<string, (args: any, tell: Tell) => Promise<Answer>>}
 */
export function createOperations(studio, held) {
  return {
    import: importPhoto, importFrame, panel, page, compose, stylePhoto, stylePixels, stylize, fullPanels, encode,
    ...createStyleOperations({ studio, fetchPhotos, bitmap }),
  };

  /** @param {Operations['import']['args']} args @param {Tell} tell */
  async function importPhoto({ id, file }, tell) {
    tell.waits(readingOf(file));
    const { work, small, ...meta } = await read(id, await bytesOf(file), tell);
    tell.waits(STORING);
    const ok = { meta, work: await keep(`${id}/work`, work), small: await keep(`${id}/small`, small) };
    evict([]);
    return { ok, transfer: [] };
  }

  /**
   * @param {string} id
   * @param {Uint8Array<ArrayBuffer>} bytes of the file
   * @param {Tell} tell
   * @returns {Promise<any>} the photo's facts
   */
  async function read(id, bytes, tell) {
    const kind = foreignKind(bytes);
    tell.expects(photoMs(bytes, kind));
    if (!kind) return JSON.parse(studio.import_photo(id, bytes));
    const facts = JSON.parse(studio.import_photo(id, await asBmp(kind, bytes)));
    return { ...facts, format: kind, taken: takenOf(bytes) };
  }

  /** @param {Operations['importFrame']['args']} args @param {Tell} tell */
  async function importFrame({ id, frame: { width, height, data, squareWidth, squareHeight, rotation } }, tell) {
    tell.expects(frameMs(width * height + squareWidth * squareHeight));
    const { work, small, ...meta } = JSON.parse(studio.import_frame(id, width, height, data, squareWidth, squareHeight, rotation));
    const png = /** @type {Uint8Array<ArrayBuffer>} */ (studio.take_file());
    tell.waits(STORING);
    const file = await blobOf(png, { type: 'image/png' });
    const ok = { meta, work: await keep(`${id}/work`, work), small: await keep(`${id}/small`, small), file };
    evict([]);
    return { ok, transfer: [] };
  }

  /** @param {Operations['panel']['args']} args @param {Tell} tell */
  async function panel({ document, index, width, tier, photos }, tell) {
    await fetchPhotos(photos, tell);
    tell.expects(pageMs(document, width, 1));
    return bitmap(studio.render_panel(document, index, width, tier));
  }

  /** @param {Operations['page']['args']} args @param {Tell} tell */
  async function page({ document, width, tier, photos }, tell) {
    await fetchPhotos(photos, tell);
    tell.expects(pageMs(document, width));
    return bitmap(studio.compose(document, width, tier));
  }

  /** @param {Operations['compose']['args']} args @param {Tell} tell */
  async function compose({ document, width, tier, photos }, tell) {
    await fetchPhotos(photos, tell);
    tell.expects(pageMs(document, width));
    return pixels(studio.compose(document, width, tier));
  }

  /** @param {Operations['stylePhoto']['args']} args @param {Tell} tell */
  async function stylePhoto({ photo, style, width, height, crop }, tell) {
    await fetchPhotos([photo], tell);
    tell.expects(styleMs(style, width * height));
    return bitmap(studio.stylize_photo(photo.key, style, width, height, crop));
  }

  /** @param {Operations['stylePixels']['args']} args @param {Tell} tell */
  async function stylePixels({ photo, style, width, height }, tell) {
    await fetchPhotos([photo], tell);
    tell.expects(styleMs(style, width * height));
    return pixels(studio.stylize_photo(photo.key, style, width, height, ''));
  }

  /** @param {Operations['stylize']['args']} args @param {Tell} tell */
  async function stylize({ style, width, height, data }, tell) {
    tell.expects(styleMs(style, width * height));
    const styled = studio.stylize(style, width, height, data);
    const ok = { x: 0, y: 0, width, height, data: new Uint8ClampedArray(styled.buffer, styled.byteOffset, styled.length) };
    return { ok, transfer: [styled.buffer] };
  }

  /**
   * The panels that show one photo, from its original file at full size, so that it is decoded once for all.
   * @param {Operations['fullPanels']['args']} args
   * @param {Tell} tell
   */
  async function fullPanels({ id, file, document, indexes, width }, tell) {
    tell.waits(readingOf(file));
    const bytes = await bytesOf(file);
    const kind = foreignKind(bytes);
    tell.expects(photoMs(bytes, kind));
    studio.import_full(id, kind ? await asBmp(kind, bytes) : bytes);
    try {
      const ok = [];
      for (const index of indexes) {
        tell.expects(pageMs(document, width, 1));
        ok.push({ ...pixels(studio.render_panel(document, index, width, 'full')).ok, index });
      }
      return { ok, transfer: ok.map((patch) => patch.data.buffer) };
    } finally {
      studio.drop_photo(`${id}/full`);
    }
  }

  /** @param {Operations['encode']['args']} args @param {Tell} tell */
  async function encode({ document, width, patches }, tell) {
    const drawn = patches.reduce((sum, patch) => sum + patch.width * patch.height, 0);
    // The page is about as large as what lies on it.
    tell.expects(fileMs(drawn) + pngMs(2 * drawn + width * width));
    studio.begin_page(document, width);
    for (const { index, x, y, width: w, height: h, data } of patches) {
      studio.add_patch(index, x, y, w, h, new Uint8Array(data.buffer, data.byteOffset, data.length));
    }
    const png = /** @type {Uint8Array<ArrayBuffer>} */ (studio.finish_png());
    tell.waits(STORING);
    return { ok: await blobOf(png, { type: 'image/png' }), transfer: [] };
  }

  /**
   * Puts the planes of a fresh photo into a Blob, which the page hands to the other workers.
   * @param {string} key
   * @param {{ width: number, height: number }} size
   * @returns {Promise<PhotoHandle>}
   */
  async function keep(key, { width, height }) {
    const planes = /** @type {Uint8Array<ArrayBuffer>} */ (studio.photo_planes(key));
    held.touch(key, planes.length);
    return { key, width, height, planes: await blobOf(planes) };
  }

  /**
   * Reads into the studio what it lacks.
   * @param {PhotoHandle[]} photos
   * @param {Tell} tell
   */
  async function fetchPhotos(photos, tell) {
    if (photos.some(({ key }) => !studio.has_photo(key))) tell.waits(STORING);
    await Promise.all(photos.map(async ({ key, width, height, planes }) => {
      if (!studio.has_photo(key)) studio.put_photo(key, width, height, await bytesOf(planes));
      held.touch(key, planes.size);
    }));
    evict(photos.map(({ key }) => key));
  }

  /** @param {string[]} needed */
  function evict(needed) {
    for (const key of held.evict((other) => needed.includes(other))) studio.drop_photo(key);
  }
}

/**
 * @param {Blob} blob
 * @returns {Promise<Uint8Array<ArrayBuffer>>}
 */
async function bytesOf(blob) {
  if (blob.size > MOST_BYTES) throw failure('too-large', `The file is larger than ${MOST_BYTES / 2 ** 20} MB.`);
  try {
    return new Uint8Array(await blob.arrayBuffer());
  } catch (cause) {
    // The browser throws this when a file was moved, changed or deleted since it was chosen.
    throw Object.assign(new Error('The file can no longer be read.', { cause }), { code: 'unreadable-file' });
  }
}

/**
 * @param {Patch} patch
 * @returns {{ ok: import('./protocol.js').PixelPatch, transfer: Transferable[] }}
 */
function pixels(patch) {
  const { x, y, width, height } = patch;
  const data = /** @type {Uint8ClampedArray<ArrayBuffer>} */ (patch.take());
  patch.free();
  return { ok: { x, y, width, height, data }, transfer: [data.buffer] };
}

/**
 * @param {Patch} patch
 * @returns {Promise<{ ok: import('./protocol.js').BitmapPatch, transfer: Transferable[] }>}
 */
async function bitmap(patch) {
  const { ok: { x, y, width, height, data } } = pixels(patch);
  const image = await createImageBitmap(new ImageData(data, width, height));
  return { ok: { x, y, width, height, bitmap: image }, transfer: [image] };
}
