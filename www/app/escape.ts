/** Escape closes the mode that was opened last, or the workspace. */

import type { App } from '../ui/context.ts';

/** @returns the action of Escape; `undefined` if there is nothing to close */
export function escapeOf({
  ui,
  explorer,
  shownPages,
  framing,
  lettering,
  selection,
  reshaping,
  hints,
}: App): (() => void) | undefined {
  const work = ui.work.peek();
  if (work === 'explorer' && explorer.parent.peek()) return () => void (explorer.parent.value = null);
  if (work === 'pages' && shownPages.pair.peek().length > 0) return () => void (shownPages.pair.value = []);
  if (work !== null) return () => void (ui.work.value = null);
  if (ui.originals.peek()) return () => void (ui.originals.value = false);
  if (ui.preview.peek()) return () => void (ui.preview.value = false);
  if (framing.placing.peek() !== null) return () => framing.place(null);
  if (lettering.mode.peek()) return () => void (lettering.mode.value = null);
  if (framing.mode.peek()) return () => void (framing.mode.value = null);
  if (lettering.chosen.peek() >= 0) return () => lettering.choose(-1);
  if (framing.cropping.peek() !== null) return () => void (framing.cropping.value = null);
  if (selection.several.peek() || selection.panels.peek().length > 0) return () => selection.choose(false);
  if (reshaping.editing.peek()) return () => void (reshaping.editing.value = false);
  if (ui.sheet.peek()) return () => void (ui.sheet.value = null);
  return hints.shown.peek() ? hints.close : undefined;
}
