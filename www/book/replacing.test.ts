import { expect, test } from 'vitest';
import { createActions } from '../app/app.ts';
import { fakeParts } from '../app/app-testing.ts';
import { strings } from '../strings/strings.ts';

test('before pages with text are replaced, the question can be answered in both ways', async () => {
  const parts = await fakeParts();
  const { store, messages, book } = parts;
  const page = store.page.value as NonNullable<typeof store.page.value>;
  const panels = page.panels.map((panel, i) => (i === 0 ? { ...panel, edited: true } : panel));
  store.change({ type: 'change-page', page: { ...page, panels } });
  const { spread } = createActions(parts).book;
  const asked = () => messages.list.value.find(({ text }) => text === strings.book.spreadAsk);
  spread.run();
  expect(book.several.value).toBe(false);
  expect([asked()?.way?.label, asked()?.more?.label]).toEqual([strings.book.spreadYes, strings.cancel]);
  asked()?.more?.run();
  expect(book.several.value).toBe(false);
  spread.run();
  asked()?.way?.run();
  expect(book.several.value).toBe(true);
});
