/** The entry of the app. */

import './framed.ts';
import { render } from 'preact';
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
render(
  <AppContext.Provider value={app}>
    <App />
  </AppContext.Provider>,
  root,
);
keepFocus(root);
