/** Saves files for the user. */

import { after } from '../engine/scheduler.ts';

export function save(blob: Blob, name: string) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // The browser reads the address after the click returns; a minute is far more than it needs.
  after(60_000, () => URL.revokeObjectURL(link.href));
}
