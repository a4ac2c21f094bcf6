/**
 * Keeps edited text above an on-screen keyboard. The keyboard covers the bottom of the window without changing its
 * height. So the page moves up until the text is between the top bar and the keyboard.
 */

/** Pixels between what is written and the keyboard. */
const AIR = 8;
/** Minimum height of a keyboard. Smaller changes are browser toolbars that appear and disappear. */
const KEYBOARD = 80;

/**
 * @param field in which is written
 * @returns lets the page down again
 */
export function liftAbove(field: HTMLElement): () => void {
  const seen = window.visualViewport;
  const area = field.closest('.stage-area') as HTMLElement | null;
  if (!seen || !area) return () => {};
  // If the page is zoomed, the user controls the position.
  const look = () => {
    area.style.translate = '';
    const keyboard = window.innerHeight - seen.height;
    delete area.dataset.lifted;
    if (seen.scale !== 1 || keyboard < KEYBOARD) return;
    const { top, bottom } = field.getBoundingClientRect();
    const ceiling = Math.max(seen.offsetTop, barAbove(area)) + AIR;
    const floor = seen.offsetTop + seen.height - AIR;
    // If both do not fit, the beginning of the text is visible.
    const by = Math.max(Math.min(0, floor - bottom), ceiling - top);
    if (by === 0) return;
    area.dataset.lifted = 'true';
    area.style.translate = `0 ${by}px`;
  };
  seen.addEventListener('resize', look);
  seen.addEventListener('scroll', look);
  field.addEventListener('input', look);
  look();
  return () => {
    seen.removeEventListener('resize', look);
    seen.removeEventListener('scroll', look);
    field.removeEventListener('input', look);
    delete area.dataset.lifted;
    area.style.translate = '';
  };
}

/** @returns the top of the visible area of the page */
function barAbove(area: Element): number {
  return area.closest('.centre')?.getBoundingClientRect().top ?? 0;
}
