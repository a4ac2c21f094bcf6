import { useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { IconButton } from '../ui/button.tsx';

/** A button that chooses one file, and the name of the file with a button to remove it. */
export function FilePick({
  label,
  file,
  accept,
  off,
  choose,
}: {
  label: string;
  file: File | null;
  accept: string;
  off: boolean;
  choose: (file: File | null) => void;
}) {
  const input = useRef(null as HTMLInputElement | null);
  return (
    <div class="file-pick">
      <ActionButton
        action={{ label, icon: 'add', enabled: !off, run: () => input.current?.click() }}
        class="button"
        text
      />
      <input
        ref={input}
        type="file"
        hidden
        aria-label={label}
        accept={accept}
        disabled={off}
        onChange={(event) => {
          const [chosen = null] = event.currentTarget.files ?? [];
          if (chosen) choose(chosen);
          event.currentTarget.value = '';
        }}
      />
      {file && (
        <>
          <span class="file-pick-name">{file.name}</span>
          <IconButton icon="close" label={strings.animatic.noSound({ name: file.name })} onClick={() => choose(null)} />
        </>
      )}
    </div>
  );
}
