import { signal } from '@preact/signals';
import { describe, expect, it, vi } from 'vitest';
import { createScores } from './explorer-scores.ts';

const item = (n: number, more?: object) => ({
  style: { id: `s${n}` },
  score: n / 100,
  novelty: 1,
  look: 'wild',
  photo: { id: 'p', width: 4, height: 3 },
  ...more,
});

function app({
  judge = (style) => Number(style.id.slice(1)) / 10,
  judges = true,
  wanted = true,
}: {
  judge?: (style: any) => any;
  judges?: boolean;
  wanted?: boolean;
} = {}) {
  const items = signal([] as any[]);
  const sorted = signal(false);
  const asked: string[] = [];
  const messages = { alert: vi.fn() };
  const engine = {
    judges,
    hasPhoto: (id: string) => id === 'p',
    judgeStyle: async (_: string, style: any, __: any, call: any) => {
      asked.push(style.id);
      await new Promise((done) => {
        setTimeout(done, 1);
      });
      if (call.signal.aborted) throw Object.assign(new Error('stopped'), { code: 'cancelled' });
      return judge(style);
    },
  };
  const scores = createScores({ engine, messages, items, sorted, wanted } as any);
  return { scores, items, sorted, asked, messages };
}

describe('the scores of the net', () => {
  it('are asked for once styles are sorted, those in sight first', async () => {
    const { scores, items, sorted, asked } = app();
    items.value = [10, 20, 30].map((n) => item(n));
    scores.visible.add('s30');
    expect(asked).toEqual([]);
    sorted.value = true;
    expect(scores.progress.value).toEqual({ done: 0, total: 3 });
    await vi.waitFor(() => expect(scores.progress.value).toBe(null));
    expect(asked).toEqual(['s30', 's10', 's20']);
    expect(scores.judged.value.get('s20')).toBe(2);
  });

  it('rank before those that are not judged yet, and by how new a picture is', async () => {
    const { scores, items, sorted } = app();
    items.value = [item(60), item(50), item(65, { novelty: 0.5 })];
    sorted.value = true;
    await vi.waitFor(() => expect(scores.progress.value).toBe(null));
    const late = item(99) as any;
    const ranked = [...items.value, late].sort((a, b) => scores.rank(b) - scores.rank(a));
    expect(ranked.map(({ style }) => style.id)).toEqual(['s60', 's50', 's65', 's99']);
  });

  it('go on with what is hung later, and end when nobody sorts', async () => {
    const { scores, items, sorted, asked } = app();
    items.value = [item(1)];
    sorted.value = true;
    await vi.waitFor(() => expect(scores.progress.value).toBe(null));
    items.value = [item(1), item(2), item(3), item(4)];
    await vi.waitFor(() => expect(asked).toEqual(['s1', 's2']));
    sorted.value = false;
    expect(scores.progress.value).toBe(null);
    await new Promise((done) => {
      setTimeout(done, 20);
    });
    expect(asked).toEqual(['s1', 's2']);
    expect(scores.judged.value.has('s2')).toBe(false);
  });

  it('pause until styles are sorted anew', async () => {
    const { scores, items, sorted, asked } = app();
    items.value = [item(1), item(2)];
    sorted.value = true;
    scores.pause();
    items.value = [...items.value, item(3)];
    await new Promise((done) => {
      setTimeout(done, 20);
    });
    expect(asked).toEqual(['s1']);
    sorted.value = false;
    sorted.value = true;
    await vi.waitFor(() => expect(scores.judged.value.size).toBe(3));
  });

  it('leave out a style that fails or whose photo is gone, and give up when the net fails', async () => {
    const wrong = (code: string) => Object.assign(new Error('broken'), { code });
    const odd = app({
      judge: ({ id }) => {
        if (id === 's1') throw wrong('internal');
        return 5;
      },
    });
    odd.items.value = [item(1), item(2), item(3, { photo: { id: 'gone' } })];
    odd.sorted.value = true;
    await vi.waitFor(() => expect(odd.scores.progress.value).toBe(null));
    expect([...odd.scores.judged.value]).toEqual([
      ['s1', null],
      ['s2', 5],
    ]);
    expect(odd.messages.alert).not.toHaveBeenCalled();

    const dead = app({
      judge: () => {
        throw wrong('detector-missing');
      },
    });
    dead.items.value = [item(1), item(2)];
    dead.sorted.value = true;
    await vi.waitFor(() => expect(dead.scores.off.value).toBe(true));
    expect(dead.messages.alert).toHaveBeenCalledOnce();
    expect(dead.asked).toEqual(['s1']);
  });

  it('are not asked for without a net, or when nets are not wanted', async () => {
    for (const how of [{ judges: false }, { wanted: false }]) {
      const { scores, items, sorted, asked } = app(how);
      items.value = [item(1)];
      sorted.value = true;
      expect([asked, scores.off.value, scores.rank(items.value[0] as any)]).toEqual([[], true, 0.01]);
    }
  });
});
