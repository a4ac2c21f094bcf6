/** Print options of a PDF file: bleed and marks, imposition, ink plates. */

import { strings } from '../strings/strings.ts';
import type { Bleed, Paper, Print, Sheets } from './print.ts';
import { blanks } from './print.ts';

const BLEEDS: readonly Bleed[] = ['none', 'mm3', 'inch', 'mm5'];
const SHEETS: readonly Sheets[] = ['none', 'booklet', 'zine', 'twoUp', 'spreads'];
const PAPERS: readonly Paper[] = ['none', 'a4', 'a3', 'letter', 'tabloid'];

export function PrintOptions({
  print,
  change,
  pages,
  plates,
  home,
}: {
  print: Print;
  change: (part: Partial<Print>) => void;
  pages: number;
  /** Whether the pages are printed with inks. */
  plates: boolean;
  /** The paper size of home printers. */
  home: Paper;
}) {
  const words = strings.print;
  const empty = blanks(print.sheets, pages);
  return (
    <>
      {pages > 1 && (
        <Choice
          name={words.sheets}
          value={print.sheets}
          options={SHEETS}
          labels={words.impositions}
          // Eight pages at full size are a poster. A zine fits the paper of a home printer.
          choose={(sheets) =>
            change({ sheets, paper: sheets === 'zine' && print.paper === 'none' ? home : print.paper })
          }
        />
      )}
      {print.sheets !== 'none' && pages > 1 && (
        <>
          <p class="quiet print-help">
            {words[print.sheets]} {empty > 0 && words.blanks({ n: empty })}
          </p>
          <Choice
            name={words.paperSize}
            value={print.paper}
            options={PAPERS}
            labels={words.papers}
            choose={(paper) => change({ paper })}
          />
        </>
      )}
      <Choice
        name={words.bleed}
        value={print.bleed}
        options={BLEEDS}
        labels={words.bleeds}
        choose={(bleed) => change({ bleed })}
      />
      {print.bleed !== 'none' && <p class="quiet print-help">{words.bleedHelp}</p>}
      <Switch label={words.marks} on={print.marks} turn={(marks) => change({ marks })} />
      {plates && <Switch label={words.plates} on={print.plates} turn={(on) => change({ plates: on })} />}
      {plates && print.plates && <p class="quiet print-help">{words.platesHelp}</p>}
    </>
  );
}

function Choice<T extends string>({
  name,
  value,
  options,
  labels,
  choose,
}: {
  name: string;
  value: T;
  options: readonly T[];
  labels: Record<T, string>;
  choose: (value: T) => void;
}) {
  return (
    <label class="field">
      <span>{name}</span>
      <select class="select" value={value} onChange={(event) => choose(event.currentTarget.value as T)}>
        {options.map((id) => (
          <option key={id} value={id}>
            {labels[id]}
          </option>
        ))}
      </select>
    </label>
  );
}

function Switch({ label, on, turn }: { label: string; on: boolean; turn: (on: boolean) => void }) {
  return (
    <label class="choice">
      <input type="checkbox" checked={on} onChange={(event) => turn(event.currentTarget.checked)} />
      {label}
    </label>
  );
}
