/**
 * Offline use: a service worker caches the files of the site (`worker/`), and a new version is activated when
 * the user accepts it. Without service workers the app works only online.
 */

import { effect } from '@preact/signals';
import { pause } from '../engine/scheduler.ts';
import { strings } from '../strings/strings.ts';
import type { Messages } from '../ui/messages.ts';
import type { Scheduler } from '../engine/scheduler.ts';

/** Minimum milliseconds without work before the files are downloaded, so that they do not delay the first page. */
const DELAY = 2_000;
/** Milliseconds between two checks for a new version, for a page that stays open. */
const OFTEN = 3600_000;
/** Maximum milliseconds to wait until a new version takes over. */
const PATIENCE = 10_000;
/** Prefix of the locks that tell the worker which build a tab uses. */
const PAGE_LOCK = 'inkpanel.page ';

/** The data saver setting; not all browsers have it. */
type Saving = Navigator & { connection?: { saveData?: boolean } };

/** @param app `script`: the address of the page's own script; `busy` reads signals */
export function createOffline({
  window,
  messages,
  keeping,
  script,
  busy,
  scheduler,
}: {
  window: Window;
  messages: Pick<Messages, 'offer' | 'alert'>;
  keeping: { flush: () => Promise<unknown>; isSafe: () => boolean; files: { save: () => unknown } };
  script: string;
  busy: () => boolean;
  scheduler: Pick<Scheduler, 'background'>;
}) {
  const { navigator, document } = window;
  const workers = navigator.serviceWorker;
  let registration: ServiceWorkerRegistration | undefined;
  let looked = 0;
  if (!workers) return;

  // Held as long as the page is open.
  void navigator.locks
    ?.request(`${PAGE_LOCK}${script}`, { mode: 'shared' }, () => new Promise(() => {}))
    .catch(() => {});

  let wait = new AbortController();
  const stop = effect(() => {
    wait.abort();
    if (busy()) return;
    wait = new AbortController();
    const start = () => {
      stop();
      return begin();
    };
    scheduler.background(start, { delay: DELAY, signal: wait.signal });
  });

  async function begin() {
    try {
      registration = await workers.register(new URL('./service-worker.js', document.baseURI), {
        updateViaCache: 'none',
      });
      looked = Date.now();
      if (registration.waiting) tell();
      registration.addEventListener('updatefound', () => {
        registration?.installing?.addEventListener('statechange', () => registration?.waiting && tell());
      });
      document.addEventListener('visibilitychange', look);
      const { active } = await workers.ready;
      active?.postMessage({ op: 'settle', extras: !(navigator as Saving).connection?.saveData });
    } catch {
      // Storage is blocked, as in some private windows, or the file is missing. The app works without it.
    }
  }

  /** Checks for a new version when the user returns to the page. */
  function look() {
    if (document.visibilityState !== 'visible' || Date.now() - looked < OFTEN) return;
    looked = Date.now();
    void registration?.update().catch(() => {});
  }

  function tell() {
    // A page without a service worker came from the host just now.
    if (workers.controller) messages.offer(strings.newVersion, { label: strings.reload, run: () => void reload() });
  }

  /** Other open pages of the previous version continue with it. */
  async function reload() {
    await keeping.flush();
    if (!keeping.isSafe()) {
      messages.alert(strings.notReloaded, { label: strings.saveToFile, run: () => void keeping.files.save() });
      tell();
      return;
    }
    const { waiting } = registration ?? {};
    if (waiting) {
      const changed = new Promise((resolve) => {
        workers.addEventListener('controllerchange', resolve, { once: true });
      });
      waiting.postMessage({ op: 'take-over' });
      await Promise.race([changed, pause(PATIENCE)]);
    }
    window.location.reload();
  }
}
