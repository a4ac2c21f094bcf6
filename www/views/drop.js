// @ts-check
/**
 * Files dropped on the window or pasted into it. Folders are walked.
 */

import { signal } from '@preact/signals';

/** Whether files are being dragged over the window. */
export const dragging = signal(false);

/**
 * @param {Window} window
 * @param {(files: File[]) => void} accept
 */
export function acceptFiles(window, accept) {
  let depth = 0;
  const carries = (/** @type {DragEvent} */ event) => event.dataTransfer?.types.includes('Files') ?? false;
  const over = (/** @type {number} */ step) => {
    depth = Math.max(0, depth + step);
    dragging.value = depth > 0;
  };
  window.addEventListener('dragenter', (event) => carries(event) && over(1));
  window.addEventListener('dragleave', (event) => carries(event) && over(-1));
  window.addEventListener('dragover', (event) => carries(event) && event.preventDefault());
  window.addEventListener('drop', async (event) => {
    depth = 0;
    dragging.value = false;
    if (!event.dataTransfer || !carries(event)) return;
    event.preventDefault();
    accept(await filesOf(event.dataTransfer));
  });
  window.addEventListener('paste', (event) => {
    const files = [...(event.clipboardData?.files ?? [])];
    if (files.length > 0) accept(files);
  });
}

/**
 * @param {DataTransfer} transfer
 * @returns {Promise<File[]>}
 */
async function filesOf(transfer) {
  // The entries must be taken before the first await: the browser empties the transfer after the event.
  const plain = [...transfer.files];
  const entries = [...transfer.items].flatMap((item) => item.webkitGetAsEntry?.() ?? []);
  if (!entries.some((entry) => entry.isDirectory)) return plain;
  return (await Promise.all(entries.map(walk))).flat();
}

/**
 * @param {FileSystemEntry} entry
 * @returns {Promise<File[]>}
 */
async function walk(entry) {
  if (entry.isFile) {
    return [await new Promise((resolve, reject) => /** @type {FileSystemFileEntry} */ (entry).file(resolve, reject))];
  }
  const reader = /** @type {FileSystemDirectoryEntry} */ (entry).createReader();
  const found = [];
  // A reader gives at most a hundred entries a call.
  for (;;) {
    const some = /** @type {FileSystemEntry[]} */ (await new Promise((resolve, reject) => reader.readEntries(resolve, reject)));
    if (some.length === 0) break;
    found.push(...some);
  }
  return (await Promise.all(found.map(walk))).flat();
}
