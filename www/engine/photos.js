// @ts-check
/**
 * The photos of an album as the main thread holds them: the original file and two Blobs of planes each. The
 * browser keeps Blobs outside this page's memory; workers read what a job needs.
 */

import { failure } from './protocol.js';

/** @typedef {import('./protocol.js').PhotoHandle} PhotoHandle */
/** @typedef {import('./documents.js').PageDocument} PageDocument */
/** @typedef {{ name: string, file: Blob, work: PhotoHandle, small: PhotoHandle }} Entry */

export function createPhotos() {
  /** @type {Map<string, Entry>} */
  const entries = new Map();

  return {
    /**
     * @param {string} id
     * @param {Entry} entry
     */
    add: (id, entry) => void entries.set(id, entry),
    /** @param {string} id */
    has: (id) => entries.has(id),
    /** @param {string} id */
    forget: (id) => void entries.delete(id),
    get,
    handles,
    names,
  };

  /**
   * @param {string} id
   * @returns {Entry}
   */
  function get(id) {
    const entry = entries.get(id);
    if (!entry) throw failure('missing-photo', `The photo ${id} is not in this album.`);
    return entry;
  }

  /**
   * @param {(string | null)[]} ids
   * @param {'small' | 'work'} tier
   * @returns {PhotoHandle[]} one a photo, however often it is used
   */
  function handles(ids, tier) {
    return [...new Set(ids)].flatMap((id) => (id === null ? [] : get(id)[tier]));
  }

  /**
   * @param {(string | null)[]} ids
   * @returns {string} the names of the photos, for messages
   */
  function names(ids) {
    return [...new Set(ids)].flatMap((id) => (id === null ? [] : entries.get(id)?.name ?? id)).join(', ');
  }
}
