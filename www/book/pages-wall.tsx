/** The gallery of all versions of the page: choose one to continue from it, or compare two side by side. */

import { useEffect, useRef, useState } from 'preact/hooks';
import { useSubjectsOf } from '../page/subjects-of.ts';
import { strings } from '../strings/strings.ts';
import { Thumbnail, screenPixels } from '../ui/bitmap.tsx';
import { ActionButton } from '../ui/action-button.tsx';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../ui/context.ts';
import { Workspace } from '../ui/workspace.tsx';
import type { Entry } from './shown-pages.ts';

export function PagesWall() {
  const { shownPages, ui } = useApp();
  const [only, setOnly] = useState(false);
  const pair = shownPages.pair.value;
  const list = useRef(null as HTMLUListElement | null);
  const all = shownPages.entries.value;
  const two = all.filter(({ id }) => pair.includes(id));
  const compares = two.length === 2;
  const entries = compares ? two : only ? all.filter(({ loved }) => loved) : all;

  useEffect(() => {
    list.current?.querySelector('[aria-current]')?.scrollIntoView({ block: 'center' });
    return () => setPair([]);
  }, []);

  function setPair(ids: readonly number[]) {
    shownPages.pair.value = ids;
  }

  const leave = compares ? { label: strings.comparedAll, icon: 'previous' } : { label: strings.cancel };
  const showFavourites = { label: strings.favouritePages, icon: 'heart', on: only, run: () => setOnly(!only) };
  const tools = (
    <div class="wall-bar">
      <p class="wall-hint" role="status">
        {pair.length === 1 && strings.compareSecond}
      </p>
      {pair.length > 0 && <ActionButton action={{ ...leave, run: () => setPair([]) }} class="button" text />}
      <ActionButton action={showFavourites} class="button" text />
    </div>
  );
  return (
    <Workspace
      title={strings.pagesShown}
      class="pages-wall"
      tools={tools}
      onClose={() => {
        ui.work.value = null;
      }}
    >
      <ul class="page-wall" ref={list} data-compares={compares}>
        {entries.map((entry) => (
          <ShownPage
            key={`${entry.id} ${compares}`}
            entry={entry}
            compared={pair.includes(entry.id)}
            onCompare={() =>
              setPair(pair.includes(entry.id) ? pair.filter((id) => id !== entry.id) : [...pair, entry.id].slice(-2))
            }
          />
        ))}
      </ul>
      {entries.length === 0 && <p class="wall-empty">{strings.noFavouritePages}</p>}
    </Workspace>
  );
}

function ShownPage({
  entry: { id, number, page, from, place, loved, current },
  compared,
  onCompare,
}: {
  entry: Entry;
  compared: boolean;
  onCompare: () => void;
}) {
  const { shownPages, engine, ui } = useApp();
  const ref = useRef(null as HTMLButtonElement | null);
  const width = () => screenPixels(ref.current?.clientWidth ?? 120);
  return (
    <li class="shown-page" data-compared={compared} style={{ '--aspect': page.page.width / page.page.height }}>
      <button
        type="button"
        ref={ref}
        class="shown-picture"
        aria-label={strings.versionNumber({ n: number })}
        aria-current={current ? 'true' : undefined}
        onClick={() => {
          shownPages.go(id);
          ui.work.value = null;
        }}
      >
        <Thumbnail of={page} by={useSubjectsOf(page)} draw={(call) => engine.pageFile(page, width(), call)} />
      </button>
      <div class="shown-about">
        <span>
          {strings.versionNumber({ n: number })}
          {place !== null ? (
            <i>{strings.pageNumber({ n: place })}</i>
          ) : (
            from !== null && <i>{strings.versionFrom({ n: from })}</i>
          )}
        </span>
        <IconButton
          icon="columns"
          label={strings.comparePage({ n: number })}
          short={strings.compareShort}
          pressed={compared}
          onClick={onCompare}
        />
        <IconButton
          icon="heart"
          label={strings.favouritePage}
          pressed={loved}
          class="page-heart"
          onClick={() => shownPages.love(id, !loved)}
        />
      </div>
    </li>
  );
}
