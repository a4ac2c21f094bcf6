/**
 * A control for a parameter of a block, by its descriptor: a slider with a number field, a switch, a choice, a colour,
 * a picture, or a model.
 */

import { ModelChoice } from './model-choice.tsx';
import { TextureChoice } from './texture-choice.tsx';
import { strings } from '../strings/strings.ts';
import type { BlockParam, ParamValue } from '../engine/types.ts';

/** @param props `onMove`: in the middle of a drag, which `onRest` ends */
export function Parameter({
  block,
  param,
  value,
  onMove,
  onSet,
  onRest,
}: {
  block: string;
  param: BlockParam;
  value: ParamValue;
  onMove: (value: ParamValue) => void;
  onSet: (value: ParamValue) => void;
  onRest: () => void;
}) {
  const { kind } = param;
  const label = strings.parameterName(block, param);
  const help = strings.parameterHelp(block, param);
  if (kind === 'boolean') {
    return (
      <label class="parameter switch" title={help}>
        <input type="checkbox" checked={value === true} onChange={(event) => onSet(event.currentTarget.checked)} />
        <span>{label}</span>
      </label>
    );
  }
  if (kind === 'colour') {
    return (
      <label class="parameter switch" title={help}>
        <input
          type="color"
          value={String(value)}
          onInput={(event) => onMove(event.currentTarget.value)}
          onChange={(event) => onSet(event.currentTarget.value)}
        />
        <span>{label}</span>
      </label>
    );
  }
  if (kind === 'choice') {
    return (
      <label class="parameter choice" title={help}>
        <span>{label}</span>
        <select class="select" value={String(value)} onChange={(event) => onSet(event.currentTarget.value)}>
          {param.choices?.map((name) => (
            <option key={name} value={name}>
              {strings.choiceName(name)}
            </option>
          ))}
        </select>
      </label>
    );
  }
  if (kind === 'texture') return <TextureChoice label={label} help={help} value={String(value)} onSet={onSet} />;
  if (kind === 'model') return <ModelChoice label={label} help={help} value={String(value)} onSet={onSet} />;
  return (
    <Range
      param={param}
      label={label}
      help={help}
      value={Number(value)}
      onMove={onMove}
      onSet={onSet}
      onRest={onRest}
    />
  );
}

function Range({
  param: { min = 0, max = 1, step = 1, unit = '', default: standard },
  label,
  help,
  value: set,
  onMove,
  onSet,
  onRest,
}: {
  param: BlockParam;
  label: string;
  help: string;
  value: number;
  onMove: (value: number) => void;
  onSet: (value: number) => void;
  onRest: () => void;
}) {
  // A style may be for a model with more painters.
  const value = Math.min(set, max);
  const usual = Number(standard);
  const mark = (usual - min) / (max - min);
  const told = (number: number) => `${strings.decimal(number)}${unit ? ` ${unit}` : ''}`;
  return (
    <div class="parameter" title={help}>
      <span class="parameter-name" aria-hidden="true">
        {label}
      </span>
      <span class="parameter-number">
        <input
          class="number"
          type="number"
          aria-label={strings.numberOf({ label })}
          min={min}
          max={max}
          step={step}
          value={value}
          onChange={({ currentTarget }) => {
            const typed = currentTarget.valueAsNumber;
            if (Number.isFinite(typed)) onSet(rounded(Math.min(max, Math.max(min, typed)), step));
            // Typed text may be invalid, so the field shows the accepted value.
            currentTarget.value = String(
              Number.isFinite(typed) ? rounded(Math.min(max, Math.max(min, typed)), step) : value,
            );
          }}
        />
        <span class="unit">{unit}</span>
      </span>
      <span class="parameter-slider" style={{ '--usual': mark }} data-usual={value === usual}>
        <input
          type="range"
          aria-label={label}
          aria-valuetext={told(value)}
          min={min}
          max={max}
          step={step}
          value={value}
          onInput={(event) => onMove(rounded(event.currentTarget.valueAsNumber, step))}
          onChange={onRest}
          onDblClick={() => onSet(usual)}
        />
        <i class="usual-mark" title={strings.defaultIs({ value: told(usual) })} />
      </span>
    </div>
  );
}

/** Rounds to the digits of the step, or to more digits if the user types them. */
function rounded(value: number, step: number) {
  if (Number.isInteger(step)) return Math.round(value);
  const digits = (String(step).split('.')[1] ?? '').length + 1;
  return Number(value.toFixed(digits));
}
