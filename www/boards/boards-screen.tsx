/**
 * The storyboard of the album: its shot list and its sheets. Loaded when it is first opened.
 */

import { useEffect, useRef, useState } from 'preact/hooks';
import { isList, LISTS } from '../export/formats.ts';
import { USUAL_QUALITY } from '../export/page-making.ts';
import { NO_PRINT } from '../export/print.ts';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { Workspace } from '../ui/workspace.tsx';
import { importShots } from './board-import.ts';
import { BoardSettings } from './board-settings.tsx';
import { Sheets } from './sheets.tsx';
import { ShotsTable } from './shots-table.tsx';
import './boards.css';
import { explain } from '../ui/explain.ts';
import type { ListKind } from '../engine/protocol.ts';

/** Export formats of a storyboard, in the order of the list. */
const WAYS: readonly (ListKind | 'pdf' | 'zip')[] = ['pdf', 'zip', ...LISTS];

export function BoardsScreen() {
  const { ui } = useApp();
  return (
    <Workspace
      title={strings.boards.board}
      class="boards"
      tools={<Tools />}
      onClose={() => {
        ui.work.value = null;
      }}
    >
      <div class="boards-body">
        <ShotsTable />
        <section class="boards-sheets" aria-label={strings.boards.sheets}>
          <BoardSettings />
          <Sheets />
        </section>
      </div>
    </Workspace>
  );
}

function Tools() {
  const { boards, download, messages, actions } = useApp();
  const [format, setFormat] = useState(WAYS[0]);
  const busy = download.progress.value !== null;
  const none = boards.rows.value.length === 0;

  async function save() {
    try {
      const pages = isList(format) ? [] : await boards.sheets();
      await download.saveAs({ pages, format, inside: 'png', quality: USUAL_QUALITY, print: NO_PRINT });
    } catch (error) {
      messages.alert(strings.exportFailed({ why: explain(error) }));
    }
  }

  return (
    <div class="boards-tools">
      <ActionButton action={actions.boards.animatic} class="button" text />
      <ImportFile />
      <select
        class="select"
        aria-label={strings.boards.saveAs}
        value={format}
        onChange={(event) => setFormat(event.currentTarget.value as (typeof WAYS)[number])}
      >
        {WAYS.map((way) => (
          <option key={way} value={way}>
            {way === 'pdf' || way === 'zip' ? strings.boards.ways[way] : strings.exportFormats[way]}
          </option>
        ))}
      </select>
      <button type="button" class="button strong" disabled={busy || none} onClick={() => void save()}>
        <Icon name="download" />
        {strings.boards.saveBoard}
      </button>
    </div>
  );
}

/** The button that imports screenplays and tables. */
function ImportFile() {
  const { boards, store, messages } = useApp();
  const input = useRef(null as HTMLInputElement | null);

  useEffect(() => {
    if (input.current) input.current.value = '';
  });
  return (
    <>
      <button type="button" class="button" onClick={() => input.current?.click()}>
        <Icon name="open" />
        {strings.boards.importFile}
      </button>
      <input
        ref={input}
        type="file"
        hidden
        aria-label={strings.boards.importFile}
        accept=".fountain,.spmd,.csv,.tsv,.txt,text/csv,text/tab-separated-values"
        onChange={(event) => {
          const [file] = event.currentTarget.files ?? [];
          if (file) void importShots(file, { boards, store, messages });
          event.currentTarget.value = '';
        }}
      />
    </>
  );
}
