/** Settings of the storyboard sheets: layout and header. */

import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import { LogoChoice } from './logo-choice.tsx';
import { ASPECTS, PER_SHEET, RATES, rateName } from './shots.ts';

/** Sorted by rate. Object keys that are integers would come first. */
const RATE_NAMES = Object.keys(RATES).sort((a, b) => Number.parseFloat(a) - Number.parseFloat(b));

export function BoardSettings() {
  const { boards, actions } = useApp();
  const board = boards.board.value;
  return (
    <div class="board-settings">
      <Choice
        label={strings.boards.perSheet}
        value={board.frames}
        values={PER_SHEET}
        onValue={(frames) => boards.change({ frames })}
      />
      <Choice
        label={strings.boards.aspect}
        value={board.aspect}
        values={Object.keys(ASPECTS)}
        onValue={(aspect) => boards.change({ aspect })}
      />
      <Choice
        label={strings.boards.rate}
        value={rateName(board)}
        values={RATE_NAMES}
        onValue={(name) => boards.change({ pace: undefined, ...RATES[name] })}
      />
      <Line name="author" label={strings.boards.author} />
      <Line name="date" label={strings.boards.date} />
      <LogoChoice />
      <label class="choice">
        <input
          type="checkbox"
          checked={board.beside}
          onChange={(event) => boards.change({ beside: event.currentTarget.checked })}
        />
        {strings.boards.beside}
      </label>
      <label class="choice">
        <input
          type="checkbox"
          checked={board.ruled}
          onChange={(event) => boards.change({ ruled: event.currentTarget.checked })}
        />
        {strings.boards.ruled}
      </label>
      <ActionButton action={actions.boards.filmBoard} class="button" text />
    </div>
  );
}

function Choice<T extends string | number>({
  label,
  value,
  values,
  onValue,
}: {
  label: string;
  value: T;
  values: readonly T[];
  onValue: (value: T) => void;
}) {
  return (
    <label class="field">
      <span>{label}</span>
      <select
        class="select"
        value={String(value)}
        onChange={(event) => {
          const chosen = values.find((one) => String(one) === event.currentTarget.value);
          if (chosen !== undefined) onValue(chosen);
        }}
      >
        {values.map((one) => (
          <option key={one} value={String(one)}>
            {one}
          </option>
        ))}
      </select>
    </label>
  );
}

function Line({ name, label }: { name: 'author' | 'date'; label: string }) {
  const { boards } = useApp();
  return (
    <label class="field">
      <span>{label}</span>
      <input
        class="text"
        value={boards.board.value[name]}
        maxLength={200}
        onChange={(event) => boards.change({ [name]: event.currentTarget.value.trim() })}
      />
    </label>
  );
}
