/**
 * Offers pages that are read from right to left, if the language of the browser is. Japanese is not offered: comics in
 * Japanese have both directions, so the choice in the page settings stays with the user.
 */

import { effect, untracked } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import type { Messages } from '../ui/messages.ts';
import type { Pages } from '../document/pages.ts';
import type { Store } from '../document/store.ts';

/** Languages that are written from right to left. */
const LEFTWARD = new Set(['ar', 'dv', 'fa', 'he', 'iw', 'ps', 'sd', 'ug', 'ur', 'yi']);

/** @param language a BCP 47 tag */
export function isLeftward(language: string): boolean {
  return LEFTWARD.has(language.toLowerCase().split('-')[0]);
}

/** @param app `language`: the preferred language of the browser */
export function offerRtl({
  store,
  pages,
  messages,
  language,
}: {
  store: Pick<Store, 'page' | 'sketch' | 'project' | 'canUndo'>;
  pages: Pick<Pages, 'changeSettings'>;
  messages: Pick<Messages, 'note'>;
  language: string;
}) {
  if (!isLeftward(language)) return;
  let offered = false;
  effect(() => {
    if (offered || store.page.value === null || store.sketch.value) return;
    offered = true;
    untracked(() => {
      // A project that was opened has its direction.
      if (store.project.peek().settings.rtl || store.canUndo.peek()) return;
      messages.note(strings.rtlOffer, {
        label: strings.rightToLeft,
        run: () => pages.changeSettings({ rtl: true }),
      });
    });
  });
}
