/**
 * The bar of the selected text item on a small screen: above or below the item, never over it. It is hidden while text
 * is edited, because the on-screen keyboard needs the space. A large screen has the contextual bar instead.
 */

import { useLayoutEffect, useRef } from 'preact/hooks';
import type { Word, WordBox } from '../engine/types.ts';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../ui/context.ts';
import { capitals, USUAL_OUTLINE } from './word-fields.tsx';
import type { Place } from './word-places.ts';
import { knobOf } from './word-places.ts';

/** Pixels between the text item and the bar, for the handles. */
const AIR = 18;
/** Half of a handle, which the bar never covers. */
const HANDLE = 12;
/** Values of the switches of a sound effect. */
const ARC = 0.6;
const SLANT = 15;
const THICK = 0.14;

/** Letters of scripts that are set in columns, too. */
const IN_COLUMNS = /[\p{Script=Han}\p{Script=Hiragana}\p{Script=Katakana}\p{Script=Hangul}\p{Script=Bopomofo}]/u;

const SHAPES = ['oval', 'thought', 'shout', 'whisper', 'radio'] as const;

export function WordBar({ index, box }: { index: number; box: WordBox }) {
  const { lettering, store, ui, actions } = useApp();
  const bar = useRef(null as HTMLDivElement | null);
  const gesture = useRef(lettering.step());
  const word = lettering.words.value[index];
  const height = store.geometry.value?.height ?? 1;
  const hidden = ui.wide.value || ui.sheet.value !== null;

  useLayoutEffect(() => {
    const shown = bar.current;
    if (!shown) return;
    const knob = word?.kind === 'effect' ? knobOf(lettering.pageAt(index), box, word.angle) : undefined;
    const settle = () => place(shown, box, height, knob);
    settle();
    // The bar stays in the stage when the window changes its size.
    const sizes = new ResizeObserver(settle);
    for (const element of [shown.parentElement, shown.closest('.stage-area')]) if (element) sizes.observe(element);
    return () => sizes.disconnect();
  });
  if (!word || hidden) return null;

  const rest = () => {
    gesture.current = lettering.step();
  };
  const set = (news: Partial<Word>) => {
    lettering.edit(index, news, gesture.current);
    rest();
  };
  const stop = (event: Event) => event.stopPropagation();
  const { font } = box;
  const bold = font === 'comic-neue-bold';

  return (
    <div
      ref={bar}
      class="word-bar"
      role="toolbar"
      aria-label={strings.wordBar}
      // A change of the zoom updates its position.
      data-zoom={ui.zoom.value}
      onClick={stop}
      onPointerDown={stop}
      onKeyDown={(event: KeyboardEvent) => {
        // Keys pressed here are not shortcuts of the page.
        if (event.key !== 'Escape' && event.key !== 'Tab') event.stopPropagation();
      }}
    >
      <ActionButton action={actions.text.edit} />
      {word.kind === 'balloon' &&
        SHAPES.map((shape) => (
          <IconButton
            key={shape}
            icon={`balloon-${shape}`}
            label={strings.shapes[shape]}
            pressed={(word.shape ?? 'oval') === shape}
            onClick={() => set({ shape })}
          />
        ))}
      {word.kind === 'balloon' && !box.tip && (
        <IconButton icon="focus" label={strings.barTail} onClick={() => (lettering.mode.value = 'tail')} />
      )}
      <span class="word-bar-line" />
      <ActionButton action={actions.text.smaller} />
      <ActionButton action={actions.text.larger} />
      {font !== 'bangers' && (
        <IconButton
          icon="bold"
          label={strings.barBold}
          pressed={bold}
          onClick={() => set({ font: bold ? 'comic-neue' : 'comic-neue-bold' })}
        />
      )}
      <IconButton
        icon="capitals"
        label={strings.barCapitals}
        pressed={capitals(word)}
        onClick={() => set({ capitals: !capitals(word) })}
      />
      {(word.vertical || IN_COLUMNS.test(word.text)) && (
        <IconButton
          icon="vertical"
          label={strings.barVertical}
          pressed={word.vertical ?? false}
          onClick={() => set({ vertical: !word.vertical })}
        />
      )}
      {word.kind === 'effect' && <EffectTools word={word} set={set} />}
      <span class="word-bar-line" />
      {(['color', 'fill'] as const).map((name) => (
        <input
          key={name}
          type="color"
          class="word-bar-colour"
          aria-label={name === 'color' ? strings.barInk : strings.barFill}
          title={name === 'color' ? strings.barInk : strings.barFill}
          value={box[name]}
          onInput={({ currentTarget }) => lettering.edit(index, { [name]: currentTarget.value }, gesture.current)}
          onChange={rest}
        />
      ))}
      <ActionButton action={actions.text.remove} />
    </div>
  );
}

function EffectTools({ word, set }: { word: Word; set: (news: Partial<Word>) => void }) {
  const arc = word.arc ?? 0;
  const slant = word.slant ?? 0;
  const thick = (word.outline ?? USUAL_OUTLINE) >= THICK;
  return (
    <>
      <IconButton
        icon="arch"
        label={strings.barArch}
        pressed={arc > 0}
        onClick={() => set({ arc: arc > 0 ? 0 : ARC })}
      />
      <IconButton
        icon="sag"
        label={strings.barSag}
        pressed={arc < 0}
        onClick={() => set({ arc: arc < 0 ? 0 : -ARC })}
      />
      <IconButton
        icon="lean"
        label={strings.barLean}
        pressed={slant !== 0}
        onClick={() => set({ slant: slant === 0 ? SLANT : 0 })}
      />
      <IconButton
        icon="outline"
        label={strings.barOutline}
        pressed={thick}
        onClick={() => set({ outline: thick ? null : THICK })}
      />
    </>
  );
}

/**
 * Places the bar above the text item and its handles. Without enough space, it goes below them. It is centred, as far
 * as the window allows.
 */
function place(bar: HTMLElement, box: WordBox, height: number, knob?: Place) {
  const page = bar.closest('.page') as HTMLElement;
  const [width, tall] = [page.clientWidth, page.clientHeight];
  const room = (bar.closest('.stage-area') ?? page).getBoundingClientRect();
  const { left, top } = page.getBoundingClientRect();
  bar.style.maxWidth = `${Math.max(160, room.width - 8)}px`;
  const pixels = (y: number) => (y / height) * tall;
  const handles = [box.tip, knob].flatMap((handle) => (handle ? pixels(handle[1]) : []));
  const above = Math.min(pixels(box.y), ...handles.map((y) => y - HANDLE + AIR / 2)) - AIR - bar.offsetHeight;
  const below = Math.max(pixels(box.y + box.height), ...handles.map((y) => y + HANDLE - AIR / 2)) + AIR;
  const ceiling = room.top - top + 4;
  const floor = room.bottom - top - bar.offsetHeight - 4;
  // If the item is as high as the page, the bar goes to the side with more space.
  const y = above >= ceiling ? above : below <= floor ? below : above - ceiling > floor - below ? above : below;
  const middle = (box.x + box.width / 2) * width - bar.offsetWidth / 2;
  const x = Math.max(room.left - left + 4, Math.min(middle, room.right - left - bar.offsetWidth - 4));
  bar.style.top = `${y}px`;
  bar.style.left = `${x}px`;
}
