/** The sheets of the storyboard in their printed form. */

import { useEffect, useRef, useState } from 'preact/hooks';
import { Priority } from '../engine/queue.ts';
import type { PageDocument } from '../engine/types.ts';
import { subjectsOf } from '../page/subjects-of.ts';
import { strings } from '../strings/strings.ts';
import { Bitmap, screenPixels } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { explain } from '../ui/explain.ts';
import { after } from '../engine/scheduler.ts';

/** Milliseconds without typing before the sheets are laid out again. */
const REST_MS = 200;

export function Sheets() {
  const { boards, store, engine, messages } = useApp();
  const [sheets, setSheets] = useState([] as readonly PageDocument[]);
  const [busy, setBusy] = useState(true);
  const list = useRef(null as HTMLUListElement | null);
  const rows = boards.rows.value;
  const board = boards.board.value;
  const style = store.page.value?.style;
  const { name } = store.project.value;

  useEffect(() => {
    let gone = false;
    setBusy(true);
    const cancel = after(REST_MS, async () => {
      try {
        const made = await boards.sheets();
        if (!gone) setSheets((before) => made.map((sheet, i) => (same(before[i], sheet) ? before[i] : sheet)));
      } catch (error) {
        if (!gone) messages.alert(strings.boards.noSheets({ why: explain(error) }));
      }
      if (!gone) setBusy(false);
    });
    return () => {
      gone = true;
      cancel();
    };
  }, [rows, board, style, name]);

  const width = () => screenPixels(list.current?.clientWidth ?? 480);
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: it is scrolled by keys, and nothing in it takes the focus.
    <ul class="board-sheets" ref={list} aria-label={strings.boards.sheets} aria-busy={busy} tabIndex={0}>
      {sheets.map((sheet, i) => (
        <li key={i} style={{ aspectRatio: `${sheet.page.width} / ${sheet.page.height}` }}>
          <div role="img" aria-label={strings.boards.sheet({ n: i + 1, of: sheets.length })}>
            <Bitmap
              of={sheet}
              by={subjectsOf(store, sheet)}
              draw={(call) => engine.renderPage(sheet, width(), { ...call, priority: Priority.VIEW })}
            />
          </div>
        </li>
      ))}
    </ul>
  );
}

function same(a: PageDocument | undefined, b: PageDocument): boolean {
  return a !== undefined && JSON.stringify(a) === JSON.stringify(b);
}
