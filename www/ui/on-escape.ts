/**
 * Gives up what is in hand, and nothing else, when Escape is pressed.
 * @param signal until when
 */
export function onEscape(end: () => void, signal: AbortSignal) {
  window.addEventListener(
    'keydown',
    (event) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      event.stopPropagation();
      end();
    },
    { signal, capture: true },
  );
}
