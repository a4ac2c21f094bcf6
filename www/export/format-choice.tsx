/** The format of an export: tiles for the kinds of files, then the formats of the chosen kind. */

import { KINDS, wayOf, WAYS, withWay } from './export-choice.ts';
import { isBoard, isBook, isList } from './formats.ts';
import { strings } from '../strings/strings.ts';
import type { Choice, Kind } from './export-choice.ts';
import type { Way } from './formats.ts';

export type ChoiceProps = { choice: Choice; choose: (choice: Choice) => void };

/** @param props `board`: whether the sheets of the storyboard are a choice */
export function KindChoice({ choice, choose, board }: ChoiceProps & { board: boolean }) {
  return (
    <fieldset class="export-kinds">
      <legend class="visually-hidden">{strings.format}</legend>
      {[...(board ? ['board' as const] : []), ...KINDS].map((kind) => (
        <label class="export-kind" key={kind}>
          <input
            type="radio"
            name="export-kind"
            checked={choice.kind === kind}
            aria-labelledby={`export-kind-${kind}`}
            aria-describedby={`export-kind-${kind}-help`}
            onChange={() => choose({ ...choice, kind })}
          />
          <span id={`export-kind-${kind}`}>{kindName(kind)}</span>
          <small id={`export-kind-${kind}-help`}>{strings.exportKindHelp[kind]}</small>
        </label>
      ))}
    </fieldset>
  );
}

/** The formats of the chosen kind, and one line about the chosen format. */
export function FormatChoice({ choice, choose }: ChoiceProps) {
  const ways = WAYS[choice.kind];
  const way = wayOf(choice);
  const help = helpOf(way);
  return (
    <>
      {ways.length > 1 && (
        <fieldset class="export-formats">
          <legend class="visually-hidden">{kindName(choice.kind)}</legend>
          {ways.map((id) => (
            <label class="export-format" key={id}>
              <input
                type="radio"
                name="export-format"
                checked={way === id}
                aria-describedby={help ? 'export-help' : undefined}
                onChange={() => choose(withWay(choice, id))}
              />
              {isBoard(id) ? strings.boards.ways[id === 'boardPdf' ? 'pdf' : 'zip'] : strings.exportFormats[id]}
            </label>
          ))}
        </fieldset>
      )}
      {help && (
        <p class="quiet export-help" id="export-help">
          {help}
        </p>
      )}
      {way === 'cbz' && (
        <label class="field">
          <span>{strings.pictures}</span>
          <select
            class="select"
            value={choice.inside}
            onChange={({ currentTarget }) => choose({ ...choice, inside: currentTarget.value as Choice['inside'] })}
          >
            <option value="png">{strings.insides.png}</option>
            <option value="jpeg">{strings.insides.jpeg}</option>
          </select>
        </label>
      )}
    </>
  );
}

function kindName(kind: Kind): string {
  return kind === 'board' ? strings.boards.board : strings.exportKinds[kind];
}

/** Videos have their own help next to the player. */
function helpOf(way: Way): string | undefined {
  if (isBook(way)) return strings.bookHelp[way];
  if (isBoard(way)) return strings.boards.boardHelp;
  if (isList(way)) return strings.boards.listHelp;
  return (strings.formatHelp as Partial<Record<Way | Kind, string>>)[way];
}
