/**
 * The board: the page in the middle, everything else around it and quiet. On a small screen the sides become
 * sheets that open below the page and leave it in view.
 */

import { BoardSwitch } from '../boards/board-switch.tsx';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { Alternatives } from '../page/alternatives-strip.tsx';
import { PageStrip } from '../book/page-strip.tsx';
import { BottomBar } from './bottom-bar.tsx';
import { useApp } from '../ui/context.ts';
import { HintBubble } from '../help/hint-bubble.tsx';
import { LanguageChoice } from '../help/language-choice.tsx';
import { ThemeChoice } from '../help/theme-choice.tsx';
import { LayoutTools } from '../layouts/layout-tools.tsx';
import { LayoutsList } from '../layouts/layouts-list.tsx';
import { PageSettingsForm } from '../page/page-settings-form.tsx';
import { PanelTools } from '../page/panels/panel-tools.tsx';
import { Sheet } from './drawer.tsx';
import { ShuffleButton, ShuffleParts } from '../page/shuffle-bar.tsx';
import { SideTabs } from './side-tabs.tsx';
import { Stage } from './stage.tsx';
import { StyleTools } from '../styles/style-tools.tsx';
import { StylesList } from '../styles/styles-list.tsx';
import { Tray } from '../photos/tray.tsx';
import { WordTools } from '../lettering/word-tools.tsx';
import { Workspaces } from './workspaces.tsx';

export function Board() {
  const { ui } = useApp();
  return ui.wide.value ? <WideBoard /> : <NarrowBoard />;
}

function WideBoard() {
  return (
    <>
      <div class="left">
        <Tray />
      </div>
      <main class="centre">
        <Stage />
        <PageStrip />
        <PanelTools />
        <div class="shuffle-bar">
          <ShuffleButton />
          <ShuffleParts />
        </div>
        <HintBubble />
      </main>
      <SideTabs />
      <Alternatives />
    </>
  );
}

function NarrowBoard() {
  const { ui, book, selection, reshaping, actions } = useApp();
  const sheet = ui.sheet.value;
  const several = book.several.value;
  const byHand = reshaping.editing.value || selection.several.value || selection.panels.value.length > 0;
  return (
    <>
      <main class="centre">
        {several && sheet === null && <PageStrip />}
        <Stage />
        {byHand ? <PanelTools /> : sheet === null && <ShuffleParts />}
        <HintBubble />
      </main>
      {sheet === null &&
        (several ? (
          <Alternatives />
        ) : (
          <div class="strip-row">
            <PageStrip />
            <Alternatives />
          </div>
        ))}
      {sheet === 'photos' && (
        <Sheet title={strings.photos} bare>
          <Tray />
        </Sheet>
      )}
      {sheet === 'styles' && (
        <Sheet title={strings.styles}>
          <div class="styles-head">
            <Workspaces />
            <StyleTools />
          </div>
          <StylesList />
        </Sheet>
      )}
      {sheet === 'layouts' && (
        <Sheet title={strings.layouts}>
          <LayoutTools />
          <LayoutsList />
        </Sheet>
      )}
      {sheet === 'words' && (
        <Sheet title={strings.words}>
          <WordTools />
        </Sheet>
      )}
      {sheet === 'settings' && (
        <Sheet
          title={strings.pageSettings}
          tools={<ActionButton action={actions.window.help} class="button sheet-tool" text />}
        >
          <BoardSwitch />
          <PageSettingsForm />
          <div class="sheet-choices">
            <ThemeChoice />
            <LanguageChoice />
          </div>
        </Sheet>
      )}
      <BottomBar />
    </>
  );
}
