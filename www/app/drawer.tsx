import { useEffect, useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../ui/context.ts';
import type { ComponentChildren } from 'preact';

/**
 * A part of the board on a small screen, below the page.
 * @param props `bare`: the content contains a heading; `tools`: next to the heading
 */
export function Sheet({
  title,
  bare = false,
  tools,
  children,
}: {
  title: string;
  bare?: boolean;
  tools?: ComponentChildren;
  children: ComponentChildren;
}) {
  const { ui } = useApp();
  const ref = useRef(null as HTMLElement | null);
  // It comes before the bar that opens it, so without this, Tab would skip it.
  useEffect(() => ref.current?.focus({ preventScroll: true }), []);
  return (
    <section class="sheet" aria-label={strings.drawer} ref={ref} tabIndex={-1}>
      <div class="section-head sheet-head">
        {!bare && <h2>{title}</h2>}
        {tools}
        <IconButton
          icon="close"
          label={strings.close}
          onClick={() => {
            ui.sheet.value = null;
          }}
        />
      </div>
      <div class="sheet-body">{children}</div>
    </section>
  );
}
