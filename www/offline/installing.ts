/** Installation of the app on the device, if the browser offers it. */

import { computed, signal } from '@preact/signals';
import type { Signal } from '@preact/signals';

type InstallEvent = Event & { prompt: () => Promise<unknown> };
export type Installing = ReturnType<typeof createInstalling>;

export function createInstalling(window: Pick<Window, 'addEventListener'>) {
  const offer: Signal<InstallEvent | null> = signal(null);
  window.addEventListener('beforeinstallprompt', (event) => {
    // A button of the app offers the installation instead of the browser's own prompt.
    event.preventDefault();
    offer.value = event as InstallEvent;
  });
  window.addEventListener('appinstalled', () => {
    offer.value = null;
  });

  return {
    possible: computed(() => offer.value !== null),
    /** Shows the browser's installation prompt, which is possible only once. */
    install: () => {
      const event = offer.value;
      offer.value = null;
      void event?.prompt().catch(() => {});
    },
  };
}
