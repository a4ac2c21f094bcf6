/** Tools of the brush as labelled buttons, and information about the mask. */

import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { SIZES, TOOLS } from './retouching.ts';
import type { Action } from '../ui/action.ts';
import type { Mending } from '../engine/brush-module.ts';
import type { Retouching } from './retouching.ts';

export function BrushTools({
  retouching,
  done,
  cancel,
}: {
  retouching: Retouching;
  done: () => void;
  cancel: () => void;
}) {
  const { brush } = strings;
  const { undoable, redoable, found } = retouching.told.value;
  const mends = (how: Mending, label: string, why = '') => (
    <Command action={{ label, why, run: () => void retouching.mend(how) }} />
  );
  return (
    <div class="brush-tools">
      <Told retouching={retouching} />
      <div class="segments" role="group" aria-label={brush.tools}>
        {TOOLS.map((tool) => (
          <button
            key={tool}
            type="button"
            aria-pressed={retouching.tool.value === tool}
            title={tool === 'choose' ? brush.chooseHelp : undefined}
            onClick={() => {
              retouching.tool.value = tool;
            }}
          >
            {brush.tool[tool]}
          </button>
        ))}
      </div>
      <Size retouching={retouching} />
      <div class="brush-set">
        <Command action={{ label: strings.undo, enabled: undoable, run: () => void retouching.undo() }} />
        <Command action={{ label: strings.redo, enabled: redoable, run: () => void retouching.redo() }} />
      </div>
      <div class="brush-set" role="group" aria-label={brush.border}>
        {mends('Grow', brush.grow)}
        {mends('Shrink', brush.shrink)}
        {mends('Feather', brush.feather)}
      </div>
      <div class="brush-set" role="group" aria-label={brush.whole}>
        {mends('NextFigure', brush.next)}
        {mends('Everything', brush.everything)}
        {mends('Nothing', brush.nothing)}
        {mends('Invert', brush.invert)}
        {mends('Found', brush.found, found ? brush.isFound : '')}
      </div>
      <div class="brush-set">
        <Command action={{ label: brush.cancel, run: cancel }} />
        <ActionButton action={{ label: strings.doneEditing, run: done }} class="button strong" text />
      </div>
    </div>
  );
}

function Command({ action }: { action: Action }) {
  return <ActionButton action={action} class="button" text />;
}

/**
 * Share of the photo that the subject covers, or the reason why the last command had no effect. Announced again after
 * each step.
 */
function Told({ retouching }: { retouching: Retouching }) {
  const vain = retouching.vain.value;
  return (
    <p class="brush-told" role="status">
      {vain ? strings.brush[vain] : strings.brush.covers({ share: strings.percent(retouching.told.value.coverage) })}
    </p>
  );
}

/** The slider is logarithmic, so that small sizes can be set precisely. */
function Size({ retouching }: { retouching: Retouching }) {
  const radius = retouching.size.value;
  const place = Math.log(radius / SIZES.least) / Math.log(SIZES.most / SIZES.least);
  return (
    <label class="brush-size">
      <span>{strings.brush.size}</span>
      <input
        type="range"
        min={0}
        max={1}
        step={0.01}
        value={place}
        aria-valuetext={strings.percent(2 * radius)}
        onInput={({ currentTarget }) => {
          retouching.size.value = SIZES.least * (SIZES.most / SIZES.least) ** currentTarget.valueAsNumber;
        }}
      />
      <span class="brush-number" aria-hidden="true">
        {strings.percent(2 * radius)}
      </span>
    </label>
  );
}
