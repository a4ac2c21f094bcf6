/**
 * Shuffle, the big button, and its three parts, each with its lock.
 */

import { useApp } from '../ui/context.ts';
import { ActionButton } from '../ui/action-button.tsx';

export function ShuffleButton() {
  const { page } = useApp().actions;
  return <ActionButton action={page.shuffle} class="shuffle" text />;
}

export function ShuffleParts() {
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
    </div>
  );
}
