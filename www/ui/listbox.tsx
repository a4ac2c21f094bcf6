/** A list box of images in a grid: one tab stop; arrows move; Enter, Space or a click selects. */

import { useEffect, useRef, useState } from 'preact/hooks';
import { useInView } from './bitmap.tsx';
import { useApp } from './context.ts';
import { useGrowing } from './growing.ts';
import { pointing } from './pointing.ts';
import type { ComponentChild } from 'preact';
import type { Point } from './pointing.ts';

type Option = { id: string; name: string };

const asItIs = ({ name }: Option) => name;

export function Listbox<T extends Option>({
  label,
  groups,
  selected,
  onChoose,
  picture,
  nameOf = asItIs,
  tileOf = nameOf,
  names = false,
  noteOf,
  empty = '',
  onPoint,
  class: extra = '',
}: {
  label: string;
  groups: { name: string; options: T[] }[];
  selected: string | null;
  onChoose: (id: string) => void;
  picture: (option: T) => ComponentChild;
  nameOf?: (option: T) => string;
  /** The name as it is shown, perhaps with soft hyphens. */
  tileOf?: (option: T) => string;
  names?: boolean;
  /** A second line below the name. */
  noteOf?: (option: T) => string;
  empty?: string;
  /** The option under the pointer, the keyboard focus or a long press, or null. */
  onPoint?: Point;
  class?: string;
}) {
  const ref = useRef(null as HTMLDivElement | null);
  const [active, setActive] = useState(null as string | null);
  const there = useGrowing(groups.flatMap(({ name, options }) => options.map(({ id }) => `${name} ${id}`)));
  const shown = groups.map(({ name, options }) => ({
    name,
    options: options.filter(({ id }) => there.has(`${name} ${id}`)),
  }));
  const ids = shown.flatMap(({ options }) => options.map(({ id }) => id));
  const stop = [active, selected, ids[0]].find((id) => id !== null && ids.includes(id));

  // Scroll to a selection from outside, for example from a shuffle. It forces a layout of the window, so it waits until the
  // page is drawn and the user rests.
  const { scheduler } = useApp();
  const inView = useInView(ref);
  useEffect(() => {
    const stop = new AbortController();
    scheduler.background(() => reveal(ref.current), stop);
    return () => stop.abort();
  }, [selected, selected !== null && ids.includes(selected), inView]);

  function onKeyDown(event: KeyboardEvent) {
    const options = [...(ref.current as HTMLElement).querySelectorAll('[role=option]')];
    const at = options.indexOf(event.target as Element);
    if (at < 0 || event.ctrlKey || event.metaKey || event.altKey) return;
    const to = target(event.key, options as HTMLElement[], at);
    if (to === undefined && event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    if (to === undefined) onChoose(ids[at]);
    else {
      setActive(ids[to]);
      (options[to] as HTMLElement).focus();
    }
  }

  return (
    <div
      ref={ref}
      class={`listbox ${extra}`}
      role="listbox"
      aria-label={label}
      onKeyDown={onKeyDown}
      onPointerLeave={onPoint && (() => onPoint(null))}
      onBlurCapture={onPoint && (() => onPoint(null))}
    >
      {ids.length === 0 && (
        <p class="quiet" role="presentation">
          {empty}
        </p>
      )}
      {shown
        .filter(({ options }) => options.length > 0)
        .map(({ name, options }) => (
          <div class="listbox-group" role="group" aria-label={name || label} key={name}>
            {name && (
              <div class="listbox-heading" aria-hidden="true">
                {name}
              </div>
            )}
            {options.map((option) => (
              <div
                key={option.id}
                class="option"
                role="option"
                aria-label={nameOf(option)}
                aria-selected={option.id === selected}
                tabIndex={option.id === stop ? 0 : -1}
                title={nameOf(option)}
                aria-description={noteOf?.(option)}
                {...(onPoint && pointing(option.id, onPoint))}
                onFocusIn={() => setActive(option.id)}
                onClick={() => onChoose(option.id)}
              >
                {picture(option)}
                {names && (
                  <span class="option-name" aria-hidden="true">
                    {tileOf(option)}
                    {noteOf && <small>{noteOf(option)}</small>}
                  </span>
                )}
              </div>
            ))}
          </div>
        ))}
    </div>
  );
}

/** Scrolls the list, and nothing around it, if the chosen option is not in view. Its neighbours are then in view too. */
function reveal(list: HTMLElement | null) {
  const option = list?.querySelector('[aria-selected=true]');
  // Nothing moves under the pointer: a click would hit another option.
  if (!list || !option || list.matches(':hover')) return;
  const { top, bottom } = list.getBoundingClientRect();
  const inner = option.getBoundingClientRect();
  // A search field may cover the padding.
  const end = bottom - Number.parseFloat(getComputedStyle(list).paddingBlockEnd);
  if (inner.top < top || inner.bottom > end) list.scrollTop += (inner.top + inner.bottom - top - end) / 2;
}

/** @returns the option for the key; undefined for other keys */
function target(key: string, options: HTMLElement[], at: number): number | undefined {
  const last = options.length - 1;
  switch (key) {
    case 'ArrowRight':
      return Math.min(last, at + 1);
    case 'ArrowLeft':
      return Math.max(0, at - 1);
    case 'ArrowDown':
      return nearest(options, at, 1);
    case 'ArrowUp':
      return nearest(options, at, -1);
    case 'Home':
      return 0;
    case 'End':
      return last;
    default:
      return undefined;
  }
}

/** The option in the next row that is closest to the same column. */
function nearest(options: HTMLElement[], at: number, way: 1 | -1) {
  const { left, top } = options[at].getBoundingClientRect();
  let best = at;
  let row = NaN;
  for (let i = at + way; i >= 0 && i < options.length; i += way) {
    const box = options[i].getBoundingClientRect();
    if (Math.abs(box.top - top) < 2) continue;
    if (Number.isNaN(row)) row = box.top;
    if (Math.abs(box.top - row) > 2) break;
    if (best === at || Math.abs(box.left - left) < Math.abs(options[best].getBoundingClientRect().left - left))
      best = i;
  }
  return best;
}
