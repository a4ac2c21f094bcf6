/**
 * The page's size, lengths and colours, all live. One drag of a slider is one step of the undo.
 */

import { useEffect, useRef, useState } from 'preact/hooks';
import { PAGE_SIZES, sizeId } from './paper.ts';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { CustomSize } from './custom-size.tsx';
import { PageDescription } from './page-description.tsx';
import type { PageSettings } from '../engine/types.ts';

/** Lengths, in hundredths of the page's width. */
const LENGTHS: { name: 'gutter' | 'margin' | 'border' | 'cornerRadius'; most: number; step: number }[] = [
  { name: 'gutter', most: 6, step: 0.1 },
  { name: 'margin', most: 10, step: 0.1 },
  { name: 'border', most: 1.5, step: 0.05 },
  { name: 'cornerRadius', most: 6, step: 0.1 },
];

const COLOURS: ('paper' | 'borderColor')[] = ['paper', 'borderColor'];
const PURPOSES = ['paper', 'book', 'screen'] as const;

export function PageSettingsForm() {
  const { store, pages, book, bookMaking, messages, narrating, ui } = useApp();
  const { settings } = store.project.value;
  const drags = useRef(0);
  /** Whether the user selected a custom size. It may equal a known size for a while. */
  const [custom, setCustom] = useState(false);
  const size = custom ? 'custom' : sizeId(settings);

  /** The drag that has changed only the visible page so far. */
  const held = useRef('');

  const change = (name: keyof PageSettings, value: number | string) => {
    held.current = `${name}-${drags.current}`;
    pages.changeSettings({ [name]: value }, held.current, { held: true });
  };
  const rest = () => {
    if (held.current) pages.changeSettings({}, held.current);
    held.current = '';
    drags.current += 1;
  };
  function turnPlaces(on: boolean) {
    narrating.turnPlaces(on);
    if (book.isMade.peek())
      messages.note(strings.placesInBook, { label: strings.book.again, run: () => void bookMaking.again() });
  }
  // Ends the drag if the form unmounts.
  useEffect(() => rest, []);

  function resize(id: string) {
    setCustom(id === 'custom');
    const found = PAGE_SIZES.find((other) => other.id === id);
    if (found) pages.changeSettings({ width: found.width, height: found.height, dpi: found.dpi });
  }

  return (
    <section class="settings" aria-label={strings.pageSettings}>
      <label class="field">
        <span>{strings.pageSize}</span>
        <select class="select" value={size} onChange={(event) => resize(event.currentTarget.value)}>
          {PURPOSES.map((purpose) => (
            <optgroup key={purpose} label={strings.print.purpose[purpose]}>
              {PAGE_SIZES.filter((other) => other.purpose === purpose).map(({ id }) => (
                <option key={id} value={id}>
                  {strings.size[id]}
                </option>
              ))}
            </optgroup>
          ))}
          <option value="custom">{strings.size.custom}</option>
        </select>
      </label>
      {size === 'custom' && <CustomSize />}
      <fieldset class="text-use">
        <legend>{strings.textUse}</legend>
        {([true, false] as const).map((forScreens) => (
          <label class="choice" key={String(forScreens)}>
            <input
              type="radio"
              name="text-use"
              checked={(settings.forScreens ?? false) === forScreens}
              aria-describedby="text-use-help"
              onChange={() => pages.changeSettings({ forScreens })}
            />
            {forScreens ? strings.forScreens : strings.forPrint}
          </label>
        ))}
        <p class="quiet" id="text-use-help">
          {settings.forScreens ? strings.forScreensHelp : strings.forPrintHelp}
        </p>
      </fieldset>
      <label class="choice">
        <input
          type="checkbox"
          checked={settings.rtl ?? false}
          onChange={(event) => pages.changeSettings({ rtl: event.currentTarget.checked })}
        />
        {strings.rightToLeft}
      </label>
      <label class="choice" title={strings.wholePhotosHelp}>
        <input
          type="checkbox"
          checked={settings.wholePhotos ?? false}
          onChange={(event) => pages.changeSettings({ wholePhotos: event.currentTarget.checked })}
        />
        {strings.wholePhotos}
      </label>
      {LENGTHS.map(({ name, most, step }) => {
        // A setting that is 0 by default may be missing.
        const length = settings[name] ?? 0;
        return (
          <label class="field length" key={name}>
            <span>{strings[name]}</span>
            <input
              type="range"
              min="0"
              max={most}
              step={step}
              value={length * 100}
              aria-valuetext={strings.percent(length, 1)}
              onInput={(event) => change(name, Number((event.currentTarget.valueAsNumber / 100).toFixed(5)))}
              onChange={rest}
            />
            <output aria-hidden="true">{strings.percent(length, 1)}</output>
          </label>
        );
      })}
      {COLOURS.map((name) => (
        <label class="field colour" key={name}>
          <span>{strings[name]}</span>
          <input
            type="color"
            value={settings[name]}
            onInput={(event) => change(name, event.currentTarget.value)}
            onChange={rest}
          />
        </label>
      ))}
      <label class="choice" title={strings.narrationHelp}>
        <input
          type="checkbox"
          checked={ui.narrates.value}
          onChange={(event) => narrating.turn(event.currentTarget.checked)}
        />
        {strings.narration}
      </label>
      <label class="choice" title={strings.placeNamesHelp}>
        <input
          type="checkbox"
          checked={ui.places.value}
          onChange={(event) => turnPlaces(event.currentTarget.checked)}
        />
        {strings.placeNames}
      </label>
      <PageDescription />
      <label class="choice" title={strings.print.safeHelp}>
        <input
          type="checkbox"
          checked={ui.safeArea.value}
          onChange={(event) => {
            ui.safeArea.value = event.currentTarget.checked;
          }}
        />
        {strings.print.showSafe}
      </label>
    </section>
  );
}
