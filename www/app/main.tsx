/** The entry of the app. */

import './framed.ts';
import { render } from 'preact';
import { nextTask } from '../engine/scheduler.ts';
import { AppContext } from '../ui/context.ts';
import { createApp } from './app.ts';
import { App } from './app.tsx';
import { begin } from './begin.ts';
import { escapeOf } from './escape.ts';
import { keepFocus } from './focus-keeper.ts';
import { createKeys } from './keys.ts';
import { reportState } from './state-attributes.ts';
import { trackPointed } from './pointed.ts';
import { holdSliders } from './slider-touch.ts';

void start();

/** Starts in three tasks, so that the browser can paint the start screen of `index.html` and answer the user between them. */
async function start() {
  await nextTask();
  const app = createApp({ window, script: import.meta.url });
  const root = document.getElementById('app') as HTMLElement;
  begin(app);
  reportState(app);
  holdSliders(window);
  window.addEventListener(
    'keydown',
    createKeys({
      ui: app.ui,
      actions: { ...app.actions },
      leave: () => escapeOf(app),
      covered: () => document.querySelector('dialog:modal') !== null,
      pointed: trackPointed(window),
    }),
  );
  await nextTask();
  // The views decide now what is shown (`public/theme.js`).
  delete document.documentElement.dataset.opens;
  render(
    <AppContext.Provider value={app}>
      <App />
    </AppContext.Provider>,
    root,
  );
  keepFocus(root);
}
