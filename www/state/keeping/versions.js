// @ts-check
/**
 * The version of what is kept, in the database and in project files. The core reads it, and makes the newest of an older
 * one (`src/document/`).
 */

import { failure } from '../../engine/protocol.js';

export const VERSION = 1;

/** @param {string} what */
export function damaged(what) {
  return failure('damaged-project', what);
}
