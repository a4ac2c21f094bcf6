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
  const scores = createScores({ engine, messages, items, wanted } as any);
  return { scores, items, asked, messages };
}

describe('the scores', () => {
  it('are asked for once a person wants them, those in sight first', async () => {
    const { scores, items, asked } = app();
    items.value = [10, 20, 30].map((n) => item(n));
    scores.visible.add('s30');
    expect(asked).toEqual([]);
    scores.ask();
    expect(scores.progress.value).toEqual({ done: 0, total: 3 });
    await vi.waitFor(() => expect(scores.progress.value).toBe(null));
    expect(asked).toEqual(['s30', 's10', 's20']);
    expect(scores.judged.value.get('s20')).toBe(2);
  });

  it('are one figure from 0 to 100 each, by the light score until the net has judged, and by how new a picture is', async () => {
    const { scores, items } = app();
    items.value = [item(60), item(50), item(65, { novelty: 0.5 }), item(20), item(99)];
    expect(items.value.map(scores.points)).toEqual([60, 50, 65, 20, 99]);
    scores.ask();
    await vi.waitFor(() => expect(scores.progress.value).toBe(null));
    expect(items.value.map(scores.points)).toEqual([88, 63, 19, 0, 100]);
    expect(scores.points(item(42) as any)).toBe(42);
  });

  it('go on with what is hung later, and end when they are to rest', async () => {
    const { scores, items, asked } = app();
    items.value = [item(1)];
    scores.ask();
    await vi.waitFor(() => expect(scores.progress.value).toBe(null));
    items.value = [item(1), item(2), item(3), item(4)];
    await vi.waitFor(() => expect(asked).toEqual(['s1', 's2']));
    scores.pause();
    expect(scores.progress.value).toBe(null);
    await new Promise((done) => {
      setTimeout(done, 20);
    });
    expect(asked).toEqual(['s1', 's2']);
    expect(scores.judged.value.has('s2')).toBe(false);
  });

  it('pause until they are asked for again', async () => {
    const { scores, items, asked } = app();
    items.value = [item(1), item(2)];
    scores.ask();
    scores.pause();
    items.value = [...items.value, item(3)];
    await new Promise((done) => {
      setTimeout(done, 20);
    });
    expect(asked).toEqual(['s1']);
    scores.ask();
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
    odd.scores.ask();
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
    dead.scores.ask();
    await vi.waitFor(() => expect(dead.scores.off.value).toBe(true));
    expect(dead.messages.alert).toHaveBeenCalledOnce();
    expect(dead.asked).toEqual(['s1']);
  });

  it('are not asked for without a net, or when nets are not wanted', async () => {
    for (const how of [{ judges: false }, { wanted: false }]) {
      const { scores, items, asked } = app(how);
      items.value = [item(1)];
      scores.ask();
      expect([asked, scores.off.value, scores.points(items.value[0] as any)]).toEqual([[], true, 1]);
    }
  });
});
