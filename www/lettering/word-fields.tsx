/** Settings of one text item. */

import { useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { subjectOf } from '../page/subjects-of.ts';
import type { Word } from '../engine/types.ts';
import { balloonBefore, hangsOn } from './joining.ts';
import { LEAST_SIZE, MOST_SIZE, unitsOf } from './word-units.ts';
import type { Unit } from './word-units.ts';

type AmountProps = {
  label: string;
  value: number;
  least: number;
  most: number;
  step?: number;
  unit?: string;
  digits?: number;
  onValue: (value: number) => void;
};

/** Default outline of a sound effect, in ems; half the width of the line. */
const USUAL_OUTLINE = 0.06;

/** Whether a text item is set in capitals. By default, letterers do so except for sound effects. */
export function capitals({ capitals, kind }: Word): boolean {
  return capitals ?? kind !== 'effect';
}

/** Limits of the width, in page widths. */
const [NARROWEST, WIDEST] = [0.04, 0.96];

/** A readable name of a character. Private-use characters are invisible, so they get their code point. */
function named(letter: string): string {
  if (!/\p{Co}/u.test(letter)) return letter;
  return `U+${(letter.codePointAt(0) ?? 0).toString(16).toUpperCase().padStart(4, '0')}`;
}

export function WordFields({ index }: { index: number }) {
  const { store, ui, lettering, actions } = useApp();
  const words = lettering.words.value;
  const word = words[index];
  const hangs = hangsOn(words, index) >= 0;
  const box = lettering.boxes.value[index];
  const height = store.geometry.value?.height ?? 1;
  const gesture = useRef(lettering.step());
  if (!box) return null;
  const rest = () => {
    gesture.current = lettering.step();
  };
  const set = (news: Partial<Word>) => lettering.edit(index, news, gesture.current);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const { length, text } = unitsOf(store.page.value?.page ?? store.project.value.settings);

  // Whether the subject is known that a sound effect would be behind.
  const isKnown = subjectOf(store, word) !== '';
  const missing = [...lettering.missing(word.text, box.font)].map(named).join(' ');

  return (
    <div class="word-fields">
      {/* The bar next to the page has all tools. On a small screen, the drawer replaces it. */}
      {!ui.wide.value && (
        <div class="word-deeds">
          {[actions.text.edit, actions.text.place, actions.text.remove].map((action) => (
            <ActionButton key={action.label} action={action} class="tool" text />
          ))}
        </div>
      )}
      {lettering.mode.value && (
        <p class="quiet" role="note">
          {strings.wordModes[lettering.mode.value]}
        </p>
      )}
      {box.cut && (
        <p class="quiet" role="note">
          {strings.wordCut}
        </p>
      )}
      {missing && (
        <p class="quiet" role="note">
          {strings.wordMissing({ letters: missing })}
        </p>
      )}
      {!missing && lettering.foreign(word.text) && (
        <p class="quiet" role="note">
          {strings.wordForeign}
        </p>
      )}
      {word.kind === 'balloon' && (
        <Choice
          label={strings.shape}
          value={word.shape ?? 'oval'}
          names={strings.shapes}
          onValue={(shape) => set({ shape: shape as 'oval' })}
        />
      )}
      <Choice
        label={strings.wordFont}
        value={box.font}
        names={strings.fonts}
        onValue={(value) => set({ font: value })}
      />
      <div class="word-numbers" onFocusOut={rest}>
        <Amount
          label={strings.wordX}
          {...amountIn(length)}
          value={x * length.per}
          least={0}
          most={length.per}
          onValue={(value) => lettering.move(index, [value / length.per, y], gesture.current)}
        />
        <Amount
          label={strings.wordY}
          {...amountIn(length)}
          value={y * length.per}
          least={0}
          most={height * length.per}
          onValue={(value) => lettering.move(index, [x, value / length.per], gesture.current)}
        />
        <Amount
          label={strings.wordWidth}
          {...amountIn(length)}
          value={(word.width ?? box.width) * length.per}
          least={NARROWEST * length.per}
          most={WIDEST * length.per}
          onValue={(value) => set({ width: Math.min(WIDEST, Math.max(NARROWEST, value / length.per)) })}
        />
        <Amount
          label={strings.wordSize}
          {...amountIn(text)}
          value={box.size * text.per}
          least={LEAST_SIZE * text.per}
          most={MOST_SIZE * text.per}
          onValue={(value) => set({ size: Math.min(MOST_SIZE, Math.max(LEAST_SIZE, value / text.per)) })}
        />
        {word.kind === 'effect' && (
          <Amount
            label={strings.wordAngle}
            unit="°"
            value={word.angle ?? 0}
            least={-180}
            most={180}
            onValue={(angle) => set({ angle })}
          />
        )}
        {word.kind === 'effect' && (
          <Amount
            label={strings.wordArc}
            unit="%"
            value={(word.arc ?? 0) * 100}
            least={-100}
            most={100}
            step={5}
            onValue={(value) => set({ arc: value / 100 })}
          />
        )}
        {word.kind === 'effect' && (
          <Amount
            label={strings.wordSlant}
            unit="°"
            value={word.slant ?? 0}
            least={-45}
            most={45}
            onValue={(slant) => set({ slant })}
          />
        )}
        {word.kind === 'effect' && (
          <Amount
            label={strings.wordOutline}
            unit="%"
            value={(word.outline ?? USUAL_OUTLINE) * 100}
            least={0}
            most={40}
            onValue={(value) => set({ outline: value / 100 })}
          />
        )}
      </div>
      {actions.text.match.enabled.value && <ActionButton action={actions.text.match} class="button small" text />}
      <div class="word-switches">
        <Switch label={strings.wordCapitals} on={capitals(word)} onChange={(on) => set({ capitals: on })} />
        <Switch label={strings.wordVertical} on={word.vertical ?? false} onChange={(vertical) => set({ vertical })} />
        {(hangs || balloonBefore(words, index) >= 0) && (
          <Switch label={strings.wordJoin} on={hangs} onChange={(on) => lettering.join(index, on)} />
        )}
        {word.kind === 'caption' && (
          <Switch label={strings.wordBoxless} on={word.boxless ?? false} onChange={(boxless) => set({ boxless })} />
        )}
        {word.kind === 'effect' && (word.behind || isKnown) && (
          <Switch label={strings.wordBehind} on={word.behind ?? false} onChange={(behind) => set({ behind })} />
        )}
      </div>
      {word.kind === 'effect' && word.behind && !isKnown && (
        <p class="quiet" role="note">
          {strings.wordBehindWhy}
        </p>
      )}
      <div class="word-colours">
        {(['color', 'fill'] as const).map((name) => (
          <label class="field colour" key={name}>
            <span>{name === 'color' ? strings.wordColor : strings.wordFill}</span>
            <input
              type="color"
              value={box[name]}
              onInput={({ currentTarget }) => set({ [name]: currentTarget.value })}
              onChange={rest}
            />
          </label>
        ))}
      </div>
    </div>
  );
}

function Switch({ label, on, onChange }: { label: string; on: boolean; onChange: (on: boolean) => void }) {
  return (
    <label class="check">
      <input type="checkbox" checked={on} onChange={({ currentTarget }) => onChange(currentTarget.checked)} />
      <span>{label}</span>
    </label>
  );
}

function Choice({
  label,
  value,
  names,
  onValue,
}: {
  label: string;
  value: string;
  names: Record<string, string>;
  onValue: (value: string) => void;
}) {
  return (
    <label class="field">
      <span>{label}</span>
      <select class="select" value={value} onChange={({ currentTarget }) => onValue(currentTarget.value)}>
        {Object.entries(names).map(([id, name]) => (
          <option key={id} value={id}>
            {name}
          </option>
        ))}
      </select>
    </label>
  );
}

/** The unit of an amount, and its steps. */
function amountIn({ unit, digits }: Unit) {
  return { unit, digits, step: unit === 'pt' ? 0.5 : 1 };
}

/** A number with its unit. Numbers out of range are not accepted. */
function Amount({ label, value, least, most, step = 1, unit = '', digits = 1, onValue }: AmountProps) {
  const round = (number: number) => Number(number.toFixed(digits));
  return (
    <label class="field">
      <span>{label}</span>
      <span class="amount">
        <input
          type="number"
          min={round(least)}
          max={round(most)}
          step={step}
          aria-description={unit || undefined}
          value={round(value)}
          onChange={({ currentTarget }) => {
            const number = currentTarget.valueAsNumber;
            if (number >= round(least) && number <= round(most)) onValue(number);
            else currentTarget.value = String(round(value));
          }}
        />
        {unit && <small aria-hidden="true">{unit}</small>}
      </span>
    </label>
  );
}
