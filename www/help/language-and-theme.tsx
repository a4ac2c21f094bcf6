/** A button, and below it how the page looks and speaks. */

import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { IconButton } from '../ui/button.tsx';
import { onEscape } from '../ui/on-escape.ts';
import { LanguageChoice } from './language-choice.tsx';
import { ThemeChoice } from './theme-choice.tsx';

export function LanguageAndTheme() {
  const [open, setOpen] = useState(false);
  const menu = useRef(null as HTMLDivElement | null);

  // With the menu, not after the next picture: a press that is quicker than that closes it, too.
  useLayoutEffect(() => {
    const element = menu.current;
    if (!open || !element) return;
    element.querySelector<HTMLElement>('input:checked')?.focus();
    const ended = new AbortController();
    const close = () => setOpen(false);
    onEscape(() => {
      close();
      element.querySelector('button')?.focus();
    }, ended.signal);
    const outside = ({ target }: Event) => {
      if (!element.contains(target as Node)) close();
    };
    window.addEventListener('pointerdown', outside, { signal: ended.signal, capture: true });
    window.addEventListener('focusin', outside, { signal: ended.signal });
    return () => ended.abort();
  }, [open]);

  return (
    <div class="menu" ref={menu}>
      <IconButton icon="globe" label={strings.languageAndTheme} expanded={open} onClick={() => setOpen(!open)} />
      {open && (
        <div class="menu-body" role="dialog" aria-label={strings.languageAndTheme}>
          <ThemeChoice />
          <LanguageChoice />
        </div>
      )}
    </div>
  );
}
