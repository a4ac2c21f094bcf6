/**
 * The board: the page in the middle, surrounded by unobtrusive tools. On a small screen the sides become sheets that
 * open below the page and leave it in view.
 */

import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { Alternatives } from '../page/alternatives-strip.tsx';
import { PageStrip } from '../book/page-strip.tsx';
import { BottomBar } from './bottom-bar.tsx';
import { useApp } from '../ui/context.ts';
import { ContextBar, ModeHint } from '../page/context-bar.tsx';
import { HintLine } from '../help/hint-line.tsx';
import { Versions } from '../page/versions.tsx';
import { isEnabled } from '../ui/action.ts';
import { LayoutTools } from '../layouts/layout-tools.tsx';
import { LayoutsList } from '../layouts/layouts-list.tsx';
import { PageSettingsForm } from '../page/page-settings-form.tsx';
import { Sheet } from './drawer.tsx';
import { ShuffleButton, ShuffleParts } from '../page/shuffle-bar.tsx';
import { SideTabs } from './side-tabs.tsx';
import { Stage } from './stage.tsx';
import { StylesList } from '../styles/styles-list.tsx';
import { Tray } from '../photos/tray.tsx';
import { WordTools } from '../lettering/word-tools.tsx';

export function Board() {
  const { ui } = useApp();
  return ui.wide.value ? <WideBoard /> : <NarrowBoard />;
}

function WideBoard() {
  const { store, book, selection, lettering } = useApp();
  const { width, height } = store.project.value.settings;
  return (
    <>
      <div class="left">
        <Tray />
      </div>
      <main
        class="centre"
        data-wide-page={width > height}
        onClick={({ target, currentTarget }) => {
          if (target !== currentTarget) return;
          selection.clear();
          lettering.choose(-1);
        }}
      >
        <Stage />
        {book.several.value && <PageStrip />}
        <div class="page-side">
          <ContextBar />
          <ModeHint />
          <HintLine />
          <div class="shuffle-bar">
            <Versions heart />
            <ShuffleParts />
            <ShuffleButton />
          </div>
        </div>
      </main>
      <SideTabs />
      <Alternatives />
    </>
  );
}

function NarrowBoard() {
  const { ui, book, selection, framing, reshaping, lettering, hints, actions } = useApp();
  const sheet = ui.sheet.value;
  const several = book.several.value;
  const { acceptCrops } = actions.page;
  const isText = lettering.chosen.value >= 0;
  const aims = framing.mode.value !== null || framing.placing.value !== null;
  const selects = selection.several.value || selection.panels.value.length > 0;
  const byHand = reshaping.editing.value || (sheet === null && (selects || isText));
  return (
    <>
      <main class="centre">
        {several && sheet === null && <PageStrip />}
        <Stage />
        {byHand || aims ? (
          <ContextBar bare={!byHand} />
        ) : (
          sheet === null && (
            <>
              {isEnabled(acceptCrops) && <ActionButton action={acceptCrops} class="better-crops" text />}
              <ShuffleParts heart />
            </>
          )
        )}
      </main>
      {sheet === null && (
        <div class="strip-row">
          {!several && <PageStrip bare={hints.shown.value !== null} />}
          <HintLine />
          <Alternatives />
        </div>
      )}
      {sheet === 'photos' && (
        <Sheet title={strings.photos} bare>
          <Tray />
        </Sheet>
      )}
      {sheet === 'styles' && (
        <Sheet
          title={strings.styles}
          tools={<ActionButton action={actions.styles.shuffleSettings} class="icon-button sheet-tool" />}
        >
          <StylesList />
        </Sheet>
      )}
      {sheet === 'layouts' && (
        <Sheet title={strings.layouts} tools={<LayoutTools />}>
          <LayoutsList />
        </Sheet>
      )}
      {sheet === 'words' && (
        <Sheet title={strings.words}>
          <WordTools />
        </Sheet>
      )}
      {sheet === 'settings' && (
        <Sheet title={strings.pageSettings}>
          <PageSettingsForm />
        </Sheet>
      )}
      <BottomBar />
    </>
  );
}
