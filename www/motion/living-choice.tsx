import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import type { AnimaticWish } from './animatics.ts';

/**
 * Switch for animated panels; hidden without panels from videos. @param props `note` is shown below if they are
 * possible
 */
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
