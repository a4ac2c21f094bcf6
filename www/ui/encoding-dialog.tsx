/** The dialog in which the user chooses the encoding of a text file, with a preview of its beginning. */

import { useEffect, useState } from 'preact/hooks';
import { decodeText } from '../engine/text-file.ts';
import { textModule } from '../engine/text-module.ts';
import { language, strings } from '../strings/strings.ts';
import { ActionButton } from './action-button.tsx';
import { Dialog } from './dialog.tsx';
import { choosing, encodingName } from './encodings.ts';
import type { EncodingChoice } from './encodings.ts';

/** Bytes of the file that the preview reads, a multiple of all character sizes. */
const BEGINNING = 4_096;
const PREVIEW_LINES = 12;

export function EncodingDialog() {
  const choice = choosing.value;
  return choice && <Choice key={choice.file.name} choice={choice} />;
}

function Choice({ choice: { file, encoding, again } }: { choice: EncodingChoice }) {
  const [chosen, setChosen] = useState(encoding);
  const [known, setKnown] = useState([] as readonly string[]);
  const [preview, setPreview] = useState('');
  const close = () => {
    choosing.value = null;
  };

  useEffect(() => {
    void textModule().then(({ encodings }) => setKnown(encodings()), close);
  }, []);
  useEffect(() => {
    let isCurrent = true;
    const read = async () => {
      const decoded = await decodeText(new Uint8Array(await file.slice(0, BEGINNING).arrayBuffer()), chosen);
      if (isCurrent) setPreview((decoded?.text ?? '').split(/\r\n|\r|\n/, PREVIEW_LINES).join('\n'));
    };
    void read().catch(close);
    return () => {
      isCurrent = false;
    };
  }, [chosen]);

  const readAgain = {
    label: strings.readAgain,
    enabled: chosen !== encoding,
    run() {
      close();
      again(chosen);
    },
  };
  return (
    <Dialog title={strings.encodingOf({ name: file.name })} onClose={close}>
      <select
        class="select"
        aria-label={strings.encoding}
        value={chosen}
        onChange={(event) => setChosen(event.currentTarget.value)}
      >
        {known.map((entry) => {
          const [name, ...languages] = entry.split(' ');
          return (
            <option key={name} value={name}>
              {languages.length > 0
                ? `${encodingName(name)} (${strings.listed(languages.map(languageName))})`
                : encodingName(name)}
            </option>
          );
        })}
      </select>
      <textarea
        class="encoding-preview"
        dir="auto"
        rows={PREVIEW_LINES}
        readOnly
        aria-label={strings.encodingPreview}
        value={preview}
      />
      <ActionButton action={readAgain} class="button strong" text />
    </Dialog>
  );
}

function languageName(code: string): string {
  return new Intl.DisplayNames([language], { type: 'language' }).of(code) ?? code;
}
