/**
 * Shuffle, the big button, and its three parts, each with its lock.
 */

import { useApp } from '../ui/context.ts';
import { ActionButton } from '../ui/action-button.tsx';

export function ShuffleButton() {
  const { page } = useApp().actions;
  return <ActionButton action={page.shuffle} class="shuffle" text />;
}

/** @param props `heart`: includes the heart of the page, for screens that show it nowhere else */
export function ShuffleParts({ heart = false }: { heart?: boolean }) {
  const { page } = useApp().actions;
  const parts = [
    { shuffle: page.shuffleLayout, lock: page.lockLayout },
    { shuffle: page.shuffleStyle, lock: page.lockStyle },
    { shuffle: page.shufflePhotos, lock: page.lockPhotos },
  ];
  return (
    <div class="parts">
      {parts.map(({ shuffle, lock }) => (
        <div class="part" key={shuffle.label} data-locked={lock.on.value}>
          <ActionButton action={shuffle} class="part-shuffle" text />
          <ActionButton action={lock} class="part-lock" />
        </div>
      ))}
      {heart && <ActionButton action={page.favourite} class="icon-button page-heart" />}
    </div>
  );
}
