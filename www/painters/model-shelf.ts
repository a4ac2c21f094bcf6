/**
 * Models of painters in this browser's storage, in a separate database. A table in the database of projects would
 * need a newer version, which older app versions cannot open. Bytes and not blobs, because WebKit stores no blobs in a
 * private window.
 */

import { openDB } from 'idb';
import type { DBSchema, IDBPDatabase } from 'idb';

/** `id` identifies the content: 16 hexadecimal digits. `painters` is the number of them. */
export type KeptModel = { id: string; name: string; painters: number; bytes: ArrayBuffer };
export type ModelShelf = ReturnType<typeof createModelShelf>;

type Schema = DBSchema & { models: { key: string; value: KeptModel } };

/** @param name of the database */
export function createModelShelf(name: string = 'inkpanel-painters') {
  let opened: Promise<IDBPDatabase<Schema>> | null = null;

  return {
    all: async (): Promise<KeptModel[]> => (await database()).getAll('models'),
    put: async (model: KeptModel) => void (await (await database()).put('models', model)),
    remove: async (id: string) => (await database()).delete('models', id),
  };

  function database() {
    opened ??= open().catch((error) => {
      opened = null;
      throw error;
    });
    return opened;
  }

  async function open() {
    const forget = () => {
      opened = null;
    };
    const made: IDBPDatabase<Schema> = await openDB(name, 1, {
      upgrade: (fresh) => void fresh.createObjectStore('models', { keyPath: 'id' }),
      blocking: () => {
        made?.close();
        forget();
      },
      terminated: forget,
    });
    return made;
  }
}
