/** A stack of near-duplicates: closed, the used photo represents all. Open, each photo can be used. */

import { useEffect, useRef } from 'preact/hooks';
import { isUsed } from '../document/album.ts';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { PhotoTile } from './photo-tile.tsx';
import type { Verdict } from '../document/album.ts';
import type { TrayItem } from '../document/project.ts';

/** The stack of each photo that has one. */
export function stacks(tray: readonly TrayItem[], verdicts: ReadonlyMap<string, Verdict>): Map<string, TrayItem[]> {
  const groups: Map<number, TrayItem[]> = new Map();
  for (const item of tray) {
    const group = verdicts.get(item.id)?.group;
    if (group !== undefined) groups.set(group, [...(groups.get(group) ?? []), item]);
  }
  const several = [...groups.values()].filter((items) => items.length > 1);
  return new Map(several.flatMap((items) => items.map((item) => [item.id, items])));
}

export function Stack({ items }: { items: TrayItem[] }) {
  const { store, choosing, ui } = useApp();
  const button = useRef(null as HTMLButtonElement | null);
  const verdicts = store.verdicts.value;
  const ids = items.map(({ id }) => id);
  const used = items.filter((item) => isUsed(item, verdicts));
  // The button that opened it is gone.
  useEffect(() => button.current?.focus(), []);
  return (
    <li class="stack">
      <button
        ref={button}
        type="button"
        class="stack-head"
        aria-expanded="true"
        onClick={() => {
          ui.stack.value = null;
        }}
      >
        <span>{strings.stackOf({ count: items.length })}</span>
        <Icon name="close" />
      </button>
      <p class="aside-why">{strings.stackWhy}</p>
      <ul class="photos">
        {items.map((item) => (
          <PhotoTile
            key={item.id}
            item={item}
            used={used.includes(item)}
            onTake={used.length === 1 && used[0] === item ? undefined : () => choosing.take(item.id, ids)}
          />
        ))}
      </ul>
    </li>
  );
}
