/**
 * Files dropped on the window or pasted into it, and how one sees them coming. Folders are walked.
 */

import { signal } from '@preact/signals';
import { noteFolders } from '../photos/folders.ts';

/** Whether files are being dragged over the window. */
export const dragging = signal(false);

/** Whether what is dragged would be taken for its style: Alt is held, or it is over the zone for that. */
export const forStyle = signal(false);

/** Names, as `data-drop`, elements on which a picture is dropped for its style. */
export const STYLE_ZONE = 'style';

/** @param imitate takes files for their style */
export function acceptFiles(window: Window, accept: (files: File[]) => void, imitate: (files: File[]) => void) {
  let depth = 0;
  const over = (step: number) => {
    depth = Math.max(0, depth + step);
    dragging.value = depth > 0;
  };
  window.addEventListener('dragenter', (event) => carries(event) && over(1));
  window.addEventListener('dragleave', (event) => carries(event) && over(-1));
  window.addEventListener('dragover', (event) => {
    if (!carries(event)) return;
    event.preventDefault();
    forStyle.value = wantsStyle(event);
  });
  window.addEventListener('drop', async (event) => {
    depth = 0;
    dragging.value = false;
    if (!event.dataTransfer || !carries(event)) return;
    event.preventDefault();
    const take = wantsStyle(event) ? imitate : accept;
    take(await filesOf(event.dataTransfer));
  });
  window.addEventListener('paste', (event) => {
    const files = [...(event.clipboardData?.files ?? [])];
    if (files.length > 0) accept(files);
  });
}

/** @param expect is told when files are dragged in, or a dialog opens to choose some: seconds before they come */
export function expectFiles(window: Window, expect: () => void) {
  window.addEventListener('dragenter', (event) => carries(event) && expect());
  window.addEventListener('click', ({ target }) => isFileInput(target) && expect(), { capture: true });
}

function wantsStyle({ altKey, target }: DragEvent) {
  return altKey || (target instanceof Element && target.closest(`[data-drop='${STYLE_ZONE}']`) !== null);
}

function carries(event: DragEvent) {
  return event.dataTransfer?.types.includes('Files') ?? false;
}

function isFileInput(target: EventTarget | null) {
  return target instanceof HTMLInputElement && target.type === 'file';
}

async function filesOf(transfer: DataTransfer): Promise<File[]> {
  // The entries must be taken before the first await: the browser empties the transfer after the event.
  const plain = [...transfer.files];
  const entries = [...transfer.items].flatMap((item) => item.webkitGetAsEntry?.() ?? []);
  if (!entries.some((entry) => entry.isDirectory)) return plain;
  return (await Promise.all(entries.map(walk))).flat();
}

async function walk(entry: FileSystemEntry): Promise<File[]> {
  if (entry.isFile) {
    const file: File = await new Promise((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
    return [noteFolders(file, entry.fullPath.split('/').slice(1, -1))];
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const found = [];
  // A reader gives at most a hundred entries a call.
  for (;;) {
    const some = (await new Promise((resolve, reject) => reader.readEntries(resolve, reject))) as FileSystemEntry[];
    if (some.length === 0) break;
    found.push(...some);
  }
  return (await Promise.all(found.map(walk))).flat();
}
