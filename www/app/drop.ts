/**
 * Files that are dropped on the window or pasted into it. Folders are read with all that is in them; an entry that cannot be
 * read is reported, and the others still come.
 */

import { signal } from '@preact/signals';
import { failure } from '../engine/protocol.ts';
import { noteFolders } from '../photos/folders.ts';
import type { Signal } from '@preact/signals';

/** Reports an entry that could not be read, by its name or its path in the dropped folder. */
type Unread = (name: string, error: unknown) => void;

/** Whether files are being dragged over the window. */
export const dragging = signal(false);

/** Whether the style of the dragged picture would be used: Alt is held, or the picture is over the zone for that. */
export const forStyle = signal(false);

/**
 * The end of the button that opened the file dialog, in CSS pixels. Messages about the files appear there, until the user
 * presses something else. After a drop they are with the other messages, because they would cover controls.
 */
export const spot: Signal<{ x: number; y: number } | null> = signal(null);

/** Names, as `data-drop`, elements on which a picture is dropped for its style. */
export const STYLE_ZONE = 'style';

/** @param imitate takes files for their style */
export function acceptFiles(
  window: Window,
  { accept, imitate, unread }: { accept: (files: File[]) => void; imitate: (files: File[]) => void; unread: Unread },
) {
  let depth = 0;
  const over = (step: number) => {
    depth = Math.max(0, depth + step);
    dragging.value = depth > 0;
  };
  window.addEventListener('dragenter', (event) => carries(event) && over(1));
  window.addEventListener('dragleave', (event) => carries(event) && over(-1));
  window.addEventListener('dragover', (event) => {
    if (!carries(event)) return refuse(event);
    event.preventDefault();
    forStyle.value = wantsStyle(event);
  });
  window.addEventListener('drop', async (event) => {
    depth = 0;
    dragging.value = false;
    if (!event.dataTransfer || !carries(event)) return refuse(event);
    event.preventDefault();
    spot.value = null;
    const take = wantsStyle(event) ? imitate : accept;
    const files = await filesOf(event.dataTransfer, unread);
    if (files.length > 0) take(files);
  });
  window.addEventListener('paste', (event) => {
    const files = [...(event.clipboardData?.files ?? [])];
    if (files.length > 0) accept(files);
  });
  const follow = { capture: true, passive: true };
  window.addEventListener('click', ({ target }) => isFileInput(target) && (spot.value = opener(window)), follow);
  window.addEventListener(
    'pointerdown',
    ({ target }) => {
      if (!(target instanceof Element && target.closest('.toasts'))) spot.value = null;
    },
    follow,
  );
}

/** The end of the button that opens the file dialog. */
function opener({ document }: Window) {
  const button = document.activeElement?.closest('button');
  if (!button) return null;
  const { left, width, bottom } = button.getBoundingClientRect();
  return { x: left + width / 2, y: bottom };
}

/** @param expect called when files are dragged in, or a dialog opens to choose some, seconds before they arrive */
export function expectFiles(window: Window, expect: () => void) {
  window.addEventListener('dragenter', (event) => carries(event) && expect());
  window.addEventListener('click', ({ target }) => isFileInput(target) && expect(), { capture: true });
}

/** Keeps the browser from leaving the app to open a dropped link. Text can be dropped on fields. */
function refuse(event: DragEvent) {
  const { target, dataTransfer } = event;
  if (event.defaultPrevented || (target instanceof Element && target.matches(':read-write'))) return;
  event.preventDefault();
  if (dataTransfer) dataTransfer.dropEffect = 'none';
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

async function filesOf(transfer: DataTransfer, unread: Unread): Promise<File[]> {
  // The browser empties the transfer after the event, so everything is taken before the first await.
  const plain = [...transfer.files];
  const sources = [...transfer.items].flatMap((item) => item.webkitGetAsEntry?.() ?? item.getAsFile?.() ?? []);
  if (!sources.some((source) => 'isDirectory' in source && source.isDirectory)) return plain;
  const lists = await Promise.all(
    sources.map((source) => ('isDirectory' in source ? filesIn(source, unread) : [source])),
  );
  return lists.flat();
}

/** Returns the files of an entry, in the order of its folders. */
async function filesIn(entry: FileSystemEntry, unread: Unread): Promise<File[]> {
  const path = (entry.fullPath || entry.name).split('/').filter(Boolean);
  const failed = (code: string) => unread(path.join('/'), failure(code, 'The browser cannot read it.'));
  if (entry.isFile) {
    try {
      const file: File = await new Promise((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
      return [noteFolders(file, path.slice(0, -1))];
    } catch {
      failed('unreadable-entry');
      return [];
    }
  }
  const found: FileSystemEntry[] = [];
  try {
    const reader = (entry as FileSystemDirectoryEntry).createReader();
    // A reader returns at most 100 entries per call.
    for (;;) {
      const some: FileSystemEntry[] = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
      if (some.length === 0) break;
      found.push(...some);
    }
  } catch {
    failed('unreadable-folder');
  }
  const lists = await Promise.all(found.map((inner) => filesIn(inner, unread)));
  return lists.flat();
}
