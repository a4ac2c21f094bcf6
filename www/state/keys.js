// @ts-check
/**
 * The keyboard: one table from key to deed. A key that a control wants for itself is left to it.
 */

/** @typedef {{ pages: import('./pages.js').Pages, download: import('./download.js').Download, ui: import('./ui.js').Ui,
 *   selection: import('./selection.js').Selection, framing: import('./framing.js').Framing, reshaping: import('./reshaping.js').Reshaping,
 *   book: Pick<import('./book.js').Book, 'step' | 'several'>, lettering: Pick<import('./lettering.js').Lettering, 'mode'> }} Deeds */

/**
 * @param {Deeds} deeds
 * @returns {(event: KeyboardEvent) => void} a listener for `keydown` on the window
 */
export function createKeys({ pages, download, ui, selection, framing, reshaping, book, lettering }) {
  return (event) => {
    if (event.defaultPrevented || ui.dialog.peek() !== null || event.altKey) return;
    const deed = event.ctrlKey || event.metaKey ? withControl(event) : plain(event);
    if (!deed) return;
    event.preventDefault();
    deed();
  };

  /** @param {KeyboardEvent} event */
  function withControl({ key, shiftKey, target }) {
    if (typesText(target)) return undefined;
    switch (key.toLowerCase()) {
      case 'z': return shiftKey ? pages.redo : pages.undo;
      case 'y': return pages.redo;
      case 's': return ui.work.peek() === null ? () => download.start() : undefined;
      default: return undefined;
    }
  }

  /** Escape leaves what was begun last. */
  function leave() {
    if (lettering.mode.peek()) return () => void (lettering.mode.value = null);
    if (framing.mode.peek()) return () => void (framing.mode.value = null);
    if (selection.several.peek() || selection.panels.peek().length > 0) return () => selection.choose(false);
    if (reshaping.editing.peek()) return () => void (reshaping.editing.value = false);
    return ui.sheet.peek() ? () => void (ui.sheet.value = null) : undefined;
  }

  /** Whether a key turns the pages: lists and sliders have another use for it. @param {EventTarget | null} target */
  function turns(target) {
    return book.several.peek() && !(target instanceof Element && target.closest('input, select, [role=listbox], [role=slider]'));
  }

  /** @param {KeyboardEvent} event */
  function plain({ key, target }) {
    if (typesText(target)) return undefined;
    // Over the board the page is out of sight: nothing shuffles it unseen.
    if (ui.work.peek() !== null) return key === 'Escape' ? () => void (ui.work.value = null) : undefined;
    // Letters alone may be switched off; what needs no letter stays.
    if (/^[a-z?]$/i.test(key) && !ui.letterKeys.peek()) return undefined;
    switch (key) {
      case ' ': return pressesItself(target) ? undefined : () => pages.shuffle('all');
      case 'l': case 'L': return () => pages.shuffle('layout');
      case 's': case 'S': return () => pages.shuffle('style');
      case 'p': case 'P': return () => pages.shuffle('photos');
      case 'PageUp': case 'PageDown': return turns(target) ? () => book.step(key === 'PageUp' ? -1 : 1) : undefined;
      case '?': return () => void (ui.dialog.value = 'keys');
      case 'Escape': return leave();
      default: return undefined;
    }
  }
}

/** @param {EventTarget | null} target */
function typesText(target) {
  if (!(target instanceof HTMLElement)) return false;
  const typed = 'input:not([type=checkbox], [type=range], [type=color], [type=file]), textarea, select';
  return target.isContentEditable || target.matches(typed);
}

/** @param {EventTarget | null} target */
function pressesItself(target) {
  return target instanceof Element && target.closest('button, input, a, select, [role=option], summary') !== null;
}
