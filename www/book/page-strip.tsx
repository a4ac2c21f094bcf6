/**
 * The pages of the storyboard beside the one that is edited. One page alone has but a quiet way to more, and where many
 * photos are on no page an offer to spread them.
 */

import { useState } from 'preact/hooks';
import { sheetsOf } from '../document/sheets.ts';
import { strings } from '../strings/strings.ts';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../app/context.ts';
import { Icon } from '../ui/icon.tsx';
import { usePageDrag } from './page-drag.ts';
import { PageThumb } from './page-thumb.tsx';

/** From so many photos on no page they are worth an offer. */
const MANY = 4;

export function PageStrip() {
  const { store, book } = useApp();
  if (store.page.value === null) return null;
  return book.several.value ? <Several /> : <Alone />;
}

function Alone() {
  const { store, book } = useApp();
  const offers = store.reading.value === null && book.left.value.length >= MANY;
  return (
    <section class="book" aria-label={strings.book.name} data-several="false">
      <AddPage />
      {offers && <SpreadAlbum />}
    </section>
  );
}

function Several() {
  const { store, book, ui } = useApp();
  const [open, setOpen] = useState(false);
  const drag = usePageDrag(book.move);
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
      {(wide || open) && <Tools count={sheets.length} />}
      <span class="visually-hidden" aria-live="polite">
        {strings.book.page(at + 1, sheets.length)}
      </span>
    </section>
  );
}

/** What can be done to the page among the others. */
function Tools({ count }: { count: number }) {
  const { book, ui } = useApp();
  const at = book.at.value;
  const [back, forth] = ui.wide.value ? ['up', 'down'] : ['previous', 'next'];
  return (
    <div class="book-tools">
      <div class="book-icons">
        <IconButton
          icon={back}
          label={strings.book.earlier}
          disabled={at === 0}
          onClick={() => book.move(at, at - 1)}
        />
        <IconButton
          icon={forth}
          label={strings.book.later}
          disabled={at === count - 1}
          onClick={() => book.move(at, at + 1)}
        />
        <IconButton icon="bin" label={strings.book.remove} onClick={book.remove} />
      </div>
      {!book.oneStyle.value && (
        <button type="button" class="book-text" onClick={book.styleAll}>
          <Icon name="style" />
          {strings.book.styleAll}
        </button>
      )}
      <SpreadAlbum />
    </div>
  );
}

/** The outline of a page that is not there yet. */
function AddPage() {
  const { book } = useApp();
  const why = book.cannotAdd();
  const left = book.left.value.length;
  return (
    <button
      type="button"
      class="book-ghost"
      disabled={why !== ''}
      onClick={book.add}
      title={why || (left > 0 ? strings.book.addMore(left) : strings.book.addHelp)}
    >
      <span class="book-outline">
        <Icon name="add" />
      </span>
      {strings.book.add}
    </button>
  );
}

function SpreadAlbum() {
  const { store, book } = useApp();
  const why = book.cannotSpread();
  return (
    <button
      type="button"
      class="book-text"
      disabled={why !== ''}
      onClick={book.spreadAlbum}
      title={why || strings.book.spreadHelp(store.photos.value.length)}
    >
      <Icon name="spread" />
      {strings.book.spreadAlbum}
    </button>
  );
}
