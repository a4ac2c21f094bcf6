/**
 * The pages of the book next to the edited page. On a small screen a single page has a button for more, and an offer to
 * make pages from all photos if many are not used.
 */

import { useState } from 'preact/hooks';
import { sheetsOf } from '../engine/sheets.ts';
import { strings } from '../strings/strings.ts';
import { IconButton } from '../ui/button.tsx';
import { useListDrag } from '../ui/list-drag.ts';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { BookProgress } from '../page/book-progress.tsx';
import { PageThumb } from './page-thumb.tsx';
import { isEnabled } from '../ui/action.ts';
import { ActionButton } from '../ui/action-button.tsx';

/** @param props `bare`: a single page has only the buttons for another page and a book */
export function PageStrip({ bare = false }: { bare?: boolean }) {
  const { store, book } = useApp();
  if (store.page.value === null) return null;
  return book.several.value ? <Several /> : <Alone bare={bare} />;
}

function Alone({ bare }: { bare: boolean }) {
  const { store, book, ui } = useApp();
  const offers = store.reading.value === null && book.areManyLeft.value;
  return (
    <section class="book" aria-label={strings.book.name} data-several="false">
      <AddPage />
      {offers && <MakeBook />}
      {offers && !bare && <SpreadAlbum />}
      {!ui.wide.value && <BookProgress />}
    </section>
  );
}

function Several() {
  const { store, book, ui } = useApp();
  const [open, setOpen] = useState(false);
  const drag = useListDrag({ list: '.book-pages', item: '.book-page' }, book.move);
  const sheets = sheetsOf(store.project.value);
  const at = book.at.value;
  const gap = drag.carried?.gap ?? -1;
  const wide = ui.wide.value;
  return (
    <section class="book" aria-label={strings.book.name} data-several="true">
      <ol class="book-pages">
        {sheets.map(({ page, sheet }, i) => (
          <PageThumb
            key={sheet}
            page={page}
            at={i}
            of={sheets.length}
            current={i === at}
            drag={drag}
            marked={gap === i ? 'before' : gap === sheets.length && i === sheets.length - 1 ? 'behind' : ''}
          />
        ))}
      </ol>
      <AddPage />
      {!wide && (
        <IconButton
          icon="dots"
          class="book-more"
          label={strings.book.tools}
          expanded={open}
          onClick={() => setOpen(!open)}
        />
      )}
      {(wide || open) && <Tools />}
      {!wide && <BookProgress />}
      <span class="visually-hidden" aria-live="polite">
        {strings.book.page({ n: at + 1, of: sheets.length })}
      </span>
    </section>
  );
}

/** Actions of the page in the storyboard. */
function Tools() {
  const { ui, actions } = useApp();
  const { cover, earlier, later, remove, styleAll, make } = actions.book;
  return (
    <div class="book-tools">
      <div class="book-icons">
        <ActionButton action={earlier} />
        <ActionButton action={later} />
        <ActionButton action={remove} />
      </div>
      {isEnabled(styleAll) && <ActionButton action={styleAll} class="book-text" text />}
      {isEnabled(cover) && <ActionButton action={cover} class="book-text" text />}
      <ActionButton action={make} class="book-text" text />
      {!ui.wide.value && <SpreadAlbum />}
    </div>
  );
}

/** The outline of a page that is not there yet. */
function AddPage() {
  const { add } = useApp().actions.book;
  return (
    <ActionButton action={add} class="book-ghost" text>
      <span class="book-outline">
        <Icon name="add" />
      </span>
      {add.label}
    </ActionButton>
  );
}

/** The offer to make a book, which stands out. A book that exists has a plain button. */
function MakeBook() {
  const { make } = useApp().actions.book;
  return <ActionButton action={make} class="book-text book-make" text />;
}

function SpreadAlbum() {
  const { spread } = useApp().actions.book;
  return <ActionButton action={spread} class="book-text" text />;
}
