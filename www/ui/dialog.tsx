import { useLayoutEffect, useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { IconButton } from './button.tsx';
import type { ComponentChildren } from 'preact';

/** A modal dialog. The browser keeps the focus inside. Escape and a click outside close it. */
export function Dialog({
  title,
  onClose,
  children,
  class: extra = '',
}: {
  title: string;
  onClose: () => void;
  children: ComponentChildren;
  class?: string;
}) {
  const ref = useRef(null as HTMLDialogElement | null);
  useLayoutEffect(() => {
    const dialog = ref.current;
    dialog?.showModal();
    return () => dialog?.close();
  }, []);
  return (
    <dialog
      ref={ref}
      class={`dialog ${extra}`}
      aria-label={title}
      onClose={onClose}
      onClick={(event) => event.target === ref.current && onClose()}
    >
      <div class="dialog-body">
        <header class="section-head">
          <h2>{title}</h2>
          <IconButton icon="close" label={strings.close} onClick={onClose} />
        </header>
        {children}
      </div>
    </dialog>
  );
}
