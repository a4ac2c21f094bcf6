import { expect, test } from 'vitest';
import { createActions } from '../app/app.ts';
import { fakeParts } from '../app/app-testing.ts';
import { strings } from '../strings/strings.ts';

/** An edited page, and the action that replaces it. */
async function editedPage() {
  const parts = await fakeParts();
  const { store, book, ui } = parts;
  const page = store.page.value as NonNullable<typeof store.page.value>;
  const panels = page.panels.map((panel, i) => (i === 0 ? { ...panel, edited: true } : panel));
  store.change({ type: 'change-page', page: { ...page, panels } });
  const { spread } = createActions(parts).book;
  return { ui, book, spread };
}

test('before edited pages are replaced, the question can be answered in both ways', async () => {
  const { ui, book, spread } = await editedPage();
  spread.run();
  expect(book.several.value).toBe(false);
  expect(ui.question.value).toMatchObject({ text: strings.book.spreadAsk, yes: strings.book.spreadYes });
  ui.question.value?.run();
  expect(book.several.value).toBe(true);
});

test('another view ends the question', async () => {
  const { ui, book, spread } = await editedPage();
  spread.run();
  ui.work.value = 'boards';
  expect(ui.question.value).toBeNull();
  expect(book.several.value).toBe(false);
});
