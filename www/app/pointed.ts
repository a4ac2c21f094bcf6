/**
 * Tracks the button that has the focus because of a click. The user looks at the page then, so the next Space is for
 * the page.
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
  // After keyboard navigation, Space is for the focused button.
  window.addEventListener('keydown', ({ key }) => key === 'Tab' && (pressed = null), { capture: true });
  return () => (pressed !== null && pressed === window.document.activeElement ? pressed : null);
}
