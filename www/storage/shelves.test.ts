import { describe, expect, it } from 'vitest';
import { fakeApp } from '../document/testing.ts';
import { createShelves } from './shelves.ts';

const style = (id: string, name = id) => ({ id, name, tags: [], background: [] });
const ids = (list: readonly { id: string }[]) => list.map(({ id }) => id).sort();

function tab(kept: Map<string, string>) {
  const app = fakeApp();
  (app.planner as any).checkStyle = JSON.parse;
  const full = { on: false };
  const box = {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => {
      if (full.on) throw new Error('quota');
      kept.set(key, value);
    },
  };
  const shelves = createShelves({ store: app.store, messages: app.messages, box: () => box });
  shelves.recall();
  const save = (item: any) => app.store.change({ type: 'own-styles', mine: [item, ...app.store.project.peek().mine] });
  const remove = (id: string) =>
    app.store.change({ type: 'own-styles', mine: app.store.project.peek().mine.filter((item) => item.id !== id) });
  const mine = () => ids(app.store.project.peek().mine);
  return { ...app, shelves, save, remove, mine, full, hear: () => shelves.hear({ key: 'inkpanel.styles' }) };
}

const stored = (kept: Map<string, string>) => ids(JSON.parse(kept.get('inkpanel.styles') ?? '[]'));

describe('styles of two tabs', () => {
  it('do not overwrite each other, heard of or not', () => {
    const kept = new Map();
    const [one, two] = [tab(kept), tab(kept)];
    one.save(style('a'));
    two.save(style('b'));
    expect(stored(kept)).toEqual(['a', 'b']);
    one.hear();
    expect(one.mine()).toEqual(['a', 'b']);
    two.hear();
    two.remove('a');
    expect(stored(kept)).toEqual(['b']);
  });

  it('are not taken back by an undo in the other', () => {
    const kept = new Map();
    const [one, two] = [tab(kept), tab(kept)];
    one.save(style('a'));
    one.save(style('c'));
    two.save(style('b'));
    one.hear();
    one.pages.undo();
    expect([one.mine(), stored(kept)]).toEqual([
      ['a', 'b'],
      ['a', 'b'],
    ]);
    one.pages.redo();
    expect([one.mine(), stored(kept)]).toEqual([
      ['a', 'b', 'c'],
      ['a', 'b', 'c'],
    ]);
  });

  it('stay here when the storage takes none, and are written with the next', () => {
    const kept = new Map();
    const [one, two] = [tab(kept), tab(kept)];
    one.full.on = true;
    one.save(style('a'));
    expect(one.messages.list.value).toHaveLength(1);
    two.save(style('b'));
    one.hear();
    expect([one.mine(), stored(kept)]).toEqual([['a', 'b'], ['b']]);
    one.full.on = false;
    one.save(style('c'));
    expect(stored(kept)).toEqual(['a', 'b', 'c']);
  });
});
