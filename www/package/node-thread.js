// @ts-check
/** Entry point of a Node thread: runs a worker of the engine, with the functions of a browser's worker. */

import { parentPort, workerData } from 'node:worker_threads';
import { readFromDisk } from './node-disk.js';

readFromDisk();
const port = /** @type {import('node:worker_threads').MessagePort} */ (parentPort);
Object.assign(globalThis, {
  postMessage: (/** @type {unknown} */ message, /** @type {{ transfer?: any[] }} */ { transfer = [] } = {}) =>
    port.postMessage(message, transfer),
});
await import(workerData);
// Earlier messages waited in the port.
port.on('message', (data) => globalThis.onmessage?.(/** @type {MessageEvent} */ ({ data })));
