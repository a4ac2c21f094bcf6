/** Selects the first project of a visit: the project of this tab, or the last saved project. */

type Box = Pick<Storage, 'getItem' | 'setItem'>;

const KEY = 'inkpanel.project';

/** @param boxes small storages, which may throw */
export function createLastProject({ tab, browser }: { tab: () => Box; browser: () => Box }) {
  return {
    recall,
    /** This tab has it open now. */
    opened: (id: string) => write(tab, id),
    saved: (id: string) => write(browser, id),
  };

  /** @returns `here`: this very tab had it open */
  function recall(): { id: string; here: boolean } | null {
    try {
      const here = tab().getItem(KEY);
      const last = here ?? browser().getItem(KEY);
      return last ? { id: last, here: here !== null } : null;
    } catch {
      return null;
    }
  }

  function write(box: () => Box, id: string) {
    try {
      box().setItem(KEY, id);
    } catch {
      // Without storage, there is nothing to restore.
    }
  }
}
