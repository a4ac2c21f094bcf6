// @ts-check
/**
 * A page size of one's own: sides in pixels, millimetres or inches, and dots an inch. Live, as soon as the numbers
 * are a page.
 */

import { useState } from 'preact/hooks';
import { UNITS, lengthIn, pixelsOf, whyNotSize } from '../state/paper.js';
import { strings } from '../strings.js';
import { useApp } from './context.js';

/** @typedef {import('../state/paper.js').Unit} Unit */
/** @typedef {'width' | 'height' | 'dpi'} Field */

export function CustomSize() {
  const { store, pages } = useApp();
  const { settings } = store.project.value;
  const [unit, setUnit] = useState(/** @type {Unit} */ ('px'));
  /** What is being typed and is no page yet. */
  const [typed, setTyped] = useState(/** @type {Partial<Record<Field, string>>} */ ({}));
  const { width, height, dpi } = settings;
  const shown = {
    width: typed.width ?? String(lengthIn(width, unit, dpi)),
    height: typed.height ?? String(lengthIn(height, unit, dpi)),
    dpi: typed.dpi ?? String(dpi),
  };
  const wrong = whyNotSize(read(shown));

  /** @param {Record<Field, string>} fields */
  function read(fields) {
    const dots = Math.round(Number(fields.dpi));
    // What nobody touched keeps its pixels; a length that was rounded for the eye must not change them.
    const side = (/** @type {'width' | 'height'} */ name) => (
      fields[name] === String(lengthIn(settings[name], unit, dpi)) && dots === dpi ? settings[name] : pixelsOf(Number(fields[name]), unit, dots)
    );
    return { width: side('width'), height: side('height'), dpi: dots };
  }

  /** @param {Field} name @param {string} value */
  function type(name, value) {
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
      {/** @type {Field[]} */ (['width', 'height', 'dpi']).map((name) => (
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
        <select class="select" value={unit} onChange={(event) => {
          setTyped({});
          setUnit(/** @type {Unit} */ (event.currentTarget.value));
        }}>
          {UNITS.map((name) => <option key={name} value={name}>{strings.units[name]}</option>)}
        </select>
      </label>
      {wrong !== '' && <p class="custom-wrong" id="size-wrong" aria-live="polite">{strings.wrongSize[wrong]}</p>}
    </div>
  );
}
