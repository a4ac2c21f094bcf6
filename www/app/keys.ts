/**
 * The keyboard: one listener that maps shortcuts to actions. A control with the focus receives its keys first.
 */

import { isEnabled } from '../ui/action.ts';
import { pressed } from '../ui/shortcut.ts';
import { everyAction } from '../ui/action.ts';
import type { Ui } from '../ui/ui.ts';
import type { Tables } from '../ui/action.ts';

/** Elements that handle a key themselves when they have the focus. */
const OWN_USE: Record<string, string> = {
  Space: 'button, [role=button], input, a, select, [role=option], summary',
  PageUp: 'input, select, [role=listbox], [role=slider]',
  PageDown: 'input, select, [role=listbox], [role=slider]',
};
const TEXT_FIELDS = 'input:not([type=checkbox], [type=range], [type=color], [type=file]), textarea, select';

/**
 * @param parts `leave`: the action of Escape, if any. `covered`: whether a modal dialog is open. While a
 * dialog of `ui` is loaded, the keys do nothing, because the user types them for the dialog; Escape cancels it.
 * `pointed`: the button that has the focus because of a click. Space must not press it again.
 * @returns a listener for `keydown` on the window
 */
export function createKeys({
  actions,
  ui,
  leave,
  covered,
  pointed = () => null,
}: {
  actions: Tables;
  ui: Pick<Ui, 'work' | 'dialog' | 'letterKeys'>;
  leave: () => (() => void) | undefined;
  covered: () => boolean;
  pointed?: () => Element | null;
}): (event: KeyboardEvent) => void {
  const byKeys = new Map(
    everyAction(actions)
      .filter(([, { heard }]) => heard !== 'panel')
      .flatMap(([, action]) => (action.keys ?? []).map((keys) => [keys, action])),
  );

  return (event) => {
    if (event.defaultPrevented || covered() || event.altKey || typesText(event.target)) return;
    if (ui.dialog.peek() !== null) {
      if (event.key === 'Escape') take(event, () => void (ui.dialog.value = null));
      return;
    }
    if (event.key === 'Escape' && !event.ctrlKey && !event.metaKey) {
      take(event, leave());
      return;
    }
    const shortcut = pressed(event).find((keys) => byKeys.has(keys));
    const action = shortcut === undefined ? undefined : byKeys.get(shortcut);
    if (!shortcut || !action || isSilent(shortcut, event.target)) return;
    // Behind a workspace the page is invisible, so nothing shuffles it.
    if (ui.work.peek() !== null && action.heard !== 'everywhere') return;
    if (isEnabled(action)) {
      // Some browsers press a focused button when the key is released.
      if (shortcut === 'Space') (pointed() as HTMLElement | null)?.blur();
      take(event, action.run);
    }
    // Prevents the browser's own action, such as saving a copy of the page.
    else if (shortcut.includes('Mod+')) event.preventDefault();
  };

  /** The user can turn off single-letter shortcuts. Other shortcuts stay active. */
  function isSilent(shortcut: string, target: EventTarget | null) {
    if (/^[A-Z?]$/.test(shortcut) && !ui.letterKeys.peek()) return true;
    const own = OWN_USE[shortcut];
    if (own === undefined || !(target instanceof Element)) return false;
    const control = target.closest(own);
    return control !== null && !(shortcut === 'Space' && control === pointed());
  }
}

function take(event: KeyboardEvent, deed: (() => void) | undefined) {
  if (!deed) return;
  event.preventDefault();
  deed();
}

function typesText(target: EventTarget | null) {
  return target instanceof HTMLElement && (target.isContentEditable || target.matches(TEXT_FIELDS));
}
