/**
 * The panel next to the page: one tab for each kind of content, each as high as the window. The tab list is one tab
 * stop. Arrows, Home and End move between tabs.
 */

import { useComputed } from '@preact/signals';
import { useEffect, useId, useRef, useState } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { LayoutTools } from '../layouts/layout-tools.tsx';
import { LayoutsList } from '../layouts/layouts-list.tsx';
import { PageSettingsForm } from '../page/page-settings-form.tsx';
import { StylesList } from '../styles/styles-list.tsx';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { WordTools } from '../lettering/word-tools.tsx';
import { SIDE_TABS } from '../ui/ui.ts';
import type { ComponentChildren } from 'preact';
import type { SideTab } from '../ui/ui.ts';

const ICONS = { styles: 'style', layouts: 'layout', words: 'balloon', page: 'settings' } as const;

export function SideTabs() {
  const { store, ui, lettering } = useApp();
  const list = useRef(null as HTMLDivElement | null);
  const id = useId();
  const open = ui.sideTab.value;
  const chosen = lettering.chosen.value;
  const wasDrawn = useRef(false);
  const isDrawn = useComputed(() => !store.sketch.value && (ui.painted.value !== null || store.page.value === null));
  wasDrawn.current ||= isDrawn.value;

  // Selecting a text item opens its tab.
  useEffect(() => {
    if (chosen >= 0) ui.sideTab.value = 'words';
  }, [chosen]);

  function onKeyDown(event: KeyboardEvent) {
    const at = SIDE_TABS.indexOf(open);
    const last = SIDE_TABS.length - 1;
    const to = { ArrowLeft: at === 0 ? last : at - 1, ArrowRight: at === last ? 0 : at + 1, Home: 0, End: last }[
      event.key
    ];
    if (to === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    ui.sideTab.value = SIDE_TABS[to];
    list.current?.querySelectorAll<HTMLElement>('[role=tab]')[to].focus();
  }

  return (
    <aside class="right" aria-label={strings.look}>
      <div class="side-tabs" role="tablist" aria-label={strings.pageTools} ref={list} onKeyDown={onKeyDown}>
        {SIDE_TABS.map((tab) => (
          <button
            key={tab}
            type="button"
            role="tab"
            class="side-tab"
            id={`${id}-${tab}`}
            aria-controls={`${id}-${tab}-panel`}
            aria-selected={tab === open}
            tabIndex={tab === open ? 0 : -1}
            onClick={() => {
              ui.sideTab.value = tab;
            }}
          >
            <Icon name={ICONS[tab]} />
            {strings.sideTab[tab]}
          </button>
        ))}
      </div>
      {SIDE_TABS.map((tab) => (
        <TabPanel key={tab} id={id} tab={tab} hidden={tab !== open} isDrawn={wasDrawn.current}>
          {CONTENT[tab]}
        </TabPanel>
      ))}
    </aside>
  );
}

const CONTENT: Record<SideTab, ComponentChildren> = {
  styles: <StylesList />,
  layouts: (
    <>
      <LayoutTools />
      <LayoutsList />
    </>
  ),
  words: <WordTools />,
  page: <PageSettingsForm />,
};

/**
 * An inactive tab stays mounted, so that its search text and scroll position are retained.
 * @param props `isDrawn`: whether the first page is drawn, which comes before all tabs
 */
function TabPanel({
  id,
  tab,
  hidden,
  isDrawn,
  children,
}: {
  id: string;
  tab: SideTab;
  hidden: boolean;
  isDrawn: boolean;
  children: ComponentChildren;
}) {
  const { scheduler } = useApp();
  const [isMounted, setMounted] = useState(false);
  useEffect(() => {
    if (!isDrawn || isMounted) return undefined;
    const stop = new AbortController();
    // Inactive tabs are as much work as the first page.
    scheduler.turn(hidden ? 'background' : 'visible', stop).then(
      () => setMounted(true),
      () => {},
    );
    return () => stop.abort();
  }, [isDrawn, isMounted, hidden]);
  return (
    <div
      class={`side-panel side-panel-${tab}`}
      role="tabpanel"
      id={`${id}-${tab}-panel`}
      aria-labelledby={`${id}-${tab}`}
      hidden={hidden}
    >
      {isMounted && children}
    </div>
  );
}
