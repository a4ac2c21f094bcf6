/** A parameter with a custom picture: choose a file, show it, and remove it. */

import { useRef } from 'preact/hooks';
import { ChosenFiles } from '../photos/chosen-files.tsx';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../ui/context.ts';
import { DataPicture } from '../ui/data-picture.tsx';
import { importing } from '../ui/importing.ts';
import { textureOf } from './texture-file.ts';

export function TextureChoice({
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
  const { store, messages } = useApp();
  const input = useRef(null as HTMLInputElement | null);
  const button = useRef(null as HTMLButtonElement | null);

  async function take([file]: readonly File[]) {
    const planner = store.planner.peek();
    if (!file || !planner) return;
    await importing(messages, file.name, async () =>
      onSet(await textureOf(file, (style, name) => planner.checkStyle(JSON.stringify(style), name))),
    );
  }

  function remove() {
    onSet('');
    button.current?.focus();
  }

  const choose = {
    label: value === '' ? strings.chooseTexture : strings.otherTexture,
    run: () => input.current?.click(),
  };
  return (
    <div class="parameter texture" role="group" aria-label={label} title={help}>
      <span aria-hidden="true">{label}</span>
      <span class="texture-tools">
        {value !== '' && <DataPicture class="texture-swatch" url={value} alt={strings.textureShown} />}
        <ActionButton action={choose} class="button small" text button={button} />
        {value !== '' && <IconButton icon="close" label={strings.removeTexture} onClick={remove} />}
      </span>
      <ChosenFiles input={input} accept="image/png,image/jpeg" label={strings.textureFile} onFiles={take} />
    </div>
  );
}
