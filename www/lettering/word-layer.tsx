/**
 * The text items on the page: a canvas with their pictures, and one focusable element per item above it. The selected
 * item also has its tail and a text field.
 */

import { useEffect, useRef } from 'preact/hooks';
import { wordName } from '../document/word-names.ts';
import { strings } from '../strings/strings.ts';
import { subjectsOf, useSubjectsOf } from '../page/subjects-of.ts';
import { useApp } from '../ui/context.ts';
import { placed, pointOn, useWordHands } from './word-hands.ts';
import { WordEditor } from './word-editor.tsx';
import { createWordPainter } from './word-painter.ts';
import { explain } from '../ui/explain.ts';
import type { Geometry, PageDocument, WordBox } from '../engine/types.ts';

/** @param props `width` of the page in pixels of the screen */
export function WordLayer({ page, geometry, width }: { page: PageDocument; geometry: Geometry; width: number }) {
  const { engine, ui, messages, lettering, store } = useApp();
  const canvas = useRef(null as HTMLCanvasElement | null);
  const painter = useRef(null as ReturnType<typeof createWordPainter> | null);
  const words = lettering.words.value;
  const boxes = lettering.boxes.value;
  const editing = lettering.editing.value;
  // While the user types, the drawn balloon follows the field.
  const drawn = lettering.draft.value ?? page;
  /** The page that is drawn now, without the text that is typed. */
  const shown = useRef(page);

  useEffect(() => {
    const alerts = messages.alertGroup();
    painter.current = createWordPainter(canvas.current as HTMLCanvasElement, {
      render: engine.renderWord,
      subjectsOf: (document) => subjectsOf(store, document),
      onPainted: (document, whole) => {
        if (whole) alerts.clear();
        ui.lettered.value = document && shown.current;
      },
      onError: (error) => alerts.report(strings.wordsFailed({ why: explain(error) })),
    });
    return () => painter.current?.dispose();
  }, []);
  // Sound effects may be behind the subjects of photos, whose masks arrive later, like photos.
  const subjects = useSubjectsOf(page);
  const read = store.reading.value?.done;
  useEffect(() => {
    shown.current = page;
    if (width > 0) painter.current?.show(drawn, width);
  }, [drawn, page, width, subjects, read]);

  return (
    <>
      <canvas ref={canvas} class="word-canvas" aria-hidden="true" />
      <div class="words" role="group" aria-label={strings.wordList}>
        {words.map(
          (_, i) => boxes[i] && i !== editing && <Word key={i} index={i} box={boxes[i]} height={geometry.height} />,
        )}
        {lettering.mode.value && <Aim />}
        {boxes[editing] && (
          <WordEditor key={`edit-${editing}`} index={editing} box={boxes[editing]} height={geometry.height} />
        )}
      </div>
    </>
  );
}

/** @param props `height` of the page, in its widths */
function Word({ index, box, height }: { index: number; box: WordBox; height: number }) {
  const { lettering, ui } = useApp();
  const hands = useWordHands(index);
  const word = lettering.words.value[index];
  const chosen = lettering.chosen.value === index;
  // Above a drawer, the page is too small for handles.
  const held = chosen && (ui.wide.value || ui.sheet.value === null);
  const name = wordName(word);
  return (
    <>
      <button
        type="button"
        class="word"
        data-word={index}
        aria-label={name}
        aria-description={strings.wordKeys}
        aria-pressed={chosen}
        style={{ ...placed(box, height), '--wide': box.width, '--tall': box.height / height }}
        {...hands.body}
      />
      {held && box.tip && (
        <button
          type="button"
          class="word-tail"
          aria-label={strings.wordTail({ name })}
          aria-description={strings.tailKeys}
          style={{ left: `${box.tip[0] * 100}%`, top: `${(box.tip[1] / height) * 100}%` }}
          {...hands.tail}
        />
      )}
      {held && (
        <button
          type="button"
          class="word-handle"
          data-handle="size"
          aria-label={strings.wordResize}
          aria-description={strings.resizeKeys}
          style={spot(hands.corner(), height)}
          {...hands.size}
        />
      )}
      {held && word.kind === 'effect' && (
        <button
          type="button"
          class="word-handle"
          data-handle="turn"
          aria-label={strings.wordTurn}
          aria-description={strings.turnKeys}
          style={spot(hands.knobAt(), height)}
          {...hands.knob}
        />
      )}
    </>
  );
}

/** @returns the position of a handle, limited to the page */
function spot([x, y]: readonly [number, number], height: number) {
  const percent = (part: number) => `${Math.min(100, Math.max(0, part * 100)).toFixed(3)}%`;
  return { left: percent(x), top: percent(y / height) };
}

/** Covers the page while the next click selects a position. */
function Aim() {
  const { lettering } = useApp();
  const index = lettering.chosen.value;

  function press(event: MouseEvent) {
    event.stopPropagation();
    const at = pointOn(event);
    if (lettering.mode.peek() === 'tail') lettering.point(index, at);
    else lettering.move(index, at);
    lettering.mode.value = null;
  }

  return (
    <div class="word-aim" role="presentation" onClick={press} onPointerDown={(event) => event.stopPropagation()} />
  );
}
