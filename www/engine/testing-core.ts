/** The core as the page has it, for tests in Node: `cargo xtask module core` builds it. */

import { readFileSync } from 'node:fs';
import { initSync } from '../pkg/inkpanel.js';
import { createPlanner } from './core.ts';

initSync({ module: readFileSync(new URL('../pkg/inkpanel_bg.wasm', import.meta.url)) });

export const core = createPlanner();
