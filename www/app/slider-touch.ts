/**
 * Prevents sliders from changing when a finger scrolls the page. Browsers move a slider on touch, before they detect
 * scrolling. The change is delayed until the finger moves along the slider or is lifted, and is undone if the browser
 * scrolls.
 */

/** Minimum movement along a slider, in CSS pixels, that counts as intended. */
const MEANT = 6;

type Held = { slider: HTMLInputElement; value: string; id: number; x: number; told: boolean };

export function holdSliders(root: EventTarget) {
  let held: Held | null = null;
  /** Whether the next `input` is our own. */
  let own = false;

  root.addEventListener('pointerdown', begin, { capture: true });
  root.addEventListener('pointermove', move, { capture: true });
  root.addEventListener('pointerup', end, { capture: true });
  root.addEventListener('pointercancel', takeBack, { capture: true });
  for (const type of ['input', 'change']) root.addEventListener(type, hold, { capture: true });

  function begin(event: Event) {
    const { target, pointerType, pointerId, clientX } = event as PointerEvent;
    if (pointerType !== 'touch' || held || !(target instanceof HTMLInputElement) || target.type !== 'range') return;
    held = { slider: target, value: target.value, id: pointerId, x: clientX, told: false };
  }

  function move(event: Event) {
    const { pointerId, clientX } = event as PointerEvent;
    if (held?.id === pointerId && Math.abs(clientX - held.x) > MEANT) tell();
  }

  function end(event: Event) {
    if (held?.id !== (event as PointerEvent).pointerId) return;
    tell();
    held = null;
  }

  function takeBack(event: Event) {
    if (held?.id !== (event as PointerEvent).pointerId) return;
    if (!held.told) held.slider.value = held.value;
    held = null;
  }

  function hold(event: Event) {
    if (held && !held.told && !own && event.target === held.slider) event.stopImmediatePropagation();
  }

  /** Starts to accept values of the slider. */
  function tell() {
    if (!held || held.told) return;
    held.told = true;
    if (held.slider.value === held.value) return;
    own = true;
    held.slider.dispatchEvent(new InputEvent('input', { bubbles: true }));
    own = false;
  }
}
