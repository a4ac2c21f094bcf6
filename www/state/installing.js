// @ts-check
/** The page as a program of the device, where the browser offers that. */

import { computed, signal } from '@preact/signals';

/** @typedef {Event & { prompt: () => Promise<unknown> }} InstallEvent */
/** @typedef {ReturnType<typeof createInstalling>} Installing */

/** @param {Pick<Window, 'addEventListener'>} window */
export function createInstalling(window) {
  /** @type {import('@preact/signals').Signal<InstallEvent | null>} */
  const offer = signal(null);
  window.addEventListener('beforeinstallprompt', (event) => {
    // The button says it, when the person wants to know.
    event.preventDefault();
    offer.value = /** @type {InstallEvent} */ (event);
  });
  window.addEventListener('appinstalled', () => { offer.value = null; });

  return {
    possible: computed(() => offer.value !== null),
    /** Has the browser ask the person; it can be asked once. */
    install: () => {
      const event = offer.value;
      offer.value = null;
      void event?.prompt().catch(() => {});
    },
  };
}
