/** The document in a record of the table `states`: the bytes of an editor, or objects, as earlier versions wrote it. */

import { bytesOf, encoded, recordIn } from '../engine/interned.ts';
import { VERSION } from '../engine/versions.ts';
import type { AnyState } from './database.ts';

/** Version of records with bytes. Their history has a separate version. Records with objects have version 1. */
export const RECORD = 2;

type State = Pick<Partial<AnyState>, 'version' | 'bytes' | 'history'>;

/** @returns the history for an editor, not validated; throws `damaged-project` if it is not plain data */
export function bytesIn({ version, bytes, history }: State): Uint8Array<ArrayBuffer> {
  if (version === RECORD && isBytes(bytes)) return bytes;
  return bytesOf({ version: version === RECORD ? VERSION : version, history });
}

/** @returns whether there is a document, in any form */
export function hasDocument({ bytes, history }: State): boolean {
  return Boolean(bytes ?? history);
}

export function isBytes(value: unknown): value is Uint8Array<ArrayBuffer> {
  return ArrayBuffer.isView(value);
}

/**
 * Renames the project in its present, and perhaps in all states.
 * @returns the record; unchanged if it cannot be read
 */
export function withName<Record extends State>(state: Record, name: string, { all = false } = {}): Record {
  const named = (one: object) => ({ ...one, name });
  const change = <History extends NonNullable<State['history']> | ReturnType<typeof recordIn>['history']>(
    history: History,
  ) => {
    if (!history?.present) throw new TypeError('There is no present.');
    const { past, present, future } = history;
    return {
      ...history,
      present: named(present),
      ...(all && { past: (past ?? []).map(named), future: (future ?? []).map(named) }),
    };
  };
  try {
    const { bytes, history } = state;
    if (!isBytes(bytes)) return { ...state, history: change(history as NonNullable<State['history']>) };
    const record = recordIn(bytes);
    return { ...state, bytes: encoded({ ...record, history: change(record.history) }) };
  } catch {
    return state;
  }
}
