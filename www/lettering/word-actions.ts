/** Words added to the page. */

import { computed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { Parts } from '../ui/context.ts';
import type { Kind } from '../strings/en/words.ts';
import type { Action } from '../ui/action.ts';

export function createWordActions({ store, ui, lettering }: Pick<Parts, 'store' | 'ui' | 'lettering'>) {
  const enabled = computed(() => store.page.value !== null);

  const added = (kind: Kind) =>
    ({
      label: strings.addWord[kind],
      short: strings.wordShort[kind],
      icon: kind,
      enabled,
      run: () => void add(kind),
      undo: 'step',
    }) satisfies Action;

  async function add(kind: Kind) {
    if (!(await lettering.add(kind))) return;
    if (!ui.wide.peek()) ui.sheet.value = null;
    lettering.editing.value = lettering.words.peek().length - 1;
  }

  return { addCaption: added('caption'), addBalloon: added('balloon'), addEffect: added('effect') };
}
