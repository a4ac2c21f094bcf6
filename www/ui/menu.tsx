/** A button, and a small dialog below it that closes with Escape, with a press elsewhere, and after a choice. */

import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { IconButton } from './button.tsx';
import { onEscape } from './on-escape.ts';
import type { ComponentChildren } from 'preact';

export function Menu({ icon, label, children }: { icon: string; label: string; children: ComponentChildren }) {
  const [open, setOpen] = useState(false);
  const menu = useRef(null as HTMLDivElement | null);

  // With the menu, not after the next picture: a press that is quicker than that closes it, too.
  useLayoutEffect(() => {
    const element = menu.current;
    if (!open || !element) return;
    element.querySelector<HTMLElement>('.menu-body :is(button, input:checked)')?.focus();
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
      <IconButton icon={icon} label={label} short={label} expanded={open} onClick={() => setOpen(!open)} />
      {open && (
        <div
          class="menu-body"
          role="dialog"
          aria-label={label}
          onClick={({ target }) => {
            if (!(target as Element).closest('button')) return;
            setOpen(false);
            // The chosen button disappears. A choice that opens something moves the focus afterwards.
            menu.current?.querySelector('button')?.focus();
          }}
        >
          {children}
        </div>
      )}
    </div>
  );
}
