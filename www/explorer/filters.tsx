/** Which photo the wall is drawn on, and which of its styles are shown. */

import { strings } from '../strings/strings.ts';
import { PhotoPicker } from '../photos/photo-picker.tsx';
import { useApp } from '../ui/context.ts';
import { HUES, LIGHTNESSES } from './colours.ts';
import type { Signal } from '@preact/signals';
import type { Shown } from '../photos/photo-picker.tsx';

export function Filters({ facts, chosen }: { facts: readonly Shown[]; chosen: string | null }) {
  const { explorer } = useApp();
  return (
    <div class="explorer-filters">
      <PhotoPicker
        label={strings.wallPhotos}
        facts={facts}
        chosen={chosen}
        told={(name) => strings.drawOn({ name })}
        onChoose={(id) => {
          explorer.photo.value = id;
        }}
      />
      <div class="filter-kinds">
        <select
          class="select"
          aria-label={strings.looks}
          value={explorer.look.value}
          onChange={(event) => explorer.filter(event.currentTarget.value)}
        >
          {Object.entries(strings.lookName).map(([id, name]) => (
            <option key={id} value={id}>
              {name}
            </option>
          ))}
        </select>
        <Swatches label={strings.hues} options={HUES} names={strings.hueName} chosen={explorer.hue} />
        <Swatches
          label={strings.lightnesses}
          options={LIGHTNESSES}
          names={strings.lightnessName}
          chosen={explorer.lightness}
        />
      </div>
    </div>
  );
}

/** Colours to filter by. Selecting the same colour again removes the filter. */
function Swatches<T extends string>({
  label,
  options,
  names,
  chosen,
}: {
  label: string;
  options: readonly T[];
  names: Record<T, string>;
  chosen: Signal<T | null>;
}) {
  return (
    <div class="swatches" role="group" aria-label={label}>
      {options.map((option) => (
        <button
          key={option}
          type="button"
          class="swatch"
          data-colour={option}
          aria-label={names[option]}
          title={names[option]}
          aria-pressed={chosen.value === option}
          onClick={() => {
            chosen.value = chosen.peek() === option ? null : option;
          }}
        />
      ))}
    </div>
  );
}
