/** The model of the block Painter: the built-in one, or one of the user. */

import { useId, useRef } from 'preact/hooks';
import { ChosenFiles } from '../photos/chosen-files.tsx';
import { partsOf, referenceOf } from '../painters/references.ts';
import { endingsOf } from '../engine/file-kinds.ts';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../ui/context.ts';
import { importing } from '../ui/importing.ts';

export function ModelChoice({
  label,
  help,
  value,
  onSet,
}: {
  label: string;
  help: string;
  value: string;
  onSet: (value: string) => void;
}) {
  const { ownPainters, messages } = useApp();
  const input = useRef(null as HTMLInputElement | null);
  const button = useRef(null as HTMLButtonElement | null);
  const note = useId();
  const models = [...ownPainters.models.value];
  const { id, name } = partsOf(value);
  const there = models.some(([other]) => other === id);
  const missing = value !== '' && !there;

  async function take([file]: readonly File[]) {
    if (!file) return;
    const reference = await importing(messages, file.name, () => ownPainters.add(file));
    if (reference !== undefined) onSet(reference);
  }

  function remove() {
    onSet('');
    void ownPainters.remove(id);
    button.current?.focus();
  }

  const useBuiltIn = {
    label: strings.useBuiltIn,
    run() {
      onSet('');
      button.current?.focus();
    },
  };
  return (
    <div class="parameter model" role="group" aria-label={label} title={help}>
      {(models.length > 0 || missing) && (
        <label class="model-choice">
          <span>{label}</span>
          <select
            class="select"
            value={id}
            aria-describedby={missing ? note : undefined}
            onChange={({ currentTarget }) => {
              const chosen = models.find(([other]) => other === currentTarget.value);
              onSet(chosen ? referenceOf(chosen[0], chosen[1].name) : '');
            }}
          >
            <option value="">{strings.builtInPainters}</option>
            {models.map(([own, model]) => (
              <option key={own} value={own}>
                {model.name}
              </option>
            ))}
            {missing && (
              <option value={id} disabled>
                {name}
              </option>
            )}
          </select>
          {there && <IconButton icon="bin" label={strings.removeModel({ name })} onClick={remove} />}
        </label>
      )}
      {missing && (
        <p class="model-missing" id={note}>
          {strings.modelMissing({ name })}
        </p>
      )}
      <span class="model-tools">
        <ActionButton
          action={{ label: strings.ownModel, run: () => input.current?.click() }}
          class="button small"
          text
          button={button}
        />
        {value !== '' && <ActionButton action={useBuiltIn} class="button small" text />}
      </span>
      <ChosenFiles input={input} accept={endingsOf('painters')} label={strings.modelFile} onFiles={take} />
    </div>
  );
}
