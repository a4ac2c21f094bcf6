// @ts-check
/**
 * The panels that a person has chosen to do something with. They are of one page: another page or another number of
 * panels has none chosen.
 */

import { computed, signal } from '@preact/signals';

/** @typedef {import('./store.js').Store} Store */
/** @typedef {ReturnType<typeof createSelection>} Selection */

/** @param {{ store: Store }} app */
export function createSelection({ store }) {
  const chosen = signal({ of: '', panels: /** @type {readonly number[]} */ ([]) });
  /** Whether each click adds to the choice, for hands without Shift or Ctrl. */
  const several = signal(false);

  const of = computed(() => {
    const { page, pageId } = store.project.value;
    return page ? `${pageId} ${page.panels.length}` : '';
  });
  const none = /** @type {readonly number[]} */ ([]);
  /** In ascending order. */
  const panels = computed(() => (chosen.value.of === of.value ? chosen.value.panels : none));

  /** @param {readonly number[]} list */
  function set(list) {
    chosen.value = { of: of.peek(), panels: [...new Set(list)].sort((a, b) => a - b) };
  }

  return {
    panels,
    several,
    set,
    clear: () => set([]),
    /** @param {number} panel */
    toggle: (panel) => {
      const list = panels.peek();
      set(list.includes(panel) ? list.filter((other) => other !== panel) : [...list, panel]);
    },
    /**
     * A click on a panel.
     * @param {number} panel
     * @param {boolean} adds whether a key says that it adds to the choice
     */
    press(panel, adds) {
      if (adds || several.peek()) this.toggle(panel);
      else set([panel]);
    },
    /** @param {boolean} on */
    choose: (on) => {
      several.value = on;
      if (!on) set([]);
    },
  };
}
