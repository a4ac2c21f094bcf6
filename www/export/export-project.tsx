/** The embedded content of a file besides its pictures, in the export dialog. */

import { useEffect } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import type { Cargo } from '../storage/files/page-files.ts';

const KINDS: readonly Cargo[] = ['none', 'project', 'photos'];

/** @param props `archive`: the file is an archive of pages, not a PNG */
export function ExportProject({ archive }: { archive: boolean }) {
  const { cargo } = useApp().keeping.pageFiles;
  const now = cargo.value;
  // The choice applies to the file that is exported here, not to later ones.
  useEffect(
    () => () => {
      cargo.value = 'none';
    },
    [],
  );
  return (
    <fieldset class="cargo">
      <legend>{strings.cargo}</legend>
      {KINDS.map((kind) => (
        <label class="cargo-kind" key={kind}>
          <input
            type="radio"
            name="cargo"
            value={kind}
            checked={now === kind}
            aria-describedby="cargo-help"
            onChange={() => {
              cargo.value = kind;
            }}
          />
          <span>{strings.cargoKind[kind]}</span>
        </label>
      ))}
      <p class="quiet" id="cargo-help">
        {archive ? strings.cargoFileHelp[now] : strings.cargoHelp[now]} {now !== 'none' && strings.cargoClean}
      </p>
    </fieldset>
  );
}
