/**
 * The keyboard of a screen covers the foot of the window, which stays as high as it was: what is written there is moved up
 * with its page, between the bar above and the keyboard.
 */

/** Pixels between what is written and the keyboard. */
const AIR = 8;
/** What is less is the bar of a browser that comes and goes. */
const KEYBOARD = 80;

/**
 * @param field in which is written
 * @returns lets the page down again
 */
export function liftAbove(field: HTMLElement): () => void {
  const seen = window.visualViewport;
  const area = field.closest('.stage-area') as HTMLElement | null;
  if (!seen || !area) return () => {};
  // Zoomed in by two fingers, the person has the place in hand.
  const look = () => {
    area.style.translate = '';
    const keyboard = window.innerHeight - seen.height;
    delete area.dataset.lifted;
    if (seen.scale !== 1 || keyboard < KEYBOARD) return;
    const { top, bottom } = field.getBoundingClientRect();
    const ceiling = Math.max(seen.offsetTop, barAbove(area)) + AIR;
    const floor = seen.offsetTop + seen.height - AIR;
    // Where both do not fit, the beginning of the text is in sight.
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

/** @returns where the room of the page begins */
function barAbove(area: Element): number {
  return area.closest('.centre')?.getBoundingClientRect().top ?? 0;
}
