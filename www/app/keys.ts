/**
 * The keyboard: one table from key to deed. A key that a control wants for itself is left to it.
 */

import type { Book } from '../book/book.ts';
import type { Pages } from '../document/pages.ts';
import type { Download } from '../export/download.ts';
import type { Lettering } from '../lettering/lettering.ts';
import type { Framing } from '../page/panels/framing.ts';
import type { Reshaping } from '../page/panels/reshaping.ts';
import type { Ui } from './ui.ts';

type Deeds = {
  pages: Pages;
  download: Download;
  ui: Ui;
  selection: import('../page/panels/selection.ts').Selection;
  framing: Framing;
  reshaping: Reshaping;
  book: Pick<Book, 'step' | 'several'>;
  lettering: Pick<Lettering, 'mode'>;
};

/** @returns a listener for `keydown` on the window */
export function createKeys({
  pages,
  download,
  ui,
  selection,
  framing,
  reshaping,
  book,
  lettering,
}: Deeds): (event: KeyboardEvent) => void {
  return (event) => {
    if (event.defaultPrevented || ui.dialog.peek() !== null || event.altKey) return;
    const deed = event.ctrlKey || event.metaKey ? withControl(event) : plain(event);
    if (!deed) return;
    event.preventDefault();
    deed();
  };

  function withControl({ key, shiftKey, target }: KeyboardEvent) {
    if (typesText(target)) return undefined;
    switch (key.toLowerCase()) {
      case 'z':
        return shiftKey ? pages.redo : pages.undo;
      case 'y':
        return pages.redo;
      case 's':
        return ui.work.peek() === null ? () => download.start() : undefined;
      default:
        return undefined;
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

  /** Whether a key turns the pages: lists and sliders have another use for it. */
  function turns(target: EventTarget | null) {
    return (
      book.several.peek() &&
      !(target instanceof Element && target.closest('input, select, [role=listbox], [role=slider]'))
    );
  }

  function plain({ key, target }: KeyboardEvent) {
    if (typesText(target)) return undefined;
    // Over the board the page is out of sight: nothing shuffles it unseen.
    if (ui.work.peek() !== null) return key === 'Escape' ? () => void (ui.work.value = null) : undefined;
    // Letters alone may be switched off; what needs no letter stays.
    if (/^[a-z?]$/i.test(key) && !ui.letterKeys.peek()) return undefined;
    switch (key) {
      case ' ':
        return pressesItself(target) ? undefined : () => pages.shuffle('all');
      case 'l':
      case 'L':
        return () => pages.shuffle('layout');
      case 's':
      case 'S':
        return () => pages.shuffle('style');
      case 'p':
      case 'P':
        return () => pages.shuffle('photos');
      case 'PageUp':
      case 'PageDown':
        return turns(target) ? () => book.step(key === 'PageUp' ? -1 : 1) : undefined;
      case '?':
        return () => void (ui.dialog.value = 'keys');
      case 'Escape':
        return leave();
      default:
        return undefined;
    }
  }
}

function typesText(target: EventTarget | null) {
  if (!(target instanceof HTMLElement)) return false;
  const typed = 'input:not([type=checkbox], [type=range], [type=color], [type=file]), textarea, select';
  return target.isContentEditable || target.matches(typed);
}

function pressesItself(target: EventTarget | null) {
  return target instanceof Element && target.closest('button, input, a, select, [role=option], summary') !== null;
}
