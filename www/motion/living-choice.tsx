import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import type { AnimaticWish } from './animatics.ts';

/** Whether panels that come from films move; nothing where there are none. @param props `note` stands below where they may */
export function LivingChoice({
  of,
  on,
  set,
  note,
}: {
  of: AnimaticWish['of'];
  on: boolean;
  set: (on: boolean) => void;
  note?: string;
}) {
  const may = useApp().animatics.living(of);
  if (may === 'none') return null;
  const below = may === 'apart' ? strings.motion.apart : note;
  return (
    <>
      <label class="choice">
        <input
          type="checkbox"
          checked={on && may === 'some'}
          disabled={may === 'apart'}
          aria-describedby={below ? 'living-note' : undefined}
          onChange={(event) => set(event.currentTarget.checked)}
        />
        {strings.motion.living}
      </label>
      {below && (
        <p class="quiet" id="living-note">
          {below}
        </p>
      )}
    </>
  );
}
