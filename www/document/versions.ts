/**
 * The version of what is kept, in the database and in project files. The core reads it, and makes the newest of an older
 * one (`src/document/`).
 */

import { failure } from '../engine/protocol.ts';

export const VERSION = 1;

export function damaged(what: string) {
  return failure('damaged-project', what);
}
