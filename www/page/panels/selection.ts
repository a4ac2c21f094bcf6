/**
 * The selected panels of a page. Showing another page or changing the number of panels clears the selection.
 */

import { computed, signal } from '@preact/signals';
import type { Store } from '../../document/store.ts';

export type Selection = ReturnType<typeof createSelection>;

export function createSelection({ store }: { store: Store }) {
  const chosen = signal({ of: '', panels: [] as readonly number[] });
  /** Whether each click extends the selection, for users without Shift or Ctrl. */
  const several = signal(false);

  const of = computed(() => {
    const { page, pageId } = store.project.value;
    return page ? `${pageId} ${page.panels.length}` : '';
  });
  const none = [] as readonly number[];
  /** In ascending order. */
  const panels = computed(() => (chosen.value.of === of.value ? chosen.value.panels : none));

  function set(list: readonly number[]) {
    chosen.value = { of: of.peek(), panels: [...new Set(list)].sort((a, b) => a - b) };
  }

  return {
    panels,
    several,
    set,
    clear: () => set([]),
    toggle: (panel: number) => {
      const list = panels.peek();
      set(list.includes(panel) ? list.filter((other) => other !== panel) : [...list, panel]);
    },
    /**
     * A click on a panel.
     * @param adds whether a key extends the selection
     */
    press(panel: number, adds: boolean) {
      if (adds || several.peek()) this.toggle(panel);
      else set([panel]);
    },
    choose: (on: boolean) => {
      several.value = on;
      if (!on) set([]);
    },
  };
}
