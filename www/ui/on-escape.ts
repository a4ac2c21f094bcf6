/**
 * Cancels the current operation, and nothing else, on Escape.
 * @param signal removes the listener
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
