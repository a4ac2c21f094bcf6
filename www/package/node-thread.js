// @ts-check
/** What a thread of Node runs: a worker of the engine, which finds there what a browser's worker has. */

import { parentPort, workerData } from 'node:worker_threads';
import { readFromDisk } from './node-disk.js';

readFromDisk();
const port = /** @type {import('node:worker_threads').MessagePort} */ (parentPort);
Object.assign(globalThis, {
  postMessage: (/** @type {unknown} */ message, /** @type {{ transfer?: any[] }} */ { transfer = [] } = {}) =>
    port.postMessage(message, transfer),
});
await import(workerData);
// What came until now waited in the port.
port.on('message', (data) => globalThis.onmessage?.(/** @type {MessageEvent} */ ({ data })));
