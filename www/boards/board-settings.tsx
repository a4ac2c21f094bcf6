/** How the sheets of the board are laid out, and what stands in their heads. */

import type { Board } from '../engine/types.ts';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { ASPECTS, PER_SHEET, RATES } from './shots.ts';

export function BoardSettings() {
  const { boards } = useApp();
  const board = boards.board.value;
  return (
    <div class="board-settings">
      <button type="button" class="button" onClick={boards.filmBoard}>
        <Icon name="style" />
        {strings.boards.filmBoard}
      </button>
      <Choice name="frames" label={strings.boards.perSheet} values={PER_SHEET} />
      <Choice name="aspect" label={strings.boards.aspect} values={Object.keys(ASPECTS)} />
      <Choice name="fps" label={strings.boards.rate} values={RATES} />
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
      <Line name="author" label={strings.boards.author} />
      <Line name="date" label={strings.boards.date} />
    </div>
  );
}

function Choice<T extends string | number>({
  name,
  label,
  values,
}: {
  name: 'frames' | 'aspect' | 'fps';
  label: string;
  values: readonly T[];
}) {
  const { boards } = useApp();
  return (
    <label class="field">
      <span>{label}</span>
      <select
        class="select"
        value={String(boards.board.value[name])}
        onChange={(event) => {
          const value = values.find((one) => String(one) === event.currentTarget.value);
          boards.change({ [name]: value } as Partial<Board>);
        }}
      >
        {values.map((value) => (
          <option key={value} value={String(value)}>
            {value}
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
