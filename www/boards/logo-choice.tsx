/** The logo in the headers of the sheets: choose a file, show it, and remove it. */

import { useRef } from 'preact/hooks';
import { ChosenFiles } from '../photos/chosen-files.tsx';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../ui/context.ts';
import { DataPicture } from '../ui/data-picture.tsx';
import { importing } from '../ui/importing.ts';
import { logoOf } from './logo-file.ts';

export function LogoChoice() {
  const { boards, messages } = useApp();
  const input = useRef(null as HTMLInputElement | null);
  const button = useRef(null as HTMLButtonElement | null);
  const { logo = '' } = boards.board.value;
  const { logo: name, chooseLogo, removeLogo, logoFile } = strings.boards;

  async function take([file]: readonly File[]) {
    if (file) await importing(messages, file.name, async () => boards.change({ logo: await logoOf(file) }));
  }

  function remove() {
    boards.change({ logo: '' });
    button.current?.focus();
  }

  const choose = { label: chooseLogo, icon: 'open', run: () => input.current?.click() };
  return (
    <div class="field board-logo" role="group" aria-label={name}>
      <span aria-hidden="true">{name}</span>
      <span class="board-logo-tools">
        {logo !== '' && <DataPicture class="board-logo-picture" url={logo} alt={name} />}
        <ActionButton action={choose} class="button" text button={button} />
        {logo !== '' && <IconButton icon="close" label={removeLogo} onClick={remove} />}
      </span>
      <ChosenFiles
        input={input}
        accept="image/png,image/jpeg,image/webp,image/svg+xml"
        label={logoFile}
        onFiles={(files) => void take(files)}
      />
    </div>
  );
}
