// @ts-check
/** Runs one contestant away from the page's own thread. */

import { contest } from './contest.js';

globalThis.onmessage = async ({ data: { name, rows, image } }) => {
  try {
    postMessage({ times: await contest(name, rows, image) });
  } catch (error) {
    postMessage({ error: String(error instanceof Error ? error.message : error) });
  }
};
