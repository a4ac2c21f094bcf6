import { signal } from '@preact/signals';
import { describe, expect, it } from 'vitest';
import { createDesigner } from './designer.ts';
import { MOST } from '../document/limits.ts';
import { fakeApp } from '../document/testing.ts';
import { strings } from '../strings/strings.ts';
import type { DraftEdit, Intent } from '../engine/types.ts';

const add = (name: string, at = 99, layer = 'background' as const) =>
  ({ type: 'add', layer, at, blocks: [name] }) as DraftEdit;

function app() {
  const fake = fakeApp();
  (fake.planner as any).styles = () => [{ id: 'noir', name: 'Noir', tags: [], background: [{ block: 'gaussian' }] }];
  (fake.planner as any).checkStyle = (json: string) => JSON.parse(json);
  fake.store.planner.value = { ...fake.planner } as any;
  let ids = 0;
  const ui = { work: signal(null as 'designer' | 'explorer' | null) };
  const designer = createDesigner({ ...fake, ui, freshId: () => `my-${(ids += 1)}` });
  return { ...fake, ui, designer };
}

describe('the designer', () => {
  it('undoes edit by edit, and a drag in one step', () => {
    const { designer, pages } = app();
    designer.open();
    designer.change(add('gaussian'));
    for (const value of [3, 3.5, 4]) designer.hold({ type: 'set', layer: 'background', at: 0, param: 'sigma', value });
    expect(designer.draft.value?.background[0].values.sigma).toBe(4);
    designer.release();
    pages.undo();
    expect(designer.draft.value?.background[0].values.sigma).toBe(2);
    pages.undo();
    expect(designer.draft.value?.background).toEqual([]);
    pages.redo();
    pages.redo();
    expect(designer.draft.value?.background[0].values.sigma).toBe(4);
  });

  it('puts a block anywhere, with what it needs there', () => {
    const { designer, pages } = app();
    designer.open();
    const blocks = () => designer.draft.value?.background.map(({ block }) => block);
    designer.insert('posterize', { layer: 'background', at: 0 });
    designer.insert('saturation', { layer: 'background', at: 1 });
    // The block needs gray, so it is inserted after the conversion to gray.
    expect(designer.insert('pattern', { layer: 'background', at: 1 })).toEqual({ layer: 'background', at: 2 });
    expect(blocks()).toEqual(['posterize', 'to_gray', 'pattern', 'saturation']);
    // It is gray there already.
    expect(designer.insert('colorize', { layer: 'background', at: 2 })).toEqual({ layer: 'background', at: 2 });
    expect(blocks()).toEqual(['posterize', 'to_gray', 'colorize', 'pattern', 'saturation']);
    pages.undo();
    pages.undo();
    expect(blocks()).toEqual(['posterize', 'saturation']);
  });

  it('puts no more into a layer than it holds, and says so', () => {
    const { designer, messages } = app();
    designer.open();
    for (let i = 0; i < MOST.blocks; i += 1) designer.insert('gaussian', { layer: 'foreground', at: i });
    expect(designer.insert('sobel', { layer: 'foreground', at: 3 })).toBe(null);
    expect(designer.draft.value?.foreground).toHaveLength(MOST.blocks);
    expect(messages.list.value.map(({ text }) => text)).toEqual([strings.fullLayer]);
  });

  it('leaves a designed style as it is, and begins with a copy', () => {
    const { designer, store } = app();
    designer.open(store.styles.value[0]);
    expect(designer.draft.value).toMatchObject({ id: 'my-1', name: 'Noir copy' });
  });

  it('begins with the style of the page, until the draft is edited', async () => {
    const { designer, reading, files, pages } = app();
    await reading.addFiles(files('a', 'b', 'c'));
    const wear = (style: unknown) => pages.edit({ type: 'restyle', style: style as 'noir' });
    wear('noir');
    designer.open();
    expect(designer.draft.value).toMatchObject({ name: 'Noir copy', background: [{ block: 'gaussian' }] });
    designer.close();
    wear({ id: 'own', name: 'Own', tags: [], background: [{ block: 'saturation' }] });
    designer.open();
    expect(designer.draft.value).toMatchObject({ name: 'Own', background: [{ block: 'saturation' }] });
    designer.change(add('gaussian'));
    designer.close();
    wear('noir');
    designer.open();
    expect(designer.draft.value?.name, 'the edited draft').toBe('Own');
  });

  it('puts the page into its style, and the page follows from then on', async () => {
    const { designer, store, reading, files, pages, ui } = app();
    await reading.addFiles(files('a', 'b', 'c'));
    designer.open();
    designer.change(add('gaussian'));
    expect(designer.onPage.value).toBe(false);
    designer.use();
    expect(store.page.value?.style).toMatchObject({ id: 'my-1', background: [{ block: 'gaussian' }] });
    expect(ui.work.value).toBe(null);
    expect(designer.onPage.value).toBe(true);
    designer.change(add('saturation'));
    expect((store.page.value!.style as any).background).toHaveLength(2);
    pages.undo();
    expect([designer.draft.value?.background.length, (store.page.value!.style as any).background.length]).toEqual([
      1, 1,
    ]);
  });

  it('previews the page on the paper that it has after Use', async () => {
    const { designer, store, reading, files, pages } = app();
    await reading.addFiles(files('a', 'b', 'c'));
    const { preview } = pages;
    const paper = '#15141a';
    const planned = (intent: Intent) => {
      const page = preview(intent);
      return page && { ...page, page: { ...page.page, paper } };
    };
    pages.preview = planned;
    designer.open();
    designer.change(add('gaussian'));
    expect(designer.sheet.value).toEqual({ ...store.page.value, page: { ...store.page.value?.page, paper } });
    designer.use();
    expect(designer.sheet.value).toBe(store.page.value);
  });

  it('says what the core finds wrong, and uses nothing of it', async () => {
    const { designer, store, reading, files, messages } = app();
    await reading.addFiles(files('a', 'b', 'c'));
    const before = store.page.value;
    designer.open();
    designer.change(add('pattern'));
    (store.planner.value as any).checkStyle = () => {
      throw new Error('style Untitled style: background[0] (pattern): needs gray');
    };
    designer.use();
    expect(store.page.value).toBe(before);
    expect(messages.list.value.map(({ text }) => text)).toEqual([
      'style Untitled style: background[0] (pattern): needs gray',
    ]);
  });
});
