import type { Place } from '../engine/types.ts';

/** Scrolls the card there into view, once it is drawn. */
export function showCard({ layer, at }: Place, then: (card: HTMLElement) => void = () => {}) {
  requestAnimationFrame(() => {
    const card = document.querySelectorAll(`.lane[data-layer="${layer}"] .card`)[at] as HTMLElement | undefined;
    if (!card) return;
    card.scrollIntoView({ block: 'nearest' });
    then(card);
  });
}

/** Puts the focus on the card there, once it is drawn. */
export const focusCard = (place: Place) => showCard(place, (card) => card.focus());
