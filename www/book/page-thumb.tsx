import { useEffect, useRef } from 'preact/hooks';
import { Priority } from '../engine/queue.ts';
import { useSubjectsOf } from '../page/subjects-of.ts';
import { strings } from '../strings/strings.ts';
import { Thumbnail, screenPixels } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import type { PageDocument } from '../engine/types.ts';
import type { ListDrag } from '../ui/list-drag.ts';

/**
 * A page of the storyboard, small: pressed it is turned to, and it is carried to another place by dragging, or by Alt
 * with the arrow keys.
 * @param props `marked`: a dragged page would land on that side of it
 */
export function PageThumb({
  page,
  at,
  of,
  current,
  marked,
  drag,
}: {
  page: PageDocument;
  at: number;
  of: number;
  current: boolean;
  marked: '' | 'before' | 'behind';
  drag: ListDrag;
}) {
  const { book, engine, ui } = useApp();
  const ref = useRef(null as HTMLButtonElement | null);
  const width = () => screenPixels(ref.current?.clientWidth ?? 64);
  // The visible page comes first. Its thumbnail waits until it is drawn.
  const drawn = useRef(page);
  if (!current || ui.painted.value === page) drawn.current = page;

  useEffect(() => {
    if (current) ref.current?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  }, [current, at]);

  function onKeyDown(event: KeyboardEvent) {
    const by = { ArrowUp: -1, ArrowLeft: -1, ArrowDown: 1, ArrowRight: 1 }[event.key];
    if (!event.altKey || by === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    book.move(at, at + by);
    // The browser removes the focus from a moved element.
    requestAnimationFrame(() => ref.current?.focus());
  }

  return (
    <li
      class="book-page"
      style={{ '--aspect': page.page.width / page.page.height }}
      data-marked={marked}
      data-carried={drag.carried?.from === at}
    >
      <button
        type="button"
        ref={ref}
        aria-label={strings.book.page({ n: at + 1, of })}
        aria-current={current ? 'true' : undefined}
        title={`${strings.book.page({ n: at + 1, of })}\n${strings.book.dragHelp}`}
        onPointerDown={(event) => drag.take(event, at)}
        onKeyDown={onKeyDown}
        onClick={() => {
          if (!drag.dragged.current) book.go(at);
        }}
      >
        <Thumbnail
          of={drawn.current}
          by={useSubjectsOf(drawn.current)}
          draw={(call) => engine.pageFile(drawn.current, width(), { ...call, priority: Priority.REST })}
        />
      </button>
      <span class="book-number" aria-hidden="true">
        {at + 1}
      </span>
    </li>
  );
}
