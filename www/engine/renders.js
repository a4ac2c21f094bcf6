// @ts-check
/**
 * The calls that draw with photos of the album: panels, whole pages, thumbnails of styles.
 */

import { Priority } from './queue.js';

/** @typedef {import('./documents.js').PageDocument} PageDocument */
/** @typedef {import('./protocol.js').BitmapPatch} BitmapPatch */
/** @typedef {import('./protocol.js').PixelPatch} PixelPatch */
/** @typedef {import('./engine.js').Call} Call */

/**
 * @param {{ run: (job: import('./pool.js').Job) => Promise<any>, photos: ReturnType<typeof import('./photos.js').createPhotos>, words: ReturnType<typeof import('./words.js').createWords> }} engine
 */
export function createRenders({ run, photos, words }) {
  return { renderPanel, renderWord: words.draw, renderPage, composePixels, stylePhoto, exploreStyles };

  /**
   * One panel of a page.
   * @param {PageDocument} document
   * @param {number} index
   * @param {number} width of the page, in pixels
   * @param {Call & { tier?: 'small' | 'work' }} [call]
   * @returns {Promise<BitmapPatch>}
   */
  async function renderPanel(document, index, width, { tier = 'work', ...call } = {}) {
    const needed = photos.handles([document.panels[index].photo], tier);
    const args = { document: JSON.stringify(document), index, width, tier, photos: needed };
    const photo = photos.names([document.panels[index].photo]);
    return run({ op: 'panel', args, photo, holds: keys(needed), priority: Priority.PANEL, ...call });
  }

  /**
   * A whole page as one bitmap: thumbnails.
   * @param {PageDocument} document
   * @param {number} width
   * @param {Call} [call]
   * @returns {Promise<BitmapPatch>}
   */
  async function renderPage(document, width, call) {
    const page = await run({ op: 'page', ...pageJob(document, width, 'small'), priority: Priority.VIEW, ...call });
    return words.over(document, width, page, call);
  }

  /**
   * A whole page as pixels.
   * @param {PageDocument} document
   * @param {number} width
   * @param {Call} [call]
   * @returns {Promise<PixelPatch>}
   */
  async function composePixels(document, width, call) {
    const page = await run({ op: 'compose', ...pageJob(document, width, 'work'), priority: Priority.PAGE, ...call });
    return words.lay(document, width, page, call);
  }

  /**
   * A crop of a photo in some style: thumbnails.
   * @param {string} id
   * @param {string | object} style
   * @param {{ width: number, height: number, crop?: object | null, tier?: 'small' | 'work' }} size
   * @param {Call} [call]
   * @returns {Promise<BitmapPatch>}
   */
  async function stylePhoto(id, style, { width, height, crop = null, tier = 'small' }, call) {
    const [photo] = photos.handles([id], tier);
    const args = { photo, style: JSON.stringify(style), width, height, crop: crop ? JSON.stringify(crop) : '' };
    return run({ op: 'stylePhoto', args, photo: photos.names([id]), holds: [photo.key], priority: Priority.VIEW, ...call });
  }

  /**
   * A photo in many styles, with what is known of each picture.
   * @param {string} id
   * @param {object[]} styles
   * @param {{ width: number, height: number }} size
   * @param {Call} [call]
   * @returns {Promise<import('./protocol.js').Explored[]>}
   */
  async function exploreStyles(id, styles, { width, height }, call) {
    const [photo] = photos.handles([id], 'small');
    const args = { photo, styles: styles.map((style) => JSON.stringify(style)), width, height };
    return run({ op: 'explore', args, photo: photos.names([id]), holds: [photo.key], priority: Priority.REST, ...call });
  }

  /**
   * @param {PageDocument} document
   * @param {number} width
   * @param {'small' | 'work'} tier
   */
  function pageJob(document, width, tier) {
    const ids = document.panels.map((panel) => panel.photo);
    const needed = photos.handles(ids, tier);
    return {
      args: { document: JSON.stringify(document), width, tier, photos: needed },
      photo: photos.names(ids),
      holds: keys(needed),
    };
  }
}

/** @param {import('./protocol.js').PhotoHandle[]} handles */
function keys(handles) {
  return handles.map(({ key }) => key);
}

/**
 * @param {Blob} blob
 * @param {string} other
 * @returns {string} the name of a file, or `other` for a Blob without one
 */
export function nameOf(blob, other) {
  return 'name' in blob && typeof blob.name === 'string' ? blob.name : other;
}
