import { signal } from '@preact/signals';
import { describe, expect, it } from 'vitest';
import { createDesigner } from './designer.ts';
import { draftOf, edit, emptyDraft, misfits, remedy, styleOf } from './designer-draft.ts';
import { fakeApp } from '../document/testing.ts';
import type { Block, BlockParam, Channels } from '../engine/types.ts';
import type { Draft, Edit } from './designer-draft.ts';

const number = (id: string, usual = 1): BlockParam => ({
  id,
  label: id,
  help: '',
  kind: 'number',
  default: usual,
  min: 0,
  max: 10,
  step: 0.1,
});
const block = (id: string, input: Channels = 'any', output: Channels = 'any', params = [number('sigma')]): Block => ({
  id,
  label: id,
  help: '',
  input,
  output,
  params,
});
const BLOCKS = [
  block('gaussian'),
  block('to_gray', 'any', 'luma', []),
  block('to_color', 'any', 'color', []),
  block('pattern', 'luma', 'any', [number('scale')]),
  block('saturation', 'color', 'any', [number('amount')]),
];

const made = (...edits: Edit[]) =>
  edits.reduce((draft, change) => edit(draft, change, BLOCKS), emptyDraft('my-1', 'Mine'));
const add = (name: string, at = 99, layer = 'background' as const) =>
  ({ type: 'add', layer, at, blocks: [name] }) as Edit;
const names = (draft: Draft, layer = 'background' as 'background' | 'foreground') =>
  draft[layer].map(({ block: id }) => id);

describe('a draft', () => {
  it('is built, ordered and taken apart, and its cards keep their keys', () => {
    const draft = made(add('gaussian'), add('to_gray'), add('pattern'));
    expect(names(draft)).toEqual(['gaussian', 'to_gray', 'pattern']);
    const keys = draft.background.map(({ key }) => key);
    expect(new Set(keys).size).toBe(3);
    const moved = edit(draft, { type: 'move', layer: 'background', at: 0, toLayer: 'background', to: 2 }, BLOCKS);
    expect(names(moved)).toEqual(['to_gray', 'pattern', 'gaussian']);
    expect(moved.background[2].key).toBe(keys[0]);
    const across = edit(moved, { type: 'move', layer: 'background', at: 2, toLayer: 'foreground', to: 0 }, BLOCKS);
    expect([names(across), names(across, 'foreground')]).toEqual([['to_gray', 'pattern'], ['gaussian']]);
    const twice = edit(across, { type: 'duplicate', layer: 'foreground', at: 0 }, BLOCKS);
    expect(twice.foreground[1].key).not.toBe(twice.foreground[0].key);
    expect(names(edit(twice, { type: 'remove', layer: 'background', at: 0 }, BLOCKS))).toEqual(['pattern']);
  });

  it('stays the same object where an edit changes nothing, or cannot', () => {
    const draft = made(add('gaussian'));
    expect(edit(draft, { type: 'move', layer: 'background', at: 0, toLayer: 'background', to: 5 }, BLOCKS)).toBe(draft);
    expect(edit(draft, { type: 'set', layer: 'background', at: 0, param: 'sigma', value: 1 }, BLOCKS)).toBe(draft);
    expect(edit(draft, { type: 'remove', layer: 'background', at: 7 }, BLOCKS)).toBe(draft);
    const full = made(...Array.from({ length: 40 }, () => add('gaussian')));
    expect(full.background).toHaveLength(32);
  });

  it('becomes a style file without what is the default, and comes back', () => {
    const draft = [
      { type: 'set', layer: 'background', at: 0, param: 'sigma', value: 3 },
      { type: 'bypass', layer: 'background', at: 1, on: true },
      { type: 'ink', ink: '#102030' },
      { type: 'add', layer: 'foreground', at: 0, blocks: ['to_gray'] },
    ].reduce((now, change) => edit(now, change as Edit, BLOCKS), made(add('gaussian'), add('saturation')));
    const style = styleOf(draft, BLOCKS);
    expect(style).toEqual({
      id: 'my-1',
      name: 'Mine',
      tags: [],
      background: [
        { block: 'gaussian', sigma: 3 },
        { block: 'saturation', bypass: true },
      ],
      foreground: [{ block: 'to_gray' }],
      ink: '#102030',
    });
    expect(styleOf(draftOf(style, BLOCKS), BLOCKS)).toEqual(style);
    const reset = edit(draft, { type: 'reset', layer: 'background', at: 0 }, BLOCKS);
    expect(styleOf(reset, BLOCKS).background?.[0]).toEqual({ block: 'gaussian' });
  });

  it('tells the channel rules before they bite', () => {
    const draft = made(add('pattern'), add('to_gray'), add('saturation'), add('pattern'));
    expect(misfits(draft.background, BLOCKS)).toEqual(['luma', '', 'color', '']);
    expect(styleOf(draft, BLOCKS, { tolerant: true }).background).toEqual([
      { block: 'pattern', bypass: true },
      { block: 'to_gray' },
      { block: 'saturation', bypass: true },
      { block: 'pattern' },
    ]);
    expect(remedy([], 'pattern', BLOCKS)).toBe('to_gray');
    expect(remedy(draft.background, 'saturation', BLOCKS)).toBe('to_color');
    expect(remedy(draft.background, 'pattern', BLOCKS)).toBe(null);
  });
});

function app() {
  const fake = fakeApp();
  (fake.planner as any).blocks = () => BLOCKS;
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
    for (const value of [2, 3, 4]) designer.hold({ type: 'set', layer: 'background', at: 0, param: 'sigma', value });
    expect(designer.draft.value?.background[0].values.sigma).toBe(4);
    designer.release();
    pages.undo();
    expect(designer.draft.value?.background[0].values.sigma).toBe(1);
    pages.undo();
    expect(designer.draft.value?.background).toEqual([]);
    pages.redo();
    pages.redo();
    expect(designer.draft.value?.background[0].values.sigma).toBe(4);
  });

  it('leaves a designed style as it is, and begins with a copy', () => {
    const { designer, store } = app();
    designer.open(store.styles.value[0]);
    expect(designer.draft.value).toMatchObject({ id: 'my-1', name: 'Noir copy' });
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
