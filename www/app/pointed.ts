/**
 * The button that has the focus because the pointer pressed it: the eye is on the page by then, and the next Space is meant
 * for the page.
 */
export function trackPointed(window: Window): () => Element | null {
  let pressed: Element | null = null;
  window.addEventListener(
    'pointerdown',
    ({ target }) => {
      pressed = target instanceof Element ? target.closest('button') : null;
    },
    { capture: true },
  );
  // By keys the focus may come back to it, and then it is meant.
  window.addEventListener('keydown', ({ key }) => key === 'Tab' && (pressed = null), { capture: true });
  return () => (pressed !== null && pressed === window.document.activeElement ? pressed : null);
}
