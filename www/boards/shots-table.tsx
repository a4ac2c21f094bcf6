/**
 * The shot list: an editable table like a spreadsheet. Enter goes to the next shot, Tab to the next field, and Escape
 * discards the typed text. Alt with the arrows moves a shot. Cells copied from a spreadsheet are pasted over several
 * cells.
 */

import { useEffect, useRef, useState } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { IconButton } from '../ui/button.tsx';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import { useListDrag } from '../ui/list-drag.ts';
import type { ListDrag } from '../ui/list-drag.ts';
import { Icon } from '../ui/icon.tsx';
import { importing } from '../ui/importing.ts';
import type { Column } from './boards.ts';
import { Frame } from './frame.tsx';
import type { Rate, ShotRow } from './shots.ts';
import { lengthText, USUAL_SECONDS } from './shots.ts';
import { explain } from '../ui/explain.ts';

export function ShotsTable() {
  const { boards, messages, actions } = useApp();
  const table = useRef(null as HTMLTableElement | null);
  const rows = boards.rows.value;
  const columns = boards.columns.value;
  const board = boards.board.value;
  const drag = useListDrag({ list: '.shots-scroll', item: 'tbody tr' }, boards.move);
  const gap = drag.carried?.gap ?? -1;

  /** @returns whether the cell exists */
  function focus(row: number, column: number): boolean {
    const cell = table.current?.querySelector<HTMLElement>(`[data-cell="${row} ${column}"]`);
    cell?.focus();
    return cell !== null && cell !== undefined;
  }

  async function copy() {
    const lines = rows.map((row) => columns.map((column) => boards.textOf(row, column)));
    try {
      const { tabbed } = await import('./imports.ts');
      await navigator.clipboard.writeText(tabbed([columns.map(headingOf), ...lines]));
      messages.note(strings.boards.copied);
    } catch (error) {
      messages.alert(strings.exportFailed({ why: explain(error) }));
    }
  }

  return (
    <section class="shots" aria-label={strings.boards.shots}>
      <div class="shots-head">
        <p>
          {strings.boards.count({ count: rows.length })} · <b>{lengthText(boards.total.value, board)}</b>
        </p>
        {board.order.length > 0 && <ActionButton action={actions.boards.followPages} class="button" text />}
        <NewColumn />
        <ActionButton
          action={{ label: strings.boards.copy, icon: 'duplicate', run: () => void copy() }}
          class="button"
          text
        />
      </div>
      <div class="shots-scroll" tabIndex={-1}>
        <table ref={table}>
          <caption class="visually-hidden">{strings.boards.help}</caption>
          <thead>
            <tr>
              <th scope="col">{strings.boards.picture}</th>
              {columns.map((column) => (
                <th
                  key={`${column.kind} ${column.id}`}
                  scope="col"
                  data-column={column.kind === 'own' ? 'own' : column.id}
                >
                  <Heading column={column} />
                </th>
              ))}
              <th scope="col">
                <span class="visually-hidden">{strings.boards.order}</span>
              </th>
            </tr>
          </thead>
          <tbody>
            {rows.map((row, at) => (
              <Row
                key={row.id}
                row={row}
                at={at}
                focus={focus}
                last={at === rows.length - 1}
                marked={gap === at ? 'before' : gap === rows.length && at === rows.length - 1 ? 'behind' : ''}
                drag={drag}
              />
            ))}
          </tbody>
        </table>
        <p class="quiet shots-help">{strings.boards.help}</p>
      </div>
    </section>
  );
}

function headingOf({ kind, id }: Column): string {
  return kind === 'own' ? id : strings.boards.columns[id as 'scene'];
}

function Heading({ column }: { column: Column }) {
  const { boards } = useApp();
  const name = headingOf(column);
  if (column.kind !== 'own') return <>{name}</>;
  return (
    <span class="shots-own">
      {name}
      <IconButton
        icon="close"
        label={strings.boards.removeColumn({ name })}
        onClick={() => boards.change({ columns: boards.board.peek().columns.filter((own) => own !== column.id) })}
      />
    </span>
  );
}

function NewColumn() {
  const { boards } = useApp();
  const [name, setName] = useState('');
  return (
    <form
      class="shots-column"
      onSubmit={(event) => {
        event.preventDefault();
        if (boards.addColumn(name)) setName('');
      }}
    >
      <input
        class="text"
        value={name}
        aria-label={strings.boards.newColumn}
        placeholder={strings.boards.newColumn}
        onInput={(event) => setName(event.currentTarget.value)}
      />
      <button type="submit" class="icon-button" aria-label={strings.boards.addColumn} title={strings.boards.addColumn}>
        <Icon name="add" />
      </button>
    </form>
  );
}

