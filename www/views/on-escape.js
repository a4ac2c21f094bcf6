// @ts-check
/**
 * Gives up what is in hand, and nothing else, when Escape is pressed.
 * @param {() => void} end
 * @param {AbortSignal} signal until when
 */
export function onEscape(end, signal) {
  window.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.preventDefault();
    event.stopPropagation();
    end();
  }, { signal, capture: true });
}
