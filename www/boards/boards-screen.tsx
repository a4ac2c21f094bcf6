/**
 * The storyboard of the album: its shot list and its sheets. Loaded when it is first opened.
 */

import { useEffect, useRef, useState } from 'preact/hooks';
import { isList, LISTS } from '../export/formats.ts';
import { USUAL_QUALITY } from '../export/page-making.ts';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
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

  async function save() {
    try {
      const pages = isList(format) ? [] : await boards.sheets();
      await download.saveAs({ pages, format, inside: 'png', quality: USUAL_QUALITY });
    } catch (error) {
      messages.alert(strings.exportFailed({ why: explain(error) }));
    }
  }

  const saveBoard = {
    label: strings.boards.saveBoard,
    icon: 'download',
    enabled: boards.rows.value.length > 0,
    why: download.progress.value === null ? '' : strings.exportRuns,
    run: () => void save(),
  };
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
      <ActionButton action={saveBoard} class="button strong" text />
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
      <ActionButton
        action={{ label: strings.boards.importFile, icon: 'open', run: () => input.current?.click() }}
        class="button"
        text
      />
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
