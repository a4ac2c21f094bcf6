/**
 * Form for a custom page size: width and height in pixels, millimetres or inches, and DPI. It changes the page as soon
 * as the numbers are valid.
 */

import { useState } from 'preact/hooks';
import { UNITS, lengthIn, pixelsOf, whyNotSize } from './paper.ts';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import type { Unit } from './paper.ts';

type Field = 'width' | 'height' | 'dpi';

export function CustomSize() {
  const { store, pages } = useApp();
  const { settings } = store.project.value;
  const [unit, setUnit] = useState('px' as Unit);
  /** Input that is not a valid size yet. */
  const [typed, setTyped] = useState({} as Partial<Record<Field, string>>);
  const { width, height, dpi } = settings;
  const shown = {
    width: typed.width ?? String(lengthIn(width, unit, dpi)),
    height: typed.height ?? String(lengthIn(height, unit, dpi)),
    dpi: typed.dpi ?? String(dpi),
  };
  const wrong = whyNotSize(read(shown));

  function read(fields: Record<Field, string>) {
    const dots = Math.round(Number(fields.dpi));
    // An unchanged field retains its exact pixels, because the displayed length is rounded.
    const side = (name: 'width' | 'height') =>
      fields[name] === String(lengthIn(settings[name], unit, dpi)) && dots === dpi
        ? settings[name]
        : pixelsOf(Number(fields[name]), unit, dots);
    return { width: side('width'), height: side('height'), dpi: dots };
  }

  function type(name: Field, value: string) {
    const fields = { ...shown, [name]: value };
    const size = read(fields);
    if (whyNotSize(size)) {
      setTyped({ ...typed, [name]: value });
      return;
    }
    setTyped({ [name]: value });
    pages.changeSettings(size, `size-${name}`);
  }

  return (
    <div class="custom-size">
      {(['width', 'height', 'dpi'] as Field[]).map((name) => (
        <label class="field stacked" key={name}>
          <span>{strings.customSize[name]}</span>
          <input
            class="number"
            type="number"
            inputMode="decimal"
            min="0"
            step="any"
            value={shown[name]}
            aria-invalid={wrong !== '' && (wrong === 'dpi') === (name === 'dpi')}
            aria-describedby={wrong ? 'size-wrong' : undefined}
            onInput={(event) => type(name, event.currentTarget.value)}
            onBlur={() => setTyped({})}
          />
        </label>
      ))}
      <label class="field stacked">
        <span>{strings.customSize.unit}</span>
        <select
          class="select"
          value={unit}
          onChange={(event) => {
            setTyped({});
            setUnit(event.currentTarget.value as Unit);
          }}
        >
          {UNITS.map((name) => (
            <option key={name} value={name}>
              {strings.units[name]}
            </option>
          ))}
        </select>
      </label>
      {wrong !== '' && (
        <p class="custom-wrong" id="size-wrong" aria-live="polite">
          {strings.wrongSize[wrong]}
        </p>
      )}
    </div>
  );
}
