import type { Place } from '../engine/types.ts';

/** Puts the focus on the card there, once it is drawn. */
export function focusCard({ layer, at }: Place) {
  requestAnimationFrame(() => {
    const card = document.querySelectorAll(`.lane[data-layer="${layer}"] .card`)[at] as HTMLElement | undefined;
    card?.focus();
    card?.scrollIntoView({ block: 'nearest' });
  });
}
