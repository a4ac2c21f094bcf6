/**
 * The journal: edits that are not in the database yet, written immediately. An edit right before the tab closes is not
 * lost. Each project has one entry in local storage: the changes since the last written state, which is identified by
 * its stamp. During a write, the entry names the state that is being written as well, because either may be in the
 * database later. An entry without changes is removed.
 *
 * A change is a list of edits that give the same result whenever they are applied. For an intent, it has the
 * pages that were planned. The journal is untrusted: entries that do not match, or that the core rejects, are ignored.
 */

type Box = Pick<Storage, 'getItem' | 'setItem' | 'removeItem' | 'key' | 'length'>;
/** A state that is in the database, or may be: the number of changes in the entry that it includes. */
type Base = { stamp: string; from: number };
/** Photos that are not in the database: their ids and names. */
type Names = readonly (readonly [string, string])[];
/** The entry of a project. */
type Entry = { version: number; bases: Base[]; photos: [string, string][]; changes: unknown[] };
export type Journal = ReturnType<typeof createJournal>;

const VERSION = 2;
const PREFIX = 'inkpanel.journal.';

/** Maximum length of an entry in characters. Longer ones would slow down editing and fill local storage. */
const MOST = 400_000;
/** Maximum length of a list. */
const MOST_ITEMS = 10_000;

/** `box` may throw if storage is blocked */
export function createJournal({ box, most = MOST }: { box: () => Box; most?: number }) {
  return { note, clear, recall, names, tidy };

  /**
   * @param id of the project
   * @param entry each of the changes as JSON
   * @returns whether the entry is complete; an entry that is too large is removed
   */
  function note(
    id: string,
    { bases, changes, photos }: { bases: readonly Base[]; changes: readonly string[]; photos: Names },
  ): boolean {
    try {
      const about = JSON.stringify({ version: VERSION, bases, photos });
      const length = changes.reduce((sum, change) => sum + change.length + 1, about.length);
      if (length <= most && changes.length <= MOST_ITEMS) {
        box().setItem(PREFIX + id, `${about.slice(0, -1)},"changes":[${changes.join()}]}`);
        return true;
      }
    } catch {
      // Storage is blocked or full.
    }
    clear(id);
    return false;
  }

  function clear(id: string) {
    try {
      box().removeItem(PREFIX + id);
    } catch {
      // There is no entry.
    }
  }

  /**
   * @param id of a project
   * @param stamp of the project in the database
   * @returns the changes since, not validated, each as JSON; null without a matching entry
   */
  function recall(id: string, stamp: string): { changes: string[]; photos: Names } | null {
    try {
      const entry = stamp === '' ? null : read(id);
      const base = entry?.bases.find((one) => one.stamp === stamp);
      if (!entry || !base || !Number.isSafeInteger(base.from) || base.from < 0) return null;
      return { changes: entry.changes.slice(base.from).map((change) => JSON.stringify(change)), photos: entry.photos };
    } catch {
      return null;
    }
  }

  /**
   * @param id of a project
   * @returns its photos that were not written
   */
  function names(id: string): string[] {
    try {
      return read(id)?.photos.map(([, name]) => name) ?? [];
    } catch {
      return [];
    }
  }

  function read(id: string): Omit<Entry, 'version'> | null {
    const text = box().getItem(PREFIX + id);
    if (text === null) return null;
    const { version, bases, photos, changes }: Partial<Entry> = JSON.parse(text);
    const good =
      version === VERSION &&
      [bases, photos, changes].every((list) => Array.isArray(list) && list.length <= MOST_ITEMS) &&
      photos?.every(
        (photo) =>
          Array.isArray(photo) && photo.length === 2 && photo.every((part) => typeof part === 'string' && part !== ''),
      );
    return good && bases && photos && changes ? { bases, photos, changes } : null;
  }

  /**
   * Removes entries that match no project.
   * @param stampOf of a project in the database
   */
  async function tidy(stampOf: (id: string) => Promise<string | undefined>) {
    try {
      const keys = Array.from({ length: box().length }, (_, i) => box().key(i)).flatMap((key) =>
        key?.startsWith(PREFIX) ? key : [],
      );
      for (const key of keys) {
        const id = key.slice(PREFIX.length);
        const stamp = await stampOf(id);
        if (!read(id)?.bases.some((base) => base?.stamp === stamp)) clear(id);
      }
    } catch {
      // Without access to storage, the entries remain.
    }
  }
}
