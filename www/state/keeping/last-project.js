// @ts-check
/** Which project the next visit begins with: the one that this tab had open, else the one that was saved last. */

/** @typedef {Pick<Storage, 'getItem' | 'setItem'>} Box */

const KEY = 'inkpanel.project';

/** @param {{ tab: () => Box, browser: () => Box }} boxes small storages, which may throw */
export function createLastProject({ tab, browser }) {
  return {
    recall,
    /** This tab has it open now. @param {string} id */
    opened: (id) => write(tab, id),
    /** @param {string} id */
    saved: (id) => write(browser, id),
  };

  /** @returns {{ id: string, here: boolean } | null} `here`: this very tab had it open */
  function recall() {
    try {
      const here = tab().getItem(KEY);
      const last = here ?? browser().getItem(KEY);
      return last ? { id: last, here: here !== null } : null;
    } catch {
      return null;
    }
  }

  /** @param {() => Box} box @param {string} id */
  function write(box, id) {
    try {
      box().setItem(KEY, id);
    } catch {
      // Without storage there is nothing to come back to.
    }
  }
}
