/** Waits for the views. */

import { nextTask, pause } from '../engine/scheduler.ts';
import type { Ui } from './ui.ts';

/** Maximum milliseconds to wait for frames. */
const PATIENCE = 150;

/**
 * Waits until the views have drawn what is in the store now.
 * @returns rejects with the error that the views threw
 */
export async function drawn(ui: Ui): Promise<void> {
  const frames = new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))).then(nextTask);
  // A tab in the background draws no frames; its views are made all the same.
  await Promise.race([frames, pause(PATIENCE)]);
  const error = ui.failed.peek();
  if (error !== null) throw error;
}