function Row({
  row,
  at,
  last,
  focus,
  marked,
  drag,
}: {
  row: ShotRow;
  at: number;
  last: boolean;
  focus: (row: number, column: number) => boolean;
  /** a shot that is carried would land on that side of it */
  marked: '' | 'before' | 'behind';
  drag: ListDrag;
}) {
  const { boards, store } = useApp();
  const name = store.album.value.get(row.id)?.name ?? row.id;

  function carry(by: number, column?: number) {
    boards.move(at, at + by);
    if (column !== undefined) requestAnimationFrame(() => focus(at + by, column));
  }

  return (
    <tr
      aria-label={strings.boards.shot({ number: row.number })}
      data-marked={marked || undefined}
      data-carried={drag.carried?.from === at || undefined}
    >
      <th scope="row">
        <span
          class="shot-picture"
          title={`${name}\n${strings.boards.dragHelp}`}
          onPointerDown={(event) => drag.take(event, at)}
        >
          <Frame id={row.id} />
          <b>{row.number}</b>
        </span>
      </th>
      {boards.columns.value.map((column, i) => (
        <td key={`${column.kind} ${column.id}`} data-label={headingOf(column)}>
          <Cell row={row} column={column} place={{ row: at, column: i }} focus={focus} carry={(by) => carry(by, i)} />
        </td>
      ))}
      <td class="shot-order">
        <div class="shot-tools">
          <span
            class="shot-handle"
            aria-hidden="true"
            title={strings.boards.dragHelp}
            onPointerDown={(event) => drag.take(event, at)}
          >
            <Icon name="handle" />
          </span>
          <IconButton
            icon="unfold"
            label={strings.boards.up({ number: row.number })}
            disabled={at === 0}
            onClick={() => carry(-1)}
          />
          <IconButton
            icon="fold"
            label={strings.boards.down({ number: row.number })}
            disabled={last}
            onClick={() => carry(1)}
          />
        </div>
      </td>
    </tr>
  );
}

function Cell({
  row,
  column,
  place,
  focus,
  carry,
}: {
  row: ShotRow;
  column: Column;
  place: { row: number; column: number };
  focus: (row: number, column: number) => boolean;
  carry: (by: number) => void;
}) {
  const { boards, messages } = useApp();
  const ref = useRef(null as HTMLTextAreaElement | null);
  const told = boards.textOf(row, column);
  const [typed, setTyped] = useState(null as string | null);
  const text = typed ?? told;
  const name = `${headingOf(column)}, ${strings.boards.shot({ number: row.number })}`;
  /** Discarded text is not applied when the cell loses the focus. */
  const given = useRef(false);

  useEffect(() => {
    const cell = ref.current;
    if (!cell) return;
    // As high as its content.
    cell.style.height = 'auto';
    cell.style.height = `${cell.scrollHeight + 2}px`;
  }, [text]);

  function take(now: string) {
    setTyped(null);
    if (given.current || now.trim() === told) return;
    if (boards.put(place, [[now]]) > 0) messages.alert(strings.boards.noLength({ text: now.trim() }));
  }

  function onKeyDown(event: KeyboardEvent & { currentTarget: HTMLTextAreaElement }) {
    const { key, altKey, shiftKey, currentTarget } = event;
    const by = { ArrowUp: -1, ArrowDown: 1 }[key];
    if (altKey && by !== undefined) {
      event.preventDefault();
      take(currentTarget.value);
      carry(by);
    } else if (key === 'Enter' && !shiftKey && !event.isComposing) {
      event.preventDefault();
      take(currentTarget.value);
      focus(place.row + 1, place.column);
    } else if (key === 'Escape') {
      event.preventDefault();
      event.stopPropagation();
      given.current = true;
      setTyped(null);
      currentTarget.closest<HTMLElement>('.shots-scroll')?.focus();
      given.current = false;
    }
  }

  async function paste(event: ClipboardEvent) {
    const pasted = event.clipboardData?.getData('text/plain').replace(/\r\n?/g, '\n').replace(/\n$/, '') ?? '';
    if (!/[\t\n]/.test(pasted) || (!pasted.includes('\t') && column.kind === 'field' && isProse(pasted))) return;
    event.preventDefault();
    setTyped(null);
    const { cells } = await import('./imports.ts');
    const lost = boards.put(place, cells(pasted, '\t'));
    if (lost > 0) messages.alert(strings.boards.pasteLost({ count: lost }));
  }

  return (
    <textarea
      ref={ref}
      rows={1}
      class="shot-cell"
      data-cell={`${place.row} ${place.column}`}
      data-column={column.kind === 'own' ? 'own' : column.id}
      aria-label={name}
      placeholder={placeholderOf(row, column, boards.board.value)}
      value={text}
      onInput={(event) => setTyped(event.currentTarget.value)}
      onBlur={(event) => take(event.currentTarget.value)}
      onKeyDown={onKeyDown}
      onPaste={(event) => void importing(messages, strings.boards.shots, () => paste(event))}
    />
  );
}

/** A text with blank lines is not a column of a spreadsheet. */
function isProse(text: string): boolean {
  return text.includes('\n\n');
}

/** The value of an empty cell. */
function placeholderOf({ number }: ShotRow, { id, kind }: Column, rate: Rate): string | undefined {
  if (kind === 'length') return lengthText(USUAL_SECONDS * rate.fps, rate);
  return kind === 'field' && id === 'number' ? number : undefined;
}
